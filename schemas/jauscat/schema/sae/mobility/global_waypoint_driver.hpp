// GlobalWaypointDriver 1.1, urn:jaus:jss:mobility:GlobalWaypointDriver.
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

/// SetGlobalWaypoint: ID 040Ch, command, deprecated, input of GlobalWaypointDriver.
struct set_global_waypoint {
    double latitude{};                          ///< degree, -90 to 90
    double longitude{};                         ///< degree, -180 to 180
    std::optional<double> altitude{};           ///< meter, -10000 to 35000
    std::optional<double> roll{};               ///< radian, -pi to pi
    std::optional<double> pitch{};              ///< radian, -pi to pi
    std::optional<double> yaw{};                ///< radian, -pi to pi
    std::optional<double> waypoint_tolerance{}; ///< meter, 0 to 100
    std::optional<double> path_tolerance{};     ///< meter, 0 to 100000
    friend constexpr bool operator==(const set_global_waypoint&, const set_global_waypoint&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x040C;
        static constexpr bool is_command = true, is_deprecated = true;
        using T = set_global_waypoint;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::latitude, scaled<u32le, degree_minus_90_to_90>>,
                field<&T::longitude, scaled<u32le, degree_minus_180_to_180>>,
                field<&T::altitude, scaled<u32le, meter_minus_10000_to_35000>>,
                field<&T::roll, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::pitch, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::yaw, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::waypoint_tolerance, scaled<u16le, meter_0_to_100>>,
                field<&T::path_tolerance, scaled<u32le, meter_0_to_100000>>>>;
    };
};

/// Values of ZPosition.
enum class global_waypoint_driver_z_position_form : std::uint8_t {
    altitude_agl = 0,
    altitude_msl = 1,
    altitude_asf = 2,
    depth = 3,
};

/// ZPosition: a number in the form that is named before it.
struct global_waypoint_driver_z_position {
    global_waypoint_driver_z_position_form index{};
    double value{}; ///< meter, -50000 to 50000
    friend constexpr bool operator==(
        const global_waypoint_driver_z_position&,
        const global_waypoint_driver_z_position&) = default;

    struct schema : wire::items {
        using T = global_waypoint_driver_z_position;
        using type = layout<
            field<&T::index, enumeration<global_waypoint_driver_z_position_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<global_waypoint_driver_z_position_form::altitude_agl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_waypoint_driver_z_position_form::altitude_msl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_waypoint_driver_z_position_form::altitude_asf, scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_waypoint_driver_z_position_form::depth, scaled<u32le, meter_minus_50000_to_50000>>>>;
    };
};

/// SetGlobalWaypointExt: ID 04ACh, command, input of GlobalWaypointDriver.
struct set_global_waypoint_ext {
    double latitude{};                          ///< degree, -90 to 90
    double longitude{};                         ///< degree, -180 to 180
    std::optional<global_waypoint_driver_z_position> z_position{};
    std::optional<double> roll{};               ///< radian, -pi to pi
    std::optional<double> pitch{};              ///< radian, -pi to pi
    std::optional<double> heading{};            ///< radian, -pi to pi
    std::optional<double> waypoint_tolerance{}; ///< meter, 0 to 10000
    std::optional<double> path_tolerance{};     ///< meter, 0 to 100000
    friend constexpr bool operator==(const set_global_waypoint_ext&, const set_global_waypoint_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x04AC;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_global_waypoint_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::latitude, scaled<u32le, degree_minus_90_to_90>>,
                field<&T::longitude, scaled<u32le, degree_minus_180_to_180>>,
                nested<&T::z_position>,
                field<&T::roll, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::pitch, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::heading, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::waypoint_tolerance, scaled<u32le, meter_0_to_10000>>,
                field<&T::path_tolerance, scaled<u32le, meter_0_to_100000>>>>;
    };
};

namespace services {

/// GlobalWaypointDriver: what it is called, and its messages.
struct global_waypoint_driver {
    static constexpr std::string_view name = "GlobalWaypointDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:mobility:GlobalWaypointDriver";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        set_travel_speed,
        set_travel_speed_ext,
        set_global_waypoint,
        set_global_waypoint_ext,
        query_travel_speed,
        query_travel_speed_ext,
        query_global_waypoint,
        query_global_waypoint_ext>;
    using outputs = jaus::message_list<
        report_travel_speed,
        report_travel_speed_ext,
        report_global_waypoint,
        report_global_waypoint_ext>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::mobility
