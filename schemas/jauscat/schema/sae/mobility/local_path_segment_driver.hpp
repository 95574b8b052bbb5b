// LocalPathSegmentDriver 1.1, urn:jaus:jss:mobility:LocalPathSegmentDriver.
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

/// QueryLocalPathSegment: ID 2410h, deprecated, input of LocalPathSegmentDriver.
struct query_local_path_segment {
    std::uint8_t presence_vector{};
    friend constexpr bool operator==(const query_local_path_segment&, const query_local_path_segment&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2410;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = query_local_path_segment;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u8>>;
    };
};

/// QueryLocalPathSegmentExt: ID 24B0h, input of LocalPathSegmentDriver.
struct query_local_path_segment_ext {
    std::uint8_t presence_vector{};
    friend constexpr bool operator==(
        const query_local_path_segment_ext&,
        const query_local_path_segment_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x24B0;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_local_path_segment_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u8>>;
    };
};

/// ReportLocalPathSegment: ID 4410h, deprecated, output of LocalPathSegmentDriver.
struct report_local_path_segment {
    double p1_x{};                          ///< meter, -100000 to 100000
    double p1_y{};                          ///< meter, -100000 to 100000
    std::optional<double> p1_z{};           ///< meter, -10000 to 35000
    double p2_x{};                          ///< meter, -100000 to 100000
    double p2_y{};                          ///< meter, -100000 to 100000
    std::optional<double> p2_z{};           ///< meter, -10000 to 35000
    double weighting_factor{};              ///< 0 to 500
    std::optional<double> path_tolerance{}; ///< meter, 0 to 100000
    friend constexpr bool operator==(const report_local_path_segment&, const report_local_path_segment&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4410;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = report_local_path_segment;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::p1_x, scaled<u32le, meter_minus_100000_to_100000>>,
                field<&T::p1_y, scaled<u32le, meter_minus_100000_to_100000>>,
                field<&T::p1_z, scaled<u32le, meter_minus_10000_to_35000>>,
                field<&T::p2_x, scaled<u32le, meter_minus_100000_to_100000>>,
                field<&T::p2_y, scaled<u32le, meter_minus_100000_to_100000>>,
                field<&T::p2_z, scaled<u32le, meter_minus_10000_to_35000>>,
                field<&T::weighting_factor, scaled<u16le, one_0_to_500>>,
                field<&T::path_tolerance, scaled<u32le, meter_0_to_100000>>>>;
    };
};

/// Values of P1_ZPosition.
enum class local_path_segment_driver_p1_z_position_form : std::uint8_t {
    altitude_agl = 0,
    altitude_msl = 1,
    altitude_asf = 2,
    depth = 3,
    z_local = 4,
};

/// P1_ZPosition: a number in the form that is named before it.
struct local_path_segment_driver_p1_z_position {
    local_path_segment_driver_p1_z_position_form index{};
    double value{}; ///< meter, -50000 to 50000
    friend constexpr bool operator==(
        const local_path_segment_driver_p1_z_position&,
        const local_path_segment_driver_p1_z_position&) = default;

    struct schema : wire::items {
        using T = local_path_segment_driver_p1_z_position;
        using type = layout<
            field<&T::index, enumeration<local_path_segment_driver_p1_z_position_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<local_path_segment_driver_p1_z_position_form::altitude_agl,
                    scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_path_segment_driver_p1_z_position_form::altitude_msl,
                    scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_path_segment_driver_p1_z_position_form::altitude_asf,
                    scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_path_segment_driver_p1_z_position_form::depth, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_path_segment_driver_p1_z_position_form::z_local,
                    scaled<u32le, meter_minus_50000_to_50000>>>>;
    };
};

/// Values of P2_ZPosition.
enum class p2_z_position_form : std::uint8_t {
    altitude_agl = 0,
    altitude_msl = 1,
    altitude_asf = 2,
    depth = 3,
    z_local = 4,
};

/// P2_ZPosition: a number in the form that is named before it.
struct p2_z_position {
    p2_z_position_form index{};
    double value{}; ///< meter, -50000 to 50000
    friend constexpr bool operator==(const p2_z_position&, const p2_z_position&) = default;

    struct schema : wire::items {
        using T = p2_z_position;
        using type = layout<
            field<&T::index, enumeration<p2_z_position_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<p2_z_position_form::altitude_agl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<p2_z_position_form::altitude_msl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<p2_z_position_form::altitude_asf, scaled<u32le, meter_minus_50000_to_50000>>,
                when<p2_z_position_form::depth, scaled<u32le, meter_minus_50000_to_50000>>,
                when<p2_z_position_form::z_local, scaled<u32le, meter_minus_50000_to_50000>>>>;
    };
};

/// ReportLocalPathSegmentExt: ID 44B0h, output of LocalPathSegmentDriver.
struct report_local_path_segment_ext {
    double p1_x{};                          ///< meter, -20000000 to 20000000
    double p1_y{};                          ///< meter, -20000000 to 20000000
    std::optional<local_path_segment_driver_p1_z_position> p1_z_position{};
    double p2_x{};                          ///< meter, -20000000 to 20000000
    double p2_y{};                          ///< meter, -20000000 to 20000000
    std::optional<mobility::p2_z_position> p2_z_position{};
    double weighting_factor{};              ///< 0 to 500
    std::optional<double> path_tolerance{}; ///< meter, 0 to 100000
    friend constexpr bool operator==(
        const report_local_path_segment_ext&,
        const report_local_path_segment_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x44B0;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_local_path_segment_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::p1_x, scaled<u32le, meter_minus_20000000_to_20000000>>,
                field<&T::p1_y, scaled<u32le, meter_minus_20000000_to_20000000>>,
                nested<&T::p1_z_position>,
                field<&T::p2_x, scaled<u32le, meter_minus_20000000_to_20000000>>,
                field<&T::p2_y, scaled<u32le, meter_minus_20000000_to_20000000>>,
                nested<&T::p2_z_position>,
                field<&T::weighting_factor, scaled<u16le, one_0_to_500>>,
                field<&T::path_tolerance, scaled<u32le, meter_0_to_100000>>>>;
    };
};

namespace services {

/// LocalPathSegmentDriver: what it is called, and its messages.
struct local_path_segment_driver {
    static constexpr std::string_view name = "LocalPathSegmentDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:mobility:LocalPathSegmentDriver";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:ListManager";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        execute_list,
        execute_list_ext,
        query_travel_speed,
        query_travel_speed_ext,
        query_local_path_segment,
        query_local_path_segment_ext,
        query_active_element>;
    using outputs = jaus::message_list<
        report_travel_speed,
        report_travel_speed_ext,
        report_local_path_segment,
        report_local_path_segment_ext,
        report_active_element>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::mobility
