// Messages and types that several services of the set mobility have.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/ranges.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::mobility {

/// Bits of TimeStamp.
struct time_stamp {
    std::uint16_t milliseconds{}; ///< 0 to 999
    std::uint8_t seconds{};       ///< 0 to 59
    std::uint8_t minutes{};       ///< 0 to 59
    std::uint8_t hour{};          ///< 0 to 23
    std::uint8_t day{};           ///< 1 to 31
    friend constexpr bool operator==(const time_stamp&, const time_stamp&) = default;

    struct schema : wire::items {
        using T = time_stamp;
        using type = layout<
            bit_fields<u32le,
                bit_field_in_set<&T::milliseconds, 10, between<0, 999>>,
                bit_field_in_set<&T::seconds, 6, between<0, 59>>,
                bit_field_in_set<&T::minutes, 6, between<0, 59>>,
                bit_field_in_set<&T::hour, 5, between<0, 23>>,
                bit_field_in_set<&T::day, 5, between<1, 31>>>>;
    };
};

/// Values of LoiterDirection.
enum class loiter_direction : std::uint8_t {
    vehicle_dependent = 0,
    clockwise = 1,
    counter_clockwise = 2,
};

/// Record PolygonRec.
struct polygon_rec {
    std::uint8_t number_loiter_vertices{};
    double xy_extent{};      ///< meter, 0 to 100000
    mobility::loiter_direction loiter_direction{};
    double loiter_bearing{}; ///< radian, 0 to pi
    friend constexpr bool operator==(const polygon_rec&, const polygon_rec&) = default;

    struct schema : wire::items {
        using T = polygon_rec;
        using type = layout<
            field<&T::number_loiter_vertices, u8>,
            field<&T::xy_extent, scaled<u32le, meter_0_to_100000>>,
            field<&T::loiter_direction, in_value_set<enumeration<mobility::loiter_direction, u8>, between<0, 2>>>,
            field<&T::loiter_bearing, scaled<u16le, radian_0_to_pi>>>;
    };
};

/// Values of LoiterType.
enum class loiter_type : std::uint8_t {
    racetrack = 0,
    figure8 = 1,
};

/// Record RaceTrackRec.
struct race_track_rec {
    mobility::loiter_type loiter_type{};
    double loiter_radius{};  ///< meter, 0 to 200000
    double loiter_length{};  ///< meter, 0 to 200000
    mobility::loiter_direction loiter_direction{};
    double loiter_bearing{}; ///< radian, 0 to pi
    friend constexpr bool operator==(const race_track_rec&, const race_track_rec&) = default;

    struct schema : wire::items {
        using T = race_track_rec;
        using type = layout<
            field<&T::loiter_type, in_value_set<enumeration<mobility::loiter_type, u8>, between<0, 1>>>,
            field<&T::loiter_radius, scaled<u32le, meter_0_to_200000>>,
            field<&T::loiter_length, scaled<u32le, meter_0_to_200000>>,
            field<&T::loiter_direction, in_value_set<enumeration<mobility::loiter_direction, u8>, between<0, 2>>>,
            field<&T::loiter_bearing, scaled<u16le, radian_0_to_pi>>>;
    };
};

/// Values of Speed.
enum class speed_form : std::uint8_t {
    speed_over_ground = 0,
    speed_relative_to_medium = 1,
    rotations_per_minute = 2,
    indicated_speed = 3,
};

/// Speed: a number in the form that is named before it.
struct speed {
    speed_form index{};
    double value{}; ///< as its form says
    friend constexpr bool operator==(const speed&, const speed&) = default;

    struct schema : wire::items {
        using T = speed;
        using type = layout<
            field<&T::index, enumeration<speed_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<speed_form::speed_over_ground, scaled<u16le, meter_per_second_minus_327_68_to_327_67>>,
                when<speed_form::speed_relative_to_medium, scaled<u16le, meter_per_second_minus_327_68_to_327_67>>,
                when<speed_form::rotations_per_minute, scaled<u16le, rotations_per_minute_minus_1000_to_1000>>,
                when<speed_form::indicated_speed, scaled<u16le, meter_per_second_minus_327_68_to_327_67>>>>;
    };
};

/// SetTravelSpeedExt: ID 04AAh, command, input of GlobalLoiterDriver, GlobalWaypointDriver, LocalLoiterDriver,
/// LocalWaypointDriver.
struct set_travel_speed_ext {
    mobility::speed speed{};
    friend constexpr bool operator==(const set_travel_speed_ext&, const set_travel_speed_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x04AA;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_travel_speed_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::speed>>;
    };
};

/// QueryTravelSpeedExt: ID 24AAh, input of GlobalLoiterDriver, GlobalPathSegmentDriver, GlobalWaypointDriver,
/// GlobalWaypointListDriver, LocalLoiterDriver, LocalPathSegmentDriver, LocalWaypointDriver.
struct query_travel_speed_ext {
    friend constexpr bool operator==(const query_travel_speed_ext&, const query_travel_speed_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x24AA;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ReportTravelSpeedExt: ID 44AAh, output of GlobalLoiterDriver, GlobalPathSegmentDriver, GlobalWaypointDriver,
/// GlobalWaypointListDriver, LocalLoiterDriver, LocalPathSegmentDriver, LocalWaypointDriver.
struct report_travel_speed_ext {
    mobility::speed speed{};
    friend constexpr bool operator==(const report_travel_speed_ext&, const report_travel_speed_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x44AA;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_travel_speed_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::speed>>;
    };
};

/// Values of ZoneID.
enum class zone_id : std::uint16_t {
    reserved = 0,
    operating_zone = 1,
};

/// Record ZoneIDRec.
struct zone_id_rec {
    mobility::zone_id zone_id{}; ///< 2 to 65535
    friend constexpr bool operator==(const zone_id_rec&, const zone_id_rec&) = default;

    struct schema : wire::items {
        using T = zone_id_rec;
        using type = layout<field<&T::zone_id, enumeration<mobility::zone_id, u16le>>>;
    };
};

/// DeleteZone: ID 0422h, command, input of GlobalOperatingZone, LocalOperatingZone.
struct delete_zone {
    wire::list<zone_id_rec> zone_id_list{}; ///< up to 255 elements
    friend constexpr bool operator==(const delete_zone&, const delete_zone&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0422;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = delete_zone;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::zone_id_list, count<"number_of_zone_id_list", u8>>>;
    };
};

/// Values of QueryZoneID.
enum class query_zone_id : std::uint16_t {
    all_zones = 0,
    operating_zone = 1,
};

/// QueryExcursion: ID 2424h, input of GlobalOperatingZone, LocalOperatingZone.
struct query_excursion {
    mobility::query_zone_id query_zone_id{}; ///< 2 to 65535
    friend constexpr bool operator==(const query_excursion&, const query_excursion&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2424;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_excursion;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::query_zone_id, enumeration<mobility::query_zone_id, u16le>>>;
    };
};

/// Values of ZoneStatus.
enum class zone_status : std::uint8_t {
    inside_safe_op_zone = 0,
    outsize_safe_op_zone = 1,
    inside_safe_op_zone_and_inside_exclusion_zone = 2,
};

/// Record ExcursionRec.
struct excursion_rec {
    mobility::zone_id zone_id{}; ///< 2 to 65535
    mobility::zone_status zone_status{};
    friend constexpr bool operator==(const excursion_rec&, const excursion_rec&) = default;

    struct schema : wire::items {
        using T = excursion_rec;
        using type = layout<
            field<&T::zone_id, enumeration<mobility::zone_id, u16le>>,
            field<&T::zone_status, in_value_set<enumeration<mobility::zone_status, u8>, between<0, 2>>>>;
    };
};

/// ReportExcursion: ID 4424h, output of GlobalOperatingZone, LocalOperatingZone.
struct report_excursion {
    wire::list<excursion_rec> excursion{}; ///< up to 255 elements
    friend constexpr bool operator==(const report_excursion&, const report_excursion&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4424;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_excursion;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::excursion, count<"number_of_excursion", u8>>>;
    };
};

/// ExecuteList: ID 041Eh, command, deprecated, input of GlobalPathSegmentDriver, GlobalWaypointListDriver,
/// LocalPathSegmentDriver.
struct execute_list {
    double speed{}; ///< meter per second, 0 to 327.67
    std::optional<std::uint16_t> element_uid{};
    friend constexpr bool operator==(const execute_list&, const execute_list&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x041E;
        static constexpr bool is_command = true, is_deprecated = true;
        using T = execute_list;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::speed, scaled<u16le, meter_per_second_0_to_327_67>>,
                field<&T::element_uid, u16le>>>;
    };
};

/// ExecuteListExt: ID 04AEh, command, input of GlobalPathSegmentDriver, GlobalWaypointListDriver,
/// LocalPathSegmentDriver.
struct execute_list_ext {
    mobility::speed speed{};
    std::optional<std::uint16_t> element_uid{};
    friend constexpr bool operator==(const execute_list_ext&, const execute_list_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x04AE;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = execute_list_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                nested<&T::speed>,
                field<&T::element_uid, u16le>>>;
    };
};

/// QueryTravelSpeed: ID 240Ah, deprecated, input of GlobalPathSegmentDriver, GlobalWaypointDriver,
/// GlobalWaypointListDriver, LocalPathSegmentDriver, LocalWaypointDriver.
struct query_travel_speed {
    friend constexpr bool operator==(const query_travel_speed&, const query_travel_speed&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x240A;
        static constexpr bool is_command = false, is_deprecated = true;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// QueryActiveElement: ID 241Eh, input of GlobalPathSegmentDriver, GlobalWaypointListDriver, LocalPathSegmentDriver.
struct query_active_element {
    friend constexpr bool operator==(const query_active_element&, const query_active_element&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x241E;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ReportTravelSpeed: ID 440Ah, deprecated, output of GlobalPathSegmentDriver, GlobalWaypointDriver,
/// GlobalWaypointListDriver, LocalPathSegmentDriver, LocalWaypointDriver.
struct report_travel_speed {
    double speed{}; ///< meter per second, 0 to 327.67
    friend constexpr bool operator==(const report_travel_speed&, const report_travel_speed&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x440A;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = report_travel_speed;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::speed, scaled<u16le, meter_per_second_0_to_327_67>>>;
    };
};

/// ReportActiveElement: ID 441Eh, output of GlobalPathSegmentDriver, GlobalWaypointListDriver, LocalPathSegmentDriver.
struct report_active_element {
    std::uint16_t element_uid{};
    friend constexpr bool operator==(const report_active_element&, const report_active_element&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x441E;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_active_element;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::element_uid, u16le>>;
    };
};

/// SetTravelSpeed: ID 040Ah, command, deprecated, input of GlobalWaypointDriver, LocalWaypointDriver.
struct set_travel_speed {
    double speed{}; ///< meter per second, 0 to 327.67
    friend constexpr bool operator==(const set_travel_speed&, const set_travel_speed&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x040A;
        static constexpr bool is_command = true, is_deprecated = true;
        using T = set_travel_speed;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::speed, scaled<u16le, meter_per_second_0_to_327_67>>>;
    };
};

/// QueryGlobalWaypoint: ID 240Ch, deprecated, input of GlobalWaypointDriver, GlobalWaypointListDriver.
struct query_global_waypoint {
    std::uint8_t presence_vector{};
    friend constexpr bool operator==(const query_global_waypoint&, const query_global_waypoint&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x240C;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = query_global_waypoint;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u8>>;
    };
};

/// QueryGlobalWaypointExt: ID 24ACh, input of GlobalWaypointDriver, GlobalWaypointListDriver.
struct query_global_waypoint_ext {
    std::uint16_t presence_vector{};
    friend constexpr bool operator==(const query_global_waypoint_ext&, const query_global_waypoint_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x24AC;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_global_waypoint_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u16le>>;
    };
};

/// ReportGlobalWaypoint: ID 440Ch, deprecated, output of GlobalWaypointDriver, GlobalWaypointListDriver.
struct report_global_waypoint {
    double latitude{};                          ///< degree, -90 to 90
    double longitude{};                         ///< degree, -180 to 180
    std::optional<double> altitude{};           ///< meter, -10000 to 35000
    std::optional<double> roll{};               ///< radian, -pi to pi
    std::optional<double> pitch{};              ///< radian, -pi to pi
    std::optional<double> yaw{};                ///< radian, -pi to pi
    std::optional<double> waypoint_tolerance{}; ///< meter, 0 to 100
    std::optional<double> path_tolerance{};     ///< meter, 0 to 100000
    friend constexpr bool operator==(const report_global_waypoint&, const report_global_waypoint&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x440C;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = report_global_waypoint;
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
enum class shared_z_position_form : std::uint8_t {
    altitude_agl = 0,
    altitude_msl = 1,
    altitude_asf = 2,
    depth = 3,
};

/// ZPosition: a number in the form that is named before it.
struct shared_z_position {
    shared_z_position_form index{};
    double value{}; ///< meter, -50000 to 50000
    friend constexpr bool operator==(const shared_z_position&, const shared_z_position&) = default;

    struct schema : wire::items {
        using T = shared_z_position;
        using type = layout<
            field<&T::index, enumeration<shared_z_position_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<shared_z_position_form::altitude_agl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<shared_z_position_form::altitude_msl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<shared_z_position_form::altitude_asf, scaled<u32le, meter_minus_50000_to_50000>>,
                when<shared_z_position_form::depth, scaled<u32le, meter_minus_50000_to_50000>>>>;
    };
};

/// ReportGlobalWaypointExt: ID 44ACh, output of GlobalWaypointDriver, GlobalWaypointListDriver.
struct report_global_waypoint_ext {
    double latitude{};                          ///< degree, -90 to 90
    double longitude{};                         ///< degree, -180 to 180
    std::optional<shared_z_position> z_position{};
    std::optional<double> roll{};               ///< radian, -pi to pi
    std::optional<double> pitch{};              ///< radian, -pi to pi
    std::optional<double> heading{};            ///< radian, -pi to pi
    std::optional<double> waypoint_tolerance{}; ///< meter, 0 to 10000
    std::optional<double> path_tolerance{};     ///< meter, 0 to 100000
    friend constexpr bool operator==(const report_global_waypoint_ext&, const report_global_waypoint_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x44AC;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_global_waypoint_ext;
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

} // namespace jauscat::sae::mobility
