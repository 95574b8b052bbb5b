// ManipulatorJointForceTorqueSensor 2.0, urn:jaus:jss:manipulator:ManipulatorJointForceTorqueSensor.
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

/// QueryJointForceTorques: ID 2605h, input of ManipulatorJointForceTorqueSensor.
struct query_joint_force_torques {
    friend constexpr bool operator==(const query_joint_force_torques&, const query_joint_force_torques&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2605;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ReportJointForceTorques: ID 4605h, output of ManipulatorJointForceTorqueSensor.
struct report_joint_force_torques {
    wire::list<actuator_force_torque_rec> actuator_force_torque_list{}; ///< up to 255 elements
    friend constexpr bool operator==(const report_joint_force_torques&, const report_joint_force_torques&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4605;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_joint_force_torques;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::actuator_force_torque_list, count<"number_of_actuator_force_torque_list", u8>>>;
    };
};

namespace services {

/// ManipulatorJointForceTorqueSensor: what it is called, and its messages.
struct manipulator_joint_force_torque_sensor {
    static constexpr std::string_view name = "ManipulatorJointForceTorqueSensor";
    static constexpr std::string_view uri = "urn:jaus:jss:manipulator:ManipulatorJointForceTorqueSensor";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Events";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<query_joint_force_torques>;
    using outputs = jaus::message_list<report_joint_force_torques>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::manipulator
