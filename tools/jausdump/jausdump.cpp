// jausdump: shows JAUS messages out of a capture, from a UDP port, or from lines of hex digits.
#include "capture.hpp"
#include "capture_writer.hpp"
#include "dump.hpp"
#include "ethercat_reader.hpp"
#include "input_lines.hpp"
#include "listener.hpp"
#include "live_record.hpp"
#include "replayer.hpp"
#include "serial_file.hpp"
#include "serial_lines.hpp"
#include "support/known_messages.hpp"
#include "support/live_view.hpp"
#include "support/program.hpp"
#include "top.hpp"
#include <jauscat/catalogue/sae.hpp>

#include <fstream>
#include <optional>
#include <unistd.h>

namespace {

namespace po = boost::program_options;
using example::usage_error;

constexpr const char* help = R"(jausdump: shows JAUS messages, field by field.

  jausdump [options] CAPTURE        a file of tcpdump or Wireshark: UDP and TCP over IPv4, any port; serial lines
  jausdump [options] -              the same from standard input
  jausdump [options] --listen PORT  messages as they arrive, until Ctrl-C; where another program of this machine has
                                    the port, what passes it is captured (as root, or with CAP_NET_RAW)
  jausdump [options] --jserial FILE  the bytes of a serial line with SAE JAUS: a file, a device, or - for standard input
  jausdump [options]                lines of hex digits on standard input, one message each

Captures and ports: messages of RA 3.3 (with or without JAUS01.0 in front, or of AS5669-2007) and of SAE services
(AS5669A), also mixed at one port. TCP streams of SAE JAUS (JTCP) are put together. Large data sets and messages of
several packets are reassembled, and payload data elements are decoded with the types of an earlier Report Payload
Interface. Other datagrams are counted. Lines: each is decoded alone, regardless of its acknowledgement bits and data
flag. With --sae each line is a payload of SAE JAUS, from its message ID on.

EtherCAT (--ethercat): shows the messages in SDO transfers to and from the objects of JAUS components, in frames of
EtherType 88A4h or in UDP at port 34980. A message is shown when its data are complete, a refusal with its abort code.
Other objects and mailbox protocols are counted. Octets of a JAUS ID that are not on the wire have the value that a
slave fills in: with the seed table the subsystem of --subsystem and instance 1. An unknown octet is 0, such as the
node of a slave whose station address is above 254. Messages of SAE JAUS are in the objects of the table sae.

Table (--top): one row for each message and sender, with the first bytes of the newest body. Bytes that change are in
reverse, without colours they have * behind them. Keys: q ends; c m s n r a sort by code, message, source, count (n),
rate, age; arrows, Page Up and Page Down scroll. Of a capture, and where the output is no terminal, the table is printed
at the end. With --format json each row is an object, with rate and age, and changed: the numbers of changed bytes.

File (--write): packets of captures as they were, datagrams of a port with Ethernet, IP and UDP headers made for them. A
packet is written if one of its messages passes the filters. Parts of messages in several packets (IPv4 fragments,
packets of SAE JAUS, TCP segments, serial data, EtherCAT frames) always are. Ctrl-C leaves a whole file.

Replay (--replay): sends each datagram with a message that passes the filters, unchanged. TCP streams and serial lines
are counted and not sent. Datagrams that a closed port refuses are counted, and the others are sent.

Examples:
  jausdump drive.pcap
  jausdump drive.pcap --name global_pose --from 1.1 --hex
  jausdump drive.pcap --summary
  jausdump ring.pcap --ethercat seed --subsystem 2
  jausdump ring.pcap --ethercat sae
  jausdump --listen 3794 --join 224.1.0.1
  jausdump --listen 3794 --top --sort rate
  jausdump --listen 3794 --write drive.pcap --time relative
  jausdump drive.pcap --from 1.1 --write from_1_1.pcap --summary
  jausdump drive.pcap --replay 127.0.0.1:3794 --speed 2
  jausdump --listen 3794 --web 8080           and the newest message of each kind at http://127.0.0.1:8080/
  sudo tcpdump -i any -U -w - udp port 3794 | jausdump -
  echo 0602050401210202012001010400220001000040 | jausdump --format json --reencode
  jausdump --format json --translate seed <messages.hex
  jausdump --payload-types 1,2,4,20 <payload.hex
  jausdump --jserial line.bin --summary
  echo 0d0023 | jausdump --sae --format json --reencode

JSON: one object for each line, with message, code, header, presence_vector, fields; then hex (--reencode), packet
(--translate, or the name of the error), error (error, field, and byte counted from the header), bytes (of a message
that was not decoded), outside_values (fields with values that the standard does not define), ignored_presence_bits (that
stand for no field), dropped (bytes that no field holds), data_set, refusal (by, what, code, text), origin (its time in
seconds with --time relative and delta). Of SAE JAUS the code is the message ID, header that of the transport or null,
byte is counted from there or from the message ID, and generation "SAE" and payload_size stand before data_set.

Exit code: 0 if all was decoded, 1 if a message was malformed, unknown or incomplete, 2 for a wrong command line or
input that cannot be read. With --replay 0 if all was sent, 1 if a datagram was refused or too large, none was there, or
Ctrl-C ended it.
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

constexpr std::pair<const char*, jausdump::translation> seed{"seed", jausdump::translation::seed},
    self_contained{"self-contained", jausdump::translation::self_contained}, sae{"sae", jausdump::translation::sae};

/// What --ethercat and the options that go with it say.
jausdump::object_table object_table_from(const po::variables_map& values) {
    namespace bases = jauscat::translation;
    if (values.count("ethercat") == 0) {
        for (const std::string name : {"index-base", "subsystem", "fixed-length"})
            if (values.count(name) != 0) throw usage_error{"--" + name + " needs --ethercat seed or self-contained"};
        return {};
    }
    jausdump::object_table table{.table =
                                     choice<jausdump::translation>(values, "ethercat", {seed, self_contained, sae}),
                                 .fixed_length = values.count("fixed-length") != 0};
    const bool is_sae = table.table == jausdump::translation::sae;
    if (is_sae) table.index_base = bases::manufacturer_index_base;
    for (const std::string name : {"subsystem", "fixed-length"})
        if (is_sae && values.count(name) != 0) throw usage_error{"--" + name + " does not go with --ethercat sae"};
    if (values.count("index-base") != 0)
        table.index_base = static_cast<std::uint16_t>(choice<std::uint32_t>(values, "index-base",
                                                                            {{"6900", bases::seed_index_base},
                                                                             {"0x2000", bases::manufacturer_index_base},
                                                                             {"0x6900", bases::profile_index_base}}));
    if (is_sae && table.index_base == bases::seed_index_base)
        throw usage_error{"--index-base must be 0x2000 or 0x6900 with --ethercat sae"};
    if (values.count("subsystem") != 0) {
        const auto subsystem = values["subsystem"].as<unsigned>();
        if (subsystem < 1 || subsystem > 254) throw usage_error{"--subsystem must be 1 to 254"};
        table.subsystem = static_cast<std::uint8_t>(subsystem);
    }
    return table;
}

jausdump::options options_from(const po::variables_map& values) {
    using namespace jausdump;
    jausdump::options made{
        .format = choice<format>(values, "format", {{"text", format::text_lines}, {"json", format::json_lines}}),
        .filter = {.codes = parsed(items_of(values, "code"), &parse_code),
                   .names = parsed(items_of(values, "name"), &parse_name),
                   .from = parsed(items_of(values, "from"), &parse_pattern),
                   .to = parsed(items_of(values, "to"), &parse_pattern)},
        .sae = values.count("sae") != 0,
        .sae_mobility_1_0 = choice<bool>(values, "sae-mobility", {{"1.0", true}, {"1.1", false}}),
        .reencode = values.count("reencode") != 0,
        .hex = values.count("hex") != 0,
        .summary_only = values.count("summary") != 0,
        .time = choice<time_display>(values, "time",
                                     {{"absolute", time_display::absolute},
                                      {"relative", time_display::relative},
                                      {"delta", time_display::delta},
                                      {"none", time_display::none}}),
        .colours = example::colours(),
    };
    if (values.count("translate") != 0)
        made.translation = choice<jausdump::translation>(values, "translate", {seed, self_contained});
    if (values.count("payload-types") != 0)
        made.payload_types = payload_types(values["payload-types"].as<std::string>());
    return made;
}

bool stopped() { return example::stop_requested; }

/// What is made of the messages beside what is printed.
struct outputs {
    std::optional<jausdump::capture_writer> writer{};
    std::optional<jausdump::top> top{};
    std::optional<jausdump::replayer> replayer{};

    void follow(jausdump::capture_listener& listener, bool live) {
        if (writer) writer->follow(listener, live);
        if (replayer) replayer->follow(listener);
    }
    /// To be called often.
    bool stop() { return (top && top->tick()) || stopped(); }
};

/// Makes what the options ask for, and lets it follow the messages.
void make_outputs(outputs& made, const po::variables_map& values, jausdump::options& how) {
    using jausdump::top_order;
    const bool live = values.count("listen") != 0, file = values.count("capture") != 0;
    const bool serial = values.count("jserial") != 0;
    const bool is_json = how.format == jausdump::format::json_lines;
    const auto has = [&](const char* name) { return values.count(name) != 0; };
    const auto needs = [&](const std::string& name, bool met, const char* what) {
        if (has(name.c_str()) && !met) throw usage_error{"--" + name + " needs " + what};
    };
    needs("write", (live || file) && !serial, "a capture or --listen PORT");
    needs("replay", file && !serial, "a capture");
    needs("speed", has("replay"), "--replay HOST:PORT");
    needs("sort", has("top"), "--top");
    needs("interval", has("top"), "--top");
    for (const std::string name : {"top", "write", "summary", "ethercat"})
        if (has("replay") && has(name.c_str())) throw usage_error{"--" + name + " does not go with --replay"};
    if (has("top") && has("summary")) throw usage_error{"--summary does not go with --top"};
    if (has("replay")) {
        const double speed = has("speed") ? values["speed"].as<double>() : 1;
        if (!(speed >= 0)) throw usage_error{"--speed must be 0 or more"};
        made.replayer.emplace(values["replay"].as<std::string>(), speed, stopped);
        made.replayer->follow(how);
    }
    if (has("top")) {
        jausdump::top_options table{.live = live, .as_json = is_json};
        if (has("sort"))
            table.order = choice<top_order>(values, "sort",
                                            {{"code", top_order::code},
                                             {"message", top_order::message},
                                             {"source", top_order::source},
                                             {"count", top_order::count},
                                             {"rate", top_order::rate},
                                             {"age", top_order::age}});
        if (has("interval")) table.interval_s = values["interval"].as<double>();
        if (const auto each = table.interval_s; each && !(*each > 0 && *each <= 86400))
            throw usage_error{"--interval must be above 0, up to 86400 seconds"};
        made.top.emplace(table);
        made.top->follow(how);
    }
    if (has("write")) {
        const auto source = file ? values["capture"].as<std::string>() : std::string{};
        made.writer.emplace(values["write"].as<std::string>(), source);
        made.writer->follow(how);
    }
}

/// Shows on a terminal how far a long capture has been read, unless the messages are shown there too.
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

void read_lines(jausdump::dump& dump, outputs& out) {
    if (isatty(STDIN_FILENO) == 1)
        std::cerr
            << "jausdump: type messages as hex digits, one a line; Ctrl-D or Ctrl-C ends it, --help explains more\n";
    std::size_t number = 0;
    jausdump::read_input_lines([&](const std::string& line) { dump.on_line(line, ++number); },
                               [&] { return out.stop(); });
}

jausdump::jtcp_streams streams_of(jausdump::dump& dump) {
    return jausdump::jtcp_streams{
        {.message = [&](const auto& message, auto part, const auto& from) { dump.on_sae_message(message, part, from); },
         .skipped = [&](const std::string& reason) { dump.on_skipped(reason); }}};
}

/// The bytes of a serial line.
void read_serial(jausdump::dump& dump, const std::string& path, outputs& out) {
    jausdump::origin from{.place = "frame"};
    jausdump::serial_lines line{[&](const auto& frame, const auto&) {
        if (frame.error != jauscat::sae::transport_errc::noise) ++from.number;
        dump.on_serial_frame(frame, from);
    }};
    jausdump::read_bytes(path, [&](auto part) { line.on_bytes(part, from); }, [&] { return out.stop(); });
    line.finish();
}

void read_file(jausdump::dump& dump, const std::string& path, const jausdump::object_table& table, outputs& out) {
    progress shown;
    const auto skipped = [&](const std::string& reason) { dump.on_skipped(reason); };
    jausdump::capture_listener listener{
        .datagram = [&](auto payload, const auto& from) { dump.on_datagram(payload, from); },
        .skipped = skipped,
        .progress = [&](double part) { shown(part); },
        .stop = [&] { return out.stop(); }};
    jausdump::ethercat_reader ring{
        table,
        {.message =
             [&](auto message, const auto& from) {
                 table.table == jausdump::translation::sae ? dump.on_sae_messages(message, from)
                                                           : dump.on_object(message, from);
             },
         .unreadable = [&](auto data, auto error, const auto& from) { dump.on_unreadable_object(data, error, from); },
         .refused = [&](jausdump::record message) { dump.on_refused(std::move(message)); },
         .lost = [&] { dump.on_lost_transfer(); },
         .skipped = skipped}};
    jausdump::jtcp_streams streams = streams_of(dump);
    listener.tcp = [&](const auto& segment, const auto& from) { streams.on_segment(segment, from); };
    jausdump::serial_lines lines{[&](const auto& frame, const auto& from) { dump.on_serial_frame(frame, from); }};
    listener.serial = [&](auto part, const auto& from) { lines.on_bytes(part, from); };
    const bool wants_ring = table.table != jausdump::translation::none;
    if (wants_ring) listener.ethercat = [&](auto frame, const auto& from) { ring.read(frame, from); };
    out.follow(listener, false);
    try {
        jausdump::read_capture(path, listener);
    } catch (const jausdump::input_error&) {
        streams.finish();
        lines.finish();
        ring.finish();
        throw;
    }
    shown.end();
    streams.finish();
    lines.finish();
    ring.finish();
    if (wants_ring && ring.frames() == 0 && !stopped())
        throw jausdump::input_error{path + ": holds no EtherCAT: no frame of EtherType 0x88A4, nothing at UDP port "
                                           "34980; record at the interface of the master, or leave out --ethercat"};
}

void listen(jausdump::dump& dump, const po::variables_map& values, outputs& out) {
    const auto port = values["listen"].as<std::uint16_t>();
    const auto stop = [&] { return out.stop(); };
    std::optional<jausdump::udp_listener> udp;
    try {
        udp.emplace(port, values_of<std::string>(values, "join"));
    } catch (const jausdump::port_taken&) {
        jausdump::port_capture capture{port};
        std::cerr << "jausdump: another program has UDP port " << port
                  << ": capturing what it receives and sends; Ctrl-C ends it\n";
        jausdump::jtcp_streams streams = streams_of(dump);
        jausdump::capture_listener listener{
            .datagram = [&](auto payload, const auto& from) { dump.on_datagram(payload, from); },
            .tcp = [&](const auto& segment, const auto& from) { streams.on_segment(segment, from); },
            .skipped = [&](const std::string& reason) { dump.on_skipped(reason); },
            .stop = stop};
        out.follow(listener, true);
        capture.run(listener);
        return streams.finish();
    }
    std::cerr << "jausdump: listening on UDP port " << udp->port() << "; Ctrl-C ends it\n";
    udp->run(
        [&](auto payload, const auto& from) {
            dump.on_datagram(payload, from);
            if (out.writer) out.writer->on_datagram(payload, from);
        },
        stop);
}

int read_input(const po::variables_map& values) {
    const bool live = values.count("listen") != 0, file = values.count("capture") != 0;
    if (live && file) throw usage_error{"give either a capture or --listen PORT"};
    if (!live && values.count("join") != 0) throw usage_error{"--join needs --listen PORT"};
    if (values.count("sae") != 0) {
        if (live || file) throw usage_error{"--sae is for lines of hex: captures and ports show SAE JAUS without it"};
        for (const std::string name : {"translate", "payload-types", "from", "to"})
            if (values.count(name) != 0) throw usage_error{"--" + name + " does not go with --sae"};
    }
    const bool serial = values.count("jserial") != 0;
    if (serial && !file) throw usage_error{"--jserial needs a file with the bytes of a serial line"};
    if (serial && values.count("ethercat") != 0) throw usage_error{"--ethercat does not go with --jserial"};
    const auto table = object_table_from(values);
    if (!file && values.count("ethercat") != 0) throw usage_error{"--ethercat needs a capture"};
    if (values.count("web") != 0 && !live && (!file || values["capture"].as<std::string>() != "-"))
        throw usage_error{"--web needs --listen PORT, or a capture from standard input"};
    example::live_view view{"jausdump", values, {}, example::known_messages(), &jauscat::catalogue::sae()};
    auto options = options_from(values);
    outputs out;
    make_outputs(out, values, options);
    if (auto* const feed = view.make_feed())
        options.watcher = [feed](const jausdump::record& message) { jausdump::show(*feed, message); };
    jausdump::dump dump{std::move(options)};
    view.start();
    if (const auto link = view.link(); !link.empty()) std::cerr << "jausdump: live view at " << link << "\n";
    std::string problem;
    try {
        if (serial)
            read_serial(dump, values["capture"].as<std::string>(), out);
        else if (file)
            read_file(dump, values["capture"].as<std::string>(), table, out);
        else if (live)
            listen(dump, values, out);
        else
            read_lines(dump, out);
    } catch (const jausdump::input_error& error) {
        if (!dump.has_seen_anything()) throw;
        problem = error.what(); // everything before it is summarised first
    }
    bool is_good = dump.finish();
    if (out.writer) out.writer->finish();
    if (out.top) out.top->finish();
    if (out.replayer && problem.empty()) is_good = out.replayer->finish(values["format"].as<std::string>() == "json");
    if (!problem.empty()) throw jausdump::input_error{problem};
    return is_good ? example::success : example::failure;
}

} // namespace

int main(int argc, char** argv) {
    return example::run("jausdump", [&] {
        po::options_description options;
        // clang-format off
        options.add_options()
            ("capture", po::value<std::string>(), "capture file; --capture itself may be omitted")
            ("listen", po::value<std::uint16_t>(), "UDP port to receive on")
            ("join", po::value<std::vector<std::string>>(), "multicast group to join, with --listen")
            ("format", po::value<std::string>()->default_value("text"), "text or json")
            ("jserial", "CAPTURE holds the bytes of a serial line with SAE JAUS")
            ("sae", "lines of hex are payloads of SAE JAUS, each from its message ID on")
            ("sae-mobility", po::value<std::string>()->default_value("1.1"),
             "version of the mobility services of SAE that peers speak: 1.0 or 1.1")
            ("time", po::value<std::string>()->default_value("absolute"),
             "time of each message: absolute (UTC), relative (since the first one), delta (since the one before) or none")
            ("top", "show a table of messages by sender instead: how many, how often, the newest bytes")
            ("sort", po::value<std::string>(), "order of the rows of --top: code (the default), message, source, count, rate or age")
            ("interval", po::value<double>(),
             "seconds between two tables of --top; without, 0.5 on a terminal, elsewhere one table at the end")
            ("write", po::value<std::string>(), "pcap file for the packets with the messages shown")
            ("replay", po::value<std::string>(), "send the datagrams of CAPTURE to HOST:PORT at the recorded pace, and show none")
            ("speed", po::value<double>(), "factor of the pace of --replay; 0: without pauses")
            ("hex", "show each message's bytes with their offsets too")
            ("reencode", "add the message encoded again from the decoded values")
            ("translate", po::value<std::string>(), "add the SDO download packet, by the table seed or self-contained")
            ("ethercat", po::value<std::string>(),
             "show the messages in SDO transfers of a capture, by the table seed, self-contained or sae")
            ("index-base", po::value<std::string>(),
             "object index of component 0, with --ethercat: 6900 (the default; not of sae), 0x2000 (its default) or 0x6900")
            ("fixed-length", "with --ethercat: every object is padded to one size, and begins with its length")
            ("subsystem", po::value<unsigned>(),
             "JAUS subsystem of the slaves, with --ethercat seed, whose table does not carry it")
            ("payload-types", po::value<std::string>(),
             "type codes of a payload's interfaces 1, 2, ...: a list such as 1,2,4, or a file with a list")
            ("code", po::value<std::vector<std::string>>(), "only these command codes, in hex: 0405,4405")
            ("name", po::value<std::vector<std::string>>(), "only messages whose name contains this: wrench_effort")
            ("from", po::value<std::vector<std::string>>(), "only from this JAUS ID: 1.1.32.1, 1.1, 1.*.32")
            ("to", po::value<std::vector<std::string>>(), "only to this JAUS ID")
            ("summary", "show only the number of each message");
        // clang-format on
        example::add_web_options(options);
        po::positional_options_description positional;
        positional.add("capture", 1);
        try {
            return read_input(example::parse(argc, argv, options, help, positional));
        } catch (const jausdump::input_error& error) {
            example::say_error("jausdump", example::events::failed, error);
            return static_cast<int>(example::usage);
        }
    });
}
