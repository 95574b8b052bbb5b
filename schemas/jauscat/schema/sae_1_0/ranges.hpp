// Ranges and units of the messages.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <string_view>

// One line per range: the limits of a scaled number and its unit.
// clang-format off
namespace jauscat::sae_1_0 {

struct meter_minus_10000_to_35000   { static constexpr double min = -10000,             max = 35000;             static constexpr std::string_view unit = "meter"; };
struct meter_per_second_0_to_327_67 { static constexpr double min = 0,                  max = 327.67;            static constexpr std::string_view unit = "meter per second"; };
struct radian_minus_pi_to_pi        { static constexpr double min = -3.141592653589793, max = 3.141592653589793; static constexpr std::string_view unit = "radian"; };

} // namespace jauscat::sae_1_0
