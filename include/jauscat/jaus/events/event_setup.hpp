// Parameters of an event, and the check of a request. RA 3.3 part 3, Create Event.
#pragma once
#include <jauscat/jaus/events/event_condition.hpp>
#include <jauscat/jaus/events/update_rate.hpp>
#include <jauscat/jaus/message/hook.hpp>
#include <jauscat/jaus/message/message.hpp>

namespace jauscat::jaus {

/// Bytes of query message that an event may have. Queries of RA 3.3 for reports that change have at most 12.
inline constexpr std::size_t max_event_query = 24;

/// A report that there may be events of.
struct eventful_report {
    std::uint16_t command_code{};      ///< of the report
    field_reader read_field{};         ///< &read_field<Report>; null: its events have no boundaries
    double max_rate{update_rate::max}; ///< hertz; more events a second than this are not sent
    bool periodic{true};               ///< may be sent periodically
    bool on_change{true};              ///< changes are reported to events, so it may be sent on change
};

/// Writes the body of report `command_code` to the front of `body` and returns its size; nothing where there is nothing
/// to report now. `query`: the body of the query for it, which selects its fields; empty: all of them.
using event_filler = hook<std::optional<std::size_t>(std::uint16_t command_code, std::span<const std::byte> query,
                                                     std::span<std::byte> body)>;
/// Whether a component may have an event: successful, or the reason why not, for example connection_refused.
using event_policy = hook<event_response(const header&, std::uint16_t message_code)>;

/// Parameters of an event.
struct event_setup {
    jaus::event_type event_type{};                         ///< when it is sent
    event_condition condition{};                           ///< which values count
    double min_rate{};                                     ///< hertz; 0: not requested
    double rate{};                                         ///< hertz; 0: not requested
    wire::inline_list<std::byte, max_event_query> query{}; ///< body of the query that selects fields
    friend constexpr bool operator==(const event_setup&, const event_setup&) = default;
};

/// The types that are sent at fixed times, with any content of the report.
[[nodiscard]] constexpr bool is_periodic(event_type type) noexcept {
    return type == event_type::periodic || type == event_type::periodic_without_repeat;
}
/// The types that are sent on conditions of the report.
[[nodiscard]] constexpr bool is_on_change(event_type type) noexcept {
    return type == event_type::every_change || type == event_type::first_change ||
           type == event_type::first_change_in_and_out_of_boundary;
}

/// A checked request: a setup, or the reason for a refusal.
struct checked_setup {
    event_setup setup{};              ///< only where the response is successful
    event_response response{};        ///< successful, or the code to reject with
    std::string_view error_message{}; ///< the reason in words
};

/// Checks a Create Event or Update Event for the report `of`; null: no such report.
template <class Request>
[[nodiscard]] constexpr checked_setup check_setup(const Request& request, const eventful_report* of) noexcept {
    using enum event_response;
    if (of == nullptr) return {.response = message_not_supported, .error_message = "no events of this message"};
    checked_setup checked{.setup = {.event_type = request.event_type,
                                    .condition = {.boundary = request.event_boundary,
                                                  .field = request.limit_data_field,
                                                  .lower = request.lower_limit,
                                                  .upper = request.upper_limit,
                                                  .state = request.state_limit},
                                    .min_rate = request.requested_minimum_periodic_rate.value_or(0),
                                    .rate = request.requested_periodic_rate.value_or(0)}};
    event_setup& setup = checked.setup;
    const auto reject = [&](event_response why, std::string_view text) {
        checked.response = why;
        checked.error_message = text;
        return checked;
    };
    const auto query = request.query_message_body.value_or(wire::blob{});
    if (!setup.query.resize(query.size())) return reject(invalid_event_setup, "the query message is too long");
    std::ranges::copy(query, setup.query.begin());

    if (setup.event_type > event_type::one_time_on_demand) return reject(invalid_event_setup, "unknown event type");
    for (const auto* const limit : {&setup.condition.lower, &setup.condition.upper, &setup.condition.state})
        if (*limit && is_nan(**limit)) return reject(invalid_event_setup, "a limit is not a number");
    if (is_periodic(setup.event_type)) {
        if (!of->periodic) return reject(periodic_events_not_supported, "no periodic events of this message");
        setup.rate = sayable_rate(setup.rate, of->max_rate);
        if (setup.rate == 0) return reject(invalid_event_setup, "a periodic event needs a rate");
    }
    if (setup.event_type == event_type::periodic_without_repeat || is_on_change(setup.event_type)) {
        if (!of->on_change) return reject(change_based_events_not_supported, "changes of this message are not known");
    }
    if (is_on_change(setup.event_type)) {
        setup.rate = sayable_rate(setup.rate, of->max_rate);
        setup.min_rate = sayable_rate(setup.min_rate, of->max_rate);
        if (setup.rate == 0 && request.requested_periodic_rate.value_or(0) != 0)
            return reject(invalid_event_setup, "the rate rounds to 0");
        const event_condition& condition = setup.condition;
        if (!condition.boundary && setup.event_type == event_type::first_change_in_and_out_of_boundary)
            return reject(invalid_event_setup, "the event type needs a boundary");
        if (!is_complete(condition))
            return reject(invalid_event_setup, "the boundary lacks its field or limits, or these are no numbers");
        if (condition.field && (of->read_field == nullptr || !of->read_field({}, *condition.field).exists))
            return reject(invalid_event_setup, "the field cannot be limited");
    }
    return checked;
}

} // namespace jauscat::jaus
