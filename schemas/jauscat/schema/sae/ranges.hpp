// Ranges and units of the messages.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <string_view>

// One line per range: the limits of a scaled number and its unit.
// clang-format off
namespace jauscat::sae {

struct ampere_0_to_1000                                   { static constexpr double min = 0,                   max = 1000;               static constexpr std::string_view unit = "ampere"; };
struct ampere_0_to_5000                                   { static constexpr double min = 0,                   max = 5000;               static constexpr std::string_view unit = "ampere"; };
struct bar_0_to_512                                       { static constexpr double min = 0,                   max = 512;                static constexpr std::string_view unit = "bar"; };
struct coulomb_0_to_3600000                               { static constexpr double min = 0,                   max = 3600000;            static constexpr std::string_view unit = "coulomb"; };
struct degree_0_to_360                                    { static constexpr double min = 0,                   max = 360;                static constexpr std::string_view unit = "degree"; };
struct degree_celsius_0_to_256                            { static constexpr double min = 0,                   max = 256;                static constexpr std::string_view unit = "degree Celsius"; };
struct degree_celsius_minus_75_to_180                     { static constexpr double min = -75,                 max = 180;                static constexpr std::string_view unit = "degree Celsius"; };
struct degree_minus_180_to_180                            { static constexpr double min = -180,                max = 180;                static constexpr std::string_view unit = "degree"; };
struct degree_minus_90_to_90                              { static constexpr double min = -90,                 max = 90;                 static constexpr std::string_view unit = "degree"; };
struct hertz_0_to_1000                                    { static constexpr double min = 0,                   max = 1000;               static constexpr std::string_view unit = "hertz"; };
struct hertz_0_to_1092                                    { static constexpr double min = 0,                   max = 1092;               static constexpr std::string_view unit = "hertz"; };
struct kilogram_0_to_1000000                              { static constexpr double min = 0,                   max = 1000000;            static constexpr std::string_view unit = "kilogram"; };
struct kilogram_0_to_256                                  { static constexpr double min = 0,                   max = 256;                static constexpr std::string_view unit = "kilogram"; };
struct liter_0_to_256                                     { static constexpr double min = 0,                   max = 256;                static constexpr std::string_view unit = "liter"; };
struct meter_0_to_10                                      { static constexpr double min = 0,                   max = 10;                 static constexpr std::string_view unit = "meter"; };
struct meter_0_to_100                                     { static constexpr double min = 0,                   max = 100;                static constexpr std::string_view unit = "meter"; };
struct meter_0_to_10000                                   { static constexpr double min = 0,                   max = 10000;              static constexpr std::string_view unit = "meter"; };
struct meter_0_to_100000                                  { static constexpr double min = 0,                   max = 100000;             static constexpr std::string_view unit = "meter"; };
struct meter_0_to_1000000                                 { static constexpr double min = 0,                   max = 1000000;            static constexpr std::string_view unit = "meter"; };
struct meter_0_to_2                                       { static constexpr double min = 0,                   max = 2;                  static constexpr std::string_view unit = "meter"; };
struct meter_0_to_200000                                  { static constexpr double min = 0,                   max = 200000;             static constexpr std::string_view unit = "meter"; };
struct meter_0_to_25                                      { static constexpr double min = 0,                   max = 25;                 static constexpr std::string_view unit = "meter"; };
struct meter_0_to_30                                      { static constexpr double min = 0,                   max = 30;                 static constexpr std::string_view unit = "meter"; };
struct meter_0_to_50000                                   { static constexpr double min = 0,                   max = 50000;              static constexpr std::string_view unit = "meter"; };
struct meter_0_to_60                                      { static constexpr double min = 0,                   max = 60;                 static constexpr std::string_view unit = "meter"; };
struct meter_minus_100000_to_100000                       { static constexpr double min = -100000,             max = 100000;             static constexpr std::string_view unit = "meter"; };
struct meter_minus_10000_to_35000                         { static constexpr double min = -10000,              max = 35000;              static constexpr std::string_view unit = "meter"; };
struct meter_minus_10_to_10                               { static constexpr double min = -10,                 max = 10;                 static constexpr std::string_view unit = "meter"; };
struct meter_minus_20000000_to_20000000                   { static constexpr double min = -20000000,           max = 20000000;           static constexpr std::string_view unit = "meter"; };
struct meter_minus_30_to_30                               { static constexpr double min = -30,                 max = 30;                 static constexpr std::string_view unit = "meter"; };
struct meter_minus_32_768_to_32_767                       { static constexpr double min = -32.768,             max = 32.767;             static constexpr std::string_view unit = "meter"; };
struct meter_minus_50000_to_50000                         { static constexpr double min = -50000,              max = 50000;              static constexpr std::string_view unit = "meter"; };
struct meter_per_second_0_to_100                          { static constexpr double min = 0,                   max = 100;                static constexpr std::string_view unit = "meter per second"; };
struct meter_per_second_0_to_327_67                       { static constexpr double min = 0,                   max = 327.67;             static constexpr std::string_view unit = "meter per second"; };
struct meter_per_second_0_to_90                           { static constexpr double min = 0,                   max = 90;                 static constexpr std::string_view unit = "meter per second"; };
struct meter_per_second_minus_10_to_10                    { static constexpr double min = -10,                 max = 10;                 static constexpr std::string_view unit = "meter per second"; };
struct meter_per_second_minus_327_68_to_327_67            { static constexpr double min = -327.68,             max = 327.67;             static constexpr std::string_view unit = "meter per second"; };
struct meter_per_second_minus_5_to_5                      { static constexpr double min = -5,                  max = 5;                  static constexpr std::string_view unit = "meter per second"; };
struct meter_per_second_squared_0_to_100                  { static constexpr double min = 0,                   max = 100;                static constexpr std::string_view unit = "meter per second squared"; };
struct meter_per_second_squared_0_to_40                   { static constexpr double min = 0,                   max = 40;                 static constexpr std::string_view unit = "meter per second squared"; };
struct meter_per_second_squared_minus_1310_68_to_1310_68  { static constexpr double min = -1310.68,            max = 1310.68;            static constexpr std::string_view unit = "meter per second squared"; };
struct newton_0_to_5000                                   { static constexpr double min = 0,                   max = 5000;               static constexpr std::string_view unit = "newton"; };
struct newton_meter_0_to_500                              { static constexpr double min = 0,                   max = 500;                static constexpr std::string_view unit = "newton meter"; };
struct newton_meter_0_to_5000                             { static constexpr double min = 0,                   max = 5000;               static constexpr std::string_view unit = "newton meter"; };
struct newton_meter_minus_1000_to_1000                    { static constexpr double min = -1000,               max = 1000;               static constexpr std::string_view unit = "newton meter"; };
struct newton_meter_minus_5000_to_5000                    { static constexpr double min = -5000,               max = 5000;               static constexpr std::string_view unit = "newton meter"; };
struct newton_meter_minus_500_to_500                      { static constexpr double min = -500,                max = 500;                static constexpr std::string_view unit = "newton meter"; };
struct newton_minus_5000_to_5000                          { static constexpr double min = -5000,               max = 5000;               static constexpr std::string_view unit = "newton"; };
struct newton_minus_500_to_500                            { static constexpr double min = -500,                max = 500;                static constexpr std::string_view unit = "newton"; };
struct one_0_1_to_128                                     { static constexpr double min = 0.1,                 max = 128;                static constexpr std::string_view unit{}; };
struct one_0_to_100                                       { static constexpr double min = 0,                   max = 100;                static constexpr std::string_view unit{}; };
struct one_0_to_200                                       { static constexpr double min = 0,                   max = 200;                static constexpr std::string_view unit{}; };
struct one_0_to_500                                       { static constexpr double min = 0,                   max = 500;                static constexpr std::string_view unit{}; };
struct one_minus_100_to_100                               { static constexpr double min = -100,                max = 100;                static constexpr std::string_view unit{}; };
struct one_minus_1_to_1                                   { static constexpr double min = -1,                  max = 1;                  static constexpr std::string_view unit{}; };
struct percent_0_to_100                                   { static constexpr double min = 0,                   max = 100;                static constexpr std::string_view unit = "percent"; };
struct percent_minus_100_to_100                           { static constexpr double min = -100,                max = 100;                static constexpr std::string_view unit = "percent"; };
struct radian_0_to_3_14159                                { static constexpr double min = 0,                   max = 3.14159;            static constexpr std::string_view unit = "radian"; };
struct radian_0_to_pi                                     { static constexpr double min = 0,                   max = 3.141592653589793;  static constexpr std::string_view unit = "radian"; };
struct radian_0_to_pi_by_2                                { static constexpr double min = 0,                   max = 1.5707963267948966; static constexpr std::string_view unit = "radian"; };
struct radian_minus_3_14158_to_0                          { static constexpr double min = -3.14158,            max = 0;                  static constexpr std::string_view unit = "radian"; };
struct radian_minus_3_14159_to_3_14159                    { static constexpr double min = -3.14159,            max = 3.14159;            static constexpr std::string_view unit = "radian"; };
struct radian_minus_8_pi_to_8_pi                          { static constexpr double min = -25.132741228718345, max = 25.132741228718345; static constexpr std::string_view unit = "radian"; };
struct radian_minus_pi_by_2_to_pi_by_2                    { static constexpr double min = -1.5707963267948966, max = 1.5707963267948966; static constexpr std::string_view unit = "radian"; };
struct radian_minus_pi_to_pi                              { static constexpr double min = -3.141592653589793,  max = 3.141592653589793;  static constexpr std::string_view unit = "radian"; };
struct radian_per_second_0_to_100                         { static constexpr double min = 0,                   max = 100;                static constexpr std::string_view unit = "radian per second"; };
struct radian_per_second_0_to_10_pi                       { static constexpr double min = 0,                   max = 31.41592653589793;  static constexpr std::string_view unit = "radian per second"; };
struct radian_per_second_0_to_32_767                      { static constexpr double min = 0,                   max = 32.767;             static constexpr std::string_view unit = "radian per second"; };
struct radian_per_second_0_to_6_28                        { static constexpr double min = 0,                   max = 6.28;               static constexpr std::string_view unit = "radian per second"; };
struct radian_per_second_0_to_pi                          { static constexpr double min = 0,                   max = 3.141592653589793;  static constexpr std::string_view unit = "radian per second"; };
struct radian_per_second_minus_10_pi_to_10_pi             { static constexpr double min = -31.41592653589793,  max = 31.41592653589793;  static constexpr std::string_view unit = "radian per second"; };
struct radian_per_second_minus_20_pi_to_20_pi             { static constexpr double min = -62.83185307179586,  max = 62.83185307179586;  static constexpr std::string_view unit = "radian per second"; };
struct radian_per_second_minus_32_767_to_32_768           { static constexpr double min = -32.767,             max = 32.768;             static constexpr std::string_view unit = "radian per second"; };
struct radian_per_second_minus_32_768_to_32_767           { static constexpr double min = -32.768,             max = 32.767;             static constexpr std::string_view unit = "radian per second"; };
struct radian_per_second_squared_0_to_1000                { static constexpr double min = 0,                   max = 1000;               static constexpr std::string_view unit = "radian per second squared"; };
struct radian_per_second_squared_0_to_10_pi               { static constexpr double min = 0,                   max = 31.41592653589793;  static constexpr std::string_view unit = "radian per second squared"; };
struct radian_per_second_squared_0_to_pi                  { static constexpr double min = 0,                   max = 3.141592653589793;  static constexpr std::string_view unit = "radian per second squared"; };
struct radian_per_second_squared_minus_13106_8_to_13106_8 { static constexpr double min = -13106.8,            max = 13106.8;            static constexpr std::string_view unit = "radian per second squared"; };
struct rotations_per_minute_minus_1000_to_1000            { static constexpr double min = -1000,               max = 1000;               static constexpr std::string_view unit = "rotations per minute"; };
struct second_0_to_256                                    { static constexpr double min = 0,                   max = 256;                static constexpr std::string_view unit = "second"; };
struct second_0_to_60                                     { static constexpr double min = 0,                   max = 60;                 static constexpr std::string_view unit = "second"; };
struct volt_0_to_1000                                     { static constexpr double min = 0,                   max = 1000;               static constexpr std::string_view unit = "volt"; };

// Units of numbers that are not scaled.
struct hour { static constexpr std::string_view unit = "hour"; };
struct lumen { static constexpr std::string_view unit = "lumen"; };
struct meter { static constexpr std::string_view unit = "meter"; };
struct second { static constexpr std::string_view unit = "second"; };

} // namespace jauscat::sae
