// The histogram of times, and waiting for periodic instants.
#include "support/catch.hpp"
#include <jauscat/net/link/cycle_timer.hpp>
#include <jauscat/net/link/latency_histogram.hpp>
#include <jauscat/net/node/run_until.hpp>

#include <boost/asio/steady_timer.hpp>

#include <sstream>
#include <thread>
#include <vector>

using namespace std::chrono_literals;
using jauscat::net::cycle_timer;
using jauscat::net::latency_histogram;

TEST_CASE("a histogram without times prints 0") {
    const latency_histogram none;
    CHECK(none.count() == 0);
    CHECK(none.min() == 0ns);
    CHECK(none.max() == 0ns);
    CHECK(none.quantile(0.5) == 0ns);
    std::ostringstream out;
    none.print(out);
    CHECK(out.str().empty());
}

TEST_CASE("short times are counted exactly") {
    latency_histogram h;
    for (int i = 100; i >= 1; --i) h.add(std::chrono::nanoseconds{i});
    CHECK(h.count() == 100);
    CHECK(h.min() == 1ns);
    CHECK(h.max() == 100ns);
    CHECK(h.quantile(0) == 1ns);
    CHECK(h.quantile(0.5) == 50ns);
    CHECK(h.quantile(0.99) == 99ns);
    CHECK(h.quantile(0.991) == 100ns);
    CHECK(h.quantile(1) == 100ns);
}

TEST_CASE("a quantile exceeds the time by at most a 64th") {
    for (std::int64_t time = 1; time < 130'000'000'000; time += time / 7 + 1) {
        latency_histogram h;
        h.add(std::chrono::nanoseconds{time});
        h.add(200s);
        const auto median = h.quantile(0.5).count();
        CHECK(median >= time);
        CHECK(median <= time + time / 64);
        CHECK(h.quantile(1) == 200s);
    }
}

TEST_CASE("times beyond the buckets are counted") {
    latency_histogram h;
    h.add(-5ns);
    CHECK(h.max() == 0ns);
    CHECK(h.quantile(1) == 0ns);
    h.add(24h);
    CHECK(h.count() == 2);
    CHECK(h.min() == 0ns);
    CHECK(h.quantile(0.5) == 0ns);
    CHECK(h.quantile(1) == 24h);
}

TEST_CASE("buckets have no gaps and contain their values") {
    latency_histogram h;
    std::vector<std::int64_t> times;
    for (std::int64_t time = 0; time < 100'000; ++time) h.add(std::chrono::nanoseconds{time});
    std::chrono::nanoseconds expected{};
    h.for_each_bucket([&](auto from, auto below, std::uint64_t count) {
        CHECK(from == expected);
        CHECK(static_cast<std::int64_t>(count) == std::min((below - from).count(), 100'000 - from.count()));
        expected = below;
    });
    CHECK(expected > 100'000ns);
}

TEST_CASE("a histogram is printed as bars") {
    latency_histogram h;
    for (int i = 0; i != 1000; ++i) h.add(20us);
    for (int i = 0; i != 30; ++i) h.add(21us);
    h.add(1ms);
    std::ostringstream out;
    out.precision(3);
    h.print(out, 20);
    CHECK(out.str() == "     18.43 us      1000 ####################\n"
                       "     20.48 us        30 ##########\n"
                       "          ...\n"
                       "    983.04 us         1 ##\n");
    CHECK(out.precision() == 3);
}

TEST_CASE("the due times of a cycle timer are whole periods apart, and it is never early") {
    for (const std::chrono::nanoseconds spin : {0ns, 200'000ns}) {
        cycle_timer timer{2ms, spin};
        const auto start = timer.due();
        for (int i = 0; i != 20; ++i) {
            const auto before = timer.due();
            const auto late = timer.wait();
            CHECK(late >= 0ns);
            CHECK(jauscat::net::now() >= timer.due() + late);
            CHECK(timer.due() > before);
            CHECK((timer.due() - start) % 2ms == 0ns);
        }
        CHECK(timer.due() - start == (20 + static_cast<std::int64_t>(timer.overruns())) * 2ms);
    }
}

TEST_CASE("due times during a long cycle are skipped and counted") {
    cycle_timer timer{2ms};
    const auto start = timer.due();
    std::this_thread::sleep_for(7ms); // covers those at 2, 4 and 6 ms
    CHECK(timer.wait() >= 0ns);
    CHECK(timer.overruns() >= 3);
    CHECK(timer.due() - start == (1 + static_cast<std::int64_t>(timer.overruns())) * 2ms);
}

TEST_CASE("run_until never times out with the longest timeout, and does not wait with a negative one") {
    boost::asio::io_context context;
    boost::asio::steady_timer timer{context, 1ms};
    bool fired = false;
    timer.async_wait([&](const auto&) { fired = true; });
    REQUIRE_FALSE(jauscat::net::run_until(context, -1s, [&] { return fired; }));
    REQUIRE(jauscat::net::run_until(context, std::chrono::nanoseconds::max(), [&] { return fired; }));
}
