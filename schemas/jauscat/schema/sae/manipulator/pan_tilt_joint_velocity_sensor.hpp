// PanTiltJointVelocitySensor 2.0, urn:jaus:jss:manipulator:PanTiltJointVelocitySensor.
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

/// QueryPanTiltJointVelocity: ID 2623h, input of PanTiltJointVelocitySensor.
struct query_pan_tilt_joint_velocity {
    friend constexpr bool operator==(
        const query_pan_tilt_joint_velocity&,
        const query_pan_tilt_joint_velocity&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2623;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ReportPanTiltJointVelocity: ID 4623h, output of PanTiltJointVelocitySensor.
struct report_pan_tilt_joint_velocity {
    double joint1_velocity{}; ///< radian per second, -10 pi to 10 pi
    double joint2_velocity{}; ///< radian per second, -10 pi to 10 pi
    friend constexpr bool operator==(
        const report_pan_tilt_joint_velocity&,
        const report_pan_tilt_joint_velocity&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4623;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_pan_tilt_joint_velocity;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::joint1_velocity, scaled<u32le, radian_per_second_minus_10_pi_to_10_pi>>,
            field<&T::joint2_velocity, scaled<u32le, radian_per_second_minus_10_pi_to_10_pi>>>;
    };
};

namespace services {

/// PanTiltJointVelocitySensor: what it is called, and its messages.
struct pan_tilt_joint_velocity_sensor {
    static constexpr std::string_view name = "PanTiltJointVelocitySensor";
    static constexpr std::string_view uri = "urn:jaus:jss:manipulator:PanTiltJointVelocitySensor";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Events";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<query_pan_tilt_joint_velocity>;
    using outputs = jaus::message_list<report_pan_tilt_joint_velocity>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::manipulator
