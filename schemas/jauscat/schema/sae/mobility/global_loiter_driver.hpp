// GlobalLoiterDriver 1.1, urn:jaus:jss:mobility:GlobalLoiterDriver.
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

/// Values of ZPosition.
enum class global_loiter_driver_z_position_form : std::uint8_t {
    altitude_agl = 0,
    altitude_msl = 1,
    altitude_asf = 2,
    depth = 3,
};

/// ZPosition: a number in the form that is named before it.
struct global_loiter_driver_z_position {
    global_loiter_driver_z_position_form index{};
    double value{}; ///< meter, -50000 to 50000
    friend constexpr bool operator==(
        const global_loiter_driver_z_position&,
        const global_loiter_driver_z_position&) = default;

    struct schema : wire::items {
        using T = global_loiter_driver_z_position;
        using type = layout<
            field<&T::index, enumeration<global_loiter_driver_z_position_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<global_loiter_driver_z_position_form::altitude_agl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_loiter_driver_z_position_form::altitude_msl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_loiter_driver_z_position_form::altitude_asf, scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_loiter_driver_z_position_form::depth, scaled<u32le, meter_minus_50000_to_50000>>>>;
    };
};

/// Record GlobalLoiterRec.
struct global_loiter_rec {
    double latitude{};  ///< degree, -90 to 90
    double longitude{}; ///< degree, -180 to 180
    std::optional<global_loiter_driver_z_position> z_position{};
    friend constexpr bool operator==(const global_loiter_rec&, const global_loiter_rec&) = default;

    struct schema : wire::items {
        using T = global_loiter_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::latitude, scaled<u32le, degree_minus_90_to_90>>,
                field<&T::longitude, scaled<u32le, degree_minus_180_to_180>>,
                nested<&T::z_position>>>;
    };
};

/// Values of HoverPreference.
enum class global_loiter_driver_hover_preference : std::uint8_t {
    lat_lon_priority = 0,
    z_priority = 1,
};

/// Record HoverRec.
struct global_loiter_driver_hover_rec {
    global_loiter_driver_hover_preference hover_preference{};
    double xy_tolerance{}; ///< meter, 0 to 100000
    double z_tolerance{};  ///< meter, 0 to 50000
    friend constexpr bool operator==(
        const global_loiter_driver_hover_rec&,
        const global_loiter_driver_hover_rec&) = default;

    struct schema : wire::items {
        using T = global_loiter_driver_hover_rec;
        using type = layout<
            field<&T::hover_preference,
                in_value_set<enumeration<global_loiter_driver_hover_preference, u8>, between<0, 1>>>,
            field<&T::xy_tolerance, scaled<u32le, meter_0_to_100000>>,
            field<&T::z_tolerance, scaled<u32le, meter_0_to_50000>>>;
    };
};

/// SetGlobalLoiter: ID 0425h, command, input of GlobalLoiterDriver.
struct set_global_loiter {
    mobility::global_loiter_rec global_loiter_rec{};
    std::variant<global_loiter_driver_hover_rec, polygon_rec, race_track_rec> loiter{};
    friend constexpr bool operator==(const set_global_loiter&, const set_global_loiter&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0425;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_global_loiter;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::global_loiter_rec>,
            variant<&T::loiter, u8>>;
    };
};

/// QueryGlobalLoiter: ID 2425h, input of GlobalLoiterDriver.
struct query_global_loiter {
    std::uint8_t presence_vector{};
    friend constexpr bool operator==(const query_global_loiter&, const query_global_loiter&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2425;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_global_loiter;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u8>>;
    };
};

/// ReportGlobalLoiter: ID 4425h, output of GlobalLoiterDriver.
struct report_global_loiter {
    mobility::global_loiter_rec global_loiter_rec{};
    std::variant<global_loiter_driver_hover_rec, polygon_rec, race_track_rec> loiter{};
    friend constexpr bool operator==(const report_global_loiter&, const report_global_loiter&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4425;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_global_loiter;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::global_loiter_rec>,
            variant<&T::loiter, u8>>;
    };
};

namespace services {

/// GlobalLoiterDriver: what it is called, and its messages.
struct global_loiter_driver {
    static constexpr std::string_view name = "GlobalLoiterDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:mobility:GlobalLoiterDriver";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        set_global_loiter,
        set_travel_speed_ext,
        query_global_loiter,
        query_travel_speed_ext>;
    using outputs = jaus::message_list<report_global_loiter, report_travel_speed_ext>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::mobility
