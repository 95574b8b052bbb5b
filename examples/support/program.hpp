// What the example programs share: options, a `main` that turns exceptions into a message and an exit code, Ctrl-C.
#pragma once
#include "support/colour.hpp"
#include "support/log.hpp"
#include <jauscat/net.hpp>
#include <jauscat/version.hpp>

#include <boost/program_options.hpp>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <string>

namespace example {

/// Exit codes of every program here.
enum exit_code : int { success = 0, failure = 1, usage = 2 };

/// A wrong command line.
struct usage_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Set by Ctrl-C and by SIGTERM; programs look at it in their loops.
inline std::atomic<bool> stop_requested{false};

inline void stop_on_signals() {
    const auto stop = [](int) { stop_requested = true; };
    std::signal(SIGINT, stop);
    std::signal(SIGTERM, stop);
}

/// Boost takes -1 for the largest number of an unsigned type.
inline void refuse_negative(const std::vector<boost::program_options::option>& given,
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
inline std::string complaint(const boost::program_options::validation_error& error,
                             const boost::program_options::options_description& options) {
    namespace po = boost::program_options;
    const auto name = error.get_option_name(); // with its dashes
    const auto* const option = options.find_nothrow(name.substr(name.find_first_not_of('-')), false);
    if (option == nullptr) return error.what();
    const auto* const typed = dynamic_cast<const po::typed_value_base*>(option->semantic().get());
    if (typed == nullptr || typed->value_type() != typeid(std::uint16_t)) return error.what();
    return name + " must be 0 to 65535, in decimal";
}

/// For programs that can log as JSON; `parse` looks at it.
inline void add_log_option(boost::program_options::options_description& options) {
    namespace po = boost::program_options;
    options.add_options()("log-format", po::value<std::string>()->default_value("text"),
                          "text or json: one object a line, see docs/log-events.md");
}
/// What --log-format says also where the rest of the command line is wrong.
inline void choose_log_format(int argc, char** argv, const boost::program_options::options_description& options) {
    if (options.find_nothrow("log-format", false) == nullptr) return;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word{argv[i]}, next{i + 1 < argc ? argv[i + 1] : ""};
        if (word == "--log-format=json" || (word == "--log-format" && next == "json"))
            chosen_log_format() = log_format::json;
    }
}

/// Parses the command line, which also has --help and --version: prints what they ask for and ends the program. `help`
/// begins with the program's name: "ocu: commands the efforts ...".
inline boost::program_options::variables_map
parse(int argc, char** argv, const boost::program_options::options_description& options, const std::string& help,
      const boost::program_options::positional_options_description& positional = {}) {
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
        std::exit(success);
    }
    if (values.count("version") != 0) {
        std::cout << name << " (JausCat) " << JAUSCAT_VERSION_MAJOR << '.' << JAUSCAT_VERSION_MINOR << '.'
                  << JAUSCAT_VERSION_PATCH << "\n";
        std::exit(success);
    }
    return values;
}

/// `more`: lines below, each with its end.
inline void say_error(const char* name, event_kind kind, const std::exception& error, const std::string& more = {}) {
    const auto& colour = colours(STDERR_FILENO);
    std::cerr << log_lines(kind, {},
                           colour.bad + (name + (": " + std::string{error.what()})) + colour.end + "\n" + more);
}

/// Runs `program`, and prints on standard error why it ended early.
int run(const char* name, auto&& program) {
    program_name() = name;
    std::setvbuf(stdout, nullptr, _IOLBF,
                 4096); // a line is seen, whole, when it is written: in a terminal and in a log
    try {
        stop_on_signals();
        return program();
    } catch (const usage_error& error) {
        say_error(name, events::usage_error, error, "Try '" + std::string{name} + " --help'.\n");
        return usage;
    } catch (const std::exception& error) {
        say_error(name, events::failed, error);
        return failure;
    }
}

/// The configuration that --config and --this choose.
inline jauscat::net::jaus_config load_config(const boost::program_options::variables_map& values) {
    const auto config = jauscat::net::read_jaus_config(values["config"].as<std::string>());
    return values.count("this") != 0 ? config.with_this(values["this"].as<std::string>()) : config;
}

/// `2.2.33.1` as an address with all octets given.
inline jauscat::jaus::address parse_address(const std::string& text) {
    unsigned s = 0, n = 0, c = 0, i = 0;
    int used = 0;
    if (std::sscanf(text.c_str(), "%u.%u.%u.%u%n", &s, &n, &c, &i, &used) != 4 ||
        used != static_cast<int>(text.size()) || s < 1 || s > 255 || n < 1 || n > 255 || c < 1 || c > 255 || i < 1 ||
        i > 255)
        throw usage_error{"'" + text + "' is no JAUS ID: write subsystem.node.component.instance, each 1 to 255"};
    return {.instance = static_cast<std::uint8_t>(i),
            .component = static_cast<std::uint8_t>(c),
            .node = static_cast<std::uint8_t>(n),
            .subsystem = static_cast<std::uint8_t>(s)};
}

} // namespace example
