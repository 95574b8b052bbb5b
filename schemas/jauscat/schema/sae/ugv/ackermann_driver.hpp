// AckermannDriver 1.0, urn:jaus:jss:ugv:AckermannDriver.
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

/// SetAckermannConfiguration: ID 0500h, command, input of AckermannDriver.
struct set_ackermann_configuration {
    double steering_angle{};                     ///< radian, -pi / 2 to pi / 2
    double throttle_effort{};                    ///< 0 to 100
    double brake_effort{};                       ///< 0 to 100
    std::optional<double> max_steering_rate{};   ///< radian per second, 0 to 32.767
    std::optional<double> max_steering_torque{}; ///< newton meter, 0 to 500
    friend constexpr bool operator==(const set_ackermann_configuration&, const set_ackermann_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0500;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_ackermann_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::steering_angle, scaled<u16le, radian_minus_pi_by_2_to_pi_by_2>>,
                field<&T::throttle_effort, scaled<u16le, one_0_to_100>>,
                field<&T::brake_effort, scaled<u16le, one_0_to_100>>,
                field<&T::max_steering_rate, scaled<u16le, radian_per_second_0_to_32_767>>,
                field<&T::max_steering_torque, scaled<u16le, newton_meter_0_to_500>>>>;
    };
};

/// QueryAckermannConfiguration: ID 2500h, input of AckermannDriver.
struct query_ackermann_configuration {
    friend constexpr bool operator==(
        const query_ackermann_configuration&,
        const query_ackermann_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2500;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ReportAckermannConfiguration: ID 4500h, output of AckermannDriver.
struct report_ackermann_configuration {
    double steering_angle{};                 ///< radian, -pi / 2 to pi / 2
    double throttle_effort{};                ///< 0 to 100
    double brake_effort{};                   ///< 0 to 100
    std::optional<double> steering_rate{};   ///< radian per second, -32.767 to 32.768
    std::optional<double> steering_torque{}; ///< newton meter, -500 to 500
    friend constexpr bool operator==(
        const report_ackermann_configuration&,
        const report_ackermann_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4500;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_ackermann_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::steering_angle, scaled<u16le, radian_minus_pi_by_2_to_pi_by_2>>,
                field<&T::throttle_effort, scaled<u16le, one_0_to_100>>,
                field<&T::brake_effort, scaled<u16le, one_0_to_100>>,
                field<&T::steering_rate, scaled<u16le, radian_per_second_minus_32_767_to_32_768>>,
                field<&T::steering_torque, scaled<u16le, newton_meter_minus_500_to_500>>>>;
    };
};

namespace services {

/// AckermannDriver: what it is called, and its messages.
struct ackermann_driver {
    static constexpr std::string_view name = "AckermannDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:ugv:AckermannDriver";
    static constexpr std::string_view version = "1.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<set_ackermann_configuration, query_ackermann_configuration>;
    using outputs = jaus::message_list<report_ackermann_configuration>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::ugv
