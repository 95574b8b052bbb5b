// ManipulatorJointVelocitySensor 2.0, urn:jaus:jss:manipulator:ManipulatorJointVelocitySensor.
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

/// QueryJointVelocity: ID 2603h, input of ManipulatorJointVelocitySensor.
struct query_joint_velocity {
    friend constexpr bool operator==(const query_joint_velocity&, const query_joint_velocity&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2603;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ReportJointVelocity: ID 4603h, output of ManipulatorJointVelocitySensor.
struct report_joint_velocity {
    wire::list<joint_velocity_rec> joint_velocity_list{}; ///< up to 255 elements
    friend constexpr bool operator==(const report_joint_velocity&, const report_joint_velocity&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4603;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_joint_velocity;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::joint_velocity_list, count<"number_of_joint_velocity_list", u8>>>;
    };
};

namespace services {

/// ManipulatorJointVelocitySensor: what it is called, and its messages.
struct manipulator_joint_velocity_sensor {
    static constexpr std::string_view name = "ManipulatorJointVelocitySensor";
    static constexpr std::string_view uri = "urn:jaus:jss:manipulator:ManipulatorJointVelocitySensor";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Events";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<query_joint_velocity>;
    using outputs = jaus::message_list<report_joint_velocity>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::manipulator
