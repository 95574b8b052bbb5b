// Six joints: JAUS messages to six emulated drives on one ring, and back.
#include "cia402/joint_arm.hpp"
#include "support/catch.hpp"
#include "support/simulated_link.hpp"
#include <jauscat/ethercat/master/process_data.hpp>

#include <array>
#include <memory>
#include <optional>
#include <vector>

using namespace jauscat;
using namespace std::chrono_literals;
using bridging::joint_errc;
using bridging::joint_group_state;
using cia402::axis_errc;

namespace {

constexpr std::size_t joints = 6;
constexpr std::uint16_t set_positions = jaus::command_code_of<jaus::set_joint_positions>;
constexpr std::uint16_t set_velocities = jaus::command_code_of<jaus::set_joint_velocities>;
constexpr std::uint16_t set_efforts = jaus::command_code_of<jaus::set_joint_efforts>;
constexpr std::uint16_t report_positions = jaus::command_code_of<jaus::report_joint_positions>;
constexpr std::uint16_t report_velocities = jaus::command_code_of<jaus::report_joint_velocities>;

/// The drives on a ring in OP, its master, and the arm.
template <std::size_t Axes = 1> struct arm {
    std::array<test::joint_device<Axes>, joints / Axes> devices{};
    test::simulated_link link{[this](std::span<std::byte> frame) { pass(frame); }};
    ethercat::master_for<joints> master{};
    std::optional<ethercat::process_data_for<joints, 1024>> data{};
    bridging::joint_group<joints> group{test::joint_arm<Axes>()};

    arm() {
        REQUIRE(group.is_usable());
        for (std::uint16_t i = 0; i != devices.size(); ++i) {
            const auto station = static_cast<std::uint16_t>(i + 1);
            REQUIRE(link.run(master, ethercat::bring_up{i, station}));
            REQUIRE(link.run(master, ethercat::configure{station}));
            REQUIRE(link.run(master, ethercat::change_state{station, ethercat::al_state::safe_op}));
        }
        for (std::uint16_t i = 0; i != devices.size(); ++i)
            REQUIRE(
                link.run(master, ethercat::change_state{static_cast<std::uint16_t>(i + 1), ethercat::al_state::op}));
        data.emplace(master.slaves(), ethercat::process_options{.watch_slaves = true});
        REQUIRE(data->fits());
    }
    arm(const arm&) = delete;
    arm& operator=(const arm&) = delete;

    void pass(std::span<std::byte> frame) {
        for (auto& each : devices)
            if (each.connected) each.slave.process(frame);
    }
    cia402::emulated_axis& motor(std::size_t joint) { return devices[joint / Axes].drive.axes[joint % Axes]; }
    /// One cycle of 1 ms: frame out and back, then the group.
    void cycle(int count = 1) {
        for (int i = 0; i != count; ++i) {
            link.now += 1ms;
            std::vector<std::byte> frame(ethercat::max_frame_size);
            data->begin_cycle();
            frame.resize(data->next_frame(frame, link.now));
            pass(frame);
            data->on_frame(frame);
            for (auto& each : devices) {
                each.slave.on_time(link.now);
                each.drive.work(each.slave, link.now);
            }
            step();
        }
    }
    /// Of the group alone.
    void step() {
        std::array<bridging::drive_image, joints / Axes> images{};
        for (std::size_t s = 0; s != images.size(); ++s) {
            const auto& record = master.slaves()[s];
            const bool is_current = data->status(record).ran_within(2ms, link.now);
            images[s] = {data->outputs(record), data->inputs(record),
                         is_current ? bridging::input_age::current : missing};
        }
        group.step(images, link.now);
    }
    bridging::input_age missing{bridging::input_age::lost}; ///< what a drive without an answer is
    template <class Message> joint_errc command(std::uint16_t code, const Message& message) {
        std::array<std::byte, 64> body{};
        const auto encoded = wire::encode(message, body);
        REQUIRE(encoded);
        return group.command(code, *encoded).error();
    }
    joint_errc turn(double rate) {
        return command(set_velocities, jaus::basic_set_joint_velocities<joints>{
                                           .joint_velocity = {rate, rate, rate, rate, rate, rate}});
    }
    template <class Report> Report report(std::uint16_t code) {
        std::array<std::byte, 64> body{};
        const auto written = group.report(code, body);
        REQUIRE(written);
        Report message{};
        REQUIRE(wire::decode(message, *written));
        return message;
    }
    double velocity(std::size_t joint) {
        return report<jaus::basic_report_joint_velocities<joints>>(report_velocities).joint_velocity[joint];
    }
};

} // namespace

TEST_CASE("a command enables six drives and takes effect in the same cycle") {
    arm a;
    a.cycle(5);
    CHECK(a.group.state() == joint_group_state::at_rest);
    REQUIRE(a.turn(2.0) == joint_errc::ok);
    CHECK(a.group.state() == joint_group_state::starting);
    int cycles = 0;
    for (; a.group.state() == joint_group_state::starting && cycles != 100; ++cycles) {
        for (std::size_t i = 0; i != joints; ++i) CHECK(a.group.axis(i).targets().velocity == 0);
        a.cycle();
    }
    CHECK(cycles < 20);
    a.cycle(100);
    CHECK(a.group.state() == joint_group_state::moving);
    for (std::size_t i = 0; i != joints; ++i) {
        CHECK(a.velocity(i) == Approx(2.0).margin(0.01));
        CHECK(a.motor(i).velocity() == Approx(i % 2 == 1 ? -20'000 : 20'000).margin(100));
    }
    a.group.stop();
    a.cycle(100);
    CHECK(a.group.is_at_rest());
    CHECK(a.group.state() == joint_group_state::at_rest);
}

TEST_CASE("a command of the mode in force changes the targets in the next cycle, without a step back") {
    arm a;
    a.cycle(5);
    REQUIRE(a.turn(2.0) == joint_errc::ok);
    a.cycle(100);
    REQUIRE(a.group.axis(0).targets().velocity == 20'000);
    REQUIRE(a.turn(2.0) == joint_errc::ok);
    a.cycle();
    CHECK(a.group.has_targets());
    CHECK(a.group.axis(0).targets().velocity == 20'000);
    REQUIRE(a.turn(3.0) == joint_errc::ok);
    a.cycle();
    CHECK(a.group.axis(0).targets().velocity == 22'000); // 2,000,000 increments/s^2
}

TEST_CASE("positions are reached and reported; the next message changes the mode") {
    arm a;
    a.cycle(5);
    REQUIRE(a.command(set_positions, jaus::basic_set_joint_positions<joints>{
                                         .joint_position = {0.5, -0.5, 1.0, -1.0, 0.25, 0.0}}) == joint_errc::ok);
    a.cycle(800);
    const auto report = a.report<jaus::basic_report_joint_positions<joints>>(report_positions);
    REQUIRE(report.joint_position.size() == joints);
    CHECK(report.joint_position[0] == Approx(0.5).margin(0.001));
    CHECK(report.joint_position[1] == Approx(-0.5).margin(0.001));
    CHECK(report.joint_position[3] == Approx(-1.0).margin(0.001));

    REQUIRE(a.command(set_efforts, jaus::basic_set_joint_efforts<joints>{.joint_effort = {5, 5, 5, 5, 5, 5}}) ==
            joint_errc::ok);
    a.cycle(50);
    CHECK(a.group.axis(0).feedback().mode == cia402::mode::cyclic_synchronous_torque);
    CHECK(a.group.axis(0).feedback().torque == 50);
    CHECK(a.group.axis(1).feedback().torque == -50);
}

TEST_CASE("an emergency stops all drives in one cycle, and nothing moves after it without a command") {
    arm a;
    a.cycle(5);
    REQUIRE(a.turn(2.0) == joint_errc::ok);
    a.cycle(100);
    a.group.emergency();
    a.cycle();
    for (std::size_t i = 0; i != joints; ++i) CHECK(a.group.axis(i).targets().controlword == 0x02);
    CHECK(a.turn(1.0) == joint_errc::in_emergency);
    a.cycle(50);
    CHECK(a.group.is_at_rest());
    CHECK(a.group.state() == joint_group_state::emergency);
    a.group.clear_emergency();
    a.cycle(50);
    CHECK(a.group.state() == joint_group_state::at_rest);
    for (std::size_t i = 0; i != joints; ++i) CHECK(std::abs(a.motor(i).velocity()) < 10);
    REQUIRE(a.turn(1.0) == joint_errc::ok);
    a.cycle(100);
    CHECK(a.velocity(5) == Approx(1.0).margin(0.01));
}

TEST_CASE("a fault of one drive brings the others to rest, and is reset on request") {
    arm a;
    a.cycle(5);
    REQUIRE(a.turn(2.0) == joint_errc::ok);
    a.cycle(100);
    a.motor(3).disturbed.fault = cia402::error_codes::over_current;
    a.cycle(3);
    CHECK(a.group.state() == joint_group_state::failed);
    CHECK(a.group.failed_joint() == 3);
    CHECK(a.group.axis(3).error().drive_code == cia402::error_codes::over_current);
    CHECK(a.turn(1.0) == joint_errc::has_failed);
    a.cycle(100);
    CHECK(a.group.is_at_rest());
    a.motor(3).disturbed.fault = 0;
    a.group.reset();
    a.cycle(200);
    CHECK(a.group.state() == joint_group_state::at_rest);
    REQUIRE(a.turn(1.0) == joint_errc::ok);
    a.cycle(100);
    CHECK(a.velocity(3) == Approx(1.0).margin(0.01));
}

TEST_CASE("a drive that disappears brings the others to rest, and its values are not reported") {
    arm a;
    a.cycle(5);
    REQUIRE(a.turn(2.0) == joint_errc::ok);
    a.cycle(100);
    a.devices[2].connected = false;
    a.cycle(4);
    CHECK(a.group.state() == joint_group_state::failed);
    CHECK(a.group.failed_joint() == 2);
    CHECK(a.group.axis(2).error().code == axis_errc::inputs_lost);
    std::array<std::byte, 64> body{};
    CHECK(a.group.report(report_positions, body).error() == joint_errc::not_current);
    a.cycle(150);
    for (const std::size_t i : {0u, 1u, 3u, 4u, 5u}) CHECK(std::abs(a.motor(i).velocity()) < 10);
    CHECK(a.devices[2].slave.state() == ethercat::al_state::safe_op); // its watchdog
    CHECK(a.motor(2).state() == cia402::state::fault);
    CHECK(std::abs(a.motor(2).velocity()) < 10);
}

TEST_CASE("a drive that is lost at rest is not known to be at rest") {
    arm a;
    a.cycle(5);
    CHECK(a.group.is_at_rest());
    a.devices[2].connected = false;
    a.cycle(4);
    CHECK(!a.group.is_at_rest(2));
    CHECK(!a.group.is_at_rest());
    CHECK(a.group.is_at_rest(3));
}

TEST_CASE("a drive that is late keeps its targets, and goes on to rest if it is told to") {
    arm a;
    a.cycle(5);
    REQUIRE(a.turn(2.0) == joint_errc::ok);
    a.cycle(100);
    a.missing = bridging::input_age::late;
    a.devices[2].connected = false;
    a.cycle(8);
    CHECK(a.group.state() == joint_group_state::moving);
    const auto target = [&a] { return std::abs(a.group.axis(2).targets().velocity); };
    CHECK(target() == Approx(20'000).margin(1));
    SECTION("it answers again") {
        a.devices[2].connected = true;
        a.cycle(3);
        CHECK(a.group.state() == joint_group_state::moving);
        CHECK(a.velocity(2) == Approx(2.0).margin(0.02));
    }
    SECTION("a stop order comes in between") {
        a.group.stop();
        a.cycle();
        CHECK(target() < 20'000);
        a.cycle(15);
        CHECK(target() == 0);
    }
    SECTION("so does an emergency") {
        a.group.emergency();
        a.cycle();
        CHECK(a.group.axis(2).targets().controlword == cia402::control_of(cia402::command::quick_stop));
    }
}

namespace {
/// Its joints turn at 1 rad/s, 10,000 increments/s, and a drive without an answer is late.
struct turning_arm : arm<> {
    turning_arm() {
        missing = bridging::input_age::late;
        cycle(5);
        REQUIRE(turn(1.0) == joint_errc::ok);
        cycle(100);
    }
    /// Each drive has its targets of the first cycle towards a higher velocity.
    [[nodiscard]] bool is_faster_in_all_drives() const {
        for (std::size_t i = 0; i != joints; ++i)
            if (std::abs(std::abs(group.axis(i).targets().velocity) - 12'000) > 1) return false;
        return true;
    }
};
} // namespace

TEST_CASE("a command takes effect in all drives in the same cycle, also in one that is late") {
    turning_arm a;
    a.devices[2].connected = false;
    a.cycle(4);
    REQUIRE(a.turn(2.0) == joint_errc::ok);
    a.cycle();
    CHECK(a.group.has_targets());
    CHECK(a.is_faster_in_all_drives());
}

TEST_CASE("a group has the targets of a command once its axes have moved on towards them") {
    turning_arm a;
    if (GENERATE(false, true)) {
        a.devices[2].connected = false;
        a.cycle(4);
    }
    REQUIRE(a.turn(2.0) == joint_errc::ok);
    a.step(); // another cycle that ends in this instant
    CHECK(!a.group.has_targets());
    CHECK(a.group.is_following());
    a.cycle();
    CHECK(a.group.has_targets());
    CHECK(a.is_faster_in_all_drives());
}

TEST_CASE("a message for another number of joints changes nothing") {
    arm a;
    a.cycle(5);
    REQUIRE(a.turn(2.0) == joint_errc::ok);
    a.cycle(100);
    CHECK(a.command(set_velocities, jaus::basic_set_joint_velocities<joints>{.joint_velocity = {0, 0, 0, 0, 0}}) ==
          joint_errc::wrong_count);
    CHECK(a.command(0x0405, jaus::basic_set_joint_velocities<joints>{}) == joint_errc::unknown_message);
    a.cycle(100);
    CHECK(a.velocity(0) == Approx(2.0).margin(0.01));
    CHECK(a.turn(20.0) == joint_errc::ok); // 200,000 increments/s, limited to 100,000
    a.cycle(200);
    CHECK(a.velocity(0) == Approx(10.0).margin(0.05));
}

TEST_CASE("joints may share a drive with several axes") {
    arm<3> a;
    a.cycle(5);
    REQUIRE(a.turn(2.0) == joint_errc::ok);
    a.cycle(120);
    for (std::size_t i = 0; i != joints; ++i) CHECK(a.velocity(i) == Approx(2.0).margin(0.01));
    a.motor(4).disturbed.fault = cia402::error_codes::over_temperature;
    a.cycle(100);
    CHECK(a.group.failed_joint() == 4);
    CHECK(a.motor(3).state() == cia402::state::switch_on_disabled);
}

TEST_CASE("a group serves the commands that its process data have the objects for") {
    auto options = test::joint_arm<1>();
    for (auto& each : options) {
        each.places.mode = {};
        each.places.fixed_mode = cia402::mode::cyclic_synchronous_velocity;
    }
    const bridging::joint_group<joints> velocities{options};
    CHECK(velocities.is_usable());
    CHECK(velocities.serves(set_velocities));
    CHECK(!velocities.serves(set_positions));
    options[4].places.target_velocity = {};
    CHECK(!bridging::joint_group<joints>{options}.is_usable());
    options = test::joint_arm<1>();
    for (auto& each : options) {
        each.places.mode = {};
        each.places.fixed_mode = cia402::mode::cyclic_synchronous_position;
    }
    const bridging::joint_group<joints> positions{options};
    CHECK(positions.is_usable());
    CHECK(positions.serves(set_positions));
    CHECK(!positions.serves(set_velocities));
}
