#include "simulation/joint_parts.hpp"

#include "simulation/messages.hpp"
#include <jauscat/bridge/joints/joint_part.hpp>
#include <jauscat/ethercat/cia402/emulated_drive.hpp>

#include <array>

namespace simulation {
namespace {

namespace bridging = jauscat::bridging;
namespace cia402 = jauscat::cia402;

template <std::size_t Axes> std::array<cia402::axis_places, Axes> places_in_drive() {
    cia402::pdo_layout<Axes * 8> outputs, inputs;
    for (const auto& each : cia402::drive_outputs<Axes>)
        static_cast<void>(outputs.append({each.bits, each.subindex, each.index}));
    for (const auto& each : cia402::drive_inputs<Axes>)
        static_cast<void>(inputs.append({each.bits, each.subindex, each.index}));
    std::array<cia402::axis_places, Axes> made{};
    for (std::size_t i = 0; i != Axes; ++i) made[i] = cia402::places_of(outputs, inputs, i);
    return made;
}

// Targets are reached at once, so that each says which command it is of.
template <std::size_t Joints> std::unique_ptr<bridging::process_part> part_of(std::size_t axes) {
    std::array<bridging::joint_options, Joints> made{};
    for (std::size_t i = 0; i != Joints; ++i)
        made[i] = {.slave = i / axes,
                   .drive_axis = i % axes,
                   .places = axes == 2 ? places_in_drive<2>()[i % 2] : places_in_drive<1>()[0],
                   .axis = {.max_velocity = 1e5, .acceleration = 1e9, .deceleration = 1e9},
                   .scale = {.increments_per_radian = increments_per_radian, .max_velocity = 1e5}};
    return std::make_unique<bridging::joint_part<Joints>>(made);
}

} // namespace

std::unique_ptr<bridging::process_part> make_joint_part(std::size_t joints, std::size_t axes) {
    switch (joints) {
    case 1: return part_of<1>(axes);
    case 2: return part_of<2>(axes);
    case 3: return part_of<3>(axes);
    case 4: return part_of<4>(axes);
    case 6: return part_of<6>(axes);
    default: return part_of<8>(axes);
    }
}

} // namespace simulation
