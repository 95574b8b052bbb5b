// VelocityStateSensor 1.1, urn:jaus:jss:mobility:VelocityStateSensor.
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

/// QueryVelocityState: ID 2404h, deprecated, input of VelocityStateSensor.
struct query_velocity_state {
    std::uint16_t presence_vector{};
    friend constexpr bool operator==(const query_velocity_state&, const query_velocity_state&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2404;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = query_velocity_state;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u16le>>;
    };
};

/// QueryVelocityStateExt: ID 24A4h, input of VelocityStateSensor.
struct query_velocity_state_ext {
    std::uint8_t velocity_var_presence_vector{};
    std::uint16_t report_velocity_state_ext_rec_presence_vector{};
    friend constexpr bool operator==(const query_velocity_state_ext&, const query_velocity_state_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x24A4;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_velocity_state_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::velocity_var_presence_vector, u8>,
            field<&T::report_velocity_state_ext_rec_presence_vector, u16le>>;
    };
};

/// ReportVelocityState: ID 4404h, deprecated, output of VelocityStateSensor.
struct report_velocity_state {
    std::optional<double> velocity_x{};   ///< meter per second, -327.68 to 327.67
    std::optional<double> velocity_y{};   ///< meter per second, -327.68 to 327.67
    std::optional<double> velocity_z{};   ///< meter per second, -327.68 to 327.67
    std::optional<double> velocity_rms{}; ///< meter per second, 0 to 100
    std::optional<double> roll_rate{};    ///< radian per second, -32.768 to 32.767
    std::optional<double> pitch_rate{};   ///< radian per second, -32.768 to 32.767
    std::optional<double> yaw_rate{};     ///< radian per second, -32.768 to 32.767
    std::optional<double> rate_rms{};     ///< radian per second, 0 to pi
    std::optional<mobility::time_stamp> time_stamp{};
    friend constexpr bool operator==(const report_velocity_state&, const report_velocity_state&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4404;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = report_velocity_state;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u16le,
                field<&T::velocity_x, scaled<u32le, meter_per_second_minus_327_68_to_327_67>>,
                field<&T::velocity_y, scaled<u32le, meter_per_second_minus_327_68_to_327_67>>,
                field<&T::velocity_z, scaled<u32le, meter_per_second_minus_327_68_to_327_67>>,
                field<&T::velocity_rms, scaled<u32le, meter_per_second_0_to_100>>,
                field<&T::roll_rate, scaled<u16le, radian_per_second_minus_32_768_to_32_767>>,
                field<&T::pitch_rate, scaled<u16le, radian_per_second_minus_32_768_to_32_767>>,
                field<&T::yaw_rate, scaled<u16le, radian_per_second_minus_32_768_to_32_767>>,
                field<&T::rate_rms, scaled<u16le, radian_per_second_0_to_pi>>,
                nested<&T::time_stamp>>>;
    };
};

/// Record VelocityVehicleXYZRec.
struct velocity_vehicle_xyz_rec {
    std::optional<double> velocity_x{}; ///< meter per second, -327.68 to 327.67
    std::optional<double> velocity_y{}; ///< meter per second, -327.68 to 327.67
    std::optional<double> velocity_z{}; ///< meter per second, -327.68 to 327.67
    friend constexpr bool operator==(const velocity_vehicle_xyz_rec&, const velocity_vehicle_xyz_rec&) = default;

    struct schema : wire::items {
        using T = velocity_vehicle_xyz_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::velocity_x, scaled<u32le, meter_per_second_minus_327_68_to_327_67>>,
                field<&T::velocity_y, scaled<u32le, meter_per_second_minus_327_68_to_327_67>>,
                field<&T::velocity_z, scaled<u32le, meter_per_second_minus_327_68_to_327_67>>>>;
    };
};

/// Record VelocityLocalXYZRec.
struct velocity_local_xyz_rec {
    std::optional<double> velocity_x{}; ///< meter per second, -327.68 to 327.67
    std::optional<double> velocity_y{}; ///< meter per second, -327.68 to 327.67
    std::optional<double> velocity_z{}; ///< meter per second, -327.68 to 327.67
    friend constexpr bool operator==(const velocity_local_xyz_rec&, const velocity_local_xyz_rec&) = default;

    struct schema : wire::items {
        using T = velocity_local_xyz_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::velocity_x, scaled<u32le, meter_per_second_minus_327_68_to_327_67>>,
                field<&T::velocity_y, scaled<u32le, meter_per_second_minus_327_68_to_327_67>>,
                field<&T::velocity_z, scaled<u32le, meter_per_second_minus_327_68_to_327_67>>>>;
    };
};

/// Record VelocityNEDRec.
struct velocity_ned_rec {
    std::optional<double> velocity_n{}; ///< meter per second, -327.68 to 327.67
    std::optional<double> velocity_e{}; ///< meter per second, -327.68 to 327.67
    std::optional<double> velocity_d{}; ///< meter per second, -327.68 to 327.67
    friend constexpr bool operator==(const velocity_ned_rec&, const velocity_ned_rec&) = default;

    struct schema : wire::items {
        using T = velocity_ned_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::velocity_n, scaled<u32le, meter_per_second_minus_327_68_to_327_67>>,
                field<&T::velocity_e, scaled<u32le, meter_per_second_minus_327_68_to_327_67>>,
                field<&T::velocity_d, scaled<u32le, meter_per_second_minus_327_68_to_327_67>>>>;
    };
};

/// Record ReportVelocityStateExtRec.
struct report_velocity_state_ext_rec {
    std::optional<double> velocity_rms{};             ///< meter per second, 0 to 100
    std::optional<double> roll_rate{};                ///< radian per second, -32.768 to 32.767
    std::optional<double> pitch_rate{};               ///< radian per second, -32.768 to 32.767
    std::optional<double> yaw_rate{};                 ///< radian per second, -32.768 to 32.767
    std::optional<double> rate_rms{};                 ///< radian per second, 0 to 100
    std::optional<double> speed_over_ground{};        ///< meter per second, -327.68 to 327.67
    std::optional<double> speed_relative_to_medium{}; ///< meter per second, -327.68 to 327.67
    std::optional<double> rotations_per_minute{};     ///< rotations per minute, -1000 to 1000
    std::optional<double> indicated_speed{};          ///< meter per second, -327.68 to 327.67
    std::optional<std::uint32_t> time_seconds{};      ///< second
    std::optional<std::uint32_t> time_nano_seconds{};
    friend constexpr bool operator==(
        const report_velocity_state_ext_rec&,
        const report_velocity_state_ext_rec&) = default;

    struct schema : wire::items {
        using T = report_velocity_state_ext_rec;
        using type = layout<
            lenient_presence<u16le,
                field<&T::velocity_rms, scaled<u32le, meter_per_second_0_to_100>>,
                field<&T::roll_rate, scaled<u32le, radian_per_second_minus_32_768_to_32_767>>,
                field<&T::pitch_rate, scaled<u32le, radian_per_second_minus_32_768_to_32_767>>,
                field<&T::yaw_rate, scaled<u32le, radian_per_second_minus_32_768_to_32_767>>,
                field<&T::rate_rms, scaled<u16le, radian_per_second_0_to_100>>,
                field<&T::speed_over_ground, scaled<u16le, meter_per_second_minus_327_68_to_327_67>>,
                field<&T::speed_relative_to_medium, scaled<u16le, meter_per_second_minus_327_68_to_327_67>>,
                field<&T::rotations_per_minute, scaled<u16le, rotations_per_minute_minus_1000_to_1000>>,
                field<&T::indicated_speed, scaled<u16le, meter_per_second_minus_327_68_to_327_67>>,
                field<&T::time_seconds, in_units<u32le, second>>,
                field<&T::time_nano_seconds, u32le>>>;
    };
};

/// ReportVelocityStateExt: ID 44A4h, output of VelocityStateSensor.
struct report_velocity_state_ext {
    std::variant<velocity_vehicle_xyz_rec, velocity_local_xyz_rec, velocity_ned_rec> velocity_var{};
    mobility::report_velocity_state_ext_rec report_velocity_state_ext_rec{};
    friend constexpr bool operator==(const report_velocity_state_ext&, const report_velocity_state_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x44A4;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_velocity_state_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            variant<&T::velocity_var, u8>,
            nested<&T::report_velocity_state_ext_rec>>;
    };
};

namespace services {

/// VelocityStateSensor: what it is called, and its messages.
struct velocity_state_sensor {
    static constexpr std::string_view name = "VelocityStateSensor";
    static constexpr std::string_view uri = "urn:jaus:jss:mobility:VelocityStateSensor";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Events";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<query_velocity_state, query_velocity_state_ext>;
    using outputs = jaus::message_list<report_velocity_state, report_velocity_state_ext>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::mobility
