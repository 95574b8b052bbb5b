// Messages and types that several services of the set manipulator have.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/ranges.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::manipulator {

/// Values of JointForceTorque.
enum class joint_force_torque_form : std::uint8_t {
    newton_meter = 1,
    newton = 2,
};

/// JointForceTorque: a number in the form that is named before it.
struct joint_force_torque {
    joint_force_torque_form index{};
    double value{}; ///< as its form says
    friend constexpr bool operator==(const joint_force_torque&, const joint_force_torque&) = default;

    struct schema : wire::items {
        using T = joint_force_torque;
        using type = layout<
            field<&T::index, enumeration<joint_force_torque_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<joint_force_torque_form::newton_meter, scaled<u32le, newton_meter_minus_1000_to_1000>>,
                when<joint_force_torque_form::newton, scaled<u32le, newton_minus_500_to_500>>>>;
    };
};

/// Record ActuatorForceTorqueRec.
struct actuator_force_torque_rec {
    manipulator::joint_force_torque joint_force_torque{};
    friend constexpr bool operator==(const actuator_force_torque_rec&, const actuator_force_torque_rec&) = default;

    struct schema : wire::items {
        using T = actuator_force_torque_rec;
        using type = layout<nested<&T::joint_force_torque>>;
    };
};

/// QueryCommandedEndEffectorPose: ID 2610h, input of ManipulatorEndEffectorPoseDriver,
/// ManipulatorEndEffectorPoseListDriver.
struct query_commanded_end_effector_pose {
    friend constexpr bool operator==(
        const query_commanded_end_effector_pose&,
        const query_commanded_end_effector_pose&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2610;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ReportCommandedEndEffectorPose: ID 4610h, output of ManipulatorEndEffectorPoseDriver,
/// ManipulatorEndEffectorPoseListDriver.
struct report_commanded_end_effector_pose {
    double tool_point_coordinate_x{};          ///< meter, -30 to 30
    double tool_point_coordinate_y{};          ///< meter, -30 to 30
    double tool_point_coordinate_z{};          ///< meter, -30 to 30
    double d_component_of_unit_quaternion_q{}; ///< -1 to 1
    double a_component_of_unit_quaternion_q{}; ///< -1 to 1
    double b_component_of_unit_quaternion_q{}; ///< -1 to 1
    double c_component_of_unit_quaternion_q{}; ///< -1 to 1
    friend constexpr bool operator==(
        const report_commanded_end_effector_pose&,
        const report_commanded_end_effector_pose&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4610;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_commanded_end_effector_pose;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::tool_point_coordinate_x, scaled<u32le, meter_minus_30_to_30>>,
            field<&T::tool_point_coordinate_y, scaled<u32le, meter_minus_30_to_30>>,
            field<&T::tool_point_coordinate_z, scaled<u32le, meter_minus_30_to_30>>,
            field<&T::d_component_of_unit_quaternion_q, scaled<u32le, one_minus_1_to_1>>,
            field<&T::a_component_of_unit_quaternion_q, scaled<u32le, one_minus_1_to_1>>,
            field<&T::b_component_of_unit_quaternion_q, scaled<u32le, one_minus_1_to_1>>,
            field<&T::c_component_of_unit_quaternion_q, scaled<u32le, one_minus_1_to_1>>>;
    };
};

/// QueryCommandedJointPositions: ID 2608h, input of ManipulatorJointPositionDriver, ManipulatorJointPositionListDriver.
struct query_commanded_joint_positions {
    friend constexpr bool operator==(
        const query_commanded_joint_positions&,
        const query_commanded_joint_positions&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2608;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// Values of JointPosition.
enum class joint_position_form : std::uint8_t {
    radian = 1,
    meter = 2,
};

/// JointPosition: a number in the form that is named before it.
struct joint_position {
    joint_position_form index{};
    double value{}; ///< as its form says
    friend constexpr bool operator==(const joint_position&, const joint_position&) = default;

    struct schema : wire::items {
        using T = joint_position;
        using type = layout<
            field<&T::index, enumeration<joint_position_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<joint_position_form::radian, scaled<u32le, radian_minus_8_pi_to_8_pi>>,
                when<joint_position_form::meter, scaled<u32le, meter_minus_10_to_10>>>>;
    };
};

/// Record JointPositionRec.
struct joint_position_rec {
    manipulator::joint_position joint_position{};
    friend constexpr bool operator==(const joint_position_rec&, const joint_position_rec&) = default;

    struct schema : wire::items {
        using T = joint_position_rec;
        using type = layout<nested<&T::joint_position>>;
    };
};

/// ReportCommandedJointPositions: ID 4608h, output of ManipulatorJointPositionDriver,
/// ManipulatorJointPositionListDriver.
struct report_commanded_joint_positions {
    wire::list<joint_position_rec> joint_position_list{}; ///< up to 255 elements
    friend constexpr bool operator==(
        const report_commanded_joint_positions&,
        const report_commanded_joint_positions&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4608;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_commanded_joint_positions;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::joint_position_list, count<"number_of_joint_position_list", u8>>>;
    };
};

/// Values of JointVelocity.
enum class joint_velocity_form : std::uint8_t {
    radian_per_second = 1,
    meter_per_second = 2,
};

/// JointVelocity: a number in the form that is named before it.
struct joint_velocity {
    joint_velocity_form index{};
    double value{}; ///< as its form says
    friend constexpr bool operator==(const joint_velocity&, const joint_velocity&) = default;

    struct schema : wire::items {
        using T = joint_velocity;
        using type = layout<
            field<&T::index, enumeration<joint_velocity_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<joint_velocity_form::radian_per_second, scaled<u32le, radian_per_second_minus_10_pi_to_10_pi>>,
                when<joint_velocity_form::meter_per_second, scaled<u32le, meter_per_second_minus_5_to_5>>>>;
    };
};

/// Record JointVelocityRec.
struct joint_velocity_rec {
    manipulator::joint_velocity joint_velocity{};
    friend constexpr bool operator==(const joint_velocity_rec&, const joint_velocity_rec&) = default;

    struct schema : wire::items {
        using T = joint_velocity_rec;
        using type = layout<nested<&T::joint_velocity>>;
    };
};

} // namespace jauscat::sae::manipulator
