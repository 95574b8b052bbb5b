// The functions of component_clock.
#pragma once
#include <jauscat/jaus/component/component_clock.hpp>

namespace jauscat::jaus {

JAUSCAT_CONSTEXPR bool has_date_stamp(civil_time t) noexcept {
    using namespace std::chrono;
    const auto year = year_month_day{floor<days>(t)}.year();
    return year >= std::chrono::year{2000} && year <= std::chrono::year{2127};
}

JAUSCAT_CONSTEXPR report_time stamps_of(civil_time t) noexcept {
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

JAUSCAT_CONSTEXPR std::optional<duration> time_of_day(const time_stamp& s) noexcept {
    using namespace std::chrono;
    if (s.milliseconds > 999 || s.seconds > 59 || s.minutes > 59 || s.hours > 23) return std::nullopt;
    return hours{s.hours} + minutes{s.minutes} + seconds{s.seconds} + milliseconds{s.milliseconds};
}

JAUSCAT_CONSTEXPR std::optional<std::chrono::sys_days> date_of(const date_stamp& s) noexcept {
    using namespace std::chrono;
    const year_month_day date{year{2000 + s.year}, month{s.month}, day{s.day}};
    return date.ok() ? std::optional{sys_days{date}} : std::nullopt;
}

JAUSCAT_CONSTEXPR bool component_clock::set(civil_time time, time_point now) noexcept {
    if (!has_date_stamp(time)) return false;
    offset_ = time.time_since_epoch() - now.time_since_epoch();
    has_time_ = has_date_ = true;
    return true;
}

JAUSCAT_CONSTEXPR std::optional<civil_time> component_clock::time_at(time_point now) const noexcept {
    return has_time_ && has_date_ ? std::optional{running(now)} : std::nullopt;
}

JAUSCAT_CONSTEXPR report_time component_clock::report_at(time_point now) const noexcept {
    const civil_time time = running(now);
    report_time report = stamps_of(time);
    if (!has_time_) report.time_stamp.reset();
    if (!has_date_ || !has_date_stamp(time)) report.date_stamp.reset();
    return report;
}

JAUSCAT_CONSTEXPR message_outcome component_clock::on_message(const header& head, std::span<const std::byte> body,
                                                              time_point now, message_sink out) noexcept {
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

JAUSCAT_CONSTEXPR civil_time component_clock::running(time_point now) const noexcept {
    return civil_time{now.time_since_epoch() + offset_};
}

JAUSCAT_CONSTEXPR bool component_clock::set_from(const set_time& m, time_point now) noexcept {
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

JAUSCAT_CONSTEXPR std::chrono::sys_days component_clock::nearest(civil_time shown, duration time,
                                                                 std::uint8_t day) noexcept {
    using namespace std::chrono;
    const year_month_day today{floor<days>(shown)};
    const auto distance = [&](sys_days date) { return abs(date + time - shown); };
    std::optional<sys_days> best;
    for (const int step : {-2, -1, 0, 1, 2}) {
        const year_month_day date = (today.year() / today.month() + months{step}) / std::chrono::day{day};
        if (date.ok() && (!best || distance(date) < distance(*best))) best = date;
    }
    return *best;
}

} // namespace jauscat::jaus
