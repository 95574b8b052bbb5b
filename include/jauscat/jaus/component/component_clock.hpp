// A component's clock: Set Time, Query Time, Report Time. It is an offset to the caller's time and needs no clock of
// its own. RA 3.3 part 3, core subgroup and stamp formats.
#pragma once
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
[[nodiscard]] constexpr bool has_date_stamp(civil_time t) noexcept {
    using namespace std::chrono;
    const auto year = year_month_day{floor<days>(t)}.year();
    return year >= std::chrono::year{2000} && year <= std::chrono::year{2127};
}

/// The stamps of a time, cut to milliseconds. The date must have a stamp.
[[nodiscard]] constexpr report_time stamps_of(civil_time t) noexcept {
    using namespace std::chrono;
    const auto day = floor<days>(t);
    const year_month_day date{day};
    const hh_mm_ss clock{floor<milliseconds>(t - day)};
    const auto day_of_month = static_cast<std::uint8_t>(unsigned{date.day()});
    return {.time_stamp = time_stamp{.milliseconds = static_cast<std::uint16_t>(clock.subseconds().count()),
                                     .seconds = static_cast<std::uint8_t>(clock.seconds().count()),
                                     .minutes = static_cast<std::uint8_t>(clock.minutes().count()),
                                     .hours = static_cast<std::uint8_t>(clock.hours().count()),
                                     .day = day_of_month},
            .date_stamp = date_stamp{.day = day_of_month,
                                     .month = static_cast<std::uint8_t>(unsigned{date.month()}),
                                     .year = static_cast<std::uint8_t>(int{date.year()} - 2000)}};
}

/// The stamp's time of day; empty where a value is outside its range. The day of the month is another matter.
[[nodiscard]] constexpr std::optional<duration> time_of_day(const time_stamp& s) noexcept {
    using namespace std::chrono;
    if (s.milliseconds > 999 || s.seconds > 59 || s.minutes > 59 || s.hours > 23) return std::nullopt;
    return hours{s.hours} + minutes{s.minutes} + seconds{s.seconds} + milliseconds{s.milliseconds};
}

/// The stamp's date; empty where there is no such day, such as the 29th of February 2023.
[[nodiscard]] constexpr std::optional<std::chrono::sys_days> date_of(const date_stamp& s) noexcept {
    using namespace std::chrono;
    const year_month_day date{year{2000 + s.year}, month{s.month}, day{s.day}};
    return date.ok() ? std::optional{sys_days{date}} : std::nullopt;
}

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
    [[nodiscard]] constexpr bool set(civil_time time, time_point now) noexcept {
        if (!has_date_stamp(time)) return false;
        offset_ = time.time_since_epoch() - now.time_since_epoch();
        has_time_ = has_date_ = true;
        return true;
    }
    /// The clock's time at `now`; empty while the time or the date has not been set.
    [[nodiscard]] constexpr std::optional<civil_time> time_at(time_point now) const noexcept {
        return has_time_ && has_date_ ? std::optional{running(now)} : std::nullopt;
    }
    /// Report Time at `now`. A date after 2127 is left out.
    [[nodiscard]] constexpr report_time report_at(time_point now) const noexcept {
        const civil_time time = running(now);
        report_time report = stamps_of(time);
        if (!has_time_) report.time_stamp.reset();
        if (!has_date_ || !has_date_stamp(time)) report.date_stamp.reset();
        return report;
    }

    /// Handles Set Time, and answers Query Time with the requested fields. Refused: a Set Time with values outside
    /// their ranges, an impossible day, or two contradicting days.
    constexpr message_outcome on_message(const header& head, std::span<const std::byte> body, time_point now,
                                         message_sink out) noexcept {
        switch (head.command_code) {
        case command_code_of<set_time>:
            return decode_for<set_time>(body, [&](const set_time& m) {
                return set_from(m, now) ? message_outcome::handled : message_outcome::refused;
            });
        case command_code_of<query_time>:
            return decode_for<query_time>(body, [&](const query_time& query) {
                report_time report = report_at(now);
                keep_requested(report, query.presence_vector);
                static_cast<void>(answer(head, self_, report, out));
            });
        default: return message_outcome::unhandled;
        }
    }

  private:
    [[nodiscard]] constexpr civil_time running(time_point now) const noexcept {
        return civil_time{now.time_since_epoch() + offset_};
    }

    [[nodiscard]] constexpr bool set_from(const set_time& m, time_point now) noexcept {
        using namespace std::chrono;
        if (!m.time_stamp && !m.date_stamp) return true;
        const civil_time shown = has_time_ || has_date_ ? running(now) : civil_time{unset};
        sys_days date = floor<days>(shown);
        nanoseconds time = shown - date;
        if (m.date_stamp) {
            const auto told = date_of(*m.date_stamp);
            if (!told) return false;
            date = *told;
        }
        if (m.time_stamp) {
            const auto told = time_of_day(*m.time_stamp);
            if (!told) return false;
            time = *told;
            if (const std::uint8_t day = m.time_stamp->day; day != 0) {
                if (m.date_stamp && day != m.date_stamp->day) return false;
                if (!m.date_stamp) date = nearest(shown, time, day);
            }
        }
        offset_ = civil_time{date} + time - civil_time{now.time_since_epoch()};
        has_time_ |= m.time_stamp.has_value();
        has_date_ |= m.date_stamp.has_value();
        return true;
    }
    // The date with this day of the month that brings the clock nearest to what it shows. Of three months in a row one
    // has 31 days, so there is one.
    [[nodiscard]] static constexpr std::chrono::sys_days nearest(civil_time shown, duration time,
                                                                 std::uint8_t day) noexcept {
        using namespace std::chrono;
        const year_month_day today{floor<days>(shown)};
        const auto distance = [&](sys_days date) { return abs(date + time - shown); };
        std::optional<sys_days> best;
        for (const int step : {-1, 0, 1}) {
            const year_month_day date = (today.year() / today.month() + months{step}) / std::chrono::day{day};
            if (date.ok() && (!best || distance(date) < distance(*best))) best = date;
        }
        return *best;
    }

    // Epoch of a clock without a date.
    static constexpr std::chrono::sys_days unset{std::chrono::year{2000} / 1 / 1};

    address self_;
    duration offset_{};
    bool has_time_{};
    bool has_date_{};
};

} // namespace jauscat::jaus
