// No peer takes the places of all others, however many components it says it has.
#include "jaus/messages.hpp"
#include "support/instant.hpp"
#include <jauscat/jaus/events/events.hpp>
#include <jauscat/jaus/events/service_connections.hpp>
#include <jauscat/jaus/large_data/reassembler.hpp>
#include <jauscat/jaus/routing/liveness_table.hpp>
#include <jauscat/schema/jaus/platform.hpp>

#include <array>
#include <optional>
#include <vector>

namespace {

using namespace std::chrono_literals;
using jauscat::jaus::message_outcome;
using jauscat::test::message;
using support::instant;
namespace jaus = jauscat::jaus;

constexpr std::uint16_t velocity = jaus::command_code_of<jaus::report_velocity_state>;
constexpr jaus::address sensor{1, 42, 1, 2};
constexpr jaus::address of(std::uint8_t subsystem, std::uint8_t node, std::uint8_t component) {
    return {1, component, node, subsystem};
}

/// How many of 8 places the 8 components of node 1.1 have got, and whether one of node 1.2 gets one then.
struct taken {
    int by_first{};
    bool by_second{};
    friend bool operator==(const taken&, const taken&) = default;
};
taken ask_for_all(auto ask) {
    taken all{};
    for (std::uint8_t i = 1; i != 9; ++i) all.by_first += ask(of(1, 1, i));
    all.by_second = ask(of(1, 2, 1));
    return all;
}

bool handles(auto& part, const auto& request, const jaus::address& from, jauscat::test::sent_messages& sent) {
    const auto whole = message({.destination = sensor, .source = from}, request);
    const auto m = jaus::split(whole);
    REQUIRE(m);
    return part.on_message(m.header, m.body, instant{0s}, sent.sink()) == message_outcome::handled;
}

} // namespace

TEST_CASE("a peer's share is three quarters of the places, and of few places all") {
    STATIC_REQUIRE(jaus::peer_share(1) == 1);
    STATIC_REQUIRE(jaus::peer_share(3) == 3);
    STATIC_REQUIRE(jaus::peer_share(4) == 3);
    STATIC_REQUIRE(jaus::peer_share(64) == 48);
    STATIC_REQUIRE(jaus::are_of_one_node(of(1, 2, 3), of(1, 2, 4)));
    STATIC_REQUIRE_FALSE(jaus::are_of_one_node(of(1, 2, 3), of(1, 3, 3)));
    STATIC_REQUIRE_FALSE(jaus::are_of_one_node(of(1, 2, 3), of(2, 2, 3)));
}

TEST_CASE("no node takes all places of a component's events, connections and large data sets") {
    jauscat::test::sent_messages sent;
    const auto fill = [](auto...) -> std::optional<std::size_t> { return 0; };
    std::array<std::byte, 2048> memory{};
    SECTION("events") {
        constexpr std::array reports{jaus::eventful_report{velocity, &jaus::read_field<jaus::report_velocity_state>}};
        jaus::events<8> events{sensor, reports, fill, memory};
        std::uint8_t number = 0;
        const auto ask = [&](const jaus::address& who) {
            return handles(events,
                           jaus::create_event{.local_request_id = ++number,
                                              .message_code = velocity,
                                              .event_type = jaus::event_type::every_change},
                           who, sent);
        };
        CHECK(ask_for_all(ask) == taken{6, true});
        CHECK(ask(of(1, 3, 1)));
        CHECK_FALSE(ask(of(1, 4, 1))); // all are taken
    }
    SECTION("connections") {
        const std::array reports{jaus::connectable_report{.command_code = velocity}};
        jaus::service_connections<8> connections{sensor, reports, fill, memory};
        const auto ask = [&](const jaus::address& who) {
            return handles(connections, jaus::create_service_connection{velocity, 10, 0}, who, sent);
        };
        CHECK(ask_for_all(ask) == taken{6, true});
        CHECK(ask(of(1, 1, 1))); // the one that it has
    }
    SECTION("large data sets") {
        std::array<jaus::partial_data_set, 8> places{};
        std::array<jaus::held_packet, 32> packets{};
        jaus::reassembler sets{places, packets, memory, 1s};
        const auto packet = [&](const jaus::address& who, jaus::data_flag flag, std::uint16_t number) {
            const jaus::header head{
                .command_code = 0x4807, .source = who, .data_size = 1, .data_flag = flag, .sequence_number = number};
            const std::array body{std::byte{1}};
            return sets.on_packet(head, body, instant{0s}, [](auto&, auto) {}, [](auto&) {});
        };
        const auto ask = [&](const jaus::address& who) {
            return packet(who, jaus::data_flag::first, 0) == jaus::reassembled::waiting &&
                   packet(who, jaus::data_flag::middle, 1) == jaus::reassembled::waiting;
        };
        CHECK(ask_for_all(ask) == taken{6, true});
    }
}

TEST_CASE("no subsystem takes all places of the components that are alive, and what it has had is free again") {
    std::vector<jaus::liveness_table::place> places(16);
    jaus::liveness_table table{places};
    REQUIRE(table.capacity() == 12);
    const auto hear = [&](const jaus::address& who, instant at = 0s) {
        return table.on_heard(who, at, 1s) != jaus::heard::no_capacity;
    };
    int heard = 0;
    for (std::uint8_t i = 1; i != 20; ++i) heard += hear(of(1, i, 1));
    CHECK(heard == 9);
    CHECK(hear(of(1, 1, 1)));
    CHECK(hear(of(2, 1, 1)));
    int gone = 0;
    table.on_time(instant{1s}, [&](const jaus::address&) { ++gone; });
    CHECK(gone == 10);
    heard = 0;
    for (std::uint8_t i = 20; i != 40; ++i) heard += hear(of(1, i, 1), 2s);
    CHECK(heard == 9);
}
