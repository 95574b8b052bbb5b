// Service connections: the two sides by themselves with literal messages, and together on a network that loses some.
#include "jaus/messages.hpp"
#include "support/hex.hpp"
#include "support/instant.hpp"
#include <jauscat/jaus/events/service_connections.hpp>
#include <jauscat/jaus/events/service_consumer.hpp>

#include <algorithm>
#include <random>

namespace {

using namespace std::chrono_literals;
using jauscat::jaus::consumed_state;
using jauscat::jaus::consumer_notice;
using jauscat::jaus::message_outcome;
using jauscat::test::bytes;
using jauscat::test::from_hex;
using jauscat::test::to_hex;
using support::instant;
using response = jauscat::jaus::service_connection_response;
using jauscat::time_point;
namespace jaus = jauscat::jaus;

constexpr jaus::address sensor{1, 38, 1, 2}, viewer{1, 40, 1, 1}, other{2, 40, 1, 1};
constexpr std::uint16_t pose = 0x4402, velocity = 0x4404;

/// A provider of two reports, and what it sends.
struct provider {
    std::array<jaus::connectable_report, 2> reports{
        {{.command_code = pose, .min_rate = 1, .max_rate = 50, .presence_vector = 0x1FF}, {.command_code = velocity}}};
    std::optional<std::size_t> size{2};
    std::optional<std::size_t> operator()(std::uint16_t code, std::uint32_t fields, std::span<std::byte> body) {
        if (size && *size <= body.size()) std::ranges::fill(body.first(*size), static_cast<std::byte>(code + fields));
        return size;
    }
    std::array<std::byte, jaus::header_size + 100> memory{};
    jaus::service_connections<3> connections{sensor, reports, *this, memory};
    jauscat::test::sent_messages sent{};

    template <class Message> message_outcome hear(const jaus::address& from, const Message& body, instant now = 0s) {
        return hear(jauscat::test::message({.destination = sensor, .source = from}, body), now);
    }
    message_outcome hear(const bytes& message, instant now = 0s) {
        const auto m = jaus::split(message);
        REQUIRE(m);
        return connections.on_message(m.header, m.body, now, sent.sink());
    }
    response ask(const jaus::address& from, std::uint16_t code, double rate, std::uint32_t fields = 0,
                 instant now = 0s) {
        const auto outcome = hear(from, jaus::create_service_connection{code, rate, fields}, now);
        const auto confirmed = sent.body<jaus::confirm_service_connection>(sent.size() - 1);
        REQUIRE(confirmed.command_code == code);
        REQUIRE(sent.header(sent.size() - 1).destination == from);
        REQUIRE((confirmed.response_code == response::connection_created) == (outcome == message_outcome::handled));
        REQUIRE((confirmed.confirmed_periodic_update_rate == 0) == (outcome == message_outcome::refused));
        return confirmed.response_code;
    }
    double confirmed_rate() { return sent.body<jaus::confirm_service_connection>(0).confirmed_periodic_update_rate; }
};

/// Runs the provider's due reports until `end` and counts them.
std::size_t run(provider& p, instant end) {
    p.sent.clear();
    while (p.connections.next_event() && *p.connections.next_event() <= end)
        p.connections.on_time(*p.connections.next_event(), p.sent.sink());
    return p.sent.size();
}

} // namespace

TEST_CASE("a connection is confirmed, and its reports have the flag and the count") {
    provider p;
    // Report Global Pose at 10 Hz (0258h steps), fields 0000000Fh.
    REQUIRE(p.hear(from_hex("06 02 08 00 01 26 01 02 01 28 01 01 08 00 05 00 02 44 58 02 0f 00 00 00"), 3s) ==
            message_outcome::handled);
    REQUIRE(p.sent.size() == 1);
    REQUIRE(to_hex(p.sent[0]) == "06 02 09 00 01 28 01 01 01 26 01 02 06 00 05 00 02 44 00 58 02 00");
    REQUIRE(p.connections.next_event() == instant{3s});

    p.sent.clear();
    p.connections.on_time(instant{3s - 1ns}, p.sent.sink());
    REQUIRE(p.sent.empty());
    p.connections.on_time(instant{3s}, p.sent.sink());
    p.connections.on_time(instant{3s}, p.sent.sink());
    REQUIRE(p.sent.size() == 1);
    REQUIRE(to_hex(p.sent[0]) == "46 02 02 44 01 28 01 01 01 26 01 02 02 00 00 00 11 11");
    p.connections.on_time(instant{4s}, p.sent.sink());
    REQUIRE(to_hex(p.sent[1]) == "46 02 02 44 01 28 01 01 01 26 01 02 02 00 01 00 11 11");
}

TEST_CASE("suspend, activate and terminate have their effects") {
    provider p;
    p.ask(viewer, pose, 10);
    const auto suspend = from_hex("06 02 0b 00 01 26 01 02 01 28 01 01 03 00 00 00 02 44 00");
    const auto activate = from_hex("06 02 0a 00 01 26 01 02 01 28 01 01 03 00 00 00 02 44 00");
    const auto terminate = from_hex("06 02 0c 00 01 26 01 02 01 28 01 01 03 00 00 00 02 44 00");
    REQUIRE(run(p, 1s) == 10);
    REQUIRE(p.hear(suspend, 1s) == message_outcome::handled);
    REQUIRE(p.connections.next_event() == std::nullopt);
    REQUIRE(run(p, 5s) == 0);
    REQUIRE(p.hear(activate, 5s) == message_outcome::handled);
    REQUIRE(p.connections.next_event() == instant{5s});
    REQUIRE(p.hear(activate, 5050ms) == message_outcome::handled);
    REQUIRE(p.connections.next_event() == instant{5s}); // a repeat changes nothing
    REQUIRE(run(p, 6s) == 10);
    REQUIRE(p.sent.header(0).sequence_number == 10);
    REQUIRE(p.hear(terminate) == message_outcome::handled);
    REQUIRE(run(p, 100s) == 0);
    REQUIRE(p.hear(activate) == message_outcome::refused);
    REQUIRE(p.hear(terminate) == message_outcome::refused);
    REQUIRE(p.sent.empty());
}

TEST_CASE("the confirmed rate is one that can be kept") {
    struct row {
        std::uint16_t code;
        double asked, lowest, highest;
    };
    for (const row& r : {row{pose, 10, 9.99, 10.01}, row{pose, 1000, 49.98, 50}, row{pose, 0.1, 0.99, 1.01},
                         row{velocity, 1092, 1092, 1092}, row{velocity, 0.017, 0.016, 0.018}}) {
        provider p;
        REQUIRE(p.ask(viewer, r.code, r.asked) == response::connection_created);
        REQUIRE(p.confirmed_rate() >= r.lowest);
        REQUIRE(p.confirmed_rate() <= r.highest);
        REQUIRE(p.connections.connections()[0].rate == p.confirmed_rate());
    }
}

TEST_CASE("a connection has the requested fields that its report has") {
    provider p;
    REQUIRE(p.ask(viewer, pose, 10, 0xFFFF0201) == response::connection_created);
    REQUIRE(p.connections.connections()[0].presence_vector == 1);
}

TEST_CASE("an impossible connection is answered with the reason") {
    provider p;
    REQUIRE(p.ask(viewer, 0x4403, 10) == response::command_not_supported);
    REQUIRE(p.ask(viewer, pose, 0) == response::invalid_service_connection_parameters);
    REQUIRE(p.ask(viewer, pose, 10, 0x1FF) == response::connection_created);
    REQUIRE(p.ask(viewer, velocity, 10, 0xFFFFFFFF) == response::connection_created);
    REQUIRE(p.ask(other, pose, 10) == response::connection_created);
    REQUIRE(p.ask(other, velocity, 10) == response::connection_refused);
    REQUIRE(p.connections.on_lost(viewer) == 2);
    REQUIRE(p.ask(other, velocity, 10) == response::connection_created);
    REQUIRE(p.connections.on_lost({255, 255, 2, 1}) == 0);
    REQUIRE(p.connections.on_lost({255, 255, other.node, other.subsystem}) == 2);

    std::array<std::byte, 100> memory{};
    jaus::service_connections<1> none{sensor, {}, p, memory};
    jauscat::test::sent_messages sent;
    const auto body = from_hex("02 44 58 02 00 00 00 00");
    REQUIRE(none.on_message({.command_code = 8, .source = viewer}, body, instant{0s}, sent.sink()) ==
            message_outcome::refused);
    REQUIRE(sent.body<jaus::confirm_service_connection>(0).response_code ==
            response::component_does_not_support_service_connections);
}

TEST_CASE("a judge function refuses connections with its own reason") {
    provider p;
    const auto policy = [](const jaus::header& head, const jaus::create_service_connection& request) {
        REQUIRE(request.command_code == pose);
        return head.source == viewer ? response::connection_created : response::insufficient_authority;
    };
    p.connections = {sensor, p.reports, p, p.memory, policy};
    REQUIRE(p.ask(other, pose, 10) == response::insufficient_authority);
    REQUIRE(p.ask(viewer, pose, 10) == response::connection_created);
    REQUIRE(p.connections.connections()[0].consumer == viewer);
    REQUIRE(p.connections.connections()[1].command_code == 0);
}

TEST_CASE("a repeated request changes the connection and creates no second one") {
    provider p;
    p.ask(viewer, pose, 10);
    REQUIRE(run(p, 990ms) == 10);
    const auto due = p.connections.next_event();
    REQUIRE(p.ask(viewer, pose, 10, 0, 995ms) == response::connection_created);
    REQUIRE(p.connections.next_event() == due);
    REQUIRE(p.ask(viewer, pose, 20, 3, 996ms) == response::connection_created);
    REQUIRE(p.connections.next_event() == instant{996ms});
    run(p, 996ms);
    REQUIRE(p.sent.header(0).sequence_number == 10);
    REQUIRE(std::ranges::count(p.connections.connections(), pose, &jaus::service_connection::command_code) == 1);
}

TEST_CASE("only its consumer can change a connection") {
    provider p;
    p.ask(viewer, pose, 10);
    REQUIRE(p.hear(other, jaus::terminate_service_connection{pose, 0}) == message_outcome::refused);
    REQUIRE(p.hear(other, jaus::suspend_service_connection{pose, 0}) == message_outcome::refused);
    REQUIRE(p.hear(viewer, jaus::suspend_service_connection{velocity, 0}) == message_outcome::refused);
    REQUIRE(p.hear(viewer, jaus::suspend_service_connection{pose, 1}) == message_outcome::refused);
    REQUIRE(p.hear(viewer, jaus::suspend_service_connection{pose, 255}) == message_outcome::refused);
    REQUIRE(p.hear(viewer, jaus::suspend_service_connection{0, 1}) == message_outcome::refused);
    REQUIRE(p.connections.connections()[0].active);
    REQUIRE(p.connections.connections()[1].consumer == jaus::address{});
}

TEST_CASE("malformed and foreign messages change nothing") {
    provider p;
    const std::array<std::byte, 9> junk{};
    for (const std::uint16_t code : {std::uint16_t{8}, std::uint16_t{10}, std::uint16_t{11}, std::uint16_t{12}})
        for (const std::size_t size : {0u, 2u, 7u, 9u}) {
            const jaus::header head{.command_code = code, .source = viewer};
            REQUIRE(p.connections.on_message(head, std::span{junk}.first(size), instant{0s}, p.sent.sink()) ==
                    message_outcome::malformed);
        }
    REQUIRE(p.connections.on_message({.command_code = 0x0009}, std::span{junk}.first(6), instant{0s}, p.sent.sink()) ==
            message_outcome::unhandled);
    REQUIRE(p.connections.on_message({.ack_nak = jaus::ack_nak::ack, .command_code = 8}, {}, instant{0s},
                                     p.sent.sink()) == message_outcome::unhandled);
    REQUIRE(p.sent.empty());
    REQUIRE(p.connections.next_event() == std::nullopt);
}

TEST_CASE("reports do not drift, and a late one is sent once") {
    provider p;
    p.ask(viewer, pose, 10, 0, 0s);
    const auto period = jaus::period_of(p.confirmed_rate());
    REQUIRE(period > 99ms);
    REQUIRE(period < 101ms);
    // Always served 3 ms late.
    p.sent.clear();
    for (int i = 0; i != 100000; ++i) {
        REQUIRE(p.connections.next_event() == instant{i * period});
        p.connections.on_time(instant{i * period + 3ms}, p.sent.sink());
    }
    REQUIRE(p.sent.size() == 100000);
    REQUIRE(p.sent.header(99999).sequence_number == 99999 - 65536);
    // An hour late: one report, and the instants stay where they were.
    p.sent.clear();
    p.connections.on_time(instant{100000 * period + 36000 * period + 1ms}, p.sent.sink());
    REQUIRE(p.sent.size() == 1);
    REQUIRE(p.connections.next_event() == instant{136001 * period});
}

TEST_CASE("a report that cannot be made is skipped and not counted as sent") {
    provider p;
    p.ask(viewer, pose, 10);
    run(p, 0s);
    p.size = std::nullopt;
    REQUIRE(run(p, 990ms) == 0);
    REQUIRE(p.connections.skipped() == 9);
    p.size = 101;
    REQUIRE(run(p, 1100ms) == 0);
    REQUIRE(p.connections.skipped() == 10);
    p.size = 100;
    REQUIRE(run(p, 1200ms) == 1);
    REQUIRE(p.sent.header(0).sequence_number == 1);
    REQUIRE(p.sent[0].size() == 116);
    REQUIRE(p.connections.skipped() == 10);
    p.connections.clear();
    REQUIRE(p.connections.next_event() == std::nullopt);
}

namespace {

/// A consumer, what it sends and what it says.
struct consumer {
    std::vector<consumed_state> states{};
    void operator()(const jaus::consumed_connection& c) { states.push_back(c.state); }
    jaus::service_consumer<2> service{viewer, {}, *this};
    jauscat::test::sent_messages sent{};

    jaus::consumer_outcome hear(const bytes& message, instant now) {
        const auto m = jaus::split(message);
        REQUIRE(m);
        return service.on_message(m.header, m.body, now, sent.sink());
    }
    jaus::consumer_outcome report(std::uint16_t number, instant now, std::uint16_t code = pose) {
        const jaus::header head{
            .service_connection = true, .command_code = code, .source = sensor, .sequence_number = number};
        return service.on_message(head, {}, now, sent.sink());
    }
    const jaus::consumed_connection& first() { return service.connections()[0]; }
};
using states = std::vector<consumed_state>;

const auto confirmation = "06 02 09 00 01 28 01 01 01 26 01 02 06 00 05 00 02 44 07 58 02 00";

} // namespace

TEST_CASE(
    "a consumer repeats its request until it is answered, keeps the confirmed rate, and terminates the connection") {
    consumer c;
    REQUIRE(c.service.ask(sensor, pose, 10, 15, instant{0s}, c.sent.sink()) == 0);
    REQUIRE(c.service.next_event() == instant{1s});
    c.service.on_time(instant{1s}, c.sent.sink());
    REQUIRE(c.sent.size() == 2);
    REQUIRE(to_hex(c.sent[0]) == "06 02 08 00 01 26 01 02 01 28 01 01 08 00 00 00 02 44 58 02 0f 00 00 00");
    REQUIRE(c.sent[1] == c.sent[0]);
    REQUIRE(c.hear(from_hex(confirmation), 1100ms) == jaus::consumer_outcome{consumer_notice::confirmed, 0, 0});
    REQUIRE(c.first().instance_id == 7);
    REQUIRE(c.first().rate > 9.99);
    REQUIRE(c.first().rate < 10.01);

    c.sent.clear();
    REQUIRE(c.service.suspend(0, instant{1200ms}, c.sent.sink()));
    REQUIRE_FALSE(c.service.suspend(0, instant{1200ms}, c.sent.sink()));
    REQUIRE(c.service.next_event() == std::nullopt);
    REQUIRE(c.service.activate(0, instant{1300ms}, c.sent.sink()));
    REQUIRE_FALSE(c.service.activate(0, instant{1300ms}, c.sent.sink()));
    c.service.end(0, instant{1400ms}, c.sent.sink());
    REQUIRE(c.sent.size() == 3);
    REQUIRE(to_hex(c.sent[0]) == "06 02 0b 00 01 26 01 02 01 28 01 01 03 00 00 00 02 44 07");
    REQUIRE(to_hex(c.sent[1]) == "06 02 0a 00 01 26 01 02 01 28 01 01 03 00 00 00 02 44 07");
    REQUIRE(to_hex(c.sent[2]) == "06 02 0c 00 01 26 01 02 01 28 01 01 03 00 00 00 02 44 07");
    c.service.on_time(instant{2400ms}, c.sent.sink());
    REQUIRE(c.states == states{consumed_state::asking, consumed_state::active, consumed_state::suspended,
                               consumed_state::active, consumed_state::ending, consumed_state::free});
    REQUIRE(c.service.next_event() == std::nullopt);
}

TEST_CASE("a consumer counts missing reports and drops old ones") {
    consumer c;
    REQUIRE(c.service.ask(sensor, pose, 10, 15, instant{0s}, c.sent.sink()));
    // The first overtakes the confirmation.
    REQUIRE(c.report(65533, 1ms) == jaus::consumer_outcome{consumer_notice::report, 0, 0});
    c.hear(from_hex(confirmation), 2ms);
    REQUIRE(c.report(65534, 3ms) == jaus::consumer_outcome{consumer_notice::report, 0, 0});
    REQUIRE(c.report(65534, 4ms) == jaus::consumer_outcome{consumer_notice::old_report, 0, 0});
    REQUIRE(c.report(2, 5ms) == jaus::consumer_outcome{consumer_notice::report, 0, 3});
    REQUIRE(c.report(0, 6ms) == jaus::consumer_outcome{consumer_notice::old_report, 0, 0});
    REQUIRE(c.report(3, 6ms, velocity).what == consumer_notice::unhandled);
    REQUIRE(c.service.on_message({.command_code = pose, .source = sensor}, {}, instant{7ms}, c.sent.sink()).what ==
            consumer_notice::unhandled);
    REQUIRE(c.first().received == 3);
    REQUIRE(c.first().lost == 3);
    REQUIRE(c.first().dropped == 2);
}

TEST_CASE("a connection without a report for three periods is stale and requested again") {
    consumer c;
    REQUIRE(c.service.ask(sensor, pose, 10, 15, instant{0s}, c.sent.sink()));
    c.hear(from_hex(confirmation), 0s);
    c.report(41, 100ms);
    const auto due = c.service.next_event();
    REQUIRE(due > instant{399ms});
    REQUIRE(due < instant{401ms});
    c.sent.clear();
    c.service.on_time(*due - 1ns, c.sent.sink());
    REQUIRE(c.first().state == consumed_state::active);
    c.service.on_time(*due, c.sent.sink());
    REQUIRE(c.first().state == consumed_state::stale);
    REQUIRE(c.service.next_event() == *due + 1s);
    c.service.on_time(*due + 1s, c.sent.sink());
    REQUIRE(c.first().asked_at == *due + 1s);
    REQUIRE(c.sent.size() == 2);
    REQUIRE(to_hex(c.sent[1]) == "06 02 08 00 01 26 01 02 01 28 01 01 08 00 00 00 02 44 58 02 0f 00 00 00");

    // The provider has started anew, with another instance ID, and counts from 0.
    REQUIRE(c.hear(from_hex("06 02 09 00 01 28 01 01 01 26 01 02 06 00 05 00 02 44 01 58 02 00"), 2s).what ==
            consumer_notice::confirmed);
    REQUIRE(c.report(0, 2s) == jaus::consumer_outcome{consumer_notice::report, 0, 0});
    REQUIRE(c.first().instance_id == 1);
    REQUIRE(c.first().state == consumed_state::active);
}

TEST_CASE("a late copy of a report is dropped after a silence, too, before and after a new confirmation") {
    consumer c;
    REQUIRE(c.service.ask(sensor, pose, 10, 15, instant{0s}, c.sent.sink()));
    c.hear(from_hex(confirmation), 0s);
    for (const std::uint16_t number : {std::uint16_t{40}, std::uint16_t{41}})
        REQUIRE(c.report(number, 100ms).what == consumer_notice::report);
    c.service.on_time(*c.service.next_event(), c.sent.sink());
    REQUIRE(c.first().state == consumed_state::stale);
    REQUIRE(c.report(40, 1s).what == consumer_notice::old_report);
    c.hear(from_hex(confirmation), 2s);
    REQUIRE(c.first().state == consumed_state::active);
    REQUIRE(c.report(40, 2s).what == consumer_notice::old_report);
    REQUIRE(c.report(41, 2s).what == consumer_notice::old_report);
    SECTION("it goes on") { REQUIRE(c.report(42, 2s).what == consumer_notice::report); }
    SECTION("it counts anew, and its first reports were lost") {
        for (std::uint16_t i = 5; i != 12; ++i) REQUIRE(c.report(i, 2s).what == consumer_notice::old_report);
        REQUIRE(c.report(12, 2s).what == consumer_notice::report);
        REQUIRE(c.report(13, 2s).what == consumer_notice::report);
    }
}

TEST_CASE("a connection whose provider counts anew goes on although its first reports were lost") {
    consumer c;
    REQUIRE(c.service.ask(sensor, pose, 10, 15, instant{0s}, c.sent.sink()));
    c.hear(from_hex(confirmation), 0s);
    REQUIRE(c.report(200, 100ms).what == consumer_notice::report);
    // Each request is confirmed at once, and three reports later the connection is stale again.
    auto now = instant{100ms};
    for (std::uint16_t number = 2; number != 9; ++number) {
        now = now + 100ms;
        if (*c.service.next_event() <= now) {
            c.service.on_time(now, c.sent.sink());
            REQUIRE(c.first().state == consumed_state::stale);
            c.hear(from_hex(confirmation), now);
        }
        REQUIRE(c.report(number, now).what == consumer_notice::old_report);
    }
    REQUIRE(c.report(9, now + 50ms).what == consumer_notice::report);
}

TEST_CASE("a late report is not taken for the first one of a provider that counts anew") {
    consumer c;
    REQUIRE(c.service.ask(sensor, pose, 10, 15, instant{0s}, c.sent.sink()));
    c.hear(from_hex(confirmation), 0s);
    for (const unsigned number : {0U, 2U, 3U, 4U})
        REQUIRE(c.report(static_cast<std::uint16_t>(number), 100ms).what == consumer_notice::report);
    c.service.on_time(*c.service.next_event(), c.sent.sink());
    REQUIRE(c.first().state == consumed_state::stale);
    c.hear(from_hex(confirmation), 1s);
    REQUIRE(c.report(1, 1s).what == consumer_notice::old_report);
    REQUIRE(c.report(5, 1s).what == consumer_notice::report);
}

TEST_CASE("a late report of the count before is dropped after the provider has begun to count anew") {
    consumer c;
    REQUIRE(c.service.ask(sensor, pose, 10, 15, instant{0s}, c.sent.sink()));
    c.hear(from_hex(confirmation), 0s);
    REQUIRE(c.report(200, 100ms).what == consumer_notice::report);
    c.service.on_time(*c.service.next_event(), c.sent.sink());
    c.hear(from_hex(confirmation), 1s);
    REQUIRE(c.report(0, 1s).what == consumer_notice::report);
    REQUIRE(c.report(202, 1100ms).what == consumer_notice::old_report);
    REQUIRE(c.report(1, 1100ms) == jaus::consumer_outcome{consumer_notice::report, 0, 0});
    REQUIRE(c.first().dropped == 1);
    SECTION("many reports in a row are none of them") {
        for (std::uint16_t i = 40; i != 71; ++i) REQUIRE(c.report(i, 2s).what == consumer_notice::old_report);
        REQUIRE(c.report(71, 2s).what == consumer_notice::report);
        REQUIRE(c.report(72, 2s).what == consumer_notice::report);
    }
    SECTION("a step of 33 is that of a late report, one of 32 is not") {
        REQUIRE(c.report(34, 1100ms).what == consumer_notice::old_report);
        REQUIRE(c.report(33, 1100ms) == jaus::consumer_outcome{consumer_notice::report, 0, 31});
    }
    SECTION("it does not last") { REQUIRE(c.report(40, 7s) == jaus::consumer_outcome{consumer_notice::report, 0, 38}); }
}

TEST_CASE("a consumer abandons requests that are refused or never answered") {
    consumer c;
    REQUIRE(c.service.ask(sensor, pose, 10, 15, instant{0s}, c.sent.sink()));
    REQUIRE(c.hear(from_hex("06 02 09 00 01 28 01 01 01 26 01 02 06 00 05 00 02 44 00 00 00 04"), 0s).what ==
            consumer_notice::refused);
    REQUIRE(c.first().response == response::connection_refused);
    REQUIRE(c.service.next_event() == std::nullopt);
    REQUIRE(c.report(0, 1s).what == consumer_notice::ignored);

    c.sent.clear();
    REQUIRE(c.service.ask(sensor, velocity, 10, 15, instant{0s}, c.sent.sink()) == 1);
    while (c.service.next_event()) c.service.on_time(*c.service.next_event(), c.sent.sink());
    REQUIRE(c.sent.size() == 5);
    REQUIRE(c.service.connections()[1].state == consumed_state::unanswered);
    // Both places are wanted for others.
    REQUIRE(c.service.ask(other, pose, 10, 15, instant{9s}, c.sent.sink()) == 1);
    REQUIRE(c.service.ask(other, velocity, 10, 15, instant{9s}, c.sent.sink()) == 0);
    REQUIRE(c.service.ask(other, 0x4403, 10, 15, instant{9s}, c.sent.sink()) == std::nullopt);
    REQUIRE(c.service.ask(other, velocity, 0, 15, instant{9s}, c.sent.sink()) == std::nullopt);
    REQUIRE(c.service.ask(other, velocity, 1093, 15, instant{9s}, c.sent.sink()) == std::nullopt);
}

TEST_CASE("a connection with a refused change is terminated, also if that message is lost") {
    const auto refusal = from_hex("06 02 09 00 01 28 01 01 01 26 01 02 06 00 05 00 02 44 00 00 00 04");
    const auto termination = "06 02 0c 00 01 26 01 02 01 28 01 01 03 00 00 00 02 44 07";
    consumer c;
    REQUIRE(c.service.ask(sensor, pose, 10, 15, instant{0s}, c.sent.sink()));
    c.hear(from_hex(confirmation), 0s);
    REQUIRE(c.service.ask(sensor, pose, 20, 15, instant{1s}, c.sent.sink()) == 0);
    c.sent.clear();
    REQUIRE(c.hear(refusal, 1s) == jaus::consumer_outcome{consumer_notice::refused, 0, 0});
    REQUIRE(c.first().state == consumed_state::refused);
    REQUIRE(c.service.next_event() == std::nullopt);
    REQUIRE(c.sent.size() == 1);
    REQUIRE(to_hex(c.sent[0]) == termination);
    REQUIRE(c.report(0, 1500ms).what == consumer_notice::ignored); // was under way
    REQUIRE(c.sent.size() == 1);
    REQUIRE(c.report(1, 2s).what == consumer_notice::ignored);
    REQUIRE(c.sent.size() == 2);
    REQUIRE(to_hex(c.sent[1]) == termination);

    // A change that is ended before there is an answer.
    consumer d;
    REQUIRE(d.service.ask(sensor, pose, 10, 15, instant{0s}, d.sent.sink()));
    d.hear(from_hex(confirmation), 0s);
    REQUIRE(d.service.ask(sensor, pose, 20, 15, instant{1s}, d.sent.sink()) == 0);
    d.sent.clear();
    d.service.end(0, instant{1s}, d.sent.sink());
    REQUIRE(d.sent.size() == 1);
    REQUIRE(to_hex(d.sent[0]) == termination);
}

TEST_CASE("a stale connection that is refused is not requested again") {
    consumer c;
    REQUIRE(c.service.ask(sensor, pose, 10, 15, instant{0s}, c.sent.sink()));
    c.hear(from_hex(confirmation), 0s);
    c.service.on_time(instant{5s}, c.sent.sink());
    REQUIRE(c.first().state == consumed_state::stale);
    REQUIRE(c.hear(from_hex("06 02 09 00 01 28 01 01 01 26 01 02 06 00 05 00 02 44 00 00 00 04"), 6s).what ==
            consumer_notice::refused);
    REQUIRE(c.first().state == consumed_state::refused);
    REQUIRE(c.first().response == response::connection_refused);
    REQUIRE(c.service.next_event() == std::nullopt);
    REQUIRE(c.states ==
            states{consumed_state::asking, consumed_state::active, consumed_state::stale, consumed_state::refused});
}

TEST_CASE("a connection confirmed after it was abandoned is terminated") {
    consumer c;
    REQUIRE(c.service.ask(sensor, pose, 10, 15, instant{0s}, c.sent.sink()));
    while (c.service.next_event()) c.service.on_time(*c.service.next_event(), c.sent.sink());
    REQUIRE(c.first().state == consumed_state::unanswered);
    c.sent.clear();
    REQUIRE(c.hear(from_hex("06 02 09 00 01 28 01 01 01 26 01 02 06 00 05 00 02 44 07 58 02 00"), 10s).what ==
            consumer_notice::ignored);
    REQUIRE(to_hex(c.sent[0]) == "06 02 0c 00 01 26 01 02 01 28 01 01 03 00 00 00 02 44 07");
    REQUIRE(c.first().state == consumed_state::ending);
    c.report(0, 11s); // the provider has not got it
    REQUIRE(c.sent[1] == c.sent[0]);
}

TEST_CASE("a connection that is ended before its confirmation is terminated when that arrives") {
    consumer c;
    REQUIRE(c.service.ask(sensor, pose, 10, 15, instant{0s}, c.sent.sink()));
    c.sent.clear();
    c.service.end(0, instant{100ms}, c.sent.sink());
    REQUIRE(c.sent.empty()); // its instance is not known
    REQUIRE(c.hear(from_hex(confirmation), 200ms).what == consumer_notice::ignored);
    REQUIRE(c.sent.size() == 1);
    REQUIRE(to_hex(c.sent[0]) == "06 02 0c 00 01 26 01 02 01 28 01 01 03 00 00 00 02 44 07");
    REQUIRE(c.first().state == consumed_state::ending);
}

TEST_CASE("a report after a suspension has that message sent again, at most once for each answer timeout") {
    consumer c;
    REQUIRE(c.service.ask(sensor, pose, 10, 15, instant{0s}, c.sent.sink()));
    c.hear(from_hex(confirmation), 0s);
    REQUIRE(c.service.suspend(0, instant{1s}, c.sent.sink()));
    c.sent.clear();
    REQUIRE(c.report(0, 1999ms).what == consumer_notice::ignored);
    REQUIRE(c.sent.empty());
    for (const auto now : {2000ms, 2500ms}) {
        REQUIRE(c.report(1, now).what == consumer_notice::ignored);
        REQUIRE(c.sent.size() == 1);
    }
    REQUIRE(to_hex(c.sent[0]) == "06 02 0b 00 01 26 01 02 01 28 01 01 03 00 00 00 02 44 07");
}

TEST_CASE("a confirmation from another sender or of another report is ignored") {
    consumer c;
    REQUIRE(c.service.ask(sensor, pose, 10, 15, instant{0s}, c.sent.sink()));
    REQUIRE(c.hear(from_hex("06 02 09 00 01 28 01 01 02 26 01 02 06 00 05 00 02 44 07 58 02 00"), 0s).what ==
            consumer_notice::unhandled);
    REQUIRE(c.hear(from_hex("06 02 09 00 01 28 01 01 01 26 01 02 06 00 05 00 04 44 07 58 02 00"), 0s).what ==
            consumer_notice::unhandled);
    REQUIRE(c.hear(from_hex("06 02 09 00 01 28 01 01 01 26 01 02 05 00 05 00 02 44 07 58 02"), 0s).what ==
            consumer_notice::malformed);
    REQUIRE(c.first().state == consumed_state::asking);
    // One that says created, and a rate of 0, promises nothing.
    REQUIRE(c.hear(from_hex("06 02 09 00 01 28 01 01 01 26 01 02 06 00 05 00 02 44 07 00 00 00"), 0s).what ==
            consumer_notice::refused);
}

TEST_CASE("over a network that loses a third of all messages, connections are created, report and end") {
    std::mt19937 random{3};
    for (int round = 0; round != 50; ++round) {
        provider p;
        consumer c;
        c.service = jaus::service_consumer<2>{viewer, {.retry = {.interval = 1s, .attempts = 100}}, c};
        std::vector<std::uint16_t> numbers;
        std::uint64_t lost_by_count = 0;
        const auto exchange = [&](instant now) {
            for (int hop = 0; hop != 4; ++hop) {
                for (const auto& m : c.sent.take())
                    if (random() % 3 != 0) p.hear(m, now);
                for (const auto& m : p.sent.take()) {
                    if (random() % 3 == 0) continue;
                    const auto news = c.hear(m, now);
                    if (news.what != consumer_notice::report) continue;
                    numbers.push_back(jaus::split(m).header.sequence_number);
                    lost_by_count += news.lost;
                }
            }
        };
        REQUIRE(c.service.ask(sensor, pose, 50, 7, instant{0s}, c.sent.sink()));
        bool ended = false;
        int restarts = 0;
        time_point now{};
        for (; now != instant{60s}; now += 1ms) {
            if (now == instant{20s}) { // the provider starts anew and has forgotten all
                p.connections.clear();
                ++restarts;
            }
            if (now == instant{40s}) {
                // Nearly all reports of 40 s were sent: asking takes a few seconds at worst.
                REQUIRE(c.first().confirmed);
                REQUIRE(numbers.size() > 800);
                REQUIRE(numbers.size() < 2000);
                REQUIRE(c.first().received + c.first().lost <= 2002);
                REQUIRE(c.first().received == numbers.size());
                REQUIRE(c.first().lost == lost_by_count);
                c.service.end(0, now, c.sent.sink());
                ended = true;
            }
            if (p.connections.next_event() && *p.connections.next_event() <= now)
                p.connections.on_time(now, p.sent.sink());
            if (c.service.next_event() && *c.service.next_event() <= now) c.service.on_time(now, c.sent.sink());
            exchange(now);
        }
        REQUIRE(ended);
        REQUIRE(restarts == 1);
        REQUIRE(p.connections.next_event() == std::nullopt);
        REQUIRE(c.first().state == consumed_state::free);
    }
}

TEST_CASE("random messages keep both sides of service connections within their bounds") {
    std::mt19937 random{13};
    provider p;
    consumer c;
    std::array<int, 4> outcomes{};
    constexpr std::array<std::uint16_t, 8> codes{8, 9, 10, 11, 12, pose, velocity, 0};
    time_point now{};
    for (int i = 0; i != 100000; ++i) {
        now += std::chrono::milliseconds{random() % 50};
        // Every other body has the size of its message.
        const auto kind = random() % codes.size();
        constexpr std::array<std::size_t, 8> sizes{8, 6, 3, 3, 3, 2, 2, 0};
        bytes body(random() % 2 == 0 ? sizes[kind] : random() % 10);
        for (auto& b : body) b = static_cast<std::byte>(random() % 4 == 0 ? random() : random() % 3);
        // Half of the bodies name a report that there is.
        if (body.size() > 1 && random() % 2 == 0) std::ranges::copy(from_hex("02 44"), body.begin());
        const jaus::header head{.service_connection = random() % 2 == 0,
                                .command_code = codes[kind],
                                .destination = sensor,
                                .source = random() % 2 == 0 ? viewer : sensor,
                                .sequence_number = static_cast<std::uint16_t>(random() % 4)};
        ++outcomes[static_cast<std::size_t>(p.connections.on_message(head, body, now, p.sent.sink()))];
        c.service.on_message(head, body, now, c.sent.sink());
        if (random() % 50 == 0)
            static_cast<void>(c.service.ask(sensor, codes[5 + random() % 2], 1 + static_cast<double>(random() % 100), 1,
                                            now, c.sent.sink()));
        if (random() % 50 == 0) c.service.end(random() % 3, now, c.sent.sink());
        p.connections.on_time(now, p.sent.sink());
        c.service.on_time(now, c.sent.sink());
        if (const auto next = p.connections.next_event()) REQUIRE(*next > now);
        if (const auto next = c.service.next_event()) REQUIRE(*next > now);
        for (const auto& m : p.sent.take()) {
            REQUIRE(jaus::split(m));
            REQUIRE(jaus::split(m).header.source == sensor);
        }
        for (const auto& m : c.sent.take()) REQUIRE(jaus::split(m));
    }
    REQUIRE(outcomes[static_cast<std::size_t>(message_outcome::handled)] > 100);
    REQUIRE(outcomes[static_cast<std::size_t>(message_outcome::refused)] > 100);
    REQUIRE(outcomes[static_cast<std::size_t>(message_outcome::malformed)] > 100);
}
