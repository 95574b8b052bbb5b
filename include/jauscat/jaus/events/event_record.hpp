// One event of a provider: what triggers it, and when it is due. The RA only names the types; here they are
// - periodic: at the confirmed rate, the first at once, on absolute instants; a late one is sent once.
// - periodic_without_repeat: the same, but only after a change since the last one.
// - every_change: with each change, or each new value of the limited field; with a boundary, while that is met.
// - first_change: the first of these, then nothing until Update Event.
// - first_change_in_and_out_of_boundary: whenever a value meets the boundary and the one before did not, or reverse.
// - one_time_on_demand: at once, and the event is over; without a report to send, with the first change. Events on
//   change are limited to the requested periodic rate, or to the report's highest; the newest report is then sent. A
//   minimum periodic rate also sends them without a change. Boundaries are ignored in the other types.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/events/event_setup.hpp>

namespace jauscat::jaus {

/// An event of a provider.
struct event_record {
    address requester{};               ///< the consumer
    std::uint16_t message_code{};      ///< of the report; 0: no event
    std::uint8_t event_id{};           ///< 1 to 255
    std::uint8_t local_request_id{};   ///< of the last request for it
    std::uint8_t priority{};           ///< of that request, and of the events
    std::uint8_t sequence_number{};    ///< of the next one
    std::uint32_t order{};             ///< increases with each request
    event_setup setup{};               ///< the requested setup
    bool pending{};                    ///< to be sent as soon as the rate allows
    bool done{};                       ///< a first change that has been
    bool inside{};                     ///< the boundary, by the last value
    std::optional<field_value> last{}; ///< of the limited field
    time_point due{};                  ///< of periodic ones the next instant, of others the earliest
    duration gap{};                    ///< between two that are sent on change, at least
    time_point silent_until{};         ///< with a minimum rate: when the next is sent without a change
};

/// Restarts the event with `setup`; ID and sequence number are kept.
constexpr void arm(event_record& e, const event_setup& setup, const eventful_report& report, time_point now) noexcept {
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

/// Whether a change of its report to `body` triggers the event; keeps what is needed to judge the next one.
[[nodiscard]] constexpr bool triggers(event_record& e, const eventful_report& report,
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

/// When the event is due; none where it waits for a change.
[[nodiscard]] constexpr std::optional<time_point> due_of(const event_record& e) noexcept {
    if (e.message_code == 0 || e.done) return std::nullopt;
    std::optional<time_point> due;
    if (e.setup.event_type == event_type::periodic ||
        (e.pending && e.setup.event_type != event_type::one_time_on_demand))
        due = e.due;
    if (is_on_change(e.setup.event_type) && e.setup.min_rate != 0 && (!due || e.silent_until < *due))
        due = e.silent_until;
    return due;
}

/// Updates the event after it was `sent`, or skipped for lack of a report.
constexpr void note_sent(event_record& e, bool sent, time_point now) noexcept {
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

/// Whether the requester of both seems to have sent `later` instead of `earlier`: it has restarted and counts its
/// requests from the same number. `earlier` will then never be cancelled.
[[nodiscard]] constexpr bool supersedes(const event_record& later, const event_record& earlier) noexcept {
    return later.message_code == earlier.message_code && later.requester == earlier.requester &&
           later.local_request_id == earlier.local_request_id && later.order > earlier.order;
}

/// Whether a message that may name a report and an event means this one.
[[nodiscard]] constexpr bool is_selected(const event_record& e, std::optional<std::uint16_t> message_code,
                                         std::optional<std::uint8_t> event_id) noexcept {
    return e.message_code != 0 && message_code.value_or(e.message_code) == e.message_code &&
           event_id.value_or(e.event_id) == e.event_id;
}

/// The event as Report Events lists it; points into `e`.
[[nodiscard]] constexpr reported_event as_reported(const event_record& e) noexcept {
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
