// One axis: the way of its states, targets within limits, and what brings it to rest.
#include "cia402/plain_drive.hpp"
#include "support/catch.hpp"

#include <cstdlib>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

using namespace jauscat;
using namespace jauscat::cia402;
using namespace std::chrono_literals;

namespace {

using test::plain_drive;

/// An axis and its drive on a bus of 1 ms.
struct rig {
    plain_drive drive{};
    axis mine{};
    time_point now{};

    constexpr rig() = default;
    explicit constexpr rig(const axis_options& options) : mine{options} {}

    constexpr void cycle(int count = 1) {
        for (int i = 0; i != count; ++i) {
            now += 1ms;
            drive.take(mine.on_cycle(drive.feedback, now));
        }
    }
    constexpr bool enable(mode m) {
        mine.set_mode(m);
        const bool taken = mine.enable().has_value();
        cycle(6);
        return taken && mine.state() == axis_state::enabled;
    }
    /// The drive is where it was told to be.
    constexpr void follow(int count) {
        for (int i = 0; i != count; ++i) {
            cycle();
            drive.feedback.position = mine.targets().position;
            drive.feedback.velocity = mine.targets().velocity;
        }
    }
};

/// Whether all values up to `last` have a text, which differs from those of the others.
template <class Enum> bool are_described(Enum last) {
    const auto count = static_cast<unsigned>(last) + 1;
    std::set<std::string_view> texts{""};
    for (unsigned i = 0; i != count; ++i) texts.insert(describe(static_cast<Enum>(i)));
    return texts.size() == count + 1;
}

constexpr axis_options slow{.max_velocity = 1000, .acceleration = 10'000, .deceleration = 10'000, .standstill = 0};

/// It turns at 500/s.
rig turning() {
    rig r{slow};
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    REQUIRE(r.mine.run_at(500));
    r.follow(60);
    return r;
}

} // namespace

TEST_CASE("every error and state of an axis, and all that it waits for, has a text of its own") {
    CHECK(are_described(axis_errc::has_failed));
    CHECK(are_described(axis_state::failed));
    CHECK(are_described(axis_wait::reset));
    CHECK(describe(axis_error{.code = axis_errc::inputs_lost}) == describe(axis_errc::inputs_lost));
}

TEST_CASE("an axis is enabled by one command for each observed status") {
    rig r;
    r.mine.set_mode(mode::cyclic_synchronous_velocity);
    CHECK(r.mine.state() == axis_state::unknown);
    r.cycle();
    CHECK(r.mine.state() == axis_state::disabled);
    REQUIRE(r.mine.enable());
    std::vector<int> words;
    for (int i = 0; i != 5; ++i) {
        r.cycle();
        words.push_back(r.mine.targets().controlword);
    }
    CHECK(words == std::vector{0x06, 0x07, 0x0F, 0x0F, 0x0F});
    CHECK(r.mine.state() == axis_state::enabled);
}

TEST_CASE("an axis is enabled at compile time too") {
    STATIC_REQUIRE([] {
        rig r;
        return r.enable(mode::cyclic_synchronous_position) && r.mine.move_to(1000).has_value() &&
               (r.follow(100), r.mine.is_target_reached()) && r.drive.feedback.position == 1000;
    }());
}

TEST_CASE("a drive that does not take the next state fails the axis in time") {
    rig r;
    r.drive.stuck = true;
    r.mine.set_mode(mode::cyclic_synchronous_velocity);
    REQUIRE(r.mine.enable());
    r.cycle(2000);
    CHECK(r.mine.state() == axis_state::enabling);
    r.cycle(2);
    CHECK(r.mine.state() == axis_state::failed);
    CHECK(r.mine.error() == axis_error{axis_errc::step_timeout, state::switch_on_disabled});
    CHECK(r.mine.enable().error() == axis_errc::has_failed);
}

TEST_CASE("an axis that was disabled for longer than the step time is enabled as usual") {
    rig r;
    r.cycle(3000);
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    CHECK(r.mine.error().code == axis_errc::ok);
}

TEST_CASE("a motion begins with the acceleration and ends with the deceleration, in both directions") {
    constexpr motion_limits limits{.velocity = 100, .acceleration = 10, .deceleration = 40};
    for (const double direction : {1, -1}) {
        motion_profile profile;
        profile.step_at(direction * 100, limits, 1);
        CHECK(profile.velocity() == direction * 10);
        profile.reset(0, direction * 100);
        profile.step_at(0, limits, 1);
        CHECK(profile.velocity() == direction * 60);
    }
}

TEST_CASE("a cyclic position starts where the axis is, until the drive follows") {
    rig r;
    r.drive.feedback.position = 123'456;
    r.drive.bits = 0; // operation enabled, but bit 12 is not set
    r.mine.set_mode(mode::cyclic_synchronous_position);
    REQUIRE(r.mine.enable());
    for (int i = 0; i != 20; ++i) {
        r.cycle();
        CHECK(r.mine.targets().position == r.drive.feedback.position);
        ++r.drive.feedback.position; // somebody moves it
    }
    CHECK(r.mine.state() == axis_state::enabling);
    CHECK(r.mine.move_to(0).error() == axis_errc::not_enabled);
    r.drive.bits = status_bits::follows_target;
    r.cycle(2);
    CHECK(r.mine.state() == axis_state::enabled);
    CHECK(std::abs(r.mine.targets().position - r.drive.feedback.position) <= 1);
}

TEST_CASE("the targets of an axis that turns stay where its drive is, until that follows them in a new mode") {
    rig r = turning();
    r.mine.set_mode(mode::cyclic_synchronous_position);
    r.follow(2);
    REQUIRE(r.drive.feedback.mode == mode::cyclic_synchronous_position);
    REQUIRE(r.drive.feedback.velocity > 400);
    r.drive.bits = 0;
    const auto held_at = r.drive.feedback.position;
    r.cycle(2); // the status tells it a cycle later
    while (r.drive.feedback.velocity > 0) {
        r.drive.feedback.velocity -= 50;
        r.cycle();
        CHECK(std::abs(r.mine.targets().position - held_at) <= 1);
    }
    r.drive.bits = status_bits::follows_target;
    r.cycle(2);
    CHECK(r.mine.state() == axis_state::enabled);
    CHECK(r.mine.targets().position == held_at);
}

TEST_CASE("an axis that is disabled while it changes from velocities to positions brakes from where it is") {
    rig r{slow};
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    REQUIRE(r.mine.run_at(500));
    for (int i = 0; i != 200; ++i) { // the shaft is held
        r.cycle();
        r.drive.feedback.position = 7;
    }
    r.mine.set_mode(mode::cyclic_synchronous_position);
    r.mine.disable();
    for (int i = 0; i != 20; ++i) {
        r.cycle();
        CHECK(std::abs(r.mine.targets().position - 7) <= 1);
    }
}

TEST_CASE("the targets of an axis stay where its drive is, if that does not follow them while the axis stops") {
    rig r{slow};
    REQUIRE(r.enable(mode::cyclic_synchronous_position));
    REQUIRE(r.mine.move_to(100'000));
    r.follow(100);
    r.drive.bits = 0;
    const auto held_at = r.drive.feedback.position;
    r.cycle(2); // the status tells it a cycle later
    r.mine.disable();
    for (int velocity = 1000; velocity > 0; velocity -= 100) {
        r.drive.feedback.velocity = velocity;
        r.cycle();
        CHECK(std::abs(r.mine.targets().position - held_at) <= 1);
    }
}

TEST_CASE("a drive that never follows fails the axis") {
    rig r;
    r.drive.bits = 0;
    r.mine.set_mode(mode::cyclic_synchronous_position);
    REQUIRE(r.mine.enable());
    r.cycle(2010);
    CHECK(r.mine.error().code == axis_errc::not_following);
    CHECK(r.drive.state != state::operation_enabled);
}

TEST_CASE("a cyclic position moves within the limits and ends exactly") {
    auto options = slow;
    options.min_position = -500;
    options.max_position = 500;
    rig r{options};
    REQUIRE(r.enable(mode::cyclic_synchronous_position));
    const auto accepted = r.mine.move_to(9999);
    REQUIRE(accepted);
    CHECK(*accepted == acceptance::limited);
    double fastest = 0, before = 0, last_velocity = 0;
    for (int i = 0; i != 1000; ++i) {
        r.follow(1);
        const double velocity = r.mine.targets().position - before;
        before = r.mine.targets().position;
        fastest = std::max(fastest, velocity);
        CHECK(std::abs(r.mine.targets().velocity - last_velocity) <= 12); // 10 a cycle, and rounding
        last_velocity = r.mine.targets().velocity;
    }
    CHECK(fastest <= 2); // 1 an ms, rounded
    CHECK(r.mine.targets().position == 500);
    CHECK(r.mine.is_target_reached());
    const auto within = r.mine.move_to(-500);
    REQUIRE(within);
    CHECK(*within == acceptance::exact);
    CHECK(!r.mine.is_target_reached()); // also before it moves
}

TEST_CASE("a cyclic velocity follows a ramp, and stops before a position limit") {
    auto options = slow;
    options.max_position = 1000;
    rig r{options};
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    REQUIRE(r.mine.run_at(800));
    r.cycle();
    CHECK(r.mine.targets().velocity == 10);
    r.cycle(100);
    CHECK(r.mine.targets().velocity == 800);
    double at = 0;
    for (int i = 0; i != 3000; ++i) {
        r.cycle();
        at += r.mine.targets().velocity / 1000.0;
        r.drive.feedback.position = static_cast<int>(at);
    }
    CHECK(r.mine.targets().velocity == 0);
    CHECK(at > 990);
    CHECK(at <= 1001);
    REQUIRE(r.mine.run_at(-100));
    r.cycle(50);
    CHECK(r.mine.targets().velocity == -100); // inwards
}

TEST_CASE("a torque is limited, follows its slope, and does not push out of the range") {
    rig r{{.min_position = -100, .max_position = 100, .max_torque = 500, .torque_slope = 10'000}};
    REQUIRE(r.enable(mode::cyclic_synchronous_torque));
    const auto accepted = r.mine.push_with(900);
    REQUIRE(accepted);
    CHECK(*accepted == acceptance::limited);
    r.cycle();
    CHECK(r.mine.targets().torque == 10);
    r.cycle(60);
    CHECK(r.mine.targets().torque == 500);
    r.drive.feedback.position = 100;
    r.cycle(60);
    CHECK(r.mine.targets().torque == 0);
    r.drive.feedback.position = 0;
    r.cycle(60);
    CHECK(r.mine.targets().torque == 500);
    r.drive.feedback.velocity = 1'000'000; // max_velocity
    r.cycle(60);
    CHECK(r.mine.targets().torque == 0);
    REQUIRE(r.mine.push_with(-500));
    r.cycle(60);
    CHECK(r.mine.targets().torque == -500); // against the velocity
    r.drive.feedback.velocity = 0;
    r.drive.feedback.position = -100;
    r.cycle(60);
    CHECK(r.mine.targets().torque == 0);
}

TEST_CASE("an axis beyond its range pushes back into it") {
    auto options = slow;
    options.min_position = -500;
    options.max_position = 500;
    for (const int direction : {1, -1}) {
        rig r{options};
        r.drive.feedback.position = -600 * direction;
        REQUIRE(r.enable(mode::cyclic_synchronous_torque));
        const auto torque = static_cast<std::int16_t>(50 * direction);
        REQUIRE(r.mine.push_with(torque));
        CHECK(!r.mine.is_target_reached());
        r.cycle(60);
        CHECK(r.mine.targets().torque == torque);
        CHECK(r.mine.is_target_reached());
    }
}

TEST_CASE("disable brings the axis to rest by ramp before it takes the torque away") {
    rig r = turning();
    r.mine.disable();
    r.follow(20);
    CHECK(r.mine.state() == axis_state::stopping);
    CHECK(r.drive.state == state::operation_enabled);
    CHECK(r.mine.targets().velocity == 300);
    r.follow(40);
    CHECK(r.drive.state == state::switch_on_disabled);
    CHECK(r.mine.state() == axis_state::disabled);
    CHECK(r.mine.run_at(1).error() == axis_errc::not_enabled);
}

TEST_CASE("an axis at rest whose profile is the drive's is disabled at once") {
    for (const auto each : {mode::profile_position, mode::profile_velocity, mode::homing}) {
        rig r{slow};
        REQUIRE(r.enable(each));
        r.cycle(10);
        r.mine.disable();
        r.cycle(10);
        CHECK(r.drive.state == state::switch_on_disabled);
        CHECK(r.mine.state() == axis_state::disabled);
    }
}

TEST_CASE("disable does not enable the drive again while its status is late") {
    rig r{slow};
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    r.mine.disable();
    r.drive.stuck = true; // its status comes some cycles later
    r.cycle();
    CHECK(r.mine.targets().controlword == 0x07);
    r.drive.feedback.velocity = 20; // settles
    for (int i = 0; i != 3; ++i) {
        r.cycle();
        CHECK(r.mine.targets().controlword == 0x07);
    }
    r.drive.stuck = false;
    r.cycle(3);
    CHECK(r.mine.state() == axis_state::disabled);
}

TEST_CASE("a ramp that does not bring the axis to rest in time ends in a quick stop") {
    rig r = turning();
    r.mine.disable();
    r.cycle(2010); // the drive goes on turning
    CHECK(r.drive.state == state::quick_stop_active);
    CHECK(r.mine.error().code == axis_errc::ok);
    r.cycle(1980); // the quick stop has the step time
    CHECK(r.mine.error().code == axis_errc::ok);
    r.cycle(20);
    CHECK(r.mine.error() == axis_error{axis_errc::step_timeout, state::quick_stop_active});
}

TEST_CASE("quick stop goes out in the same cycle") {
    rig r = turning();
    r.mine.quick_stop();
    r.cycle();
    CHECK(r.mine.targets().controlword == 0x02);
    CHECK(r.mine.targets().velocity == 0);
    CHECK(r.drive.state == state::quick_stop_active);
    r.cycle(10);
    CHECK(r.drive.state == state::quick_stop_active); // the drive decides when it leaves
    CHECK(r.mine.state() == axis_state::stopping);
    r.drive.feedback.velocity = 0;
    REQUIRE(r.mine.enable());
    r.cycle(8);
    CHECK(r.mine.state() == axis_state::enabled);
    CHECK(r.mine.targets().velocity == 0); // the old target is gone
}

TEST_CASE("a quick stop is its command alone, in each mode") {
    for (const auto each : {mode::profile_position, mode::profile_velocity, mode::homing,
                            mode::cyclic_synchronous_position, mode::cyclic_synchronous_torque}) {
        rig r{slow};
        REQUIRE(r.enable(each));
        r.mine.quick_stop();
        r.cycle();
        CHECK(r.mine.targets().controlword == control_of(command::quick_stop));
    }
}

TEST_CASE("a drive that stays in a state without torque is told to stop on, and its axis has no error") {
    for (const auto each : {state::ready_to_switch_on, state::quick_stop_active}) {
        rig r{slow};
        REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
        r.drive.state = each;
        r.drive.stuck = true;
        r.drive.show();
        if (each == state::ready_to_switch_on)
            r.mine.quick_stop();
        else
            r.mine.disable();
        r.cycle(10'000);
        CHECK(r.mine.error().code == axis_errc::ok);
        CHECK(r.mine.targets().controlword ==
              control_of(each == state::ready_to_switch_on ? command::quick_stop : command::disable_voltage));
    }
}

TEST_CASE("a quick stop that does not bring the axis to rest in time fails it, and goes on") {
    rig r = turning();
    r.mine.quick_stop();
    r.cycle(2000); // the drive goes on turning
    CHECK(r.mine.error().code == axis_errc::ok);
    r.cycle();
    CHECK(r.mine.error() == axis_error{axis_errc::step_timeout, state::quick_stop_active});
    CHECK(r.mine.targets().controlword == control_of(command::quick_stop));
}

TEST_CASE("a ramp that would take longer than its time is a quick stop at once, and any other one is not") {
    const auto [velocity, word] = GENERATE(table<int, int>({{500, 0x0F}, {510, 0x02}}));
    auto options = slow; // 50 ms from 500
    options.ramp_time = 50ms;
    rig r{options};
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    REQUIRE(r.mine.run_at(velocity));
    r.follow(60);
    CHECK(r.drive.feedback.velocity == velocity);
    r.mine.disable();
    r.cycle();
    CHECK(r.mine.targets().controlword == word);
}

TEST_CASE("a ramp that the drive does not follow in its time becomes a quick stop") {
    auto options = slow;
    options.ramp_time = 50ms;
    rig r{options};
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    REQUIRE(r.mine.run_at(300));
    r.follow(60);
    r.mine.disable();
    r.cycle(45); // goes on at 300
    CHECK(r.mine.targets().controlword == 0x0F);
    r.cycle(6);
    CHECK(r.mine.targets().controlword == 0x02);
    CHECK(r.mine.error().code == axis_errc::ok);
}

TEST_CASE("an axis that is enabled while an earlier command is on the way to the drive does not fail") {
    const int delay = GENERATE(0, 1, 2); // cycles
    rig r;
    std::vector<axis_targets> on_the_way;
    const auto send = [&](const axis_targets& targets) {
        on_the_way.push_back(targets);
        if (static_cast<int>(on_the_way.size()) <= delay) return;
        r.drive.take(on_the_way.front());
        on_the_way.erase(on_the_way.begin());
    };
    const auto cycle = [&](int count) {
        for (int i = 0; i != count; ++i) send(r.mine.on_cycle(r.drive.feedback, r.now += 1ms));
    };
    r.mine.set_mode(mode::cyclic_synchronous_velocity);
    for (int off = 1; off != 12; ++off) {
        REQUIRE(r.mine.enable());
        cycle(20);
        REQUIRE(r.mine.state() == axis_state::enabled);
        r.mine.disable();
        cycle(off);
    }
    REQUIRE(r.mine.enable());
    cycle(20);
    r.now += 1ms;
    send(r.mine.on_lost()); // a quick stop
    r.mine.reset();
    REQUIRE(r.mine.enable());
    cycle(20);
    CHECK(r.mine.error().code == axis_errc::ok);
    CHECK(r.mine.state() == axis_state::enabled);
}

TEST_CASE("an axis that was stopped while it changed its mode begins with the velocity of the motor") {
    rig r{slow};
    REQUIRE(r.enable(mode::cyclic_synchronous_position));
    REQUIRE(r.mine.move_to(100'000));
    r.follow(60);
    r.mine.set_mode(mode::cyclic_synchronous_velocity);
    r.mine.quick_stop();
    r.drive.feedback.velocity = 0;
    r.cycle(10);
    REQUIRE(r.mine.enable());
    while (r.drive.state != state::switched_on && r.now < time_point{1s}) r.cycle();
    r.drive.feedback.velocity = 500; // its load turns it
    while (r.mine.targets().velocity == 0 && r.now < time_point{1s}) r.cycle();
    CHECK(r.mine.targets().velocity == 490);
}

TEST_CASE("an axis that is enabled while its quick stop is on the way sends no velocity until that has shown") {
    rig r = turning();
    r.mine.quick_stop();
    r.drive.stuck = true; // its status follows later
    r.cycle();
    REQUIRE(r.mine.enable());
    r.cycle();
    CHECK(r.mine.state() == axis_state::enabling);
    CHECK(r.mine.targets().velocity == 0);
}

TEST_CASE("a drive that leaves operation enabled again and again fails the axis in time") {
    rig r;
    r.mine.set_mode(mode::cyclic_synchronous_velocity);
    REQUIRE(r.mine.enable());
    bool was_enabled = false;
    for (int i = 0; i != 8010 && r.mine.error().code == axis_errc::ok; ++i) {
        r.cycle();
        if (!std::exchange(was_enabled, r.drive.state == state::operation_enabled)) continue;
        r.drive.state = state::switch_on_disabled; // it was enabled for one cycle
        r.drive.show();
    }
    CHECK(r.mine.error().code == axis_errc::step_timeout);
    CHECK(r.now < time_point{8100ms});
}

TEST_CASE("a drive that does not obey the quick stop fails the axis") {
    rig r{slow};
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    r.drive.stuck = true;
    r.mine.quick_stop();
    r.cycle(2010);
    CHECK(r.mine.error() == axis_error{axis_errc::step_timeout, state::operation_enabled});
    CHECK(r.mine.targets().controlword == 0x00);
}

TEST_CASE("halt brings the axis to rest and keeps it enabled") {
    rig r = turning();
    r.mine.halt(true);
    r.follow(60);
    CHECK(r.mine.targets().velocity == 0);
    CHECK(r.drive.state == state::operation_enabled);
    CHECK(r.mine.run_at(1).error() == axis_errc::not_enabled);
    r.mine.halt(false);
    r.follow(60);
    CHECK(r.mine.targets().velocity == 0);
}

TEST_CASE("an axis that is halted on its way has reached its target once it stands still") {
    rig r{slow};
    REQUIRE(r.enable(mode::cyclic_synchronous_position));
    REQUIRE(r.mine.move_to(100'000));
    r.follow(60);
    r.mine.halt(true);
    r.follow(1);
    CHECK(r.mine.targets().velocity > 0);
    CHECK(!r.mine.is_target_reached());
    r.follow(200);
    CHECK(r.mine.targets().velocity == 0);
    CHECK(r.mine.is_target_reached());
}

TEST_CASE("set-points are rounded to the nearest unit, in both directions") {
    auto options = slow;
    options.acceleration = 700; // 0.7 in the first cycle
    for (const int direction : {1, -1}) {
        rig r{options};
        REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
        REQUIRE(r.mine.run_at(100 * direction));
        r.cycle();
        CHECK(r.mine.targets().velocity == direction);
    }
}

TEST_CASE("after a halt an axis pushes with nothing until it is told to") {
    rig r{{.max_torque = 500, .torque_slope = 100'000}};
    REQUIRE(r.enable(mode::cyclic_synchronous_torque));
    REQUIRE(r.mine.push_with(500));
    r.cycle(20);
    CHECK(r.mine.targets().torque == 500);
    r.mine.halt(true);
    r.cycle(20);
    CHECK(r.mine.targets().torque == 0);
    r.mine.halt(false);
    r.cycle(20);
    CHECK(r.mine.targets().torque == 0);
}

TEST_CASE("a drive that turns by its own profile is halted before it is disabled") {
    rig r{slow};
    REQUIRE(r.enable(mode::profile_velocity));
    REQUIRE(r.mine.run_at(500));
    r.follow(2);
    r.mine.disable();
    r.cycle();
    CHECK(r.drive.state == state::operation_enabled);
    CHECK((r.mine.targets().controlword & control_bits::halt) != 0);
}

TEST_CASE("halt sets its bit in profile modes") {
    rig r{slow};
    REQUIRE(r.enable(mode::profile_velocity));
    REQUIRE(r.mine.run_at(500));
    r.cycle();
    CHECK(r.mine.targets().velocity == 500);
    CHECK((r.mine.targets().controlword & control_bits::halt) == 0);
    r.mine.halt(true);
    r.cycle();
    CHECK((r.mine.targets().controlword & control_bits::halt) != 0);
    r.mine.set_mode(mode::homing);
    r.cycle(6);
    CHECK((r.mine.targets().controlword & control_bits::halt) != 0);
    r.mine.halt(false);
    r.cycle();
    CHECK((r.mine.targets().controlword & control_bits::halt) == 0);
}

TEST_CASE("a fault is reported with its code and reset by the edge of its bit") {
    rig r = turning();
    r.drive.fail(error_codes::over_current);
    r.cycle();
    CHECK(r.mine.error() == axis_error{axis_errc::drive_fault, state::fault, error_codes::over_current});
    CHECK(r.mine.targets().velocity == 0);
    r.cycle(1000);
    CHECK(r.drive.state == state::fault); // not by itself
    r.mine.reset();
    CHECK(r.mine.state() == axis_state::resetting);
    r.drive.stuck = true;
    r.drive.feedback.error_code = 0;
    std::vector<int> lengths{0}; // of the times with the same word
    int word = 0;
    while (r.mine.state() == axis_state::resetting && lengths.size() < 20) {
        r.cycle();
        if (const int next = r.mine.targets().controlword; next != word) {
            word = next;
            lengths.push_back(0);
        }
        ++lengths.back();
    }
    REQUIRE(lengths.size() == 7); // 0, 80h, three times, and 0 again
    for (const int each : {0, 1, 2, 3, 4, 5}) CHECK(lengths[static_cast<std::size_t>(each)] >= 50);
    CHECK(r.mine.error().code == axis_errc::reset_refused);
    r.drive.stuck = false;
    r.mine.reset();
    r.cycle(60);
    CHECK(r.drive.state == state::switch_on_disabled);
    CHECK(r.mine.error() == axis_error{});
    CHECK(r.mine.state() == axis_state::disabled); // enabled again only on request
}

TEST_CASE("a drive that leaves operation enabled by itself fails the axis") {
    rig r{slow};
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    r.drive.state = state::switch_on_disabled;
    r.drive.show();
    r.cycle();
    CHECK(r.mine.error() == axis_error{axis_errc::enable_lost, state::switch_on_disabled});
    r.cycle(100);
    CHECK(r.drive.state == state::switch_on_disabled);
}

TEST_CASE("lost inputs fail the axis, and nothing moves when they come back") {
    rig r = turning();
    const auto& targets = r.mine.on_lost();
    CHECK(targets.controlword == 0x02);
    CHECK(targets.velocity == 0);
    CHECK(r.mine.error().code == axis_errc::inputs_lost);
    r.cycle(100);
    CHECK(r.drive.state == state::quick_stop_active);
    CHECK(r.mine.targets().velocity == 0);
    CHECK(r.mine.state() == axis_state::failed);
    r.mine.reset();
    r.drive.feedback.velocity = 0;
    REQUIRE(r.mine.enable());
    r.cycle(8);
    CHECK(r.mine.state() == axis_state::enabled);
}

TEST_CASE("a mode is switched as fast as the axis moves, and waits for the drive's display") {
    rig r = turning();
    const auto at = r.drive.feedback.position = 7000;
    r.mine.set_mode(mode::cyclic_synchronous_position);
    r.cycle();
    CHECK(r.mine.targets().mode == mode::cyclic_synchronous_position);
    CHECK(r.mine.targets().velocity == 500);
    CHECK(r.mine.targets().position == at);
    CHECK(r.mine.state() == axis_state::enabling);
    r.follow(100);
    CHECK(r.mine.state() == axis_state::enabled);
    CHECK(r.mine.targets().velocity == 0);
    CHECK(r.mine.targets().position > at); // the way of the ramp
    CHECK(r.mine.targets().position < at + 50);
}

TEST_CASE("a mode that the drive does not have fails the axis") {
    rig r{slow};
    r.mine.set_mode(mode::interpolated_position);
    REQUIRE(r.mine.enable());
    int cycles = 0;
    for (; r.mine.error().code == axis_errc::ok && cycles != 2010; ++cycles) {
        r.cycle();
        r.drive.feedback.mode = mode::none;
    }
    CHECK(r.mine.error().code == axis_errc::mode_refused);
    CHECK(r.mine.targets().controlword == control_of(command::quick_stop)); // in the same cycle
    r.cycle(5);
    CHECK(r.drive.state != state::operation_enabled);
}

TEST_CASE("a set-point of profile position is handed over by its handshake") {
    rig r{slow};
    r.drive.bits = 0;
    REQUIRE(r.enable(mode::profile_position));
    REQUIRE(r.mine.move_to(4000));
    r.cycle();
    CHECK(r.mine.targets().position == 4000);
    CHECK(r.mine.targets().profile_velocity == 1000);
    CHECK((r.mine.targets().controlword & control_bits::new_set_point) != 0);
    r.cycle(5);
    CHECK((r.mine.targets().controlword & control_bits::new_set_point) != 0); // until it is acknowledged
    r.drive.bits = status_bits::set_point_acknowledged;
    r.cycle(2);
    CHECK((r.mine.targets().controlword & control_bits::new_set_point) == 0);
    REQUIRE(r.mine.move_to(5000));
    r.cycle(3);
    CHECK((r.mine.targets().controlword & control_bits::new_set_point) == 0); // the drive has not released the last
    r.drive.bits = status_bits::target_reached;
    r.cycle(3);
    CHECK((r.mine.targets().controlword & control_bits::new_set_point) != 0);
    CHECK(r.mine.targets().position == 5000);
    CHECK(!r.mine.is_target_reached());
    r.drive.bits = status_bits::set_point_acknowledged | status_bits::target_reached;
    r.cycle(2);
    CHECK(!r.mine.is_target_reached()); // of the last set-point: the handshake has not ended
    for (const std::uint16_t bits : {std::uint16_t{0}, std::uint16_t{0xE800}}) { // none, and all others
        r.drive.bits = bits;
        r.cycle(3);
        CHECK(!r.mine.is_target_reached());
    }
    r.drive.bits = status_bits::target_reached;
    r.cycle(2);
    CHECK(r.mine.is_target_reached());
}

TEST_CASE("a set-point that the drive does not take fails the axis") {
    rig r{slow};
    r.drive.bits = 0;
    REQUIRE(r.enable(mode::profile_position));
    REQUIRE(r.mine.move_to(4000));
    r.cycle(2010);
    CHECK(r.mine.error().code == axis_errc::not_acknowledged);
}

TEST_CASE("homing ends by the drive's bits, not by those of an earlier one") {
    rig r{slow};
    r.drive.bits = status_bits::homing_attained | status_bits::target_reached;
    REQUIRE(r.enable(mode::homing));
    REQUIRE(r.mine.home());
    r.cycle();
    CHECK((r.mine.targets().controlword & control_bits::start_homing) != 0);
    CHECK(!r.mine.is_homed());
    r.cycle(2);
    r.drive.bits = 0; // the fourth cycle has those of before, still
    r.cycle(10);
    CHECK(!r.mine.is_homed());
    r.drive.bits = status_bits::homing_attained | status_bits::target_reached;
    r.cycle(3);
    CHECK(r.mine.is_homed());
    REQUIRE(r.mine.home());
    r.drive.bits = status_bits::homing_error;
    r.cycle(10);
    CHECK(r.mine.error().code == axis_errc::homing_failed);
}

TEST_CASE("homing goes on while the drive has only one of the two bits, also where it was homed before") {
    rig r{slow};
    REQUIRE(r.enable(mode::homing));
    REQUIRE(r.mine.home());
    r.drive.bits = status_bits::homing_attained | status_bits::target_reached;
    r.cycle(10);
    REQUIRE(r.mine.is_homed());
    r.drive.bits = GENERATE(status_bits::homing_attained, status_bits::target_reached);
    REQUIRE(r.mine.home());
    CHECK(!r.mine.is_homed());
    r.cycle(10);
    CHECK(!r.mine.is_homed());
    CHECK(!r.mine.is_target_reached());
    CHECK((r.mine.targets().controlword & control_bits::start_homing) != 0);
}

TEST_CASE("an error of homing counts from the fifth cycle on") {
    rig r{slow};
    REQUIRE(r.enable(mode::homing));
    REQUIRE(r.mine.home());
    r.drive.bits = status_bits::homing_error;
    r.cycle(4);
    CHECK(r.mine.error().code == axis_errc::ok);
    r.cycle();
    CHECK(r.mine.error().code == axis_errc::homing_failed);
}

TEST_CASE("a target of another mode is refused") {
    rig r{slow};
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    CHECK(r.mine.move_to(1).error() == axis_errc::wrong_mode);
    CHECK(r.mine.push_with(1).error() == axis_errc::wrong_mode);
    CHECK(r.mine.home().error() == axis_errc::wrong_mode);
}

TEST_CASE("set-points keep to real time where the bus runs faster than the axis") {
    axis_options options = slow;
    options.cycle = 10ms;
    rig r{options}; // is called each millisecond
    REQUIRE(r.enable(mode::cyclic_synchronous_position));
    const auto modes = {mode::cyclic_synchronous_position, mode::cyclic_synchronous_velocity};
    for (const auto each : modes) {
        INFO(static_cast<int>(each));
        r.mine.set_mode(each);
        r.follow(20);
        REQUIRE(r.mine.state() == axis_state::enabled);
        if (each == mode::cyclic_synchronous_position)
            REQUIRE(r.mine.move_to(1'000'000));
        else
            REQUIRE(r.mine.run_at(1000));
        const auto from = r.mine.targets();
        r.follow(50); // half of the acceleration
        CHECK(r.mine.targets().velocity - from.velocity <= 600);
        CHECK(r.mine.targets().velocity - from.velocity >= 400);
        r.follow(1000);
        const auto then = r.mine.targets();
        r.follow(1000);
        if (each == mode::cyclic_synchronous_position)
            CHECK(std::abs(r.mine.targets().position - then.position - 1000) <= 10);
        r.mine.halt(true);
        r.follow(200);
        r.mine.halt(false);
    }
}

TEST_CASE("a shorter period of the bus brings no set-point forward") {
    axis_options options = slow;
    options.cycle = 10ms;
    rig r{options};
    const auto cycle = [&](duration period) {
        r.now += period;
        r.drive.take(r.mine.on_cycle(r.drive.feedback, r.now));
        r.drive.feedback.position = r.mine.targets().position;
        r.drive.feedback.velocity = r.mine.targets().velocity;
    };
    r.mine.set_mode(mode::cyclic_synchronous_position);
    REQUIRE(r.mine.enable());
    for (int i = 0; i != 8; ++i) cycle(10ms);
    REQUIRE(r.mine.move_to(1'000'000));
    for (int i = 0; i != 50; ++i) cycle(10ms);
    const auto from = r.mine.targets().position; // 1000/s: 10 in each cycle
    r.mine.change_period(1ms);
    for (int i = 1; i != 30; ++i) {
        cycle(1ms);
        // What is sent a millisecond from now; before, 10 ms.
        CHECK(r.mine.targets().position - from <= std::max(0, i - 9) + 2);
    }
    r.mine.change_period(10ms);
    for (int i = 0; i != 5; ++i) {
        const auto last = r.mine.targets().position;
        cycle(10ms);
        CHECK(r.mine.targets().position - last <= 10);
    }
}

TEST_CASE("a call between two cycles makes no step") {
    rig r{slow};
    REQUIRE(r.enable(mode::cyclic_synchronous_position));
    REQUIRE(r.mine.move_to(10'000));
    r.follow(200);
    const auto before = r.mine.targets();
    r.mine.disable();
    CHECK(r.mine.on_cycle(r.drive.feedback, r.now).position == before.position);
    CHECK(r.mine.on_cycle(r.drive.feedback, r.now + 100us).position == before.position);
    for (int i = 1; i != 3; ++i) static_cast<void>(r.mine.on_cycle(r.drive.feedback, r.now + i * 1ms));
    CHECK(r.mine.targets().position > before.position);
    CHECK(r.mine.targets().position <= before.position + 2);
}

TEST_CASE("without a velocity an axis stands still if its positions say so") {
    rig r{slow};
    r.drive.feedback.has_velocity = false;
    r.cycle(10);
    CHECK(!r.mine.is_at_standstill()); // not for long enough
    r.cycle(20);
    CHECK(r.mine.is_at_standstill());
    for (int i = 0; i != 100; ++i) {
        r.drive.feedback.position += 1; // 1000/s
        r.cycle();
        CHECK((i < 2 || !r.mine.is_at_standstill()));
    }
    for (int i = 0; i != 100; ++i) {
        if (i % 10 == 0) r.drive.feedback.position += 1; // 100/s
        r.cycle();
        CHECK(!r.mine.is_at_standstill());
    }
    r.cycle(40);
    CHECK(r.mine.is_at_standstill());
    r.drive.feedback.is_current = false; // the last position of a drive that is silent
    r.cycle();
    CHECK(!r.mine.is_at_standstill());
    r.cycle(100);
    CHECK(!r.mine.is_at_standstill());
    r.drive.feedback.is_current = true;
    r.cycle(40);
    CHECK(r.mine.is_at_standstill());
    r.mine.on_lost();
    CHECK(!r.mine.is_at_standstill());
    r.cycle(10); // it is back where it was, but was not seen for long enough
    CHECK(!r.mine.is_at_standstill());
    r.cycle(20);
    CHECK(r.mine.is_at_standstill());
    r.drive.feedback.has_position = false;
    r.cycle(100);
    CHECK(!r.mine.is_at_standstill()); // neither is known
}

TEST_CASE("a drive without a velocity is not switched off while it turns") {
    rig r{slow};
    r.drive.feedback.has_velocity = false;
    REQUIRE(r.enable(mode::cyclic_synchronous_position));
    REQUIRE(r.mine.move_to(10'000));
    r.follow(200);
    r.mine.disable();
    for (int i = 0; i != 300; ++i) { // it overruns the ramp
        r.drive.feedback.position += 1;
        r.cycle();
        CHECK(r.drive.state == state::operation_enabled);
    }
    r.cycle(40);
    CHECK(r.drive.state != state::operation_enabled);
}

TEST_CASE("a call between two cycles does not take a drive without a velocity as standing") {
    rig r{slow};
    r.drive.feedback.has_velocity = false;
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    for (int i = 0; i != 100; ++i) {
        r.drive.feedback.position += 1; // 1000/s
        r.cycle();
    }
    r.mine.set_mode(mode::cyclic_synchronous_position);
    CHECK(r.mine.on_cycle(r.drive.feedback, r.now + 100us).velocity == 1000);
}

TEST_CASE("the error stands until the drive has left its fault") {
    rig r{slow};
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    r.drive.fail(0x2310);
    r.cycle();
    r.mine.reset();
    CHECK(r.mine.error().code == axis_errc::drive_fault);
    CHECK(r.mine.enable().error() == axis_errc::has_failed);
    r.drive.feedback.statusword = 0x0001; // of no state: not known to have left it
    r.mine.on_cycle(r.drive.feedback, r.now += 1ms);
    CHECK(r.mine.error().code == axis_errc::drive_fault);
    CHECK(r.mine.waits_for() == axis_wait::reset);
    r.drive.show();
    for (int i = 0; i != 500 && r.drive.state == state::fault; ++i) {
        CHECK(r.mine.error().code == axis_errc::drive_fault);
        r.cycle();
    }
    REQUIRE(r.drive.state == state::switch_on_disabled);
    r.cycle(2);
    CHECK(r.mine.error().code == axis_errc::ok);
    CHECK(r.mine.state() == axis_state::disabled);
}

TEST_CASE("a reset ends where the drive's reaction to its fault does not") {
    rig r{slow};
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    r.drive.stuck = true;
    r.drive.state = state::fault_reaction_active;
    r.drive.show();
    r.cycle();
    r.mine.reset();
    r.cycle(1900);
    CHECK(r.mine.state() == axis_state::resetting);
    r.cycle(200);
    CHECK(r.mine.state() == axis_state::failed);
    CHECK(r.mine.error().code == axis_errc::reset_refused);
}

TEST_CASE("a drive that shows no state gets the quick stop, then no voltage") {
    for (const bool on : {false, true}) {
        INFO(on);
        rig r{slow};
        REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
        if (!on) r.mine.disable();
        r.drive.feedback.statusword = 0x0001;
        const auto cycle = [&] { return r.mine.on_cycle(r.drive.feedback, r.now += 1ms).controlword; };
        for (int i = 0; i != 2000; ++i) CHECK(cycle() == 0x02);
        CHECK(r.mine.error().code == (on ? axis_errc::enable_lost : axis_errc::ok));
        cycle(); // the step time is over
        CHECK(r.mine.error().code == (on ? axis_errc::enable_lost : axis_errc::step_timeout));
        for (int i = 0; i != 2500; ++i) cycle();
        CHECK(cycle() == 0x00);
        CHECK(r.mine.error().code == (on ? axis_errc::enable_lost : axis_errc::step_timeout));
    }
}

TEST_CASE("an axis is told to stop until its drive shows a state, and is then enabled") {
    rig r;
    r.mine.set_mode(mode::cyclic_synchronous_velocity);
    r.drive.feedback.statusword = 0x0001;
    REQUIRE(r.mine.enable());
    for (int i = 0; i != 10; ++i)
        CHECK(r.mine.on_cycle(r.drive.feedback, r.now += 1ms).controlword == control_of(command::quick_stop));
    CHECK(r.mine.waits_for() == axis_wait::known_state);
    r.drive.show();
    r.cycle(6);
    CHECK(r.mine.state() == axis_state::enabled);
}

TEST_CASE("an axis brakes in its old mode while the drive does not take the new one") {
    axis_options options = slow;
    options.max_position = 500;
    rig r{options};
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    REQUIRE(r.mine.run_at(1000));
    double position = 0;
    const auto cycle = [&] { // it follows its target velocity, whatever the mode is
        r.now += 1ms;
        const auto old = r.drive.feedback.mode;
        r.drive.take(r.mine.on_cycle(r.drive.feedback, r.now));
        r.drive.feedback.mode = old;
        r.drive.feedback.velocity = r.mine.targets().velocity;
        position += r.drive.feedback.velocity * 0.001;
        r.drive.feedback.position = static_cast<std::int32_t>(position);
    };
    for (int i = 0; i != 300; ++i) cycle();
    REQUIRE(r.drive.feedback.velocity == 1000);
    r.mine.set_mode(mode::cyclic_synchronous_position);
    int last = 1000;
    for (int i = 0; i != 1500; ++i) {
        cycle();
        CHECK(std::abs(r.drive.feedback.velocity - last) <= 10); // the deceleration
        last = r.drive.feedback.velocity;
        CHECK(r.drive.feedback.position <= 500);
    }
    CHECK(r.drive.feedback.velocity == 0);
}

TEST_CASE("an axis that is disabled while it changes its mode brakes in the one that its drive shows") {
    const auto old = GENERATE(mode::cyclic_synchronous_position, mode::cyclic_synchronous_velocity);
    const auto next = GENERATE(mode::cyclic_synchronous_velocity, mode::cyclic_synchronous_torque);
    if (old == next) return;
    rig r{{.max_velocity = 1'000'000, .acceleration = 10'000'000, .deceleration = 10'000'000, .standstill = 0}};
    REQUIRE(r.enable(old));
    REQUIRE((old == mode::cyclic_synchronous_velocity ? r.mine.run_at(500'000) : r.mine.move_to(1'000'000)));
    double velocity = 0; // of what the drive follows
    const auto cycle = [&] {
        r.cycle();
        r.drive.feedback.mode = old;
        if (old == mode::cyclic_synchronous_velocity) {
            velocity = r.mine.targets().velocity;
            r.drive.feedback.position += static_cast<int>(velocity / 1000);
        } else {
            velocity = (r.mine.targets().position - r.drive.feedback.position) * 1000.0;
            r.drive.feedback.position = r.mine.targets().position;
        }
        r.drive.feedback.velocity = static_cast<int>(velocity);
    };
    for (int i = 0; i != 60; ++i) cycle();
    REQUIRE(velocity >= 490'000);
    r.mine.set_mode(next);
    r.mine.disable();
    for (int i = 0; i != 100; ++i) {
        const double before = velocity;
        cycle();
        CHECK(std::abs(velocity - before) <= 12'000); // the deceleration, and two units
        CHECK(r.mine.targets().torque == 0);
    }
    CHECK(velocity == 0);
    CHECK(r.mine.state() == axis_state::disabled);
    CHECK(r.mine.error().code == axis_errc::ok);
}

TEST_CASE("an axis that coasts out of torques begins with the velocity of its motor, however late the new mode comes") {
    rig r{{.max_velocity = 1'000'000, .acceleration = 10'000'000, .deceleration = 10'000'000, .standstill = 0}};
    REQUIRE(r.enable(mode::cyclic_synchronous_torque));
    const auto coast = [&] {
        r.drive.feedback.velocity = 500'000;
        r.drive.feedback.position += 500;
        r.cycle();
    };
    r.mine.set_mode(mode::cyclic_synchronous_position);
    for (int i = 0; i != 30; ++i) {
        coast();
        r.drive.feedback.mode = mode::cyclic_synchronous_torque;
        CHECK(r.mine.targets().position == r.drive.feedback.position + 500);
    }
    r.drive.feedback.mode = mode::cyclic_synchronous_position;
    coast();
    CHECK(std::abs(r.mine.targets().position - r.drive.feedback.position - 1000) <= 11); // where it is then, and a step
    CHECK(std::abs(r.mine.targets().velocity - 500'000) <= 10'000);                      // the deceleration of a cycle
}

TEST_CASE("an axis whose drive moves by itself is halted when its mode changes, and begins with the motor's velocity") {
    const auto old = GENERATE(mode::profile_position, mode::homing);
    rig r{{.max_velocity = 1'000'000, .acceleration = 10'000'000, .deceleration = 10'000'000, .standstill = 0}};
    REQUIRE(r.enable(old));
    const auto cycle = [&](int velocity, mode shown) {
        r.drive.feedback.velocity = velocity;
        r.drive.feedback.position += velocity / 1000;
        r.cycle();
        r.drive.feedback.mode = shown;
    };
    cycle(500'000, old);
    REQUIRE((r.mine.targets().controlword & control_bits::halt) == 0);
    r.mine.set_mode(mode::cyclic_synchronous_velocity);
    for (int i = 0; i != 30; ++i) {
        cycle(500'000, old);
        CHECK((r.mine.targets().controlword & control_bits::halt) != 0);
        CHECK(r.mine.targets().velocity == 500'000);
    }
    cycle(500'000, mode::cyclic_synchronous_velocity);
    cycle(500'000, mode::cyclic_synchronous_velocity);
    CHECK((r.mine.targets().controlword & control_bits::halt) == 0);
    CHECK(std::abs(r.mine.targets().velocity - 500'000) <= 10'000); // the deceleration of a cycle
}

TEST_CASE("an axis that changes its mode back before its drive has followed goes on where that is") {
    rig r{{.max_velocity = 1'000'000, .acceleration = 10'000'000, .deceleration = 10'000'000, .standstill = 0}};
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    REQUIRE(r.mine.run_at(500'000));
    r.cycle(60);
    r.drive.feedback.velocity = 500'000;
    r.mine.set_mode(mode::cyclic_synchronous_position);
    r.cycle();
    const auto told = r.mine.targets();
    REQUIRE(r.drive.feedback.mode == mode::cyclic_synchronous_position);
    r.drive.feedback.velocity = 0; // it has reached its first set-point, and stands until the second one comes
    r.mine.set_mode(mode::cyclic_synchronous_velocity);
    for (int velocity = told.velocity; velocity > 0; velocity = r.mine.targets().velocity) {
        r.cycle();
        CHECK(r.mine.targets().velocity >= velocity - 10'001);
        CHECK(r.mine.targets().velocity < velocity);
    }
}

TEST_CASE("set-points do not jump where the mode changes faster than the drive shows it") {
    const int cycles_between = GENERATE(1, 2, 3, 4, 7);
    rig r{{.max_velocity = 1'000'000, .acceleration = 10'000'000, .deceleration = 10'000'000, .standstill = 0}};
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    REQUIRE(r.mine.run_at(500'000));
    axis_targets taken{r.mine.targets()};
    const auto cycle = [&] { // a frame has the inputs of before its outputs
        const auto told = r.mine.on_cycle(r.drive.feedback, r.now += 1ms);
        auto& is = r.drive.feedback;
        const auto before = is.position;
        is.position = taken.mode == mode::cyclic_synchronous_position ? taken.position : before + taken.velocity / 1000;
        is.velocity = (is.position - before) * 1000;
        is.mode = std::exchange(taken, told).mode;
    };
    for (int i = 0; i != 60; ++i) cycle();
    REQUIRE(r.drive.feedback.velocity == 500'000);
    for (int changes = 0; changes != 8; ++changes) {
        const bool is_position = r.mine.targets().mode == mode::cyclic_synchronous_position;
        r.mine.set_mode(is_position ? mode::cyclic_synchronous_velocity : mode::cyclic_synchronous_position);
        for (int i = 0; i != cycles_between; ++i) {
            const auto before = taken;
            cycle();
            CHECK(std::abs(taken.velocity - before.velocity) <= 10'001);
            if (before.mode == mode::cyclic_synchronous_position && taken.mode == before.mode)
                CHECK(std::abs(taken.position - before.position) <= 510);
        }
    }
}

TEST_CASE("an axis that is disabled while it changes from torques pushes no more") {
    rig r{slow};
    REQUIRE(r.enable(mode::cyclic_synchronous_torque));
    REQUIRE(r.mine.push_with(100));
    r.cycle(200);
    REQUIRE(r.mine.targets().torque == 100);
    r.mine.set_mode(mode::cyclic_synchronous_velocity);
    r.mine.disable();
    for (int i = 0; i != 10; ++i) {
        r.cycle();
        r.drive.feedback.mode = mode::cyclic_synchronous_torque;
        CHECK(r.mine.targets().torque == 0);
    }
    CHECK(r.mine.state() == axis_state::disabled);
}

TEST_CASE("an axis works with times that are never over, and with those that always are") {
    STATIC_REQUIRE([] {
        constexpr auto ever = duration::max();
        rig r{{.step_time = ever, .rest_time = ever, .reset_time = ever}};
        if (!r.enable(mode::cyclic_synchronous_velocity) || !r.mine.run_at(100)) return false;
        r.follow(10);
        r.mine.disable();
        r.follow(100);
        return r.mine.state() == axis_state::disabled;
    }());
    STATIC_REQUIRE([] {
        rig r{{.step_time = -1ns, .rest_time = duration::min(), .reset_time = -1ns}};
        r.mine.set_mode(mode::cyclic_synchronous_velocity);
        static_cast<void>(r.mine.enable());
        r.cycle(10);
        r.mine.disable();
        r.cycle(10);
        return r.mine.state() != axis_state::enabled;
    }());
}

TEST_CASE("a drive that ignores its controlwords loses its voltage after the step time, and the axis says what it "
          "waits for") {
    rig r{{.step_time = 100ms, .max_velocity = 1000, .acceleration = 10'000, .deceleration = 10'000, .standstill = 0}};
    CHECK(r.mine.waits_for() == axis_wait::feedback);
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    CHECK(r.mine.waits_for() == axis_wait::nothing);
    REQUIRE(r.mine.run_at(100));
    r.follow(20);
    r.drive.stuck = true;
    r.mine.quick_stop();
    r.cycle(2);
    CHECK(r.mine.targets().controlword == control_of(command::quick_stop));
    CHECK(r.mine.waits_for() == axis_wait::leaving_enabled);
    r.cycle(200);
    CHECK(r.mine.state() == axis_state::failed);
    CHECK(r.mine.error().code == axis_errc::step_timeout);
    CHECK(r.mine.targets().controlword == control_of(command::disable_voltage));
    CHECK(describe(r.mine.waits_for()) == "the drive to leave operation enabled");
    CHECK(describe(r.mine.state()) == "failed");
}

TEST_CASE("an axis at rest in quick stop active is disabled after the step time") {
    rig r{{.step_time = 100ms, .standstill = 0}};
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    r.mine.quick_stop();
    r.cycle(50);
    CHECK(r.drive.state == state::quick_stop_active);
    r.cycle(100);
    CHECK(r.drive.state == state::switch_on_disabled);
    CHECK(r.mine.error().code == axis_errc::ok);
}

TEST_CASE("a drive that never shows bit 12 is taken to follow if the options say so") {
    for (const bool shows : {true, false}) {
        rig r{{.step_time = 100ms, .shows_following = shows}};
        r.drive.bits = 0;
        r.mine.set_mode(mode::cyclic_synchronous_position);
        REQUIRE(r.mine.enable());
        r.cycle(10);
        CHECK((r.mine.state() == axis_state::enabled) == !shows);
        CHECK(r.mine.waits_for() == (shows ? axis_wait::following : axis_wait::nothing));
    }
}
