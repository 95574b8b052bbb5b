// Many slaves that are brought up at once: at the start, and after a loss.
#include "rig.hpp"

using namespace test;

namespace {

struct start {
    std::uint64_t frames{};
    std::chrono::nanoseconds time{};
};

/// Another user of the bus, who scans it once.
struct scanning {
    rig& r;
    bool is_wanted{true};
    std::size_t found{};

    explicit scanning(rig& of) : r{of} {
        r.bus.share({.begin = jaus::bound<&scanning::begin>(*this),
                     .done = jaus::bound<&scanning::done>(*this),
                     .cycle = jaus::bound<&scanning::cycle>(*this)});
    }
    scanning(const scanning&) = delete;
    scanning& operator=(const scanning&) = delete;
    bool begin(ethercat::master& idle) { return std::exchange(is_wanted, false) && idle.start(ethercat::scan{}); }
    void done(ethercat::master& idle) {
        found = idle.result<ethercat::scan>().value_or(0);
        CHECK(r.bus.is_cleared());
    }
    void cycle() {}
};

bool are_all_up(rig& r) { return std::ranges::all_of(r.fronts, &bridging::slave_front::up); }

start start_of(rig& r) {
    const auto before = r.frames;
    const auto took = r.run_until([&] { return are_all_up(r); });
    CHECK(r.watcher.failed_bring_ups == 0);
    CHECK(r.bus.statistics().foreign == 0);
    return {r.frames - before, took};
}

} // namespace

TEST_CASE("slaves by mailbox are brought up at once") {
    rig one, many{64};
    const auto single = start_of(one), all = start_of(many);
    CAPTURE(single.frames, all.frames, single.time.count(), all.time.count());
    CHECK(all.frames < 64 * single.frames / 4); // with a look at the place of each, and a stop order to each
    CHECK(all.time < 64 * single.time / 8);
}

TEST_CASE("cyclic slaves are brought up, configured and taken to OP at once") {
    rig one{1, true}, many{64, true};
    const auto single = start_of(one), all = start_of(many);
    CAPTURE(single.frames, all.frames, single.time.count(), all.time.count());
    CHECK(all.frames < 64 * single.frames / 4);
    CHECK(all.time < 64 * single.time / 4);
    CHECK(many.watcher.lost == 0);
    many.run_until_ready();
    many.run_until_acknowledged(many.drive(50, 63), 50ms);
}

TEST_CASE("slaves behind a cable that was out return at once, and are at rest") {
    rig r{32, true};
    r.run_until_ready();
    r.run_until_acknowledged(r.drive(50, 31));
    r.dead_from = 8;
    r.run_until([&] { return r.watcher.lost == 24; }, 200ms);
    r.run(2s);
    for (std::size_t i = 0; i != 8; ++i) CHECK(r.fronts[i].up());
    r.dead_from = 1000;
    const auto before = r.frames;
    const auto took = r.run_until([&] { return are_all_up(r); }, 2s);
    CAPTURE(r.frames - before, took.count());
    CHECK(took < r.options.bring_up_interval + 300ms);
    CHECK(r.watcher.lost == 24);
    r.run_until_ready();
    CHECK(r.motor(31).effort == 0);
}

TEST_CASE("a ring has as many slaves as it has places for") {
    rig r{2};
    bridging::ring_for<1, 1024> small{r.options};
    CHECK(small.add(r.fronts[0]));
    CHECK_FALSE(small.add(r.fronts[1]));
    small.remove(r.fronts[0], r.now);
    CHECK(small.add(r.fronts[1]));
}

TEST_CASE("a slave that does not change its state holds the others up once, not at each attempt") {
    const bool cyclic = GENERATE(false, true);
    rig r{4, cyclic};
    r.actuators[1].hangs = true;
    const auto state_timeout = r.options.master.state_timeout;
    const auto others_are_up = [&] { return r.fronts[0].up() && r.fronts[2].up() && r.fronts[3].up(); };
    CHECK(r.run_until(others_are_up) < state_timeout + 300ms);
    for (int i = 0; i != 3; ++i) {
        r.run(700ms);
        r.actuators[2].power_cycle();
        r.actuators[3].power_cycle();
        r.run_until([&] { return !r.fronts[2].up() && !r.fronts[3].up(); }, 200ms);
        CHECK(r.run_until(others_are_up) < state_timeout + 300ms); // the attempt that runs ends first
    }
    CHECK(r.fronts[0].up());
    r.actuators[1].hangs = false;
    r.run_until_ready();
}

TEST_CASE("a slave whose mailbox hangs is given up, and the others that are configured with it operate") {
    rig r{3, true};
    r.run_until([&] { return r.actuators[1].slave.state() == ethercat::al_state::pre_op; });
    r.actuators[1].hangs = true;
    r.run_until([&] { return r.fronts[0].up() && r.fronts[2].up(); });
    CHECK_FALSE(r.fronts[1].up());
    r.actuators[1].hangs = false;
    r.run_until_ready();
}

TEST_CASE("slaves that another user of the bus has scanned are cleared, and not scanned again") {
    rig r{2};
    scanning others{r};
    CHECK(!r.bus.is_cleared());
    r.run_until_ready();
    CHECK(others.found == 2);
}

TEST_CASE("slaves that another user of the bus scans while they work are lost at once, and brought up again") {
    const bool cyclic = GENERATE(false, true);
    rig r{3, cyclic};
    r.run_until_ready();
    for (std::size_t i = 0; i != 3; ++i) r.run_until_acknowledged(r.drive(50, i));
    scanning others{r};
    r.run_until([&] { return r.watcher.lost == 3; }, 100ms);
    CHECK(others.found == 3);
    r.run_until_ready();
    CHECK(are_all_up(r));
    CHECK(r.watcher.lost == 3);
    for (std::size_t i = 0; i != 3; ++i) {
        CHECK(r.motor(i).effort == 0);
        r.run_until_acknowledged(r.drive(50, i), 1s);
    }
}

TEST_CASE("a scan that finds no slave clears none: those that come later are cleared first") {
    rig r{2};
    r.dead_from = 0;
    r.run(1s);
    CHECK_FALSE(r.bus.is_cleared());
    r.dead_from = 1000;
    r.run_until_ready();
    CHECK(r.bus.is_cleared());
}

TEST_CASE("a slave that works is not brought up in place of one before it whose neighbour is removed") {
    const bool cyclic = GENERATE(false, true);
    for (unsigned frames = 1, is_up = 0; is_up == 0; ++frames) {
        rig r{3, cyclic};
        r.run_until_ready();
        r.actuators[1].power_cycle();
        r.run_until([&] { return r.watcher.lost == 1; });
        r.run_until([&, before = r.frames] { return r.frames - before >= frames || r.fronts[1].up(); });
        is_up = r.fronts[1].up();
        r.bus.remove(r.fronts[0], r.now);
        r.run_until([&] { return r.fronts[1].up(); }, 1s);
        r.run(100ms);
        CHECK(r.watcher.up == 4);
        CHECK(r.watcher.lost == 1);
        CHECK(r.fronts[2].up());
    }
}

TEST_CASE("a slave is removed while it is brought up with others") {
    rig r{3, true};
    const auto i = GENERATE(0u, 1u, 2u);
    const auto goal = GENERATE(ethercat::al_state::init, ethercat::al_state::pre_op, ethercat::al_state::safe_op);
    r.run(2ms);
    r.run_until([&] { return r.actuators[i].slave.state() >= goal; });
    r.bus.remove(r.fronts[i], r.now);
    r.run_until([&] {
        for (std::size_t k = 0; k != 3; ++k)
            if (k != i && !r.fronts[k].up()) return false;
        return true;
    });
    r.run(1s);
    CHECK_FALSE(r.fronts[i].up());
    CHECK(r.watcher.lost == 0);
}

TEST_CASE("a slave is brought up while another one before it is removed") {
    const bool cyclic = GENERATE(false, true);
    for (unsigned frames = 1, is_up = 0; is_up == 0; ++frames) {
        rig r{2, cyclic};
        r.run_until_ready();
        r.dead_from = 1;
        r.run_until([&] { return !r.fronts[1].up(); });
        r.actuators[1].power_cycle();
        r.dead_from = 2;
        r.run_until([&, before = r.frames] { return r.frames - before >= frames || r.fronts[1].up(); });
        is_up = r.fronts[1].up();
        const auto failed = r.watcher.failed_bring_ups;
        r.bus.remove(r.fronts[0], r.now);
        r.run_until([&] { return r.fronts[1].up(); }, 1s);
        CHECK(r.watcher.failed_bring_ups == failed);
    }
}

TEST_CASE("a slave that is removed while it is brought up gets no frame any more") {
    rig r{2};
    r.run_until([&] { return r.actuators[1].slave.state() == ethercat::al_state::pre_op && !r.fronts[1].up(); });
    r.bus.remove(r.fronts[1], r.now);
    std::size_t frames = 0;
    r.on_way_back = [&](std::span<std::byte> frame) {
        ethercat::mutable_frame_view view;
        REQUIRE(view.parse(frame));
        for (const auto each : view) {
            using enum ethercat::command;
            const auto how = each.header.cmd;
            const bool is_to_one = how == fprd || how == fpwr || how == fprw;
            if (is_to_one && each.header.adp == r.fronts[1].station()) ++frames;
        }
    };
    r.run_until([&] { return r.fronts[0].up(); });
    r.run(100ms);
    CHECK(frames == 0);
}
