// Component IDs that RA 3.3 has assigned.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace jauscat::jaus {

/// `.id = jaus::component_ids::primitive_driver`. 2 to 31 are free for components of one's own.
namespace component_ids {
enum component_id : std::uint8_t {
    node_manager = 1,
    subsystem_commander = 32,
    primitive_driver = 33,
    global_vector_driver = 34,
    communicator = 35,
    mission_spooler = 36,
    visual_sensor = 37,
    global_pose_sensor = 38,
    mission_planner = 39,
    system_commander = 40,
    local_pose_sensor = 41,
    velocity_state_sensor = 42,
    reflexive_driver = 43,
    local_vector_driver = 44,
    global_waypoint_driver = 45,
    local_waypoint_driver = 46,
    global_path_segment_driver = 47,
    local_path_segment_driver = 48,
    primitive_manipulator = 49,
    range_sensor = 50,
    manipulator_joint_position_sensor = 51,
    manipulator_joint_velocity_sensor = 52,
    manipulator_joint_force_torque_sensor = 53,
    manipulator_joint_positions_driver = 54,
    manipulator_end_effector_pose_driver = 55,
    manipulator_joint_velocities_driver = 56,
    manipulator_end_effector_velocity_state_driver = 57,
    manipulator_joint_move_driver = 58,
    manipulator_end_effector_discrete_pose_driver = 59,
    world_model_vector_knowledge_store = 61,
};
} // namespace component_ids
using component_ids::component_id;

/// A component ID and the standard's name of it.
struct component_kind {
    std::uint8_t id{};
    std::string_view name{};
};
inline constexpr std::array<component_kind, 30> component_kinds{{
    {1, "Node Manager"},
    {32, "Subsystem Commander"},
    {33, "Primitive Driver"},
    {34, "Global Vector Driver"},
    {35, "Communicator"},
    {36, "Mission Spooler"},
    {37, "Visual Sensor"},
    {38, "Global Pose Sensor"},
    {39, "Mission Planner"},
    {40, "System Commander"},
    {41, "Local Pose Sensor"},
    {42, "Velocity State Sensor"},
    {43, "Reflexive Driver"},
    {44, "Local Vector Driver"},
    {45, "Global Waypoint Driver"},
    {46, "Local Waypoint Driver"},
    {47, "Global Path Segment Driver"},
    {48, "Local Path Segment Driver"},
    {49, "Primitive Manipulator"},
    {50, "Range Sensor"},
    {51, "Manipulator Joint Position Sensor"},
    {52, "Manipulator Joint Velocity Sensor"},
    {53, "Manipulator Joint Force/Torque Sensor"},
    {54, "Manipulator Joint Positions Driver"},
    {55, "Manipulator End-Effector Pose Driver"},
    {56, "Manipulator Joint Velocities Driver"},
    {57, "Manipulator End-Effector Velocity State Driver"},
    {58, "Manipulator Joint Move Driver"},
    {59, "Manipulator End-Effector Discrete Pose Driver"},
    {61, "World Model Vector Knowledge Store"},
}};

/// Empty where the standard has assigned no component to the ID.
[[nodiscard]] constexpr std::string_view component_name(std::uint8_t id) noexcept {
    for (const auto& kind : component_kinds)
        if (kind.id == id) return kind.name;
    return {};
}

} // namespace jauscat::jaus
