// The stamps of reports and of the core subgroup's clock messages. RA 3.3 part 3, time stamp and date stamp formats.
#pragma once
#include <jauscat/wire/schema.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::jaus {

/// Time of day and day of the month. 4 bytes.
struct time_stamp {
    std::uint16_t milliseconds{}; ///< 0 to 999
    std::uint8_t seconds{};       ///< 0 to 59
    std::uint8_t minutes{};       ///< 0 to 59
    std::uint8_t hours{};         ///< 0 to 23
    std::uint8_t day{};           ///< 1 to 31
    friend constexpr bool operator==(const time_stamp&, const time_stamp&) = default;

    struct schema : wire::items {
        using T = time_stamp;
        using type = layout<
            bit_fields<u32le,
                bit_field<&T::milliseconds, 10>,
                bit_field<&T::seconds, 6>,
                bit_field<&T::minutes, 6>,
                bit_field<&T::hours, 5>,
                bit_field<&T::day, 5>>>;
    };
};

/// Date. 2 bytes. Some peers count months from 0, or years from 1920 (2008 as 88).
struct date_stamp {
    std::uint8_t day{};   ///< 1 to 31
    std::uint8_t month{}; ///< 1 to 12
    std::uint8_t year{};  ///< 0 to 127, counted from 2000
    friend constexpr bool operator==(const date_stamp&, const date_stamp&) = default;

    struct schema : wire::items {
        using T = date_stamp;
        using type = layout<
            bit_fields<u16le,
                bit_field<&T::day, 5>,
                bit_field<&T::month, 4>,
                bit_field<&T::year, 7>>>;
    };
};

} // namespace jauscat::jaus
