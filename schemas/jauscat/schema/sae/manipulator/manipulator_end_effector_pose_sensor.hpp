// ManipulatorEndEffectorPoseSensor 2.0, urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/manipulator/shared.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::manipulator {

/// QueryEndEffectorPose: ID 2615h, input of ManipulatorEndEffectorPoseSensor.
struct query_end_effector_pose {
    friend constexpr bool operator==(const query_end_effector_pose&, const query_end_effector_pose&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2615;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ReportEndEffectorPose: ID 4615h, output of ManipulatorEndEffectorPoseSensor.
struct report_end_effector_pose {
    double tool_point_coordinate_x{};          ///< meter, -30 to 30
    double tool_point_coordinate_y{};          ///< meter, -30 to 30
    double tool_point_coordinate_z{};          ///< meter, -30 to 30
    double d_component_of_unit_quaternion_q{}; ///< -1 to 1
    double a_component_of_unit_quaternion_q{}; ///< -1 to 1
    double b_component_of_unit_quaternion_q{}; ///< -1 to 1
    double c_component_of_unit_quaternion_q{}; ///< -1 to 1
    friend constexpr bool operator==(const report_end_effector_pose&, const report_end_effector_pose&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4615;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_end_effector_pose;
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

namespace services {

/// ManipulatorEndEffectorPoseSensor: what it is called, and its messages.
struct manipulator_end_effector_pose_sensor {
    static constexpr std::string_view name = "ManipulatorEndEffectorPoseSensor";
    static constexpr std::string_view uri = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:AccessControl";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<query_end_effector_pose>;
    using outputs = jaus::message_list<report_end_effector_pose>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::manipulator
