// PlatformSpecificationsService 1.0, urn:jaus:jss:ugv:PlatformSpecifications.
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
namespace jauscat::sae::ugv {

/// QueryPlatformSpecifications: ID 2502h, input of PlatformSpecificationsService.
struct query_platform_specifications {
    friend constexpr bool operator==(
        const query_platform_specifications&,
        const query_platform_specifications&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2502;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// Record skidsteer.
struct skidsteer {
    std::optional<double> track_separation{};   ///< meter, 0 to 30
    std::optional<double> drive_wheel_radius{}; ///< meter, 0 to 10
    friend constexpr bool operator==(const skidsteer&, const skidsteer&) = default;

    struct schema : wire::items {
        using T = skidsteer;
        using type = layout<
            lenient_presence<u8,
                field<&T::track_separation, scaled<u16le, meter_0_to_30>>,
                field<&T::drive_wheel_radius, scaled<u16le, meter_0_to_10>>>>;
    };
};

/// Record Ackermann.
struct ackermann {
    std::optional<double> steering_angle_range{}; ///< radian, -pi / 2 to pi / 2
    std::optional<double> min_turn_radius{};      ///< meter, 0 to 25
    std::optional<double> wheel_separation{};     ///< meter, 0 to 30
    std::optional<double> drive_wheel_radius{};   ///< meter, 0 to 10
    friend constexpr bool operator==(const ackermann&, const ackermann&) = default;

    struct schema : wire::items {
        using T = ackermann;
        using type = layout<
            lenient_presence<u8,
                field<&T::steering_angle_range, scaled<u16le, radian_minus_pi_by_2_to_pi_by_2>>,
                field<&T::min_turn_radius, scaled<u16le, meter_0_to_25>>,
                field<&T::wheel_separation, scaled<u16le, meter_0_to_30>>,
                field<&T::drive_wheel_radius, scaled<u16le, meter_0_to_10>>>>;
    };
};

/// Record platformInertial.
struct platform_inertial {
    std::optional<double> maximum_forward_speed{};        ///< meter per second, 0 to 90
    std::optional<double> maximum_reverse_speed{};        ///< meter per second, 0 to 90
    std::optional<double> maximum_rotational_speed{};     ///< radian per second, 0 to 6.28
    std::optional<double> maximum_forward_acceleration{}; ///< meter per second squared, 0 to 40
    std::optional<double> maximum_reverse_acceleration{}; ///< meter per second squared, 0 to 40
    std::optional<double> maximum_forward_deceleration{}; ///< meter per second squared, 0 to 40
    std::optional<double> maximum_reverse_deceleration{}; ///< meter per second squared, 0 to 40
    friend constexpr bool operator==(const platform_inertial&, const platform_inertial&) = default;

    struct schema : wire::items {
        using T = platform_inertial;
        using type = layout<
            lenient_presence<u8,
                field<&T::maximum_forward_speed, scaled<u16le, meter_per_second_0_to_90>>,
                field<&T::maximum_reverse_speed, scaled<u16le, meter_per_second_0_to_90>>,
                field<&T::maximum_rotational_speed, scaled<u16le, radian_per_second_0_to_6_28>>,
                field<&T::maximum_forward_acceleration, scaled<u8, meter_per_second_squared_0_to_40>>,
                field<&T::maximum_reverse_acceleration, scaled<u8, meter_per_second_squared_0_to_40>>,
                field<&T::maximum_forward_deceleration, scaled<u8, meter_per_second_squared_0_to_40>>,
                field<&T::maximum_reverse_deceleration, scaled<u8, meter_per_second_squared_0_to_40>>>>;
    };
};

/// Record platformSpec.
struct platform_spec {
    std::string_view mobility_platform_name{}; ///< up to 255 characters
    std::optional<double> front{};             ///< meter, 0 to 30
    std::optional<double> back{};              ///< meter, 0 to 30
    std::optional<double> right{};             ///< meter, 0 to 30
    std::optional<double> left{};              ///< meter, 0 to 30
    std::optional<double> bottom{};            ///< meter, 0 to 30
    std::optional<double> top{};               ///< meter, 0 to 30
    std::optional<double> xcg{};               ///< meter, -30 to 30
    std::optional<double> ycg{};               ///< meter, -30 to 30
    std::optional<double> zcg{};               ///< meter, -30 to 30
    std::optional<double> wheel_base{};        ///< meter, 0 to 60
    std::optional<double> static_pitch_over{}; ///< radian, -pi to pi
    std::optional<double> static_roll_over{};  ///< radian, -pi to pi
    std::optional<double> vehicle_weight{};    ///< kilogram, 0 to 1000000
    std::optional<double> approach_angle{};    ///< radian, 0 to pi / 2
    std::optional<double> departure_angle{};   ///< radian, 0 to pi / 2
    std::optional<double> break_over_angle{};  ///< radian, 0 to pi / 2
    friend constexpr bool operator==(const platform_spec&, const platform_spec&) = default;

    struct schema : wire::items {
        using T = platform_spec;
        using type = layout<
            lenient_presence<u16le,
                string<&T::mobility_platform_name, count<"mobility_platform_name_size", u8>>,
                field<&T::front, scaled<u16le, meter_0_to_30>>,
                field<&T::back, scaled<u16le, meter_0_to_30>>,
                field<&T::right, scaled<u16le, meter_0_to_30>>,
                field<&T::left, scaled<u16le, meter_0_to_30>>,
                field<&T::bottom, scaled<u16le, meter_0_to_30>>,
                field<&T::top, scaled<u16le, meter_0_to_30>>,
                field<&T::xcg, scaled<u16le, meter_minus_30_to_30>>,
                field<&T::ycg, scaled<u16le, meter_minus_30_to_30>>,
                field<&T::zcg, scaled<u16le, meter_minus_30_to_30>>,
                field<&T::wheel_base, scaled<u16le, meter_0_to_60>>,
                field<&T::static_pitch_over, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::static_roll_over, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::vehicle_weight, scaled<u32le, kilogram_0_to_1000000>>,
                field<&T::approach_angle, scaled<u16le, radian_0_to_pi_by_2>>,
                field<&T::departure_angle, scaled<u16le, radian_0_to_pi_by_2>>,
                field<&T::break_over_angle, scaled<u16le, radian_0_to_pi_by_2>>>>;
    };
};

/// ReportPlatformSpecifications: ID 4502h, output of PlatformSpecificationsService.
struct report_platform_specifications {
    std::variant<skidsteer, ackermann> platform_specifics{};
    ugv::platform_inertial platform_inertial{};
    ugv::platform_spec platform_spec{};
    friend constexpr bool operator==(
        const report_platform_specifications&,
        const report_platform_specifications&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4502;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_platform_specifications;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            variant<&T::platform_specifics, u8>,
            nested<&T::platform_inertial>,
            nested<&T::platform_spec>>;
    };
};

namespace services {

/// PlatformSpecificationsService: what it is called, and its messages.
struct platform_specifications_service {
    static constexpr std::string_view name = "PlatformSpecificationsService";
    static constexpr std::string_view uri = "urn:jaus:jss:ugv:PlatformSpecifications";
    static constexpr std::string_view version = "1.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Events";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<query_platform_specifications>;
    using outputs = jaus::message_list<report_platform_specifications>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::ugv
