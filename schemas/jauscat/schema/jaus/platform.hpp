// Platform subgroup of RA 3.3 part 3: wrench effort, velocity, discrete devices, vectors, poses, waypoints, path
// segments.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/jaus/time_stamp.hpp>
#include <jauscat/schema/jaus/types.hpp>
#include <jauscat/wire/schema.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::jaus {

/// Set Velocity State: moves the platform at the given velocities.
/// Code 0404h, command class, 2 to 30 bytes. Not in RA 3.3 but an experimental message of known peers.
struct set_velocity_state {
    std::optional<double> velocity_x{};           ///< metres per second, -65.534 to 65.534
    std::optional<double> velocity_y{};           ///< metres per second, -65.534 to 65.534
    std::optional<double> velocity_z{};           ///< metres per second, -65.534 to 65.534
    std::optional<double> velocity_rms{};         ///< metres per second, 0 to 100
    std::optional<double> roll_rate{};            ///< radians per second, -32.767 to 32.767
    std::optional<double> pitch_rate{};           ///< radians per second, -32.767 to 32.767
    std::optional<double> yaw_rate{};             ///< radians per second, -32.767 to 32.767
    std::optional<double> rate_rms{};             ///< radians per second, 0 to pi
    std::optional<jaus::time_stamp> time_stamp{}; ///< time of the command
    friend constexpr bool operator==(const set_velocity_state&, const set_velocity_state&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0404;
        using T = set_velocity_state;
        using type = layout<
            lenient_presence<u16le,
                field<&T::velocity_x, scaled<i32le, velocity_range>>,
                field<&T::velocity_y, scaled<i32le, velocity_range>>,
                field<&T::velocity_z, scaled<i32le, velocity_range>>,
                field<&T::velocity_rms, scaled<u32le, velocity_error>>,
                field<&T::roll_rate, scaled<i16le, angular_rate>>,
                field<&T::pitch_rate, scaled<i16le, angular_rate>>,
                field<&T::yaw_rate, scaled<i16le, angular_rate>>,
                field<&T::rate_rms, scaled<u16le, angular_rate_error>>,
                nested<&T::time_stamp>>>;
    };
};

/// Set Wrench Effort: drives the platform's actuators open-loop, in percent of their capability.
/// Code 0405h, command class, 2 to 20 bytes.
struct set_wrench_effort {
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

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0405;
        using T = set_wrench_effort;
        using type = layout<
            lenient_presence<u16le,
                field<&T::propulsive_linear_effort_x, scaled<i16le, signed_percent>>,
                field<&T::propulsive_linear_effort_y, scaled<i16le, signed_percent>>,
                field<&T::propulsive_linear_effort_z, scaled<i16le, signed_percent>>,
                field<&T::propulsive_rotational_effort_x, scaled<i16le, signed_percent>>,
                field<&T::propulsive_rotational_effort_y, scaled<i16le, signed_percent>>,
                field<&T::propulsive_rotational_effort_z, scaled<i16le, signed_percent>>,
                field<&T::resistive_linear_effort_x, scaled<u8, percent>>,
                field<&T::resistive_linear_effort_y, scaled<u8, percent>>,
                field<&T::resistive_linear_effort_z, scaled<u8, percent>>,
                field<&T::resistive_rotational_effort_x, scaled<u8, percent>>,
                field<&T::resistive_rotational_effort_y, scaled<u8, percent>>,
                field<&T::resistive_rotational_effort_z, scaled<u8, percent>>>>;
    };
};

/// What Main Propulsion switches on. Bit numbers.
enum class main_propulsion_device : std::uint8_t {
    main_propulsion = 0,
    main_fuel_supply = 1,
    auxiliary_fuel_supply = 2,
    power_to_auxiliary_devices = 3,
    starting_device = 4,
    cold_start = 5,
    automatic_start_sequence = 6,
    automatic_shutdown_sequence = 7,
};

/// What Parking, Brake and Horn switches on. Bit numbers; bits 2 to 7 are not assigned.
enum class parking_brake_and_horn : std::uint8_t {
    parking_brake = 0,
    horn = 1,
};

/// Gear: 1 to 127 are the forward gears from low to high, 129 to 255 the reverse gears from low to high.
enum class gear : std::uint8_t {
    park = 0,
    neutral = 128,
};

/// Transfer Case: 0 to 127 are low, 129 to 255 high.
enum class transfer_case : std::uint8_t {
    neutral = 128,
};

/// Set Discrete Devices: switches engine, brake, horn, gear and transfer case.
/// Code 0406h, command class, 1 to 5 bytes.
struct set_discrete_devices {
    std::optional<wire::bit_set<main_propulsion_device>> main_propulsion{};              ///< what to switch on
    std::optional<wire::bit_set<jaus::parking_brake_and_horn>> parking_brake_and_horn{}; ///< what to switch on
    std::optional<jaus::gear> gear{};                                                    ///< gear to engage
    std::optional<jaus::transfer_case> transfer_case{};                                  ///< transfer case to engage
    friend constexpr bool operator==(const set_discrete_devices&, const set_discrete_devices&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0406;
        using T = set_discrete_devices;
        using type = layout<
            lenient_presence<u8,
                field<&T::main_propulsion, bit_set_codec<main_propulsion_device, u8>>,
                field<&T::parking_brake_and_horn, bit_set_codec<jaus::parking_brake_and_horn, u8>>,
                field<&T::gear, enumeration<jaus::gear, u8>>,
                field<&T::transfer_case, enumeration<jaus::transfer_case, u8>>>>;
    };
};

/// Set Global Vector: sets speed, elevation, heading and attitude to hold.
/// Code 0407h, command class, 1 to 13 bytes.
struct set_global_vector {
    std::optional<double> desired_speed{};     ///< metres per second, 0 to 10000
    std::optional<double> desired_elevation{}; ///< metres, -10000 to 35000
    std::optional<double> desired_heading{};   ///< radians, -pi to pi
    std::optional<double> desired_roll{};      ///< radians, -pi to pi
    std::optional<double> desired_pitch{};     ///< radians, -pi to pi
    friend constexpr bool operator==(const set_global_vector&, const set_global_vector&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0407;
        using T = set_global_vector;
        using type = layout<
            lenient_presence<u8,
                field<&T::desired_speed, scaled<u16le, speed_limit>>,
                field<&T::desired_elevation, scaled<i32le, elevation_range>>,
                field<&T::desired_heading, scaled<i16le, signed_angle>>,
                field<&T::desired_roll, scaled<i16le, signed_angle>>,
                field<&T::desired_pitch, scaled<i16le, signed_angle>>>>;
    };
};

/// Set Local Vector: sets speed and heading to hold.
/// Code 0408h, command class, 6 bytes. The speed is a signed 32-bit scaled integer here, although it is never negative.
struct set_local_vector {
    double desired_speed{};   ///< metres per second, 0 to 10000
    double desired_heading{}; ///< radians, -pi to pi
    friend constexpr bool operator==(const set_local_vector&, const set_local_vector&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0408;
        using T = set_local_vector;
        using type = layout<
            field<&T::desired_speed, scaled<i32le, speed_limit>>,
            field<&T::desired_heading, scaled<i16le, signed_angle>>>;
    };
};

/// Set Travel Speed: sets the speed to travel at.
/// Code 040Ah, command class, 2 bytes.
struct set_travel_speed {
    double desired_speed{}; ///< metres per second, 0 to 10000
    friend constexpr bool operator==(const set_travel_speed&, const set_travel_speed&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x040A;
        using T = set_travel_speed;
        using type = layout<field<&T::desired_speed, scaled<u16le, speed_limit>>>;
    };
};

/// Set Global Waypoint: gives a waypoint by latitude and longitude.
/// Code 040Ch, command class, 11 to 21 bytes.
struct set_global_waypoint {
    std::uint16_t waypoint_number{};       ///< which waypoint
    double latitude{};                     ///< degrees, -90 to 90
    double longitude{};                    ///< degrees, -180 to 180
    std::optional<double> altitude{};      ///< metres, -10000 to 35000
    std::optional<double> desired_roll{};  ///< radians, -pi to pi
    std::optional<double> desired_pitch{}; ///< radians, -pi to pi
    std::optional<double> desired_yaw{};   ///< radians, -pi to pi
    friend constexpr bool operator==(const set_global_waypoint&, const set_global_waypoint&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x040C;
        using T = set_global_waypoint;
        using type = layout<
            lenient_presence<u8,
                field<&T::waypoint_number, u16le>,
                field<&T::latitude, scaled<i32le, latitude_range>>,
                field<&T::longitude, scaled<i32le, longitude_range>>,
                field<&T::altitude, scaled<i32le, elevation_range>>,
                field<&T::desired_roll, scaled<i16le, signed_angle>>,
                field<&T::desired_pitch, scaled<i16le, signed_angle>>,
                field<&T::desired_yaw, scaled<i16le, signed_angle>>>>;
    };
};

/// Set Local Waypoint: gives a waypoint in local coordinates.
/// Code 040Dh, command class, 11 to 21 bytes.
struct set_local_waypoint {
    std::uint16_t waypoint_number{};       ///< which waypoint
    double waypoint_x{};                   ///< metres, -100000 to 100000
    double waypoint_y{};                   ///< metres, -100000 to 100000
    std::optional<double> waypoint_z{};    ///< metres, -10000 to 35000
    std::optional<double> desired_roll{};  ///< radians, -pi to pi
    std::optional<double> desired_pitch{}; ///< radians, -pi to pi
    std::optional<double> desired_yaw{};   ///< radians, -pi to pi
    friend constexpr bool operator==(const set_local_waypoint&, const set_local_waypoint&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x040D;
        using T = set_local_waypoint;
        using type = layout<
            lenient_presence<u8,
                field<&T::waypoint_number, u16le>,
                field<&T::waypoint_x, scaled<i32le, local_coordinate>>,
                field<&T::waypoint_y, scaled<i32le, local_coordinate>>,
                field<&T::waypoint_z, scaled<i32le, elevation_range>>,
                field<&T::desired_roll, scaled<i16le, signed_angle>>,
                field<&T::desired_pitch, scaled<i16le, signed_angle>>,
                field<&T::desired_yaw, scaled<i16le, signed_angle>>>>;
    };
};

/// Set Global Path Segment: gives a path segment by latitude and longitude.
/// Code 040Fh, command class, 21 to 29 bytes. Both points P1 and P2 are always there; their altitudes need not be.
struct set_global_path_segment {
    std::uint16_t path_segment_number{}; ///< which path segment
    double p1_latitude{};                ///< degrees, -90 to 90
    double p1_longitude{};               ///< degrees, -180 to 180
    std::optional<double> p1_altitude{}; ///< metres, -10000 to 35000
    double p2_latitude{};                ///< degrees, -90 to 90
    double p2_longitude{};               ///< degrees, -180 to 180
    std::optional<double> p2_altitude{}; ///< metres, -10000 to 35000
    double weighting_factor{};           ///< 0 to 500
    friend constexpr bool operator==(const set_global_path_segment&, const set_global_path_segment&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x040F;
        using T = set_global_path_segment;
        using type = layout<
            lenient_presence<u8,
                field<&T::path_segment_number, u16le>,
                field<&T::p1_latitude, scaled<i32le, latitude_range>>,
                field<&T::p1_longitude, scaled<i32le, longitude_range>>,
                field<&T::p1_altitude, scaled<i32le, elevation_range>>,
                field<&T::p2_latitude, scaled<i32le, latitude_range>>,
                field<&T::p2_longitude, scaled<i32le, longitude_range>>,
                field<&T::p2_altitude, scaled<i32le, elevation_range>>,
                field<&T::weighting_factor, scaled<u16le, path_weight>>>>;
    };
};

/// Set Local Path Segment: gives a path segment in local coordinates.
/// Code 0410h, command class, 21 to 29 bytes. Both points P1 and P2 are always there; their heights need not be.
struct set_local_path_segment {
    std::uint16_t path_segment_number{}; ///< which path segment
    double p1_x{};                       ///< metres, -100000 to 100000
    double p1_y{};                       ///< metres, -100000 to 100000
    std::optional<double> p1_z{};        ///< metres, -10000 to 35000
    double p2_x{};                       ///< metres, -100000 to 100000
    double p2_y{};                       ///< metres, -100000 to 100000
    std::optional<double> p2_z{};        ///< metres, -10000 to 35000
    double weighting_factor{};           ///< 0 to 500
    friend constexpr bool operator==(const set_local_path_segment&, const set_local_path_segment&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0410;
        using T = set_local_path_segment;
        using type = layout<
            lenient_presence<u8,
                field<&T::path_segment_number, u16le>,
                field<&T::p1_x, scaled<i32le, local_coordinate>>,
                field<&T::p1_y, scaled<i32le, local_coordinate>>,
                field<&T::p1_z, scaled<i32le, elevation_range>>,
                field<&T::p2_x, scaled<i32le, local_coordinate>>,
                field<&T::p2_y, scaled<i32le, local_coordinate>>,
                field<&T::p2_z, scaled<i32le, elevation_range>>,
                field<&T::weighting_factor, scaled<u16le, path_weight>>>>;
    };
};

/// Query Platform Specifications: asks for size, balance and limits of the platform.
/// Code 2400h, query class, 4 bytes.
struct query_platform_specifications {
    std::uint32_t presence_vector{}; ///< the requested fields of Report Platform Specifications
    friend constexpr bool operator==(const query_platform_specifications&,
                                     const query_platform_specifications&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2400;
        using report = struct report_platform_specifications;
        using T = query_platform_specifications;
        using type = layout<field<&T::presence_vector, u32le>>;
    };
};

/// Query Platform Operational Data: asks for the gauges of the platform.
/// Code 2401h, query class, 1 byte.
struct query_platform_operational_data {
    std::uint8_t presence_vector{}; ///< the requested fields of Report Platform Operational Data
    friend constexpr bool operator==(const query_platform_operational_data&,
                                     const query_platform_operational_data&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2401;
        using report = struct report_platform_operational_data;
        using T = query_platform_operational_data;
        using type = layout<field<&T::presence_vector, u8>>;
    };
};

/// Query Global Pose: asks for position by latitude and longitude, and attitude.
/// Code 2402h, query class, 2 bytes.
struct query_global_pose {
    std::uint16_t presence_vector{}; ///< the requested fields of Report Global Pose
    friend constexpr bool operator==(const query_global_pose&, const query_global_pose&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2402;
        using report = struct report_global_pose;
        using T = query_global_pose;
        using type = layout<field<&T::presence_vector, u16le>>;
    };
};

/// Query Local Pose: asks for position and attitude in local coordinates.
/// Code 2403h, query class, 2 bytes.
struct query_local_pose {
    std::uint16_t presence_vector{}; ///< the requested fields of Report Local Pose
    friend constexpr bool operator==(const query_local_pose&, const query_local_pose&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2403;
        using report = struct report_local_pose;
        using T = query_local_pose;
        using type = layout<field<&T::presence_vector, u16le>>;
    };
};

/// Query Velocity State: asks for the velocities of the platform.
/// Code 2404h, query class, 2 bytes.
struct query_velocity_state {
    std::uint16_t presence_vector{}; ///< the requested fields of Report Velocity State
    friend constexpr bool operator==(const query_velocity_state&, const query_velocity_state&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2404;
        using report = struct report_velocity_state;
        using T = query_velocity_state;
        using type = layout<field<&T::presence_vector, u16le>>;
    };
};

/// Query Wrench Effort: asks for the efforts in force.
/// Code 2405h, query class, 2 bytes.
struct query_wrench_effort {
    std::uint16_t presence_vector{}; ///< the requested fields of Report Wrench Effort
    friend constexpr bool operator==(const query_wrench_effort&, const query_wrench_effort&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2405;
        using report = struct report_wrench_effort;
        using T = query_wrench_effort;
        using type = layout<field<&T::presence_vector, u16le>>;
    };
};

/// Query Discrete Devices: asks for the state of engine, brake, horn, gear and transfer case.
/// Code 2406h, query class, 1 byte.
struct query_discrete_devices {
    std::uint8_t presence_vector{}; ///< the requested fields of Report Discrete Devices
    friend constexpr bool operator==(const query_discrete_devices&, const query_discrete_devices&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2406;
        using report = struct report_discrete_devices;
        using T = query_discrete_devices;
        using type = layout<field<&T::presence_vector, u8>>;
    };
};

/// Query Global Vector: asks for the global vector in force.
/// Code 2407h, query class, 1 byte.
struct query_global_vector {
    std::uint8_t presence_vector{}; ///< the requested fields of Report Global Vector
    friend constexpr bool operator==(const query_global_vector&, const query_global_vector&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2407;
        using report = struct report_global_vector;
        using T = query_global_vector;
        using type = layout<field<&T::presence_vector, u8>>;
    };
};

/// Query Local Vector: asks for the local vector in force.
/// Code 2408h, query class, no body.
struct query_local_vector {
    friend constexpr bool operator==(const query_local_vector&, const query_local_vector&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2408;
        using report = struct report_local_vector;
        using type = layout<>;
    };
};

/// Query Travel Speed: asks for the speed to travel at.
/// Code 240Ah, query class, no body.
struct query_travel_speed {
    friend constexpr bool operator==(const query_travel_speed&, const query_travel_speed&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x240A;
        using report = struct report_travel_speed;
        using type = layout<>;
    };
};

/// Query Waypoint Count: requests the number of waypoints.
/// Code 240Bh, query class, no body.
struct query_waypoint_count {
    friend constexpr bool operator==(const query_waypoint_count&, const query_waypoint_count&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x240B;
        using report = struct report_waypoint_count;
        using type = layout<>;
    };
};

/// Query Global Waypoint: asks for a waypoint by latitude and longitude.
/// Code 240Ch, query class, 2 bytes.
struct query_global_waypoint {
    std::uint16_t waypoint_number{}; ///< which waypoint
    friend constexpr bool operator==(const query_global_waypoint&, const query_global_waypoint&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x240C;
        using report = struct report_global_waypoint;
        using T = query_global_waypoint;
        using type = layout<field<&T::waypoint_number, u16le>>;
    };
};

/// Query Local Waypoint: asks for a waypoint in local coordinates.
/// Code 240Dh, query class, 2 bytes.
struct query_local_waypoint {
    std::uint16_t waypoint_number{}; ///< which waypoint
    friend constexpr bool operator==(const query_local_waypoint&, const query_local_waypoint&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x240D;
        using report = struct report_local_waypoint;
        using T = query_local_waypoint;
        using type = layout<field<&T::waypoint_number, u16le>>;
    };
};

/// Query Path Segment Count: requests the number of path segments.
/// Code 240Eh, query class, no body.
struct query_path_segment_count {
    friend constexpr bool operator==(const query_path_segment_count&, const query_path_segment_count&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x240E;
        using report = struct report_path_segment_count;
        using type = layout<>;
    };
};

/// Query Global Path Segment: asks for a path segment by latitude and longitude.
/// Code 240Fh, query class, 3 bytes. The number comes first here, unlike in the report.
struct query_global_path_segment {
    std::uint16_t path_segment_number{}; ///< which path segment
    std::uint8_t presence_vector{};      ///< the requested fields of Report Global Path Segment
    friend constexpr bool operator==(const query_global_path_segment&, const query_global_path_segment&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x240F;
        using report = struct report_global_path_segment;
        using T = query_global_path_segment;
        using type = layout<
            field<&T::path_segment_number, u16le>,
            field<&T::presence_vector, u8>>;
    };
};

/// Query Local Path Segment: asks for a path segment in local coordinates.
/// Code 2410h, query class, 3 bytes. The number comes first here, unlike in the report.
struct query_local_path_segment {
    std::uint16_t path_segment_number{}; ///< which path segment
    std::uint8_t presence_vector{};      ///< the requested fields of Report Local Path Segment
    friend constexpr bool operator==(const query_local_path_segment&, const query_local_path_segment&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2410;
        using report = struct report_local_path_segment;
        using T = query_local_path_segment;
        using type = layout<
            field<&T::path_segment_number, u16le>,
            field<&T::presence_vector, u8>>;
    };
};

/// Report Platform Specifications: size, balance and limits of the platform.
/// Code 4400h, inform class, 4 to 59 bytes.
struct report_platform_specifications {
    std::optional<std::string_view> platform_name{}; ///< up to 15 characters
    std::optional<double> front{};                   ///< metres, 0 to 32.767
    std::optional<double> back{};                    ///< metres, 0 to 32.767
    std::optional<double> right{};                   ///< metres, 0 to 32.767
    std::optional<double> left{};                    ///< metres, 0 to 32.767
    std::optional<double> bottom{};                  ///< metres, 0 to 32.767
    std::optional<double> top{};                     ///< metres, 0 to 32.767
    std::optional<double> x_cg{};                    ///< metres, 0 to 32.767
    std::optional<double> y_cg{};                    ///< metres, 0 to 32.767
    std::optional<double> z_cg{};                    ///< metres, 0 to 32.767
    std::optional<double> turning_radius{};          ///< metres, 0 to 65.535
    std::optional<double> wheel_base{};              ///< metres, 0 to 65.535
    std::optional<double> track_width{};             ///< metres, 0 to 65.535
    std::optional<double> static_pitch_over{};       ///< radians, 0 to 2.56
    std::optional<double> static_roll_over{};        ///< radians, 0 to 2.56
    std::optional<double> maximum_velocity_x{};      ///< metres per second, 0 to 65.535
    std::optional<double> maximum_velocity_y{};      ///< metres per second, 0 to 65.535
    std::optional<double> maximum_velocity_z{};      ///< metres per second, 0 to 65.535
    std::optional<double> maximum_roll_rate{};       ///< radians per second, 0 to 32.767
    std::optional<double> maximum_pitch_rate{};      ///< radians per second, 0 to 32.767
    std::optional<double> maximum_yaw_rate{};        ///< radians per second, 0 to 32.767
    friend constexpr bool operator==(const report_platform_specifications&,
                                     const report_platform_specifications&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4400;
        using query = query_platform_specifications;
        using T = report_platform_specifications;
        using type = layout<
            lenient_presence<u32le,
                string<&T::platform_name, fixed<15>>,
                field<&T::front, scaled<u16le, platform_dimension>>,
                field<&T::back, scaled<u16le, platform_dimension>>,
                field<&T::right, scaled<u16le, platform_dimension>>,
                field<&T::left, scaled<u16le, platform_dimension>>,
                field<&T::bottom, scaled<u16le, platform_dimension>>,
                field<&T::top, scaled<u16le, platform_dimension>>,
                field<&T::x_cg, scaled<u16le, platform_dimension>>,
                field<&T::y_cg, scaled<u16le, platform_dimension>>,
                field<&T::z_cg, scaled<u16le, platform_dimension>>,
                field<&T::turning_radius, scaled<u16le, chassis_dimension>>,
                field<&T::wheel_base, scaled<u16le, chassis_dimension>>,
                field<&T::track_width, scaled<u16le, chassis_dimension>>,
                field<&T::static_pitch_over, scaled<u16le, static_roll_over_angle>>,
                field<&T::static_roll_over, scaled<u16le, static_roll_over_angle>>,
                field<&T::maximum_velocity_x, scaled<u16le, maximum_velocity>>,
                field<&T::maximum_velocity_y, scaled<u16le, maximum_velocity>>,
                field<&T::maximum_velocity_z, scaled<u16le, maximum_velocity>>,
                field<&T::maximum_roll_rate, scaled<u16le, maximum_angular_rate>>,
                field<&T::maximum_pitch_rate, scaled<u16le, maximum_angular_rate>>,
                field<&T::maximum_yaw_rate, scaled<u16le, maximum_angular_rate>>>>;
    };
};

/// Report Platform Operational Data: the gauges of the platform.
/// Code 4401h, inform class, 1 to 10 bytes.
struct report_platform_operational_data {
    std::optional<double> engine_temperature{}; ///< degrees Celsius, -75 to 180
    std::optional<std::uint32_t> odometer{};    ///< metres
    std::optional<double> battery_voltage{};    ///< percent, 0 to 127
    std::optional<double> fuel_level{};         ///< percent, 0 to 100
    std::optional<double> oil_pressure{};       ///< percent, 0 to 127
    friend constexpr bool operator==(const report_platform_operational_data&,
                                     const report_platform_operational_data&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4401;
        using query = query_platform_operational_data;
        using T = report_platform_operational_data;
        using type = layout<
            lenient_presence<u8,
                field<&T::engine_temperature, scaled<i16le, engine_temperature_range>>,
                field<&T::odometer, in_units<u32le, metres>>,
                field<&T::battery_voltage, scaled<u8, gauge_percent>>,
                field<&T::fuel_level, scaled<u8, percent>>,
                field<&T::oil_pressure, scaled<u8, gauge_percent>>>>;
    };
};

/// Report Global Pose: position by latitude and longitude, and attitude.
/// Code 4402h, inform class, 2 to 30 bytes. Peers are known to set presence bit 9 and to append two bytes that RA 3.3
/// does not define; they are dropped.
struct report_global_pose {
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

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4402;
        using query = query_global_pose;
        using T = report_global_pose;
        using type = layout<
            open_presence<u16le,
                field<&T::latitude, scaled<i32le, latitude_range>>,
                field<&T::longitude, scaled<i32le, longitude_range>>,
                field<&T::elevation, scaled<i32le, elevation_range>>,
                field<&T::position_rms, scaled<u32le, position_error>>,
                field<&T::roll, scaled<i16le, signed_angle>>,
                field<&T::pitch, scaled<i16le, signed_angle>>,
                field<&T::yaw, scaled<i16le, signed_angle>>,
                field<&T::attitude_rms, scaled<u16le, positive_angle>>,
                nested<&T::time_stamp>>>;
    };
};

/// Report Local Pose: position and attitude in local coordinates.
/// Code 4403h, inform class, 2 to 30 bytes.
struct report_local_pose {
    std::optional<double> x{};                    ///< metres, -100000 to 100000
    std::optional<double> y{};                    ///< metres, -100000 to 100000
    std::optional<double> z{};                    ///< metres, -10000 to 35000
    std::optional<double> position_rms{};         ///< metres, 0 to 100
    std::optional<double> roll{};                 ///< radians, -pi to pi
    std::optional<double> pitch{};                ///< radians, -pi to pi
    std::optional<double> yaw{};                  ///< radians, -pi to pi
    std::optional<double> attitude_rms{};         ///< radians, 0 to pi
    std::optional<jaus::time_stamp> time_stamp{}; ///< time of the measurement
    friend constexpr bool operator==(const report_local_pose&, const report_local_pose&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4403;
        using query = query_local_pose;
        using T = report_local_pose;
        using type = layout<
            lenient_presence<u16le,
                field<&T::x, scaled<i32le, local_coordinate>>,
                field<&T::y, scaled<i32le, local_coordinate>>,
                field<&T::z, scaled<i32le, elevation_range>>,
                field<&T::position_rms, scaled<u32le, position_error>>,
                field<&T::roll, scaled<i16le, signed_angle>>,
                field<&T::pitch, scaled<i16le, signed_angle>>,
                field<&T::yaw, scaled<i16le, signed_angle>>,
                field<&T::attitude_rms, scaled<u16le, positive_angle>>,
                nested<&T::time_stamp>>>;
    };
};

/// Report Velocity State: the velocities of the platform.
/// Code 4404h, inform class, 2 to 30 bytes. Peers are known to set presence bit 9 and to append two bytes that RA 3.3
/// does not define; they are dropped. Others send Velocity RMS in two bytes; RA 3.3 has four.
struct report_velocity_state {
    std::optional<double> velocity_x{};           ///< metres per second, -65.534 to 65.534
    std::optional<double> velocity_y{};           ///< metres per second, -65.534 to 65.534
    std::optional<double> velocity_z{};           ///< metres per second, -65.534 to 65.534
    std::optional<double> velocity_rms{};         ///< metres per second, 0 to 100
    std::optional<double> roll_rate{};            ///< radians per second, -32.767 to 32.767
    std::optional<double> pitch_rate{};           ///< radians per second, -32.767 to 32.767
    std::optional<double> yaw_rate{};             ///< radians per second, -32.767 to 32.767
    std::optional<double> rate_rms{};             ///< radians per second, 0 to pi
    std::optional<jaus::time_stamp> time_stamp{}; ///< time of the measurement
    friend constexpr bool operator==(const report_velocity_state&, const report_velocity_state&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4404;
        using query = query_velocity_state;
        using T = report_velocity_state;
        using type = layout<
            open_presence<u16le,
                field<&T::velocity_x, scaled<i32le, velocity_range>>,
                field<&T::velocity_y, scaled<i32le, velocity_range>>,
                field<&T::velocity_z, scaled<i32le, velocity_range>>,
                field<&T::velocity_rms, scaled<u32le, velocity_error>>,
                field<&T::roll_rate, scaled<i16le, angular_rate>>,
                field<&T::pitch_rate, scaled<i16le, angular_rate>>,
                field<&T::yaw_rate, scaled<i16le, angular_rate>>,
                field<&T::rate_rms, scaled<u16le, angular_rate_error>>,
                nested<&T::time_stamp>>>;
    };
};

/// Report Wrench Effort: the efforts in force.
/// Code 4405h, inform class, 2 to 20 bytes.
struct report_wrench_effort {
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

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4405;
        using query = query_wrench_effort;
        using T = report_wrench_effort;
        using type = layout<
            lenient_presence<u16le,
                field<&T::propulsive_linear_effort_x, scaled<i16le, signed_percent>>,
                field<&T::propulsive_linear_effort_y, scaled<i16le, signed_percent>>,
                field<&T::propulsive_linear_effort_z, scaled<i16le, signed_percent>>,
                field<&T::propulsive_rotational_effort_x, scaled<i16le, signed_percent>>,
                field<&T::propulsive_rotational_effort_y, scaled<i16le, signed_percent>>,
                field<&T::propulsive_rotational_effort_z, scaled<i16le, signed_percent>>,
                field<&T::resistive_linear_effort_x, scaled<u8, percent>>,
                field<&T::resistive_linear_effort_y, scaled<u8, percent>>,
                field<&T::resistive_linear_effort_z, scaled<u8, percent>>,
                field<&T::resistive_rotational_effort_x, scaled<u8, percent>>,
                field<&T::resistive_rotational_effort_y, scaled<u8, percent>>,
                field<&T::resistive_rotational_effort_z, scaled<u8, percent>>>>;
    };
};

/// Report Discrete Devices: the state of engine, brake, horn, gear and transfer case.
/// Code 4406h, inform class, 1 to 5 bytes.
struct report_discrete_devices {
    std::optional<wire::bit_set<main_propulsion_device>> main_propulsion{};              ///< what is on
    std::optional<wire::bit_set<jaus::parking_brake_and_horn>> parking_brake_and_horn{}; ///< what is on
    std::optional<jaus::gear> gear{};                                                    ///< gear engaged
    std::optional<jaus::transfer_case> transfer_case{};                                  ///< transfer case engaged
    friend constexpr bool operator==(const report_discrete_devices&, const report_discrete_devices&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4406;
        using query = query_discrete_devices;
        using T = report_discrete_devices;
        using type = layout<
            lenient_presence<u8,
                field<&T::main_propulsion, bit_set_codec<main_propulsion_device, u8>>,
                field<&T::parking_brake_and_horn, bit_set_codec<jaus::parking_brake_and_horn, u8>>,
                field<&T::gear, enumeration<jaus::gear, u8>>,
                field<&T::transfer_case, enumeration<jaus::transfer_case, u8>>>>;
    };
};

/// Report Global Vector: the global vector in force.
/// Code 4407h, inform class, 1 to 13 bytes.
struct report_global_vector {
    std::optional<double> desired_speed{};     ///< metres per second, 0 to 10000
    std::optional<double> desired_elevation{}; ///< metres, -10000 to 35000
    std::optional<double> desired_heading{};   ///< radians, -pi to pi
    std::optional<double> desired_roll{};      ///< radians, -pi to pi
    std::optional<double> desired_pitch{};     ///< radians, -pi to pi
    friend constexpr bool operator==(const report_global_vector&, const report_global_vector&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4407;
        using query = query_global_vector;
        using T = report_global_vector;
        using type = layout<
            lenient_presence<u8,
                field<&T::desired_speed, scaled<u16le, speed_limit>>,
                field<&T::desired_elevation, scaled<i32le, elevation_range>>,
                field<&T::desired_heading, scaled<i16le, signed_angle>>,
                field<&T::desired_roll, scaled<i16le, signed_angle>>,
                field<&T::desired_pitch, scaled<i16le, signed_angle>>>>;
    };
};

/// Report Local Vector: the local vector in force.
/// Code 4408h, inform class, 6 bytes. The speed is a signed 32-bit scaled integer here, although it is never negative.
struct report_local_vector {
    double desired_speed{};   ///< metres per second, 0 to 10000
    double desired_heading{}; ///< radians, -pi to pi
    friend constexpr bool operator==(const report_local_vector&, const report_local_vector&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4408;
        using query = query_local_vector;
        using T = report_local_vector;
        using type = layout<
            field<&T::desired_speed, scaled<i32le, speed_limit>>,
            field<&T::desired_heading, scaled<i16le, signed_angle>>>;
    };
};

/// Report Travel Speed: the speed to travel at.
/// Code 440Ah, inform class, 2 bytes.
struct report_travel_speed {
    double desired_speed{}; ///< metres per second, 0 to 10000
    friend constexpr bool operator==(const report_travel_speed&, const report_travel_speed&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x440A;
        using query = query_travel_speed;
        using T = report_travel_speed;
        using type = layout<field<&T::desired_speed, scaled<u16le, speed_limit>>>;
    };
};

/// Report Waypoint Count: how many waypoints there are.
/// Code 440Bh, inform class, 2 bytes.
struct report_waypoint_count {
    std::uint16_t waypoint_count{}; ///< waypoints
    friend constexpr bool operator==(const report_waypoint_count&, const report_waypoint_count&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x440B;
        using query = query_waypoint_count;
        using T = report_waypoint_count;
        using type = layout<field<&T::waypoint_count, u16le>>;
    };
};

/// Report Global Waypoint: a waypoint by latitude and longitude.
/// Code 440Ch, inform class, 11 to 21 bytes.
struct report_global_waypoint {
    std::uint16_t waypoint_number{};       ///< which waypoint
    double latitude{};                     ///< degrees, -90 to 90
    double longitude{};                    ///< degrees, -180 to 180
    std::optional<double> altitude{};      ///< metres, -10000 to 35000
    std::optional<double> desired_roll{};  ///< radians, -pi to pi
    std::optional<double> desired_pitch{}; ///< radians, -pi to pi
    std::optional<double> desired_yaw{};   ///< radians, -pi to pi
    friend constexpr bool operator==(const report_global_waypoint&, const report_global_waypoint&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x440C;
        using query = query_global_waypoint;
        using T = report_global_waypoint;
        using type = layout<
            lenient_presence<u8,
                field<&T::waypoint_number, u16le>,
                field<&T::latitude, scaled<i32le, latitude_range>>,
                field<&T::longitude, scaled<i32le, longitude_range>>,
                field<&T::altitude, scaled<i32le, elevation_range>>,
                field<&T::desired_roll, scaled<i16le, signed_angle>>,
                field<&T::desired_pitch, scaled<i16le, signed_angle>>,
                field<&T::desired_yaw, scaled<i16le, signed_angle>>>>;
    };
};

/// Report Local Waypoint: a waypoint in local coordinates.
/// Code 440Dh, inform class, 11 to 21 bytes.
struct report_local_waypoint {
    std::uint16_t waypoint_number{};       ///< which waypoint
    double waypoint_x{};                   ///< metres, -100000 to 100000
    double waypoint_y{};                   ///< metres, -100000 to 100000
    std::optional<double> waypoint_z{};    ///< metres, -10000 to 35000
    std::optional<double> desired_roll{};  ///< radians, -pi to pi
    std::optional<double> desired_pitch{}; ///< radians, -pi to pi
    std::optional<double> desired_yaw{};   ///< radians, -pi to pi
    friend constexpr bool operator==(const report_local_waypoint&, const report_local_waypoint&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x440D;
        using query = query_local_waypoint;
        using T = report_local_waypoint;
        using type = layout<
            lenient_presence<u8,
                field<&T::waypoint_number, u16le>,
                field<&T::waypoint_x, scaled<i32le, local_coordinate>>,
                field<&T::waypoint_y, scaled<i32le, local_coordinate>>,
                field<&T::waypoint_z, scaled<i32le, elevation_range>>,
                field<&T::desired_roll, scaled<i16le, signed_angle>>,
                field<&T::desired_pitch, scaled<i16le, signed_angle>>,
                field<&T::desired_yaw, scaled<i16le, signed_angle>>>>;
    };
};

/// Report Path Segment Count: how many path segments there are.
/// Code 440Eh, inform class, 2 bytes.
struct report_path_segment_count {
    std::uint16_t path_segment_count{}; ///< path segments
    friend constexpr bool operator==(const report_path_segment_count&, const report_path_segment_count&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x440E;
        using query = query_path_segment_count;
        using T = report_path_segment_count;
        using type = layout<field<&T::path_segment_count, u16le>>;
    };
};

/// Report Global Path Segment: a path segment by latitude and longitude.
/// Code 440Fh, inform class, 21 to 29 bytes.
struct report_global_path_segment {
    std::uint16_t path_segment_number{}; ///< which path segment
    double p1_latitude{};                ///< degrees, -90 to 90
    double p1_longitude{};               ///< degrees, -180 to 180
    std::optional<double> p1_altitude{}; ///< metres, -10000 to 35000
    double p2_latitude{};                ///< degrees, -90 to 90
    double p2_longitude{};               ///< degrees, -180 to 180
    std::optional<double> p2_altitude{}; ///< metres, -10000 to 35000
    double weighting_factor{};           ///< 0 to 500
    friend constexpr bool operator==(const report_global_path_segment&, const report_global_path_segment&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x440F;
        using query = query_global_path_segment;
        using T = report_global_path_segment;
        using type = layout<
            lenient_presence<u8,
                field<&T::path_segment_number, u16le>,
                field<&T::p1_latitude, scaled<i32le, latitude_range>>,
                field<&T::p1_longitude, scaled<i32le, longitude_range>>,
                field<&T::p1_altitude, scaled<i32le, elevation_range>>,
                field<&T::p2_latitude, scaled<i32le, latitude_range>>,
                field<&T::p2_longitude, scaled<i32le, longitude_range>>,
                field<&T::p2_altitude, scaled<i32le, elevation_range>>,
                field<&T::weighting_factor, scaled<u16le, path_weight>>>>;
    };
};

/// Report Local Path Segment: a path segment in local coordinates.
/// Code 4410h, inform class, 21 to 29 bytes.
struct report_local_path_segment {
    std::uint16_t path_segment_number{}; ///< which path segment
    double p1_x{};                       ///< metres, -100000 to 100000
    double p1_y{};                       ///< metres, -100000 to 100000
    std::optional<double> p1_z{};        ///< metres, -10000 to 35000
    double p2_x{};                       ///< metres, -100000 to 100000
    double p2_y{};                       ///< metres, -100000 to 100000
    std::optional<double> p2_z{};        ///< metres, -10000 to 35000
    double weighting_factor{};           ///< 0 to 500
    friend constexpr bool operator==(const report_local_path_segment&, const report_local_path_segment&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4410;
        using query = query_local_path_segment;
        using T = report_local_path_segment;
        using type = layout<
            lenient_presence<u8,
                field<&T::path_segment_number, u16le>,
                field<&T::p1_x, scaled<i32le, local_coordinate>>,
                field<&T::p1_y, scaled<i32le, local_coordinate>>,
                field<&T::p1_z, scaled<i32le, elevation_range>>,
                field<&T::p2_x, scaled<i32le, local_coordinate>>,
                field<&T::p2_y, scaled<i32le, local_coordinate>>,
                field<&T::p2_z, scaled<i32le, elevation_range>>,
                field<&T::weighting_factor, scaled<u16le, path_weight>>>>;
    };
};

/// The messages of the subgroup, by command code.
using platform_subgroup = message_list<
    set_velocity_state,
    set_wrench_effort,
    set_discrete_devices,
    set_global_vector,
    set_local_vector,
    set_travel_speed,
    set_global_waypoint,
    set_local_waypoint,
    set_global_path_segment,
    set_local_path_segment,
    query_platform_specifications,
    query_platform_operational_data,
    query_global_pose,
    query_local_pose,
    query_velocity_state,
    query_wrench_effort,
    query_discrete_devices,
    query_global_vector,
    query_local_vector,
    query_travel_speed,
    query_waypoint_count,
    query_global_waypoint,
    query_local_waypoint,
    query_path_segment_count,
    query_global_path_segment,
    query_local_path_segment,
    report_platform_specifications,
    report_platform_operational_data,
    report_global_pose,
    report_local_pose,
    report_velocity_state,
    report_wrench_effort,
    report_discrete_devices,
    report_global_vector,
    report_local_vector,
    report_travel_speed,
    report_waypoint_count,
    report_global_waypoint,
    report_local_waypoint,
    report_path_segment_count,
    report_global_path_segment,
    report_local_path_segment>;

} // namespace jauscat::jaus
