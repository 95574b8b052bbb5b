// A drive by CiA 402 and its master's axis, and JAUS joint messages as objects: the code of drives.md.
//     docs_drives
// [includes]
#include <jauscat/ethercat/cia402/axis_places.hpp>
#include <jauscat/ethercat/cia402/emulated_drive.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/schema/translation/joint_tables.hpp>

#include <iostream>

using namespace jauscat;
using namespace std::chrono_literals;
// [includes end]

// [own]
struct motor {
    double newton_metres{}; ///< rated torque x gear
};

struct newton_metres_as_torque {
    static constexpr std::string_view from = "N m";
    static constexpr auto to = cia402::unit::rated_torque;
    static constexpr bool zero_within_step = false;
    static constexpr double to_object(double torque, const motor& m) noexcept {
        return torque * 1000 / m.newton_metres;
    }
    static constexpr double limited(double value, const motor&) noexcept { return value; }
    static constexpr double from_object(double value, const motor& m) noexcept {
        return value * m.newton_metres / 1000;
    }
};

using report = jaus::basic_report_joint_force_torques<6>;
using torques = translate::object_table<
    report, motor,
    translate::axis_row<&report::joint_force_torque, cia402::objects::torque_actual, newton_metres_as_torque>>;
// [own end]

int main() {
    // [drive]
    cia402::emulated_drive<> drive{{.rated_acceleration = 1e7}};
    ethercat::standard_objects dictionary{cia402::drive_description<>, drive};
    ethercat::slave slave{cia402::drive_description<>, dictionary};
    // After each frame that the slave has processed, and every few milliseconds without one:
    const auto work = [&](time_point now) { drive.work(slave, now); };
    // [drive end]
    work({});

    // [places]
    cia402::pdo_layout<> outputs, inputs;
    bool fits = true; // a pdo_layout<> has 64 entries
    for (const std::uint32_t entry :
         {0x6040'0010u, 0x6060'0008u, 0x0000'0008u, 0x607A'0020u, 0x60FF'0020u, 0x6071'0010u})
        fits = outputs.append(cia402::mapping_of(entry)) && fits;
    for (const std::uint32_t entry :
         {0x6041'0010u, 0x6061'0008u, 0x0000'0008u, 0x6064'0020u, 0x606C'0020u, 0x6077'0010u})
        fits = inputs.append(cia402::mapping_of(entry)) && fits;
    const auto places = cia402::places_of(outputs, inputs); // or those of another axis of the drive
    const auto* const lacks = places.missing_for(cia402::mode::cyclic_synchronous_position);
    // [places end]
    if (!fits || lacks != nullptr) return 1;

    std::array<std::byte, 14> output_bytes{};
    std::array<std::byte, 16> input_bytes{};
    cia402::axis axis{{.max_velocity = 100'000}};
    const auto cycle = [&](time_point now) {
        drive.take(output_bytes);
        drive.axes[0].on_time(now, true);
        drive.give(input_bytes);
        // [cycle]
        places.store(axis.on_cycle(places.load(input_bytes), now), output_bytes);
        // [cycle end]
    };
    time_point now{};
    axis.set_mode(cia402::mode::cyclic_synchronous_position);
    if (!axis.enable()) return 1;
    while (axis.state() != cia402::axis_state::enabled && now < time_point{1s}) cycle(now += 1ms);
    if (!axis.move_to(25'000)) return 1;
    while (!axis.is_target_reached() || axis.feedback().position != 25'000) cycle(now += 1ms);
    std::cout << describe(*axis.drive_state()) << ", at " << axis.feedback().position << '\n';

    const std::array<translation::joint_scale, 1> scales{{{.full_effort = 500}}};
    const std::array body{std::byte{1}, std::byte{0xFF}, std::byte{0xFF}}; // one joint, 100 %
    // [efforts]
    using efforts = translate::object_translator<translation::set_joint_efforts_table<1>>;
    const auto limited = efforts::to_objects(body, scales, [&](std::size_t joint, const auto& object, auto value) {
        std::cout << "joint " << joint + 1 << ": " << object.name << " = " << value << '\n';
        cia402::store(places.target_torque, output_bytes, value);
    });
    // [efforts end]
    if (!limited) return 1;

    std::array<std::byte, 64> written{};
    const std::array<motor, 2> motors{motor{.newton_metres = 50}, motor{.newton_metres = 20}};
    const auto message = translate::object_translator<torques>::from_objects(
        [](std::size_t, const auto&) { return 100; }, motors, written);
    std::cout << "Report Joint Force/Torques: " << (message ? message->size() : 0) << " bytes\n";
    return 0;
}
