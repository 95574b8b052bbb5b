// Events: provider and consumer by themselves with literal messages, every type and boundary, and both together on a
// network that loses some.
#include "jaus/messages.hpp"
#include "support/hex.hpp"
#include "support/instant.hpp"
#include <jauscat/jaus/events/core_reports.hpp>
#include <jauscat/jaus/events/event_consumer.hpp>
#include <jauscat/jaus/events/events.hpp>
#include <jauscat/schema/jaus/platform.hpp>

#include <algorithm>
#include <limits>
#include <random>
#include <string>

namespace {

using namespace std::chrono_literals;
using jauscat::time_point;
using jauscat::jaus::event_boundary;
using jauscat::jaus::event_notice;
using jauscat::jaus::event_response;
using jauscat::jaus::event_type;
using jauscat::jaus::message_outcome;
using jauscat::jaus::requested_state;
using jauscat::test::bytes;
using jauscat::test::from_hex;
using jauscat::test::to_hex;
using support::instant;
namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;

constexpr jaus::address sensor{1, 42, 1, 2}, viewer{1, 40, 1, 1}, other{2, 40, 1, 1}, third{1, 40, 1, 3};
constexpr std::uint16_t velocity = 0x4404, devices = 0x4406;

jaus::typed_value real(double value) { return {.data_type = jaus::data_type::long_float, .value = value}; }
jaus::typed_value octet(std::uint8_t value) { return {.data_type = jaus::data_type::byte, .value = value}; }

template <jaus::coded_message T> bytes body_of(const T& message) {
    const auto whole = jauscat::test::message({}, message);
    return {whole.begin() + jaus::header_size, whole.end()};
}
bytes velocity_body(double x) { return body_of(jaus::report_velocity_state{.velocity_x = x}); }

/// A provider with reports of velocity and discrete devices, and what it sends.
struct provider {
    std::array<jaus::eventful_report, 4> reports{{{velocity, &jaus::read_field<jaus::report_velocity_state>},
                                                  {devices, &jaus::read_field<jaus::report_discrete_devices>, 10},
                                                  {0x4400, nullptr, 1092, true, false},
                                                  {0x4401, nullptr, 1092, false, true}}};
    std::optional<bytes> current{velocity_body(0)};
    std::vector<bytes> queries{};
    std::optional<std::size_t> operator()(std::uint16_t, std::span<const std::byte> query, std::span<std::byte> body) {
        queries.emplace_back(query.begin(), query.end());
        if (!current || current->size() > body.size()) return std::nullopt;
        std::ranges::copy(*current, body.begin());
        return current->size();
    }
    std::array<std::byte, 1024> memory{};
    jaus::events<4> events{sensor, reports, *this, memory};
    jauscat::test::sent_messages sent{};

    message_outcome hear(const bytes& message, instant now = 0s) {
        const auto m = jaus::split(message);
        REQUIRE(m);
        return events.on_message(m.header, m.body, now, sent.sink());
    }
    template <class Message> message_outcome hear(const jaus::address& from, const Message& body, instant now = 0s) {
        return hear(jauscat::test::message({.destination = sensor, .source = from}, body), now);
    }
    /// Creates an event that must be confirmed, and returns its ID.
    std::uint8_t create(const jaus::create_event& request, instant now = 0s) {
        sent.clear();
        REQUIRE(hear(viewer, request, now) == message_outcome::handled);
        const auto confirmed = sent.body<jaus::confirm_event_request>(0);
        REQUIRE(confirmed.local_request_id == request.local_request_id);
        REQUIRE(confirmed.message_code == request.message_code);
        REQUIRE(confirmed.response_code == event_response::successful);
        return confirmed.event_id;
    }
    /// Sends a request that must be rejected, and returns the reason.
    template <class Message> event_response rejects(const Message& request, const jaus::address& from = viewer) {
        sent.clear();
        REQUIRE(hear(from, request) == message_outcome::refused);
        REQUIRE(sent.size() == 1);
        const auto rejected = sent.body<jaus::reject_event_request>(0);
        REQUIRE(rejected.local_request_id == request.local_request_id);
        REQUIRE(rejected.error_message.has_value());
        return rejected.response_code;
    }
    /// How many events a change of the velocity makes.
    std::size_t drive(double x, instant now) {
        sent.clear();
        current = velocity_body(x);
        events.changed(velocity, *current, now, sent.sink());
        return sent.size();
    }
    std::size_t wait(instant end) {
        sent.clear();
        while (events.next_event() && *events.next_event() <= end) events.on_time(*events.next_event(), sent.sink());
        return sent.size();
    }
};

} // namespace

TEST_CASE("an event on every change is confirmed, and carries the report") {
    provider p;
    REQUIRE(p.hear(from_hex("06 02 f0 01 01 2a 01 02 01 28 01 01 05 00 09 00 00 05 04 44 01"), 1s) ==
            message_outcome::handled);
    REQUIRE(p.sent.size() == 1);
    REQUIRE(to_hex(p.sent[0]) == "06 02 f3 01 01 28 01 01 01 2a 01 02 06 00 09 00 00 05 04 44 01 00");
    REQUIRE(p.events.next_event() == std::nullopt);

    p.events.changed(velocity, from_hex("01 00 ff ff ff 7f"), instant{2s}, p.sent.sink());
    p.events.changed(devices, from_hex("00"), instant{2s}, p.sent.sink());
    p.events.changed(velocity, from_hex("01 00 00 00 00 00"), instant{3s}, p.sent.sink());
    REQUIRE(p.sent.size() == 3);
    REQUIRE(to_hex(p.sent[1]) ==
            "06 02 f1 41 01 28 01 01 01 2a 01 02 0e 00 00 00 01 04 44 00 06 00 00 00 01 00 ff ff ff 7f");
    REQUIRE(to_hex(p.sent[2]) ==
            "06 02 f1 41 01 28 01 01 01 2a 01 02 0e 00 00 00 01 04 44 01 06 00 00 00 01 00 00 00 00 00");

    // Cancel Event, by its ID.
    p.sent.clear();
    REQUIRE(p.hear(from_hex("06 02 f2 01 01 2a 01 02 01 28 01 01 03 00 00 00 02 06 01"), 4s) ==
            message_outcome::handled);
    REQUIRE(to_hex(p.sent[0]) == "06 02 f3 01 01 28 01 01 01 2a 01 02 06 00 00 00 00 06 04 44 01 00");
    REQUIRE(p.drive(1, 5s) == 0);
    REQUIRE(p.hear(from_hex("06 02 f2 01 01 2a 01 02 01 28 01 01 03 00 00 00 02 06 01"), 6s) ==
            message_outcome::refused);
    REQUIRE(to_hex(p.sent[0]).starts_with("06 02 f4 01 01 28 01 01 01 2a 01 02 10 00 00 00 01 06 06 6e 6f 20 73"));
}

TEST_CASE("a periodic event is sent at the confirmed rate, without drift and without bursts") {
    provider p;
    // Presence bit 6: 10 Hz.
    REQUIRE(p.hear(from_hex("06 02 f0 01 01 2a 01 02 01 28 01 01 07 00 00 00 40 05 04 44 00 58 02")) ==
            message_outcome::handled);
    REQUIRE(to_hex(p.sent[0]) == "06 02 f3 01 01 28 01 01 01 2a 01 02 08 00 00 00 01 05 04 44 01 58 02 00");
    const auto period = jaus::period_of(*p.sent.body<jaus::confirm_event_request>(0).confirmed_periodic_rate);
    REQUIRE(p.events.next_event() == instant{0s});
    p.sent.clear();
    for (int i = 0; i != 1000; ++i) {
        REQUIRE(p.events.next_event() == instant{i * period});
        p.events.on_time(instant{i * period + 5ms}, p.sent.sink());
    }
    REQUIRE(p.sent.size() == 1000);
    REQUIRE(p.sent.body<jaus::event>(999).event_sequence_number == 999 % 256);
    p.events.on_time(instant{5000 * period + 1ms}, p.sent.sink());
    REQUIRE(p.sent.size() == 1001);
    REQUIRE(p.events.next_event() == instant{5001 * period});
    REQUIRE(p.drive(1, 5000 * period + 2ms) == 0);

    p.current.reset();
    p.events.on_time(instant{5001 * period}, p.sent.sink());
    REQUIRE(p.sent.empty());
    REQUIRE(p.events.skipped() == 1);
}

TEST_CASE("a change puts off no periodic event") {
    provider p;
    p.create({.message_code = velocity, .event_type = event_type::periodic, .requested_periodic_rate = 10});
    REQUIRE(p.wait(0s) == 1);
    const auto due = p.events.next_event();
    REQUIRE(due < instant{101ms});
    REQUIRE(p.drive(1, 150ms) == 0); // the event is late
    REQUIRE(p.events.next_event() == due);
    p.events.on_time(instant{151ms}, p.sent.sink());
    REQUIRE(p.sent.size() == 1);
}

TEST_CASE("the report of a periodic event is read when the event is due, not before") {
    provider p;
    p.create({.message_code = velocity,
              .event_type = event_type::periodic,
              .limit_data_field = std::uint8_t{2},
              .requested_periodic_rate = 10});
    REQUIRE(p.queries.empty());
    REQUIRE(p.wait(0s) == 1);
    REQUIRE(p.queries.size() == 1);
}

TEST_CASE("a periodic event without repeat is sent only after a change") {
    provider p;
    p.create(
        {.message_code = velocity, .event_type = event_type::periodic_without_repeat, .requested_periodic_rate = 10});
    REQUIRE(p.wait(0s) == 1);
    REQUIRE(p.events.next_event() == std::nullopt);
    REQUIRE(p.drive(1, 250ms) == 0);
    REQUIRE(p.drive(2, 260ms) == 0);
    REQUIRE(p.events.next_event() > instant{299ms});
    REQUIRE(p.events.next_event() < instant{301ms});
    REQUIRE(p.wait(1s) == 1);
    const auto report = p.sent.body<jaus::event>(0).report_message_body;
    REQUIRE(std::ranges::equal(report, velocity_body(2)));
}

TEST_CASE("a first-change event is sent once, and again after an update") {
    provider p;
    const auto id = p.create({.message_code = velocity, .event_type = event_type::first_change});
    REQUIRE(p.drive(1, 1s) == 1);
    REQUIRE(p.drive(2, 2s) == 0);
    REQUIRE(p.hear(from_hex("06 02 f1 01 01 2a 01 02 01 28 01 01 06 00 00 00 00 07 04 44 02 01"), 3s) ==
            message_outcome::handled);
    REQUIRE(id == 1);
    REQUIRE(to_hex(p.sent[0]) == "06 02 f3 01 01 28 01 01 01 2a 01 02 06 00 00 00 00 07 04 44 01 00");
    REQUIRE(p.drive(3, 4s) == 1);
    REQUIRE(p.sent.body<jaus::event>(0).event_sequence_number == 1);
    REQUIRE(p.drive(4, 5s) == 0);
}

TEST_CASE("an event that a minimum rate makes without a change is not the first change") {
    provider p;
    p.create({.message_code = velocity, .event_type = event_type::first_change, .requested_minimum_periodic_rate = 1});
    REQUIRE(p.wait(1500ms) == 1);
    REQUIRE(p.drive(1, 1600ms) == 1);
    REQUIRE(p.drive(2, 1700ms) == 0);
    REQUIRE(p.wait(10s) == 0);
}

TEST_CASE("a one-time event is sent at once, or with the first available report") {
    provider p;
    p.create({.message_code = velocity, .event_type = event_type::one_time_on_demand});
    REQUIRE(p.sent.size() == 2);
    REQUIRE(p.sent.body<jaus::event>(1).event_id == 1);
    REQUIRE(p.events.records()[0].message_code == 0);

    p.current.reset();
    p.create({.message_code = velocity, .event_type = event_type::one_time_on_demand}, 1s);
    REQUIRE(p.sent.size() == 1);
    REQUIRE(p.events.next_event() == std::nullopt);
    REQUIRE(p.drive(1, 2s) == 1);
    REQUIRE(p.sent.body<jaus::event>(0).event_id == 2);
    REQUIRE(p.drive(2, 3s) == 0);
}

TEST_CASE("each boundary condition is met by the values that the standard defines") {
    struct row {
        event_boundary boundary;
        std::string_view met; ///< by -2, -1, 0, 1, 2 with limits -1 and 1, or the one limit
    };
    const auto met = [](const row& r, std::optional<jaus::typed_value> lower, std::optional<jaus::typed_value> upper,
                        std::optional<jaus::typed_value> state) {
        provider p;
        p.current.reset();
        p.create({.message_code = velocity,
                  .event_type = event_type::every_change,
                  .event_boundary = r.boundary,
                  .limit_data_field = std::uint8_t{2},
                  .lower_limit = lower,
                  .upper_limit = upper,
                  .state_limit = state});
        std::string result;
        for (int x = -2; x != 3; ++x) result += p.drive(x, x * 1s + 10s) == 1 ? '1' : '0';
        return result;
    };
    for (const row& r :
         {row{event_boundary::inside_inclusive, "01110"}, row{event_boundary::inside_exclusive, "00100"},
          row{event_boundary::outside_inclusive, "11011"}, row{event_boundary::outside_exclusive, "10001"}})
        REQUIRE(met(r, real(-1), real(1), std::nullopt) == r.met);
    for (const row& r :
         {row{event_boundary::equal, "00010"}, row{event_boundary::not_equal, "11101"},
          row{event_boundary::greater_than_or_equal, "00011"}, row{event_boundary::strictly_greater_than, "00001"},
          row{event_boundary::less_than_or_equal, "11110"}, row{event_boundary::strictly_less_than, "11100"}}) {
        // With the one limit wherever it is.
        REQUIRE(met(r, real(1), std::nullopt, std::nullopt) == r.met);
        REQUIRE(met(r, std::nullopt, real(1), std::nullopt) == r.met);
    }
    REQUIRE(met({event_boundary::equal, {}}, real(0), real(2), real(-1)) == "01000");
    REQUIRE(met({event_boundary::strictly_greater_than, {}}, real(0), real(2), std::nullopt) == "00011");
    REQUIRE(met({event_boundary::strictly_less_than, {}}, real(0), real(2), std::nullopt) == "11110");
}

TEST_CASE("a boundary event is sent when a value enters and when it leaves") {
    provider p;
    p.current = velocity_body(0);
    p.create({.message_code = velocity,
              .event_type = event_type::first_change_in_and_out_of_boundary,
              .event_boundary = event_boundary::strictly_greater_than,
              .limit_data_field = std::uint8_t{2},
              .lower_limit = real(10)});
    const std::array<double, 8> values{1, 11, 12, 13, 10, 9, 20, 0};
    std::string result;
    for (std::size_t i = 0; i != values.size(); ++i) result += p.drive(values[i], (i + 1) * 1s) == 1 ? '1' : '0';
    REQUIRE(result == "01001011");

    // A value that is inside at the beginning is no crossing.
    provider q;
    q.current = velocity_body(11);
    q.create({.message_code = velocity,
              .event_type = event_type::first_change_in_and_out_of_boundary,
              .event_boundary = event_boundary::strictly_greater_than,
              .limit_data_field = std::uint8_t{2},
              .lower_limit = real(10)});
    REQUIRE(q.drive(12, 1s) == 0);
    REQUIRE(q.drive(9, 2s) == 1);
    // A report without the field says nothing about it.
    q.sent.clear();
    q.events.changed(velocity, from_hex("00 00"), instant{3s}, q.sent.sink());
    q.events.changed(velocity, from_hex("01 00 ff"), instant{3s}, q.sent.sink());
    REQUIRE(q.sent.empty());
    REQUIRE(q.drive(8, 4s) == 0);
}

TEST_CASE("only changes of a limited field count") {
    provider p;
    p.current = velocity_body(5);
    p.create({.message_code = velocity, .event_type = event_type::every_change, .limit_data_field = std::uint8_t{2}});
    REQUIRE(p.drive(5, 1s) == 0);
    REQUIRE(p.drive(6, 2s) == 1);
    const auto turned = body_of(jaus::report_velocity_state{.velocity_x = 6, .yaw_rate = 1});
    p.events.changed(velocity, turned, instant{3s}, p.sent.sink());
    REQUIRE(p.sent.size() == 1);
    REQUIRE(p.drive(5, 4s) == 1);
}

TEST_CASE("fields of different types are compared by value") {
    using jaus::compare;
    using jaus::data_type;
    const auto number = [](auto value) { return jaus::field_value{.number = value}; };
    const jaus::typed_value small{.data_type = data_type::short_integer, .value = std::int16_t{-1}};
    REQUIRE(std::is_gt(compare(number(std::uint64_t{0xFFFF}), small)));
    REQUIRE(std::is_eq(compare(number(std::int64_t{-1}), small)));
    REQUIRE(std::is_lt(compare(number(-1.5), small)));
    REQUIRE(std::is_lt(compare(number(std::int64_t{-2}), real(-1.5))));
    REQUIRE(std::is_gt(compare(number(std::int64_t{-1}), real(-1.5))));
    REQUIRE(std::is_eq(compare(number(std::uint64_t{2}), real(2))));
    // Beyond 2^53 a double has no place for each integer.
    const std::uint64_t large = (std::uint64_t{1} << 53) + 1;
    REQUIRE(std::is_gt(compare(number(large), real(9007199254740992.0))));
    REQUIRE(std::is_lt(compare(number(~std::uint64_t{}), real(18446744073709551616.0))));
    REQUIRE(std::is_lt(compare(number(std::numeric_limits<std::int64_t>::max()), real(9223372036854775808.0))));
    REQUIRE(std::is_eq(compare(number(std::numeric_limits<std::int64_t>::min()), real(-9223372036854775808.0))));
    REQUIRE(std::is_gt(compare(number(std::numeric_limits<std::int64_t>::min()), real(-1e300))));
    const auto nan = real(std::numeric_limits<double>::quiet_NaN());
    REQUIRE(compare(number(std::uint64_t{2}), nan) == std::partial_ordering::unordered);
    REQUIRE(compare(number(2.0), nan) == std::partial_ordering::unordered);
    REQUIRE(compare(number(2.0), {.data_type = data_type::rgb, .value = jaus::rgb{}}) ==
            std::partial_ordering::unordered);

    // A scaled field: an integer is what is on the wire, a real number is rounded to the field's steps.
    const auto x = *jaus::read_field<jaus::report_velocity_state>(velocity_body(10), 2).value;
    REQUIRE(std::is_eq(compare(x, real(10))));
    REQUIRE(std::is_eq(compare(x, {.data_type = data_type::float_, .value = 10.0f})));
    REQUIRE(std::is_lt(compare(x, real(10.01))));
    REQUIRE(std::is_lt(compare(x, real(1000))));
    REQUIRE(std::is_gt(compare(x, real(-1000))));
    REQUIRE(compare(x, nan) == std::partial_ordering::unordered);
    const auto turned = body_of(jaus::report_velocity_state{.yaw_rate = -10});
    const auto yaw = *jaus::read_field<jaus::report_velocity_state>(turned, 8).value;
    REQUIRE(std::is_eq(compare(yaw, {.data_type = data_type::short_integer, .value = std::int16_t{-10000}})));
    REQUIRE(std::is_lt(compare(yaw, {.data_type = data_type::unsigned_long_integer, .value = std::uint64_t{0}})));
    REQUIRE(std::is_eq(compare(yaw, real(-10))));
}

TEST_CASE("fields of a report are found by their numbers") {
    const auto read = &jaus::read_field<jaus::report_velocity_state>;
    const auto all = body_of(jaus::report_velocity_state{
        .velocity_x = 1, .yaw_rate = 2, .time_stamp = jaus::time_stamp{.milliseconds = 7, .seconds = 1}});
    REQUIRE(read(all, 2).value);
    REQUIRE(read(all, 8).value);
    REQUIRE(std::get<std::uint64_t>(read(all, 10).value->number) == 7 + 1024);
    REQUIRE(read(all, 3).exists);
    REQUIRE_FALSE(read(all, 3).value);
    for (const std::uint8_t number : {std::uint8_t{0}, std::uint8_t{1}, std::uint8_t{11}, std::uint8_t{255}})
        REQUIRE_FALSE(read(all, number).exists);
    REQUIRE(read({}, 2).exists);
    REQUIRE_FALSE(read({}, 2).value);
    REQUIRE(read(from_hex("01 00 01 00 00 80"), 2).value);
    REQUIRE_FALSE(read(from_hex("01 00 00 00 00 80"), 2).value); // the raw value that stands for nothing

    using device = jaus::main_propulsion_device;
    const auto switched = body_of(jaus::report_discrete_devices{
        .main_propulsion = wire::bit_set<device>{device::main_propulsion, device::cold_start},
        .gear = jaus::gear::neutral});
    const auto read_devices = &jaus::read_field<jaus::report_discrete_devices>;
    REQUIRE(std::get<std::uint64_t>(read_devices(switched, 2).value->number) == 0x21);
    REQUIRE(std::get<std::uint64_t>(read_devices(switched, 4).value->number) == 128);
}

TEST_CASE("changes faster than the rate are held back, and the newest is sent") {
    provider p;
    p.create({.message_code = velocity, .event_type = event_type::every_change, .requested_periodic_rate = 10});
    REQUIRE(p.sent.body<jaus::confirm_event_request>(0).confirmed_periodic_rate.has_value());
    REQUIRE(p.drive(1, 1s) == 1);
    for (int i = 1; i != 50; ++i) REQUIRE(p.drive(i, 1s + i * 1ms) == 0);
    REQUIRE(p.events.next_event() > instant{1099ms});
    REQUIRE(p.wait(2s) == 1);
    REQUIRE(std::ranges::equal(p.sent.body<jaus::event>(0).report_message_body, velocity_body(49)));
    REQUIRE(p.drive(50, 2s) == 1);

    // The report's own limit, where none was asked for.
    provider q;
    q.create({.message_code = devices, .event_type = event_type::every_change});
    q.sent.clear();
    for (int i = 0; i != 100; ++i) q.events.changed(devices, from_hex("00"), instant{i * 1ms}, q.sent.sink());
    REQUIRE(q.sent.size() == 1);
}

TEST_CASE("changes of a report without a maximum rate are all sent") {
    provider p;
    p.reports[0].max_rate = 0;
    p.create({.message_code = velocity, .event_type = event_type::every_change});
    for (const double x : {1, 2, 3}) REQUIRE(p.drive(x, 1s) == 1);
}

TEST_CASE("without a report when the event is set up, the first report of a limited event counts as a change") {
    struct {
        bool is_there{};
        std::optional<std::size_t> operator()(std::uint16_t, std::span<const std::byte>, std::span<std::byte> body) {
            const auto old = velocity_body(7);
            std::ranges::copy(old, body.begin());
            std::optional<std::size_t> size{old.size()};
            if (!is_there) size.reset();
            return size;
        }
    } filler;
    for (const bool is_there : {true, false}) {
        provider p;
        filler.is_there = is_there;
        p.events = {sensor, p.reports, filler, p.memory};
        p.create({.message_code = velocity,
                  .event_type = event_type::every_change,
                  .event_boundary = event_boundary::strictly_greater_than,
                  .limit_data_field = std::uint8_t{2},
                  .lower_limit = real(5)});
        REQUIRE(p.drive(7, 1s) == (is_there ? 0 : 1));
    }
}

TEST_CASE("without a report when the event is updated, the first report of a limited event counts as a change") {
    provider p;
    const jaus::create_event request{.message_code = velocity,
                                     .event_type = event_type::every_change,
                                     .event_boundary = event_boundary::strictly_greater_than,
                                     .limit_data_field = std::uint8_t{2},
                                     .lower_limit = real(5)};
    const auto id = p.create(request);
    REQUIRE(p.drive(7, 1s) == 1);
    REQUIRE(p.drive(7, 2s) == 0);
    p.current.reset();
    REQUIRE(p.hear(viewer, jaus::as_update(request, id), 3s) == message_outcome::handled);
    REQUIRE(p.drive(7, 4s) == 1);
}

TEST_CASE("a minimum rate is kept within the highest rate of the report") {
    provider p;
    p.create({.message_code = devices, .event_type = event_type::every_change, .requested_minimum_periodic_rate = 100});
    REQUIRE(p.wait(1050ms) == 10);
}

TEST_CASE("a minimum rate makes events without changes") {
    provider p;
    p.create({.message_code = velocity, .event_type = event_type::every_change, .requested_minimum_periodic_rate = 1});
    REQUIRE(p.events.next_event() > instant{999ms});
    REQUIRE(p.wait(3500ms) == 3);
    REQUIRE(p.drive(1, 3900ms) == 1);
    REQUIRE(p.events.next_event() > instant{4899ms});
    p.current.reset();
    REQUIRE(p.wait(6s) == 0);
    REQUIRE(p.events.skipped() == 2);
}

TEST_CASE("the query of an event selects its content") {
    provider p;
    const auto query = from_hex("0f 00");
    p.create({.message_code = velocity,
              .event_type = event_type::every_change,
              .query_message_body = wire::blob{std::span<const std::byte>{query}}});
    p.queries.clear();
    REQUIRE(p.drive(1, 1s) == 1);
    REQUIRE(p.queries == std::vector<bytes>{query});
    const bytes most(24), more(25);
    const auto with = [](const bytes& q) {
        return jaus::create_event{.message_code = velocity,
                                  .event_type = event_type::every_change,
                                  .query_message_body = wire::blob{std::span<const std::byte>{q}}};
    };
    p.create(with(most));
    REQUIRE(p.rejects(with(more)) == event_response::invalid_event_setup);
}

TEST_CASE("an impossible event is rejected with the reason") {
    provider p;
    using enum event_response;
    const jaus::create_event every{
        .local_request_id = 9, .message_code = velocity, .event_type = event_type::every_change};
    const auto with = [&](auto change) {
        auto request = every;
        change(request);
        return request;
    };
    REQUIRE(p.rejects(with([](auto& r) { r.message_code = 0x4402; })) == message_not_supported);
    REQUIRE(p.rejects(with([](auto& r) { r.message_code = 0; })) == message_not_supported);
    REQUIRE(p.rejects(with([](auto& r) { r.message_code = 0x4400; })) == change_based_events_not_supported);
    REQUIRE(p.rejects(with([](auto& r) {
        r.message_code = 0x4401;
        r.event_type = event_type::periodic;
        r.requested_periodic_rate = 1;
    })) == periodic_events_not_supported);
    REQUIRE(p.rejects(with([](auto& r) { r.event_type = event_type::periodic; })) == invalid_event_setup);
    REQUIRE(p.rejects(with([](auto& r) { r.event_type = event_type{6}; })) == invalid_event_setup);
    REQUIRE(p.rejects(with([](auto& r) { r.event_type = event_type::first_change_in_and_out_of_boundary; })) ==
            invalid_event_setup);
    const auto limited = [&](event_boundary boundary, std::optional<std::uint8_t> field, auto... limits) {
        return with([&](auto& r) {
            r.event_boundary = boundary;
            r.limit_data_field = field;
            const std::array<std::optional<jaus::typed_value>, 2> both{limits...};
            r.lower_limit = both[0];
            r.upper_limit = both[1];
        });
    };
    const std::uint8_t x = 2;
    REQUIRE(p.rejects(limited(event_boundary::equal, x)) == invalid_event_setup);
    REQUIRE(p.rejects(limited(event_boundary::equal, std::nullopt, real(1))) == invalid_event_setup);
    REQUIRE(p.rejects(limited(event_boundary::inside_inclusive, x, real(1))) == invalid_event_setup);
    REQUIRE(p.rejects(limited(event_boundary::inside_inclusive, x, std::nullopt, real(1))) == invalid_event_setup);
    REQUIRE(p.rejects(limited(event_boundary{10}, x, real(1), real(2))) == invalid_event_setup);
    REQUIRE(p.rejects(limited(event_boundary::equal, std::uint8_t{1}, real(1))) == invalid_event_setup);
    REQUIRE(p.rejects(limited(event_boundary::equal, std::uint8_t{11}, real(1))) == invalid_event_setup);
    const jaus::typed_value colour{.data_type = jaus::data_type::rgb, .value = jaus::rgb{}};
    REQUIRE(p.rejects(limited(event_boundary::equal, x, colour)) == invalid_event_setup);
    REQUIRE(p.rejects(with([](auto& r) {
        r.message_code = 0x4401;
        r.limit_data_field = std::uint8_t{2};
    })) == invalid_event_setup);

    for (std::uint8_t i = 0; i != 3; ++i) p.create(with([&](auto& r) { r.local_request_id = i; }));
    REQUIRE(p.rejects(every) == connection_refused); // its node has its share
    REQUIRE(p.hear(third, every) == message_outcome::handled);
    REQUIRE(p.rejects(every, jaus::address{1, 40, 1, 4}) == connection_refused); // all places are taken
    const jaus::update_event update{.message_code = velocity, .event_type = event_type::every_change, .event_id = 1};
    REQUIRE(p.rejects(update, other) == error_invalid_event_id_for_update_request);
    auto changed = update;
    changed.event_id = 77;
    REQUIRE(p.rejects(changed) == error_invalid_event_id_for_update_request);
    changed = update;
    changed.message_code = devices;
    REQUIRE(p.rejects(changed) == invalid_event_setup);
    changed = update;
    changed.event_type = event_type::periodic;
    REQUIRE(p.rejects(changed) == invalid_event_setup);
    REQUIRE(p.rejects(jaus::cancel_event{}, other) == error_invalid_event_id_for_update_request);
    REQUIRE(p.drive(1, 1s) == 4); // none of it changed anything
}

TEST_CASE("a judge function rejects requests with its own reason, and malformed requests change nothing") {
    provider p;
    const auto policy = [](const jaus::header& head, std::uint16_t code) {
        REQUIRE(code == velocity);
        return head.source == viewer ? event_response::successful : event_response::connection_refused;
    };
    p.events = {sensor, p.reports, p, p.memory, policy};
    const jaus::create_event request{.message_code = velocity, .event_type = event_type::every_change};
    REQUIRE(p.rejects(request, other) == event_response::connection_refused);
    p.create(request);

    const std::array<std::byte, 3> junk{std::byte{1}};
    for (const std::uint16_t code : {std::uint16_t{0x1F0}, std::uint16_t{0x1F1}, std::uint16_t{0x1F2}})
        for (const std::size_t size : {0u, 1u, 3u})
            REQUIRE(p.events.on_message({.command_code = code, .source = viewer}, std::span{junk}.first(size),
                                        instant{0s}, p.sent.sink()) == message_outcome::malformed);
    REQUIRE(p.events.on_message({.command_code = 0x21F0}, {}, instant{0s}, p.sent.sink()) ==
            message_outcome::malformed);
    REQUIRE(p.events.on_message({.command_code = 0x41F1}, {}, instant{0s}, p.sent.sink()) ==
            message_outcome::unhandled);
    REQUIRE(p.events.on_message({.ack_nak = jaus::ack_nak::ack, .command_code = 0x1F0}, {}, instant{0s},
                                p.sent.sink()) == message_outcome::unhandled);
    REQUIRE(p.sent.size() == 1);
}

TEST_CASE("a repeated request creates one event") {
    provider p;
    const jaus::create_event request{
        .local_request_id = 3, .message_code = velocity, .event_type = event_type::every_change};
    REQUIRE(p.create(request) == 1);
    REQUIRE(p.create(request) == 1);
    auto another = request;
    another.local_request_id = 4;
    REQUIRE(p.create(another) == 2);
    REQUIRE(p.drive(1, 1s) == 2);
    REQUIRE(p.events.on_lost(other) == 0);
    REQUIRE(p.events.on_lost(viewer) == 2);
    REQUIRE(p.drive(2, 2s) == 0);
    REQUIRE(p.create(request) != 0);
    REQUIRE(p.events.on_lost({255, 255, viewer.node, viewer.subsystem}) == 1); // its node
}

TEST_CASE("the events of all requesters that are lost are counted, and free places are not") {
    provider p;
    p.create({.message_code = velocity, .event_type = event_type::every_change});
    REQUIRE(p.events.on_lost({255, 255, 255, 3}) == 0);
    REQUIRE(p.events.on_lost({255, 255, 255, 255}) == 1);
    REQUIRE(p.drive(1, 1s) == 0);
    REQUIRE(p.events.on_lost({255, 255, 255, 255}) == 0);
}

TEST_CASE("event IDs are not reused at once") {
    provider p;
    for (int i = 0; i != 600; ++i) {
        const auto id = p.create({.message_code = velocity, .event_type = event_type::every_change});
        REQUIRE(id == i % 255 + 1);
        REQUIRE(p.hear(viewer, jaus::cancel_event{.message_code = velocity}) == message_outcome::handled);
    }
}

TEST_CASE("events that are queried are reported") {
    provider p;
    const auto query = from_hex("0f 00");
    p.create({.message_code = velocity,
              .event_type = event_type::every_change,
              .event_boundary = event_boundary::inside_inclusive,
              .limit_data_field = std::uint8_t{2},
              .lower_limit = octet(1),
              .upper_limit = octet(9),
              .query_message_body = wire::blob{std::span<const std::byte>{query}}});
    p.create({.message_code = devices, .event_type = event_type::first_change});
    p.sent.clear();
    REQUIRE(p.hear(from_hex("06 02 f0 21 01 2a 01 02 01 28 01 01 01 00 00 00 00")) == message_outcome::handled);
    REQUIRE(to_hex(p.sent[0]) == "06 02 f0 41 01 28 01 01 01 2a 01 02 17 00 00 00 "
                                 "02 6f 04 44 01 02 02 00 01 00 09 01 02 00 00 00 0f 00 20 06 44 02 02");
    const auto count = [&](const jaus::query_events& m) {
        p.sent.clear();
        REQUIRE(p.hear(other, m) == message_outcome::handled);
        return std::to_integer<int>(p.sent[0].at(16));
    };
    REQUIRE(count({.message_code = velocity}) == 1);
    REQUIRE(count({.event_type = event_type::first_change}) == 1);
    REQUIRE(count({.event_id = std::uint8_t{2}}) == 1);
    REQUIRE(count({.message_code = velocity, .event_id = std::uint8_t{2}}) == 0);
}

TEST_CASE("a report that exceeds the buffer is skipped") {
    provider p;
    std::array<std::byte, 280> memory{}; // 24 and twice 128
    p.events = {sensor, p.reports, p, memory};
    p.create({.message_code = velocity, .event_type = event_type::every_change});
    p.sent.clear();
    p.events.changed(velocity, bytes(128), instant{1s}, p.sent.sink());
    REQUIRE(p.sent.size() == 1);
    REQUIRE(p.sent[0].size() == 24 + 128);
    p.events.changed(velocity, bytes(200), instant{2s}, p.sent.sink());
    REQUIRE(p.sent.size() == 1);
    REQUIRE(p.events.skipped() == 1);
    jaus::events<1> none{sensor, p.reports, p, {}};
    const auto request = from_hex("00 05 04 44 01");
    REQUIRE(none.on_message({.command_code = 0x1F0, .source = viewer}, request, instant{0s}, p.sent.sink()) ==
            message_outcome::handled);
    none.changed(velocity, {}, instant{1s}, p.sent.sink());
    REQUIRE(p.sent.size() == 1);
}

TEST_CASE("a core report is written if it fits the buffer, also exactly") {
    const auto answer = [](const jaus::header& query, std::span<const std::byte>, time_point,
                           jaus::message_sink out) -> message_outcome {
        out(jauscat::test::message(jaus::answer_to(query, sensor), jaus::report_component_authority{9}));
        return message_outcome::handled;
    };
    const auto* const report = jaus::core_report_of(0x4001);
    REQUIRE(report != nullptr);
    std::array<std::byte, 1> body{};
    const auto write = [&](std::span<std::byte> buffer) {
        return jaus::write_core_report(*report, sensor, std::span<const std::byte>{}, buffer, instant{0s}, answer);
    };
    REQUIRE(write(body) == std::size_t{1});
    REQUIRE(body[0] == std::byte{9});
    REQUIRE(write(std::span{body}.first(0)) == std::nullopt);
}

namespace {

/// A consumer and what it sends.
struct consumer {
    jaus::event_consumer<2> events{viewer};
    jauscat::test::sent_messages sent{};
    jaus::event_outcome hear(const bytes& message, instant now = 0s) {
        const auto m = jaus::split(message);
        REQUIRE(m);
        return events.on_message(m.header, m.body, now, sent.sink());
    }
    const jaus::requested_event& first() { return events.requested()[0]; }
};

bytes confirmed(const std::string& body) { return from_hex("06 02 f3 01 01 28 01 01 01 2a 01 02 06 00 00 00" + body); }
bytes occurred(const std::string& number) {
    return from_hex("06 02 f1 41 01 28 01 01 01 2a 01 02 0a 00 00 00 07 04 44" + number + "02 00 00 00 ab cd");
}

} // namespace

TEST_CASE("a consumer matches answers and events with its requests") {
    consumer c;
    const jaus::create_event wanted{.message_code = velocity, .event_type = event_type::every_change};
    REQUIRE(c.events.create(sensor, wanted, instant{0s}, c.sent.sink()) == 0);
    REQUIRE(to_hex(c.sent[0]) == "06 02 f0 01 01 2a 01 02 01 28 01 01 05 00 00 00 00 01 04 44 01");
    REQUIRE(c.events.next_event() == instant{1s});
    c.events.on_time(instant{1s}, c.sent.sink());
    REQUIRE(c.sent[1] == c.sent[0]);
    REQUIRE(c.hear(confirmed("00 02 04 44 07 00")).what == event_notice::unknown);
    REQUIRE(c.hear(occurred("00")).what == event_notice::unknown);
    REQUIRE(c.hear(confirmed("00 01 04 44 07 00")).what == event_notice::confirmed);
    REQUIRE(c.events.next_event() == instant{5s}); // the provider is asked whether it has the event

    const auto message = occurred("fe");
    const auto heard = c.hear(message);
    REQUIRE(heard.what == event_notice::event);
    REQUIRE(heard.message_code == velocity);
    REQUIRE(to_hex(heard.report) == "ab cd");
    REQUIRE(c.hear(occurred("fe")).what == event_notice::repeated);
    const auto next = c.hear(occurred("02"));
    REQUIRE(next.what == event_notice::event);
    REQUIRE(next.lost == 3);
    REQUIRE(c.hear(occurred("01")).what == event_notice::repeated);
    REQUIRE(c.first().received == 2);
    REQUIRE(c.first().lost == 3);

    c.sent.clear();
    c.events.cancel(0, instant{5s}, c.sent.sink());
    REQUIRE(to_hex(c.sent[0]) == "06 02 f2 01 01 2a 01 02 01 28 01 01 05 00 00 00 03 02 04 44 07");
    REQUIRE(c.hear(confirmed("00 01 04 44 07 00")).what == event_notice::unknown); // of the creation, late
    REQUIRE(c.hear(confirmed("00 02 04 44 07 00")).what == event_notice::cancelled);
    REQUIRE(c.first().state == requested_state::free);
}

TEST_CASE("a consumer updates an event that continues meanwhile") {
    consumer c;
    jaus::create_event wanted{.message_code = velocity, .event_type = event_type::every_change};
    REQUIRE(c.events.create(sensor, wanted, instant{0s}, c.sent.sink()));
    REQUIRE_FALSE(c.events.update(0, wanted, instant{0s}, c.sent.sink())); // not active yet
    c.hear(confirmed("00 01 04 44 07 00"));
    c.sent.clear();
    wanted.requested_minimum_periodic_rate = 10;
    REQUIRE(c.events.update(0, wanted, instant{1s}, c.sent.sink()));
    REQUIRE(to_hex(c.sent[0]) == "06 02 f1 01 01 2a 01 02 01 28 01 01 08 00 00 00 20 02 04 44 01 58 02 07");
    REQUIRE(c.events.next_event() == instant{2s});
    c.events.on_time(instant{2s}, c.sent.sink());
    REQUIRE(c.sent[1] == c.sent[0]);
    REQUIRE(c.hear(occurred("00")).what == event_notice::event);
    REQUIRE(c.hear(confirmed("00 02 04 44 07 00")).what == event_notice::confirmed);
    REQUIRE(c.first().state == requested_state::active);

    // A rejection leaves it as it was, and so does silence.
    REQUIRE(c.events.update(0, wanted, instant{3s}, c.sent.sink()));
    REQUIRE(c.hear(from_hex("06 02 f4 01 01 28 01 01 01 2a 01 02 03 00 00 00 00 03 04")).what ==
            event_notice::rejected);
    REQUIRE(c.first().response == event_response::invalid_event_setup);
    REQUIRE(c.events.update(0, wanted, instant{3s}, c.sent.sink()));
    while (c.first().state == requested_state::updating) c.events.on_time(*c.events.next_event(), c.sent.sink());
    REQUIRE(c.first().state == requested_state::active);
    REQUIRE(c.first().requests == 5);
    REQUIRE(c.hear(occurred("01")).what == event_notice::event);
    wanted.message_code = devices;
    REQUIRE_FALSE(c.events.update(0, wanted, instant{3s}, c.sent.sink()));
    REQUIRE_FALSE(c.events.update(2, wanted, instant{3s}, c.sent.sink()));

    // Update and events of a provider.
    provider p;
    wanted = {.message_code = velocity, .event_type = event_type::first_change};
    consumer d;
    REQUIRE(d.events.create(sensor, wanted, instant{0s}, d.sent.sink()));
    const auto exchange = [&] {
        for (const auto& m : d.sent.take()) p.hear(m);
        std::vector<event_notice> news;
        for (const auto& m : p.sent.take()) news.push_back(d.hear(m).what);
        return news;
    };
    REQUIRE(exchange() == std::vector{event_notice::confirmed});
    p.drive(1, 1s);
    REQUIRE(exchange() == std::vector{event_notice::event});
    p.drive(2, 2s);
    REQUIRE(exchange().empty());
    REQUIRE(d.events.update(0, wanted, instant{3s}, d.sent.sink()));
    REQUIRE(exchange() == std::vector{event_notice::confirmed});
    p.drive(3, 4s);
    REQUIRE(exchange() == std::vector{event_notice::event});
}

TEST_CASE("a consumer whose update is rejected asks for the event as it was when the provider has lost it") {
    consumer c;
    jaus::create_event wanted{.message_code = velocity, .event_type = event_type::every_change};
    REQUIRE(c.events.create(sensor, wanted, instant{0s}, c.sent.sink()));
    c.hear(confirmed("00 01 04 44 07 00"));
    const auto first = c.sent[0];
    wanted.event_type = event_type::periodic;
    wanted.requested_periodic_rate = 10;
    REQUIRE(c.events.update(0, wanted, instant{1s}, c.sent.sink()));
    REQUIRE(c.hear(from_hex("06 02 f4 01 01 28 01 01 01 2a 01 02 03 00 00 00 00 02 04")).what ==
            event_notice::rejected);
    CHECK(c.first().type == event_type::every_change);
    while (c.first().state == requested_state::active) {
        c.sent.clear();
        c.events.on_time(*c.events.next_event(), c.sent.sink());
    }
    REQUIRE(c.first().state == requested_state::stale);
    REQUIRE(c.sent.size() == 1);
    CHECK(c.sent[0] == first);
    CHECK(c.hear(confirmed("00 01 04 44 08 00")).what == event_notice::confirmed);
}

TEST_CASE("a consumer abandons requests that are rejected or never answered") {
    consumer c;
    const jaus::create_event wanted{.message_code = velocity, .event_type = event_type::every_change};
    REQUIRE(c.events.create(sensor, wanted, instant{0s}, c.sent.sink()));
    REQUIRE(c.hear(from_hex("06 02 f4 01 01 28 01 01 01 2a 01 02 05 00 00 00 01 01 03 6e 6f")).what ==
            event_notice::rejected);
    REQUIRE(c.first().response == event_response::connection_refused);
    REQUIRE(c.hear(from_hex("06 02 f4 01 01 28 01 01 01 2a 01 02 01 00 00 00 01")).what == event_notice::malformed);
    c.sent.clear();
    REQUIRE(c.events.create(sensor, wanted, instant{0s}, c.sent.sink()) == 0);
    REQUIRE(c.events.create(sensor, wanted, instant{0s}, c.sent.sink()) == 1);
    REQUIRE(c.events.create(sensor, wanted, instant{0s}, c.sent.sink()) == std::nullopt);
    while (c.events.next_event()) c.events.on_time(*c.events.next_event(), c.sent.sink());
    REQUIRE(c.sent.size() == 10);
    REQUIRE(c.first().state == requested_state::unanswered);
    const bytes query(25);
    auto large = wanted;
    large.lower_limit = large.upper_limit = large.state_limit = real(1);
    large.event_boundary = event_boundary::equal;
    large.limit_data_field = std::uint8_t{2};
    large.requested_minimum_periodic_rate = large.requested_periodic_rate = 1;
    large.query_message_body = wire::blob{std::span<const std::byte>{query}};
    REQUIRE(c.events.create(sensor, large, instant{0s}, c.sent.sink()) == std::nullopt);
    large.query_message_body = wire::blob{std::span<const std::byte>{query}.first(24)};
    REQUIRE(c.events.create(sensor, large, instant{0s}, c.sent.sink()) == 0);
    REQUIRE(c.first().request.size() == jaus::max_create_event_size);
}

TEST_CASE("the place of a cancelled event is kept only while the provider may have it") {
    consumer c;
    const jaus::create_event wanted{.message_code = velocity, .event_type = event_type::every_change};
    REQUIRE(c.events.create(sensor, wanted, instant{0s}, c.sent.sink()) == 0);
    c.events.cancel(0, instant{0s}, c.sent.sink());
    REQUIRE(c.first().state == requested_state::cancelling);
    REQUIRE(c.sent.size() == 2); // the request again: its answer has the ID, by which the event is then cancelled
    REQUIRE(c.sent[1] == c.sent[0]);
    REQUIRE(c.hear(confirmed("00 01 04 44 07 00")).what == event_notice::confirmed);
    REQUIRE(c.hear(confirmed("00 02 04 44 07 00")).what == event_notice::cancelled);

    REQUIRE(c.events.create(sensor, wanted, instant{1s}, c.sent.sink()) == 0);
    c.hear(from_hex("06 02 f4 01 01 28 01 01 01 2a 01 02 05 00 00 00 01 03 03 6e 6f"));
    REQUIRE(c.first().state == requested_state::rejected);
    c.sent.clear();
    c.events.cancel(0, instant{1s}, c.sent.sink());
    REQUIRE(c.first().state == requested_state::free);
    REQUIRE(c.sent.empty());
}

TEST_CASE("a periodic event that is confirmed without a rate is watched as one without a period") {
    consumer c;
    REQUIRE(c.events.create(
        sensor, {.message_code = velocity, .event_type = event_type::periodic, .requested_periodic_rate = 10},
        instant{0s}, c.sent.sink()));
    REQUIRE(c.hear(confirmed("00 01 04 44 07 00")).what == event_notice::confirmed);
    REQUIRE(c.first().rate == 0);
    REQUIRE(c.events.next_event() == instant{5s});
}

TEST_CASE("an event confirmed after it was abandoned is cancelled") {
    consumer c;
    const jaus::create_event wanted{.message_code = velocity, .event_type = event_type::every_change};
    REQUIRE(c.events.create(sensor, wanted, instant{0s}, c.sent.sink()));
    while (c.events.next_event()) c.events.on_time(*c.events.next_event(), c.sent.sink());
    REQUIRE(c.first().state == requested_state::unanswered);
    c.sent.clear();
    c.hear(confirmed("00 01 04 44 07 00"), 10s);
    REQUIRE(to_hex(c.sent[0]) == "06 02 f2 01 01 2a 01 02 01 28 01 01 05 00 00 00 03 02 04 44 07");
    REQUIRE(c.hear(confirmed("00 01 04 44 07 00"), 10s).what == event_notice::unknown); // twice
    REQUIRE(c.events.next_event() == instant{11s});                                     // the cancel may get lost
    REQUIRE(c.hear(confirmed("00 02 04 44 07 00"), 11s).what == event_notice::cancelled);
    REQUIRE(c.first().state == requested_state::free);
}

TEST_CASE("a consumer abandons the events of a provider that has disappeared") {
    consumer c;
    const jaus::create_event wanted{.message_code = velocity, .event_type = event_type::every_change};
    REQUIRE(c.events.create(sensor, wanted, instant{0s}, c.sent.sink()));
    REQUIRE(c.events.create(sensor, wanted, instant{0s}, c.sent.sink()));
    c.hear(confirmed("00 01 04 44 07 00"));
    c.hear(confirmed("00 02 04 44 08 00"));
    c.events.cancel(1, instant{1s}, c.sent.sink());
    REQUIRE(c.events.on_lost({255, 255, 1, 1}) == 0);
    REQUIRE(c.events.on_lost({255, 255, sensor.node, sensor.subsystem}) == 2);
    REQUIRE(c.first().state == requested_state::unanswered);
    REQUIRE(c.events.requested()[1].state == requested_state::free);
    REQUIRE(c.hear(occurred("00")).what == event_notice::unknown);
    REQUIRE(c.events.on_lost(sensor) == 0);
    c.sent.clear();
    REQUIRE(c.events.create(sensor, wanted, instant{2s}, c.sent.sink()) == 0);
    REQUIRE(c.hear(confirmed("00 05 04 44 01 00")).what == event_notice::confirmed); // 4 cancelled the unknown event
}

TEST_CASE("a consumer abandons an event that is stale when its provider has disappeared") {
    consumer c;
    REQUIRE(c.events.create(sensor, {.message_code = velocity, .event_type = event_type::every_change}, instant{0s},
                            c.sent.sink()));
    c.hear(confirmed("00 01 04 44 07 00"));
    while (c.first().state != requested_state::stale) c.events.on_time(*c.events.next_event(), c.sent.sink());
    REQUIRE(c.events.on_lost(sensor) == 1);
    REQUIRE(c.first().state == requested_state::unanswered);
    REQUIRE(c.events.next_event() == std::nullopt);
}

namespace {

/// Hands on what provider and consumer have sent each other, until nothing is left; the events that came.
std::size_t converse(provider& p, consumer& c, instant now) {
    std::size_t count = 0;
    while (!p.sent.empty() || !c.sent.empty()) {
        for (const auto& m : c.sent.take()) p.hear(m, now);
        for (const auto& m : p.sent.take()) count += c.hear(m, now).what == event_notice::event;
    }
    return count;
}

/// Asks for events of the velocity, until the provider has answered.
void subscribe(provider& p, consumer& c, event_type type, instant now) {
    REQUIRE(c.events.create(sensor, {.message_code = velocity, .event_type = type}, now, c.sent.sink()));
    converse(p, c, now);
}
std::size_t in_use(const provider& p) {
    return static_cast<std::size_t>(
        std::ranges::count_if(p.events.records(), [](const auto& e) { return e.message_code != 0; }));
}
bytes event_number(unsigned number) {
    return jauscat::test::message({.destination = viewer, .source = sensor},
                                  jaus::event{.event_id = 7,
                                              .message_code = velocity,
                                              .event_sequence_number = static_cast<std::uint8_t>(number)});
}

} // namespace

TEST_CASE("a restarted consumer gets a first change as before") {
    provider p;
    for (int run = 0; run != 3; ++run) {
        consumer c;
        const time_point now = instant{run * 100s};
        REQUIRE(c.events.create(sensor, {.message_code = velocity, .event_type = event_type::first_change}, now,
                                c.sent.sink()));
        converse(p, c, now);
        p.drive(run, now + 1s);
        REQUIRE(converse(p, c, now + 1s) == 1);
        p.drive(run + 0.5, now + 2s);
        REQUIRE(converse(p, c, now + 2s) == 0);
        REQUIRE(in_use(p) == 1);
    }
}

TEST_CASE("a consumer that restarts repeatedly leaves no events behind") {
    // Each run asks for another rate, so the provider cannot know the event of the run before.
    provider p;
    for (int run = 0; run != 20; ++run) {
        consumer c;
        const time_point now = instant{run * 10ms};
        REQUIRE(c.events.create(
            sensor,
            {.message_code = velocity, .event_type = event_type::periodic, .requested_periodic_rate = 1.0 + run}, now,
            c.sent.sink()));
        converse(p, c, now);
        REQUIRE(c.first().state == requested_state::active);
    }
    REQUIRE(in_use(p) == 3); // the share of a node
    // Others find a place, and none is taken from an event that is wanted.
    REQUIRE(p.hear(third, jaus::create_event{.message_code = velocity, .event_type = event_type::every_change}) ==
            message_outcome::handled);
    REQUIRE(p.hear(third, jaus::create_event{.local_request_id = 1,
                                             .message_code = velocity,
                                             .event_type = event_type::first_change}) == message_outcome::handled);
    REQUIRE(p.hear(third, jaus::create_event{.local_request_id = 2,
                                             .message_code = 0x4400,
                                             .event_type = event_type::periodic,
                                             .requested_periodic_rate = 1}) == message_outcome::handled);
    REQUIRE(
        p.rejects(
            jaus::create_event{.local_request_id = 3, .message_code = velocity, .event_type = event_type::every_change},
            third) == event_response::connection_refused);
}

TEST_CASE("an event that was requested again is not superseded by another one of that number") {
    provider p;
    const auto request = [](std::uint8_t id, event_type type) {
        return jaus::create_event{.local_request_id = id, .message_code = velocity, .event_type = type};
    };
    REQUIRE(p.create(request(1, event_type::every_change)) == 1);
    REQUIRE(p.create(request(1, event_type::first_change)) == 2);
    REQUIRE(p.create(request(1, event_type::every_change)) == 1);
    REQUIRE(p.create(request(2, event_type::every_change)) == 3);
    REQUIRE(p.create(request(3, event_type::every_change)) == 4); // beyond the share of its node
    const auto has = [&](std::uint8_t id) {
        return std::ranges::count(p.events.records(), id, &jaus::event_record::event_id) == 1;
    };
    REQUIRE(has(1));
    REQUIRE_FALSE(has(2));
    REQUIRE(has(3));
}

TEST_CASE("requesters that number their requests alike keep their events when all places are taken") {
    provider p;
    const auto request = [](std::uint8_t id, event_type type) {
        return jaus::create_event{.local_request_id = id, .message_code = velocity, .event_type = type};
    };
    for (const std::uint8_t id : {std::uint8_t{1}, std::uint8_t{2}})
        for (const auto& requester : {viewer, third})
            REQUIRE(p.hear(requester, request(id, event_type::every_change)) == message_outcome::handled);
    REQUIRE(p.rejects(request(3, event_type::every_change), third) == event_response::connection_refused);
    REQUIRE(p.drive(1, 1s) == 4);
    REQUIRE(std::ranges::count(p.events.records(), viewer, &jaus::event_record::requester) == 2);
}

TEST_CASE("an event without a request is cancelled, at most once for each answer timeout") {
    consumer c;
    REQUIRE(c.hear(event_number(0), 1s).what == event_notice::unknown);
    REQUIRE(c.hear(event_number(1), 1500ms).what == event_notice::unknown);
    REQUIRE(c.sent.size() == 1);
    REQUIRE(c.sent.body<jaus::cancel_event>(0).event_id == std::uint8_t{7});
    REQUIRE(c.sent.body<jaus::cancel_event>(0).message_code == velocity);
    REQUIRE(c.hear(event_number(2), 2s).what == event_notice::unknown);
    REQUIRE(c.sent.size() == 2);
    // Another one of the same report is cancelled at once.
    c.hear(jauscat::test::message({.destination = viewer, .source = sensor},
                                  jaus::event{.event_id = 8, .message_code = velocity}),
           2s);
    REQUIRE(c.sent.size() == 3);
    REQUIRE(c.sent.body<jaus::cancel_event>(2).event_id == std::uint8_t{8});

    // Not while its confirmation may be under way.
    c.sent.clear();
    REQUIRE(c.events.create(sensor, {.message_code = velocity, .event_type = event_type::every_change}, instant{5s},
                            c.sent.sink()));
    c.sent.clear();
    REQUIRE(c.hear(event_number(3), 5s).what == event_notice::unknown);
    REQUIRE(c.sent.empty());
    // That of another report is none that was asked for.
    c.hear(jauscat::test::message({.destination = viewer, .source = sensor},
                                  jaus::event{.event_id = 7, .message_code = devices}),
           5s);
    REQUIRE(c.sent.size() == 1);
    REQUIRE(c.sent.body<jaus::cancel_event>(0).message_code == devices);

    // What an earlier life has left goes on until it is cancelled.
    provider p;
    consumer before, after;
    REQUIRE(before.events.create(sensor, {.message_code = velocity, .event_type = event_type::every_change},
                                 instant{0s}, before.sent.sink()));
    converse(p, before, 0s);
    p.drive(1, 1s);
    converse(p, after, 1s);
    REQUIRE(in_use(p) == 0);
}

TEST_CASE("events continue after a gap that exceeds their numbers") {
    consumer c;
    REQUIRE(c.events.create(sensor, {.message_code = velocity, .event_type = event_type::every_change}, instant{0s},
                            c.sent.sink()));
    c.hear(confirmed("00 01 04 44 07 00"));
    REQUIRE(c.hear(event_number(9), 1s).what == event_notice::event);
    // Late ones and copies of those before are dropped, at first.
    REQUIRE(c.hear(event_number(9), 1900ms).what == event_notice::repeated);
    REQUIRE(c.hear(event_number(8), 1900ms).what == event_notice::repeated);
    REQUIRE(c.hear(event_number(9 + 128), 1900ms).what == event_notice::repeated); // as far behind as ahead
    // A cable that was out for 130 events.
    REQUIRE(c.hear(event_number(9 + 130), 2s).what == event_notice::event);
    REQUIRE(c.first().lost == 0);
    REQUIRE(c.hear(event_number(9 + 131), 2s).what == event_notice::event);
    REQUIRE(c.hear(event_number(9 + 131 + 256), 3s).what == event_notice::event);
    REQUIRE(c.hear(event_number(9 + 131 + 256 + 128), 4s).what == event_notice::event);
}

TEST_CASE("late events and copies are dropped at any time, also after a silence") {
    consumer c;
    REQUIRE(c.events.create(sensor, {.message_code = velocity, .event_type = event_type::every_change}, instant{0s},
                            c.sent.sink()));
    c.hear(confirmed("00 01 04 44 07 00"));
    for (const unsigned number : {60u, 62u}) REQUIRE(c.hear(event_number(number), 1s).what == event_notice::event);
    REQUIRE(c.hear(event_number(62), 1s).what == event_notice::repeated);
    for (const auto now : {1s, 2s, 4s, 3600s})
        for (const unsigned number : {61u, 60u, 1u, 0u})
            REQUIRE(c.hear(event_number(number), now).what == event_notice::repeated);
    while (c.first().state != requested_state::stale) c.events.on_time(*c.events.next_event(), c.sent.sink());
    REQUIRE(c.hear(event_number(61), 3601s).what == event_notice::repeated);
    // Confirmed again: it goes on, or counts anew, which the number 0 or 1 says, or that it goes on for long.
    const auto id = c.first().local_request_id;
    c.hear(jauscat::test::message(
               {.destination = viewer, .source = sensor},
               jaus::confirm_event_request{.local_request_id = id, .message_code = velocity, .event_id = 7}),
           3602s);
    REQUIRE(c.first().state == requested_state::active);
    REQUIRE(c.hear(event_number(61), 3602s).what == event_notice::repeated);
    SECTION("it goes on") {
        REQUIRE(c.hear(event_number(63), 3602s).what == event_notice::event);
        REQUIRE(c.hear(event_number(1), 3602s).what == event_notice::repeated); // the doubt is over
    }
    SECTION("it counts anew") {
        REQUIRE(c.hear(event_number(1), 3602s).what == event_notice::event);
        REQUIRE(c.hear(event_number(2), 3602s).what == event_notice::event);
        REQUIRE(c.hear(event_number(1), 3602s).what == event_notice::repeated);
    }
    SECTION("its first events were lost") {
        for (unsigned i = 3; i != 10; ++i) REQUIRE(c.hear(event_number(i), 3602s).what == event_notice::repeated);
        REQUIRE(c.hear(event_number(10), 3602s).what == event_notice::event);
    }
}

TEST_CASE("a silent provider of periodic events is detected, and queried until it answers") {
    provider p;
    consumer c;
    REQUIRE(c.events.create(
        sensor, {.message_code = velocity, .event_type = event_type::periodic, .requested_periodic_rate = 10},
        instant{0s}, c.sent.sink()));
    converse(p, c, 0s);
    const auto period = jaus::period_of(c.first().rate);
    REQUIRE(c.events.next_event() == instant{3 * period});
    p.wait(period);
    REQUIRE(converse(p, c, period) == 2);
    REQUIRE(c.events.next_event() == instant{4 * period});
    const auto count = [&](instant end) {
        c.sent.clear();
        while (*c.events.next_event() <= end) c.events.on_time(*c.events.next_event(), c.sent.sink());
        return c.sent.size();
    };
    REQUIRE(count(60s) == 60);
    REQUIRE(c.first().state == requested_state::stale);
    // It has started anew, and counts from 0 under another ID.
    provider anew;
    anew.create({.message_code = devices, .event_type = event_type::every_change});
    c.events.on_time(*c.events.next_event(), c.sent.sink());
    converse(anew, c, 61s);
    REQUIRE(c.first().state == requested_state::active);
    REQUIRE(c.first().event_id == 2);
    anew.wait(61s);
    REQUIRE(converse(anew, c, 61s) == 1);
    REQUIRE(in_use(anew) == 2);

    // One that was cut off goes on with the same event.
    count(70s);
    REQUIRE(c.first().state == requested_state::stale);
    c.sent.clear();
    c.events.on_time(*c.events.next_event(), c.sent.sink());
    converse(anew, c, 71s);
    REQUIRE(c.first().event_id == 2);
    anew.wait(71s);
    REQUIRE(converse(anew, c, 71s) == 1);
    REQUIRE(in_use(anew) == 2);

    // Who refuses it now is not asked again.
    count(80s);
    REQUIRE(c.first().state == requested_state::stale);
    c.hear(jauscat::test::message({.destination = viewer, .source = sensor},
                                  jaus::reject_event_request{.local_request_id = c.first().local_request_id}),
           80s);
    REQUIRE(c.first().state == requested_state::rejected);
    REQUIRE(c.events.next_event() == std::nullopt);
}

TEST_CASE("a silent provider of change events is detected, and queried until it answers") {
    const jaus::create_event wanted{.message_code = velocity, .event_type = event_type::every_change};
    provider p;
    consumer c;
    REQUIRE(c.events.create(sensor, wanted, instant{0s}, c.sent.sink()));
    converse(p, c, 0s);
    p.drive(1, 2s);
    REQUIRE(converse(p, c, 2s) == 1);

    // Nothing changes for a minute: every 5 s the provider is asked, and says that it has the event.
    int queries = 0;
    while (*c.events.next_event() <= instant{60s}) {
        const time_point now = *c.events.next_event();
        c.events.on_time(now, c.sent.sink());
        REQUIRE(c.sent.size() == 1);
        REQUIRE(to_hex(c.sent[0]) == "06 02 f0 21 01 2a 01 02 01 28 01 01 04 00 00 00 05 04 44 01");
        ++queries;
        converse(p, c, now);
        REQUIRE(c.first().state == requested_state::active);
    }
    REQUIRE(queries == 11);

    // A lost answer does nothing.
    const time_point last = *c.events.next_event();
    c.events.on_time(last, c.sent.sink());
    c.sent.clear();
    REQUIRE(c.events.next_event() == last + 1s);
    c.events.on_time(last + 1s, c.sent.sink());
    converse(p, c, last + 1s);
    REQUIRE(c.events.next_event() == last + 6s);

    // The provider ends: noticed after 5 s and five queries.
    c.sent.clear();
    while (c.first().state == requested_state::active) c.events.on_time(*c.events.next_event(), c.sent.sink());
    REQUIRE(c.first().state == requested_state::stale);
    REQUIRE(c.events.next_event() == last + 12s);
    REQUIRE(c.sent.size() == 6);
    REQUIRE(c.sent.body<jaus::create_event>(5).message_code == velocity);

    // It has started anew, and gives the event another ID.
    provider anew;
    anew.create({.message_code = devices, .event_type = event_type::every_change});
    c.sent.clear();
    anew.sent.clear();
    c.events.on_time(last + 12s, c.sent.sink());
    converse(anew, c, last + 12s);
    REQUIRE(c.first().state == requested_state::active);
    REQUIRE(c.first().event_id == 2);
    anew.drive(2, last + 13s);
    REQUIRE(converse(anew, c, last + 13s) == 1);
}

TEST_CASE("an event answers a query as well as a list does") {
    consumer c;
    REQUIRE(c.events.create(sensor, {.message_code = velocity, .event_type = event_type::every_change}, instant{0s},
                            c.sent.sink()));
    c.hear(confirmed("00 01 04 44 07 00"));
    time_point now{};
    for (unsigned number = 0; number != 10; ++number) {
        now = *c.events.next_event();
        c.sent.clear();
        c.events.on_time(now, c.sent.sink());
        REQUIRE(c.sent.body<jaus::query_events>(0).event_id == std::uint8_t{7});
        REQUIRE(c.hear(event_number(number), now).what == event_notice::event);
        REQUIRE(c.events.next_event() == now + 5s);
    }
    // Then it is silent: five queries before the request.
    c.sent.clear();
    while (c.first().state == requested_state::active) c.events.on_time(*c.events.next_event(), c.sent.sink());
    REQUIRE(c.sent.size() == 6);
}

TEST_CASE("a list of events answers only the query for an event that it has") {
    consumer c;
    const jaus::create_event wanted{.message_code = velocity, .event_type = event_type::every_change};
    const auto listed = [&](std::uint16_t code) {
        const std::array<jaus::reported_event, 1> all{{{.message_code = code, .event_id = 7}}};
        c.hear(jauscat::test::message({.destination = viewer, .source = sensor}, jaus::report_events{all}), 5s);
    };
    REQUIRE(c.events.create(sensor, wanted, instant{0s}, c.sent.sink()));
    c.hear(confirmed("00 01 04 44 07 00"));
    c.events.on_time(instant{5s}, c.sent.sink());
    listed(devices); // the same ID, another report
    REQUIRE(c.first().requests == 1);
    listed(velocity);
    REQUIRE(c.first().requests == 0);

    REQUIRE(c.events.update(0, wanted, instant{5s}, c.sent.sink()));
    listed(velocity); // says nothing of the update
    REQUIRE(c.first().state == requested_state::updating);
}

TEST_CASE("a restarted provider without the event gets the request again") {
    provider p;
    consumer c;
    subscribe(p, c, event_type::every_change, 0s);
    provider anew;
    while (*c.events.next_event() <= instant{10s}) {
        const time_point now = *c.events.next_event();
        c.events.on_time(now, c.sent.sink());
        converse(anew, c, now);
    }
    REQUIRE(c.first().state == requested_state::active);
    REQUIRE(in_use(anew) == 1);
}

TEST_CASE("a received first change is not requested again") {
    provider p;
    consumer c;
    subscribe(p, c, event_type::first_change, 0s);
    REQUIRE(c.events.next_event() == instant{5s});
    p.drive(1, 1s);
    REQUIRE(converse(p, c, 1s) == 1);
    REQUIRE(c.first().state == requested_state::active);
    REQUIRE(c.events.next_event() == std::nullopt);

    // Nor is a provider asked that does not answer Query Events.
    c.events = jaus::event_consumer<2>{viewer, {.interval = 1s, .attempts = 5}, jauscat::duration::max()};
    subscribe(p, c, event_type::every_change, 2s);
    REQUIRE(c.first().state == requested_state::active);
    REQUIRE(c.events.next_event() == std::nullopt);
}

TEST_CASE("a limit that is not a number is refused, for any field") {
    provider p;
    const auto nan = real(std::numeric_limits<double>::quiet_NaN());
    jaus::typed_value small_nan{.data_type = jaus::data_type::float_, .value = std::numeric_limits<float>::quiet_NaN()};
    jaus::create_event wanted{.message_code = velocity,
                              .event_type = event_type::every_change,
                              .event_boundary = event_boundary::equal,
                              .limit_data_field = std::uint8_t{2},
                              .state_limit = nan};
    REQUIRE(p.rejects(wanted) == event_response::invalid_event_setup);
    wanted.state_limit = real(1);
    wanted.upper_limit = small_nan;
    REQUIRE(p.rejects(wanted) == event_response::invalid_event_setup);
    REQUIRE(p.rejects(jaus::create_event{.message_code = velocity,
                                         .event_type = event_type::periodic,
                                         .lower_limit = nan,
                                         .requested_periodic_rate = 1}) == event_response::invalid_event_setup);
    wanted.upper_limit.reset();
    wanted.state_limit = real(std::numeric_limits<double>::infinity());
    p.create(wanted);
    REQUIRE(in_use(p) == 1);
}

TEST_CASE("a rate that rounds to 0 is refused, and a low one is kept") {
    consumer c;
    jaus::create_event wanted{
        .message_code = velocity, .event_type = event_type::periodic, .requested_periodic_rate = 1e-10};
    REQUIRE(c.events.create(sensor, wanted, instant{0s}, c.sent.sink()) == std::nullopt);
    wanted.requested_periodic_rate = std::numeric_limits<double>::denorm_min();
    REQUIRE(c.events.create(sensor, wanted, instant{0s}, c.sent.sink()) == std::nullopt);
    wanted.requested_periodic_rate = 0.1;
    REQUIRE(c.events.create(sensor, wanted, instant{0s}, c.sent.sink()) == 0);

    // A report that changes often, and is sent once in 1000 seconds.
    provider p;
    p.reports[0].max_rate = 0.001;
    REQUIRE(p.rejects(jaus::create_event{.message_code = velocity,
                                         .event_type = event_type::every_change,
                                         .requested_periodic_rate = 5}) == event_response::invalid_event_setup);
    p.create({.message_code = velocity, .event_type = event_type::every_change});
    REQUIRE(p.drive(1, 1s) == 1);
    REQUIRE(p.drive(2, 2s) == 0);
    REQUIRE(p.drive(3, 1001s) == 1);
}

TEST_CASE("over a network that loses a third of all messages, events are created, delivered and ended") {
    std::mt19937 random{5};
    std::uint64_t received = 0, lost = 0;
    for (int round = 0; round != 100; ++round) {
        provider p;
        consumer c;
        c.events = jaus::event_consumer<2>{viewer, {.interval = 100ms, .attempts = 100}};
        const auto exchange = [&](instant now) {
            for (int hop = 0; hop != 4; ++hop) {
                for (const auto& m : c.sent.take())
                    if (random() % 3 != 0) p.hear(m, now);
                for (const auto& m : p.sent.take())
                    if (random() % 3 != 0) REQUIRE(c.hear(m, now).what != event_notice::malformed);
            }
        };
        REQUIRE(c.events.create(sensor, {.message_code = velocity, .event_type = event_type::every_change}, instant{0s},
                                c.sent.sink()));
        REQUIRE(c.events.create(
            sensor, {.message_code = velocity, .event_type = event_type::periodic, .requested_periodic_rate = 20},
            instant{0s}, c.sent.sink()));
        if (round % 4 == 0) c.events.cancel(1, instant{0s}, c.sent.sink()); // before its ID is known
        for (time_point now{}; now != instant{40s}; now += 5ms) {
            if (now == instant{20s}) {
                REQUIRE(c.first().state == requested_state::active);
                REQUIRE(c.first().received > 50);
                received += c.first().received;
                lost += c.first().lost;
                REQUIRE(c.first().received + c.first().lost <= 200);
                c.events.cancel(0, now, c.sent.sink());
                c.events.cancel(1, now, c.sent.sink());
            }
            if (now.time_since_epoch() % 100ms == 0s && now < instant{20s})
                p.events.changed(velocity, velocity_body(1), now, p.sent.sink());
            if (p.events.next_event() && *p.events.next_event() <= now) p.events.on_time(now, p.sent.sink());
            if (c.events.next_event() && *c.events.next_event() <= now) c.events.on_time(now, c.sent.sink());
            exchange(now);
        }
        for (const auto& e : c.events.requested()) REQUIRE(e.state == requested_state::free);
        for (const auto& e : p.events.records()) REQUIRE(e.message_code == 0);
    }
    // A third is lost, and is known to be.
    REQUIRE(lost * 100 > received * 40);
    REQUIRE(lost * 100 < received * 60);
}

TEST_CASE("random messages keep both sides of events within their bounds") {
    std::mt19937 random{17};
    provider p;
    consumer c;
    std::array<int, 4> outcomes{};
    constexpr std::array<std::uint16_t, 8> codes{0x1F0, 0x1F1, 0x1F2, 0x1F3, 0x1F4, 0x21F0, 0x41F0, 0x41F1};
    time_point now{};
    for (int i = 0; i != 100000; ++i) {
        now += std::chrono::milliseconds{random() % 50};
        // A request that is in order, and in most cases cut or changed.
        bytes body = body_of(jaus::create_event{
            .local_request_id = static_cast<std::uint8_t>(random() % 4),
            .message_code = velocity,
            .event_type = event_type(random() % 7),
            .event_boundary = event_boundary(random() % 11),
            .limit_data_field = static_cast<std::uint8_t>(random() % 12),
            .lower_limit = real(static_cast<double>(random() % 20) - 10),
            .upper_limit = octet(static_cast<std::uint8_t>(random())),
            .requested_periodic_rate = static_cast<double>(random() % 100),
        });
        const std::uint16_t code = codes[random() % codes.size()];
        if (code != 0x1F0 || random() % 2 == 0) {
            body.resize(random() % 3 == 0 ? random() % body.size() : std::min<std::size_t>(body.size(), 9));
            for (auto& b : body)
                if (random() % 4 == 0) b = static_cast<std::byte>(random() % 3 == 0 ? random() : random() % 4);
        }
        const jaus::header head{
            .command_code = code, .destination = sensor, .source = random() % 2 == 0 ? viewer : sensor};
        ++outcomes[static_cast<std::size_t>(p.events.on_message(head, body, now, p.sent.sink()))];
        c.events.on_message(head, body, now, c.sent.sink());
        const jaus::create_event wanted{.message_code = velocity, .event_type = event_type(random() % 6)};
        if (random() % 50 == 0) static_cast<void>(c.events.create(sensor, wanted, now, c.sent.sink()));
        if (random() % 50 == 0) c.events.cancel(random() % 3, now, c.sent.sink());
        if (random() % 100 == 0) p.events.on_lost(viewer);
        const auto report = velocity_body(static_cast<double>(random() % 40) - 20);
        p.events.changed(velocity, std::span{report}.first(random() % 4 == 0 ? 3 : report.size()), now, p.sent.sink());
        p.events.on_time(now, p.sent.sink());
        c.events.on_time(now, c.sent.sink());
        if (const auto next = p.events.next_event()) REQUIRE(*next > now);
        if (const auto next = c.events.next_event()) REQUIRE(*next > now);
        for (const auto& m : p.sent.take()) {
            REQUIRE(jaus::split(m));
            REQUIRE(jaus::split(m).header.source == sensor);
        }
        for (const auto& m : c.sent.take()) REQUIRE(jaus::split(m));
    }
    REQUIRE(outcomes[static_cast<std::size_t>(message_outcome::handled)] > 100);
    REQUIRE(outcomes[static_cast<std::size_t>(message_outcome::refused)] > 1000);
    REQUIRE(outcomes[static_cast<std::size_t>(message_outcome::malformed)] > 1000);
}
