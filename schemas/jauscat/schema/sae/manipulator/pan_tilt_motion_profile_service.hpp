// PanTiltMotionProfileService 2.0, urn:jaus:jss:manipulator:PanTiltMotionProfileService.
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

/// QueryPanTiltMotionProfile: ID 2627h, input of PanTiltMotionProfileService.
struct query_pan_tilt_motion_profile {
    friend constexpr bool operator==(
        const query_pan_tilt_motion_profile&,
        const query_pan_tilt_motion_profile&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2627;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// SetPanTiltMotionProfile: ID 0627h, command, input of PanTiltMotionProfileService.
struct set_pan_tilt_motion_profile {
    double joint1_max_speed{};             ///< radian per second, 0 to 10 pi
    double joint1_max_acceleration_rate{}; ///< radian per second squared, 0 to 10 pi
    double joint1_max_deceleration_rate{}; ///< radian per second squared, 0 to 10 pi
    double joint2_max_speed{};             ///< radian per second, 0 to 10 pi
    double joint2_max_acceleration_rate{}; ///< radian per second squared, 0 to 10 pi
    double joint2_max_deceleration_rate{}; ///< radian per second squared, 0 to 10 pi
    friend constexpr bool operator==(const set_pan_tilt_motion_profile&, const set_pan_tilt_motion_profile&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0627;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_pan_tilt_motion_profile;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::joint1_max_speed, scaled<u32le, radian_per_second_0_to_10_pi>>,
            field<&T::joint1_max_acceleration_rate, scaled<u32le, radian_per_second_squared_0_to_10_pi>>,
            field<&T::joint1_max_deceleration_rate, scaled<u32le, radian_per_second_squared_0_to_10_pi>>,
            field<&T::joint2_max_speed, scaled<u32le, radian_per_second_0_to_10_pi>>,
            field<&T::joint2_max_acceleration_rate, scaled<u32le, radian_per_second_squared_0_to_10_pi>>,
            field<&T::joint2_max_deceleration_rate, scaled<u32le, radian_per_second_squared_0_to_10_pi>>>;
    };
};

/// ReportPanTiltMotionProfile: ID 4627h, output of PanTiltMotionProfileService.
struct report_pan_tilt_motion_profile {
    double joint1_max_speed{};             ///< radian per second, 0 to 10 pi
    double joint1_max_acceleration_rate{}; ///< radian per second squared, 0 to 10 pi
    double joint1_max_deceleration_rate{}; ///< radian per second squared, 0 to 10 pi
    double joint2_max_speed{};             ///< radian per second, 0 to 10 pi
    double joint2_max_acceleration_rate{}; ///< radian per second squared, 0 to 10 pi
    double joint2_max_deceleration_rate{}; ///< radian per second squared, 0 to 10 pi
    friend constexpr bool operator==(
        const report_pan_tilt_motion_profile&,
        const report_pan_tilt_motion_profile&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4627;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_pan_tilt_motion_profile;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::joint1_max_speed, scaled<u32le, radian_per_second_0_to_10_pi>>,
            field<&T::joint1_max_acceleration_rate, scaled<u32le, radian_per_second_squared_0_to_10_pi>>,
            field<&T::joint1_max_deceleration_rate, scaled<u32le, radian_per_second_squared_0_to_10_pi>>,
            field<&T::joint2_max_speed, scaled<u32le, radian_per_second_0_to_10_pi>>,
            field<&T::joint2_max_acceleration_rate, scaled<u32le, radian_per_second_squared_0_to_10_pi>>,
            field<&T::joint2_max_deceleration_rate, scaled<u32le, radian_per_second_squared_0_to_10_pi>>>;
    };
};

namespace services {

/// PanTiltMotionProfileService: what it is called, and its messages.
struct pan_tilt_motion_profile_service {
    static constexpr std::string_view name = "PanTiltMotionProfileService";
    static constexpr std::string_view uri = "urn:jaus:jss:manipulator:PanTiltMotionProfileService";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:AccessControl";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<query_pan_tilt_motion_profile, set_pan_tilt_motion_profile>;
    using outputs = jaus::message_list<report_pan_tilt_motion_profile>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::manipulator
