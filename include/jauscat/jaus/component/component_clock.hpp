// A component's clock: Set Time, Query Time, Report Time. It is an offset to the caller's time and needs no clock of
// its own. RA 3.3 part 3, core subgroup and stamp formats.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/jaus/message/requested_fields.hpp>
#include <jauscat/schema/jaus/core.hpp>

#include <chrono>
#include <optional>

namespace jauscat::jaus {

/// A date and time of day. JAUS names no time zone; nodes that work together must mean the same one.
using civil_time = std::chrono::sys_time<std::chrono::nanoseconds>;

/// Whether date stamps can tell the date: their years are 2000 to 2127.
[[nodiscard]] JAUSCAT_CONSTEXPR bool has_date_stamp(civil_time t) noexcept;

/// The stamps of a time, cut to milliseconds. The date must have a stamp.
[[nodiscard]] JAUSCAT_CONSTEXPR report_time stamps_of(civil_time t) noexcept;

/// The stamp's time of day; empty where a value is outside its range. The day of the month is another matter.
[[nodiscard]] JAUSCAT_CONSTEXPR std::optional<duration> time_of_day(const time_stamp& s) noexcept;

/// The stamp's date; empty where there is no such day, such as the 29th of February 2023.
[[nodiscard]] JAUSCAT_CONSTEXPR std::optional<std::chrono::sys_days> date_of(const date_stamp& s) noexcept;

/// The clock. Before it is set it has neither time nor date: a report contains only what Set Time or the application
/// has set.
///
/// Set Time may carry the time, the date, or both. The time alone keeps the date: it is the one nearest to the clock's
/// that has the stamp's day of the month, so a slow clock at the end of a month is advanced into the next. The date
/// alone keeps the time of day. A day of 0 in a time stamp, as some nodes send it, means that of the date stamp, or of
/// the clock.
class component_clock {
  public:
    constexpr explicit component_clock(const address& self) noexcept : self_{self} {}

    /// Sets the clock at `now` of the caller's time. False, and no change, where date stamps cannot tell the date.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool set(civil_time time, time_point now) noexcept;
    /// The clock's time at `now`; empty while the time or the date has not been set.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::optional<civil_time> time_at(time_point now) const noexcept;
    /// Report Time at `now`. A date after 2127 is left out.
    [[nodiscard]] JAUSCAT_CONSTEXPR report_time report_at(time_point now) const noexcept;

    /// Handles Set Time, and answers Query Time with the requested fields. Refused: a Set Time with values outside
    /// their ranges, an impossible day, or two contradicting days.
    JAUSCAT_CONSTEXPR message_outcome on_message(const header& head, std::span<const std::byte> body, time_point now,
                                                 message_sink out) noexcept;

  private:
    [[nodiscard]] JAUSCAT_CONSTEXPR civil_time running(time_point now) const noexcept;

    [[nodiscard]] JAUSCAT_CONSTEXPR bool set_from(const set_time& m, time_point now) noexcept;
    // The date with this day of the month that brings the clock nearest to what it shows. Of two months in a row one
    // has 31 days, so there is one within two months, before and after.
    [[nodiscard]] JAUSCAT_CONSTEXPR static std::chrono::sys_days nearest(civil_time shown, duration time,
                                                                         std::uint8_t day) noexcept;

    // Epoch of a clock without a date.
    static constexpr std::chrono::sys_days unset{std::chrono::year{2000} / 1 / 1};

    address self_;
    duration offset_{};
    bool has_time_{};
    bool has_date_{};
};

} // namespace jauscat::jaus

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jaus/component/impl/component_clock.ipp>
#endif
