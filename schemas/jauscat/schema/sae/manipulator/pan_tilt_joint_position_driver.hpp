// PanTiltJointPositionDriver 2.0, urn:jaus:jss:manipulator:PanTiltJointPositionDriver.
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

/// QueryCommandedPanTiltJointPositions: ID 2628h, input of PanTiltJointPositionDriver.
struct query_commanded_pan_tilt_joint_positions {
    friend constexpr bool operator==(
        const query_commanded_pan_tilt_joint_positions&,
        const query_commanded_pan_tilt_joint_positions&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2628;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// SetPanTiltJointPositions: ID 0622h, command, input of PanTiltJointPositionDriver.
struct set_pan_tilt_joint_positions {
    double joint1_position{}; ///< radian, -8 pi to 8 pi
    double joint2_position{}; ///< radian, -8 pi to 8 pi
    friend constexpr bool operator==(
        const set_pan_tilt_joint_positions&,
        const set_pan_tilt_joint_positions&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0622;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_pan_tilt_joint_positions;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::joint1_position, scaled<u32le, radian_minus_8_pi_to_8_pi>>,
            field<&T::joint2_position, scaled<u32le, radian_minus_8_pi_to_8_pi>>>;
    };
};

/// ReportCommandedPanTiltJointPositions: ID 4628h, output of PanTiltJointPositionDriver.
struct report_commanded_pan_tilt_joint_positions {
    double joint1_position{}; ///< radian, -8 pi to 8 pi
    double joint2_position{}; ///< radian, -8 pi to 8 pi
    friend constexpr bool operator==(
        const report_commanded_pan_tilt_joint_positions&,
        const report_commanded_pan_tilt_joint_positions&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4628;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_commanded_pan_tilt_joint_positions;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::joint1_position, scaled<u32le, radian_minus_8_pi_to_8_pi>>,
            field<&T::joint2_position, scaled<u32le, radian_minus_8_pi_to_8_pi>>>;
    };
};

namespace services {

/// PanTiltJointPositionDriver: what it is called, and its messages.
struct pan_tilt_joint_position_driver {
    static constexpr std::string_view name = "PanTiltJointPositionDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:manipulator:PanTiltJointPositionDriver";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<query_commanded_pan_tilt_joint_positions, set_pan_tilt_joint_positions>;
    using outputs = jaus::message_list<report_commanded_pan_tilt_joint_positions>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::manipulator
