// Distributed clocks: topology, delays, offsets and drift of emulated slaves on cables, in simulated time.
#include "ethercat/clock_bench.hpp"
#include "support/catch.hpp"

#include <array>
#include <cstdlib>
#include <vector>

using namespace jauscat::ethercat;
using namespace std::chrono_literals;
using jauscat::duration;
namespace test = jauscat::test;
using test::bench_slave;
using test::clock_bench;

namespace {

// A slave's open ports, and the local times at ports 0 to 3.
clock_record measured(std::array<bool, 4> open, std::array<std::uint32_t, 4> received) {
    return {.width = clock_width::bits_64, .open = open, .received = received};
}
constexpr std::array end{true, false, false, false}, line{true, true, false, false}, branch{true, true, false, true};

std::vector<std::uint32_t> delays_of(std::span<const clock_record> slaves) {
    std::vector<std::uint32_t> delays;
    for (const auto& each : slaves) delays.push_back(each.delay);
    return delays;
}

// The delay from slave 0 along the frame's way, by the lengths of the cables.
std::vector<std::uint32_t> true_delays(std::span<const bench_slave> slaves, duration through) {
    std::vector<std::uint32_t> arrival(slaves.size());
    std::int64_t now = 0;
    for (std::size_t i = 1; i != slaves.size(); ++i) {
        now += through.count();
        for (auto from = i - 1; from != slaves[i].parent; from = slaves[from].parent)
            now += (slaves[from].cable + through).count();
        now += slaves[i].cable.count();
        arrival[i] = static_cast<std::uint32_t>(now);
    }
    return arrival;
}

} // namespace

TEST_CASE("delays in a line are half of what the loop behind a slave takes longer than that behind the next one") {
    // Times wrap, and each slave has its own.
    std::array slaves{measured(line, {0xFFFFFF00, 0xFFFFFF00u + 5'000}), measured(line, {100, 100 + 3'600}),
                      measured(end, {77})};
    REQUIRE(find_parents(slaves));
    CHECK(slaves[2].parent == 1);
    REQUIRE(find_delays(slaves));
    CHECK(delays_of(slaves) == std::vector<std::uint32_t>{0, 700, 700 + 1'800});
}

TEST_CASE("delays behind a branch include the time in the earlier branches") {
    // Slave 0 has 1 at port 3 and, after it, 2 at port 1; slave 1 has 3... in order: 0, 1 (port 3), 2 (port 1).
    std::array slaves{measured(branch, {1'000, 6'000, 0, 3'000}), measured(end, {9}), measured(end, {9})};
    REQUIRE(find_parents(slaves));
    CHECK(slaves[1].parent_port == 3);
    CHECK(slaves[2].parent_port == 1);
    CHECK(slaves[2].parent == 0);
    REQUIRE(find_delays(slaves));
    CHECK(delays_of(slaves) == std::vector<std::uint32_t>{0, 1'000, 2'000 + 1'500});
}

TEST_CASE("a slave without a clock counts as cable") {
    std::array slaves{measured(line, {0, 4'000}), measured(line, {}), measured(end, {5})};
    slaves[1].width = clock_width::no_clock;
    REQUIRE(find_parents(slaves));
    REQUIRE(find_delays(slaves));
    CHECK(slaves[2].delay == 2'000);
}

TEST_CASE("what makes no tree of clocks is an error that names the slave") {
    std::array no_port{measured(end, {}), measured(end, {})};
    no_port[1].station = 5;
    CHECK(find_parents(no_port).error() == master_error{.code = master_errc::clock_topology, .station = 5});
    std::array no_ancestor{measured(branch, {}), measured(end, {}), measured(end, {})};
    no_ancestor[0].width = clock_width::no_clock;
    no_ancestor[2].station = 6;
    REQUIRE(find_parents(no_ancestor));
    CHECK(find_delays(no_ancestor).error() == master_error{.code = master_errc::clock_topology, .station = 6});
    std::array too_long{measured(line, {0, 400'000}), measured(end, {})};
    too_long[1].station = 7;
    REQUIRE(find_parents(too_long));
    CHECK(find_delays(too_long).error() ==
          master_error{.code = master_errc::clock_delay, .station = 7, .nanoseconds = 200'000});
}

TEST_CASE("a time of 32 bits is extended to the one nearest to an estimate") {
    CHECK(extend_time(5, 0x1'FFFF'FFF0) == 0x2'0000'0005);
    CHECK(extend_time(0xFFFFFFF0, 0x2'0000'0005) == 0x1'FFFF'FFF0);
    CHECK(extend_time(7, 7) == 7);
}

TEST_CASE("the master measures the delays of a line and of a tree as they are") {
    std::vector<bench_slave> slaves(9);
    for (std::size_t i = 0; i != slaves.size(); ++i)
        slaves[i] = {.parent = i == 0 ? 0 : i - 1,
                     .cable = duration{static_cast<std::int64_t>(50 + 70 * i)},
                     .error = {.start = i * 1'000'000'007}};
    SECTION("a line") {}
    SECTION("a cross with branches of 1, 2 and 3 slaves") {
        // 0 - 1: port 3: 2; port 1: 3 - 4; port 2: 5 - 6, which has 7 and 8 at ports 3 and 2.
        slaves[2].parent_port = 3;
        slaves[3].parent = 1;
        slaves[5].parent = 1;
        slaves[5].parent_port = 2;
        slaves[7].parent_port = 3;
        slaves[8].parent = 6;
        slaves[8].parent_port = 2;
    }
    SECTION("slaves without a clock") {
        slaves[0].width = slaves[3].width = slaves[4].width = clock_width::no_clock;
        slaves[8].width = clock_width::no_clock;
    }
    clock_bench bench{slaves};
    const auto network = bench.set_up({.drift_frames = 10});
    REQUIRE(network);
    auto expected = true_delays(slaves, 300ns);
    const auto reference = reference_clock(bench.clocks);
    for (std::size_t i = 0; i != slaves.size(); ++i) {
        CAPTURE(i);
        CHECK(bench.clocks[i].has_clock() == (slaves[i].width != clock_width::no_clock));
        if (bench.clocks[i].has_clock()) CHECK(bench.clocks[i].delay == expected[i] - expected[reference]);
    }
    CHECK(network->reference == clock_bench::station(reference));
    CHECK(bench.spread() <= 2);
}

TEST_CASE("32 clocks with drifts of 100 ppm and cables of 50 to 700 ns stay within 100 ns of each other") {
    const auto seed = GENERATE(1u, 2u, 3u);
    const auto step = GENERATE(1u, 10u);
    const auto slaves = test::line_of(32, seed, step);
    clock_bench bench{slaves};
    const auto network = bench.set_up();
    REQUIRE(network);
    CHECK(network->clocks == 32);
    CHECK(network->working_counter == 32);
    CHECK(network->difference < 100);
    CHECK(bench.spread() < 100);
    // Now one frame per cycle of 1 ms.
    bench.gap = 1ms - 45us;
    std::int64_t worst = 0;
    for (int i = 0; i != 3'000; ++i) {
        CHECK(bench.distribute(network->reference) == 32);
        worst = std::max(worst, bench.spread());
    }
    CAPTURE(seed, step, worst);
    CHECK(worst < 100);
}

TEST_CASE("SYNC0 of clocks of 32 and of 64 bits start together, at a multiple of the cycle plus the shift") {
    auto slaves = test::line_of(12, 7);
    for (std::size_t i = 0; i < slaves.size(); i += 3) slaves[i].width = clock_width::bits_32; // the reference, too
    slaves[4].width = clock_width::no_clock;
    clock_bench bench{slaves};
    bench.gap = 30us;
    for (std::size_t i = 0; i != slaves.size(); ++i)
        bench.clocks[i].sync = {.assign_activate = 0x0300, .sync0_cycle = 250'000};
    bench.clocks[5].sync = {.assign_activate = 0x0730, .sync0_cycle = 250'000, .sync1_delay = 250'000, .shift = 30us};
    bench.clocks[6].sync.assign_activate = 0;
    bench.clocks[7].sync.shift = -20us;
    const auto network = bench.set_up();
    REQUIRE(network);
    CHECK(network->reference_width == clock_width::bits_32);
    const auto begun = bench.system_time();
    const auto start = bench.run(start_sync{.slaves = bench.clocks, .system_time = begun});
    REQUIRE(start);
    CHECK(*start > begun + 99'000'000);
    CHECK(*start < begun + 102'000'000);
    CHECK(bench.clocks[1].start_time % 250'000 == 0);
    CHECK(bench.clocks[5].start_time % 500'000 == 30'000); // its period is that of SYNC1
    CHECK((bench.clocks[7].start_time + 20'000) % 250'000 == 0);
    for (std::size_t i = 0; i != slaves.size(); ++i) {
        CAPTURE(i);
        auto& device = bench.device(i);
        if (i == 4 || i == 6) {
            CHECK_FALSE(device.clock().activation().on);
            continue;
        }
        CHECK(device.clock().activation().sync0);
        CHECK(device.clock().activation().sync1 == (i == 5));
        CHECK(device.clock().activation_status().sync0_pending);
    }
    bench.gap = 250us;
    while (bench.system_time() < *start + 100'000'000) bench.distribute(network->reference);
    // Half a cycle after a SYNC0 all have had as many.
    for (std::size_t i = 0; i != slaves.size(); ++i) {
        if (i == 4 || i == 6) continue;
        CAPTURE(i);
        const auto& clock = bench.device(i).clock();
        const auto low =
            static_cast<std::uint32_t>(clock.next_sync0()) - static_cast<std::uint32_t>(bench.clocks[i].start_time);
        CHECK(low % 250'000 == 0);
        CHECK(bench.device(i).sync0_count() == low / 250'000);
        CHECK(low / 250'000 > 398);
    }
    CHECK(bench.spread() < 100);
}

TEST_CASE("the period of the outputs is that of SYNC1 only if SYNC1 is on") {
    const auto period = [](std::uint16_t assign_activate) {
        return sync_settings{.assign_activate = assign_activate, .sync0_cycle = 250'000, .sync1_delay = 600'000}
            .period();
    };
    CHECK(period(0x0300) == 250'000);
    CHECK(period(0x0700) == 750'000);
}

TEST_CASE("a start time that would be over before SYNC is on is put off") {
    const auto slaves = test::line_of(30, 9);
    clock_bench bench{slaves};
    for (auto& each : bench.clocks) each.sync = {.assign_activate = 0x0300, .sync0_cycle = 62'500};
    REQUIRE(bench.set_up({.drift_frames = 2'000}));
    const auto begun = bench.system_time();
    const auto start = bench.run(start_sync{.slaves = bench.clocks, .lead = 100us}); // ten frames take longer
    REQUIRE(start);
    CHECK(*start > begun + 1'000'000);
    for (std::size_t i = 0; i != slaves.size(); ++i) CHECK(bench.device(i).clock().activation_status().sync0_pending);
}

TEST_CASE("setting clocks up leaves running slaves' offsets alone, and the others follow them") {
    const auto slaves = test::line_of(6, 11);
    clock_bench bench{slaves};
    REQUIRE(bench.set_up());
    std::vector<std::int64_t> offsets;
    for (const auto& each : bench.clocks) offsets.push_back(each.offset);
    bench.device(3).power_on(); // it comes back
    bench.device(3).set_clock_error({.drift = 50'000, .start = 42});
    std::array<std::byte, 60> buffer{};
    frame_builder address{buffer};
    address.add(command::apwr, static_cast<std::uint16_t>(-3), 0x0010, esc_word{clock_bench::station(3)});
    bench.send(*address.finish());
    for (std::size_t i = 0; i != slaves.size(); ++i) bench.clocks[i].runs = i != 3;
    REQUIRE(bench.set_up());
    for (std::size_t i = 0; i != slaves.size(); ++i) CHECK((bench.clocks[i].offset == offsets[i]) == (i != 3));
    CHECK(bench.spread() < 100);
}

TEST_CASE("jobs for clocks say why they cannot") {
    const std::vector<bench_slave> none{{.width = clock_width::no_clock}};
    clock_bench without{none};
    CHECK(without.set_up().error() == master_error{.code = master_errc::no_clock});
    CHECK(without.run(start_sync{.slaves = without.clocks}).error() == master_error{.code = master_errc::no_clock});
    CHECK(without.run(set_up_clocks{}).error() == master_error{.code = master_errc::no_clock});

    const auto slaves = test::line_of(3, 13);
    clock_bench bench{slaves};
    const auto unsettled = bench.set_up({.drift_frames = 5, .limit = 0, .repeats = 2});
    CHECK(unsettled.error().code == master_errc::clock_unsettled);
    CHECK(unsettled.error().nanoseconds > 0);
    REQUIRE(bench.set_up());
    for (auto& each : bench.clocks) each.sync = {.assign_activate = 0x0300, .sync0_cycle = 250'000};
    bench.gap = 1s; // more than the time that is left until the start, even when it is doubled
    CHECK(bench.run(start_sync{.slaves = bench.clocks, .system_time = bench.system_time()}).error() ==
          master_error{.code = master_errc::sync_late});
    bench.gap = 20us;
    bench.clocks[2].station = 0x2000;
    CHECK(bench.set_up().error().code == master_errc::working_counter);
}
