// The node without sockets: two of them against each other, in simulated time.
#include "net/simulated_program.hpp"
#include "support/bytes.hpp"
#include <jauscat/schema/jaus/environment_sensor.hpp>
#include <jauscat/schema/jaus/event.hpp>
#include <jauscat/text/jaus.hpp>

using namespace net_test;
using std::chrono::nanoseconds;

namespace {

struct simulated_pair {
    simulated_network network{};
    std::string systems = system("ocu", "1.0.0.0", 1001) + system("robot", "2.0.0.0", 1002);
    simulated_program ocu{network, config("ocu", systems), make(1, 1, 32)};
    simulated_program robot{network, config("robot", systems), make(2, 1, 33)};
};

/// Lists Set Wrench Effort with some of its fields.
struct listing {
    std::uint32_t fields{};
    void list_messages(auto&& takes, auto&&) const { takes(jaus::supported_message{0x0405, fields}); }
};

/// Twenty a second.
void request_status_events(simulated_pair& p, const jaus::address& provider) {
    REQUIRE(p.ocu.node.send({.destination = provider, .source = p.ocu.self},
                            jaus::create_event{.message_code = jaus::command_code_of<jaus::report_component_status>,
                                               .event_type = jaus::event_type::periodic,
                                               .requested_periodic_rate = 20.0},
                            p.network.now));
}

} // namespace

TEST_CASE("two nodes without sockets discover each other, exchange commands and lose each other in simulated time") {
    simulated_pair p;
    auto& now = p.network.now;
    const auto begin = now;
    REQUIRE(p.network.run(begin + 2s, [&] { return has(p.ocu.appeared, make(2, 1)); }));
    REQUIRE(has(p.robot.appeared, make(1, 1)));

    p.ocu.other.ask(5, now, p.ocu.node.out(now));
    REQUIRE(p.network.run(now + 1s, [&] { return p.ocu.other.state() == jaus::control_state::held; }));
    REQUIRE(p.robot.core.control().controls(p.ocu.self));

    // Half of what is sent gets lost.
    p.network.faults = {.lose = 50};
    REQUIRE(p.ocu.core.send({.destination = p.robot.self}, jaus::standby{}, now, p.ocu.node.out(now)));
    REQUIRE(p.network.run(now + 1s, [&] { return !p.ocu.hooks.delivered.empty(); }));
    REQUIRE(p.ocu.hooks.delivered == std::vector{jaus::delivered::acknowledged});
    REQUIRE(p.robot.core.state() == jaus::primary_status_code::standby);

    // The last heartbeat came at most a second ago; three seconds of silence end it.
    p.network.faults = {};
    p.network.run(now + 1100ms);
    p.network.detach(p.ocu.at);
    const auto silent_since = now;
    REQUIRE(p.network.run(now + 10s, [&] { return has(p.robot.disappeared, make(1, 1)); }));
    REQUIRE(now - silent_since <= 3s);
    REQUIRE(now - silent_since >= 2s);
    REQUIRE_FALSE(p.robot.core.control().controller());
}

TEST_CASE("a node sends periodic events of its component's status at their rate") {
    simulated_pair p;
    auto& now = p.network.now;
    unsigned events = 0;
    p.ocu.heard = [&](const jaus::header& head, std::span<const std::byte>) {
        events += head.command_code == jaus::command_code_of<jaus::event>;
    };
    request_status_events(p, p.robot.self);
    p.network.run(now + 1s);
    CHECK(events >= 19);
}

TEST_CASE("a message whose header does not encode is not sent, however large it is") {
    simulated_pair p;
    for (const std::size_t size : {3U, 10'000U}) {
        const auto sent =
            p.ocu.node.send({.priority = 16, .command_code = 0xD111, .destination = p.robot.self, .source = p.ocu.self},
                            bytes(size), p.network.now);
        REQUIRE_FALSE(sent);
        CHECK(sent.error().code == net::errc::invalid_message);
    }
}

TEST_CASE("large data sets beyond the memory of a node are not sent, because its queue is full") {
    simulated_pair p;
    const jaus::header head{.command_code = 0xD111, .destination = p.robot.self, .source = p.ocu.self};
    const auto sent = p.ocu.node.send(head, bytes((std::size_t{16} << 20U) + 1), p.network.now);
    REQUIRE_FALSE(sent);
    CHECK(sent.error().code == net::errc::queue_full);
    CHECK(sent.error().message == "a large data set is not sent: too many bytes wait to be sent");
}

TEST_CASE("a program without a node manager has lost at once what another program's has lost") {
    simulated_network network;
    const auto systems = system("ocu", "1.0.0.0", 1001) + system("robot", "2.1.33.0", 1002);
    simulated_program ocu{network, config("ocu", systems), make(1, 1, 32)};
    simulated_program robot{network, config("robot", systems), make(2, 1, 33)};
    auto& now = network.now;
    ocu.other.ask(5, now, ocu.node.out(now));
    REQUIRE(network.run(now + 1s, [&] { return robot.core.control().controls(ocu.self); }));
    network.run(now + 10ms);
    robot.node.lose(GENERATE(make(1, 1, 32), make(1, 1, 1)), now); // the operator, or its node
    CHECK_FALSE(robot.core.control().controller());
    CHECK(robot.node.next_event() == now);
}

TEST_CASE("the sender of a motion command is watched from its arrival on, also where its execution takes time") {
    simulated_pair p;
    auto& now = p.network.now;
    p.robot.outcome = GENERATE(jaus::message_outcome::handled, jaus::message_outcome::deferred);
    REQUIRE(p.network.run(now + 2s, [&] { return has(p.robot.appeared, make(1, 1)); }));
    unsigned queries = 0;
    p.robot.on_sent = [&](std::span<const std::byte> message) {
        const auto m = jaus::split(message);
        queries += m.header.command_code == jaus::command_code_of<jaus::query_heartbeat_pulse> &&
                   m.header.destination == p.ocu.self;
    };
    REQUIRE(
        p.ocu.node.send({.command_code = 0xD111, .destination = p.robot.self, .source = p.ocu.self}, bytes(3), now));
    REQUIRE(p.network.run(now + 1s, [&] { return !p.robot.large.empty(); }));
    p.network.detach(p.ocu.at);
    p.network.run(now + jaus::control_options{}.timeout);
    CHECK(queries == 3); // after one, two and three quarters of it
}

TEST_CASE("what a program with a node manager is told to have lost is lost only if its manager says so") {
    simulated_pair p;
    auto& now = p.network.now;
    p.ocu.other.ask(5, now, p.ocu.node.out(now));
    REQUIRE(p.network.run(now + 1s, [&] { return p.robot.core.control().controls(p.ocu.self); }));
    p.robot.node.lose(p.ocu.self, now);
    CHECK(p.robot.core.control().controls(p.ocu.self));
}

TEST_CASE("what is sent between two turns counts from the time that was given") {
    simulated_pair p;
    const auto later = p.network.now + 5s;
    std::array<std::byte, jaus::header_size> message{};
    const auto sent =
        jaus::join({.command_code = 0xD111, .destination = p.ocu.self, .source = p.robot.self}, {}, message);
    REQUIRE(sent);
    p.robot.node.out(later)(*sent);
    CHECK(p.robot.node.next_event() == later);
}

TEST_CASE("a stopped node takes no message") {
    simulated_pair p;
    const auto heartbeat = support::bytes(0x06, 0x02, 0x02, 0x42, 1, 33, 1, 2, 1, 32, 1, 1, 0, 0, 0, 0);
    unsigned heard = 0;
    p.robot.heard = [&](const jaus::header&, std::span<const std::byte>) { ++heard; };
    const auto take = [&] {
        p.robot.node.received(heartbeat, p.ocu.at, jaus::framing::bare, false, p.network.now, {});
        return std::exchange(heard, 0U);
    };
    CHECK(take() == 1);
    p.robot.node.stop();
    CHECK(take() == 0);
}

TEST_CASE("a message that cannot be routed is not sent, however large it is") {
    simulated_pair p;
    const auto nobody = GENERATE(make(3, 1, 33), make(1, 1, 33)); // no route, no such component of the node
    const auto sent = p.ocu.node.send({.command_code = 0xD111, .destination = nobody, .source = p.ocu.self},
                                      bytes(GENERATE(10u, 100'000u)), p.network.now);
    REQUIRE_FALSE(sent);
    CHECK(sent.error().code == net::errc::unroutable);
}

TEST_CASE("an exception of the log handler while a component sends leaves the node's next turn") {
    simulated_pair p;
    auto& now = p.network.now;
    p.robot.on_log = [](std::string_view line) { throw std::runtime_error{std::string{line}}; };
    std::array<std::byte, jaus::header_size> message{};
    const auto sent =
        jaus::join({.command_code = 0xD111, .destination = make(3, 1, 33), .source = p.robot.self}, {}, message);
    REQUIRE(sent);
    p.robot.node.out(now)(*sent);
    CHECK_THROWS_AS(p.robot.node.on_time(now), std::runtime_error);
    CHECK_NOTHROW(p.robot.node.on_time(now));
}

TEST_CASE("an event on demand has the time at which it was requested") {
    simulated_pair p;
    auto& now = p.network.now;
    std::optional<jaus::report_time> reported;
    p.ocu.heard = [&](const jaus::header& head, std::span<const std::byte> body) {
        jaus::event event{};
        if (head.command_code != jaus::command_code_of<jaus::event> || !wire::decode(event, body)) return;
        REQUIRE(wire::decode(reported.emplace(), event.report_message_body));
    };
    const jaus::header head{.destination = p.robot.self, .source = p.ocu.self};
    REQUIRE(p.ocu.node.send(head, jaus::set_time{.time_stamp = jaus::time_stamp{.hours = 12}}, now));
    p.network.run(now + 1234ms);
    REQUIRE(p.ocu.node.send(head,
                            jaus::create_event{.message_code = jaus::command_code_of<jaus::report_time>,
                                               .event_type = jaus::event_type::one_time_on_demand},
                            now));
    p.network.run(now + 1ms);
    REQUIRE(reported);
    REQUIRE(reported->time_stamp);
    CHECK(reported->time_stamp->seconds == 1);
    CHECK(reported->time_stamp->milliseconds == 234);
}

TEST_CASE("the reports of a connection to the time have the time at which they are sent") {
    simulated_pair p;
    auto& now = p.network.now;
    std::vector<unsigned> seconds;
    p.ocu.heard = [&](const jaus::header& head, std::span<const std::byte> body) {
        jaus::report_time report{};
        if (head.command_code != jaus::command_code_of<jaus::report_time>) return;
        REQUIRE(wire::decode(report, body));
        seconds.push_back(report.time_stamp ? report.time_stamp->seconds : 99);
    };
    const jaus::header head{.destination = make(2, 1), .source = p.ocu.self};
    REQUIRE(p.ocu.node.send(head, jaus::set_time{.time_stamp = jaus::time_stamp{.hours = 12}}, now));
    p.network.run(now + 100ms);
    REQUIRE(
        p.ocu.node.send(head, jaus::create_service_connection{jaus::command_code_of<jaus::report_time>, 1, 0xFF}, now));
    p.network.run(now + 3500ms);
    CHECK(seconds == std::vector{0U, 1U, 2U, 3U});
}

TEST_CASE("a node that was stopped sends no events that were requested before") {
    simulated_pair p;
    auto& now = p.network.now;
    unsigned events = 0;
    p.robot.on_sent = [&](std::span<const std::byte> message) {
        events += jaus::split(message).header.command_code == jaus::command_code_of<jaus::event>;
    };
    request_status_events(p, p.robot.self);
    p.network.run(now + 1s);
    CHECK(events >= 19);
    p.robot.node.stop();
    p.robot.node.start(now);
    events = 0;
    p.network.run(now + 1s);
    CHECK(events == 0);
}

TEST_CASE("an event on change is not sent for a change before it was requested") {
    simulated_pair p;
    auto& now = p.network.now;
    unsigned events = 0;
    p.robot.on_sent = [&](std::span<const std::byte> message) {
        events += jaus::split(message).header.command_code == jaus::command_code_of<jaus::event>;
    };
    const jaus::header head{.destination = p.robot.self, .source = p.ocu.self};
    const auto request = [&] {
        REQUIRE(p.ocu.node.send(head,
                                jaus::create_event{.message_code = jaus::command_code_of<jaus::report_component_status>,
                                                   .event_type = jaus::event_type::every_change},
                                now));
        p.network.run(now + 100ms);
    };
    request();
    REQUIRE(p.ocu.node.send(head, jaus::cancel_event{}, now));
    p.network.run(now + 100ms);
    REQUIRE(p.ocu.node.send(head, jaus::standby{}, now));
    p.network.run(now + 100ms);
    request();
    CHECK(events == 0);
    REQUIRE(p.ocu.node.send(head, jaus::resume{}, now));
    p.network.run(now + 100ms);
    CHECK(events == 1);
}

TEST_CASE("a node of another subsystem makes no event of the configuration of the own") {
    simulated_network network{};
    const auto systems =
        system("ocu", "1.0.0.0", 1001) + system("robot", "2.1.0.0", 1002) + system("tool", "2.2.0.0", 1003);
    simulated_program robot{network, config("robot", systems), make(2, 1, 33)};
    unsigned events = 0;
    robot.on_sent = [&](std::span<const std::byte> message) {
        events += jaus::split(message).header.command_code == jaus::command_code_of<jaus::event>;
    };
    simulated_program ocu{network, config("ocu", systems), make(1, 1, 32)};
    REQUIRE(ocu.node.send({.destination = make(2, 1), .source = ocu.self},
                          jaus::create_event{.message_code = jaus::command_code_of<jaus::report_configuration>,
                                             .event_type = jaus::event_type::every_change},
                          network.now));
    network.run(network.now + 2s);
    REQUIRE(has(robot.appeared, make(1, 1)));
    CHECK(events == 0);
    simulated_program tool{network, config("tool", systems), make(2, 2, 50)};
    network.run(network.now + 2s);
    REQUIRE(has(robot.appeared, make(2, 2)));
    CHECK(events != 0);
}

TEST_CASE("a component of the own node that is lost does not take others of the node with it") {
    simulated_network network{};
    const auto systems = system("ocu", "1.0.0.0", 1001) + system("robot", "2.0.0.0", 1002) +
                         system("first", "2.1.40.0", 1003) + system("second", "2.1.41.0", 1004);
    simulated_program robot{network, config("robot", systems), make(2, 1, 33)};
    const auto arrives = [&](unsigned port, const jaus::address& from, const jaus::address& to, const auto& body) {
        std::array<std::byte, 64> message{};
        const auto made = jaus::make_message({.destination = to, .source = from}, body, message);
        REQUIRE(made);
        const simulated_network::endpoint at{boost::asio::ip::make_address("127.0.0.1"),
                                             static_cast<std::uint16_t>(port)};
        REQUIRE(robot.node.on_datagram(*made, at, {}, false, network.now) == net::verdict::accepted);
    };
    arrives(1003, make(2, 1, 40), make(2, 1), jaus::report_heartbeat_pulse{});
    REQUIRE(has(robot.appeared, make(2, 1, 40)));
    network.run(network.now + 2s);
    const jaus::set_emergency stop{{jaus::set_emergency_code::transition_to_emergency}};
    arrives(1004, make(2, 1, 41), robot.self, stop);
    REQUIRE(network.run(network.now + 2s, [&] { return has(robot.disappeared, make(2, 1, 40)); }));
    // The one that holds the emergency is there: no other one ends it.
    arrives(1001, make(1, 1, 32), robot.self, jaus::clear_emergency{{jaus::clear_emergency_code::clear_emergency}});
    CHECK(robot.core.state() == jaus::primary_status_code::emergency);
    arrives(1004, make(2, 1, 41), robot.self, jaus::clear_emergency{{jaus::clear_emergency_code::clear_emergency}});
    CHECK(robot.core.state() == jaus::primary_status_code::standby);
}

TEST_CASE("what a component sends to a silent stranger goes out, unless it is a report that is sent repeatedly") {
    simulated_network network{};
    simulated_program robot{
        network, config("robot", system("robot", "2.0.0.0", 1002)), make(2, 1, 33), {.accept = net::access::open}};
    const auto stranger = make(7, 1, 35);
    std::array<std::byte, 64> message{};
    const auto made =
        jaus::make_message({.destination = robot.self, .source = stranger}, jaus::query_component_status{}, message);
    REQUIRE(made);
    REQUIRE(robot.node.on_datagram(*made, {boost::asio::ip::make_address("10.9.9.9"), 1001}, {}, false, network.now) ==
            net::verdict::accepted);
    const auto goes_out = [&](bool of_connection, const auto& body) {
        const auto before = network.sent;
        const jaus::header head{.service_connection = of_connection, .destination = stranger, .source = robot.self};
        REQUIRE(robot.node.send(head, body, network.now));
        return network.sent == before + 1;
    };
    const jaus::report_component_status report{};
    CHECK(goes_out(false, jaus::event{}));
    CHECK(goes_out(true, report));
    network.run(network.now + 10s);
    CHECK_FALSE(goes_out(false, jaus::event{}));
    CHECK_FALSE(goes_out(true, report));
    CHECK(goes_out(false, report));
    CHECK(goes_out(false, jaus::query_heartbeat_pulse{}));
}

TEST_CASE("a component without a name has the authority of the configuration") {
    simulated_network network;
    const auto systems =
        system("ocu", "1.0.0.0", 1001) + system("robot", "2.0.0.0", 1002, "<component id='33' authority='7'/>");
    simulated_program ocu{network, config("ocu", systems), make(1, 1, 32)};
    simulated_program robot{network, config("robot", systems), make(2, 1, 33)};
    unsigned told = 0;
    ocu.heard = [&](const jaus::header& head, std::span<const std::byte> body) {
        jaus::report_identification report{};
        if (head.command_code == jaus::command_code_of<jaus::report_identification> && wire::decode(report, body))
            told = report.authority_code;
    };
    REQUIRE(ocu.node.send({.destination = robot.self, .source = ocu.self},
                          jaus::query_identification{jaus::query_type::component_identification}, network.now));
    network.run(network.now + 10ms);
    CHECK(told == 7);
}

TEST_CASE("a component is taken away only while its node is stopped") {
    simulated_pair p;
    REQUIRE_THROWS_AS(p.robot.node.remove(p.robot.self), std::logic_error);
    p.robot.node.stop();
    p.robot.node.remove(p.robot.self);
    p.robot.node.start(p.network.now);
    p.network.run(p.network.now + 1s);
    REQUIRE(p.ocu.node.send({.command_code = 0xD111, .destination = p.robot.self, .source = p.ocu.self},
                            std::span<const std::byte>{}, p.network.now));
    p.network.run(p.network.now + 1s);
    CHECK(p.robot.large.empty());
}

TEST_CASE("a handler that has stopped its node can neither take a component away nor start it") {
    simulated_pair p;
    p.robot.heard = [&](const jaus::header&, std::span<const std::byte>) {
        p.robot.node.stop();
        CHECK_THROWS_AS(p.robot.node.remove(p.robot.self), std::logic_error);
        CHECK_THROWS_AS(p.robot.node.start(p.network.now), std::logic_error);
    };
    REQUIRE(p.network.run(p.network.now + 2s, [&] { return !p.robot.node.running(); }));
    p.robot.heard = {};
    // Outside of the handler it can.
    CHECK_NOTHROW(p.robot.node.remove(p.robot.self));
    CHECK_NOTHROW(p.robot.node.start(p.network.now));
}

TEST_CASE("time has no effect on a stopped node, also in the handler that has stopped it") {
    simulated_pair p;
    p.robot.heard = [&](const jaus::header&, std::span<const std::byte>) {
        p.robot.node.stop();
        const auto sent = p.network.sent;
        p.robot.node.on_time(p.network.now + 10s);
        CHECK(p.network.sent == sent);
        CHECK(p.robot.node.in_turn()); // until the handler returns
    };
    REQUIRE(p.network.run(p.network.now + 2s, [&] { return !p.robot.node.running(); }));
    CHECK_FALSE(p.robot.node.in_turn());
}

TEST_CASE("a datagram of AS5669-2007 that is refused is told with the reason, each time if it is not its framing") {
    simulated_pair p;
    auto heartbeat = support::bytes(0x06, 0x02, 0x02, 0x42, 1, 33, 1, 2, 1, 32, 1, 1, 0, 0, 0, 0);
    const auto lines_after_two = [&](const simulated_network::endpoint& from, net::verdict expected) {
        p.robot.log.clear();
        for (int i = 0; i != 2; ++i)
            CHECK(p.robot.node.check(heartbeat, from, jaus::framing::judp1, p.network.now) == expected);
        CHECK(p.robot.logged(describe(expected)));
        return p.robot.log.size();
    };
    CHECK(lines_after_two(p.ocu.at, net::verdict::other_framing) == 1);
    heartbeat[11] = std::byte{9}; // from a subsystem that is not configured
    CHECK(lines_after_two({boost::asio::ip::make_address("10.9.9.9"), 1001}, net::verdict::unknown_peer) == 2);
}

TEST_CASE("a node is identified by its name, or else by that of its system") {
    const bool has_name = GENERATE(true, false);
    simulated_network network;
    const auto systems = system("ocu", "1.0.0.0", 1001) +
                         system("robot", "2.0.0.0", 1002, has_name ? "<node id='1' name='arm'/>" : "<node id='1'/>");
    simulated_program ocu{network, config("ocu", systems), make(1, 1, 32)};
    simulated_program robot{network, config("robot", systems), make(2, 1, 33)};
    std::string told;
    ocu.heard = [&](const jaus::header& head, std::span<const std::byte> body) {
        jaus::report_identification report{};
        if (head.command_code == jaus::command_code_of<jaus::report_identification> && wire::decode(report, body))
            told = report.identification;
    };
    REQUIRE(ocu.node.send({.destination = make(2, 1), .source = ocu.self},
                          jaus::query_identification{jaus::query_type::node_identification}, network.now));
    network.run(network.now + 10ms);
    CHECK(told == (has_name ? "arm" : "robot"));
}

TEST_CASE("where a system has no node manager, another component may have its address") {
    simulated_network network{};
    const auto systems = system("ocu", "1.0.0.0", 1001) + system("robot", "2.1.33.0", 1002);
    simulated_program robot{network, config("robot", systems), make(2, 1, 1)};
    robot.node.stop();
    robot.node.remove(robot.self);
    CHECK_NOTHROW(robot.node.add(robot.core, robot.application)); // it was taken away
}

TEST_CASE("a node lists its own components, not those of other nodes") {
    simulated_network network;
    const auto other = GENERATE(make(1, 1, 32), make(2, 3, 32)); // another subsystem, another node
    const auto systems =
        system("ocu", net::to_jausip(make(other.subsystem, other.node, 0, 0)), 1001, "<component id='44'/>") +
        system("robot", "2.1.0.0", 1002, "<component id='45'/>");
    simulated_program ocu{network, config("ocu", systems), other};
    simulated_program robot{network, config("robot", systems), make(2, 1, 33)};
    std::vector<unsigned> listed;
    ocu.heard = [&](const jaus::header& head, std::span<const std::byte> body) {
        if (head.command_code != jaus::command_code_of<jaus::report_configuration>) return;
        listed.clear();
        for (std::size_t i = 3; i < body.size(); i += 2) listed.push_back(std::to_integer<unsigned>(body[i]));
    };
    REQUIRE(ocu.node.send({.destination = make(2, 1), .source = ocu.self},
                          jaus::query_configuration{jaus::query_field::node_configuration}, network.now));
    network.run(network.now + 10ms);
    std::ranges::sort(listed);
    CHECK(listed == std::vector{1U, 33U, 45U});
}

TEST_CASE("an event of a node manager's change is sent with the message that changes it") {
    simulated_pair p;
    auto& now = p.network.now;
    unsigned events = 0;
    p.robot.on_sent = [&](std::span<const std::byte> message) {
        events += jaus::split(message).header.command_code == jaus::command_code_of<jaus::event>;
    };
    const jaus::header head{.destination = make(2, 1), .source = p.ocu.self};
    REQUIRE(p.ocu.node.send(head,
                            jaus::create_event{.message_code = jaus::command_code_of<jaus::report_component_status>,
                                               .event_type = jaus::event_type::every_change},
                            now));
    p.network.run(now + 100ms);
    events = 0;
    REQUIRE(p.ocu.node.send(head, jaus::standby{}, now));
    p.network.run(now + 1ms);
    CHECK(events == 1);
}

TEST_CASE("events of a node manager's status end with the loss of their consumer") {
    simulated_pair p;
    auto& now = p.network.now;
    unsigned events = 0;
    p.robot.on_sent = [&](std::span<const std::byte> message) {
        events += jaus::split(message).header.command_code == jaus::command_code_of<jaus::event>;
    };
    request_status_events(p, make(2, 1));
    p.network.run(now + 1s);
    CHECK(events >= 19);
    p.network.detach(p.ocu.at);
    REQUIRE(p.network.run(now + 10s, [&] { return has(p.robot.disappeared, make(1, 1)); }));
    events = 0;
    p.network.run(now + 1s);
    CHECK(events == 0);
}

TEST_CASE("a node without sockets paces large data sets, and sends nothing while it is stopped") {
    simulated_pair p;
    auto& now = p.network.now;
    const bytes image(100'000, std::byte{7});
    const jaus::header head{.command_code = 0xD111, .destination = p.robot.self, .source = p.ocu.self};
    p.network.run(now + 1s); // nothing large is sent right after the start
    REQUIRE(p.ocu.node.send(head, std::span<const std::byte>{image}, now));
    const auto begin = now;
    REQUIRE(p.network.run(now + 1s, [&] { return !p.robot.large.empty(); }));
    REQUIRE(p.robot.large.front() == image);
    REQUIRE(now - begin > 5ms); // 25 packets, 4 each millisecond
    REQUIRE(now - begin < 10ms);

    p.ocu.node.stop();
    REQUIRE(p.ocu.node.next_event() == std::nullopt);
    REQUIRE_FALSE(p.ocu.node.send(head, std::span<const std::byte>{image}, now));
    p.robot.node.stop();
    const auto sent = p.network.sent;
    p.network.run(now + 10s);
    REQUIRE(p.network.sent == sent);
    p.ocu.node.start(now);
    p.robot.node.start(now);
    p.ocu.appeared.clear();
    REQUIRE(p.network.run(now + 2s, [&] { return has(p.ocu.appeared, make(2, 1)); }));
}

TEST_CASE("a body of one byte more than a packet holds is sent as a large data set of two packets") {
    simulated_pair p;
    auto& now = p.network.now;
    std::vector<jaus::data_flag> flags{};
    p.ocu.on_sent = [&](std::span<const std::byte> message) {
        if (const auto m = jaus::split(message); m.header.command_code == 0xD111) flags.push_back(m.header.data_flag);
    };
    const jaus::header head{.command_code = 0xD111, .destination = p.robot.self, .source = p.ocu.self};
    const bytes body(4081, std::byte{7});
    REQUIRE(p.ocu.node.send(head, std::span{body}.first(4080), now));
    p.network.run(now + 1s);
    CHECK(flags == std::vector{jaus::data_flag::only});
    flags.clear();
    REQUIRE(p.ocu.node.send(head, std::span{body}, now));
    p.network.run(now + 1s);
    CHECK(flags == std::vector{jaus::data_flag::first, jaus::data_flag::last});
    REQUIRE(p.robot.large.size() == 2);
    CHECK(p.robot.large.back() == body);
}

TEST_CASE("a node sends a typed message of unbounded size, as a large data set if necessary") {
    simulated_pair p;
    auto& now = p.network.now;
    std::vector<std::size_t> sizes{};
    const jaus::header head{.destination = p.robot.self, .source = p.ocu.self};
    const bytes pixels(100'000, std::byte{7});
    jaus::report_image image{.camera_id = 1, .image_data = std::span{pixels}.first(10)};
    p.robot.heard = [&](const jaus::header& h, std::span<const std::byte> body) {
        if (h.command_code == jaus::command_code_of<jaus::report_image>) sizes.push_back(body.size());
    };
    p.network.run(now + 1s);
    REQUIRE(p.ocu.node.send(head, image, now));
    image.image_data = pixels;
    REQUIRE(p.ocu.node.send(head, image, now));
    REQUIRE(p.network.run(now + 1s, [&] { return sizes.size() == 2; }));
    REQUIRE(sizes == std::vector<std::size_t>{12, 100'002});
    REQUIRE(p.ocu.node.send(head, jaus::create_event{.message_code = 0x4405}, now));
}

// The queue holds what it is just sending, whatever a handler does.
TEST_CASE("a handler may stop the node while a large data set is sent") {
    for (const auto how : {jaus::ack_nak::none, jaus::ack_nak::request}) {
        CAPTURE(how);
        simulated_pair p;
        auto& now = p.network.now;
        const bytes image(100'000, std::byte{7});
        p.network.run(now + 1s);
        p.ocu.on_sent = [&](std::span<const std::byte> message) {
            if (jaus::split(message).header.command_code == 0xD111) p.ocu.node.stop();
        };
        REQUIRE(
            p.ocu.node.send({.ack_nak = how, .command_code = 0xD111, .destination = p.robot.self, .source = p.ocu.self},
                            std::span<const std::byte>{image}, now));
        REQUIRE(p.network.run(now + 1s, [&] { return !p.ocu.node.running(); }));
        REQUIRE(p.ocu.logged("1 large data sets were not sent to their end"));
        p.network.run(now + 1s);
    }
}

TEST_CASE("a component lists each message that its dispatcher handles or its parts send once") {
    simulated_pair p;
    jaus::dispatcher application{jaus::on<jaus::set_wrench_effort>([](const jaus::header&, const auto&) {}),
                                 jaus::on<jaus::query_wrench_effort>([](const jaus::header&, const auto&) {}),
                                 jaus::on<jaus::standby>([](const jaus::header&, const auto&) {})};
    const net::detail::offered_messages offered{p.robot.core, application};
    using list = std::vector<jaus::supported_message>;
    REQUIRE(offered.input == list{{0x0008}, {0x000A}, {0x000B}, {0x000C}, {0x0405, 0xFFF}, {0x2405}}); // not Standby
    REQUIRE(offered.output == list{{0x0009}, {0x4405, 0xFFFFFFFF}});
}

TEST_CASE("a message that is listed twice has the fields of both") {
    const net::detail::offered_messages offered{listing{1}, listing{6}};
    REQUIRE(offered.input == std::vector<jaus::supported_message>{{0x0405, 7}});
}

TEST_CASE("a message that the node manager does not know is told in the log") {
    simulated_pair p;
    REQUIRE(p.ocu.node.send({.command_code = 0xD111, .destination = make(2, 1), .source = p.ocu.self},
                            std::span<const std::byte>{}, p.network.now));
    p.network.run(p.network.now + 1s);
    CHECK(p.robot.logged("at 2.1.1.1: unknown message"));
}

TEST_CASE("a node without sockets reports refusals of its gate") {
    simulated_pair p;
    std::array<std::byte, 64> message{};
    const auto made =
        jaus::make_message({.destination = p.robot.self, .source = make(7, 1)}, jaus::shutdown{}, message);
    REQUIRE(made);
    const std::span<const std::byte> datagram{message.data(), made->size()};
    REQUIRE(p.robot.node.on_datagram(datagram, p.ocu.at, jaus::framing::bare, false, p.network.now) ==
            net::verdict::unknown_peer);
    REQUIRE(p.robot.node.on_datagram(datagram.first(3), p.ocu.at, jaus::framing::bare, false, p.network.now) ==
            net::verdict::malformed);
    REQUIRE(p.robot.log.size() == 2);
    REQUIRE(p.robot.logged("could be answered: truncated: shorter than the 16-byte JAUS header"));
    REQUIRE(p.robot.core.state() == jaus::primary_status_code::ready);
}

TEST_CASE("an unroutable message to a group is logged unless it is for another subsystem") {
    simulated_pair p;
    const auto arrives = [&](const jaus::address& to) {
        std::array<std::byte, 64> message{};
        const auto made = jaus::make_message({.destination = to, .source = p.ocu.self}, jaus::standby{}, message);
        REQUIRE(made);
        REQUIRE(p.robot.node.on_datagram(*made, p.ocu.at, {}, true, p.network.now) == net::verdict::accepted);
    };
    arrives(make(3, 1, 33));
    CHECK(p.robot.log.empty());
    arrives(make(2, 1, 77));
    CHECK(p.robot.logged("unroutable: this node has no such component"));
    arrives(make(255, 255, 0)); // to all subsystems
    CHECK(p.robot.logged("unroutable: an octet of the destination ID is 0"));
}

TEST_CASE("the log names field and byte of a body that does not decode, if configured") {
    simulated_network network;
    const auto systems = system("ocu", "1.0.0.0", 1001) + system("robot", "2.0.0.0", 1002);
    simulated_program ocu{network, config("ocu", systems), make(1, 1, 32)};
    simulated_program robot{
        network, config("robot", systems), make(2, 1, 33), {.explain_malformed = [](std::uint16_t code, auto body) {
            return jauscat::text::why_malformed(code, body, jaus::message_list<jaus::set_component_authority>{});
        }}};
    REQUIRE(ocu.node.send({.command_code = 0x0001, .destination = robot.self, .source = ocu.self},
                          std::span<const std::byte>{}, network.now));
    REQUIRE(network.run(network.now + 1s, [&] { return !robot.log.empty(); }));
    REQUIRE(robot.logged("malformed: the body does not decode: truncated"));
    REQUIRE(robot.logged("authority_code at byte 0 needs 1 bytes, 0 left"));
}

// A program that was suspended finds the packets of several data sets in its socket, and takes them in one instant.
TEST_CASE("a packet of a large data set that waited for long does not become part of the next one") {
    simulated_pair p;
    const jaus::header head{.command_code = 0xD111, .destination = p.robot.self, .source = p.ocu.self};
    const auto arrives = [&](jaus::data_flag flag, std::uint16_t number, std::byte content, nanoseconds waited) {
        auto of = head;
        of.data_flag = flag;
        of.sequence_number = number;
        std::array<std::byte, 64> packet{};
        const auto made = jaus::join(of, std::array{content, content}, packet);
        REQUIRE(p.robot.node.on_datagram(*made, p.ocu.at, {}, false, p.network.now, waited) == net::verdict::accepted);
    };
    using enum jaus::data_flag;
    // Of the first one the end was lost, of the second one the begin.
    arrives(first, 0, std::byte{1}, 700ms);
    arrives(last, 1, std::byte{2}, 0ms);
    REQUIRE(p.robot.large.empty());
    REQUIRE(p.robot.logged("waited in the socket for 700 ms"));
    arrives(first, 0, std::byte{1}, 130ms); // longer than a pause between two packets
    REQUIRE(p.robot.logged("waited in the socket for 130 ms"));
    // What lay there for a moment is taken, as far from the one before as it came.
    p.network.now += 5s;
    arrives(first, 0, std::byte{3}, 0ms);
    p.network.now += 200ms;
    arrives(last, 1, std::byte{3}, 100ms);
    REQUIRE(p.robot.large == std::vector<bytes>{bytes(4, std::byte{3})});
}

TEST_CASE("a large data set that is not whole is dropped, with the reason in the log") {
    simulated_pair p;
    jaus::header head{
        .service_connection = true, .command_code = 0x4805, .destination = p.robot.self, .source = p.ocu.self};
    const auto arrives = [&](jaus::data_flag flag, std::uint16_t number) {
        head.data_flag = flag;
        head.sequence_number = number;
        std::array<std::byte, 64> packet{};
        const auto made = jaus::join(head, std::array{std::byte{1}, std::byte{2}}, packet);
        REQUIRE(p.robot.node.on_datagram(*made, p.ocu.at, {}, false, p.network.now, {}) == net::verdict::accepted);
    };
    const auto is_dropped = [&] {
        return p.network.run(p.network.now + 10s, [&] { return p.robot.logged("is dropped after 2 packets"); });
    };
    SECTION("its numbers do not begin at 0") {
        arrives(jaus::data_flag::first, 17);
        arrives(jaus::data_flag::last, 18);
        REQUIRE(is_dropped());
        CHECK(p.robot.logged("its packet 0 has not come, the first was 17; a set is numbered from 0"));
    }
    SECTION("packets before its last one are missing") {
        arrives(jaus::data_flag::first, 0);
        arrives(jaus::data_flag::last, 4);
        REQUIRE(is_dropped());
        CHECK(p.robot.logged(": 3 of it have not come"));
    }
    SECTION("its last packet is missing") {
        arrives(jaus::data_flag::first, 0);
        arrives(jaus::data_flag::middle, 1);
        REQUIRE(is_dropped());
        CHECK(p.robot.logged("its last packet has not come, or another set follows"));
    }
    CHECK(p.robot.large.empty());
}
