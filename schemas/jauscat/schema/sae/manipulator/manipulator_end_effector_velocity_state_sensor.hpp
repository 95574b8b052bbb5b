// ManipulatorEndEffectorVelocityStateSensor 2.0, urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor.
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

/// QueryEndEffectorVelocityState: ID 2616h, input of ManipulatorEndEffectorVelocityStateSensor.
struct query_end_effector_velocity_state {
    friend constexpr bool operator==(
        const query_end_effector_velocity_state&,
        const query_end_effector_velocity_state&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2616;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ReportEndEffectorVelocityState: ID 4616h, output of ManipulatorEndEffectorVelocityStateSensor.
struct report_end_effector_velocity_state {
    double angular_velocity_component_x{}; ///< radian per second, -20 pi to 20 pi
    double angular_velocity_component_y{}; ///< radian per second, -20 pi to 20 pi
    double angular_velocity_component_z{}; ///< radian per second, -20 pi to 20 pi
    double linear_velocity_component_x{};  ///< meter per second, -10 to 10
    double linear_velocity_component_y{};  ///< meter per second, -10 to 10
    double linear_velocity_component_z{};  ///< meter per second, -10 to 10
    friend constexpr bool operator==(
        const report_end_effector_velocity_state&,
        const report_end_effector_velocity_state&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4616;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_end_effector_velocity_state;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::angular_velocity_component_x, scaled<u32le, radian_per_second_minus_20_pi_to_20_pi>>,
            field<&T::angular_velocity_component_y, scaled<u32le, radian_per_second_minus_20_pi_to_20_pi>>,
            field<&T::angular_velocity_component_z, scaled<u32le, radian_per_second_minus_20_pi_to_20_pi>>,
            field<&T::linear_velocity_component_x, scaled<u32le, meter_per_second_minus_10_to_10>>,
            field<&T::linear_velocity_component_y, scaled<u32le, meter_per_second_minus_10_to_10>>,
            field<&T::linear_velocity_component_z, scaled<u32le, meter_per_second_minus_10_to_10>>>;
    };
};

namespace services {

/// ManipulatorEndEffectorVelocityStateSensor: what it is called, and its messages.
struct manipulator_end_effector_velocity_state_sensor {
    static constexpr std::string_view name = "ManipulatorEndEffectorVelocityStateSensor";
    static constexpr std::string_view uri = "urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:AccessControl";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<query_end_effector_velocity_state>;
    using outputs = jaus::message_list<report_end_effector_velocity_state>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::manipulator
