// Manipulator subgroup of RA 3.3 part 3: joints and end effector of an arm.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/jaus/types.hpp>
#include <jauscat/wire/schema.hpp>

// The limits of joint positions, velocities and torques are those of revolute joints. For a prismatic joint the
// standard uses the same fields in metres and newtons with other limits; those are not known here.
// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::jaus {

/// Set Joint Efforts: drives the joints open-loop, in percent of their capability.
/// Code 0601h, command class, 1 byte or more.
template <std::size_t Capacity> struct basic_set_joint_efforts {
    wire::inline_list<double, Capacity> joint_effort{}; ///< percent, -100 to 100; from joint 1
    friend constexpr bool operator==(const basic_set_joint_efforts&, const basic_set_joint_efforts&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0601;
        using T = basic_set_joint_efforts<Capacity>;
        using type = layout<
            repeated<&T::joint_effort, count<"number_of_joints", u8>,
                element<"joint", scaled<u16le, signed_percent>>>>;
    };
};
using set_joint_efforts = basic_set_joint_efforts<255>;

/// Set Joint Positions: sends the joints to the given positions.
/// Code 0602h, command class, 1 byte or more.
template <std::size_t Capacity> struct basic_set_joint_positions {
    wire::inline_list<double, Capacity> joint_position{}; ///< radians, -8 pi to 8 pi; from joint 1
    friend constexpr bool operator==(const basic_set_joint_positions&, const basic_set_joint_positions&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0602;
        using T = basic_set_joint_positions<Capacity>;
        using type = layout<
            repeated<&T::joint_position, count<"number_of_joints", u8>,
                element<"joint", scaled<u32le, joint_angle>>>>;
    };
};
using set_joint_positions = basic_set_joint_positions<255>;

/// Set Joint Velocities: moves the joints at the given velocities.
/// Code 0603h, command class, 1 byte or more.
template <std::size_t Capacity> struct basic_set_joint_velocities {
    wire::inline_list<double, Capacity> joint_velocity{}; ///< radians per second, -10 pi to 10 pi; from joint 1
    friend constexpr bool operator==(const basic_set_joint_velocities&, const basic_set_joint_velocities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0603;
        using T = basic_set_joint_velocities<Capacity>;
        using type = layout<
            repeated<&T::joint_velocity, count<"number_of_joints", u8>,
                element<"joint", scaled<u32le, joint_angular_velocity>>>>;
    };
};
using set_joint_velocities = basic_set_joint_velocities<255>;

/// Set Tool Point: sets the position of the tool's tip in the end effector's coordinate system.
/// Code 0604h, command class, 12 bytes.
struct set_tool_point {
    double x_coordinate_of_tool_tip{}; ///< metres, -15 to 15
    double y_coordinate_of_tool_tip{}; ///< metres, -15 to 15
    double z_coordinate_of_tool_tip{}; ///< metres, -15 to 15
    friend constexpr bool operator==(const set_tool_point&, const set_tool_point&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0604;
        using T = set_tool_point;
        using type = layout<
            field<&T::x_coordinate_of_tool_tip, scaled<u32le, tool_tip_coordinate>>,
            field<&T::y_coordinate_of_tool_tip, scaled<u32le, tool_tip_coordinate>>,
            field<&T::z_coordinate_of_tool_tip, scaled<u32le, tool_tip_coordinate>>>;
    };
};

/// Set End-Effector Pose: sends the tool point to a position and attitude.
/// Code 0605h, command class, 28 bytes.
struct set_end_effector_pose {
    double x_component_of_tool_point{};        ///< metres, -30 to 30
    double y_component_of_tool_point{};        ///< metres, -30 to 30
    double z_component_of_tool_point{};        ///< metres, -30 to 30
    double d_component_of_unit_quaternion_q{}; ///< -1 to 1
    double a_component_of_unit_quaternion_q{}; ///< -1 to 1
    double b_component_of_unit_quaternion_q{}; ///< -1 to 1
    double c_component_of_unit_quaternion_q{}; ///< -1 to 1
    friend constexpr bool operator==(const set_end_effector_pose&, const set_end_effector_pose&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0605;
        using T = set_end_effector_pose;
        using type = layout<
            field<&T::x_component_of_tool_point, scaled<u32le, manipulator_coordinate>>,
            field<&T::y_component_of_tool_point, scaled<u32le, manipulator_coordinate>>,
            field<&T::z_component_of_tool_point, scaled<u32le, manipulator_coordinate>>,
            field<&T::d_component_of_unit_quaternion_q, scaled<u32le, unit_vector_component>>,
            field<&T::a_component_of_unit_quaternion_q, scaled<u32le, unit_vector_component>>,
            field<&T::b_component_of_unit_quaternion_q, scaled<u32le, unit_vector_component>>,
            field<&T::c_component_of_unit_quaternion_q, scaled<u32le, unit_vector_component>>>;
    };
};

/// Coordinate System of Set End-Effector Velocity State.
enum class end_effector_coordinate_system : std::uint8_t {
    aligned_with_the_vehicle_coordinate_system = 0,
    aligned_with_the_end_effector_coordinate_system = 1,
};

/// Set End-Effector Velocity State: moves the end effector at the given velocities.
/// Code 0606h, command class, 25 bytes.
struct set_end_effector_velocity_state {
    end_effector_coordinate_system coordinate_system{}; ///< the axes that the velocities are given in
    double angular_velocity_x{};                        ///< radians per second, -20 pi to 20 pi
    double angular_velocity_y{};                        ///< radians per second, -20 pi to 20 pi
    double angular_velocity_z{};                        ///< radians per second, -20 pi to 20 pi
    double linear_velocity_x{};                         ///< metres per second, -10 to 10
    double linear_velocity_y{};                         ///< metres per second, -10 to 10
    double linear_velocity_z{};                         ///< metres per second, -10 to 10
    friend constexpr bool operator==(const set_end_effector_velocity_state&,
                                     const set_end_effector_velocity_state&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0606;
        using T = set_end_effector_velocity_state;
        using type = layout<
            field<&T::coordinate_system, enumeration<end_effector_coordinate_system, u8>>,
            field<&T::angular_velocity_x, scaled<u32le, end_effector_angular_velocity>>,
            field<&T::angular_velocity_y, scaled<u32le, end_effector_angular_velocity>>,
            field<&T::angular_velocity_z, scaled<u32le, end_effector_angular_velocity>>,
            field<&T::linear_velocity_x, scaled<u32le, end_effector_linear_velocity>>,
            field<&T::linear_velocity_y, scaled<u32le, end_effector_linear_velocity>>,
            field<&T::linear_velocity_z, scaled<u32le, end_effector_linear_velocity>>>;
    };
};

/// One joint in a pose of Set Joint Motion. 16 bytes.
struct joint_motion {
    double joint_position{};             ///< radians, -8 pi to 8 pi
    double joint_maximum_velocity{};     ///< radians per second, -10 pi to 10 pi
    double joint_maximum_acceleration{}; ///< radians per second squared, -10 pi to 10 pi
    double joint_maximum_deceleration{}; ///< radians per second squared, -10 pi to 10 pi
    friend constexpr bool operator==(const joint_motion&, const joint_motion&) = default;

    struct schema : wire::items {
        using T = joint_motion;
        using type = layout<
            field<&T::joint_position, scaled<u32le, joint_angle>>,
            field<&T::joint_maximum_velocity, scaled<u32le, joint_angular_velocity>>,
            field<&T::joint_maximum_acceleration, scaled<u32le, joint_angular_acceleration>>,
            field<&T::joint_maximum_deceleration, scaled<u32le, joint_angular_acceleration>>>;
    };
};

/// One pose of Set Joint Motion. 4 bytes or more.
struct joint_motion_pose {
    double pose_time{};               ///< seconds, 0 to 6000
    wire::list<joint_motion> joint{}; ///< as many as the message has joints; from joint 1
    friend constexpr bool operator==(const joint_motion_pose&, const joint_motion_pose&) = default;

    struct schema; ///< below the message, whose field it counts by
};

/// Set Joint Motion: sends all joints through a sequence of poses.
/// Code 0607h, command class, 2 bytes or more.
struct set_joint_motion {
    std::uint8_t number_of_joints{};      ///< joints in each pose
    wire::list<joint_motion_pose> pose{}; ///< in the order of time
    friend constexpr bool operator==(const set_joint_motion&, const set_joint_motion&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0607;
        using T = set_joint_motion;
        using type = layout<
            field<&T::number_of_joints, u8>,
            repeated<&T::pose, count<"number_of_poses", u8>>>;
    };
};

struct joint_motion_pose::schema : wire::items {
    using T = joint_motion_pose;
    using type = layout<
        field<&T::pose_time, scaled<u32le, pose_duration>>,
        repeated<&T::joint, counted_by<&set_joint_motion::number_of_joints>>>;
};

/// One pose of Set End-Effector Path Motion. 32 bytes.
struct end_effector_path_pose {
    double pose_time{};                        ///< seconds, 0 to 6000
    double x_component_of_tool_point{};        ///< metres, -30 to 30
    double y_component_of_tool_point{};        ///< metres, -30 to 30
    double z_component_of_tool_point{};        ///< metres, -30 to 30
    double d_component_of_unit_quaternion_q{}; ///< -1 to 1
    double a_component_of_unit_quaternion_q{}; ///< -1 to 1
    double b_component_of_unit_quaternion_q{}; ///< -1 to 1
    double c_component_of_unit_quaternion_q{}; ///< -1 to 1
    friend constexpr bool operator==(const end_effector_path_pose&, const end_effector_path_pose&) = default;

    struct schema : wire::items {
        using T = end_effector_path_pose;
        using type = layout<
            field<&T::pose_time, scaled<u32le, pose_duration>>,
            field<&T::x_component_of_tool_point, scaled<u32le, manipulator_coordinate>>,
            field<&T::y_component_of_tool_point, scaled<u32le, manipulator_coordinate>>,
            field<&T::z_component_of_tool_point, scaled<u32le, manipulator_coordinate>>,
            field<&T::d_component_of_unit_quaternion_q, scaled<u32le, unit_vector_component>>,
            field<&T::a_component_of_unit_quaternion_q, scaled<u32le, unit_vector_component>>,
            field<&T::b_component_of_unit_quaternion_q, scaled<u32le, unit_vector_component>>,
            field<&T::c_component_of_unit_quaternion_q, scaled<u32le, unit_vector_component>>>;
    };
};

/// Set End-Effector Path Motion: sends the tool point along a path of poses.
/// Code 0608h, command class, 1 byte or more.
struct set_end_effector_path_motion {
    wire::list<end_effector_path_pose> pose{}; ///< in the order of time
    friend constexpr bool operator==(const set_end_effector_path_motion&,
                                     const set_end_effector_path_motion&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0608;
        using T = set_end_effector_path_motion;
        using type = layout<repeated<&T::pose, count<"number_of_poses", u8>>>;
    };
};

/// Query Manipulator Specifications: asks for Report Manipulator Specifications.
/// Code 2600h, query class, no body.
struct query_manipulator_specifications {
    friend constexpr bool operator==(const query_manipulator_specifications&,
                                     const query_manipulator_specifications&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2600;
        using report = struct report_manipulator_specifications;
        using type = layout<>;
    };
};

template <std::size_t Capacity> struct basic_report_joint_efforts;
using report_joint_efforts = basic_report_joint_efforts<255>;

/// Query Joint Efforts: asks for Report Joint Efforts.
/// Code 2601h, query class, no body.
struct query_joint_efforts {
    friend constexpr bool operator==(const query_joint_efforts&, const query_joint_efforts&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2601;
        using report = report_joint_efforts;
        using type = layout<>;
    };
};

template <std::size_t Capacity> struct basic_report_joint_positions;
using report_joint_positions = basic_report_joint_positions<255>;

/// Query Joint Positions: asks for Report Joint Positions.
/// Code 2602h, query class, no body.
struct query_joint_positions {
    friend constexpr bool operator==(const query_joint_positions&, const query_joint_positions&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2602;
        using report = report_joint_positions;
        using type = layout<>;
    };
};

template <std::size_t Capacity> struct basic_report_joint_velocities;
using report_joint_velocities = basic_report_joint_velocities<255>;

/// Query Joint Velocities: asks for Report Joint Velocities.
/// Code 2603h, query class, no body.
struct query_joint_velocities {
    friend constexpr bool operator==(const query_joint_velocities&, const query_joint_velocities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2603;
        using report = report_joint_velocities;
        using type = layout<>;
    };
};

/// Query Tool Point: asks for Report Tool Point.
/// Code 2604h, query class, no body.
struct query_tool_point {
    friend constexpr bool operator==(const query_tool_point&, const query_tool_point&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2604;
        using report = struct report_tool_point;
        using type = layout<>;
    };
};

template <std::size_t Capacity> struct basic_report_joint_force_torques;
using report_joint_force_torques = basic_report_joint_force_torques<255>;

/// Query Joint Force/Torques: asks for Report Joint Force/Torques.
/// Code 2605h, query class, no body.
struct query_joint_force_torques {
    friend constexpr bool operator==(const query_joint_force_torques&, const query_joint_force_torques&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2605;
        using report = report_joint_force_torques;
        using type = layout<>;
    };
};

/// Joint Type of Report Manipulator Specifications.
enum class joint_type : std::uint8_t {
    revolute = 1,
    prismatic = 2,
};

/// One of the joints 1 to n-1 of Report Manipulator Specifications. 13 bytes.
struct joint_specification {
    jaus::joint_type joint_type{};          ///< how the joint moves
    std::uint16_t link_length{};            ///< millimetres
    std::uint16_t twist_angle{};            ///< milliradians
    std::uint16_t joint_offset{};           ///< millimetres or milliradians, by the joint's type
    std::uint16_t joint_minimum_value{};    ///< millimetres or milliradians, by the joint's type
    std::uint16_t joint_maximum_value{};    ///< millimetres or milliradians, by the joint's type
    std::uint16_t joint_maximum_velocity{}; ///< thousandths of the joint's unit per second
    friend constexpr bool operator==(const joint_specification&, const joint_specification&) = default;

    struct schema : wire::items {
        using T = joint_specification;
        using type = layout<
            field<&T::joint_type, enumeration<jaus::joint_type, u8>>,
            field<&T::link_length, in_units<u16le, millimetres>>,
            field<&T::twist_angle, in_units<u16le, milliradians>>,
            field<&T::joint_offset, u16le>,
            field<&T::joint_minimum_value, u16le>,
            field<&T::joint_maximum_value, u16le>,
            field<&T::joint_maximum_velocity, u16le>>;
    };
};

/// Report Manipulator Specifications: the manipulator's place on the vehicle and its joints; the last joint comes first
/// and has no link. Code 4600h, inform class, 38 bytes or more. A peer without joints is known to send the count alone,
/// one byte; that is refused. Which of the joint values' two units goes with which type, and their sign, rest on one
/// peer.
struct report_manipulator_specifications {
    std::uint8_t number_of_joints{};           ///< n, 1 to 255
    joint_type joint_n_type{};                 ///< how joint n moves
    std::uint16_t joint_n_offset{};            ///< millimetres or milliradians, by the joint's type
    std::uint16_t joint_n_minimum_value{};     ///< millimetres or milliradians, by the joint's type
    std::uint16_t joint_n_maximum_value{};     ///< millimetres or milliradians, by the joint's type
    std::uint16_t joint_n_maximum_velocity{};  ///< thousandths of the joint's unit per second
    double manipulator_coordinate_system_x{};  ///< metres, -30 to 30; origin in the vehicle's coordinate system
    double manipulator_coordinate_system_y{};  ///< metres, -30 to 30
    double manipulator_coordinate_system_z{};  ///< metres, -30 to 30
    double d_component_of_unit_quaternion_q{}; ///< -1 to 1
    double a_component_of_unit_quaternion_q{}; ///< -1 to 1
    double b_component_of_unit_quaternion_q{}; ///< -1 to 1
    double c_component_of_unit_quaternion_q{}; ///< -1 to 1
    wire::list<joint_specification> joint{};   ///< joints 1 to n-1
    friend constexpr bool operator==(const report_manipulator_specifications&,
                                     const report_manipulator_specifications&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4600;
        using query = query_manipulator_specifications;
        using T = report_manipulator_specifications;
        using type = layout<
            field<&T::number_of_joints, u8>,
            field<&T::joint_n_type, enumeration<joint_type, u8>>,
            field<&T::joint_n_offset, u16le>,
            field<&T::joint_n_minimum_value, u16le>,
            field<&T::joint_n_maximum_value, u16le>,
            field<&T::joint_n_maximum_velocity, u16le>,
            field<&T::manipulator_coordinate_system_x, scaled<u32le, manipulator_coordinate>>,
            field<&T::manipulator_coordinate_system_y, scaled<u32le, manipulator_coordinate>>,
            field<&T::manipulator_coordinate_system_z, scaled<u32le, manipulator_coordinate>>,
            field<&T::d_component_of_unit_quaternion_q, scaled<u32le, unit_vector_component>>,
            field<&T::a_component_of_unit_quaternion_q, scaled<u32le, unit_vector_component>>,
            field<&T::b_component_of_unit_quaternion_q, scaled<u32le, unit_vector_component>>,
            field<&T::c_component_of_unit_quaternion_q, scaled<u32le, unit_vector_component>>,
            repeated<&T::joint, one_less_than<&T::number_of_joints>>>;
    };
};

/// Report Joint Efforts: the efforts in force.
/// Code 4601h, inform class, 1 byte or more.
template <std::size_t Capacity> struct basic_report_joint_efforts {
    wire::inline_list<double, Capacity> joint_effort{}; ///< percent, -100 to 100; from joint 1
    friend constexpr bool operator==(const basic_report_joint_efforts&, const basic_report_joint_efforts&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4601;
        using query = query_joint_efforts;
        using T = basic_report_joint_efforts<Capacity>;
        using type = layout<
            repeated<&T::joint_effort, count<"number_of_joints", u8>,
                element<"joint", scaled<u16le, signed_percent>>>>;
    };
};

/// Report Joint Positions: where the joints are.
/// Code 4602h, inform class, 1 byte or more.
template <std::size_t Capacity> struct basic_report_joint_positions {
    wire::inline_list<double, Capacity> joint_position{}; ///< radians, -8 pi to 8 pi; from joint 1
    friend constexpr bool operator==(const basic_report_joint_positions&,
                                     const basic_report_joint_positions&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4602;
        using query = query_joint_positions;
        using T = basic_report_joint_positions<Capacity>;
        using type = layout<
            repeated<&T::joint_position, count<"number_of_joints", u8>,
                element<"joint", scaled<u32le, joint_angle>>>>;
    };
};

/// Report Joint Velocities: how fast the joints move.
/// Code 4603h, inform class, 1 byte or more.
template <std::size_t Capacity> struct basic_report_joint_velocities {
    wire::inline_list<double, Capacity> joint_velocity{}; ///< radians per second, -10 pi to 10 pi; from joint 1
    friend constexpr bool operator==(const basic_report_joint_velocities&,
                                     const basic_report_joint_velocities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4603;
        using query = query_joint_velocities;
        using T = basic_report_joint_velocities<Capacity>;
        using type = layout<
            repeated<&T::joint_velocity, count<"number_of_joints", u8>,
                element<"joint", scaled<u32le, joint_angular_velocity>>>>;
    };
};

/// Report Tool Point: where the tip of the tool is in the end effector's coordinate system.
/// Code 4604h, inform class, 12 bytes.
struct report_tool_point {
    double x_coordinate_of_tool_tip{}; ///< metres, -15 to 15
    double y_coordinate_of_tool_tip{}; ///< metres, -15 to 15
    double z_coordinate_of_tool_tip{}; ///< metres, -15 to 15
    friend constexpr bool operator==(const report_tool_point&, const report_tool_point&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4604;
        using query = query_tool_point;
        using T = report_tool_point;
        using type = layout<
            field<&T::x_coordinate_of_tool_tip, scaled<u32le, tool_tip_coordinate>>,
            field<&T::y_coordinate_of_tool_tip, scaled<u32le, tool_tip_coordinate>>,
            field<&T::z_coordinate_of_tool_tip, scaled<u32le, tool_tip_coordinate>>>;
    };
};

/// Report Joint Force/Torques: what the joints are measured to bear.
/// Code 4605h, inform class, 1 byte or more.
template <std::size_t Capacity> struct basic_report_joint_force_torques {
    wire::inline_list<double, Capacity> joint_force_torque{}; ///< newton metres, -1000 to 1000; from joint 1
    friend constexpr bool operator==(const basic_report_joint_force_torques&,
                                     const basic_report_joint_force_torques&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4605;
        using query = query_joint_force_torques;
        using T = basic_report_joint_force_torques<Capacity>;
        using type = layout<
            repeated<&T::joint_force_torque, count<"number_of_joints", u8>,
                element<"joint", scaled<u32le, joint_torque>>>>;
    };
};

/// The messages of the subgroup, by command code.
using manipulator_subgroup = message_list<
    set_joint_efforts,
    set_joint_positions,
    set_joint_velocities,
    set_tool_point,
    set_end_effector_pose,
    set_end_effector_velocity_state,
    set_joint_motion,
    set_end_effector_path_motion,
    query_manipulator_specifications,
    query_joint_efforts,
    query_joint_positions,
    query_joint_velocities,
    query_tool_point,
    query_joint_force_torques,
    report_manipulator_specifications,
    report_joint_efforts,
    report_joint_positions,
    report_joint_velocities,
    report_tool_point,
    report_joint_force_torques>;

} // namespace jauscat::jaus
