// Platform subgroup of RA 3.3 part 3: wrench effort, travel speed, global pose.
#pragma once
#include <jauscat/schema/jaus/time_stamp.hpp>
#include <jauscat/schema/jaus/types.hpp>
#include <jauscat/wire/schema.hpp>

namespace jauscat::jaus {

/// Set Wrench Effort: drives the platform's actuators open-loop, in percent of their capability.
/// Code 0405h, command class, 2 to 20 bytes.
struct set_wrench_effort {
    static constexpr std::uint16_t command_code = 0x0405;
    std::optional<double> propulsive_linear_effort_x{};     ///< percent, -100 to 100
    std::optional<double> propulsive_linear_effort_y{};     ///< percent, -100 to 100
    std::optional<double> propulsive_linear_effort_z{};     ///< percent, -100 to 100
    std::optional<double> propulsive_rotational_effort_x{}; ///< percent, -100 to 100
    std::optional<double> propulsive_rotational_effort_y{}; ///< percent, -100 to 100
    std::optional<double> propulsive_rotational_effort_z{}; ///< percent, -100 to 100
    std::optional<double> resistive_linear_effort_x{};      ///< percent, 0 to 100
    std::optional<double> resistive_linear_effort_y{};      ///< percent, 0 to 100
    std::optional<double> resistive_linear_effort_z{};      ///< percent, 0 to 100
    std::optional<double> resistive_rotational_effort_x{};  ///< percent, 0 to 100
    std::optional<double> resistive_rotational_effort_y{};  ///< percent, 0 to 100
    std::optional<double> resistive_rotational_effort_z{};  ///< percent, 0 to 100
    friend constexpr bool operator==(const set_wrench_effort&, const set_wrench_effort&) = default;
};

/// Set Travel Speed. Code 040Ah, command class, 2 bytes.
struct set_travel_speed {
    static constexpr std::uint16_t command_code = 0x040A;
    double desired_speed{}; ///< metres per second, 0 to 10000
    friend constexpr bool operator==(const set_travel_speed&, const set_travel_speed&) = default;
};

/// Query Global Pose. Code 2402h, query class, 2 bytes.
struct query_global_pose {
    static constexpr std::uint16_t command_code = 0x2402;
    std::uint16_t presence_vector{}; ///< the fields of Report Global Pose that are asked for
    friend constexpr bool operator==(const query_global_pose&, const query_global_pose&) = default;
};

/// Query Wrench Effort. Code 2405h, query class, 2 bytes.
struct query_wrench_effort {
    static constexpr std::uint16_t command_code = 0x2405;
    std::uint16_t presence_vector{}; ///< the fields of Report Wrench Effort that are asked for
    friend constexpr bool operator==(const query_wrench_effort&, const query_wrench_effort&) = default;
};

/// Query Travel Speed. Code 240Ah, query class, no body.
struct query_travel_speed {
    static constexpr std::uint16_t command_code = 0x240A;
    friend constexpr bool operator==(const query_travel_speed&, const query_travel_speed&) = default;
};

/// Report Global Pose. Code 4402h, inform class, 2 to 30 bytes. Peers are known to set presence bit 9 and to append two
/// bytes that RA 3.3 does not define; they are dropped.
struct report_global_pose {
    static constexpr std::uint16_t command_code = 0x4402;
    std::optional<double> latitude{};             ///< degrees (WGS 84), -90 to 90
    std::optional<double> longitude{};            ///< degrees (WGS 84), -180 to 180
    std::optional<double> elevation{};            ///< metres, -10000 to 35000
    std::optional<double> position_rms{};         ///< metres, 0 to 100
    std::optional<double> roll{};                 ///< radians, -pi to pi
    std::optional<double> pitch{};                ///< radians, -pi to pi
    std::optional<double> yaw{};                  ///< radians, -pi to pi
    std::optional<double> attitude_rms{};         ///< radians, 0 to pi
    std::optional<jaus::time_stamp> time_stamp{}; ///< time of the measurement
    friend constexpr bool operator==(const report_global_pose&, const report_global_pose&) = default;
};

/// Report Wrench Effort: the efforts in force.
/// Code 4405h, inform class, 2 to 20 bytes.
struct report_wrench_effort {
    static constexpr std::uint16_t command_code = 0x4405;
    std::optional<double> propulsive_linear_effort_x{};     ///< percent, -100 to 100
    std::optional<double> propulsive_linear_effort_y{};     ///< percent, -100 to 100
    std::optional<double> propulsive_linear_effort_z{};     ///< percent, -100 to 100
    std::optional<double> propulsive_rotational_effort_x{}; ///< percent, -100 to 100
    std::optional<double> propulsive_rotational_effort_y{}; ///< percent, -100 to 100
    std::optional<double> propulsive_rotational_effort_z{}; ///< percent, -100 to 100
    std::optional<double> resistive_linear_effort_x{};      ///< percent, 0 to 100
    std::optional<double> resistive_linear_effort_y{};      ///< percent, 0 to 100
    std::optional<double> resistive_linear_effort_z{};      ///< percent, 0 to 100
    std::optional<double> resistive_rotational_effort_x{};  ///< percent, 0 to 100
    std::optional<double> resistive_rotational_effort_y{};  ///< percent, 0 to 100
    std::optional<double> resistive_rotational_effort_z{};  ///< percent, 0 to 100
    friend constexpr bool operator==(const report_wrench_effort&, const report_wrench_effort&) = default;
};

/// Report Travel Speed. Code 440Ah, inform class, 2 bytes.
struct report_travel_speed {
    static constexpr std::uint16_t command_code = 0x440A;
    double desired_speed{}; ///< metres per second, 0 to 10000
    friend constexpr bool operator==(const report_travel_speed&, const report_travel_speed&) = default;
};

} // namespace jauscat::jaus

// One line per field, as in the standard's table.
// clang-format off
namespace jauscat {

template <> struct wire::schema<jaus::set_wrench_effort> {
    using T = jaus::set_wrench_effort;
    using type = layout<
        presence<u16le,
            field<&T::propulsive_linear_effort_x, scaled<i16le, jaus::signed_percent>>,
            field<&T::propulsive_linear_effort_y, scaled<i16le, jaus::signed_percent>>,
            field<&T::propulsive_linear_effort_z, scaled<i16le, jaus::signed_percent>>,
            field<&T::propulsive_rotational_effort_x, scaled<i16le, jaus::signed_percent>>,
            field<&T::propulsive_rotational_effort_y, scaled<i16le, jaus::signed_percent>>,
            field<&T::propulsive_rotational_effort_z, scaled<i16le, jaus::signed_percent>>,
            field<&T::resistive_linear_effort_x, scaled<u8, jaus::percent>>,
            field<&T::resistive_linear_effort_y, scaled<u8, jaus::percent>>,
            field<&T::resistive_linear_effort_z, scaled<u8, jaus::percent>>,
            field<&T::resistive_rotational_effort_x, scaled<u8, jaus::percent>>,
            field<&T::resistive_rotational_effort_y, scaled<u8, jaus::percent>>,
            field<&T::resistive_rotational_effort_z, scaled<u8, jaus::percent>>>>;
};

template <> struct wire::schema<jaus::set_travel_speed> {
    using T = jaus::set_travel_speed;
    using type = layout<field<&T::desired_speed, scaled<u16le, jaus::speed_limit>>>;
};

template <> struct wire::schema<jaus::query_global_pose> {
    using T = jaus::query_global_pose;
    using type = layout<field<&T::presence_vector, u16le>>;
};

template <> struct wire::schema<jaus::query_wrench_effort> {
    using T = jaus::query_wrench_effort;
    using type = layout<field<&T::presence_vector, u16le>>;
};

template <> struct wire::schema<jaus::query_travel_speed> { using type = layout<>; };

template <> struct wire::schema<jaus::report_global_pose> {
    using T = jaus::report_global_pose;
    using type = layout<
        open_presence<u16le,
            field<&T::latitude, scaled<i32le, jaus::latitude_range>>,
            field<&T::longitude, scaled<i32le, jaus::longitude_range>>,
            field<&T::elevation, scaled<i32le, jaus::elevation_range>>,
            field<&T::position_rms, scaled<u32le, jaus::position_error>>,
            field<&T::roll, scaled<i16le, jaus::signed_angle>>,
            field<&T::pitch, scaled<i16le, jaus::signed_angle>>,
            field<&T::yaw, scaled<i16le, jaus::signed_angle>>,
            field<&T::attitude_rms, scaled<u16le, jaus::positive_angle>>,
            nested<&T::time_stamp>>>;
};

template <> struct wire::schema<jaus::report_wrench_effort> {
    using T = jaus::report_wrench_effort;
    using type = layout<
        presence<u16le,
            field<&T::propulsive_linear_effort_x, scaled<i16le, jaus::signed_percent>>,
            field<&T::propulsive_linear_effort_y, scaled<i16le, jaus::signed_percent>>,
            field<&T::propulsive_linear_effort_z, scaled<i16le, jaus::signed_percent>>,
            field<&T::propulsive_rotational_effort_x, scaled<i16le, jaus::signed_percent>>,
            field<&T::propulsive_rotational_effort_y, scaled<i16le, jaus::signed_percent>>,
            field<&T::propulsive_rotational_effort_z, scaled<i16le, jaus::signed_percent>>,
            field<&T::resistive_linear_effort_x, scaled<u8, jaus::percent>>,
            field<&T::resistive_linear_effort_y, scaled<u8, jaus::percent>>,
            field<&T::resistive_linear_effort_z, scaled<u8, jaus::percent>>,
            field<&T::resistive_rotational_effort_x, scaled<u8, jaus::percent>>,
            field<&T::resistive_rotational_effort_y, scaled<u8, jaus::percent>>,
            field<&T::resistive_rotational_effort_z, scaled<u8, jaus::percent>>>>;
};

template <> struct wire::schema<jaus::report_travel_speed> {
    using T = jaus::report_travel_speed;
    using type = layout<field<&T::desired_speed, scaled<u16le, jaus::speed_limit>>>;
};

} // namespace jauscat
