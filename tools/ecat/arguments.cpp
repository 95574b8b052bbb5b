#include "ecat/arguments.hpp"

#include "support/output.hpp"
#include <jauscat/version.hpp>

#include <boost/program_options.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <iostream>
#include <string_view>
#include <unistd.h>

namespace ecat {

namespace {

namespace po = boost::program_options;

enum option : unsigned {
    slave = 1,
    confirmation = 2,
    type = 4,
    output = 8,
    raw = 16,
    entries = 32,
    times = 64,
};

struct command_help {
    std::string_view name;
    std::string_view words; ///< of the command line
    std::size_t least, most;
    unsigned options;
    std::string_view summary;
    std::string_view text;
};

constexpr std::array commands{
    command_help{
        "scan", "", 0, 0, 0, "list all slaves",
        R"(One row for each slave, in the order of the ring: position, station address, alias, identity and name from the SII, state.
Only reads, by position: states and station addresses stay as they are.

Examples:
  jauscat-ecat scan --link eth0
  jauscat-ecat scan --link udp:127.0.0.1:34980 --format json

JSON: an array with one object a slave: position, station, alias, vendor, product, revision, serial (numbers), name (a
string, empty if the SII has none) and state ("INIT", "PRE-OP", "BOOT", "SAFE-OP" or "OP", followed by " ERROR" where
the slave indicates one).
)"},
    command_help{"info", "", 0, 0, slave,
                 "show what a slave is: controller, ports, state, mailbox, SyncManagers, FMMUs",
                 R"(Shows the registers and the SII of one slave, or of all. Only reads.

Examples:
  jauscat-ecat info --link eth0 --slave 2
  jauscat-ecat info --link eth0 --format json
)"},
    command_help{
        "state", "[GOAL]", 0, 1, slave | confirmation, "show states, or request one",
        R"(Without a goal: the state of each slave, with the AL status code. With a goal (init, pre-op, boot, safe-op or op) the slave,
or each slave, is taken there, and an error is acknowledged. SAFE-OP sets up the process data on the way, through INIT. OP
is for slaves without outputs: outputs need a master's cycles, so that such a slave stays in SAFE-OP. Use a master, or
cyclic. Station addresses stay as they are.

Examples:
  jauscat-ecat state --link eth0
  jauscat-ecat state pre-op --link eth0 --slave 2
  jauscat-ecat state init --link eth0 --yes
)"},
    command_help{
        "read", "INDEX[:SUB[-SUB]] ...", 1, 1000, slave | type, "read objects (SDO upload)",
        R"(Reads entries of objects. Their types are those that the slave states (SDO information), or that of --type: bool, i8 to i64,
u8 to u64, f32, f64, string, bytes. A slave in INIT is taken to PRE-OP for the time of the command.

Examples:
  jauscat-ecat read 0x1008 --link eth0 --slave 2
  jauscat-ecat read 0x1018:0-4 0x6041:0 --link eth0 --slave 2
  jauscat-ecat read 0x2003 --type bytes --link udp:127.0.0.1:34980 --format json
)"},
    command_help{
        "write", "INDEX[:SUB] VALUE", 2, 2, slave | type | confirmation, "write an object (SDO download)",
        R"(Writes one entry. The value is checked against the type, and against minimum and maximum where the slave states them. Asks
before it writes; --yes answers. The value is read back if the slave permits that.

Examples:
  jauscat-ecat write 0x6060:0 8 --link eth0 --slave 2
  jauscat-ecat write 0x2002 0xFFFF0000 --type u32 --link eth0 --slave 2 --yes
  jauscat-ecat write 0x2003 00112233 --type bytes --link udp:127.0.0.1:34980 --yes
)"},
    command_help{
        "sdos", "[INDEX[-INDEX]]", 0, 1, slave | entries, "list the object dictionary",
        R"(Lists the objects that the slave states by SDO information, with their entries: type, size, access and name. --values
also reads them.

Examples:
  jauscat-ecat sdos --link eth0 --slave 2
  jauscat-ecat sdos 0x6000-0x6FFF --values --link eth0 --slave 2
)"},
    command_help{
        "sii", "", 0, 0, slave | output | raw, "show the SII memory (EEPROM), or save it",
        R"(Shows the memory decoded: configuration, identity, mailbox, strings, SyncManagers, FMMUs, PDOs. --hex shows its bytes,
--output writes them to a file. Only reads.

Examples:
  jauscat-ecat sii --link eth0 --slave 2
  jauscat-ecat sii --link eth0 --slave 2 --hex
  jauscat-ecat sii --link eth0 --slave 2 --output slave2.bin
)"},
    command_help{
        "pdos", "", 0, 0, slave, "show the process data: PDOs, entries, their places",
        R"(Shows the PDOs of each SyncManager and the objects in them. They come from the slave's objects (1C10h and up) where it has a
CoE mailbox, else from the SII. A slave in INIT is taken to PRE-OP for the time of the command.

Examples:
  jauscat-ecat pdos --link eth0 --slave 2
  jauscat-ecat pdos --link eth0 --format json
)"},
    command_help{
        "watch", "", 0, 0, slave | times, "show the inputs of slaves in SAFE-OP or OP as they change",
        R"(Reads the process data from each slave, repeatedly, and shows each entry with its value. Only reads; outputs are not shown,
because a master cannot read them. To take slaves to SAFE-OP: jauscat-ecat state safe-op. The entries come from the SII.

Examples:
  jauscat-ecat watch --link eth0 --slave 2
  jauscat-ecat watch --link eth0 --period 1000000 --seconds 10 --format json

JSON: one line with an array of entries for each look.
)"},
    command_help{
        "monitor", "", 0, 0, times, "watch frames, working counters and error counters of the ports",
        R"(Sends one frame in each period, which all slaves read into, and shows at the end, or after Ctrl-C: how long the frames took,
how many were lost, how many slaves took part, and how the error counters of each port (0300h to 0313h) have changed.
Only reads.

Examples:
  jauscat-ecat monitor --link eth0
  jauscat-ecat monitor --link eth0 --period 250 --seconds 60 --format json

Exit code 1 if frames were lost, slaves were missing or counters have grown.
)"},
    command_help{
        "esi", "FILE", 1, 1, slave, "compare a slave with an ESI file",
        R"(Compares identity, mailbox, SyncManagers, FMMUs and PDOs in the SII, and, where the slave has SDO information, its objects,
with the device in the file. Of several devices it is the one with the slave's product code and revision, or the newest
revision below. A slave in INIT is taken to PRE-OP for the time of the command.

Examples:
  jauscat-ecat esi drive.xml --link eth0 --slave 2

Exit code 1 if something differs.
)"},
};

constexpr std::string_view head = R"(jauscat-ecat: looks at the slaves of an EtherCAT bus.

)";
constexpr std::string_view tail = R"(
It notices another master on the bus and refuses to work then, unless --force is given. Numbers are decimal, or
hexadecimal with 0x.

Examples:
  jauscat-ecat scan --link eth0                              all slaves on eth0
  jauscat-ecat read 0x1018:0-4 --link eth0 --slave 2         the identity of the third slave
  jauscat-ecat write 0x2002 7 --link eth0 --slave 2          asks first
  jauscat-ecat scan --link udp:127.0.0.1:34980 --format json EtherCAT in UDP

`jauscat-ecat COMMAND --help` describes a command.

Exit code: 0 on success; 1 if the link, a slave or a file fails, or what is compared differs; 2 for a wrong command line;
3 if another master seems to use the bus; 4 if a write was not confirmed.
)";

const command_help* find(std::string_view name) {
    const auto* const found = std::ranges::find(commands, name, &command_help::name);
    return found == commands.end() ? nullptr : found;
}

po::options_description options_of(const command_help* about) {
    po::options_description made{"Options", 119};
    const auto has = [&](option one) { return about == nullptr || (about->options & one) != 0; };
    // clang-format off
    made.add_options()
        ("help", "show this text; with a command, that of the command")
        ("version", "show the version of JausCat")
        ("link", po::value<std::string>(), "network interface (needs CAP_NET_RAW), or udp:HOST or udp:HOST:PORT")
        ("format", po::value<std::string>()->default_value("text"), "text or json")
        ("frame-timeout", po::value<std::string>()->default_value("20"), "milliseconds after which a frame is lost, 1 to 10000")
        ("force", po::bool_switch(), "work also while another master seems to use the bus");
    if (has(slave)) made.add_options()
        ("slave", po::value<std::string>(), "position of the slave, 0 is the first")
        ("alias", po::value<std::string>(), "alias of the slave, in place of its position");
    if (has(type)) made.add_options()
        ("type", po::value<std::string>()->default_value(""), "type of the value: bool, i8 to i64, u8 to u64, f32, f64, string, bytes");
    if (has(confirmation)) made.add_options()
        ("yes", po::bool_switch(), "do not ask before something is changed");
    if (has(output)) made.add_options()
        ("output", po::value<std::string>()->default_value(""), "file for the bytes of the memory");
    if (has(raw)) made.add_options()
        ("hex", po::bool_switch(), "show the bytes");
    if (has(entries)) made.add_options()
        ("values", po::bool_switch(), "also read the values");
    if (has(times)) made.add_options()
        ("period", po::value<std::string>(), "microseconds, 50 to 60000000; default: monitor 1000, watch 200000")
        ("seconds", po::value<std::string>(), "duration; without it until Ctrl-C");
    // clang-format on
    return made;
}

[[noreturn]] void show_help(const command_help* about) {
    if (about != nullptr) {
        std::cout << "jauscat-ecat " << about->name << ": " << about->summary << ".\n\nUsage: jauscat-ecat "
                  << about->name << (about->words.empty() ? "" : " ") << about->words << " --link LINK [options]\n\n"
                  << about->text << "\n"
                  << options_of(about);
    } else {
        std::cout << head << "Usage: jauscat-ecat COMMAND --link LINK [options]\n\nCommands:\n";
        for (const auto& each : commands)
            std::cout << "  " << each.name << std::string(10 - each.name.size(), ' ') << each.summary << "\n";
        std::cout << tail << "\n" << options_of(nullptr);
    }
    std::exit(example::with_output("jauscat-ecat", success));
}

std::uint64_t number(const std::string& text, std::uint64_t least, std::uint64_t most, const std::string& option) {
    const bool is_hex = text.starts_with("0x") || text.starts_with("0X");
    const char* const from = text.data() + (is_hex ? 2 : 0);
    std::uint64_t made{};
    const auto [end, error] = std::from_chars(from, text.data() + text.size(), made, is_hex ? 16 : 10);
    if (error != std::errc{} || end != text.data() + text.size() || made < least || made > most)
        throw usage_error{"--" + option + " must be " + std::to_string(least) + " to " + std::to_string(most) +
                          ", not '" + text + "'"};
    return made;
}

arguments made_of(const po::variables_map& values, const command_help& about) {
    arguments made{.command = std::string{about.name}};
    const auto has = [&](const char* name) { return values.count(name) != 0; };
    const auto text = [&](const char* name) { return values[name].as<std::string>(); };
    if (has("words")) made.words = values["words"].as<std::vector<std::string>>();
    const auto command = std::string{about.name};
    if (made.words.size() < about.least)
        throw usage_error{command + ": expected " + std::string{about.words} + " behind the command"};
    if (made.words.size() > about.most)
        throw usage_error{command + ": '" + made.words[about.most] + "' is not expected"};
    if (!has("link")) throw usage_error{"--link is missing: a network interface, or udp:HOST:PORT"};
    made.link.link = text("link");
    made.link.frame_timeout = std::chrono::milliseconds{number(text("frame-timeout"), 1, 10'000, "frame-timeout")};
    made.link.force = values["force"].as<bool>();
    const auto format = text("format");
    if (format != "text" && format != "json") throw usage_error{"--format must be text or json, not '" + format + "'"};
    made.is_json = format == "json";
    if (has("slave") && has("alias")) throw usage_error{"give --slave or --alias, not both"};
    if (has("slave")) made.slave = static_cast<std::uint16_t>(number(text("slave"), 0, 65534, "slave"));
    if (has("alias")) made.alias = static_cast<std::uint16_t>(number(text("alias"), 1, 65535, "alias"));
    if (has("type")) made.type = text("type");
    if (has("yes")) made.yes = values["yes"].as<bool>();
    if (has("output")) made.output = text("output");
    if (has("hex")) made.raw = values["hex"].as<bool>();
    if (has("values")) made.entries = values["values"].as<bool>();
    if (has("period")) made.period = std::chrono::microseconds{number(text("period"), 50, 60'000'000, "period")};
    if (has("seconds")) {
        const auto given = text("seconds");
        char* end = nullptr;
        made.seconds = std::strtod(given.c_str(), &end);
        if (given.empty() || *end != '\0' || !(*made.seconds > 0 && *made.seconds <= 1e7))
            throw usage_error{"--seconds must be a time such as 10 or 0.5, not '" + given + "'"};
    }
    return made;
}

} // namespace

arguments parse(int argc, char** argv) {
    std::vector<std::string> all{argv + 1, argv + argc};
    for (auto& each : all)
        if (each == "-h") each = "--help";
    // The command is the first word that is no option; options may stand in front of it.
    const auto visible = options_of(nullptr);
    po::options_description every;
    every.add(visible).add_options()("command", po::value<std::string>())("words",
                                                                          po::value<std::vector<std::string>>());
    po::positional_options_description places;
    places.add("command", 1).add("words", -1);
    // Without short options a negative number is a word.
    const auto style = po::command_line_style::unix_style ^ po::command_line_style::allow_short ^
                       po::command_line_style::allow_guessing;
    po::variables_map values;
    std::vector<po::option> given;
    try {
        const auto parsed = po::command_line_parser(all).options(every).positional(places).style(style).run();
        po::store(parsed, values);
        po::notify(values);
        given = parsed.options;
    } catch (const po::error& error) {
        throw usage_error{error.what()};
    }
    const auto name = values.count("command") != 0 ? values["command"].as<std::string>() : std::string{};
    const auto* const about = find(name);
    if (values.count("version") != 0) {
        std::cout << "jauscat-ecat (JausCat) " << JAUSCAT_VERSION_MAJOR << '.' << JAUSCAT_VERSION_MINOR << '.'
                  << JAUSCAT_VERSION_PATCH << "\n";
        std::exit(example::with_output("jauscat-ecat", success));
    }
    if (!name.empty() && about == nullptr)
        throw usage_error{"'" + name + "' is no command: jauscat-ecat --help lists them"};
    if (values.count("help") != 0) show_help(about);
    if (about == nullptr) throw usage_error{"a command is missing, such as scan: jauscat-ecat --help lists them"};
    const auto own = options_of(about);
    for (const auto& each : given)
        if (each.string_key != "command" && each.string_key != "words" &&
            own.find_nothrow(each.string_key, false) == nullptr)
            throw usage_error{name + " has no option --" + each.string_key};
    return made_of(values, *about);
}

std::vector<std::uint16_t> chosen_slaves(const arguments& given, const ring& on) {
    std::vector<std::uint16_t> made;
    if (given.slave && *given.slave >= on.slaves())
        throw failure{given.link.link + ": there is no slave " + std::to_string(*given.slave) +
                      ": the positions are 0 to " + std::to_string(on.slaves() - 1)};
    for (std::uint16_t i = 0; i != on.slaves(); ++i)
        if ((!given.slave || *given.slave == i) && (!given.alias || on.states()[i].alias == *given.alias))
            made.push_back(i);
    if (made.empty())
        throw failure{given.link.link + ": no slave has the alias " + std::to_string(*given.alias) +
                      ": jauscat-ecat scan shows them"};
    return made;
}

std::uint16_t chosen_slave(const arguments& given, const ring& on) {
    const auto found = chosen_slaves(given, on);
    if (found.size() == 1) return found.front();
    if (given.alias)
        throw failure{given.link.link + ": " + std::to_string(found.size()) + " slaves have the alias " +
                      std::to_string(*given.alias) + ": choose one by --slave"};
    throw usage_error{given.command + ": there are " + std::to_string(found.size()) + " slaves: choose one by --slave"};
}

void confirm(const arguments& given, const std::string& question) {
    if (given.yes) return;
    if (::isatty(STDIN_FILENO) != 1)
        throw failure{question + " Not done: there is no terminal to ask on, use --yes", not_confirmed};
    std::cerr << question << " [y/N] " << std::flush;
    std::string answer;
    if (!std::getline(std::cin, answer) || (answer != "y" && answer != "Y" && answer != "yes"))
        throw failure{"not done", not_confirmed};
}

} // namespace ecat
