// LocalOperatingZone 1.1, urn:jaus:jss:mobility:LocalOperatingZone.
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
enum class local_operating_zone_min_z_position_form : std::uint8_t {
    altitude_agl = 0,
    altitude_msl = 1,
    altitude_asf = 2,
    depth = 3,
    z_local = 4,
};

/// MinZPosition: a number in the form that is named before it.
struct local_operating_zone_min_z_position {
    local_operating_zone_min_z_position_form index{};
    double value{}; ///< meter, -50000 to 50000
    friend constexpr bool operator==(
        const local_operating_zone_min_z_position&,
        const local_operating_zone_min_z_position&) = default;

    struct schema : wire::items {
        using T = local_operating_zone_min_z_position;
        using type = layout<
            field<&T::index, enumeration<local_operating_zone_min_z_position_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<local_operating_zone_min_z_position_form::altitude_agl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_operating_zone_min_z_position_form::altitude_msl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_operating_zone_min_z_position_form::altitude_asf, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_operating_zone_min_z_position_form::depth, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_operating_zone_min_z_position_form::z_local, scaled<u32le, meter_minus_50000_to_50000>>>>;
    };
};

/// Values of MaxZPosition.
enum class local_operating_zone_max_z_position_form : std::uint8_t {
    altitude_agl = 0,
    altitude_msl = 1,
    altitude_asf = 2,
    depth = 3,
    z_local = 4,
};

/// MaxZPosition: a number in the form that is named before it.
struct local_operating_zone_max_z_position {
    local_operating_zone_max_z_position_form index{};
    double value{}; ///< meter, -50000 to 50000
    friend constexpr bool operator==(
        const local_operating_zone_max_z_position&,
        const local_operating_zone_max_z_position&) = default;

    struct schema : wire::items {
        using T = local_operating_zone_max_z_position;
        using type = layout<
            field<&T::index, enumeration<local_operating_zone_max_z_position_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<local_operating_zone_max_z_position_form::altitude_agl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_operating_zone_max_z_position_form::altitude_msl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_operating_zone_max_z_position_form::altitude_asf, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_operating_zone_max_z_position_form::depth, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_operating_zone_max_z_position_form::z_local, scaled<u32le, meter_minus_50000_to_50000>>>>;
    };
};

/// Record LocalPolygonPointRec.
struct local_polygon_point_rec {
    double x{}; ///< meter, -20000000 to 20000000
    double y{}; ///< meter, -20000000 to 20000000
    std::optional<local_operating_zone_min_z_position> min_z_position{};
    std::optional<local_operating_zone_max_z_position> max_z_position{};
    friend constexpr bool operator==(const local_polygon_point_rec&, const local_polygon_point_rec&) = default;

    struct schema : wire::items {
        using T = local_polygon_point_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::x, scaled<u32le, meter_minus_20000000_to_20000000>>,
                field<&T::y, scaled<u32le, meter_minus_20000000_to_20000000>>,
                nested<&T::min_z_position>,
                nested<&T::max_z_position>>>;
    };
};

/// Record LocalExclusionZoneRec.
struct local_exclusion_zone_rec {
    mobility::zone_id zone_id{}; ///< 2 to 65535
    friend constexpr bool operator==(const local_exclusion_zone_rec&, const local_exclusion_zone_rec&) = default;

    struct schema : wire::items {
        using T = local_exclusion_zone_rec;
        using type = layout<field<&T::zone_id, enumeration<mobility::zone_id, u16le>>>;
    };
};

/// Sequence LocalExclusionZoneSeq.
struct local_exclusion_zone_seq {
    mobility::local_exclusion_zone_rec local_exclusion_zone_rec{};
    mobility::local_polygon_point_rec local_polygon_point_rec{};
    friend constexpr bool operator==(const local_exclusion_zone_seq&, const local_exclusion_zone_seq&) = default;

    struct schema : wire::items {
        using T = local_exclusion_zone_seq;
        using type = layout<
            nested<&T::local_exclusion_zone_rec>,
            nested<&T::local_polygon_point_rec>>;
    };
};

/// List LocalExclusionZone.
struct local_exclusion_zone {
    wire::list<local_exclusion_zone_seq> elements{}; ///< up to 255 elements
    friend constexpr bool operator==(const local_exclusion_zone&, const local_exclusion_zone&) = default;

    struct schema : wire::items {
        using T = local_exclusion_zone;
        using type = layout<repeated<&T::elements, count<"number_of_elements", u8>>>;
    };
};

/// SetLocalOperatingZone: ID 0427h, command, input of LocalOperatingZone.
struct set_local_operating_zone {
    wire::list<local_polygon_point_rec> local_operating_zone{}; ///< up to 255 elements
    wire::list<local_exclusion_zone> local_exclusion_zones{};   ///< up to 255 elements
    friend constexpr bool operator==(const set_local_operating_zone&, const set_local_operating_zone&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0427;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_local_operating_zone;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::local_operating_zone, count<"number_of_local_operating_zone", u8>>,
            repeated<&T::local_exclusion_zones, count<"number_of_local_exclusion_zones", u8>>>;
    };
};

/// QueryLocalOperatingZone: ID 2427h, input of LocalOperatingZone.
struct query_local_operating_zone {
    mobility::query_zone_id query_zone_id{}; ///< 2 to 65535
    friend constexpr bool operator==(const query_local_operating_zone&, const query_local_operating_zone&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2427;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_local_operating_zone;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::query_zone_id, enumeration<mobility::query_zone_id, u16le>>>;
    };
};

/// ReportLocalOperatingZone: ID 4427h, output of LocalOperatingZone.
struct report_local_operating_zone {
    wire::list<local_polygon_point_rec> local_operating_zone{}; ///< up to 255 elements
    wire::list<local_exclusion_zone> local_exclusion_zones{};   ///< up to 255 elements
    friend constexpr bool operator==(const report_local_operating_zone&, const report_local_operating_zone&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4427;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_local_operating_zone;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::local_operating_zone, count<"number_of_local_operating_zone", u8>>,
            repeated<&T::local_exclusion_zones, count<"number_of_local_exclusion_zones", u8>>>;
    };
};

namespace services {

/// LocalOperatingZone: what it is called, and its messages.
struct local_operating_zone {
    static constexpr std::string_view name = "LocalOperatingZone";
    static constexpr std::string_view uri = "urn:jaus:jss:mobility:LocalOperatingZone";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:AccessControl";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        set_local_operating_zone,
        delete_zone,
        query_local_operating_zone,
        query_excursion>;
    using outputs = jaus::message_list<report_local_operating_zone, report_excursion>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::mobility
