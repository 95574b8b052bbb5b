// ManipulatorEndEffectorVelocityStateDriver 2.0, urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateDriver.
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

/// SetEndEffectorVelocityState: ID 0612h, command, input of ManipulatorEndEffectorVelocityStateDriver.
struct set_end_effector_velocity_state {
    double angular_velocity_component_x{}; ///< radian per second, -20 pi to 20 pi
    double angular_velocity_component_y{}; ///< radian per second, -20 pi to 20 pi
    double angular_velocity_component_z{}; ///< radian per second, -20 pi to 20 pi
    double linear_velocity_component_x{};  ///< meter per second, -10 to 10
    double linear_velocity_component_y{};  ///< meter per second, -10 to 10
    double linear_velocity_component_z{};  ///< meter per second, -10 to 10
    friend constexpr bool operator==(
        const set_end_effector_velocity_state&,
        const set_end_effector_velocity_state&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0612;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_end_effector_velocity_state;
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

/// QueryCommandedEndEffectorVelocityState: ID 2612h, input of ManipulatorEndEffectorVelocityStateDriver.
struct query_commanded_end_effector_velocity_state {
    friend constexpr bool operator==(
        const query_commanded_end_effector_velocity_state&,
        const query_commanded_end_effector_velocity_state&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2612;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ReportCommandedEndEffectorVelocityState: ID 4612h, output of ManipulatorEndEffectorVelocityStateDriver.
struct report_commanded_end_effector_velocity_state {
    double angular_velocity_component_x{}; ///< radian per second, -20 pi to 20 pi
    double angular_velocity_component_y{}; ///< radian per second, -20 pi to 20 pi
    double angular_velocity_component_z{}; ///< radian per second, -20 pi to 20 pi
    double linear_velocity_component_x{};  ///< meter per second, -10 to 10
    double linear_velocity_component_y{};  ///< meter per second, -10 to 10
    double linear_velocity_component_z{};  ///< meter per second, -10 to 10
    friend constexpr bool operator==(
        const report_commanded_end_effector_velocity_state&,
        const report_commanded_end_effector_velocity_state&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4612;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_commanded_end_effector_velocity_state;
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

/// ManipulatorEndEffectorVelocityStateDriver: what it is called, and its messages.
struct manipulator_end_effector_velocity_state_driver {
    static constexpr std::string_view name = "ManipulatorEndEffectorVelocityStateDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateDriver";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<set_end_effector_velocity_state, query_commanded_end_effector_velocity_state>;
    using outputs = jaus::message_list<report_commanded_end_effector_velocity_state>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::manipulator
