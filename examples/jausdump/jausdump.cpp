// jausdump: shows JAUS messages out of a capture, from a UDP port, or from lines of hex digits.
#include "capture.hpp"
#include "dump.hpp"
#include "input_lines.hpp"
#include "listener.hpp"
#include "support/program.hpp"

#include <fstream>
#include <unistd.h>

namespace {

namespace po = boost::program_options;
using example::usage_error;

constexpr const char* help = R"(jausdump: shows JAUS messages, field by field.

  jausdump [options] CAPTURE        a file of tcpdump or Wireshark: UDP over IPv4, any port
  jausdump [options] --listen PORT  messages as they arrive, until Ctrl-C
  jausdump [options]                lines of hex digits on standard input, a message each

Captures and ports: with or without JAUS01.0 in front of a message. Large data sets are put together, and payload data
elements are decoded with the types of an earlier Report Payload Interface. What is not JAUS is counted. Lines: each is
decoded alone, whatever its acknowledgement bits or data flag say.

Examples:
  jausdump drive.pcap
  jausdump drive.pcap --name global_pose --from 1.1 --hex
  jausdump drive.pcap --summary
  jausdump --listen 3794 --join 224.1.0.1
  echo 0602050401210202012001010400220001000040 | jausdump --format json --reencode
  jausdump --format json --translate seed <messages.hex
  jausdump --payload-types 1,2,4,20 <payload.hex

JSON: one object a line with message, code, header, presence_vector, fields; then hex (--reencode), packet (--translate,
or the name of the error), error (what broke the message: error, field, byte counted from the header), bytes (of what was
not decoded), dropped (bytes that the fields do not hold), data_set, origin.

Exit code: 0 when all was decoded, 1 when something was broken, unknown or incomplete, 2 for a wrong command line or
input that cannot be read.
)";

template <class T> std::vector<T> values_of(const po::variables_map& values, const char* name) {
    return values.count(name) != 0 ? values[name].as<std::vector<T>>() : std::vector<T>{};
}

/// The parts of options that may be given several times, or once with commas.
std::vector<std::string> items_of(const po::variables_map& values, const char* name) {
    std::vector<std::string> items;
    for (const auto& text : values_of<std::string>(values, name))
        for (std::size_t at = 0, end = 0; end != std::string::npos; at = end + 1) {
            end = text.find(',', at);
            items.push_back(text.substr(at, end - at));
        }
    return items;
}

/// What `parse` makes of each item.
template <class Parse> auto parsed(const std::vector<std::string>& items, Parse parse) {
    std::vector<decltype(parse(items[0]))> made;
    try {
        for (const auto& item : items) made.push_back(parse(item));
    } catch (const std::invalid_argument& error) {
        throw usage_error{error.what()};
    }
    return made;
}

/// One of some words, as a value.
template <class T>
T choice(const po::variables_map& values, const std::string& name,
         std::initializer_list<std::pair<const char*, T>> all) {
    const auto& text = values[name].as<std::string>();
    std::string words;
    for (const auto& [word, value] : all) {
        if (text == word) return value;
        words += (words.empty() ? "" : " or ") + std::string{word};
    }
    throw usage_error{"--" + name + " must be " + words + ", not '" + text + "'"};
}

/// A list, or the name of a file that holds one.
std::vector<jauscat::jaus::payload_type> payload_types(const std::string& text) {
    if (text.find_first_not_of("0123456789, []") == std::string::npos)
        return jausdump::parse_payload_types(text, "--payload-types");
    std::ifstream file{text};
    if (!file) throw jausdump::input_error{"--payload-types: cannot read " + text};
    const std::string content{std::istreambuf_iterator<char>{file}, {}};
    return jausdump::parse_payload_types(content, text);
}

jausdump::options options_from(const po::variables_map& values) {
    using namespace jausdump;
    jausdump::options made{
        .format = choice<format>(values, "format", {{"text", format::text_lines}, {"json", format::json_lines}}),
        .filter = {.codes = parsed(items_of(values, "code"), &parse_code),
                   .names = parsed(items_of(values, "name"), &parse_name),
                   .from = parsed(items_of(values, "from"), &parse_pattern),
                   .to = parsed(items_of(values, "to"), &parse_pattern)},
        .reencode = values.count("reencode") != 0,
        .hex = values.count("hex") != 0,
        .summary_only = values.count("summary") != 0,
        .colours = example::colours(),
    };
    if (values.count("translate") != 0)
        made.translation = choice<translation>(
            values, "translate", {{"seed", translation::seed}, {"self-contained", translation::self_contained}});
    if (values.count("payload-types") != 0)
        made.payload_types = payload_types(values["payload-types"].as<std::string>());
    return made;
}

bool stopped() { return example::stop_requested; }

/// Says on a terminal how far a long capture has been read, unless the messages go there too.
class progress {
  public:
    void operator()(double part) {
        const int percent = static_cast<int>(part * 100);
        if (!shown_ || percent == percent_) return;
        percent_ = percent;
        std::cerr << "\rreading: " << percent << " %" << std::flush;
    }
    void end() const {
        if (percent_ > 0) std::cerr << "\r\033[K";
    }

  private:
    bool shown_ = isatty(STDERR_FILENO) == 1 && isatty(STDOUT_FILENO) == 0;
    int percent_{};
};

void read_lines(jausdump::dump& dump) {
    if (isatty(STDIN_FILENO) == 1)
        std::cerr << "jausdump: type messages as hex digits, one a line; Ctrl-D or Ctrl-C ends it, --help says more\n";
    std::size_t number = 0;
    jausdump::read_input_lines([&](const std::string& line) { dump.on_line(line, ++number); }, stopped);
}

void read_file(jausdump::dump& dump, const std::string& path) {
    progress shown;
    jausdump::read_capture(path, {.datagram = [&](auto payload, const auto& from) { dump.on_datagram(payload, from); },
                                  .skipped = [&](const std::string& reason) { dump.on_skipped(reason); },
                                  .progress = [&](double part) { shown(part); },
                                  .stop = stopped});
    shown.end();
}

void listen(jausdump::dump& dump, const po::variables_map& values) {
    jausdump::udp_listener udp{values["listen"].as<std::uint16_t>(), values_of<std::string>(values, "join")};
    std::cerr << "jausdump: listening on UDP port " << udp.port() << "; Ctrl-C ends it\n";
    udp.run([&](auto payload, const auto& from) { dump.on_datagram(payload, from); }, stopped);
}

int read_input(const po::variables_map& values) {
    const bool live = values.count("listen") != 0, file = values.count("capture") != 0;
    if (live && file) throw usage_error{"give either a capture or --listen PORT"};
    if (!live && values.count("join") != 0) throw usage_error{"--join needs --listen PORT"};
    jausdump::dump dump{options_from(values)};
    std::string problem;
    try {
        if (file)
            read_file(dump, values["capture"].as<std::string>());
        else if (live)
            listen(dump, values);
        else
            read_lines(dump);
    } catch (const jausdump::input_error& error) {
        if (!dump.has_seen_anything()) throw;
        problem = error.what(); // what came before it is summed up first
    }
    const bool all_decoded = dump.finish();
    if (!problem.empty()) throw jausdump::input_error{problem};
    return all_decoded ? example::success : example::failure;
}

} // namespace

int main(int argc, char** argv) {
    return example::run("jausdump", [&] {
        po::options_description options;
        // clang-format off
        options.add_options()
            ("capture", po::value<std::string>(), "capture file; --capture itself may be left out")
            ("listen", po::value<std::uint16_t>(), "UDP port to receive on")
            ("join", po::value<std::vector<std::string>>(), "multicast group to join, with --listen")
            ("format", po::value<std::string>()->default_value("text"), "text or json")
            ("hex", "show each message's bytes with their offsets too")
            ("reencode", "add the message encoded again from the decoded values")
            ("translate", po::value<std::string>(), "add the SDO download packet, by the table seed or self-contained")
            ("payload-types", po::value<std::string>(),
             "type codes of a payload's interfaces 1, 2, ...: a list such as 1,2,4 or a file that holds one")
            ("code", po::value<std::vector<std::string>>(), "only these command codes, in hex: 0405,4405")
            ("name", po::value<std::vector<std::string>>(), "only messages with this in their name: wrench_effort")
            ("from", po::value<std::vector<std::string>>(), "only from this JAUS ID: 1.1.32.1, 1.1, 1.*.32")
            ("to", po::value<std::vector<std::string>>(), "only to this JAUS ID")
            ("summary", "show no messages, only how many of each there were");
        // clang-format on
        po::positional_options_description positional;
        positional.add("capture", 1);
        try {
            return read_input(example::parse(argc, argv, options, help, positional));
        } catch (const jausdump::input_error& error) {
            example::say_error("jausdump", error);
            return static_cast<int>(example::usage);
        }
    });
}
