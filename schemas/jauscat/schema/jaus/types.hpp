// Ranges and units that JAUS messages share. RA 3.3 part 3, limits column of the message tables.
#pragma once
#include <string_view>

namespace jauscat::jaus {

inline constexpr double pi = 3.141592653589793;

// One line per range, as in the standard's table.
// clang-format off
struct percent         { static constexpr double min = 0,      max = 100  ; static constexpr std::string_view unit = "%"; };
struct signed_percent  { static constexpr double min = -100,   max = 100  ; static constexpr std::string_view unit = "%"; };
struct speed_limit     { static constexpr double min = 0,      max = 10000; static constexpr std::string_view unit = "m/s"; };
struct latitude_range  { static constexpr double min = -90,    max = 90   ; static constexpr std::string_view unit = "deg"; };
struct longitude_range { static constexpr double min = -180,   max = 180  ; static constexpr std::string_view unit = "deg"; };
struct elevation_range { static constexpr double min = -10000, max = 35000; static constexpr std::string_view unit = "m"; };
struct position_error  { static constexpr double min = 0,      max = 100  ; static constexpr std::string_view unit = "m"; };
struct signed_angle    { static constexpr double min = -pi,    max = pi   ; static constexpr std::string_view unit = "rad"; };
struct positive_angle  { static constexpr double min = 0,      max = pi   ; static constexpr std::string_view unit = "rad"; };
// clang-format on

} // namespace jauscat::jaus
