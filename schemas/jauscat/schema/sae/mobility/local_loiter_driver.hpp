// LocalLoiterDriver 1.1, urn:jaus:jss:mobility:LocalLoiterDriver.
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
enum class local_loiter_driver_z_position_form : std::uint8_t {
    altitude_agl = 0,
    altitude_msl = 1,
    altitude_asf = 2,
    depth = 3,
    z_local = 4,
};

/// ZPosition: a number in the form that is named before it.
struct local_loiter_driver_z_position {
    local_loiter_driver_z_position_form index{};
    double value{}; ///< meter, -50000 to 50000
    friend constexpr bool operator==(
        const local_loiter_driver_z_position&,
        const local_loiter_driver_z_position&) = default;

    struct schema : wire::items {
        using T = local_loiter_driver_z_position;
        using type = layout<
            field<&T::index, enumeration<local_loiter_driver_z_position_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<local_loiter_driver_z_position_form::altitude_agl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_loiter_driver_z_position_form::altitude_msl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_loiter_driver_z_position_form::altitude_asf, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_loiter_driver_z_position_form::depth, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_loiter_driver_z_position_form::z_local, scaled<u32le, meter_minus_50000_to_50000>>>>;
    };
};

/// Record LocalLoiterRec.
struct local_loiter_rec {
    double x{}; ///< meter, -20000000 to 20000000
    double y{}; ///< meter, -20000000 to 20000000
    std::optional<local_loiter_driver_z_position> z_position{};
    friend constexpr bool operator==(const local_loiter_rec&, const local_loiter_rec&) = default;

    struct schema : wire::items {
        using T = local_loiter_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::x, scaled<u32le, meter_minus_20000000_to_20000000>>,
                field<&T::y, scaled<u32le, meter_minus_20000000_to_20000000>>,
                nested<&T::z_position>>>;
    };
};

/// Values of HoverPreference.
enum class local_loiter_driver_hover_preference : std::uint8_t {
    xy_priority = 0,
    z_priority = 1,
};

/// Record HoverRec.
struct local_loiter_driver_hover_rec {
    local_loiter_driver_hover_preference hover_preference{};
    double xy_tolerance{}; ///< meter, 0 to 100000
    double z_tolerance{};  ///< meter, 0 to 50000
    friend constexpr bool operator==(
        const local_loiter_driver_hover_rec&,
        const local_loiter_driver_hover_rec&) = default;

    struct schema : wire::items {
        using T = local_loiter_driver_hover_rec;
        using type = layout<
            field<&T::hover_preference,
                in_value_set<enumeration<local_loiter_driver_hover_preference, u8>, between<0, 1>>>,
            field<&T::xy_tolerance, scaled<u32le, meter_0_to_100000>>,
            field<&T::z_tolerance, scaled<u32le, meter_0_to_50000>>>;
    };
};

/// SetLocalLoiter: ID 0426h, command, input of LocalLoiterDriver.
struct set_local_loiter {
    mobility::local_loiter_rec local_loiter_rec{};
    std::variant<local_loiter_driver_hover_rec, polygon_rec, race_track_rec> loiter{};
    friend constexpr bool operator==(const set_local_loiter&, const set_local_loiter&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0426;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_local_loiter;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::local_loiter_rec>,
            variant<&T::loiter, u8>>;
    };
};

/// QueryLocalLoiter: ID 2426h, input of LocalLoiterDriver.
struct query_local_loiter {
    std::uint8_t presence_vector{};
    friend constexpr bool operator==(const query_local_loiter&, const query_local_loiter&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2426;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_local_loiter;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u8>>;
    };
};

/// ReportLocalLoiter: ID 4426h, output of LocalLoiterDriver.
struct report_local_loiter {
    mobility::local_loiter_rec local_loiter_rec{};
    std::variant<local_loiter_driver_hover_rec, polygon_rec, race_track_rec> loiter{};
    friend constexpr bool operator==(const report_local_loiter&, const report_local_loiter&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4426;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_local_loiter;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::local_loiter_rec>,
            variant<&T::loiter, u8>>;
    };
};

namespace services {

/// LocalLoiterDriver: what it is called, and its messages.
struct local_loiter_driver {
    static constexpr std::string_view name = "LocalLoiterDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:mobility:LocalLoiterDriver";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        set_local_loiter,
        set_travel_speed_ext,
        query_local_loiter,
        query_travel_speed_ext>;
    using outputs = jaus::message_list<report_local_loiter, report_travel_speed_ext>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::mobility
