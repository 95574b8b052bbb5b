// Slaves with SYNC signals of their distributed clocks.
#include "rig.hpp"

using namespace test;
using status = jaus::primary_status_code;

namespace {

/// In a line, with cables of 100 to 700 ns, clocks that are off by up to 100 ppm, and a master that is fast by 50 ppm.
class clock_rig {
  public:
    explicit clock_rig(std::size_t slaves, std::size_t without_clock = 1000)
        : r{slaves, true, {}, true, without_clock} {
        for (std::size_t i = 0; i != slaves; ++i) {
            set_error(i);
            wires_.push_back({.device = &r.actuators[i].slave,
                              .parent = i == 0 ? 0 : i - 1,
                              .cable = std::chrono::nanoseconds{100 + 100 * (i % 7)}});
        }
        connect();
    }
    /// Slaves from here on are not there.
    void disconnect(std::size_t from) { r.wires.emplace(std::span{wires_}.first(from), through); }
    void connect() { r.wires.emplace(wires_, through); }
    /// It was switched off and on.
    void power_cycle(std::size_t i) {
        r.actuators[i].power_cycle();
        set_error(i);
        connect();
    }
    /// What happens to the datagrams of each frame on its way back to the master.
    void on_way_back(auto change) {
        r.on_way_back = [change](std::span<std::byte> back) mutable {
            ethercat::mutable_frame_view view;
            REQUIRE(view.parse(back));
            for (auto each : view) change(each);
        };
    }
    /// The largest difference between any two system times.
    [[nodiscard]] std::int64_t spread() const {
        const auto at = r.now + 10us;
        const auto first = r.actuators.front().slave.clock().system_time(at);
        std::int64_t low = 0, high = 0;
        for (const auto& each : r.actuators) {
            const auto off = static_cast<std::int64_t>(each.slave.clock().system_time(at) - first);
            low = std::min(low, off);
            high = std::max(high, off);
        }
        return high - low;
    }
    [[nodiscard]] std::uint64_t missed() const {
        std::uint64_t sum = 0;
        for (const auto& each : r.actuators) sum += each.slave.sync_missed();
        return sum;
    }

    rig r;

  private:
    void set_error(std::size_t i) {
        const auto drift = static_cast<std::int32_t>((i * 37'000 + 20'000) % 200'000) - 100'000;
        r.actuators[i].slave.set_clock_error({.drift = drift, .start = 1'000'000'000 * (i + 1)});
    }
    static constexpr auto through = 300ns;
    std::vector<ethercat::wired_slave> wires_{};
};

} // namespace

TEST_CASE("slaves with SYNC signals operate once their clocks and the cycles follow the reference clock") {
    clock_rig bench{6};
    auto& r = bench.r;
    r.run_until_ready();
    CHECK(bench.spread() < 100);
    REQUIRE(r.bus.clocks());
    CHECK(r.bus.clocks()->control().is_locked());
    CHECK(r.watcher.failed_bring_ups == 0);
    CHECK(r.watcher.lost == 0);
    const auto missed = bench.missed();
    const auto before = r.actuators[5].slave.sync0_count();
    r.run(1s);
    CHECK(r.actuators[5].slave.sync0_count() - before >= 99);
    CHECK(bench.missed() == missed);
    CHECK(bench.spread() < 100);
    r.run_until_acknowledged(r.drive(50, 3), 100ms);
    CHECK(r.watcher.agreements.empty());
}

TEST_CASE("a slave that was switched off and on gets its clock back while the others go on") {
    clock_rig bench{6};
    auto& r = bench.r;
    r.run_until_ready();
    const auto i = GENERATE(0u, 2u, 5u); // the first one has the reference clock
    bench.power_cycle(i);
    r.run_until([&] { return r.watcher.lost == 1; }, 200ms);
    CHECK(r.unit(i).state() == status::failure);
    r.run_until([&] {
        for (std::size_t k = 1; k != 5; ++k)
            if (k != i) CHECK(r.fronts[k].up());
        return r.fronts[i].up();
    });
    CHECK(bench.spread() < 1'000);
    r.run(10s);
    CHECK(bench.spread() < 100);
    CHECK(r.watcher.lost == 1);
    CHECK(r.bus.clocks()->control().is_locked());
}

TEST_CASE("the cycles follow the reference clock until the last slave with SYNC signals is removed") {
    clock_rig bench{2};
    auto& r = bench.r;
    r.run_until_ready();
    r.bus.remove(r.fronts[1], r.now);
    REQUIRE(r.bus.clocks());
    r.run(1s);
    CHECK(r.fronts[0].up());
    CHECK(r.bus.clocks()->control().is_locked());
    r.bus.remove(r.fronts[0], r.now);
    CHECK(!r.bus.clocks());
}

TEST_CASE("a slave whose clock could not be set up is left out until the slaves are others") {
    std::array<ethercat::clock_record, 8> memory{};
    bridging::ring_clocks clocks{memory};
    std::array<ethercat::slave_record, 3> slaves{};
    for (std::uint16_t i = 0; i != slaves.size(); ++i) {
        slaves[i].position = i;
        slaves[i].station = static_cast<std::uint16_t>(2 + i);
    }
    const auto chosen = [&] {
        clocks.choose(slaves, [](const auto&) { return true; }, [](const auto&) { return false; });
        std::vector<std::uint16_t> stations;
        for (const auto& each : clocks.chosen()) stations.push_back(each.station);
        return stations;
    };
    using stations = std::vector<std::uint16_t>;
    CHECK(chosen() == stations{2, 3, 4});
    clocks.leave_out(3);
    CHECK(chosen() == stations{2, 4});
    clocks.leave_out(0); // an error of no slave
    CHECK(chosen() == stations{2, 4});
    clocks.leave_out(4);
    CHECK(chosen() == stations{2});
    clocks.leave_out_none();
    CHECK(chosen() == stations{2, 3, 4});
}

TEST_CASE("the cycles follow the reference clock anew when their period changes") {
    clock_rig bench{3};
    auto& r = bench.r;
    r.run_until_ready();
    r.options.period = 5ms;
    r.bus.apply_options();
    CHECK_FALSE(r.bus.clocks()->control().is_locked());
    r.run_until([&] { return r.bus.clocks()->control().is_locked(); });
    CHECK(bench.spread() < 100);
    CHECK(r.watcher.lost == 0);
}

TEST_CASE("slaves with SYNC signals come later, and the others go on") {
    clock_rig bench{6};
    auto& r = bench.r;
    bench.disconnect(4);
    r.run_until([&] { return r.fronts[3].up(); });
    bench.connect();
    r.run_until_ready();
    CHECK(bench.spread() < 1'000);
    r.run(10s);
    CHECK(bench.spread() < 100);
    CHECK(r.watcher.lost == 0);
}

TEST_CASE("a slave without a clock that is to have SYNC signals is refused, and the others operate") {
    clock_rig bench{3, 1};
    auto& r = bench.r;
    r.run_until([&] { return r.fronts[0].up() && r.fronts[2].up(); });
    CHECK_FALSE(r.fronts[1].up());
    CHECK(r.watcher.last_loss == bridging::loss::no_process_data);
    CHECK(r.bus.bring_up_error(r.fronts[1]).code == ethercat::master_errc::no_clock);
    CHECK(r.unit(1).state() != status::ready);
}

TEST_CASE(
    "a slave whose clock does not follow the reference clock is given up and tried again, and the others operate") {
    clock_rig bench{3};
    auto& r = bench.r;
    r.options.clock_timeout = 10s;
    r.bus.apply_options();
    bench.on_way_back([](auto& each) {
        if (each.header.cmd != ethercat::command::fprd || each.header.adp != 3 || each.header.ado != 0x092C) return;
        std::ranges::copy(std::array{std::byte{}, std::byte{}, std::byte{1}, std::byte{}}, each.data.begin());
    });
    r.run_until([&] { return r.fronts[0].up() && r.fronts[2].up() && r.watcher.lost >= 2; }, 60s);
    CHECK(r.watcher.last_loss == bridging::loss::no_process_data);
    const auto why = r.bus.bring_up_error(r.fronts[1]);
    CHECK(why.code == ethercat::master_errc::clock_unsettled);
    CHECK(why.station == 3);
    CHECK(why.nanoseconds == 65'536);
    CHECK(r.unit(1).state() != status::ready);
    CHECK(r.actuators[1].slave.state() == ethercat::al_state::pre_op);
    r.on_way_back = {};
    r.run_until([&] { return std::ranges::all_of(r.fronts, &bridging::slave_front::up); }, 60s);
    CHECK(bench.spread() < 1'000);
}

TEST_CASE("slaves with SYNC signals stay in SAFE-OP while the cycles do not follow the reference clock") {
    clock_rig bench{2};
    auto& r = bench.r;
    r.options.clock_timeout = 10s;
    r.bus.apply_options();
    // It seems to be fast by 1 %: no oscillator is.
    std::uint64_t gained = 0;
    bench.on_way_back([&gained](auto& each) {
        if (each.header.cmd != ethercat::command::frmw || each.header.ado != 0x0910) return;
        ethercat::dc_time time{};
        REQUIRE(jauscat::wire::decode(time, each.data));
        time.value += gained += 100'000;
        REQUIRE(jauscat::wire::encode(time, each.data));
    });
    bool was_safe_op = false;
    r.run_until(
        [&] {
            was_safe_op = was_safe_op || r.actuators[0].slave.state() == ethercat::al_state::safe_op;
            CHECK(r.actuators[0].slave.state() != ethercat::al_state::op);
            return r.watcher.lost >= 2;
        },
        60s);
    CHECK(was_safe_op);
    CHECK(r.watcher.up == 0);
    for (std::size_t i = 0; i != 2; ++i) {
        const auto why = r.bus.bring_up_error(r.fronts[i]);
        CHECK(why.code == ethercat::master_errc::clock_unsettled);
        CHECK(why.station == r.fronts[i].station());
    }
    r.on_way_back = {};
    r.run_until([&] { return std::ranges::all_of(r.fronts, &bridging::slave_front::up); }, 60s);
}

TEST_CASE("SYNC signals that are switched on too late are switched on anew, and the slave is tried again") {
    clock_rig bench{2};
    auto& r = bench.r;
    // Whenever the time is read again, more has passed than there was lead.
    std::uint64_t lost = 0;
    bool is_slow = true;
    bench.on_way_back([&](auto& each) {
        if (each.header.cmd != ethercat::command::fprd || each.header.ado != 0x0910 || !is_slow) return;
        ethercat::dc_time time{};
        REQUIRE(jauscat::wire::decode(time, each.data));
        time.value += lost += 3'000'000'000;
        REQUIRE(jauscat::wire::encode(time, each.data));
    });
    r.run_until([&] { return r.watcher.lost >= 1; });
    CHECK(r.watcher.last_loss == bridging::loss::no_process_data);
    CHECK(r.watcher.up == 0);
    CHECK(std::ranges::any_of(r.fronts, [&](const auto& each) {
        return r.bus.bring_up_error(each).code == ethercat::master_errc::sync_late;
    }));
    for (const auto& each : r.actuators) CHECK(each.slave.state() == ethercat::al_state::pre_op);
    is_slow = false;
    r.run_until_ready();
    CHECK(bench.spread() < 1'000);
    const auto before = r.actuators[1].slave.sync0_count();
    r.run(1s);
    CHECK(r.actuators[1].slave.sync0_count() - before >= 99);
}
