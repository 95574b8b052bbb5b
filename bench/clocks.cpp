// Distributed clocks of emulated slaves in simulated time: how far they are apart, and how well a master's cycles
// follow. The same figures on every machine. scripts/measure clocks writes them to docs/clocks.md.
#include "ethercat/clock_bench.hpp"
#include <jauscat/ethercat/master/clock_cycle.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <iostream>
#include <random>
#include <string_view>
#include <vector>

using namespace jauscat::ethercat;
using namespace std::chrono_literals;
using jauscat::duration;
namespace test = jauscat::test;
using test::bench_slave;
using test::clock_bench;

namespace {

constexpr int cycles = 8'000; // of 1 ms
constexpr int settled = 2'000;
constexpr double master_drift = 80e-6; // and frames start up to 10 us late

struct outcome {
    std::int64_t spread{};             // ns, the largest once settled
    std::int64_t follower{};           // ns, the largest error of a cycle's start once settled
    int locked{};                      // cycles until the master's cycles were locked
    std::uint32_t delay{};             // ns, the longest one measured
    std::vector<std::int64_t> curve{}; // spread, from the first cycle on
};

// `lost`: the cycle in which the reference clock is reset; it takes no part in the spread then.
outcome run(const std::vector<bench_slave>& slaves, std::uint32_t seed, int lost = cycles) {
    clock_bench bench{slaves};
    bench.gap = 10us;
    outcome result;
    const auto network = bench.set_up();
    if (!network) {
        std::cerr << "clocks: " << describe(network.error()) << '\n';
        return result;
    }
    for (const auto& each : bench.clocks) result.delay = std::max(result.delay, each.delay);
    clock_cycle clock{bench.clocks, *network, bench.system_time()};
    std::mt19937 random{seed};
    std::uniform_int_distribution<std::int64_t> jitter{0, 10'000};
    std::array<std::byte, max_frame_size> buffer{};
    auto due = bench.now;
    for (int i = 0; i != cycles; ++i) {
        if (i == lost) bench.device(network->reference - clock_bench::station(0)).power_on();
        bench.now = std::max(bench.now, due + duration{jitter(random)});
        const auto frame = std::span{buffer}.first(clock.next_frame(buffer, bench.now, bench.now - due));
        bench.send(frame);
        static_cast<void>(clock.on_frame(frame));
        const auto period = static_cast<double>((1ms + clock.end_cycle()).count()) * (1 - master_drift);
        due += duration{static_cast<std::int64_t>(period)};
        const auto first = i < lost ? 0 : std::size_t{network->reference} - clock_bench::station(0) + 1;
        const auto spread = bench.spread(first);
        result.curve.push_back(spread);
        if (result.locked == 0 && clock.control().is_locked()) result.locked = i + 1;
        if (i < settled) continue;
        result.spread = std::max(result.spread, spread);
        result.follower = std::max(result.follower, std::chrono::abs(clock.control().error()).count());
    }
    return result;
}

std::vector<bench_slave> line(std::uint32_t seed) { return test::line_of(32, seed); }
std::vector<bench_slave> coarse(std::uint32_t seed) { return test::line_of(32, seed, 10); }
std::vector<bench_slave> hundred(std::uint32_t seed) { return test::line_of(100, seed, 10); }
// Each eighth slave begins a branch of four slaves, at port 3.
std::vector<bench_slave> tree(std::uint32_t seed) {
    auto slaves = test::line_of(32, seed, 10);
    for (std::size_t i = 8; i + 4 < slaves.size(); i += 8) {
        slaves[i].parent_port = 3;
        slaves[i + 4].parent = i - 1;
    }
    return slaves;
}
std::vector<bench_slave> gaps(std::uint32_t seed) {
    auto slaves = test::line_of(32, seed, 10);
    for (std::size_t i = 0; i < slaves.size(); i += 4) slaves[i].width = clock_width::no_clock;
    return slaves;
}
std::vector<bench_slave> mixed(std::uint32_t seed) {
    auto slaves = test::line_of(32, seed, 10);
    for (std::size_t i = 0; i < slaves.size(); i += 2) slaves[i].width = clock_width::bits_32;
    return slaves;
}

struct scenario {
    std::string_view name{};
    std::vector<bench_slave> (*slaves)(std::uint32_t seed){};
    int lost{cycles};
};
constexpr scenario scenarios[] = {
    {"32 slaves in a line, times in steps of 1 ns", line},
    {"the same, in steps of 10 ns", coarse},
    {"three branches of 4 of the 32 slaves", tree},
    {"8 of the 32 slaves without a clock, the first one too", gaps},
    {"16 clocks of 32 bits, the reference clock too", mixed},
    {"reference clock lost after 4 s", coarse, 4'000},
    {"100 slaves in a line", hundred},
};

} // namespace

// A line for each scenario: name; spread; error of the cycles; cycles to lock; longest delay; then the curve of the
// first seed, the largest value of each 20 cycles.
int main() {
    for (const auto& each : scenarios) {
        outcome worst;
        for (std::uint32_t seed = 1; seed != 6; ++seed) {
            const auto one = run(each.slaves(seed), seed, each.lost);
            worst.spread = std::max(worst.spread, one.spread);
            worst.follower = std::max(worst.follower, one.follower);
            worst.locked = std::max(worst.locked, one.locked);
            worst.delay = std::max(worst.delay, one.delay);
            if (seed == 1) worst.curve = one.curve;
        }
        std::cout << each.name << ';' << worst.spread << ';' << worst.follower << ';' << worst.locked << ';'
                  << worst.delay;
        for (auto at = worst.curve.begin(); at != worst.curve.end(); at += 20)
            std::cout << ';' << *std::max_element(at, at + 20);
        std::cout << '\n';
    }
}
