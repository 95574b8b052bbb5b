// A message with one list, an object and a conversion, for tables with one mistake.
#pragma once
#include <jauscat/translate/object_table.hpp>

using namespace jauscat;

namespace small {

struct metres_per_second {
    static constexpr double min = -1, max = 1;
    static constexpr std::string_view unit = "m/s";
};
struct message {
    wire::inline_list<double, 4> speeds{};
    wire::inline_list<double, 4> others{};
};

enum class unit { velocity, position };
struct object_type {
    using value_type = std::int32_t;
    small::unit unit{};
};
inline constexpr object_type object{unit::velocity};
inline constexpr object_type position{unit::position};

struct scale {};
struct conversion {
    static constexpr std::string_view from = "m/s";
    static constexpr auto to = unit::velocity;
    static constexpr bool zero_within_step = true;
    static double to_object(double value, const scale&) noexcept { return value; }
    static double limited(double value, const scale&) noexcept { return value; }
    static double from_object(double value, const scale&) noexcept { return value; }
};
struct of_radians : conversion {
    static constexpr std::string_view from = "rad/s";
};

struct list_message {
    wire::inline_list<double, 4> speeds{};
};

} // namespace small

template <> struct jauscat::wire::schema<small::list_message> {
    using T = small::list_message;
    using type =
        layout<repeated<&T::speeds, count<"number", u8>, element<"speed", scaled<u16le, small::metres_per_second>>>>;
};
template <> struct jauscat::wire::schema<small::message> {
    using T = small::message;
    using type =
        layout<repeated<&T::speeds, count<"number", u8>, element<"speed", scaled<u16le, small::metres_per_second>>>,
               repeated<&T::others, count<"number", u8>, element<"speed", scaled<u16le, small::metres_per_second>>>>;
};
