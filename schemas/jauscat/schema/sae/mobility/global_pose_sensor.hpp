// GlobalPoseSensor 1.1, urn:jaus:jss:mobility:GlobalPoseSensor.
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

/// SetGlobalPose: ID 0402h, command, deprecated, input of GlobalPoseSensor.
struct set_global_pose {
    std::optional<double> latitude{};     ///< degree, -90 to 90
    std::optional<double> longitude{};    ///< degree, -180 to 180
    std::optional<double> altitude{};     ///< meter, -10000 to 35000
    std::optional<double> position_rms{}; ///< meter, 0 to 100
    std::optional<double> roll{};         ///< radian, -pi to pi
    std::optional<double> pitch{};        ///< radian, -pi to pi
    std::optional<double> yaw{};          ///< radian, -pi to pi
    std::optional<double> attitude_rms{}; ///< radian, 0 to pi
    std::optional<mobility::time_stamp> time_stamp{};
    friend constexpr bool operator==(const set_global_pose&, const set_global_pose&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0402;
        static constexpr bool is_command = true, is_deprecated = true;
        using T = set_global_pose;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u16le,
                field<&T::latitude, scaled<u32le, degree_minus_90_to_90>>,
                field<&T::longitude, scaled<u32le, degree_minus_180_to_180>>,
                field<&T::altitude, scaled<u32le, meter_minus_10000_to_35000>>,
                field<&T::position_rms, scaled<u32le, meter_0_to_100>>,
                field<&T::roll, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::pitch, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::yaw, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::attitude_rms, scaled<u16le, radian_0_to_pi>>,
                nested<&T::time_stamp>>>;
    };
};

/// Values of ZPosition.
enum class global_pose_sensor_z_position_form : std::uint8_t {
    altitude_agl = 0,
    altitude_msl = 1,
    altitude_asf = 2,
    depth = 3,
};

/// ZPosition: a number in the form that is named before it.
struct global_pose_sensor_z_position {
    global_pose_sensor_z_position_form index{};
    double value{}; ///< meter, -50000 to 50000
    friend constexpr bool operator==(
        const global_pose_sensor_z_position&,
        const global_pose_sensor_z_position&) = default;

    struct schema : wire::items {
        using T = global_pose_sensor_z_position;
        using type = layout<
            field<&T::index, enumeration<global_pose_sensor_z_position_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<global_pose_sensor_z_position_form::altitude_agl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_pose_sensor_z_position_form::altitude_msl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_pose_sensor_z_position_form::altitude_asf, scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_pose_sensor_z_position_form::depth, scaled<u32le, meter_minus_50000_to_50000>>>>;
    };
};

/// SetGlobalPoseExt: ID 04A2h, command, input of GlobalPoseSensor.
struct set_global_pose_ext {
    std::optional<double> latitude{};            ///< degree, -90 to 90
    std::optional<double> longitude{};           ///< degree, -180 to 180
    std::optional<global_pose_sensor_z_position> z_position{};
    std::optional<double> horizontal_rms{};      ///< meter, 0 to 100
    std::optional<double> vertical_rms{};        ///< meter, 0 to 100
    std::optional<double> roll{};                ///< radian, -pi to pi
    std::optional<double> pitch{};               ///< radian, -pi to pi
    std::optional<double> heading{};             ///< radian, -pi to pi
    std::optional<double> attitude_rms{};        ///< radian, 0 to pi
    std::optional<std::uint32_t> time_seconds{}; ///< second
    std::optional<std::uint32_t> time_nano_seconds{};
    friend constexpr bool operator==(const set_global_pose_ext&, const set_global_pose_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x04A2;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_global_pose_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u16le,
                field<&T::latitude, scaled<u32le, degree_minus_90_to_90>>,
                field<&T::longitude, scaled<u32le, degree_minus_180_to_180>>,
                nested<&T::z_position>,
                field<&T::horizontal_rms, scaled<u32le, meter_0_to_100>>,
                field<&T::vertical_rms, scaled<u32le, meter_0_to_100>>,
                field<&T::roll, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::pitch, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::heading, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::attitude_rms, scaled<u16le, radian_0_to_pi>>,
                field<&T::time_seconds, in_units<u32le, second>>,
                field<&T::time_nano_seconds, u32le>>>;
    };
};

/// SetGeomagneticProperty: ID 0412h, command, input of GlobalPoseSensor.
struct set_geomagnetic_property {
    double magnetic_variation{}; ///< radian, -pi to pi
    friend constexpr bool operator==(const set_geomagnetic_property&, const set_geomagnetic_property&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0412;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_geomagnetic_property;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::magnetic_variation, scaled<u16le, radian_minus_pi_to_pi>>>;
    };
};

/// QueryGlobalPose: ID 2402h, deprecated, input of GlobalPoseSensor.
struct query_global_pose {
    std::uint16_t presence_vector{};
    friend constexpr bool operator==(const query_global_pose&, const query_global_pose&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2402;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = query_global_pose;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u16le>>;
    };
};

/// QueryGlobalPoseExt: ID 24A2h, input of GlobalPoseSensor.
struct query_global_pose_ext {
    std::uint16_t presence_vector{};
    friend constexpr bool operator==(const query_global_pose_ext&, const query_global_pose_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x24A2;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_global_pose_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u16le>>;
    };
};

/// QueryGeomagneticProperty: ID 2412h, input of GlobalPoseSensor.
struct query_geomagnetic_property {
    friend constexpr bool operator==(const query_geomagnetic_property&, const query_geomagnetic_property&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2412;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ReportGlobalPose: ID 4402h, deprecated, output of GlobalPoseSensor.
struct report_global_pose {
    std::optional<double> latitude{};     ///< degree, -90 to 90
    std::optional<double> longitude{};    ///< degree, -180 to 180
    std::optional<double> altitude{};     ///< meter, -10000 to 35000
    std::optional<double> position_rms{}; ///< meter, 0 to 100
    std::optional<double> roll{};         ///< radian, -pi to pi
    std::optional<double> pitch{};        ///< radian, -pi to pi
    std::optional<double> yaw{};          ///< radian, -pi to pi
    std::optional<double> attitude_rms{}; ///< radian, 0 to pi
    std::optional<mobility::time_stamp> time_stamp{};
    friend constexpr bool operator==(const report_global_pose&, const report_global_pose&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4402;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = report_global_pose;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u16le,
                field<&T::latitude, scaled<u32le, degree_minus_90_to_90>>,
                field<&T::longitude, scaled<u32le, degree_minus_180_to_180>>,
                field<&T::altitude, scaled<u32le, meter_minus_10000_to_35000>>,
                field<&T::position_rms, scaled<u32le, meter_0_to_100>>,
                field<&T::roll, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::pitch, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::yaw, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::attitude_rms, scaled<u16le, radian_0_to_pi>>,
                nested<&T::time_stamp>>>;
    };
};

/// ReportGlobalPoseExt: ID 44A2h, output of GlobalPoseSensor.
struct report_global_pose_ext {
    std::optional<double> latitude{};            ///< degree, -90 to 90
    std::optional<double> longitude{};           ///< degree, -180 to 180
    std::optional<double> altitude_agl{};        ///< meter, -50000 to 50000
    std::optional<double> altitude_msl{};        ///< meter, -50000 to 50000
    std::optional<double> altitude_asf{};        ///< meter, -50000 to 50000
    std::optional<double> depth{};               ///< meter, -50000 to 50000
    std::optional<double> xy_position_rms{};     ///< meter, 0 to 100
    std::optional<double> z_position_rms{};      ///< meter, 0 to 100
    std::optional<double> roll{};                ///< radian, -pi to pi
    std::optional<double> pitch{};               ///< radian, -pi to pi
    std::optional<double> heading{};             ///< radian, -pi to pi
    std::optional<double> attitude_rms{};        ///< radian, 0 to pi
    std::optional<double> course{};              ///< radian, -pi to pi
    std::optional<std::uint32_t> time_seconds{}; ///< second
    std::optional<std::uint32_t> time_nano_seconds{};
    friend constexpr bool operator==(const report_global_pose_ext&, const report_global_pose_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x44A2;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_global_pose_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u16le,
                field<&T::latitude, scaled<u32le, degree_minus_90_to_90>>,
                field<&T::longitude, scaled<u32le, degree_minus_180_to_180>>,
                field<&T::altitude_agl, scaled<u32le, meter_minus_50000_to_50000>>,
                field<&T::altitude_msl, scaled<u32le, meter_minus_50000_to_50000>>,
                field<&T::altitude_asf, scaled<u32le, meter_minus_50000_to_50000>>,
                field<&T::depth, scaled<u32le, meter_minus_50000_to_50000>>,
                field<&T::xy_position_rms, scaled<u32le, meter_0_to_100>>,
                field<&T::z_position_rms, scaled<u32le, meter_0_to_100>>,
                field<&T::roll, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::pitch, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::heading, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::attitude_rms, scaled<u16le, radian_0_to_pi>>,
                field<&T::course, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::time_seconds, in_units<u32le, second>>,
                field<&T::time_nano_seconds, u32le>>>;
    };
};

/// ReportGeomagneticProperty: ID 4412h, output of GlobalPoseSensor.
struct report_geomagnetic_property {
    double magnetic_variation{}; ///< radian, -pi to pi
    friend constexpr bool operator==(const report_geomagnetic_property&, const report_geomagnetic_property&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4412;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_geomagnetic_property;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::magnetic_variation, scaled<u16le, radian_minus_pi_to_pi>>>;
    };
};

namespace services {

/// GlobalPoseSensor: what it is called, and its messages.
struct global_pose_sensor {
    static constexpr std::string_view name = "GlobalPoseSensor";
    static constexpr std::string_view uri = "urn:jaus:jss:mobility:GlobalPoseSensor";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:AccessControl";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        set_global_pose,
        set_global_pose_ext,
        set_geomagnetic_property,
        query_global_pose,
        query_global_pose_ext,
        query_geomagnetic_property>;
    using outputs = jaus::message_list<report_global_pose, report_global_pose_ext, report_geomagnetic_property>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::mobility
