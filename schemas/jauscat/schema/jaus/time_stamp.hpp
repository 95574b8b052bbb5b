// The time stamp of pose and velocity reports. RA 3.3 part 3, time stamp format.
#pragma once
#include <jauscat/wire/schema.hpp>

namespace jauscat::jaus {

/// Time of day and day of the month. 4 bytes.
struct time_stamp {
    std::uint16_t milliseconds{}; ///< 0 to 999
    std::uint8_t seconds{};       ///< 0 to 59
    std::uint8_t minutes{};       ///< 0 to 59
    std::uint8_t hours{};         ///< 0 to 23
    std::uint8_t day{};           ///< 1 to 31
    friend constexpr bool operator==(const time_stamp&, const time_stamp&) = default;
};

} // namespace jauscat::jaus

// One line per field, as in the standard's table.
// clang-format off
namespace jauscat {

template <> struct wire::schema<jaus::time_stamp> {
    using T = jaus::time_stamp;
    using type = layout<
        bits<u32le,
            bit<&T::milliseconds, 10>,
            bit<&T::seconds, 6>,
            bit<&T::minutes, 6>,
            bit<&T::hours, 5>,
            bit<&T::day, 5>>>;
};

} // namespace jauscat
