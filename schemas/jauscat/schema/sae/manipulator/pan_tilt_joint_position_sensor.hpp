// PanTiltJointPositionSensor 2.0, urn:jaus:jss:manipulator:PanTiltJointPositionSensor.
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

/// QueryPanTiltJointPositions: ID 2622h, input of PanTiltJointPositionSensor.
struct query_pan_tilt_joint_positions {
    friend constexpr bool operator==(
        const query_pan_tilt_joint_positions&,
        const query_pan_tilt_joint_positions&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2622;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ReportPanTiltJointPositions: ID 4622h, output of PanTiltJointPositionSensor.
struct report_pan_tilt_joint_positions {
    double joint1_position{}; ///< radian, -8 pi to 8 pi
    double joint2_position{}; ///< radian, -8 pi to 8 pi
    friend constexpr bool operator==(
        const report_pan_tilt_joint_positions&,
        const report_pan_tilt_joint_positions&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4622;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_pan_tilt_joint_positions;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::joint1_position, scaled<u32le, radian_minus_8_pi_to_8_pi>>,
            field<&T::joint2_position, scaled<u32le, radian_minus_8_pi_to_8_pi>>>;
    };
};

namespace services {

/// PanTiltJointPositionSensor: what it is called, and its messages.
struct pan_tilt_joint_position_sensor {
    static constexpr std::string_view name = "PanTiltJointPositionSensor";
    static constexpr std::string_view uri = "urn:jaus:jss:manipulator:PanTiltJointPositionSensor";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Events";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<query_pan_tilt_joint_positions>;
    using outputs = jaus::message_list<report_pan_tilt_joint_positions>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::manipulator
