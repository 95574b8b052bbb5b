// Cycles of a master that follow the reference clock, differences watched, and what happens when that clock is lost; in
// simulated time.
#include "ethercat/clock_bench.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/ethercat/master/clock_cycle.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>
#include <vector>

using namespace jauscat::ethercat;
using namespace std::chrono_literals;
using jauscat::duration;
namespace test = jauscat::test;
using test::bench_slave;

namespace {

constexpr std::array one_word{pdo_entry{0x7000, 1, 16, 6, "effort"}};
constexpr slave_description drive{.vendor = 1, .outputs = one_word, .sync_missed_limit = 10};

// A master whose own clock is fast by `drift` ppm and whose frames start up to `jitter` late. Each cycle sends the
// clocks' frame and then the outputs of all slaves.
class cycles {
  public:
    cycles(std::span<const bench_slave> slaves, double drift, duration jitter)
        : bench{slaves, 300ns, drive}, drift_{drift * 1e-6}, jitter_{0, jitter.count()}, count_{slaves.size()} {
        bench.gap = 10us;
        for (std::size_t i = 0; i != count_; ++i) {
            const auto station = test::clock_bench::station(i);
            write(station, 0x0800, "0010 0001 26 00 01 00 0016 0001 22 00 01 00");
            write(station, 0x0120, "0200");
            write(station, 0x0810, "001c 0200 64 00 01 00");
            fmmu mapping{.logical_start = static_cast<std::uint32_t>(2 * i),
                         .length = 2,
                         .last_bit = 7,
                         .physical_start = 0x1C00,
                         .write = true,
                         .enable = true};
            frame_builder frame{buffer};
            frame.write(station, nth(esc_registers::fmmu, 0), mapping);
            bench.send(*frame.finish());
        }
        for (auto& each : bench.clocks) each.sync = {.assign_activate = 0x0300, .sync0_cycle = 1'000'000};
    }

    void write(std::uint16_t station, std::uint16_t ado, std::string_view hex) {
        frame_builder frame{buffer};
        frame.add(command::fpwr, station, ado, std::span<const std::byte>{test::from_hex(hex)});
        bench.send(*frame.finish());
    }
    void all_to(al_state state) {
        frame_builder frame{buffer};
        frame.write_all(esc_registers::al_control, {.state = state});
        bench.send(*frame.finish());
    }

    // Clocks, SYNC0, SAFE-OP; then the cycles begin.
    void set_up() {
        network = *bench.set_up();
        REQUIRE(bench.run(start_sync{.slaves = bench.clocks, .system_time = bench.system_time()}));
        all_to(al_state::safe_op);
        clocks.emplace_back(bench.clocks, network, bench.system_time());
        due_ = bench.now;
    }
    void cycle(bool loses_clock_frame = false, bool follows = true) {
        auto& clock = clocks.front();
        const auto at = std::max(bench.now, due_ + duration{jitter_(random_)} + (is_busy ? preempted() : duration{}));
        while (at - due_ > 500us) due_ += 1ms; // cycles that are left out, see cycle_timer
        bench.now = at;
        const auto size = clock.next_frame(buffer, at, at - due_);
        if (is_busy && one_of(20)) bench.now += duration{up_to(300'000)}; // which nobody knows
        if (size != 0) {
            const auto frame = std::span{buffer}.first(size);
            bench.send(frame);
            if (!loses_clock_frame) CHECK(clock.on_frame(frame));
        }
        frame_builder outputs{buffer};
        outputs.add(command::lwr, 0, 0, 2 * count_);
        bench.send(*outputs.finish());
        const auto correction = clock.end_cycle();
        const auto period = static_cast<double>((1ms + (follows ? correction : duration{})) / 1ns) * (1 - drift_);
        due_ += duration{static_cast<std::int64_t>(period)};
        worst_spread = std::max(worst_spread, bench.spread());
    }
    bool is_busy{}; // the machine: the master is preempted, before it looks at the time and after
    [[nodiscard]] std::uint64_t missed() {
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i != count_; ++i) sum += bench.device(i).sync_missed();
        return sum;
    }

    test::clock_bench bench;
    clock_network network{};
    std::vector<clock_cycle> clocks{}; // one
    std::int64_t worst_spread{};

  private:
    [[nodiscard]] std::int64_t up_to(std::int64_t most) {
        return std::uniform_int_distribution{std::int64_t{}, most}(random_);
    }
    [[nodiscard]] bool one_of(std::int64_t count) { return up_to(count - 1) == 0; }
    [[nodiscard]] duration preempted() {
        return duration{one_of(30) ? up_to(4'000'000) : one_of(4) ? up_to(400'000) : 0};
    }

    double drift_;
    std::uniform_int_distribution<std::int64_t> jitter_;
    std::mt19937 random_{5};
    std::size_t count_;
    jauscat::time_point due_{};
    std::array<std::byte, max_frame_size> buffer{};
};

} // namespace

TEST_CASE("cycles lock to the reference clock, and then no SYNC0 finds old outputs") {
    const auto drift = GENERATE(-100., 0., 100.);
    auto slaves = test::line_of(16, 21, 10);
    SECTION("64 bits") {}
    SECTION("a reference clock of 32 bits") { slaves[0].width = clock_width::bits_32; }
    SECTION("branches, and slaves without a clock") {
        slaves[3].width = slaves[9].width = slaves[15].width = clock_width::no_clock;
        slaves[8].parent = 2; // 3 to 7 are at port 3 of slave 2
        slaves[3].parent_port = 3;
    }
    cycles ring{slaves, drift, 10us};
    ring.set_up();
    auto& clock = ring.clocks.front();
    int cycles_to_lock = 0;
    while (!clock.control().is_locked() && cycles_to_lock != 5'000) {
        ring.cycle();
        ++cycles_to_lock;
    }
    CAPTURE(drift, cycles_to_lock);
    REQUIRE(clock.control().is_locked());
    CHECK(cycles_to_lock < 3'000);
    ring.all_to(al_state::op);
    ring.worst_spread = 0;
    duration worst{};
    for (int i = 0; i != 2'000; ++i) {
        ring.cycle();
        worst = std::max(worst, std::chrono::abs(clock.control().error()));
    }
    CHECK(ring.missed() == 0);
    CHECK(ring.bench.device(1).sync0_count() > 2'000);
    CHECK(ring.bench.device(1).state() == al_state::op);
    CHECK(worst < 15us); // the frames start up to 10 us late
    CHECK(ring.worst_spread < 100);
    CHECK(clock.is_complete());
    CHECK(clock.agreement() == clock_agreement::good);
    CHECK(clock.control().drift() == Approx(drift * 1'000 + slaves[0].error.drift * -1.).margin(15'000));
}

TEST_CASE("slaves miss outputs in cycles that do not follow the reference clock") {
    const auto slaves = test::line_of(4, 22);
    cycles ring{slaves, 150, 10us};
    ring.set_up();
    for (int i = 0; i != 2'000; ++i) ring.cycle();
    ring.all_to(al_state::op);
    for (int i = 0; i != 10'000; ++i) ring.cycle(false, false);
    CHECK(ring.missed() > 4);
}

TEST_CASE("cycles of a busy machine lock, and tell how late their frames are") {
    const auto slaves = test::line_of(8, 26);
    cycles ring{slaves, 60, 10us};
    ring.set_up();
    ring.is_busy = true;
    auto& clock = ring.clocks.front();
    int cycles_to_lock = 0;
    while (!clock.control().is_locked() && cycles_to_lock != 5'000) {
        ring.cycle();
        ++cycles_to_lock;
    }
    CAPTURE(cycles_to_lock);
    REQUIRE(clock.control().is_locked());
    CHECK(cycles_to_lock < 2'500);
    for (int i = 0; i != 3'000; ++i) {
        ring.cycle();
        REQUIRE(clock.control().is_locked());
    }
    CHECK(std::chrono::abs(clock.control().mean_error()) < 8us);
    CHECK(clock.control().deviation() > 30us);
    CHECK(clock.control().drift() == Approx(60'000 - slaves[0].error.drift).margin(15'000));
    // What the frames are late is no difference between the slaves.
    ring.worst_spread = 0;
    for (int i = 0; i != 1'000; ++i) ring.cycle();
    CHECK(ring.worst_spread < 100);
    ring.is_busy = false;
    for (int i = 0; i != 2'000; ++i) ring.cycle();
    CHECK(clock.control().deviation() < 10us);
}

TEST_CASE("the limits of a period above 1 ms are as many times wider") {
    constexpr auto of_20_ms = cycle_control_options::of_period(20ms);
    STATIC_REQUIRE(of_20_ms.phase == 10ms);
    STATIC_REQUIRE(of_20_ms.lock_within == 160us);
    STATIC_REQUIRE(of_20_ms.outlier == 3ms);
    constexpr auto of_250_us = cycle_control_options::of_period(250us);
    STATIC_REQUIRE(of_250_us.phase == 125us);
    STATIC_REQUIRE(of_250_us.lock_within == cycle_control_options{}.lock_within);
}

TEST_CASE("cycles that stay late or early are corrected as for a drift of 1000 ppm at most") {
    const std::int64_t late = GENERATE(1, -1); // early
    constexpr cycle_control_options options{};
    const auto frame_at = [&](duration error) {
        return static_cast<std::uint64_t>((options.period + options.phase + error).count());
    };
    cycle_control control{options};
    for (int i = 0; i != 1'000; ++i) static_cast<void>(control.on_time(frame_at(late * 100us)));
    CHECK(control.drift() == -late * 1'000'000);
    CHECK(control.on_missing() == -late * 1us);
    // It ends as fast as it has come.
    for (int i = 0; i != 50; ++i) static_cast<void>(control.on_time(frame_at(-late * 100us)));
    CHECK(control.drift() == late * 1'000'000);
}

TEST_CASE("lost frames are coasted over") {
    const auto slaves = test::line_of(8, 23);
    cycles ring{slaves, 100, 5us};
    ring.set_up();
    auto& clock = ring.clocks.front();
    for (int i = 0; i != 3'000; ++i) ring.cycle();
    REQUIRE(clock.control().is_locked());
    for (int i = 0; i != 100; ++i) ring.cycle(true);
    CHECK(clock.statistics().lost >= 99);
    CHECK(clock.reference() == 0); // silence of the wire is not that of the clock
    for (int i = 0; i != 10; ++i) ring.cycle();
    CHECK(std::chrono::abs(clock.control().error()) < 10us);
    CHECK(clock.control().is_locked());
}

TEST_CASE("when the reference clock is lost the next slave's takes its place, without a jump") {
    auto slaves = test::line_of(12, 24);
    slaves[1].width = clock_width::no_clock;
    slaves[4].width = clock_width::bits_32;
    cycles ring{slaves, 50, 5us};
    ring.set_up();
    auto& clock = ring.clocks.front();
    for (int i = 0; i != 3'000; ++i) ring.cycle();
    REQUIRE(clock.control().is_locked());
    ring.all_to(al_state::op);
    for (int i = 0; i != 10; ++i) ring.cycle();
    CHECK(clock.is_complete());

    ring.bench.device(0).power_on(); // its station address is gone
    std::int64_t worst = 0;
    for (int i = 0; i != 3'000; ++i) {
        ring.cycle();
        for (std::size_t n = 3; n != slaves.size(); ++n) worst = std::max(worst, std::abs(ring.bench.difference(n, 2)));
    }
    CHECK(clock.reference() == 2);
    CHECK(clock.statistics().takeovers == 1);
    CHECK(clock.control().is_locked());
    CHECK(ring.missed() == 0);
    CHECK(ring.bench.device(5).state() == al_state::op);
    CHECK(worst < 1'000);                               // three cycles of the master's estimate
    CHECK(clock.agreement() == clock_agreement::error); // slave 0 counts from its own start

    // Slave 0 is taken in again, and is the reference clock as before.
    std::array<std::byte, 60> buffer{};
    frame_builder frame{buffer};
    frame.add(command::apwr, 0, 0x0010, esc_word{test::clock_bench::station(0)});
    ring.bench.send(*frame.finish());
    for (auto& each : ring.bench.clocks) each.runs = &each != ring.bench.clocks.data();
    REQUIRE(ring.bench.run(set_up_clocks{
        .slaves = ring.bench.clocks, .system_time = clock.reference_time(), .options = {.drift_frames = 1'000}}));
    clock.set_reference(0);
    for (int i = 0; i != 2'000; ++i) ring.cycle();
    ring.worst_spread = 0;
    for (int i = 0; i != 500; ++i) ring.cycle();
    CHECK(ring.worst_spread < 100);
    CHECK(clock.agreement() == clock_agreement::good);
    CHECK(clock.reference() == 0);
}

TEST_CASE("without any clock left the frames end") {
    const auto slaves = test::line_of(2, 25);
    cycles ring{slaves, 0, 0us};
    ring.set_up();
    auto& clock = ring.clocks.front();
    for (int i = 0; i != 10; ++i) ring.cycle();
    ring.bench.device(0).power_on();
    ring.bench.device(1).power_on();
    for (int i = 0; i != 10; ++i) ring.cycle();
    CHECK(clock.is_lost());
    CHECK(clock.statistics().unanswered == 6);
    std::array<std::byte, max_frame_size> buffer{};
    CHECK(clock.next_frame(buffer, ring.bench.now) == 0);
}

TEST_CASE("the clocks' frame of a cycle, byte for byte") {
    const std::array clocks{clock_record{.station = 0x1001, .width = clock_width::bits_64}};
    clock_cycle cycle{clocks, {.reference = 0x1001, .working_counter = 1}, 0x1240};
    std::array<std::byte, 60> buffer{};
    REQUIRE(cycle.next_frame(buffer, {}) == 60);
    CHECK(test::to_hex(std::span{buffer}.subspan(14, 38)) ==
          "24 10 0e 01 01 10 10 09 08 80 00 00 40 12 00 00 00 00 00 00 00 00 07 01 00 00 2c 09 04 00 00 00 00 00 00 00 "
          "00 00");
    // Sign and magnitude: the bound is the magnitude.
    buffer[18] = std::byte{0x01};
    auto back = buffer;
    back[14 + 2 + 10] = std::byte{0x41};
    back[14 + 2 + 10 + 8] = std::byte{1};
    back[14 + 2 + 20 + 10] = std::byte{0x05};
    back[14 + 2 + 20 + 13] = std::byte{0x80};
    back[14 + 2 + 20 + 14] = std::byte{1};
    REQUIRE(cycle.on_frame(back));
    CHECK(cycle.reference_time() == 0x1241);
    CHECK(cycle.difference() == 5);
    CHECK(cycle.is_complete());
}
