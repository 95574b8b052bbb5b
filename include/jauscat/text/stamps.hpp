// Text form of JAUS time and date stamps.
#pragma once
#include <jauscat/schema/jaus/time_stamp.hpp>
#include <jauscat/text/error.hpp>

#include <array>
#include <charconv>
#include <chrono>
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

namespace detail {
/// Removes `digits` digits and the expected text after them from the front of `text`; false if there is other text.
[[nodiscard]] inline bool take_number(std::string_view& text, std::size_t digits, std::string_view follows,
                                      unsigned& number) {
    if (text.size() < digits) return false;
    const char* const end = text.data() + digits;
    if (std::from_chars(text.data(), end, number).ptr != end) return false;
    text.remove_prefix(digits);
    if (!text.starts_with(follows)) return false;
    text.remove_prefix(follows.size());
    return true;
}
} // namespace detail

/// Reads what to_text writes, digit for digit. Errors: invalid_value (another form), out_of_range (no time of day).
[[nodiscard]] inline result<void, errc> from_text(jaus::time_stamp& time, std::string_view text) {
    unsigned hours{}, minutes{}, seconds{}, milliseconds{}, day{};
    if (!detail::take_number(text, 2, ":", hours) || !detail::take_number(text, 2, ":", minutes) ||
        !detail::take_number(text, 2, ".", seconds) || !detail::take_number(text, 3, ", day ", milliseconds) ||
        text.size() > 2 || !detail::take_number(text, text.size(), "", day))
        return errc::invalid_value;
    if (hours > 23 || minutes > 59 || seconds > 59 || day < 1 || day > 31) return errc::out_of_range;
    time = {.milliseconds = static_cast<std::uint16_t>(milliseconds),
            .seconds = static_cast<std::uint8_t>(seconds),
            .minutes = static_cast<std::uint8_t>(minutes),
            .hours = static_cast<std::uint8_t>(hours),
            .day = static_cast<std::uint8_t>(day)};
    return {};
}

/// Reads what to_text writes, digit for digit. Errors: invalid_value (another form), out_of_range (no date from 2000 to
/// 2127).
[[nodiscard]] inline result<void, errc> from_text(jaus::date_stamp& date, std::string_view text) {
    unsigned year{}, month{}, day{};
    if (!detail::take_number(text, 4, "-", year) || !detail::take_number(text, 2, "-", month) ||
        !detail::take_number(text, 2, "", day) || !text.empty())
        return errc::invalid_value;
    const std::chrono::year_month_day found{std::chrono::year{static_cast<int>(year)}, std::chrono::month{month},
                                            std::chrono::day{day}};
    if (year < 2000 || year > 2127 || !found.ok()) return errc::out_of_range;
    date = {.day = static_cast<std::uint8_t>(day),
            .month = static_cast<std::uint8_t>(month),
            .year = static_cast<std::uint8_t>(year - 2000)};
    return {};
}

} // namespace jauscat::text
