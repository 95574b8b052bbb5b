// AccelerationStateSensor 1.1, urn:jaus:jss:mobility:AccelerationStateSensor.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/mobility/shared.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::mobility {

/// QueryAccelerationState: ID 2417h, deprecated, input of AccelerationStateSensor.
struct query_acceleration_state {
    std::uint16_t presence_vector{};
    friend constexpr bool operator==(const query_acceleration_state&, const query_acceleration_state&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2417;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = query_acceleration_state;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u16le>>;
    };
};

/// QueryAccelerationStateExt: ID 24B7h, input of AccelerationStateSensor.
struct query_acceleration_state_ext {
    std::uint16_t presence_vector{};
    friend constexpr bool operator==(
        const query_acceleration_state_ext&,
        const query_acceleration_state_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x24B7;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_acceleration_state_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u16le>>;
    };
};

/// ReportAccelerationState: ID 4417h, deprecated, output of AccelerationStateSensor.
struct report_acceleration_state {
    std::optional<double> acceleration_x{};              ///< meter per second squared, -1310.68 to 1310.68
    std::optional<double> acceleration_y{};              ///< meter per second squared, -1310.68 to 1310.68
    std::optional<double> acceleration_z{};              ///< meter per second squared, -1310.68 to 1310.68
    std::optional<double> acceleration_rms{};            ///< meter per second squared, 0 to 100
    std::optional<double> roll_acceleration{};           ///< radian per second squared, -13106.8 to 13106.8
    std::optional<double> pitch_acceleration{};          ///< radian per second squared, -13106.8 to 13106.8
    std::optional<double> yaw_acceleration{};            ///< radian per second squared, -13106.8 to 13106.8
    std::optional<double> rotational_acceleration_rms{}; ///< radian per second squared, 0 to pi
    std::optional<mobility::time_stamp> time_stamp{};
    friend constexpr bool operator==(const report_acceleration_state&, const report_acceleration_state&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4417;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = report_acceleration_state;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u16le,
                field<&T::acceleration_x, scaled<u32le, meter_per_second_squared_minus_1310_68_to_1310_68>>,
                field<&T::acceleration_y, scaled<u32le, meter_per_second_squared_minus_1310_68_to_1310_68>>,
                field<&T::acceleration_z, scaled<u32le, meter_per_second_squared_minus_1310_68_to_1310_68>>,
                field<&T::acceleration_rms, scaled<u32le, meter_per_second_squared_0_to_100>>,
                field<&T::roll_acceleration, scaled<u32le, radian_per_second_squared_minus_13106_8_to_13106_8>>,
                field<&T::pitch_acceleration, scaled<u32le, radian_per_second_squared_minus_13106_8_to_13106_8>>,
                field<&T::yaw_acceleration, scaled<u32le, radian_per_second_squared_minus_13106_8_to_13106_8>>,
                field<&T::rotational_acceleration_rms, scaled<u16le, radian_per_second_squared_0_to_pi>>,
                nested<&T::time_stamp>>>;
    };
};

/// ReportAccelerationStateExt: ID 44B7h, output of AccelerationStateSensor.
struct report_acceleration_state_ext {
    std::optional<double> acceleration_x{};              ///< meter per second squared, -1310.68 to 1310.68
    std::optional<double> acceleration_y{};              ///< meter per second squared, -1310.68 to 1310.68
    std::optional<double> acceleration_z{};              ///< meter per second squared, -1310.68 to 1310.68
    std::optional<double> acceleration_rms{};            ///< meter per second squared, 0 to 100
    std::optional<double> roll_acceleration{};           ///< radian per second squared, -13106.8 to 13106.8
    std::optional<double> pitch_acceleration{};          ///< radian per second squared, -13106.8 to 13106.8
    std::optional<double> yaw_acceleration{};            ///< radian per second squared, -13106.8 to 13106.8
    std::optional<double> rotational_acceleration_rms{}; ///< radian per second squared, 0 to 1000
    std::optional<std::uint32_t> time_seconds{};         ///< second
    std::optional<std::uint32_t> time_nano_seconds{};
    friend constexpr bool operator==(
        const report_acceleration_state_ext&,
        const report_acceleration_state_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x44B7;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_acceleration_state_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u16le,
                field<&T::acceleration_x, scaled<u32le, meter_per_second_squared_minus_1310_68_to_1310_68>>,
                field<&T::acceleration_y, scaled<u32le, meter_per_second_squared_minus_1310_68_to_1310_68>>,
                field<&T::acceleration_z, scaled<u32le, meter_per_second_squared_minus_1310_68_to_1310_68>>,
                field<&T::acceleration_rms, scaled<u32le, meter_per_second_squared_0_to_100>>,
                field<&T::roll_acceleration, scaled<u32le, radian_per_second_squared_minus_13106_8_to_13106_8>>,
                field<&T::pitch_acceleration, scaled<u32le, radian_per_second_squared_minus_13106_8_to_13106_8>>,
                field<&T::yaw_acceleration, scaled<u32le, radian_per_second_squared_minus_13106_8_to_13106_8>>,
                field<&T::rotational_acceleration_rms, scaled<u16le, radian_per_second_squared_0_to_1000>>,
                field<&T::time_seconds, in_units<u32le, second>>,
                field<&T::time_nano_seconds, u32le>>>;
    };
};

namespace services {

/// AccelerationStateSensor: what it is called, and its messages.
struct acceleration_state_sensor {
    static constexpr std::string_view name = "AccelerationStateSensor";
    static constexpr std::string_view uri = "urn:jaus:jss:mobility:AccelerationStateSensor";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Events";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<query_acceleration_state, query_acceleration_state_ext>;
    using outputs = jaus::message_list<report_acceleration_state, report_acceleration_state_ext>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::mobility
