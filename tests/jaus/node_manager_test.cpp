// The node manager: heartbeats, who is there, and what it says of its node and of others.
#include "support/catch.hpp"
#include "support/instant.hpp"
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/jaus/large_data/reassembler.hpp>
#include <jauscat/jaus/routing/node_manager.hpp>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace std::chrono_literals;
using support::instant;
namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;
using jaus::message_outcome;
using jauscat::time_point;

using bytes = std::vector<std::byte>;

/// All that a node manager takes.
constexpr std::array<std::uint16_t, 7> all_codes{0x4202, 0x2202, 0x2B00, 0x2B01, 0x2B02, 0x2B03, 0x4B01};

constexpr jaus::address make(unsigned subsystem, unsigned node, unsigned component = 1, unsigned instance = 1) {
    const auto id = [](unsigned n) { return static_cast<std::uint8_t>(n); };
    return {id(instance), id(component), id(node), id(subsystem)};
}
std::string text(const jaus::address& a) {
    return std::to_string(a.subsystem) + "." + std::to_string(a.node) + "." + std::to_string(a.component) + "." +
           std::to_string(a.instance);
}

/// What was sent, as text: code, source, destination; and the bytes.
struct outbox {
    std::vector<std::string> lines{};
    std::vector<bytes> messages{};

    void operator()(std::span<const std::byte> message) {
        const auto split = jaus::split(message);
        REQUIRE(split);
        char code[8];
        std::snprintf(code, sizeof code, "%04X", unsigned{split.header.command_code});
        lines.push_back(code + (" " + text(split.header.source)) + " to " + text(split.header.destination));
        messages.emplace_back(message.begin(), message.end());
    }
    std::vector<std::string> take() {
        messages.clear();
        return std::exchange(lines, {});
    }
    /// The only message, which must be a T.
    template <class T> T only(wire::arena& lists) {
        REQUIRE(messages.size() == 1);
        const auto split = jaus::split(messages.front());
        REQUIRE(split.header.command_code == jaus::command_code_of<T>);
        T message{};
        if constexpr (wire::needs_memory<T>)
            REQUIRE(wire::decode(message, split.body, lists));
        else
            REQUIRE(wire::decode(message, split.body));
        return message;
    }
};
using lines = std::vector<std::string>;

/// The node manager 1.2.1.1 with two other components.
struct node {
    std::array<jaus::configured_component, 2> components{{{33, 1}, {37, 2}}};
    jaus::node_description description{.system = {"all", 0, 9},
                                       .subsystem = {"robot", 10001, 7},
                                       .node = {"arm", 40001, 5},
                                       .manager = {"manager", 60001, 3},
                                       .components = components};
    std::array<jaus::liveness_table::place, 16> places{};
    std::array<std::byte, 1024> list_memory{};
    std::array<std::byte, 10000> report{};
    lines seen{};
    outbox out{};
    std::array<std::byte, 1 << 16> memory{};
    wire::arena lists{memory};

    struct {
        lines& all;
        void operator()(const jaus::address& who) { all.push_back("+" + text(who)); }
    } appeared{seen};
    struct {
        lines& all;
        void operator()(const jaus::address& who) { all.push_back("-" + text(who)); }
    } disappeared{seen};

    jaus::node_manager manager{
        make(1, 2), description, {places, list_memory, report}, {.appeared{appeared}, .disappeared{disappeared}}};

    template <class T>
    message_outcome hear(const jaus::address& source, const T& body, instant now = 0s,
                         const jaus::address& to = make(1, 2)) {
        std::array<std::byte, 4096> message{};
        const auto made = jaus::make_message({.destination = to, .source = source}, body, message);
        REQUIRE(made);
        const auto split = jaus::split(*made);
        return manager.on_message(split.header, split.body, now, out);
    }
    message_outcome beat(const jaus::address& source, instant now) {
        return hear(source, jaus::report_heartbeat_pulse{}, now, make(255, 255));
    }
    std::vector<std::string> configuration(jaus::query_field field) {
        out.take();
        REQUIRE(hear(make(9, 9, 9, 9), jaus::query_configuration{field}) == message_outcome::handled);
        std::vector<std::string> all;
        for (const auto& n : out.only<jaus::report_configuration>(lists).node) {
            all.push_back(std::to_string(n.node_id) + ":");
            for (const auto& c : n.component)
                all.back() += " " + std::to_string(c.component_id) + "." + std::to_string(c.instance_id);
        }
        out.take();
        return all;
    }
    std::vector<std::string> subsystems() {
        out.take();
        REQUIRE(hear(make(9, 9, 9, 9), jaus::query_subsystem_list{}) == message_outcome::handled);
        std::vector<std::string> all;
        for (const auto& s : out.only<jaus::report_subsystem_list>(lists).subsystem)
            all.push_back(text(make(s.subsystem_id, s.node_id, s.component_id, s.instance_id)));
        out.take();
        return all;
    }
};

} // namespace

TEST_CASE("a node manager broadcasts a heartbeat at once and then each second") {
    node n;
    for (int tenth = 0; tenth != 30; ++tenth) {
        REQUIRE(n.manager.next_event().value() <= instant{(tenth + 9) / 10 * 1s});
        n.manager.on_time(instant{tenth * 100ms}, n.out);
        REQUIRE(n.out.take() == (tenth % 10 == 0 ? lines{"4202 1.2.1.1 to 255.255.1.1"} : lines{}));
    }
}

TEST_CASE("a late heartbeat is sent once, and missed ones are not") {
    node n;
    n.manager.on_time(instant{0s}, n.out);
    n.manager.on_time(instant{10s + 1ms}, n.out);
    n.manager.on_time(instant{10s + 2ms}, n.out);
    REQUIRE(n.out.take().size() == 2);
    REQUIRE(*n.manager.next_event() > instant{10s + 2ms});
    REQUIRE(*n.manager.next_event() <= instant{11s + 1ms});
}

TEST_CASE("a component sends its heartbeats to its node manager, or none") {
    outbox out;
    const jaus::component_description description{};
    const auto self = make(1, 2, 33);
    jaus::described_component component{self, description, jaus::heartbeat_to_node_manager(self), {}};
    component.on_time(instant{0s}, out);
    component.on_time(instant{500ms}, out);
    component.on_time(instant{1300ms}, out); // late, which delays no other one
    REQUIRE(out.take() == lines{"4202 1.2.33.1 to 1.2.1.1", "4202 1.2.33.1 to 1.2.1.1"});
    REQUIRE(component.next_event() == instant{2s});
    jaus::described_component silent{self, description, {.period = 0s}, {}};
    silent.on_time(instant{0s}, out);
    REQUIRE(out.take().empty());
    REQUIRE_FALSE(silent.next_event());
}

TEST_CASE("a heartbeat query to a broadcast address is answered by the component itself") {
    node n;
    REQUIRE(n.hear(make(3, 1), jaus::query_heartbeat_pulse{}, 0s, make(255, 255)) == message_outcome::handled);
    REQUIRE(n.out.take() == lines{"4202 1.2.1.1 to 3.1.1.1"});
}

TEST_CASE("the identification is that of the requested level") {
    node n;
    const auto ask = [&](int level) {
        const auto what = n.hear(make(3, 1, 40), jaus::query_identification{static_cast<jaus::query_type>(level)});
        if (what != message_outcome::handled) {
            REQUIRE(n.out.messages.empty());
            return std::string{describe(what)};
        }
        REQUIRE(n.out.messages.front().size() == jaus::header_size + 84);
        const auto report = n.out.only<jaus::report_identification>(n.lists);
        REQUIRE(static_cast<int>(report.query_type) == level);
        auto all = std::string{report.identification} + " " + std::to_string(report.type) + " " +
                   std::to_string(report.authority_code);
        n.out.take();
        return all;
    };
    REQUIRE(ask(1) == "all 0 9");
    REQUIRE(ask(2) == "robot 10001 7");
    REQUIRE(ask(3) == "arm 40001 5");
    REQUIRE(ask(4) == "manager 60001 3");
    REQUIRE(ask(0) == "refused");
    REQUIRE(ask(5) == "refused");
    const std::string long_text(81, 'x');
    n.description.node.identification = long_text;
    REQUIRE(ask(3) == "refused");
}

TEST_CASE("a component identifies itself, and the node manager answers for subsystem and node") {
    outbox out;
    wire::arena lists{{}};
    const jaus::component_description description{.name = {"driver", 60001, 1}};
    jaus::described_component component{make(1, 2, 33), description, {}, {}};
    for (int level = 1; level != 5; ++level) {
        std::array<std::byte, 1> body{static_cast<std::byte>(level)};
        const auto what = component.on_message({.command_code = 0x2B00, .source = make(3, 1)}, body, instant{0s}, out);
        REQUIRE(what == (level == 4 ? message_outcome::handled : message_outcome::refused));
    }
    REQUIRE(out.only<jaus::report_identification>(lists).identification == "driver");
    REQUIRE(out.take() == lines{"4B00 1.2.33.1 to 3.1.1.1"});
}

TEST_CASE("a peer appears with its first heartbeat and is lost three periods after its last") {
    node n;
    n.manager.on_time(instant{0s}, n.out);
    REQUIRE(n.beat(make(2, 1), 0s) == message_outcome::handled);
    REQUIRE(n.beat(make(1, 2), 0s) == message_outcome::handled); // its own, heard from a multicast group
    for (int second = 1; second != 5; ++second) REQUIRE(n.beat(make(2, 1), second * 1s) == message_outcome::handled);
    REQUIRE(n.seen == lines{"+2.1.1.1"});
    REQUIRE(n.manager.present().find(make(2, 1))->last_heard_at == instant{4s});
    n.manager.on_time(instant{6s + 999ms}, n.out);
    REQUIRE(n.seen.size() == 1);
    while (n.seen.size() == 1 && n.manager.next_event().value() < instant{8s})
        n.manager.on_time(*n.manager.next_event(), n.out);
    REQUIRE(n.seen == lines{"+2.1.1.1", "-2.1.1.1"});
    REQUIRE(n.manager.present().size() == 0);
    n.beat(make(2, 1), 9s);
    REQUIRE(n.seen.back() == "+2.1.1.1");
}

TEST_CASE("loss of a peer is detected at the time that next_event returned") {
    node n;
    n.manager.on_time(instant{0s}, n.out);
    for (int i = 0; i != 5; ++i) n.beat(make(2, static_cast<unsigned>(i + 1)), i * 10ms);
    for (auto now = *n.manager.next_event(); now < instant{4s}; now = *n.manager.next_event()) {
        const auto before = n.seen.size();
        n.manager.on_time(now, n.out);
        for (auto i = before; i != n.seen.size(); ++i)
            REQUIRE(n.seen[i] == "-2." + std::to_string(1 + (now - time_point{3s}) / 10ms) + ".1.1");
        REQUIRE(*n.manager.next_event() > now);
    }
    REQUIRE(n.seen.size() == 10);
}

TEST_CASE("a silent peer is removed from every place of the table") {
    std::array<jaus::liveness_table::place, 4> places{};
    jaus::liveness_table table{places};
    for (unsigned id = 1; id != 33; ++id) {
        REQUIRE(table.on_heard(make(2, id), instant{id * 10s}, 1s) == jaus::heard::appeared);
        std::string gone;
        table.on_time(instant{id * 10s + 1s}, [&](const jaus::address& who) { gone += text(who); });
        REQUIRE(gone == text(make(2, id)));
        REQUIRE(table.next_event() == std::nullopt);
    }
}

TEST_CASE("a component that is kept from now on has the time of its last message") {
    std::array<jaus::liveness_table::place, 4> places{};
    jaus::liveness_table table{places};
    REQUIRE(table.on_heard(make(2, 1), instant{5s}, 3s) == jaus::heard::appeared);
    REQUIRE(table.keep(make(2, 1)));
    REQUIRE(table.find(make(2, 1))->last_heard_at == instant{5s});
    table.on_time(instant{1h}, [](const jaus::address&) { FAIL(); });
    REQUIRE(table.find(make(2, 1)) != nullptr);
}

TEST_CASE("a flood of peers fills the free places, is counted, and displaces no peer") {
    node n;
    n.beat(make(2, 1), 0s);
    int refused = 0;
    for (unsigned i = 0; i != 10000; ++i)
        refused += n.beat(make(3 + i / 200, 1 + i % 200), 1ms) == message_outcome::refused ? 1 : 0;
    REQUIRE(n.manager.present().size() == 12);
    REQUIRE(refused == 10000 - 11);
    REQUIRE(n.manager.not_remembered() == 10000 - 11);
    REQUIRE(n.manager.present().find(make(2, 1)) != nullptr);
    n.beat(make(2, 1), 2s);
    n.manager.on_time(instant{3s + 1ms}, n.out);
    REQUIRE(n.manager.present().size() == 1);
    REQUIRE(n.beat(make(200, 1), 4s) == message_outcome::handled);
}

TEST_CASE("a pinned peer stays without heartbeats") {
    node n;
    REQUIRE(n.manager.keep(make(4, 1)));
    REQUIRE(n.manager.keep(make(4, 1)));
    n.beat(make(4, 1), 1s);
    n.beat(make(5, 1), 1s);
    n.manager.on_time(instant{std::chrono::hours{1000}}, n.out);
    REQUIRE(n.seen == lines{"+5.1.1.1", "-5.1.1.1"});
    REQUIRE(n.subsystems() == lines{"1.2.1.1", "4.1.1.1"});
}

TEST_CASE("the configuration of the node lists described components and those that send heartbeats") {
    node n;
    REQUIRE(n.configuration(jaus::query_field::node_configuration) == lines{"2: 1.1 33.1 37.2"});
    n.beat(make(1, 2, 35, 4), 0s);
    n.beat(make(1, 2, 33, 1), 0s);
    n.beat(make(1, 1), 0s);
    n.beat(make(7, 2, 36, 1), 0s);
    REQUIRE(n.configuration(jaus::query_field::node_configuration) == lines{"2: 1.1 33.1 35.4 37.2"});
    REQUIRE(n.configuration(jaus::query_field::subsystem_configuration) == lines{"1: 1.1", "2: 1.1 33.1 35.4 37.2"});
    for (const int field : {0, 1, 4, 5})
        REQUIRE(n.hear(make(3, 1), jaus::query_configuration{static_cast<jaus::query_field>(field)}) ==
                message_outcome::refused);
}

// The report counts a node's components in one byte.
TEST_CASE("of more than 255 components of one node 255 are reported, including all described ones") {
    node n;
    std::vector<jaus::liveness_table::place> places(2048);
    bytes lists(1 << 16), report(1 << 16);
    n.components = {{{250, 9}, {251, 9}}};
    jaus::node_manager manager{make(1, 2), n.description, {places, lists, report}};
    for (unsigned i = 0; i != 600; ++i)
        for (const unsigned of : {2U, 3U})
            manager.on_message({.command_code = jaus::command_code_of<jaus::report_heartbeat_pulse>,
                                .source = make(1, of, 2 + i % 200, 1 + i / 200)},
                               {}, instant{0s}, n.out);
    for (const auto field : {jaus::query_field::node_configuration, jaus::query_field::subsystem_configuration}) {
        n.out.take();
        const std::array query{static_cast<std::byte>(field)};
        REQUIRE(
            manager.on_message({.command_code = jaus::command_code_of<jaus::query_configuration>, .source = make(9, 9)},
                               query, instant{0s}, n.out) == message_outcome::handled);
        n.lists.reset();
        const auto told = n.out.only<jaus::report_configuration>(n.lists);
        REQUIRE(told.node[0].component.size() == 255);
        REQUIRE(std::ranges::count(told.node[0].component, 9, &jaus::configured_component::instance_id) == 2);
        REQUIRE((told.node.size() == 1 || told.node[1].component.size() == 255));
    }
}

TEST_CASE(
    "a node manager queries the other nodes of its subsystem for their components and removes them with the node") {
    node n;
    n.manager.on_time(instant{0s}, n.out);
    n.out.take();
    n.beat(make(1, 5), 0s);
    n.beat(make(2, 5), 0s);
    n.beat(make(1, 5, 33), 0s);
    REQUIRE(n.out.take() == lines{"2B01 1.2.1.1 to 1.5.1.1"});
    const std::array<jaus::configured_component, 4> theirs{{{1, 1}, {33, 1}, {40, 1}, {0, 1}}};
    const std::array<jaus::configured_node, 2> nodes{{{5, theirs}, {6, theirs}}};
    REQUIRE(n.hear(make(1, 5), jaus::report_configuration{nodes}, 1s) == message_outcome::handled);
    const lines expected{"2: 1.1 33.1 37.2", "5: 1.1 33.1 40.1"};
    REQUIRE(n.configuration(jaus::query_field::subsystem_configuration) == expected);
    for (int second = 1; second != 10; ++second) {
        n.beat(make(1, 5), second * 1s);
        n.manager.on_time(instant{second * 1s}, n.out);
    }
    REQUIRE(std::ranges::count(n.out.take(), "2B01 1.2.1.1 to 1.5.1.1") == 0);
    n.manager.on_time(instant{10s}, n.out);
    REQUIRE(std::ranges::count(n.out.take(), "2B01 1.2.1.1 to 1.5.1.1") == 1);
    REQUIRE(n.configuration(jaus::query_field::subsystem_configuration) == expected);
    n.seen.clear();
    n.manager.on_time(instant{12s}, n.out); // the node manager was last heard at 9 s
    std::ranges::sort(n.seen);
    REQUIRE(n.seen == lines{"-1.5.1.1", "-1.5.33.1", "-1.5.40.1"});
    REQUIRE(n.configuration(jaus::query_field::subsystem_configuration) == lines{"2: 1.1 33.1 37.2"});
}

TEST_CASE("a node of another subsystem is not lost with the one of the same ID in the own") {
    node n;
    n.manager.on_time(instant{0s}, n.out);
    n.beat(make(1, 5), 0s);
    n.beat(make(2, 5), 0s);
    n.beat(make(2, 5), 2s);
    n.manager.on_time(instant{3s}, n.out);
    REQUIRE(n.seen == lines{"+1.5.1.1", "+2.5.1.1", "-1.5.1.1"});
}

TEST_CASE("a node manager without a survey queries another node once, when it appears") {
    node n;
    jaus::node_manager once{make(1, 2), n.description, {n.places, n.list_memory, n.report}, {.survey = 0s}};
    const jaus::header beat{.command_code = 0x4202, .destination = make(255, 255), .source = make(1, 5)};
    const jaus::header answer{.command_code = 0x4B01, .destination = make(1, 2), .source = make(1, 5)};
    const std::array<std::byte, 5> body{std::byte{1}, std::byte{5}, std::byte{1}, std::byte{33}, std::byte{1}};
    for (int second = 0; second != 100; ++second) {
        REQUIRE(once.on_message(beat, {}, instant{second * 1s}, n.out) == message_outcome::handled);
        if (second == 0) REQUIRE(once.on_message(answer, body, instant{0s}, n.out) == message_outcome::handled);
        once.on_time(instant{second * 1s}, n.out);
    }
    REQUIRE(once.present().find(make(1, 5, 33)) != nullptr); // as long as its node manager
    REQUIRE(std::ranges::count(n.out.take(), "2B01 1.2.1.1 to 1.5.1.1") == 1);
}

TEST_CASE("only a known node manager of the subsystem adds components, and only its own") {
    node n;
    const std::array<jaus::configured_component, 1> theirs{{{77, 1}}};
    const std::array<jaus::configured_node, 1> nodes{{{5, theirs}}};
    const jaus::report_configuration report{nodes};
    REQUIRE(n.hear(make(1, 5), report) == message_outcome::refused); // not known
    n.beat(make(1, 5), 0s);
    n.beat(make(1, 6), 0s);
    n.beat(make(2, 5), 0s);
    REQUIRE(n.hear(make(2, 5), report) == message_outcome::refused);
    REQUIRE(n.hear(make(1, 5, 33), report) == message_outcome::refused);
    REQUIRE(n.hear(make(1, 6), report) == message_outcome::handled); // says nothing of its own node
    REQUIRE(n.configuration(jaus::query_field::subsystem_configuration) ==
            lines{"2: 1.1 33.1 37.2", "5: 1.1", "6: 1.1"});
    // Nor does one that claims to be the own node manager, also where that is kept as alive.
    REQUIRE(n.manager.keep(make(1, 2)));
    const std::array<jaus::configured_node, 1> own{{{2, theirs}}};
    REQUIRE(n.hear(make(1, 2), jaus::report_configuration{own}) == message_outcome::refused);
    REQUIRE(n.configuration(jaus::query_field::node_configuration) == lines{"2: 1.1 33.1 37.2"});
}

TEST_CASE("the subsystem list has each subsystem once, by a node manager if one is known") {
    node n;
    REQUIRE(n.subsystems() == lines{"1.2.1.1"});
    for (const auto& who :
         {make(7, 4, 34, 1), make(7, 3, 35, 1), make(2, 9), make(2, 4), make(2, 1, 33), make(1, 1), make(200, 1)})
        n.beat(who, 0s);
    REQUIRE(n.subsystems() == lines{"1.2.1.1", "2.4.1.1", "7.3.35.1", "200.1.1.1"});
}

TEST_CASE("services are those of the queried component") {
    node n;
    REQUIRE(n.hear(make(3, 1), jaus::query_services{}) == message_outcome::handled);
    const auto ours = n.out.only<jaus::report_services>(n.lists);
    REQUIRE(ours.service.size() == 1);
    REQUIRE(ours.service[0].service_type == 1);
    REQUIRE(std::ranges::count(ours.service[0].input_message, 0x2B02, &jaus::supported_message::command_code) == 1);
    REQUIRE(std::ranges::count(ours.service[0].output_message, 0x4B02, &jaus::supported_message::command_code) == 1);
}

TEST_CASE("a component without services has the core service, and is queried until it reports one") {
    bytes memory(1000);
    outbox out;
    jaus::described_component component{make(1, 2, 33), {.services = {}}, {}, memory};
    REQUIRE(component.on_message({.command_code = 0x2B03, .source = make(3, 1)}, {}, instant{0s}, out) ==
            message_outcome::handled);
    bytes held(4000);
    wire::arena decoded{held};
    const auto report = out.only<jaus::report_services>(decoded);
    REQUIRE(report.service.size() == 1);
    REQUIRE(report.service[0] == jaus::core_messages::service);
}

TEST_CASE("a report beyond one packet is sent as a large data set, or refused without memory") {
    std::vector<jaus::supported_message> messages(200);
    for (std::size_t i = 0; i != messages.size(); ++i) messages[i].command_code = static_cast<std::uint16_t>(i);
    const std::vector<jaus::offered_service> services(5, {33, messages, {}});
    const jaus::component_description description{.services = services};
    for (const std::size_t room : {20000U, 10000U, 5000U, 4096U, 10U}) {
        bytes memory(room);
        outbox out;
        jaus::described_component component{make(1, 2, 33), description, {}, memory};
        const auto what = component.on_message({.command_code = 0x2B03, .source = make(3, 1)}, {}, instant{0s}, out);
        if (room < 11000) { // a packet and 5 * 1204 + 1 bytes of body
            REQUIRE(what == message_outcome::refused);
            REQUIRE(out.messages.empty());
            continue;
        }
        REQUIRE(what == message_outcome::handled);
        REQUIRE(out.messages.size() == 2);
        std::array<jaus::partial_data_set, 1> places{};
        std::array<jaus::held_packet, 8> packets{};
        bytes held(20000);
        jaus::reassembler sets{places, packets, held, 1s};
        int whole = 0;
        for (const auto& message : out.messages) {
            const auto split = jaus::split(message);
            sets.on_packet(
                split.header, split.body, instant{0s},
                [&](const jaus::header& head, std::span<const std::byte> body) {
                    bytes lists_memory(40000);
                    wire::arena lists{lists_memory};
                    jaus::report_services report{};
                    REQUIRE(head.command_code == 0x4B03);
                    REQUIRE(wire::decode(report, body, lists));
                    REQUIRE(report == jaus::report_services{services});
                    ++whole;
                },
                [](const jaus::partial_data_set&) {});
        }
        REQUIRE(whole == 1);
    }
}

TEST_CASE("malformed messages are reported as such, and random bodies do no harm") {
    node n;
    n.beat(make(1, 5), 0s);
    n.out.take();
    const bytes excess(3);
    for (const std::uint16_t code : all_codes) {
        const jaus::header head{.command_code = code, .destination = make(1, 2), .source = make(1, 5)};
        REQUIRE(n.manager.on_message(head, excess, instant{0s}, n.out) == message_outcome::malformed);
        auto acknowledgement = head;
        acknowledgement.ack_nak = jaus::ack_nak::ack;
        REQUIRE(n.manager.on_message(acknowledgement, {}, instant{0s}, n.out) == message_outcome::unhandled);
    }
    REQUIRE(n.out.lines.empty());
    REQUIRE(n.manager.on_message({.command_code = 0x0405, .source = make(1, 5)}, {}, instant{0s}, n.out) ==
            message_outcome::unhandled);

    std::mt19937 random{5};
    const auto below = [&](unsigned limit) { return 1 + static_cast<unsigned>(random() % limit); };
    std::array<int, 4> outcomes{};
    for (int i = 0; i != 100'000; ++i) {
        bytes body(random() % 40);
        for (auto& b : body) b = static_cast<std::byte>(random() % (i % 2 == 0 ? 256 : 6));
        const auto what = n.manager.on_message(
            {.command_code = all_codes[random() % 7], .destination = make(1, 2), .source = make(1, below(6), below(2))},
            body, instant{i * 1ms}, n.out);
        ++outcomes[static_cast<std::size_t>(what)];
        if (i % 100 == 0) n.manager.on_time(instant{i * 1ms}, n.out);
        n.out.take();
    }
    for (const auto what : {message_outcome::handled, message_outcome::refused, message_outcome::malformed})
        REQUIRE(outcomes[static_cast<std::size_t>(what)] > 100);
}

TEST_CASE("a list memory that is too small refuses the report") {
    node n;
    jaus::node_manager small{make(1, 2), n.description, {n.places, std::span{n.list_memory}.first(16), n.report}};
    for (const std::uint16_t code : {std::uint16_t{0x2B01}, std::uint16_t{0x2B02}}) {
        const std::array<std::byte, 1> field{std::byte{2}};
        const auto body = std::span{field}.first(code == 0x2B01 ? 1 : 0);
        const auto what = small.on_message({.command_code = code, .source = make(3, 1)}, body, instant{0s}, n.out);
        REQUIRE(what == message_outcome::refused);
    }
    REQUIRE(n.out.lines.empty());
    // So is that of another node, which is not malformed.
    REQUIRE(small.on_message({.command_code = 0x4202, .source = make(1, 5)}, {}, instant{0s}, n.out) ==
            message_outcome::handled);
    const std::array<jaus::configured_component, 40> theirs{};
    const std::array<jaus::configured_node, 1> nodes{{{5, theirs}}};
    std::array<std::byte, 256> body{};
    const auto report = wire::encode(jaus::report_configuration{nodes}, body);
    REQUIRE(report);
    const jaus::header head{.command_code = 0x4B01, .source = make(1, 5)};
    CHECK(small.on_message(head, *report, instant{0s}, n.out) == message_outcome::refused);
    CHECK(small.on_message(head, std::span{body}.first(1), instant{0s}, n.out) == message_outcome::malformed);
}

TEST_CASE("a node manager is a part of a component, which acknowledges what it executes") {
    node n;
    jaus::component_memory<> memory{};
    jaus::component core{make(1, 2), memory, {}, {}, n.manager};
    const auto ask = [&](std::uint8_t level) {
        const std::array<std::byte, 1> body{static_cast<std::byte>(level)};
        const jaus::header head{.ack_nak = jaus::ack_nak::request,
                                .command_code = 0x2B00,
                                .destination = make(1, 2),
                                .source = make(3, 1),
                                .data_size = 1,
                                .sequence_number = level};
        core.on_message(head, body, instant{0s}, n.out, [](const auto&...) { return message_outcome::unhandled; });
        REQUIRE_FALSE(n.out.messages.empty());
        const auto last = jaus::split(n.out.messages.back()).header;
        REQUIRE(last.command_code == 0x2B00);
        const auto answers = n.out.take().size() - 1;
        return std::pair{answers, last.ack_nak};
    };
    REQUIRE(ask(3) == std::pair{std::size_t{1}, jaus::ack_nak::ack});
    REQUIRE(ask(9) == std::pair{std::size_t{0}, jaus::ack_nak::nak});
    REQUIRE(core.next_event() == n.manager.next_event());
    core.on_time(instant{0s}, n.out);
    REQUIRE(n.out.take() == lines{"4202 1.2.1.1 to 255.255.1.1"});
}
