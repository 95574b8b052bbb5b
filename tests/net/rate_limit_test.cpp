// Token buckets: rate, burst, idle times; and a table of them under a flood of senders.
#include "support/catch.hpp"
#include "support/instant.hpp"
#include <jauscat/net/limited_log.hpp>
#include <jauscat/net/rate_limit.hpp>

#include <random>
#include <string>
#include <vector>

using namespace std::chrono_literals;
using jauscat::duration;
using jauscat::time_point;
using jauscat::net::rate;
using jauscat::net::rate_key;
using jauscat::net::rate_limit;
using jauscat::net::token_bucket;
using support::instant;

namespace {

/// Messages of `count` sent every `step` that are taken.
int taken(token_bucket& bucket, const rate& limit, instant from, duration step, int count) {
    const time_point start = from;
    int sum = 0;
    for (int i = 0; i != count; ++i) sum += bucket.take(limit, start + step * i) ? 1 : 0;
    return sum;
}

} // namespace

TEST_CASE("a bucket allows its burst at once and then its rate") {
    for (const time_point start : {time_point{-5s}, time_point{0s}, time_point{1'000'000s}}) {
        token_bucket bucket;
        const rate limit{.per_second = 100, .burst = 10};
        CHECK(taken(bucket, limit, start, 0ns, 50) == 10);
        CHECK_FALSE(bucket.take(limit, start + 9ms));
        CHECK(bucket.take(limit, start + 10ms));
        CHECK_FALSE(bucket.take(limit, start + 10ms));
        CHECK(taken(bucket, limit, start + 10ms, 1ms, 10'001) == 1000);
    }
}

TEST_CASE("a sender at its rate is never refused") {
    token_bucket bucket;
    CHECK(taken(bucket, {.per_second = 1000, .burst = 1}, 5s, 1ms, 10'000) == 10'000);
}

TEST_CASE("an idle bucket is refilled to its burst, and no further") {
    token_bucket bucket;
    const rate limit{.per_second = 10, .burst = 5};
    CHECK(bucket.is_full(instant{0s}));
    CHECK(taken(bucket, limit, 0s, 0ns, 9) == 5);
    CHECK_FALSE(bucket.is_full(instant{499ms}));
    CHECK(bucket.is_full(instant{500ms}));
    CHECK(taken(bucket, limit, 1h, 0ns, 9) == 5);
}

TEST_CASE("limits have edge cases: none, a burst of zero, the largest numbers") {
    token_bucket none;
    CHECK(taken(none, {.per_second = 0, .burst = 1}, 0s, 0ns, 1000) == 1000);
    token_bucket one;
    CHECK(taken(one, {.per_second = 1, .burst = 0}, 0s, 0ns, 10) == 1);
    token_bucket large;
    CHECK(taken(large, {.per_second = 4'294'967'295U, .burst = 4'294'967'295U}, 0s, 0ns, 1000) == 1000);
    token_bucket slow;
    CHECK(taken(slow, {.per_second = 1, .burst = 4'294'967'295U}, 0s, 0ns, 1000) == 1000);
}

TEST_CASE("each sender has its own bucket") {
    rate_limit<64> limits{{.per_second = 10, .burst = 3}};
    for (const rate_key& sender : {rate_key{0, 1}, rate_key{1, 0}, rate_key{0, 0}}) {
        for (int i = 0; i != 3; ++i) CHECK(limits.take(sender, instant{1s}));
        CHECK_FALSE(limits.take(sender, instant{1s}));
    }
    CHECK(limits.take({0, 1}, instant{1100ms}));
    CHECK(limits.crowded() == 0);
}

TEST_CASE("a flood of senders is limited as a whole and does not displace existing senders") {
    const rate limit{.per_second = 1000, .burst = 10};
    rate_limit<64> limits{limit, 42};
    const rate_key peer{0, 7};
    for (int i = 0; i != 10; ++i) CHECK(limits.take(peer, instant{0s}));
    CHECK_FALSE(limits.take(peer, instant{0s}));

    std::mt19937_64 random{3};
    std::uint64_t taken = 0;
    for (int i = 0; i != 100'000; ++i) taken += limits.take({random(), random()}, instant{0s}) ? 1 : 0;
    CHECK(taken <= 63 + 10); // one each while there are places, then the shared bucket
    CHECK(taken >= 50);
    CHECK(limits.crowded() > 99'000);
    CHECK_FALSE(limits.take(peer, instant{0s})); // its bucket was not forgotten
    CHECK(limits.take(peer, instant{1ms}));
}

TEST_CASE("idle senders are replaced by others") {
    rate_limit<8> limits{{.per_second = 10, .burst = 1}};
    for (int second = 0; second != 100; ++second)
        for (std::uint64_t sender = 0; sender != 8; ++sender)
            CHECK(limits.take({static_cast<std::uint64_t>(second), sender}, instant{std::chrono::seconds{second}}));
    CHECK(limits.crowded() == 0);
}

TEST_CASE("a limit is constexpr, so it uses no clock and no heap") {
    constexpr bool second_is_refused = [] {
        rate_limit<8> limits{{.per_second = 1, .burst = 1}};
        return limits.take({1, 2}, instant{1s}) && !limits.take({1, 2}, instant{1s});
    }();
    static_assert(second_is_refused);
    SUCCEED();
}

TEST_CASE("a log is limited by cause: a flood of one cause does not suppress others") {
    std::vector<std::string> lines;
    jauscat::net::limited_log log{[&](std::string_view line) { lines.emplace_back(line); },
                                  {.per_second = 1, .burst = 2}};
    const auto flood = [] { return "refused"; };
    const auto rare = [] { return "lost"; };
    for (int i = 0; i != 1000; ++i) log(instant{0s}, flood);
    log(instant{0s}, rare);
    log(instant{1s}, flood);
    REQUIRE(lines == std::vector<std::string>{"refused", "refused", "lost", "998 lines such as the next were left out",
                                              "refused"});
}
