// The functions of event_record.
#pragma once
#include <jauscat/jaus/events/event_record.hpp>

namespace jauscat::jaus {

JAUSCAT_CONSTEXPR void arm(event_record& e, const event_setup& setup, const eventful_report& report,
                           time_point now) noexcept {
    e.setup = setup;
    e.pending = is_periodic(setup.event_type);
    e.done = e.inside = false;
    e.last.reset();
    e.due = now;
    const double most = setup.rate != 0 ? setup.rate : report.max_rate;
    constexpr double lowest = 1e-9; // once in 31 years
    e.gap = is_on_change(setup.event_type) && most > 0 ? period_of(std::max(most, lowest)) : duration{};
    if (setup.min_rate != 0) e.silent_until = now + period_of(setup.min_rate);
}

JAUSCAT_CONSTEXPR bool triggers(event_record& e, const eventful_report& report,
                                std::span<const std::byte> body) noexcept {
    const event_condition& condition = e.setup.condition;
    if (!is_on_change(e.setup.event_type)) return e.setup.event_type != event_type::periodic;
    if (e.done) return false;
    if (!condition.field) return true;
    const auto value = report.read_field(body, *condition.field).value;
    if (!value) return false; // a report without the field does not count
    const bool is_new = std::exchange(e.last, value) != value;
    const bool meets = holds(condition, *value);
    if (e.setup.event_type == event_type::first_change_in_and_out_of_boundary)
        return std::exchange(e.inside, meets) != meets;
    return is_new && meets;
}

JAUSCAT_CONSTEXPR std::optional<time_point> due_of(const event_record& e) noexcept {
    if (e.message_code == 0 || e.done) return std::nullopt;
    std::optional<time_point> due;
    if (e.setup.event_type == event_type::periodic ||
        (e.pending && e.setup.event_type != event_type::one_time_on_demand))
        due = e.due;
    if (is_on_change(e.setup.event_type) && e.setup.min_rate != 0 && (!due || e.silent_until < *due))
        due = e.silent_until;
    return due;
}

JAUSCAT_CONSTEXPR void note_sent(event_record& e, bool sent, time_point now) noexcept {
    if (sent) {
        ++e.sequence_number;
        if (e.setup.event_type == event_type::one_time_on_demand) {
            e = {};
            return;
        }
        e.done = e.setup.event_type == event_type::first_change && e.pending;
    }
    if (is_periodic(e.setup.event_type)) {
        e.pending = e.pending && !sent; // with the next instant
        return;
    }
    e.pending = false;
    e.due = now + e.gap;
    if (e.setup.min_rate != 0) e.silent_until = now + period_of(e.setup.min_rate);
}

JAUSCAT_CONSTEXPR bool supersedes(const event_record& later, const event_record& earlier) noexcept {
    return later.message_code == earlier.message_code && later.requester == earlier.requester &&
           later.local_request_id == earlier.local_request_id && later.order > earlier.order;
}

JAUSCAT_CONSTEXPR bool is_selected(const event_record& e, std::optional<std::uint16_t> message_code,
                                   std::optional<std::uint8_t> event_id) noexcept {
    return e.message_code != 0 && message_code.value_or(e.message_code) == e.message_code &&
           event_id.value_or(e.event_id) == e.event_id;
}

JAUSCAT_CONSTEXPR reported_event as_reported(const event_record& e) noexcept {
    const event_condition& c = e.setup.condition;
    reported_event reported{.message_code = e.message_code,
                            .event_type = e.setup.event_type,
                            .event_boundary = c.boundary,
                            .limit_data_field = c.field,
                            .lower_limit = c.lower,
                            .upper_limit = c.upper,
                            .state_limit = c.state,
                            .event_id = e.event_id};
    if (!e.setup.query.empty()) reported.query_message = wire::blob{e.setup.query.begin(), e.setup.query.size()};
    return reported;
}

} // namespace jauscat::jaus
