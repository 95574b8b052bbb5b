#include "support/catch.hpp"
#include <jauscat/base/time.hpp>

using namespace std::chrono_literals;
using jauscat::deadline;
using jauscat::duration;
using jauscat::retry_policy;
using jauscat::saturating_add;
using jauscat::time_point;

TEST_CASE("a sum of times ends at the last instant") {
    STATIC_REQUIRE(saturating_add(time_point{5ms}, 3ms) == time_point{8ms});
    STATIC_REQUIRE(saturating_add(time_point{-5ms}, 3ms) == time_point{-2ms});
    STATIC_REQUIRE(saturating_add(time_point{5ms}, duration::max()) == time_point::max());
    STATIC_REQUIRE(saturating_add(time_point::max(), 1ns) == time_point::max());
    STATIC_REQUIRE(saturating_add(time_point::max(), 0ns) == time_point::max());
    STATIC_REQUIRE(saturating_add(5ms, 3ms) == 8ms);
    STATIC_REQUIRE(saturating_add(5ms, duration::max()) == duration::max());
    STATIC_REQUIRE(saturating_add(time_point{5ms}, -8ms) == time_point{-3ms});
    STATIC_REQUIRE(saturating_add(time_point{-1ns}, duration::min()) == time_point::min());
    STATIC_REQUIRE(saturating_add(time_point::min(), -1ns) == time_point::min());
    STATIC_REQUIRE(saturating_add(-1ns, duration::min()) == duration::min());
}

TEST_CASE("a deadline is reached at its instant") {
    constexpr deadline until{time_point{10ms}, 5ms};
    STATIC_REQUIRE(until.at() == time_point{15ms});
    STATIC_REQUIRE(!until.is_reached(time_point{15ms - 1ns}));
    STATIC_REQUIRE(until.is_reached(time_point{15ms}));
    STATIC_REQUIRE(until.remaining(time_point{12ms}) == 3ms);
    STATIC_REQUIRE(until.remaining(time_point{20ms}) == 0ns);
}

TEST_CASE("a deadline that is not set, or beyond the last instant, is never reached") {
    STATIC_REQUIRE(!deadline{}.is_reached(time_point::max() - 1ns));
    STATIC_REQUIRE(deadline{time_point{1h}, duration::max()} == deadline{});
    STATIC_REQUIRE(deadline{time_point{1h}} < deadline{});
}

TEST_CASE("a deadline before its start is reached") {
    STATIC_REQUIRE(deadline{time_point{1h}, -1ns}.is_reached(time_point{1h}));
    STATIC_REQUIRE(deadline{time_point{1h}, duration::min()}.is_reached(time_point{1h}));
}

TEST_CASE("a retry policy counts all attempts and also waits after the last one") {
    constexpr retry_policy three{.interval = 100ms, .attempts = 3};
    STATIC_REQUIRE(three.total() == 300ms);
    STATIC_REQUIRE(three.allows_another(2));
    STATIC_REQUIRE(!three.allows_another(3));
    STATIC_REQUIRE(retry_policy{.interval = duration::max(), .attempts = 2}.total() == duration::max());
    STATIC_REQUIRE(retry_policy{.interval = 1s, .attempts = 0}.total() == 0s);
}
