// LocalWaypointDriver 1.1, urn:jaus:jss:mobility:LocalWaypointDriver.
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

/// SetLocalWaypoint: ID 040Dh, command, deprecated, input of LocalWaypointDriver.
struct set_local_waypoint {
    double x{};                                 ///< meter, -100000 to 100000
    double y{};                                 ///< meter, -100000 to 100000
    std::optional<double> z{};                  ///< meter, -100000 to 100000
    std::optional<double> roll{};               ///< radian, -pi to pi
    std::optional<double> pitch{};              ///< radian, -pi to pi
    std::optional<double> yaw{};                ///< radian, -pi to pi
    std::optional<double> waypoint_tolerance{}; ///< meter, 0 to 100
    std::optional<double> path_tolerance{};     ///< meter, 0 to 100000
    friend constexpr bool operator==(const set_local_waypoint&, const set_local_waypoint&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x040D;
        static constexpr bool is_command = true, is_deprecated = true;
        using T = set_local_waypoint;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::x, scaled<u32le, meter_minus_100000_to_100000>>,
                field<&T::y, scaled<u32le, meter_minus_100000_to_100000>>,
                field<&T::z, scaled<u32le, meter_minus_100000_to_100000>>,
                field<&T::roll, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::pitch, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::yaw, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::waypoint_tolerance, scaled<u16le, meter_0_to_100>>,
                field<&T::path_tolerance, scaled<u32le, meter_0_to_100000>>>>;
    };
};

/// Values of ZPosition.
enum class local_waypoint_driver_z_position_form : std::uint8_t {
    altitude_agl = 0,
    altitude_msl = 1,
    altitude_asf = 2,
    depth = 3,
    z_local = 4,
};

/// ZPosition: a number in the form that is named before it.
struct local_waypoint_driver_z_position {
    local_waypoint_driver_z_position_form index{};
    double value{}; ///< meter, -50000 to 50000
    friend constexpr bool operator==(
        const local_waypoint_driver_z_position&,
        const local_waypoint_driver_z_position&) = default;

    struct schema : wire::items {
        using T = local_waypoint_driver_z_position;
        using type = layout<
            field<&T::index, enumeration<local_waypoint_driver_z_position_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<local_waypoint_driver_z_position_form::altitude_agl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_waypoint_driver_z_position_form::altitude_msl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_waypoint_driver_z_position_form::altitude_asf, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_waypoint_driver_z_position_form::depth, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_waypoint_driver_z_position_form::z_local, scaled<u32le, meter_minus_50000_to_50000>>>>;
    };
};

/// SetLocalWaypointExt: ID 04ADh, command, input of LocalWaypointDriver.
struct set_local_waypoint_ext {
    double x{};                                 ///< meter, -20000000 to 20000000
    double y{};                                 ///< meter, -20000000 to 20000000
    std::optional<local_waypoint_driver_z_position> z_position{};
    std::optional<double> roll{};               ///< radian, -pi to pi
    std::optional<double> pitch{};              ///< radian, -pi to pi
    std::optional<double> heading{};            ///< radian, -pi to pi
    std::optional<double> waypoint_tolerance{}; ///< meter, 0 to 10000
    std::optional<double> path_tolerance{};     ///< meter, 0 to 100000
    friend constexpr bool operator==(const set_local_waypoint_ext&, const set_local_waypoint_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x04AD;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_local_waypoint_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::x, scaled<u32le, meter_minus_20000000_to_20000000>>,
                field<&T::y, scaled<u32le, meter_minus_20000000_to_20000000>>,
                nested<&T::z_position>,
                field<&T::roll, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::pitch, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::heading, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::waypoint_tolerance, scaled<u32le, meter_0_to_10000>>,
                field<&T::path_tolerance, scaled<u32le, meter_0_to_100000>>>>;
    };
};

/// QueryLocalWaypoint: ID 240Dh, deprecated, input of LocalWaypointDriver.
struct query_local_waypoint {
    std::uint8_t presence_vector{};
    friend constexpr bool operator==(const query_local_waypoint&, const query_local_waypoint&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x240D;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = query_local_waypoint;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u8>>;
    };
};

/// QueryLocalWaypointExt: ID 24ADh, input of LocalWaypointDriver.
struct query_local_waypoint_ext {
    std::uint16_t presence_vector{};
    friend constexpr bool operator==(const query_local_waypoint_ext&, const query_local_waypoint_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x24AD;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_local_waypoint_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u16le>>;
    };
};

/// ReportLocalWaypoint: ID 440Dh, deprecated, output of LocalWaypointDriver.
struct report_local_waypoint {
    double x{};                                 ///< meter, -100000 to 100000
    double y{};                                 ///< meter, -100000 to 100000
    std::optional<double> z{};                  ///< meter, -100000 to 100000
    std::optional<double> roll{};               ///< radian, -pi to pi
    std::optional<double> pitch{};              ///< radian, -pi to pi
    std::optional<double> yaw{};                ///< radian, -pi to pi
    std::optional<double> waypoint_tolerance{}; ///< meter, 0 to 100
    std::optional<double> path_tolerance{};     ///< meter, 0 to 100000
    friend constexpr bool operator==(const report_local_waypoint&, const report_local_waypoint&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x440D;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = report_local_waypoint;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::x, scaled<u32le, meter_minus_100000_to_100000>>,
                field<&T::y, scaled<u32le, meter_minus_100000_to_100000>>,
                field<&T::z, scaled<u32le, meter_minus_100000_to_100000>>,
                field<&T::roll, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::pitch, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::yaw, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::waypoint_tolerance, scaled<u16le, meter_0_to_100>>,
                field<&T::path_tolerance, scaled<u32le, meter_0_to_100000>>>>;
    };
};

/// ReportLocalWaypointExt: ID 44ADh, output of LocalWaypointDriver.
struct report_local_waypoint_ext {
    double x{};                                 ///< meter, -20000000 to 20000000
    double y{};                                 ///< meter, -20000000 to 20000000
    std::optional<local_waypoint_driver_z_position> z_position{};
    std::optional<double> roll{};               ///< radian, -pi to pi
    std::optional<double> pitch{};              ///< radian, -pi to pi
    std::optional<double> heading{};            ///< radian, -pi to pi
    std::optional<double> waypoint_tolerance{}; ///< meter, 0 to 10000
    std::optional<double> path_tolerance{};     ///< meter, 0 to 100000
    friend constexpr bool operator==(const report_local_waypoint_ext&, const report_local_waypoint_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x44AD;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_local_waypoint_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::x, scaled<u32le, meter_minus_20000000_to_20000000>>,
                field<&T::y, scaled<u32le, meter_minus_20000000_to_20000000>>,
                nested<&T::z_position>,
                field<&T::roll, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::pitch, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::heading, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::waypoint_tolerance, scaled<u32le, meter_0_to_10000>>,
                field<&T::path_tolerance, scaled<u32le, meter_0_to_100000>>>>;
    };
};

namespace services {

/// LocalWaypointDriver: what it is called, and its messages.
struct local_waypoint_driver {
    static constexpr std::string_view name = "LocalWaypointDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:mobility:LocalWaypointDriver";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        set_travel_speed,
        set_travel_speed_ext,
        set_local_waypoint,
        set_local_waypoint_ext,
        query_travel_speed,
        query_travel_speed_ext,
        query_local_waypoint,
        query_local_waypoint_ext>;
    using outputs = jaus::message_list<
        report_travel_speed,
        report_travel_speed_ext,
        report_local_waypoint,
        report_local_waypoint_ext>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::mobility
