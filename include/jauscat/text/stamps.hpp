// JAUS time and date stamps as people write them.
#pragma once
#include <jauscat/schema/jaus/time_stamp.hpp>

#include <array>
#include <cstdio>
#include <string>

namespace jauscat::text {

/// `12:34:56.789, day 5`.
[[nodiscard]] inline std::string to_text(const jaus::time_stamp& time) {
    std::array<char, 48> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%02u:%02u:%02u.%03u, day %u", unsigned{time.hours},
                  unsigned{time.minutes}, unsigned{time.seconds}, unsigned{time.milliseconds}, unsigned{time.day});
    return buffer.data();
}

/// `2007-06-27`.
[[nodiscard]] inline std::string to_text(const jaus::date_stamp& date) {
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%04u-%02u-%02u", 2000u + date.year, unsigned{date.month},
                  unsigned{date.day});
    return buffer.data();
}

/// Reads what to_text writes; false where `text` is something else or no time of day.
[[nodiscard]] inline bool from_text(jaus::time_stamp& time, std::string_view text) {
    unsigned hours{}, minutes{}, seconds{}, milliseconds{}, day{};
    int end{};
    const std::string copy{text};
    if (std::sscanf(copy.c_str(), "%2u:%2u:%2u.%3u, day %2u%n", &hours, &minutes, &seconds, &milliseconds, &day,
                    &end) != 5 ||
        static_cast<std::size_t>(end) != copy.size())
        return false;
    if (hours > 23 || minutes > 59 || seconds > 59 || day < 1 || day > 31) return false;
    time = {.milliseconds = static_cast<std::uint16_t>(milliseconds),
            .seconds = static_cast<std::uint8_t>(seconds),
            .minutes = static_cast<std::uint8_t>(minutes),
            .hours = static_cast<std::uint8_t>(hours),
            .day = static_cast<std::uint8_t>(day)};
    return true;
}

/// Reads what to_text writes; false where `text` is something else or no date from 2000 to 2127.
[[nodiscard]] inline bool from_text(jaus::date_stamp& date, std::string_view text) {
    unsigned year{}, month{}, day{};
    int end{};
    const std::string copy{text};
    if (std::sscanf(copy.c_str(), "%4u-%2u-%2u%n", &year, &month, &day, &end) != 3 ||
        static_cast<std::size_t>(end) != copy.size())
        return false;
    if (year < 2000 || year > 2127 || month < 1 || month > 12 || day < 1 || day > 31) return false;
    date = {.day = static_cast<std::uint8_t>(day),
            .month = static_cast<std::uint8_t>(month),
            .year = static_cast<std::uint8_t>(year - 2000)};
    return true;
}

} // namespace jauscat::text
