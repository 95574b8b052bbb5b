// Manipulator subgroup of RA 3.3 part 3: joints and end effector of an arm.
#pragma once
#include <jauscat/schema/jaus/types.hpp>
#include <jauscat/wire/schema.hpp>

// The limits of joint positions, velocities and torques are those of revolute joints. For a prismatic joint the
// standard uses the same fields in metres and newtons with other limits; those are not known here.
namespace jauscat::jaus {

/// Set Tool Point: says where the tip of the tool is in the end effector's coordinate system.
/// Code 0604h, command class, 12 bytes.
struct set_tool_point {
    static constexpr std::uint16_t command_code = 0x0604;
    double x_coordinate_of_tool_tip{}; ///< metres, -15 to 15
    double y_coordinate_of_tool_tip{}; ///< metres, -15 to 15
    double z_coordinate_of_tool_tip{}; ///< metres, -15 to 15
    friend constexpr bool operator==(const set_tool_point&, const set_tool_point&) = default;
};

/// Set End-Effector Pose: sends the tool point to a position and attitude.
/// Code 0605h, command class, 28 bytes.
struct set_end_effector_pose {
    static constexpr std::uint16_t command_code = 0x0605;
    double x_component_of_tool_point{};        ///< metres, -30 to 30
    double y_component_of_tool_point{};        ///< metres, -30 to 30
    double z_component_of_tool_point{};        ///< metres, -30 to 30
    double d_component_of_unit_quaternion_q{}; ///< -1 to 1
    double a_component_of_unit_quaternion_q{}; ///< -1 to 1
    double b_component_of_unit_quaternion_q{}; ///< -1 to 1
    double c_component_of_unit_quaternion_q{}; ///< -1 to 1
    friend constexpr bool operator==(const set_end_effector_pose&, const set_end_effector_pose&) = default;
};

/// Coordinate System of Set End-Effector Velocity State.
enum class end_effector_coordinate_system : std::uint8_t {
    aligned_with_the_vehicle_coordinate_system = 0,
    aligned_with_the_end_effector_coordinate_system = 1,
};

/// Set End-Effector Velocity State: moves the end effector at the given velocities.
/// Code 0606h, command class, 25 bytes.
struct set_end_effector_velocity_state {
    static constexpr std::uint16_t command_code = 0x0606;
    end_effector_coordinate_system coordinate_system{}; ///< the axes that the velocities are given in
    double angular_velocity_x{};                        ///< radians per second, -20 pi to 20 pi
    double angular_velocity_y{};                        ///< radians per second, -20 pi to 20 pi
    double angular_velocity_z{};                        ///< radians per second, -20 pi to 20 pi
    double linear_velocity_x{};                         ///< metres per second, -10 to 10
    double linear_velocity_y{};                         ///< metres per second, -10 to 10
    double linear_velocity_z{};                         ///< metres per second, -10 to 10
    friend constexpr bool operator==(const set_end_effector_velocity_state&,
                                     const set_end_effector_velocity_state&) = default;
};

/// Query Manipulator Specifications. Code 2600h, query class, no body.
struct query_manipulator_specifications {
    static constexpr std::uint16_t command_code = 0x2600;
    friend constexpr bool operator==(const query_manipulator_specifications&,
                                     const query_manipulator_specifications&) = default;
};

/// Query Joint Efforts. Code 2601h, query class, no body.
struct query_joint_efforts {
    static constexpr std::uint16_t command_code = 0x2601;
    friend constexpr bool operator==(const query_joint_efforts&, const query_joint_efforts&) = default;
};

/// Query Joint Positions. Code 2602h, query class, no body.
struct query_joint_positions {
    static constexpr std::uint16_t command_code = 0x2602;
    friend constexpr bool operator==(const query_joint_positions&, const query_joint_positions&) = default;
};

/// Query Joint Velocities. Code 2603h, query class, no body.
struct query_joint_velocities {
    static constexpr std::uint16_t command_code = 0x2603;
    friend constexpr bool operator==(const query_joint_velocities&, const query_joint_velocities&) = default;
};

/// Query Tool Point. Code 2604h, query class, no body.
struct query_tool_point {
    static constexpr std::uint16_t command_code = 0x2604;
    friend constexpr bool operator==(const query_tool_point&, const query_tool_point&) = default;
};

/// Query Joint Force/Torques. Code 2605h, query class, no body.
struct query_joint_force_torques {
    static constexpr std::uint16_t command_code = 0x2605;
    friend constexpr bool operator==(const query_joint_force_torques&, const query_joint_force_torques&) = default;
};

/// Report Tool Point: where the tip of the tool is in the end effector's coordinate system.
/// Code 4604h, inform class, 12 bytes.
struct report_tool_point {
    static constexpr std::uint16_t command_code = 0x4604;
    double x_coordinate_of_tool_tip{}; ///< metres, -15 to 15
    double y_coordinate_of_tool_tip{}; ///< metres, -15 to 15
    double z_coordinate_of_tool_tip{}; ///< metres, -15 to 15
    friend constexpr bool operator==(const report_tool_point&, const report_tool_point&) = default;
};

} // namespace jauscat::jaus

// One line per field, as in the standard's table.
// clang-format off
namespace jauscat {

template <> struct wire::schema<jaus::set_tool_point> {
    using T = jaus::set_tool_point;
    using type = layout<
        field<&T::x_coordinate_of_tool_tip, scaled<u32le, jaus::tool_tip_coordinate>>,
        field<&T::y_coordinate_of_tool_tip, scaled<u32le, jaus::tool_tip_coordinate>>,
        field<&T::z_coordinate_of_tool_tip, scaled<u32le, jaus::tool_tip_coordinate>>>;
};

template <> struct wire::schema<jaus::set_end_effector_pose> {
    using T = jaus::set_end_effector_pose;
    using type = layout<
        field<&T::x_component_of_tool_point, scaled<u32le, jaus::manipulator_coordinate>>,
        field<&T::y_component_of_tool_point, scaled<u32le, jaus::manipulator_coordinate>>,
        field<&T::z_component_of_tool_point, scaled<u32le, jaus::manipulator_coordinate>>,
        field<&T::d_component_of_unit_quaternion_q, scaled<u32le, jaus::unit_vector_component>>,
        field<&T::a_component_of_unit_quaternion_q, scaled<u32le, jaus::unit_vector_component>>,
        field<&T::b_component_of_unit_quaternion_q, scaled<u32le, jaus::unit_vector_component>>,
        field<&T::c_component_of_unit_quaternion_q, scaled<u32le, jaus::unit_vector_component>>>;
};

template <> struct wire::schema<jaus::set_end_effector_velocity_state> {
    using T = jaus::set_end_effector_velocity_state;
    using type = layout<
        field<&T::coordinate_system, enumeration<jaus::end_effector_coordinate_system, u8>>,
        field<&T::angular_velocity_x, scaled<u32le, jaus::end_effector_angular_velocity>>,
        field<&T::angular_velocity_y, scaled<u32le, jaus::end_effector_angular_velocity>>,
        field<&T::angular_velocity_z, scaled<u32le, jaus::end_effector_angular_velocity>>,
        field<&T::linear_velocity_x, scaled<u32le, jaus::end_effector_linear_velocity>>,
        field<&T::linear_velocity_y, scaled<u32le, jaus::end_effector_linear_velocity>>,
        field<&T::linear_velocity_z, scaled<u32le, jaus::end_effector_linear_velocity>>>;
};

template <> struct wire::schema<jaus::query_manipulator_specifications> { using type = layout<>; };

template <> struct wire::schema<jaus::query_joint_efforts> { using type = layout<>; };

template <> struct wire::schema<jaus::query_joint_positions> { using type = layout<>; };

template <> struct wire::schema<jaus::query_joint_velocities> { using type = layout<>; };

template <> struct wire::schema<jaus::query_tool_point> { using type = layout<>; };

template <> struct wire::schema<jaus::query_joint_force_torques> { using type = layout<>; };

template <> struct wire::schema<jaus::report_tool_point> {
    using T = jaus::report_tool_point;
    using type = layout<
        field<&T::x_coordinate_of_tool_tip, scaled<u32le, jaus::tool_tip_coordinate>>,
        field<&T::y_coordinate_of_tool_tip, scaled<u32le, jaus::tool_tip_coordinate>>,
        field<&T::z_coordinate_of_tool_tip, scaled<u32le, jaus::tool_tip_coordinate>>>;
};

} // namespace jauscat
