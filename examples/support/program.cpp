#include "support/program.hpp"

#include <jauscat/version.hpp>

#include <csignal>
#include <string_view>

namespace example {

namespace {

/// Boost takes -1 for the largest number of an unsigned type.
void refuse_negative(const std::vector<boost::program_options::option>& given,
                     const boost::program_options::variables_map& values) {
    for (const auto& each : given) {
        const auto& type = values[each.string_key].value().type();
        const bool is_unsigned =
            type == typeid(std::uint16_t) || type == typeid(unsigned) || type == typeid(std::size_t);
        if (is_unsigned && each.value.front().starts_with('-'))
            throw usage_error{"--" + each.string_key + " must not be negative"};
    }
}

/// What is wrong with a value: for a port and other numbers of 16 bits, their range.
std::string complaint(const boost::program_options::validation_error& error,
                      const boost::program_options::options_description& options) {
    namespace po = boost::program_options;
    const auto name = error.get_option_name(); // with its dashes
    const auto* const option = options.find_nothrow(name.substr(name.find_first_not_of('-')), false);
    if (option == nullptr) return error.what();
    const auto* const typed = dynamic_cast<const po::typed_value_base*>(option->semantic().get());
    if (typed == nullptr || typed->value_type() != typeid(std::uint16_t)) return error.what();
    return name + " must be 0 to 65535, in decimal";
}

/// What --log-format says also where the rest of the command line is wrong.
void choose_log_format(int argc, char** argv, const boost::program_options::options_description& options) {
    if (options.find_nothrow("log-format", false) == nullptr) return;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word{argv[i]}, next{i + 1 < argc ? argv[i + 1] : ""};
        if (word == "--log-format=json" || (word == "--log-format" && next == "json"))
            chosen_log_format() = log_format::json;
    }
}

} // namespace

void stop_on_signals() {
    const auto stop = [](int) { stop_requested = true; };
    std::signal(SIGINT, stop);
    std::signal(SIGTERM, stop);
}

void add_log_option(boost::program_options::options_description& options) {
    namespace po = boost::program_options;
    options.add_options()("log-format", po::value<std::string>()->default_value("text"),
                          "text or json: one object a line, see docs/log-events.md");
}

boost::program_options::variables_map parse(int argc, char** argv,
                                            const boost::program_options::options_description& options,
                                            const std::string& help,
                                            const boost::program_options::positional_options_description& positional) {
    namespace po = boost::program_options;
    constexpr unsigned width = 119; // that of the help texts
    choose_log_format(argc, argv, options);
    po::options_description all{bold("Options"), width};
    all.add_options()("help,h", "show this text")("version", "show the version of JausCat");
    for (const auto& each : options.options()) all.add(each);
    po::variables_map values;
    try {
        const auto given = po::command_line_parser(argc, argv).options(all).positional(positional).run();
        po::store(given, values);
        refuse_negative(given.options, values);
        po::notify(values);
    } catch (const po::validation_error& error) {
        throw usage_error{complaint(error, all)};
    } catch (const po::error& error) {
        throw usage_error{error.what()};
    }
    if (values.count("log-format") != 0) {
        const auto& format = values["log-format"].as<std::string>();
        if (format != "text" && format != "json")
            throw usage_error{"--log-format must be text or json, not '" + format + "'"};
        chosen_log_format() = format == "json" ? log_format::json : log_format::text;
    }
    const auto title = help.find(':');
    const auto name = help.substr(0, title);
    if (values.count("help") != 0) {
        std::cout << bold(name) << help.substr(title) << "\n" << all;
        std::exit(end_of_output(name.c_str(), success));
    }
    if (values.count("version") != 0) {
        std::cout << name << " (JausCat) " << JAUSCAT_VERSION_TEXT << "\n";
        std::exit(end_of_output(name.c_str(), success));
    }
    return values;
}

void say_error(const char* name, event_kind kind, const std::exception& error, const std::string& more) {
    const auto& colour = colours(STDERR_FILENO);
    std::cerr << log_lines(kind, {},
                           colour.bad + (name + (": " + std::string{error.what()})) + colour.end + "\n" + more);
}

int end_of_output(const char* name, int code) {
    const auto problem = output_problem();
    if (problem.empty()) return code;
    say_error(name, events::failed, std::runtime_error{problem});
    return code == success ? failure : code;
}

} // namespace example
