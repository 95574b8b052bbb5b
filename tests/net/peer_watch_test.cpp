// Loss of peers that no node manager reports, in simulated time.
#include "net/simulated_program.hpp"
#include "support/instant.hpp"
#include <jauscat/net/node/detail/peer_watch.hpp>
#include <jauscat/schema/jaus/event.hpp>

using namespace net_test;
using support::instant;

namespace {

/// An operator, and a node in two programs, of which the second has no node manager.
struct node_in_two_programs {
    simulated_network network{};
    std::string systems =
        system("operator", "1.0.0.0", 1001) + system("first", "2.1.0.0", 1002) + system("second", "2.1.33.0", 1003);
    simulated_program ocu{network, config("operator", systems), make(1, 1, 32)};
    simulated_program first{network, config("first", systems), make(2, 1, 40)};
    simulated_program second{network, config("second", systems), make(2, 1, 33)};

    bool run_for(std::chrono::nanoseconds time, const std::function<bool()>& done = [] { return false; }) {
        return network.run(network.now + time, done);
    }
    void connect() {
        REQUIRE(ocu.node.send({.destination = second.self, .source = ocu.self},
                              jaus::create_service_connection{jaus::command_code_of<jaus::report_wrench_effort>, 10, 0},
                              network.now));
        REQUIRE(run_for(1s, [&] { return second.connections.next_event().has_value(); }));
    }
};

} // namespace

TEST_CASE("a program without a node manager detects the loss of its controller and its service consumer") {
    node_in_two_programs p;
    p.connect();
    p.ocu.other.ask(9, p.network.now, p.ocu.node.out(p.network.now));
    REQUIRE(p.run_for(1s, [&] { return p.second.core.control().controls(p.ocu.self); }));

    p.run_for(1min);
    REQUIRE(p.second.core.control().controls(p.ocu.self));
    p.network.detach(p.ocu.at);
    const auto gone_at = p.network.now;
    REQUIRE(p.run_for(10s, [&] { return !p.second.core.control().controller(); }));
    REQUIRE(p.network.now - gone_at <= 500ms);
    REQUIRE(p.run_for(10s, [&] { return !p.second.connections.next_event(); }));
    REQUIRE(p.network.now - gone_at <= 3s);
    REQUIRE(p.second.logged("1.1.32.1 does not answer any more"));
}

TEST_CASE("events of the core reports end with the loss of their consumer") {
    node_in_two_programs p;
    unsigned events = 0;
    p.second.on_sent = [&](std::span<const std::byte> message) {
        events += jaus::split(message).header.command_code == jaus::command_code_of<jaus::event>;
    };
    REQUIRE(p.ocu.node.send({.destination = p.second.self, .source = p.ocu.self},
                            jaus::create_event{.message_code = jaus::command_code_of<jaus::report_component_status>,
                                               .event_type = jaus::event_type::periodic,
                                               .requested_periodic_rate = 20.0},
                            p.network.now));
    p.run_for(10s);
    CHECK(events >= 190);
    p.network.detach(p.ocu.at);
    p.run_for(3s);
    events = 0;
    p.run_for(1s);
    CHECK(events == 0);
}

TEST_CASE("a peer that only receives stays while it answers, and its answers have no side effects") {
    node_in_two_programs p;
    p.connect();
    p.network.faults = {.lose = 10};
    p.run_for(10min);
    REQUIRE(p.second.connections.next_event());
    REQUIRE(p.second.log.empty());

    // A pulse that the component itself has asked for is its own.
    p.network.faults = {};
    REQUIRE(p.second.node.send({.destination = p.ocu.self, .source = p.second.self}, jaus::query_heartbeat_pulse{},
                               p.network.now));
    p.run_for(100us + 100us);
    REQUIRE(p.second.logged("Report Heartbeat Pulse (0x4202) 1.1.32.1 -> 2.1.33.1: at 2.1.33.1: unknown message"));
}

TEST_CASE("a peer that the program itself reports as lost is not watched any more") {
    node_in_two_programs p;
    p.connect();
    p.second.node.lose(p.ocu.self, p.network.now);
    CHECK_FALSE(p.second.connections.next_event());
    p.network.detach(p.ocu.at);
    p.run_for(10s);
    CHECK_FALSE(p.second.logged("1.1.32.1 does not answer any more"));
}

TEST_CASE("loss of a peer whose node has no node manager is detected, also by a program with one") {
    simulated_network network{};
    const auto systems = system("operator", "1.1.32.0", 1001) + system("robot", "2.0.0.0", 1002);
    simulated_program ocu{network, config("operator", systems), make(1, 1, 32)};
    simulated_program robot{network, config("robot", systems), make(2, 1, 33)};
    ocu.other.ask(9, network.now, ocu.node.out(network.now));
    REQUIRE(network.run(network.now + 1s, [&] { return robot.core.control().controls(ocu.self); }));
    network.run(network.now + 1min);
    REQUIRE(robot.core.control().controls(ocu.self));
    network.detach(ocu.at);
    const auto gone_at = network.now;
    REQUIRE(network.run(network.now + 10s, [&] { return !robot.core.control().controller(); }));
    REQUIRE(network.now - gone_at <= 3s);
}

TEST_CASE("a flood of peers that bind a component occupies a bounded number of places") {
    net::detail::peer_watch watch{3s};
    const auto self = make(2, 1, 33);
    for (unsigned node = 1; node != 255; ++node)
        for (unsigned component = 1; component != 255; ++component)
            static_cast<void>(watch.bind(make(9, node, component), self, instant{0s}));
    std::size_t asked = 0, lost = 0;
    const auto none_known = [](const jaus::address&) { return false; };
    const auto count_lost = [&](const jaus::address&) { ++lost; };
    watch.on_time(instant{1s}, none_known, [&](std::span<const std::byte>) { ++asked; }, count_lost);
    REQUIRE(asked == net::detail::peer_watch::most);
    watch.on_time(instant{3s}, none_known, [](std::span<const std::byte>) {}, count_lost);
    REQUIRE(lost == net::detail::peer_watch::most);
    REQUIRE_FALSE(watch.next_event());
}

TEST_CASE("what a component has requested or moved ends with it, although its node and node manager live") {
    simulated_network network{};
    const auto systems =
        system("manager", "1.1.0.0", 1001) + system("operator", "1.1.32.0", 1003) + system("robot", "2.0.0.0", 1002);
    simulated_program manager{network, config("manager", systems), make(1, 1, 40)};
    simulated_program ocu{network, config("operator", systems), make(1, 1, 32)};
    simulated_program robot{network, config("robot", systems), make(2, 1, 33)};
    REQUIRE(network.run(network.now + 10s, [&] { return !robot.appeared.empty(); }));
    REQUIRE(ocu.node.send({.destination = robot.self, .source = ocu.self},
                          jaus::create_service_connection{jaus::command_code_of<jaus::report_wrench_effort>, 10, 0},
                          network.now));
    REQUIRE(network.run(network.now + 1s, [&] { return robot.connections.next_event().has_value(); }));
    network.run(network.now + 1min, [] { return false; });
    REQUIRE(robot.connections.next_event());
    network.detach(ocu.at);
    const auto gone_at = network.now;
    REQUIRE(network.run(network.now + 10s, [&] { return !robot.connections.next_event(); }));
    REQUIRE(network.now - gone_at <= 3s);
    REQUIRE(robot.logged("1.1.32.1 does not answer any more"));
    REQUIRE(robot.disappeared.empty());
}

TEST_CASE("a heartbeat query is no sign of life of the component that it names") {
    net::detail::peer_watch watch{3s};
    const auto self = make(2, 1, 33), peer = make(1, 1, 32);
    const auto hear = [&](std::uint16_t code, instant now) {
        return watch.heard({.command_code = code, .destination = self, .source = peer}, now);
    };
    unsigned asked = 0, lost = 0;
    const auto wait = [&](instant now) {
        watch.on_time(
            now, [](const jaus::address&) { return false; }, [&](std::span<const std::byte>) { ++asked; },
            [&](const jaus::address&) { ++lost; });
    };
    REQUIRE(watch.bind(peer, self, instant{0s}));
    wait(instant{1s});
    REQUIRE(asked == 1);
    CHECK(hear(0x4202, instant{1500ms})); // the answer
    wait(instant{2500ms});
    REQUIRE(asked == 2);
    CHECK_FALSE(hear(0x2202, instant{4s}));
    wait(instant{4499ms});
    CHECK(lost == 0);
    wait(instant{4500ms});
    CHECK(lost == 1);
}

TEST_CASE("a heartbeat for another component is not the answer to a query of the watch") {
    net::detail::peer_watch watch{3s};
    const auto self = make(2, 1, 33), other = make(2, 1, 34), peer = make(1, 1, 32);
    REQUIRE(watch.bind(peer, self, instant{0s}));
    unsigned asked = 0;
    watch.on_time(
        instant{1s}, [](const jaus::address&) { return false; }, [&](std::span<const std::byte>) { ++asked; },
        [](const jaus::address&) {});
    REQUIRE(asked == 1);
    const auto hear = [&](const jaus::address& to) {
        return watch.heard({.command_code = 0x4202, .destination = to, .source = peer}, instant{1500ms});
    };
    CHECK_FALSE(hear(other));
    CHECK(hear(self));
    CHECK_FALSE(hear(self));
}

TEST_CASE("a peer whose heartbeats the node manager receives is neither queried nor lost") {
    net::detail::peer_watch watch{3s};
    REQUIRE(watch.bind(make(1, 1, 32), make(2, 1, 33), instant{0s}));
    unsigned asked = 0, lost = 0;
    for (auto now = 500ms; now != 10s; now += 500ms)
        watch.on_time(
            instant{now}, [](const jaus::address&) { return true; }, [&](std::span<const std::byte>) { ++asked; },
            [&](const jaus::address&) { ++lost; });
    CHECK(asked == 0);
    CHECK(lost == 0);
    CHECK(watch.next_event());
}

TEST_CASE("a peer with very many components leaves places to be watched to others") {
    net::detail::peer_watch watch{3s};
    const auto self = make(2, 1, 33);
    std::size_t watched = 0;
    for (unsigned component = 1; component != 255; ++component)
        for (unsigned instance = 1; instance != 255; ++instance) {
            auto peer = make(9, 1, component);
            peer.instance = static_cast<std::uint8_t>(instance);
            watched += watch.bind(peer, self, instant{0s});
        }
    CHECK(watched == net::detail::peer_watch::most * 3 / 4);
    CHECK(watch.bind(make(9, 1, 1), self, instant{0s})); // it is watched already
    CHECK(watch.bind(make(9, 2, 1), self, instant{0s}));
}

TEST_CASE("a handler that is told of a lost peer may report another one as lost") {
    node_in_two_programs p;
    p.connect();
    const jaus::create_service_connection request{jaus::command_code_of<jaus::report_wrench_effort>, 10, 0};
    REQUIRE(p.first.node.send({.destination = p.second.self, .source = p.first.self}, request, p.network.now));
    p.run_for(10ms);
    unsigned lines = 0;
    p.second.on_log = [&](std::string_view line) {
        if (line.find("does not answer any more") == line.npos) return;
        ++lines;
        p.second.node.lose(p.first.self, p.network.now); // by the application, which knows that both are gone
    };
    p.network.detach(p.ocu.at);
    p.network.detach(p.first.at);
    p.run_for(10s);
    CHECK(lines == 1);
    CHECK_FALSE(p.second.connections.next_event());
}
