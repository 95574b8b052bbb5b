// The emulated drive against the master's axis, and by its objects.
#include "support/catch.hpp"
#include "support/simulated_link.hpp"
#include <jauscat/ethercat/cia402/emulated_drive.hpp>
#include <jauscat/ethercat/master/process_data.hpp>
#include <jauscat/ethercat/slave/assignable_pdos.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace jauscat;
using namespace jauscat::cia402;
using namespace std::chrono_literals;

namespace {

constexpr axis_options gentle{.max_velocity = 100'000, .acceleration = 1'000'000, .deceleration = 1'000'000};

/// A drive and its master, image by image, on a bus of 1 ms.
struct rig {
    emulated_drive<> drive{};
    axis mine{gentle};
    axis_places places = places_of(cyclic_outputs, cyclic_inputs);
    std::array<std::byte, 14> outputs{};
    std::array<std::byte, 16> inputs{};
    time_point now{};
    bool operational{true};

    emulated_axis& motor() { return drive.axes[0]; }
    drive_values& values() { return drive.axes[0].values; }
    void exchange() {
        now += 1ms;
        if (operational) drive.take(outputs);
        motor().on_time(now, operational);
        drive.give(inputs);
    }
    void cycle(int count = 1) {
        for (int i = 0; i != count; ++i) {
            exchange();
            places.store(mine.on_cycle(places.load(inputs), now), outputs);
        }
    }
    /// Without the axis: a controlword of one's own, for some cycles.
    void send(std::uint16_t word, mode m = mode::cyclic_synchronous_velocity, int cycles = 2) {
        places.store({.controlword = word, .mode = m, .position = values().position_actual}, outputs);
        for (int i = 0; i != cycles; ++i) exchange();
    }
    bool enable(mode m) {
        mine.set_mode(m);
        if (!mine.enable()) return false;
        cycle(20);
        return mine.state() == axis_state::enabled;
    }
    void enable_by_hand(mode m = mode::cyclic_synchronous_velocity) {
        for (const int word : {0x06, 0x07, 0x0F}) send(static_cast<std::uint16_t>(word), m);
        REQUIRE(motor().state() == state::operation_enabled);
    }
    /// Turns at a velocity in cyclic synchronous velocity.
    void turn(std::int32_t velocity) {
        enable_by_hand();
        places.store({.controlword = 0x0F, .mode = mode::cyclic_synchronous_velocity, .velocity = velocity}, outputs);
        for (int i = 0; i != 50; ++i) exchange();
        REQUIRE(std::abs(motor().velocity() - velocity) < 100);
    }
    /// Cycles until the state is another one.
    int cycles_in(state s) {
        int count = 0;
        for (; motor().state() == s && count != 5000; ++count) exchange();
        return count;
    }
};

} // namespace

TEST_CASE("the drive takes every transition of the standard by its command") {
    for (const auto& each : transitions) {
        if (each.number == 15 || each.number == 16) continue; // below
        rig r;
        r.values().disable_option = r.values().shutdown_option = 0;
        r.values().quick_stop_option = 6; // stays in quick stop active
        r.send(0);
        CHECK(r.motor().state() == state::switch_on_disabled);
        const auto way = [&](state to) {
            if (to == state::switch_on_disabled) return;
            r.send(0x06);
            if (to == state::ready_to_switch_on) return;
            r.send(0x07);
            if (to == state::switched_on) return;
            r.send(0x0F);
            if (to == state::quick_stop_active) r.send(0x02);
        };
        way(each.from);
        CHECK(r.motor().state() == each.from);
        r.send(control_of(each.cause), mode::cyclic_synchronous_velocity, 1);
        INFO("transition " << int{each.number});
        CHECK(r.motor().state() == each.to);
        CHECK(state_of(r.values().statusword) == each.to);
    }
}

TEST_CASE("a fault passes through its reaction, and is reset by an edge once its cause is gone") {
    rig r;
    r.turn(50'000);
    r.motor().disturbed.fault = error_codes::over_temperature;
    r.exchange();
    CHECK(r.motor().state() == state::fault_reaction_active); // transition 13
    CHECK(r.cycles_in(state::fault_reaction_active) >= 5);    // 50,000 at 5,000,000 a second
    CHECK(r.motor().state() == state::fault);                 // transition 14
    CHECK(r.values().error_code == error_codes::over_temperature);
    r.motor().disturbed.fault = error_codes::over_current; // a second one does not replace the first
    r.exchange();
    CHECK(r.motor().state() == state::fault);
    CHECK(r.values().error_code == error_codes::over_temperature);
    r.send(0x80);
    CHECK(r.motor().state() == state::fault);
    r.motor().disturbed.fault = 0;
    r.send(0x80);
    CHECK(r.motor().state() == state::fault); // no edge
    r.send(0x00);
    r.send(0x80);
    CHECK(r.motor().state() == state::switch_on_disabled); // transition 15
    CHECK(r.values().error_code == 0);
}

TEST_CASE("a drive that fails on its ramp to another state stays in its fault") {
    rig r;
    r.turn(50'000);
    r.send(0x07);
    REQUIRE(r.motor().state() == state::operation_enabled); // until it stands still
    r.motor().disturbed.fault = error_codes::over_temperature;
    r.exchange();
    r.motor().disturbed.fault = 0;
    r.cycles_in(state::fault_reaction_active);
    for (int i = 0; i != 100; ++i) {
        r.exchange();
        REQUIRE(r.motor().state() == state::fault);
    }
}

TEST_CASE("the quick stop option decides how the drive stops and whether it stays") {
    const auto stop = [](std::int16_t option) {
        rig r;
        r.turn(50'000);
        r.values().quick_stop_option = option;
        r.send(0x02, mode::cyclic_synchronous_velocity, 1);
        const auto cycles = r.cycles_in(state::quick_stop_active);
        return std::pair{cycles, std::abs(r.motor().velocity())};
    };
    CHECK(stop(0).first == 0); // power off at once: it coasts
    CHECK(stop(0).second > 1000);
    CHECK(stop(1).first >= 45); // 1,000,000 a second
    CHECK(stop(1).first <= 55);
    CHECK(stop(2).first >= 7); // 5,000,000 a second
    CHECK(stop(2).first <= 12);
    CHECK(stop(3).first <= 4); // by its torque alone
    CHECK(stop(5).first == 5000);
    CHECK(stop(5).second < 1);
    CHECK(stop(6).first == 5000);
    CHECK(stop(6).second < 1);
    rig r;
    r.turn(50'000);
    r.values().quick_stop_option = 6;
    r.send(0x02, mode::cyclic_synchronous_velocity, 100);
    CHECK(r.values().position_demand == r.values().position_actual);
    r.send(0x0F);
    CHECK(r.motor().state() == state::operation_enabled); // transition 16
}

TEST_CASE("halt, disable operation and shutdown stop by their options") {
    rig r;
    r.turn(50'000);
    r.values().halt_option = 2;
    r.send(0x10F, mode::cyclic_synchronous_velocity, 20);
    CHECK(r.motor().state() == state::operation_enabled);
    CHECK(std::abs(r.motor().velocity()) < 1);
    CHECK((r.values().statusword & status_bits::follows_target) == 0);

    rig disabled;
    disabled.turn(50'000);
    disabled.send(0x07);
    CHECK(disabled.motor().state() == state::operation_enabled); // on the ramp
    disabled.send(0x07, mode::cyclic_synchronous_velocity, 30);
    CHECK(disabled.motor().state() == state::operation_enabled); // 1,000,000 a second
    disabled.send(0x07, mode::cyclic_synchronous_velocity, 30);
    CHECK(disabled.motor().state() == state::switched_on);

    rig shut;
    shut.turn(50'000);
    shut.values().shutdown_option = 1;
    shut.send(0x06, mode::cyclic_synchronous_velocity, 60);
    CHECK(shut.motor().state() == state::ready_to_switch_on);
    CHECK(std::abs(shut.motor().velocity()) < 1);
}

TEST_CASE("a drive that is enabled again on its ramp stays enabled") {
    rig r;
    r.turn(50'000);
    r.send(0x07);
    CHECK(r.motor().state() == state::operation_enabled);
    for (int i = 0; i != 100; ++i) {
        r.send(0x0F, mode::cyclic_synchronous_velocity, 1);
        CHECK(r.motor().state() == state::operation_enabled);
    }
}

TEST_CASE("the torque of profile torque begins at 0 each time that the drive is enabled") {
    rig r;
    r.values().torque_slope = 1000; // 1 per mille in each cycle
    r.enable_by_hand(mode::profile_torque);
    const auto push = [&](std::uint16_t word, int cycles) {
        r.places.store({.controlword = word, .mode = mode::profile_torque, .torque = 500}, r.outputs);
        for (int i = 0; i != cycles; ++i) r.exchange();
        return r.values().torque_actual;
    };
    CHECK(push(0x0F, 100) == 100);
    CHECK(push(0x00, 1) == 0); // disable voltage: without a ramp
    push(0x06, 1);
    push(0x07, 1);
    CHECK(push(0x0F, 1) == 1);
    CHECK(push(0x0F, 99) == 100);
}

TEST_CASE("a motor has the speed of its model at most") {
    rig r;
    r.drive = emulated_drive<>{motor_model{.max_speed = 1000}};
    r.enable_by_hand();
    r.places.store({.controlword = 0x0F, .mode = mode::cyclic_synchronous_velocity, .velocity = 50'000}, r.outputs);
    for (int i = 0; i != 50; ++i) r.exchange();
    CHECK(r.motor().velocity() == Approx(1000).margin(1));
}

TEST_CASE("a motor that its load drives has twice that speed at most") {
    rig r;
    r.drive = emulated_drive<>{motor_model{.max_speed = 1000}};
    r.motor().disturbed.load = -1000;
    for (int i = 0; i != 1000; ++i) r.exchange();
    CHECK(r.motor().velocity() == 2000);
}

TEST_CASE("a drive shows that its torque is limited") {
    rig r;
    r.enable_by_hand();
    CHECK((r.values().statusword & status_bits::internal_limit) == 0);
    r.values().max_torque = 1;
    r.places.store({.controlword = 0x0F, .mode = mode::cyclic_synchronous_velocity, .velocity = 50'000}, r.outputs);
    r.exchange();
    CHECK((r.values().statusword & status_bits::internal_limit) != 0);
}

TEST_CASE("a motor takes a velocity that its torque allows in one cycle, and no more") {
    rig r;
    r.enable_by_hand();
    r.places.store({.controlword = 0x0F, .mode = mode::cyclic_synchronous_velocity, .velocity = 1000}, r.outputs);
    r.exchange();
    CHECK(r.motor().velocity() == Approx(1000).epsilon(1e-6));
}

TEST_CASE("a shaft that is placed stands still") {
    rig r;
    r.turn(50'000);
    r.motor().place(7);
    CHECK(r.motor().position() == 7);
    CHECK(r.motor().velocity() == 0);
}

TEST_CASE("a shaft that turns without torque keeps its position demand until the drive is enabled") {
    rig r;
    r.turn(50'000);
    r.send(0x00, mode::cyclic_synchronous_velocity, 1);
    const auto demand = r.values().position_demand;
    r.send(0x06);
    r.send(0x07);
    CHECK(r.motor().state() == state::switched_on);
    CHECK(r.values().position_actual > demand + 50);
    CHECK(r.values().position_demand == demand);
    r.send(0x0F, mode::cyclic_synchronous_velocity, 1);
    CHECK(r.values().position_demand > demand + 50);
}

TEST_CASE("a drive in profile position stands still before its first set-point") {
    rig r;
    r.motor().place(1000);
    REQUIRE(r.enable(mode::profile_position));
    r.cycle(3000);
    CHECK(r.values().position_actual == 1000);
}

TEST_CASE("a drive in profile position has not reached a target before its first set-point") {
    rig r;
    r.enable_by_hand(mode::profile_position);
    for (int i = 0; i != 100; ++i) r.exchange();
    CHECK((r.values().statusword & status_bits::target_reached) == 0);
}

TEST_CASE("a drive in profile position takes a set-point once, however long it is offered") {
    rig r;
    r.enable_by_hand(mode::profile_position);
    const auto offered = static_cast<std::uint16_t>(0x0F | control_bits::new_set_point |
                                                    GENERATE(std::uint16_t{0}, control_bits::relative));
    r.places.store({.controlword = offered, .mode = mode::profile_position, .position = 1'000}, r.outputs);
    for (int i = 0; i != 1000; ++i) r.exchange();
    CHECK(r.motor().position() == Approx(1'000).margin(10));
    CHECK(r.values().position_demand == 1'000);
}

TEST_CASE("a drive in profile position keeps one set-point for later, and takes no other one until then") {
    rig r;
    r.enable_by_hand(mode::profile_position);
    const auto show = [&r](std::uint16_t word, std::int32_t position, int cycles) {
        r.places.store({.controlword = word, .mode = mode::profile_position, .position = position}, r.outputs);
        for (int i = 0; i != cycles; ++i) r.exchange();
    };
    for (const std::int32_t each : {1'000, -1'000}) {
        show(0x1F, each, 2);
        show(0x0F, each, 2);
    }
    double lowest = 0;
    for (int i = 0; i != 3000; ++i) {
        show(0x1F, 2'000, 1);
        lowest = std::min(lowest, r.motor().position());
    }
    CHECK(lowest < -900);
    CHECK(r.motor().position() == Approx(2'000).margin(10));
}

TEST_CASE("an axis moves the drive to a position, without a jump at its start") {
    rig r;
    r.motor().place(1'000'000);
    double most = 0;
    r.mine.set_mode(mode::cyclic_synchronous_position);
    REQUIRE(r.mine.enable());
    for (int i = 0; i != 20; ++i) {
        r.cycle();
        most = std::max(most, std::abs(r.motor().position() - 1'000'000));
    }
    REQUIRE(r.mine.state() == axis_state::enabled);
    CHECK(most < 1);
    REQUIRE(r.mine.move_to(1'040'000));
    double behind = 0;
    for (int i = 0; i != 800; ++i) {
        r.cycle();
        behind = std::max(behind, std::abs(static_cast<double>(r.values().following_error)));
    }
    CHECK(r.values().position_actual == 1'040'000);
    CHECK(behind < 200);
    CHECK(r.mine.is_target_reached());
}

TEST_CASE("an axis drives velocity and torque, and is at rest after each") {
    rig r;
    REQUIRE(r.enable(mode::cyclic_synchronous_velocity));
    REQUIRE(r.mine.run_at(30'000));
    r.cycle(100);
    CHECK(r.values().velocity_actual == Approx(30'000).margin(100));
    r.mine.disable();
    r.cycle(100);
    CHECK(r.mine.state() == axis_state::disabled);
    CHECK(std::abs(r.values().velocity_actual) <= 10);

    REQUIRE(r.enable(mode::cyclic_synchronous_torque));
    REQUIRE(r.mine.push_with(100));
    r.cycle(20);
    CHECK(r.values().torque_actual == 100);
    CHECK(r.values().velocity_actual > 1000);
    r.mine.set_mode(mode::cyclic_synchronous_position);
    r.cycle(200);
    CHECK(r.mine.state() == axis_state::enabled);
    CHECK(std::abs(r.values().velocity_actual) <= 10);
}

TEST_CASE("an axis uses the profiles of the drive") {
    rig r;
    REQUIRE(r.enable(mode::profile_position));
    REQUIRE(r.mine.move_to(20'000));
    r.cycle(10);
    REQUIRE(r.mine.move_to(-5'000)); // at once
    r.cycle(1500);
    CHECK(r.values().position_actual == Approx(-5'000).margin(10));
    CHECK(r.mine.is_target_reached());

    r.mine.set_mode(mode::profile_velocity);
    r.cycle(20);
    REQUIRE(r.mine.run_at(20'000));
    r.cycle(100);
    CHECK(r.values().velocity_actual == Approx(20'000).margin(100));
    CHECK(r.mine.is_target_reached());
    r.mine.halt(true);
    r.cycle(100);
    CHECK(std::abs(r.values().velocity_actual) <= 10);
    r.mine.halt(false);

    r.mine.set_mode(mode::homing);
    r.values().home_offset = 777;
    r.cycle(20);
    REQUIRE(r.mine.home());
    r.cycle(20);
    CHECK(r.mine.is_homed());
    CHECK(r.values().position_actual == 777);
    r.values().homing_method = 1; // no switch
    REQUIRE(r.mine.home());
    r.cycle(20);
    CHECK(r.mine.error().code == axis_errc::homing_failed);
}

TEST_CASE("after a halt a drive in profile position stays where it is") {
    rig r;
    REQUIRE(r.enable(mode::profile_position));
    REQUIRE(r.mine.move_to(100'000));
    const int cycles = GENERATE(0, 1, 2, 3, 300); // the set-point is not offered, offered, taken, on its way
    r.cycle(cycles);
    r.mine.halt(true);
    r.cycle(500);
    const double at = r.motor().position();
    CHECK(std::abs(r.motor().velocity()) < 10);
    CHECK(at < 90'000);
    r.mine.halt(false);
    r.cycle(2000);
    CHECK(r.motor().position() == Approx(at).margin(20));
    CHECK(r.mine.state() == axis_state::enabled);
    REQUIRE(r.mine.move_to(50'000));
    r.cycle(2000);
    CHECK(r.mine.is_target_reached());
    CHECK(r.motor().position() == Approx(50'000).margin(20));
}

TEST_CASE("a homing method that the drive does not have shows an error at rest") {
    rig r;
    r.values().homing_method = 1;
    REQUIRE(r.enable(mode::homing));
    REQUIRE(r.mine.home());
    r.cycle(3);
    const auto bits = status_bits::homing_error | status_bits::homing_attained | status_bits::target_reached;
    CHECK((r.values().statusword & bits) == (status_bits::homing_error | status_bits::target_reached));
    r.cycle(10);
    CHECK(r.mine.error().code == axis_errc::homing_failed);
}

TEST_CASE("the result of a homing stands until the next one, its error until its command ends") {
    rig r;
    constexpr unsigned done = status_bits::homing_attained | status_bits::target_reached;
    constexpr unsigned failed = status_bits::homing_error | status_bits::target_reached;
    const auto bits = [&](std::uint16_t word) {
        r.send(word, mode::homing);
        return r.values().statusword & (done | failed);
    };
    r.enable_by_hand(mode::homing);
    CHECK(bits(0x0F) == status_bits::target_reached); // at rest
    CHECK(bits(0x1F) == done);
    r.values().home_offset = 50; // of the next one
    CHECK(bits(0x1F) == done);
    CHECK(r.motor().position() == Approx(0).margin(1));
    CHECK(bits(0x0F) == done);
    r.values().homing_method = 1; // no switch
    CHECK(bits(0x1F) == failed);
    CHECK(bits(0x0F) == status_bits::target_reached);
}

TEST_CASE("a following error shows before it is a fault") {
    rig r;
    r.values().following_error_time = 200;
    REQUIRE(r.enable(mode::cyclic_synchronous_position));
    r.motor().disturbed.blocked = true;
    REQUIRE(r.mine.move_to(1'000'000));
    for (int i = 0; i != 1000 && !r.mine.has_following_error(); ++i) r.cycle();
    CHECK(r.mine.has_following_error());
    CHECK(r.mine.error().code == axis_errc::ok);
    r.cycle(300);
    CHECK(r.mine.error().drive_code == error_codes::following_error);
    CHECK(!r.mine.has_following_error());
}

TEST_CASE("a shaft that is blocked in profile position ends in a following error, too") {
    rig r;
    REQUIRE(r.enable(mode::profile_position));
    r.motor().disturbed.blocked = true;
    REQUIRE(r.mine.move_to(1'000'000));
    r.cycle(1000);
    CHECK(r.mine.error().drive_code == error_codes::following_error);
    CHECK(r.motor().state() == state::fault);
}

TEST_CASE("a drive that was not called for long continues with a tenth of a second") {
    rig r;
    r.turn(50'000);
    const double at = r.motor().position();
    r.now += 10s;
    r.exchange();
    CHECK(r.motor().position() - at == Approx(5'000).margin(50));
}

TEST_CASE("a blocked shaft ends in a following error, and the axis says so") {
    rig r;
    REQUIRE(r.enable(mode::cyclic_synchronous_position));
    r.motor().disturbed.blocked = true;
    REQUIRE(r.mine.move_to(1'000'000));
    r.cycle(1000);
    CHECK(r.mine.error() == axis_error{axis_errc::drive_fault, r.mine.error().state, error_codes::following_error});
    CHECK(r.motor().state() == state::fault);
    r.motor().disturbed.blocked = false;
    r.mine.reset();
    r.cycle(200);
    CHECK(r.mine.state() == axis_state::disabled);
    const auto at = r.values().position_actual;
    REQUIRE(r.enable(mode::cyclic_synchronous_position));
    r.cycle(100);
    CHECK(std::abs(r.values().position_actual - at) <= 1); // the old target is gone
}

TEST_CASE("software limits hold in every mode") {
    rig r;
    r.values().min_position_limit = -1000;
    r.values().max_position_limit = 1000;
    REQUIRE(r.enable(mode::cyclic_synchronous_position));
    REQUIRE(r.mine.move_to(5000));
    r.cycle(300);
    CHECK(r.values().position_actual == 1000);
    CHECK(r.mine.is_limited_by_drive());
    r.mine.set_mode(mode::cyclic_synchronous_velocity);
    r.cycle(20);
    REQUIRE(r.mine.run_at(50'000));
    r.cycle(100);
    CHECK(r.values().position_actual < 1200);
    CHECK(r.values().velocity_actual == 0);
    REQUIRE(r.mine.run_at(-50'000)); // inwards, to the other limit
    r.cycle(80);                     // the axis turns round at 1,000,000 a second
    CHECK(r.values().velocity_actual < -10'000);
    r.cycle(200);
    CHECK(r.values().position_actual < -900);
    CHECK(r.values().position_actual > -1400);
    CHECK(r.values().velocity_actual == 0);
    REQUIRE(r.mine.run_at(50'000)); // and back
    r.cycle(80);
    CHECK(r.values().velocity_actual > 10'000);
    r.cycle(200);
    CHECK(r.values().position_actual > 900);
    CHECK(r.values().position_actual < 1400);
    CHECK(r.values().velocity_actual == 0);
}

TEST_CASE("a drive at its limit that is not told to go further is not limited") {
    for (const int direction : {1, -1}) {
        rig r;
        r.values().min_position_limit = -1000;
        r.values().max_position_limit = 1000;
        r.motor().place(1000 * direction);
        r.enable_by_hand();
        r.exchange();
        CHECK((r.values().statusword & status_bits::internal_limit) == 0);
        r.places.store({.controlword = 0x0F, .mode = mode::cyclic_synchronous_velocity, .velocity = 1000 * direction},
                       r.outputs);
        r.exchange();
        CHECK((r.values().statusword & status_bits::internal_limit) != 0);
    }
}

TEST_CASE("a warning shows, and leaves the drive in its state") {
    rig r;
    r.exchange();
    const auto word = r.values().statusword;
    r.motor().disturbed.warning = true;
    r.exchange();
    CHECK(r.values().statusword == (word | status_bits::warning));
}

TEST_CASE("a drive that leaves OP stops by itself") {
    rig r;
    r.turn(50'000);
    r.operational = false;
    r.exchange();
    CHECK(r.motor().state() == state::fault_reaction_active);
    for (int i = 0; i != 20; ++i) r.exchange();
    CHECK(r.motor().state() == state::fault);
    CHECK(r.values().error_code == error_codes::communication);
    CHECK((r.values().statusword & status_bits::remote) == 0);
}

TEST_CASE("a drive that leaves OP in quick stop active has a fault, too") {
    rig r;
    r.turn(50'000);
    r.values().quick_stop_option = 6; // stays in quick stop active
    r.send(0x02, mode::cyclic_synchronous_velocity, 100);
    REQUIRE(r.motor().state() == state::quick_stop_active);
    r.operational = false;
    r.exchange();
    CHECK(r.values().error_code == error_codes::communication);
}

TEST_CASE("a drive that is not in OP takes no command but the reset of a fault") {
    rig r;
    r.operational = false;
    r.exchange();
    for (const auto each : {command::shutdown, command::quick_stop}) {
        r.values().controlword = control_of(each);
        r.exchange();
        CHECK(r.motor().state() == state::switch_on_disabled);
    }
    r.motor().disturbed.fault = error_codes::over_temperature;
    r.exchange();
    r.exchange();
    CHECK(r.motor().state() == state::fault);
    r.motor().disturbed.fault = 0;
    r.values().controlword = control_of(command::fault_reset);
    r.exchange();
    CHECK(r.motor().state() == state::switch_on_disabled);
}

TEST_CASE("a drive that leaves OP is ready to be switched on no longer, as soon as nothing prevents it") {
    rig r;
    r.send(0x06);
    CHECK(r.motor().state() == state::ready_to_switch_on);
    r.motor().disturbed.refused = state::switch_on_disabled;
    r.operational = false;
    r.exchange();
    CHECK(r.motor().state() == state::ready_to_switch_on);
    r.motor().disturbed.refused.reset();
    r.exchange();
    CHECK(r.motor().state() == state::switch_on_disabled);
}

namespace {

/// A drive whose PDOs its master assigns.
struct assigned_drive {
    emulated_drive<> drive{};
    ethercat::standard_objects standard{drive_description<>, drive};
    ethercat::assignable_pdos pdos{drive_description<>, standard};
    ethercat::slave slave{drive_description<>, pdos};
    ethercat::master_for<1> master{};
    test::simulated_link link{[this](std::span<std::byte> frame) { pass(frame); }};

    void pass(std::span<std::byte> frame) {
        slave.process(frame);
        drive.work(slave, pdos, link.now);
    }
    void write(std::uint16_t index, std::uint8_t subindex, const std::vector<int>& bytes) {
        std::vector<std::byte> data;
        for (const int each : bytes) data.push_back(static_cast<std::byte>(each));
        REQUIRE(link.run(master, ethercat::download{1, index, subindex, data}));
    }
};

} // namespace

TEST_CASE("a drive takes the targets that its master has assigned, in OP") {
    assigned_drive d;
    REQUIRE(d.link.run(d.master, ethercat::bring_up{0, 1}));
    d.write(0x1600, 0, {0});
    d.write(0x1600, 1, {0x20, 0x00, 0xFF, 0x60}); // target velocity
    d.write(0x1600, 2, {0x10, 0x00, 0x40, 0x60}); // controlword
    d.write(0x1600, 0, {2});
    d.write(0x6060, 0, {9}); // cyclic synchronous velocity
    REQUIRE(d.link.run(d.master, ethercat::configure{1}));
    CHECK(d.slave.outputs().size() == 6);
    REQUIRE(d.link.run(d.master, ethercat::change_state{1, ethercat::al_state::safe_op}));
    REQUIRE(d.link.run(d.master, ethercat::change_state{1, ethercat::al_state::op}));
    ethercat::process_data_for<1, 64> data{d.master.slaves(), ethercat::process_options{}};
    REQUIRE(data.fits());
    const auto outputs = data.outputs(d.master.slaves()[0]);
    for (const int word : {0x06, 0x07, 0x0F})
        for (int i = 0; i != 50; ++i) {
            outputs[1] = std::byte{4}; // 1024 a second
            outputs[4] = static_cast<std::byte>(word);
            d.link.now += 1ms;
            std::vector<std::byte> frame(ethercat::max_frame_size);
            data.begin_cycle();
            frame.resize(data.next_frame(frame, d.link.now));
            d.pass(frame);
            data.on_frame(frame);
        }
    CHECK(d.drive.axes[0].state() == state::operation_enabled);
    CHECK(d.drive.axes[0].velocity() == Approx(1024).margin(1));
}

TEST_CASE("faults can be injected: supply, a state that is refused") {
    rig r;
    r.motor().disturbed.refused = state::operation_enabled;
    r.mine.set_mode(mode::cyclic_synchronous_velocity);
    REQUIRE(r.mine.enable());
    r.cycle(2100);
    CHECK(r.mine.error() == axis_error{axis_errc::step_timeout, state::switched_on});

    rig supply;
    supply.turn(1000);
    supply.motor().disturbed.no_voltage = true;
    supply.send(0x0F, mode::cyclic_synchronous_velocity, 20);
    CHECK(supply.motor().state() == state::fault);
    CHECK((supply.values().statusword & status_bits::voltage_enabled) == 0);
}

TEST_CASE("the objects of a drive with two axes are described, read and written") {
    emulated_drive<2> drive;
    drive.axes[1].values.position_actual = -2;
    std::array<std::byte, 8> out{};
    CHECK(drive.read(0x6864, 0, out).size == 4);
    CHECK(load<std::int32_t>(pdo_place{0, 32}, out) == -2);
    CHECK(drive.read(0x7064, 0, out).error == ethercat::abort_code::no_object);
    CHECK(drive.read(0x6064, 1, out).error == ethercat::abort_code::no_subindex);
    CHECK(drive.read(0x607D, 0, out).size == 1);
    CHECK(out[0] == std::byte{2});
    const std::array<std::byte, 2> word{std::byte{5}, std::byte{0}};
    CHECK(drive.write(0x605A, 0, word) == ethercat::abort_code::none);
    CHECK(drive.axes[0].values.quick_stop_option == 5);
    CHECK(drive.axes[1].values.quick_stop_option == 2);
    CHECK(drive.write(0x6041, 0, word) == ethercat::abort_code::read_only);
    CHECK(drive.write(0x6083, 0, word) == ethercat::abort_code::length_mismatch);

    std::size_t count = 0;
    std::uint16_t before = 0;
    for (auto index = drive.next_index(0); index != 0; before = index, index = drive.next_index(index), ++count) {
        CHECK(index > before);
        REQUIRE(drive.describe(index));
    }
    CHECK(count == 2 * (value_slots.size() - 2)); // two records of two entries
    CHECK(drive.describe(0x60FF, 0)->access.rx_pdo);
    CHECK(drive_outputs<2>.size() == 12);
    CHECK(drive_outputs<2>[9].index == 0x687A);
}
