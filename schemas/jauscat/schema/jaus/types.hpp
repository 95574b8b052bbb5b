// Ranges and units that JAUS messages share. RA 3.3 part 3, limits and units columns of the message tables.
#pragma once
#include <jauscat/schema/jaus/command_code.hpp>

#include <string_view>

namespace jauscat::jaus {

/// As exact as a double is.
inline constexpr double pi = 3.141592653589793;

// One line per range, as in the standard's tables: the limits of a scaled integer and its unit.
// clang-format off
struct percent                        { static constexpr double min = 0,        max = 100     ; static constexpr std::string_view unit = "%"; };
struct signed_percent                 { static constexpr double min = -100,     max = 100     ; static constexpr std::string_view unit = "%"; };
struct gauge_percent                  { static constexpr double min = 0,        max = 127     ; static constexpr std::string_view unit = "%"; };
struct latitude_range                 { static constexpr double min = -90,      max = 90      ; static constexpr std::string_view unit = "deg"; };
struct longitude_range                { static constexpr double min = -180,     max = 180     ; static constexpr std::string_view unit = "deg"; };
struct elevation_range                { static constexpr double min = -10000,   max = 35000   ; static constexpr std::string_view unit = "m"; };
struct local_coordinate               { static constexpr double min = -100000,  max = 100000  ; static constexpr std::string_view unit = "m"; };
struct position_error                 { static constexpr double min = 0,        max = 100     ; static constexpr std::string_view unit = "m"; };
struct object_range                   { static constexpr double min = -10000,   max = 10000   ; static constexpr std::string_view unit = "m"; };
struct object_range_error             { static constexpr double min = 0,        max = 1000    ; static constexpr std::string_view unit = "m"; };
struct platform_dimension             { static constexpr double min = 0,        max = 32.767  ; static constexpr std::string_view unit = "m"; };
struct chassis_dimension              { static constexpr double min = 0,        max = 65.535  ; static constexpr std::string_view unit = "m"; };
struct camera_origin                  { static constexpr double min = -32.767,  max = 32.767  ; static constexpr std::string_view unit = "m"; };
struct tool_tip_coordinate            { static constexpr double min = -15,      max = 15      ; static constexpr std::string_view unit = "m"; };
struct manipulator_coordinate         { static constexpr double min = -30,      max = 30      ; static constexpr std::string_view unit = "m"; };
struct speed_limit                    { static constexpr double min = 0,        max = 10000   ; static constexpr std::string_view unit = "m/s"; };
struct maximum_velocity               { static constexpr double min = 0,        max = 65.535  ; static constexpr std::string_view unit = "m/s"; };
struct velocity_range                 { static constexpr double min = -65.534,  max = 65.534  ; static constexpr std::string_view unit = "m/s"; };
struct velocity_error                 { static constexpr double min = 0,        max = 100     ; static constexpr std::string_view unit = "m/s"; };
struct end_effector_linear_velocity   { static constexpr double min = -10,      max = 10      ; static constexpr std::string_view unit = "m/s"; };
struct signed_angle                   { static constexpr double min = -pi,      max = pi      ; static constexpr std::string_view unit = "rad"; };
struct positive_angle                 { static constexpr double min = 0,        max = pi      ; static constexpr std::string_view unit = "rad"; };
struct static_roll_over_angle         { static constexpr double min = 0,        max = 2.56    ; static constexpr std::string_view unit = "rad"; };
struct joint_angle                    { static constexpr double min = -8 * pi,  max = 8 * pi  ; static constexpr std::string_view unit = "rad"; };
struct angular_rate                   { static constexpr double min = -32.767,  max = 32.767  ; static constexpr std::string_view unit = "rad/s"; };
struct angular_rate_error             { static constexpr double min = 0,        max = pi      ; static constexpr std::string_view unit = "rad/s"; };
struct maximum_angular_rate           { static constexpr double min = 0,        max = 32.767  ; static constexpr std::string_view unit = "rad/s"; };
struct joint_angular_velocity         { static constexpr double min = -10 * pi, max = 10 * pi ; static constexpr std::string_view unit = "rad/s"; };
struct end_effector_angular_velocity  { static constexpr double min = -20 * pi, max = 20 * pi ; static constexpr std::string_view unit = "rad/s"; };
struct joint_angular_acceleration     { static constexpr double min = -10 * pi, max = 10 * pi ; static constexpr std::string_view unit = "rad/s^2"; };
struct joint_torque                   { static constexpr double min = -1000,    max = 1000    ; static constexpr std::string_view unit = "N m"; };
struct engine_temperature_range       { static constexpr double min = -75,      max = 180     ; static constexpr std::string_view unit = "deg C"; };
struct update_rate                    { static constexpr double min = 0,        max = 1092    ; static constexpr std::string_view unit = "Hz"; };
struct pose_duration                  { static constexpr double min = 0,        max = 6000    ; static constexpr std::string_view unit = "s"; };
struct path_weight                    { static constexpr double min = 0,        max = 500     ; static constexpr std::string_view unit{}; };
struct unit_vector_component          { static constexpr double min = -1,       max = 1       ; static constexpr std::string_view unit{}; };

// Units of values that travel as they are.
struct metres                         { static constexpr std::string_view unit = "m"; };
struct millimetres                    { static constexpr std::string_view unit = "mm"; };
struct milliradians                   { static constexpr std::string_view unit = "mrad"; };
struct whole_seconds                  { static constexpr std::string_view unit = "s"; };
struct frames_per_second              { static constexpr std::string_view unit = "1/s"; };
struct pixels                         { static constexpr std::string_view unit = "px"; };
// clang-format on

} // namespace jauscat::jaus
