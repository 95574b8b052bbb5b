// GlobalPathSegmentDriver 1.1, urn:jaus:jss:mobility:GlobalPathSegmentDriver.
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

/// QueryGlobalPathSegment: ID 240Fh, deprecated, input of GlobalPathSegmentDriver.
struct query_global_path_segment {
    std::uint8_t presence_vector{};
    friend constexpr bool operator==(const query_global_path_segment&, const query_global_path_segment&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x240F;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = query_global_path_segment;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u8>>;
    };
};

/// QueryGlobalPathSegmentExt: ID 24AFh, input of GlobalPathSegmentDriver.
struct query_global_path_segment_ext {
    std::uint8_t presence_vector{};
    friend constexpr bool operator==(
        const query_global_path_segment_ext&,
        const query_global_path_segment_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x24AF;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_global_path_segment_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u8>>;
    };
};

/// ReportGlobalPathSegment: ID 440Fh, deprecated, output of GlobalPathSegmentDriver.
struct report_global_path_segment {
    double p1_latitude{};                   ///< degree, -90 to 90
    double p1_longitude{};                  ///< degree, -180 to 180
    std::optional<double> p1_altitude{};    ///< meter, -10000 to 35000
    double p2_latitude{};                   ///< degree, -90 to 90
    double p2_longitude{};                  ///< degree, -180 to 180
    std::optional<double> p2_altitude{};    ///< meter, -10000 to 35000
    double weighting_factor{};              ///< 0 to 500
    std::optional<double> path_tolerance{}; ///< meter, 0 to 100000
    friend constexpr bool operator==(const report_global_path_segment&, const report_global_path_segment&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x440F;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = report_global_path_segment;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::p1_latitude, scaled<u32le, degree_minus_90_to_90>>,
                field<&T::p1_longitude, scaled<u32le, degree_minus_180_to_180>>,
                field<&T::p1_altitude, scaled<u32le, meter_minus_10000_to_35000>>,
                field<&T::p2_latitude, scaled<u32le, degree_minus_90_to_90>>,
                field<&T::p2_longitude, scaled<u32le, degree_minus_180_to_180>>,
                field<&T::p2_altitude, scaled<u32le, meter_minus_10000_to_35000>>,
                field<&T::weighting_factor, scaled<u16le, one_0_to_500>>,
                field<&T::path_tolerance, scaled<u32le, meter_0_to_100000>>>>;
    };
};

/// Values of P1_ZPosition.
enum class global_path_segment_driver_p1_z_position_form : std::uint8_t {
    altitude_agl = 0,
    altitude_msl = 1,
    altitude_asf = 2,
    depth = 3,
};

/// P1_ZPosition: a number in the form that is named before it.
struct global_path_segment_driver_p1_z_position {
    global_path_segment_driver_p1_z_position_form index{};
    double value{}; ///< meter, -50000 to 50000
    friend constexpr bool operator==(
        const global_path_segment_driver_p1_z_position&,
        const global_path_segment_driver_p1_z_position&) = default;

    struct schema : wire::items {
        using T = global_path_segment_driver_p1_z_position;
        using type = layout<
            field<&T::index, enumeration<global_path_segment_driver_p1_z_position_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<global_path_segment_driver_p1_z_position_form::altitude_agl,
                    scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_path_segment_driver_p1_z_position_form::altitude_msl,
                    scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_path_segment_driver_p1_z_position_form::altitude_asf,
                    scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_path_segment_driver_p1_z_position_form::depth, scaled<u32le, meter_minus_50000_to_50000>>>>;
    };
};

/// Values of P_ZPosition.
enum class p_z_position_form : std::uint8_t {
    altitude_agl = 0,
    altitude_msl = 1,
    altitude_asf = 2,
    depth = 3,
};

/// P_ZPosition: a number in the form that is named before it.
struct p_z_position {
    p_z_position_form index{};
    double value{}; ///< meter, -50000 to 50000
    friend constexpr bool operator==(const p_z_position&, const p_z_position&) = default;

    struct schema : wire::items {
        using T = p_z_position;
        using type = layout<
            field<&T::index, enumeration<p_z_position_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<p_z_position_form::altitude_agl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<p_z_position_form::altitude_msl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<p_z_position_form::altitude_asf, scaled<u32le, meter_minus_50000_to_50000>>,
                when<p_z_position_form::depth, scaled<u32le, meter_minus_50000_to_50000>>>>;
    };
};

/// ReportGlobalPathSegmentExt: ID 44AFh, output of GlobalPathSegmentDriver.
struct report_global_path_segment_ext {
    double p1_latitude{};                   ///< degree, -90 to 90
    double p1_longitude{};                  ///< degree, -180 to 180
    std::optional<global_path_segment_driver_p1_z_position> p1_z_position{};
    double p2_latitude{};                   ///< degree, -90 to 90
    double p2_longitude{};                  ///< degree, -180 to 180
    std::optional<mobility::p_z_position> p_z_position{};
    double weighting_factor{};              ///< 0 to 500
    std::optional<double> path_tolerance{}; ///< meter, 0 to 100000
    friend constexpr bool operator==(
        const report_global_path_segment_ext&,
        const report_global_path_segment_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x44AF;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_global_path_segment_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::p1_latitude, scaled<u32le, degree_minus_90_to_90>>,
                field<&T::p1_longitude, scaled<u32le, degree_minus_180_to_180>>,
                nested<&T::p1_z_position>,
                field<&T::p2_latitude, scaled<u32le, degree_minus_90_to_90>>,
                field<&T::p2_longitude, scaled<u32le, degree_minus_180_to_180>>,
                nested<&T::p_z_position>,
                field<&T::weighting_factor, scaled<u16le, one_0_to_500>>,
                field<&T::path_tolerance, scaled<u32le, meter_0_to_100000>>>>;
    };
};

namespace services {

/// GlobalPathSegmentDriver: what it is called, and its messages.
struct global_path_segment_driver {
    static constexpr std::string_view name = "GlobalPathSegmentDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:mobility:GlobalPathSegmentDriver";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:ListManager";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        execute_list,
        execute_list_ext,
        query_travel_speed,
        query_travel_speed_ext,
        query_global_path_segment,
        query_global_path_segment_ext,
        query_active_element>;
    using outputs = jaus::message_list<
        report_travel_speed,
        report_travel_speed_ext,
        report_global_path_segment,
        report_global_path_segment_ext,
        report_active_element>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::mobility
