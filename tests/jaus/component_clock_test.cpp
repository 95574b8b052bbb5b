// A component's clock: set, queried, and right over the ends of months and in leap years.
#include "jaus/messages.hpp"
#include "support/catch.hpp"
#include "support/instant.hpp"
#include <jauscat/jaus/component/component_clock.hpp>

#include <ctime>

namespace {

using namespace jauscat::test;
using namespace std::chrono_literals;
using support::instant;
namespace jaus = jauscat::jaus;
using jaus::message_outcome;
using std::chrono::sys_days;
using stamps = jaus::report_time;

constexpr jaus::address self{1, 49, 2, 3}, ocu{1, 32, 1, 1};

constexpr jaus::time_stamp at(unsigned day, unsigned hours, unsigned minutes = 0, unsigned seconds = 0,
                              unsigned milliseconds = 0) {
    return {.milliseconds = static_cast<std::uint16_t>(milliseconds),
            .seconds = static_cast<std::uint8_t>(seconds),
            .minutes = static_cast<std::uint8_t>(minutes),
            .hours = static_cast<std::uint8_t>(hours),
            .day = static_cast<std::uint8_t>(day)};
}
constexpr jaus::date_stamp on(unsigned day, unsigned month, unsigned year) {
    return {.day = static_cast<std::uint8_t>(day),
            .month = static_cast<std::uint8_t>(month),
            .year = static_cast<std::uint8_t>(year - 2000)};
}

struct component {
    jaus::component_clock clock{self};
    sent_messages sent{};

    template <class T> message_outcome hear(const T& body, instant now) {
        const auto bytes = message({.destination = self, .source = ocu, .sequence_number = 4}, body);
        const auto m = jaus::split(bytes);
        return clock.on_message(m.header, m.body, now, sent.sink());
    }
    bool set(std::optional<jaus::time_stamp> time, std::optional<jaus::date_stamp> date, instant now = 0s) {
        const auto outcome = hear(jaus::set_time{time, date}, now);
        REQUIRE((outcome == message_outcome::handled || outcome == message_outcome::refused));
        return outcome == message_outcome::handled;
    }
    stamps query(instant now, std::uint8_t presence_vector = 3) {
        sent.clear();
        REQUIRE(hear(jaus::query_time{presence_vector}, now) == message_outcome::handled);
        REQUIRE(sent.size() == 1);
        REQUIRE(sent.header(0).source == self);
        REQUIRE(sent.header(0).destination == ocu);
        return sent.body<jaus::report_time>(0);
    }
};

} // namespace

TEST_CASE("a clock that was not set reports nothing") {
    component c;
    REQUIRE(c.query(5s) == stamps{});
    REQUIRE_FALSE(c.clock.time_at(instant{5s}));
}

TEST_CASE("a clock that was set advances with the caller's time") {
    component c;
    REQUIRE(c.set(at(21, 10, 44, 30, 250), on(21, 11, 2026), 100s));
    REQUIRE(c.query(100s) == stamps{at(21, 10, 44, 30, 250), on(21, 11, 2026)});
    REQUIRE(c.query(100s + 999'999ns) == stamps{at(21, 10, 44, 30, 250), on(21, 11, 2026)});
    REQUIRE(c.query(13h + 100s + 15min + 29s + 750ms) == stamps{at(22, 0, 0, 0, 0), on(22, 11, 2026)});
    REQUIRE(c.query(90s) == stamps{at(21, 10, 44, 20, 250), on(21, 11, 2026)});
    REQUIRE(c.clock.time_at(instant{100s}) == sys_days{std::chrono::year{2026} / 11 / 21} + 10h + 44min + 30s + 250ms);
}

TEST_CASE("a report has the requested fields") {
    component c;
    REQUIRE(c.set(at(1, 2), on(1, 3, 2020)));
    REQUIRE(c.query(0s, 0) == stamps{});
    REQUIRE(c.query(0s, 1) == stamps{at(1, 2), std::nullopt});
    REQUIRE(c.query(0s, 2) == stamps{std::nullopt, on(1, 3, 2020)});
    REQUIRE(c.query(0s, 0xFF) == stamps{at(1, 2), on(1, 3, 2020)});
}

TEST_CASE("every midnight from 2000 to 2127 is followed by the right day") {
    component c;
    const sys_days first{std::chrono::year{2000} / 1 / 1}, last{std::chrono::year{2127} / 12 / 31};
    REQUIRE(c.clock.set(jaus::civil_time{first}, instant{0s}));
    for (auto day = first; day <= last; day += std::chrono::days{1}) {
        const instant now{day - first};
        // The C library's calendar, which is another one.
        const std::time_t seconds = std::chrono::duration_cast<std::chrono::seconds>(day.time_since_epoch()).count();
        std::tm date{};
        REQUIRE(gmtime_r(&seconds, &date) != nullptr);
        const auto expected = on(static_cast<unsigned>(date.tm_mday), static_cast<unsigned>(date.tm_mon + 1),
                                 static_cast<unsigned>(date.tm_year + 1900));
        REQUIRE(c.clock.report_at(now) == stamps{at(expected.day, 0), expected});
        REQUIRE(c.clock.report_at(now + (24h - 1ns)) == stamps{at(expected.day, 23, 59, 59, 999), expected});
        // And set from these stamps, it goes on the same way.
        component again;
        REQUIRE(again.set(at(expected.day, 23, 59, 59, 999), expected, 7s));
        REQUIRE(again.clock.time_at(instant{7s + 1ms}) == jaus::civil_time{day} + 24h);
    }
}

TEST_CASE("a date after 2127 has no stamp, and an application cannot set one") {
    component c;
    const jaus::civil_time end{sys_days{std::chrono::year{2128} / 1 / 1}};
    REQUIRE(c.clock.set(end - 1ns, instant{0s}));
    REQUIRE(c.query(0s) == stamps{at(31, 23, 59, 59, 999), on(31, 12, 2127)});
    REQUIRE(c.query(1ns) == stamps{at(1, 0), std::nullopt});
    REQUIRE_FALSE(c.clock.set(end, instant{0s}));
    REQUIRE_FALSE(c.clock.set(jaus::civil_time{sys_days{std::chrono::year{2000} / 1 / 1}} - 1ns, instant{0s}));
    REQUIRE(c.query(0s) == stamps{at(31, 23, 59, 59, 999), on(31, 12, 2127)});
}

TEST_CASE("setting the time keeps the nearest date, also across the end of a month") {
    component c;
    REQUIRE(c.set(at(10, 12), on(10, 6, 2024)));
    REQUIRE(c.set(at(10, 13), {}));
    REQUIRE(c.query(0s) == stamps{at(10, 13), on(10, 6, 2024)});
    REQUIRE(c.set(at(0, 14), {})); // day not filled in
    REQUIRE(c.query(0s) == stamps{at(10, 14), on(10, 6, 2024)});
    REQUIRE(c.set(at(12, 1), {}));
    REQUIRE(c.query(0s) == stamps{at(12, 1), on(12, 6, 2024)});

    REQUIRE(c.set(at(29, 23, 59), on(29, 2, 2024)));
    REQUIRE(c.set(at(1, 0, 1), {}));
    REQUIRE(c.query(0s) == stamps{at(1, 0, 1), on(1, 3, 2024)});
    REQUIRE(c.set(at(29, 23, 58), {}));
    REQUIRE(c.query(0s) == stamps{at(29, 23, 58), on(29, 2, 2024)});
    REQUIRE(c.set(at(31, 23, 59), on(31, 12, 2023)));
    REQUIRE(c.set(at(1, 0), {}));
    REQUIRE(c.query(0s) == stamps{at(1, 0), on(1, 1, 2024)});
    REQUIRE(c.set(at(31, 23), {}));
    REQUIRE(c.query(0s) == stamps{at(31, 23), on(31, 12, 2023)});

    // The last month has no such day.
    REQUIRE(c.set(at(1, 1), on(1, 12, 2009)));
    REQUIRE(c.set(at(31, 23), {}));
    REQUIRE(c.query(0s) == stamps{at(31, 23), on(31, 10, 2009)});
    REQUIRE(c.set(at(1, 1), on(1, 3, 2023)));
    REQUIRE(c.set(at(30, 23), {}));
    REQUIRE(c.query(0s) == stamps{at(30, 23), on(30, 1, 2023)});
}

TEST_CASE("setting the date keeps the time of day") {
    component c;
    REQUIRE(c.set(at(10, 12, 30), on(10, 6, 2024)));
    REQUIRE(c.set({}, on(28, 2, 2023), 1h));
    REQUIRE(c.query(1h) == stamps{at(28, 13, 30), on(28, 2, 2023)});
    REQUIRE(c.query(12h) == stamps{at(1, 0, 30), on(1, 3, 2023)});
}

TEST_CASE("time and date can be set one after the other, and each is reported once known") {
    component c;
    REQUIRE(c.set(at(31, 22), {}));
    REQUIRE(c.query(1h) == stamps{at(31, 23), std::nullopt});
    REQUIRE(c.set(at(31, 21), {}, 48h)); // of no known month, so the day is right in any
    REQUIRE(c.query(48h) == stamps{at(31, 21), std::nullopt});
    REQUIRE_FALSE(c.clock.time_at(instant{48h}));
    REQUIRE(c.set({}, on(29, 2, 2000), 48h));
    REQUIRE(c.query(48h) == stamps{at(29, 21), on(29, 2, 2000)});

    component d;
    REQUIRE(d.set({}, on(29, 2, 2000)));
    REQUIRE(d.query(0s) == stamps{std::nullopt, on(29, 2, 2000)});
    REQUIRE(d.set(at(29, 21), {}));
    REQUIRE(d.query(0s) == stamps{at(29, 21), on(29, 2, 2000)});
}

TEST_CASE("a Set Time without fields changes nothing") {
    component c;
    REQUIRE(c.set({}, {}));
    REQUIRE(c.query(0s) == stamps{});
}

TEST_CASE("impossible times and days are refused and change nothing") {
    component c;
    REQUIRE(c.set(at(10, 12), on(10, 6, 2024)));
    const auto refused = [&](std::optional<jaus::time_stamp> time, std::optional<jaus::date_stamp> date) {
        return !c.set(time, date, 5s);
    };
    CHECK(refused(at(10, 24), {}));
    CHECK(refused(at(10, 0, 60), {}));
    CHECK(refused(at(10, 0, 0, 60), {}));
    CHECK(refused(at(10, 0, 0, 0, 1000), {}));
    CHECK(refused({}, on(0, 1, 2024)));
    CHECK(refused({}, on(1, 0, 2024)));
    CHECK(refused({}, on(1, 13, 2024)));
    CHECK(refused({}, on(31, 4, 2024)));
    CHECK(refused({}, on(29, 2, 2023)));
    CHECK(refused({}, on(29, 2, 2100)));
    CHECK(refused(at(11, 12), on(10, 6, 2024)));
    CHECK(refused(at(10, 24), on(10, 6, 2024)));
    CHECK(c.query(5s) == stamps{at(10, 12, 0, 5), on(10, 6, 2024)});
    CHECK_FALSE(refused(at(0, 12), on(29, 2, 2024)));
}

TEST_CASE("malformed time messages change nothing, other messages are not handled") {
    component c;
    const std::array<std::byte, 2> bytes{std::byte{1}, std::byte{2}};
    for (const std::uint16_t code : std::to_array<std::uint16_t>({0x0011, 0x2011}))
        REQUIRE(c.clock.on_message({.command_code = code, .source = ocu}, bytes, instant{0s}, c.sent.sink()) ==
                message_outcome::malformed);
    REQUIRE(c.clock.on_message({.command_code = 0x4011, .source = ocu}, bytes, instant{0s}, c.sent.sink()) ==
            message_outcome::unhandled);
    REQUIRE(c.sent.empty());
    REQUIRE_FALSE(c.clock.time_at(instant{0s}));
}
