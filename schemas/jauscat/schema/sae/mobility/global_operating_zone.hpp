// GlobalOperatingZone 1.1, urn:jaus:jss:mobility:GlobalOperatingZone.
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

/// Values of MinZPosition.
enum class global_operating_zone_min_z_position_form : std::uint8_t {
    altitude_agl = 0,
    altitude_msl = 1,
    altitude_asf = 2,
    depth = 3,
};

/// MinZPosition: a number in the form that is named before it.
struct global_operating_zone_min_z_position {
    global_operating_zone_min_z_position_form index{};
    double value{}; ///< meter, -50000 to 50000
    friend constexpr bool operator==(
        const global_operating_zone_min_z_position&,
        const global_operating_zone_min_z_position&) = default;

    struct schema : wire::items {
        using T = global_operating_zone_min_z_position;
        using type = layout<
            field<&T::index, enumeration<global_operating_zone_min_z_position_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<global_operating_zone_min_z_position_form::altitude_agl,
                    scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_operating_zone_min_z_position_form::altitude_msl,
                    scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_operating_zone_min_z_position_form::altitude_asf,
                    scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_operating_zone_min_z_position_form::depth, scaled<u32le, meter_minus_50000_to_50000>>>>;
    };
};

/// Values of MaxZPosition.
enum class global_operating_zone_max_z_position_form : std::uint8_t {
    altitude_agl = 0,
    altitude_msl = 1,
    altitude_asf = 2,
    depth = 3,
};

/// MaxZPosition: a number in the form that is named before it.
struct global_operating_zone_max_z_position {
    global_operating_zone_max_z_position_form index{};
    double value{}; ///< meter, -50000 to 50000
    friend constexpr bool operator==(
        const global_operating_zone_max_z_position&,
        const global_operating_zone_max_z_position&) = default;

    struct schema : wire::items {
        using T = global_operating_zone_max_z_position;
        using type = layout<
            field<&T::index, enumeration<global_operating_zone_max_z_position_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<global_operating_zone_max_z_position_form::altitude_agl,
                    scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_operating_zone_max_z_position_form::altitude_msl,
                    scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_operating_zone_max_z_position_form::altitude_asf,
                    scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_operating_zone_max_z_position_form::depth, scaled<u32le, meter_minus_50000_to_50000>>>>;
    };
};

/// Record GlobalPolygonPointRec.
struct global_polygon_point_rec {
    double latitude{};  ///< degree, -90 to 90
    double longitude{}; ///< degree, -180 to 180
    std::optional<global_operating_zone_min_z_position> min_z_position{};
    std::optional<global_operating_zone_max_z_position> max_z_position{};
    friend constexpr bool operator==(const global_polygon_point_rec&, const global_polygon_point_rec&) = default;

    struct schema : wire::items {
        using T = global_polygon_point_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::latitude, scaled<u32le, degree_minus_90_to_90>>,
                field<&T::longitude, scaled<u32le, degree_minus_180_to_180>>,
                nested<&T::min_z_position>,
                nested<&T::max_z_position>>>;
    };
};

/// Record GlobalExclusionZoneRec.
struct global_exclusion_zone_rec {
    mobility::zone_id zone_id{}; ///< 2 to 65535
    friend constexpr bool operator==(const global_exclusion_zone_rec&, const global_exclusion_zone_rec&) = default;

    struct schema : wire::items {
        using T = global_exclusion_zone_rec;
        using type = layout<field<&T::zone_id, enumeration<mobility::zone_id, u16le>>>;
    };
};

/// Sequence GlobalExclusionZoneSeq.
struct global_exclusion_zone_seq {
    mobility::global_exclusion_zone_rec global_exclusion_zone_rec{};
    mobility::global_polygon_point_rec global_polygon_point_rec{};
    friend constexpr bool operator==(const global_exclusion_zone_seq&, const global_exclusion_zone_seq&) = default;

    struct schema : wire::items {
        using T = global_exclusion_zone_seq;
        using type = layout<
            nested<&T::global_exclusion_zone_rec>,
            nested<&T::global_polygon_point_rec>>;
    };
};

/// List GlobalExclusionZone.
struct global_exclusion_zone {
    wire::list<global_exclusion_zone_seq> elements{}; ///< up to 255 elements
    friend constexpr bool operator==(const global_exclusion_zone&, const global_exclusion_zone&) = default;

    struct schema : wire::items {
        using T = global_exclusion_zone;
        using type = layout<repeated<&T::elements, count<"number_of_elements", u8>>>;
    };
};

/// SetGlobalOperatingZone: ID 0423h, command, input of GlobalOperatingZone.
struct set_global_operating_zone {
    wire::list<global_polygon_point_rec> global_operating_zone{}; ///< up to 255 elements
    wire::list<global_exclusion_zone> global_exclusion_zones{};   ///< up to 255 elements
    friend constexpr bool operator==(const set_global_operating_zone&, const set_global_operating_zone&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0423;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_global_operating_zone;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::global_operating_zone, count<"number_of_global_operating_zone", u8>>,
            repeated<&T::global_exclusion_zones, count<"number_of_global_exclusion_zones", u8>>>;
    };
};

/// QueryGlobalOperatingZone: ID 2423h, input of GlobalOperatingZone.
struct query_global_operating_zone {
    mobility::query_zone_id query_zone_id{}; ///< 2 to 65535
    friend constexpr bool operator==(const query_global_operating_zone&, const query_global_operating_zone&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2423;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_global_operating_zone;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::query_zone_id, enumeration<mobility::query_zone_id, u16le>>>;
    };
};

/// ReportGlobalOperatingZone: ID 4423h, output of GlobalOperatingZone.
struct report_global_operating_zone {
    wire::list<global_polygon_point_rec> global_operating_zone{}; ///< up to 255 elements
    wire::list<global_exclusion_zone> global_exclusion_zones{};   ///< up to 255 elements
    friend constexpr bool operator==(
        const report_global_operating_zone&,
        const report_global_operating_zone&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4423;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_global_operating_zone;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::global_operating_zone, count<"number_of_global_operating_zone", u8>>,
            repeated<&T::global_exclusion_zones, count<"number_of_global_exclusion_zones", u8>>>;
    };
};

namespace services {

/// GlobalOperatingZone: what it is called, and its messages.
struct global_operating_zone {
    static constexpr std::string_view name = "GlobalOperatingZone";
    static constexpr std::string_view uri = "urn:jaus:jss:mobility:GlobalOperatingZone";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:AccessControl";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        set_global_operating_zone,
        delete_zone,
        query_global_operating_zone,
        query_excursion>;
    using outputs = jaus::message_list<report_global_operating_zone, report_excursion>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::mobility
