// Ranges and units that JAUS messages share. RA 3.3 part 3.
#pragma once
#include <string_view>

namespace jauscat::jaus {

// clang-format off
struct percent                { static constexpr double min = 0,       max = 100;     static constexpr std::string_view unit = "%"; };
struct signed_percent         { static constexpr double min = -100,    max = 100;     static constexpr std::string_view unit = "%"; };
struct travel_speed           { static constexpr double min = 0,       max = 10000;   static constexpr std::string_view unit = "m/s"; };
struct latitude               { static constexpr double min = -90,     max = 90;      static constexpr std::string_view unit = "deg"; };
struct longitude              { static constexpr double min = -180,    max = 180;     static constexpr std::string_view unit = "deg"; };
struct elevation              { static constexpr double min = -10000,  max = 35000;   static constexpr std::string_view unit = "m"; };
struct position_rms           { static constexpr double min = 0,       max = 100;     static constexpr std::string_view unit = "m"; };
struct signed_angle           { static constexpr double min = -3.141592653589793, max = 3.141592653589793; static constexpr std::string_view unit = "rad"; };
struct positive_angle         { static constexpr double min = 0,       max = 3.141592653589793; static constexpr std::string_view unit = "rad"; };
// clang-format on

} // namespace jauscat::jaus
