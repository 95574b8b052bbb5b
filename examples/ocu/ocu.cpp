// The operator control unit: takes control of a robot arm over JAUS, commands a wrench effort, queries it and compares;
// or sends any other message.
#include "operator_unit.hpp"
#include "support/known_messages.hpp"
#include "support/node_options.hpp"
#include <jauscat/catalogue/json.hpp>
#include <jauscat/jaus/component/command_rules.hpp>
#include <jauscat/jaus/message/requested_fields.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/text/from_text.hpp>
#include <jauscat/text/jaus.hpp>

#include <algorithm>
#include <optional>
#include <random>

namespace {

namespace jaus = jauscat::jaus;
namespace text = jauscat::text;
namespace wire = jauscat::wire;
using ocu::operator_unit;
using ocu::order;
using ocu::reply;
using words = std::vector<std::string>;

constexpr const char* help = R"(ocu: commands the efforts of a robot arm and queries them.

  ocu [options] [FIELD=VALUE ...]

Examples:
  ocu propulsive_linear_effort_x=50 resistive_linear_effort_x=12.5
  ocu --to 2.2.33.1 --random 7
  ocu --query
  ocu --authority 200 --hold 30 propulsive_linear_effort_x=10
  ocu --send set_travel_speed desired_speed=2.5
  ocu --send set_emergency emergency_code=transition_to_emergency
  ocu --unacknowledged propulsive_linear_effort_x=50
  ocu --web 8080 --hold 60 propulsive_linear_effort_x=50    and its messages at http://127.0.0.1:8080/

If a controlled component accepts the command from its controller only, the program takes control of the arm first, and
releases it at the end, also after Ctrl-C. Queries, reports, Set and Clear Emergency need no control.
Without --send the fields are those of Set Wrench Effort. --send accepts every message of the standard by its name, any
other by its code with its body in hex (--send D101 hex=0a14), and by name the private ones that are compiled in
(cmake option JAUSCAT_PRIVATE_MESSAGES=HEADER, docs/catalogue.md).
The report shows whether a peer that does not acknowledge has executed the command, where there is a query for it.
--unacknowledged requests no acknowledgement.
Exit code: 0 if the report equals the command, or the message of --send was answered as expected; 1 if not, if there is
no answer, or if control is refused or lost before the end; 2 for a wrong command line.
)";

/// The order to send the message `name` with the fields that the command line names.
order order_from(const std::string& name, const words& assignments) {
    auto message = example::read_message(name, assignments);
    if (!message) throw example::usage_error{message.error().message};
    return {message->command_code, std::move(message->body)};
}

order random_command(std::uint32_t seed) {
    std::mt19937 random{seed};
    jaus::set_wrench_effort command{};
    wire::visit(command, [&]<class Item>(Item, auto& effort) {
        using range = typename Item::codec_type::range_type;
        if (random() % 2 != 0) effort = std::uniform_real_distribution<double>{range::min, range::max}(random);
    });
    order made{jaus::command_code_of<jaus::set_wrench_effort>,
               std::vector<std::byte>(wire::max_size<jaus::set_wrench_effort>)};
    made.body.resize(wire::encode(command, made.body)->size());
    return made;
}

order query_efforts(std::uint16_t presence_vector) {
    std::vector<std::byte> body(wire::max_size<jaus::query_wrench_effort>);
    body.resize(wire::encode(jaus::query_wrench_effort{presence_vector}, body)->size());
    return {jaus::command_code_of<jaus::query_wrench_effort>, std::move(body)};
}

/// Queries the fields of the command and compares. Both messages have the same layout, so equal efforts are equal
/// bytes.
bool is_in_force(operator_unit& unit, const order& command, bool is_acknowledged) {
    jaus::set_wrench_effort efforts{};
    if (!wire::decode(efforts, command.body)) throw std::logic_error{"a command that does not decode"};
    const auto vector = static_cast<std::uint16_t>(jaus::presence_vector_of(efforts));
    if (unit.give(query_efforts(vector)) != reply::taken) return false;
    const bool equal = std::ranges::equal(unit.report(), command.body);
    const std::string silently = is_acknowledged ? ""
                                 : equal         ? "obeyed, not acknowledged: "
                                                 : "not acknowledged, not obeyed: ";
    ocu::say(example::events::report_compared, {{"equal", equal}, {"acknowledged", is_acknowledged}},
             (equal ? "OK: " + silently + "the report equals the command"
                    : "FAILED: " + silently + "the report differs from the command"));
    return equal;
}

/// The query for all fields of the report of what a command has set: Query Travel Speed for Set Travel Speed.
std::optional<order> query_after(const order& command) {
    const auto* const query = example::known_messages().find(static_cast<std::uint16_t>(command.command_code + 0x2000));
    if (command.command_code >= 0x2000 || query == nullptr) return {};
    words fields;
    if (const auto size = query->min_size(); size != 0) fields = {"presence_vector=0x" + std::string(2 * size, 'F')};
    const auto message = query->from_words(fields);
    if (!message) return {}; // it asks for more than fields
    auto body = message->encode();
    if (!body) return {};
    return order{query->command_code(), *std::move(body)};
}

/// Whether the report has all fields of the command, with their values.
bool has_fields_of(const order& command, std::span<const std::byte> report) {
    const auto fields = [](std::uint16_t command_code, std::span<const std::byte> body) {
        const auto* const type = example::known_messages().find(command_code);
        if (type == nullptr) return text::json::object();
        const auto message = type->decode(body);
        return message ? jauscat::catalogue::to_json(*message) : text::json::object();
    };
    const auto told = fields(command.command_code, command.body);
    const auto found = fields(static_cast<std::uint16_t>(command.command_code + 0x4000), report);
    for (const auto& [name, value] : told.items())
        if (!found.contains(name) || found[name] != value) return false;
    return !told.empty();
}

/// For a peer that never acknowledges: asks for the report of what the command has set.
bool is_reported(operator_unit& unit, const order& command, const order& query) {
    unit.expect_no_acknowledgements();
    if (unit.give(query) != reply::taken) return false;
    const bool equal = has_fields_of(command, unit.report());
    ocu::say(example::events::report_compared, {{"equal", equal}, {"acknowledged", false}},
             equal ? "OK: obeyed, not acknowledged: the report has the fields of the command"
                   : "FAILED: not acknowledged, not obeyed: the report has other fields than the command");
    return equal;
}

/// Whether a component under control accepts the command from its controller only. A sender that has set an emergency
/// may clear it without control.
bool needs_control(std::uint16_t command_code) {
    return command_code != jaus::command_code_of<jaus::clear_emergency> &&
           jaus::rule_of(command_code) != jaus::command_rule::open;
}

/// The options of the command line.
struct task {
    order first{};
    bool compare{}; ///< with the report
    bool control{};
    std::uint8_t authority{};
    std::chrono::milliseconds wait{}, hold{};
};

bool perform(operator_unit& unit, const task& what) {
    if (what.wait.count() != 0 && !unit.hear_robot(what.wait)) return false;
    if (what.control && !unit.take_control(what.authority)) return false;
    const auto query = what.compare ? std::nullopt : query_after(what.first);
    const auto answer = unit.give(what.first, what.compare || query);
    const bool is_acknowledged = answer == reply::taken;
    if (answer == reply::silence && query) return is_reported(unit, what.first, *query) && !unit.has_lost_control();
    if (!is_acknowledged && answer != reply::sent && !(answer == reply::silence && what.compare)) return false;
    if (!is_acknowledged) unit.expect_no_acknowledgements();
    if (!what.compare)
        ocu::say(example::events::done, {{"acknowledged", is_acknowledged}},
                 is_acknowledged ? "OK" : "OK: sent, and no acknowledgement was asked for");
    else if (!is_in_force(unit, what.first, is_acknowledged))
        return false;
    if (unit.has_lost_control()) return false;
    unit.hold(what.hold);
    return true;
}

} // namespace

int main(int argc, char** argv) {
    return example::run("ocu", [&] {
        namespace po = boost::program_options;
        po::options_description options;
        // clang-format off
        options.add_options()
            ("config", po::value<std::string>()->default_value("JausConfig.xml"), "configuration file")
            ("this", po::value<std::string>(), "the system this unit is, instead of the file's <thissystem>")
            ("to", po::value<std::string>()->default_value("2.2.33.1"), "JAUS ID of the arm")
            ("authority", po::value<unsigned>()->default_value(128), "authority of the request for control, 0 to 255; a higher one takes control from a lower one")
            ("no-control", po::bool_switch(), "send without taking control first")
            ("unacknowledged", po::bool_switch(), "request no acknowledgements, for peers that never send them")
            ("hold", po::value<double>()->default_value(0), "seconds to keep control at the end")
            ("wait", po::value<double>()->default_value(0), "seconds to wait for a heartbeat of any component of the robot before the first message; 0: none")
            ("random", po::value<std::uint32_t>(), "command random fields generated from this seed")
            ("query", "query all efforts, command nothing")
            ("send", po::value<std::string>(), "send this message instead, with the FIELD=VALUE arguments")
            ("timeout", po::value<unsigned>()->default_value(400), "milliseconds after which an unanswered message is sent again, or given up after the last attempt")
            ("attempts", po::value<unsigned>()->default_value(4), "how often a message is sent in all until it is answered")
            ("field", po::value<words>(), "FIELD=VALUE; --field itself may be omitted");
        // clang-format on
        example::add_type_option(options);
        example::add_web_options(options);
        example::add_log_option(options);
        po::positional_options_description positional;
        positional.add("field", -1);
        const auto values = example::parse(argc, argv, options, help, positional);

        const bool query_only = values.count("query") != 0, random = values.count("random") != 0;
        const bool send = values.count("send") != 0, has_fields = values.count("field") != 0;
        if (query_only + random + (send || has_fields) != 1)
            throw example::usage_error{"give either FIELD=VALUE arguments, or --random SEED, or --query, or --send"};
        const auto in_range = [&](const char* name, auto least, auto most) {
            const auto value = values[name].as<decltype(least)>();
            if (!(value >= least && value <= most))
                throw example::usage_error{std::string{"--"} + name + " must be " + text::to_text(least) + " to " +
                                           text::to_text(most)};
            return value;
        };
        const auto seconds = [&](const char* name) {
            return std::chrono::duration_cast<std::chrono::milliseconds>(
                std::chrono::duration<double>{in_range(name, 0.0, 86400.0)});
        };
        task what{.authority = static_cast<std::uint8_t>(in_range("authority", 0U, 255U)),
                  .wait = seconds("wait"),
                  .hold = seconds("hold")};
        const jauscat::retry_policy retry{.interval = std::chrono::milliseconds{in_range("timeout", 1U, 60000U)},
                                          .attempts = in_range("attempts", 1U, 1000U)};
        const auto robot = example::parse_address(values["to"].as<std::string>());
        if (!jaus::names_one_component(robot)) throw example::usage_error{"--to must name one component"};

        const words fields = has_fields ? values["field"].as<words>() : words{};
        if (query_only)
            what.first = query_efforts(0x0FFF);
        else if (random)
            what.first = random_command(values["random"].as<std::uint32_t>());
        else
            what.first = order_from(send ? values["send"].as<std::string>() : "set_wrench_effort", fields);
        what.compare = !query_only && !send;
        what.control = !values["no-control"].as<bool>() && needs_control(what.first.command_code);

        const auto config = example::load_config(values);
        example::live_view view{"ocu", values, config.this_system, example::known_messages()};
        operator_unit unit{
            config,          robot, retry, !values["unacknowledged"].as<bool>(), example::subsystem_type(values),
            view.make_feed()};
        view.start();
        view.tell();
        const bool done = perform(unit, what);
        return unit.finish() && done ? example::success : example::failure;
    });
}
