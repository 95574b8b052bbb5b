// Joint messages as SDO downloads to six emulated drives, and reports made of uploads.
#include "cia402/joint_arm.hpp"
#include "support/catch.hpp"
#include "support/simulated_link.hpp"
#include <jauscat/bridge/joints/object_jobs.hpp>

#include <array>

using namespace jauscat;
using namespace jauscat::translation;

namespace {

constexpr std::size_t joints = 6;

/// Drives in PRE-OP, `Axes` joints each, and a message in either direction.
template <std::size_t Axes> struct arm {
    std::array<test::joint_device<Axes>, joints / Axes> devices{};
    test::simulated_link link{[this](std::span<std::byte> frame) {
        for (auto& each : devices) each.slave.process(frame);
    }};
    ethercat::master_for<joints> master{};
    std::array<joint_scale, joints> scales{};
    std::array<bridging::axis_address, joints> where{};
    std::array<std::byte, 64> body{};

    arm() {
        for (std::uint16_t i = 0; i != devices.size(); ++i)
            REQUIRE(link.run(master, ethercat::bring_up{i, static_cast<std::uint16_t>(i + 1)}));
        for (std::size_t i = 0; i != joints; ++i) {
            scales[i] = {.increments_per_radian = 10'000, .reversed = i % 2 == 1, .max_velocity = 50'000};
            where[i] = {.station = static_cast<std::uint16_t>(i / Axes + 1), .axis = i % Axes};
        }
    }
    arm(const arm&) = delete;
    arm& operator=(const arm&) = delete;

    cia402::drive_values& values(std::size_t joint) { return devices[joint / Axes].drive.axes[joint % Axes].values; }

    template <class Table> translate::axis_bits write(const typename Table::message_type& message) {
        const auto encoded = wire::encode(message, body);
        REQUIRE(encoded);
        bridging::object_downloads<Table, joints> downloads;
        const auto limited = downloads.make(*encoded, scales, where);
        REQUIRE(limited);
        REQUIRE(downloads.jobs().size() == joints);
        for (const auto& each : downloads.jobs()) REQUIRE(link.run(master, each));
        return *limited;
    }
    template <class Table> typename Table::message_type read() {
        bridging::object_uploads<Table, joints> uploads{where};
        for (std::size_t i = 0; i != uploads.jobs().size(); ++i) {
            const auto done = link.run(master, uploads.jobs()[i]);
            REQUIRE(done);
            uploads.on_read(i, *done);
        }
        const auto written = uploads.report(scales, body);
        REQUIRE(written);
        CHECK(uploads.report(scales, body).error() == translate::errc::wrong_size); // stale
        typename Table::message_type message{};
        REQUIRE(wire::decode(message, *written));
        return message;
    }
};

template <std::size_t Axes> void check_all_messages() {
    arm<Axes> a;
    CHECK(a.template write<set_joint_positions_table<joints>>({.joint_position = {1, 1, -0.5, 0, 2, 0.25}}) == 0);
    CHECK(a.values(0).target_position == 10'000);
    CHECK(a.values(1).target_position == -10'000); // reversed
    CHECK(a.values(2).target_position == -5'000);
    CHECK(a.values(5).target_position == -2'500);
    CHECK(a.template write<set_joint_velocities_table<joints>>({.joint_velocity = {1, 1, 0, 9, 2, 3}}) == 1u << 3);
    CHECK(a.values(0).target_velocity == 10'000);
    CHECK(a.values(2).target_velocity == 0);
    CHECK(a.values(3).target_velocity == -50'000); // limited
    CHECK(a.values(5).target_velocity == -30'000);
    CHECK(a.template write<set_joint_efforts_table<joints>>({.joint_effort = {50, 50, 0, -100, 10, 20}}) == 0);
    CHECK(a.values(0).target_torque == 500);
    CHECK(a.values(3).target_torque == 1000);
    CHECK(a.values(5).target_torque == -200);

    for (std::size_t i = 0; i != joints; ++i) {
        a.values(i).position_actual = static_cast<std::int32_t>(1'000 * i);
        a.values(i).velocity_actual = static_cast<std::int32_t>(-2'000 * static_cast<int>(i));
        a.values(i).torque_actual = static_cast<std::int16_t>(-100 * static_cast<int>(i));
    }
    const auto positions = a.template read<report_joint_positions_table<joints>>().joint_position;
    const auto velocities = a.template read<report_joint_velocities_table<joints>>().joint_velocity;
    const auto efforts = a.template read<report_joint_efforts_table<joints>>().joint_effort;
    REQUIRE(positions.size() == joints);
    for (std::size_t i = 0; i != joints; ++i) {
        const double sign = i % 2 == 1 ? -1 : 1, joint = static_cast<double>(i);
        CHECK(positions[i] == Approx(sign * 0.1 * joint).margin(1e-6));
        CHECK(velocities[i] == Approx(sign * -0.2 * joint).margin(1e-6));
        CHECK(efforts[i] == Approx(sign * -10 * joint).margin(0.01));
    }
}

} // namespace

TEST_CASE("joint messages go as SDO downloads to six drives, and reports come from uploads") {
    check_all_messages<1>();
}

TEST_CASE("SDO downloads and uploads reach the axes of drives with several") { check_all_messages<3>(); }

TEST_CASE("a message for another number of joints becomes no download") {
    arm<1> a;
    bridging::object_downloads<set_joint_positions_table<joints>, joints> downloads;
    const auto five = wire::encode(jaus::basic_set_joint_positions<joints>{.joint_position = {1, 1, 1, 1, 1}}, a.body);
    REQUIRE(five);
    CHECK(downloads.make(*five, a.scales, a.where).error() == translate::errc::wrong_size);
    CHECK(downloads.jobs().empty());
}

TEST_CASE("a report is refused while an object has not been read") {
    arm<1> a;
    bridging::object_uploads<report_joint_efforts_table<joints>, joints> uploads{a.where};
    for (std::size_t i = 0; i != joints; ++i)
        uploads.on_read(i, i == 0 ? std::span<const std::byte>{} : std::span<const std::byte>{uploads.jobs()[i].into});
    CHECK(uploads.report(a.scales, a.body).error() == translate::errc::wrong_size);
    uploads.on_read(0, uploads.jobs()[0].into); // the others are of an earlier reading
    CHECK(uploads.report(a.scales, a.body).error() == translate::errc::wrong_size);
    for (std::size_t i = 0; i != joints; ++i) uploads.on_read(i, uploads.jobs()[i].into);
    CHECK(uploads.report(a.scales, a.body));
}
