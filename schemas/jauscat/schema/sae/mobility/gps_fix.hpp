// GPSFix 1.1, urn:jaus:jss:mobility:GPSFix.
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

/// RequestGPSFix: ID 0428h, command, input of GPSFix.
struct request_gps_fix {
    friend constexpr bool operator==(const request_gps_fix&, const request_gps_fix&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0428;
        static constexpr bool is_command = true, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// QueryGPSFix: ID 2428h, input of GPSFix.
struct query_gps_fix {
    friend constexpr bool operator==(const query_gps_fix&, const query_gps_fix&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2428;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// Record GPSFixRec.
struct gps_fix_rec {
    std::uint32_t gps_fix_time_seconds{};          ///< second
    std::uint32_t gps_fix_time_nano_seconds{};
    std::optional<double> gps_latitude{};          ///< degree, -90 to 90
    std::optional<double> gps_longitude{};         ///< degree, -180 to 180
    std::optional<double> gps_true_course{};       ///< degree, -180 to 180
    std::optional<double> gps_speed_over_ground{}; ///< meter per second, 0 to 327.67
    friend constexpr bool operator==(const gps_fix_rec&, const gps_fix_rec&) = default;

    struct schema : wire::items {
        using T = gps_fix_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::gps_fix_time_seconds, in_units<u32le, second>>,
                field<&T::gps_fix_time_nano_seconds, u32le>,
                field<&T::gps_latitude, scaled<u32le, degree_minus_90_to_90>>,
                field<&T::gps_longitude, scaled<u32le, degree_minus_180_to_180>>,
                field<&T::gps_true_course, scaled<u32le, degree_minus_180_to_180>>,
                field<&T::gps_speed_over_ground, scaled<u16le, meter_per_second_0_to_327_67>>>>;
    };
};

/// Values of GPSValidity.
enum class gps_validity : std::uint8_t {
    invalid = 0,
    valid = 1,
};

/// Record MinGPSRec.
struct min_gps_rec {
    mobility::gps_validity gps_validity{};
    double gps_magnetic_variation{}; ///< degree, -90 to 90
    friend constexpr bool operator==(const min_gps_rec&, const min_gps_rec&) = default;

    struct schema : wire::items {
        using T = min_gps_rec;
        using type = layout<
            field<&T::gps_validity, in_value_set<enumeration<mobility::gps_validity, u8>, between<0, 1>>>,
            field<&T::gps_magnetic_variation, scaled<u32le, degree_minus_90_to_90>>>;
    };
};

/// Values of GPSStatus.
enum class gps_status : std::uint8_t {
    optimal_gps_signal = 0,
    good_gps_signal = 1,
    minimal_gps_signal = 2,
    no_gps_signal = 3,
};

/// Values of GPSFixCommandStatus.
enum class gps_fix_command_status : std::uint8_t {
    stable_gps_fix = 0,
    initiating_gps_fix = 1,
    performing_gps_fix = 2,
};

/// Values of GPSLatLonValid.
enum class gps_lat_lon_valid : std::uint8_t {
    false_value = 0, ///< FALSE
    true_value = 1,  ///< TRUE
};

/// Record AltGPSRec.
struct alt_gps_rec {
    mobility::gps_status gps_status{};
    mobility::gps_fix_command_status gps_fix_command_status{};
    mobility::gps_lat_lon_valid gps_lat_lon_valid{};
    std::optional<double> gps_velocity_east{};  ///< meter per second, -327.68 to 327.67
    std::optional<double> gps_velocity_north{}; ///< meter per second, -327.68 to 327.67
    std::optional<double> gps_velocity_down{};  ///< meter per second, -327.68 to 327.67
    std::optional<double> gps_altitude{};       ///< meter, -10000 to 35000
    std::optional<std::uint8_t> number_of_satellites_seen{};
    std::optional<std::uint8_t> number_of_satellites_in_solution{};
    friend constexpr bool operator==(const alt_gps_rec&, const alt_gps_rec&) = default;

    struct schema : wire::items {
        using T = alt_gps_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::gps_status, in_value_set<enumeration<mobility::gps_status, u8>, between<0, 3>>>,
                field<&T::gps_fix_command_status,
                    in_value_set<enumeration<mobility::gps_fix_command_status, u8>, between<0, 2>>>,
                field<&T::gps_lat_lon_valid, in_value_set<enumeration<mobility::gps_lat_lon_valid, u8>, between<0, 1>>>,
                field<&T::gps_velocity_east, scaled<u32le, meter_per_second_minus_327_68_to_327_67>>,
                field<&T::gps_velocity_north, scaled<u32le, meter_per_second_minus_327_68_to_327_67>>,
                field<&T::gps_velocity_down, scaled<u32le, meter_per_second_minus_327_68_to_327_67>>,
                field<&T::gps_altitude, scaled<u32le, meter_minus_10000_to_35000>>,
                field<&T::number_of_satellites_seen, u8>,
                field<&T::number_of_satellites_in_solution, u8>>>;
    };
};

/// ReportGPSFix: ID 4428h, output of GPSFix.
struct report_gps_fix {
    mobility::gps_fix_rec gps_fix_rec{};
    std::optional<std::variant<min_gps_rec, alt_gps_rec>> gps_status_var{};
    friend constexpr bool operator==(const report_gps_fix&, const report_gps_fix&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4428;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_gps_fix;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                nested<&T::gps_fix_rec>,
                variant<&T::gps_status_var, u8>>>;
    };
};

namespace services {

/// GPSFix: what it is called, and its messages.
struct gps_fix {
    static constexpr std::string_view name = "GPSFix";
    static constexpr std::string_view uri = "urn:jaus:jss:mobility:GPSFix";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<request_gps_fix, query_gps_fix>;
    using outputs = jaus::message_list<report_gps_fix>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::mobility
