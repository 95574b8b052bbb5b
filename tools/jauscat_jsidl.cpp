// jauscat-jsidl: writes schema headers from JSIDL service definitions.
#include "support/program.hpp"
#include <jauscat/jsidl/facts.hpp>
#include <jauscat/jsidl/read_jsidl.hpp>
#include <jauscat/jsidl/write_schemas.hpp>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace {

namespace fs = std::filesystem;
namespace jsidl = jauscat::jsidl;

constexpr const char* help =
    R"(jauscat-jsidl: writes schema headers from JSIDL service definitions, or checks that headers are current.

Reads JSIDL 1.0 and 1.1. Type sets and constants that a service refers to are given as files, too. What a schema cannot
express is refused with file, line and reason. Nothing is written then.

Below the output folder there is one header for each service, such as core/events.hpp for urn:jaus:jss:core:Events, and
one for each set, such as core.hpp, with the list of its messages. The same definitions give the same headers.

Lists are in memory of the caller (wire::list), unless --capacity gives them a place in the message (wire::inline_list).

Examples:
  jauscat-jsidl Sonar.xml SonarTypes.xml --namespace acme --include-prefix acme --output include/acme
                                                  headers for a service of your own
  jauscat-jsidl Sonar.xml --capacity 16 --capacity ReportEchoes.EchoList=400 --output include/acme
                                                  lists in the messages, of 16 elements, one of 400
  jauscat-jsidl *.xml --write-facts facts.txt     names, types, units and limits, without the prose of the files
  jauscat-jsidl --facts facts.txt --output schemas/jauscat/schema/sae
                                                  headers from such a table
  jauscat-jsidl --facts facts.txt --check schemas/jauscat/schema/sae
                                                  whether the headers are those that it would write

Exit code: 0 on success; 1 if a definition is refused, a file cannot be read or written, or a header is not current;
2 for a wrong command line.
)";

template <class T> T or_throw(jauscat::result<T, jsidl::error> read) {
    if (!read) throw std::runtime_error{read.error().message};
    return *std::move(read);
}

void put(const fs::path& path, const std::string& text) {
    if (path.has_parent_path()) {
        std::error_code ignored; // writing says what is wrong
        fs::create_directories(path.parent_path(), ignored);
    }
    std::ofstream file{path, std::ios::binary};
    file << text << std::flush;
    if (!file) throw std::runtime_error{path.string() + ": cannot be written"};
}

/// Empty if the file cannot be read.
std::optional<std::string> content_of(const fs::path& path) {
    std::ifstream file{path, std::ios::binary};
    if (!file) return std::nullopt;
    return std::string{std::istreambuf_iterator<char>{file}, {}};
}

jsidl::schema_options options_of(const boost::program_options::variables_map& values) {
    jsidl::schema_options options{.name_space = values["namespace"].as<std::string>(),
                                  .include_prefix = values["include-prefix"].as<std::string>()};
    if (values.count("capacity") == 0) return options;
    for (const auto& text : values["capacity"].as<std::vector<std::string>>()) {
        const auto equals = text.find('=');
        const auto digits = equals == text.npos ? std::string_view{text} : std::string_view{text}.substr(equals + 1);
        std::size_t number{};
        const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
        if (error != std::errc{} || stop != digits.data() + digits.size() || equals == 0)
            throw example::usage_error{"--capacity must be a number or LIST=NUMBER, not '" + text + "'"};
        if (equals == text.npos)
            options.capacity = number;
        else
            options.capacities[text.substr(0, equals)] = number;
    }
    return options;
}

std::vector<jsidl::service> services_of(const boost::program_options::variables_map& values) {
    if (values.count("facts") != 0) return or_throw(jsidl::read_facts(values["facts"].as<std::string>()));
    const auto& names = values["file"].as<std::vector<std::string>>();
    const std::vector<fs::path> files{names.begin(), names.end()};
    return or_throw(jsidl::read_jsidl(files));
}

int check(const fs::path& folder, const jsidl::schema_headers& headers) {
    bool is_current = true;
    const auto complain = [&](const fs::path& path, const std::string& what) {
        std::cout << path.string() << ": " << what << '\n';
        is_current = false;
    };
    for (const auto& [name, text] : headers) {
        const auto found = content_of(folder / name);
        if (!found)
            complain(folder / name, "is missing");
        else if (*found != text)
            complain(folder / name, "differs from what jauscat-jsidl writes");
    }
    // Headers by hand may stand beside.
    std::error_code error;
    for (const auto& each : fs::recursive_directory_iterator{folder, error}) {
        const auto text = each.path().extension() == ".hpp" ? content_of(each.path()) : std::nullopt;
        if (text && text->find("// Written by jauscat-jsidl") != text->npos &&
            !headers.contains(each.path().lexically_relative(folder).generic_string()))
            complain(each.path(), "is of a service that is not given");
    }
    if (is_current) std::cout << folder.string() << ": " << headers.size() << " headers are current\n";
    return is_current ? example::success : example::failure;
}

} // namespace

int main(int argc, char** argv) {
    return example::run("jauscat-jsidl", [&] {
        namespace po = boost::program_options;
        po::options_description options;
        // clang-format off
        options.add_options()
            ("file", po::value<std::vector<std::string>>(), "JSIDL file; may be repeated, also without --file")
            ("facts", po::value<std::string>(), "table of facts to read instead of JSIDL files")
            ("output", po::value<std::string>(), "folder to write the headers to")
            ("check", po::value<std::string>(), "folder with headers that are compared with those that would be written")
            ("write-facts", po::value<std::string>(), "table of facts to write")
            ("namespace", po::value<std::string>()->default_value("jauscat::sae"), "namespace around those of the sets")
            ("include-prefix", po::value<std::string>()->default_value("jauscat/schema/sae"), "folder of the headers in #include lines")
            ("capacity", po::value<std::vector<std::string>>()->composing(),
             "NUMBER: capacity of all lists; LIST=NUMBER or MESSAGE.LIST=NUMBER: of one, 0 for memory of the caller");
        // clang-format on
        po::positional_options_description positional;
        positional.add("file", -1);
        const auto values = example::parse(argc, argv, options, help, positional);
        if (values.count("file") != 0 && values.count("facts") != 0)
            throw example::usage_error{"JSIDL files and --facts exclude each other"};
        if (values.count("file") + values.count("facts") == 0)
            throw example::usage_error{"no JSIDL file, and no --facts"};
        if (values.count("output") + values.count("check") + values.count("write-facts") == 0)
            throw example::usage_error{"nothing to do: give --output, --check or --write-facts"};
        const auto schema_options = options_of(values);
        const auto services = services_of(values);
        const auto headers = or_throw(jsidl::write_schemas(services, schema_options));
        if (values.count("write-facts") != 0)
            put(values["write-facts"].as<std::string>(), jsidl::write_facts(services));
        if (values.count("output") != 0)
            for (const auto& [name, text] : headers) put(fs::path{values["output"].as<std::string>()} / name, text);
        return values.count("check") != 0 ? check(values["check"].as<std::string>(), headers) : int{example::success};
    });
}
