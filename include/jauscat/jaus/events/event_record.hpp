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
#include <jauscat/base/compilation.hpp>
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
JAUSCAT_CONSTEXPR void arm(event_record& e, const event_setup& setup, const eventful_report& report,
                           time_point now) noexcept;

/// Whether a change of its report to `body` triggers the event; keeps what is needed to judge the next one.
[[nodiscard]] JAUSCAT_CONSTEXPR bool triggers(event_record& e, const eventful_report& report,
                                              std::span<const std::byte> body) noexcept;

/// When the event is due; none where it waits for a change.
[[nodiscard]] JAUSCAT_CONSTEXPR std::optional<time_point> due_of(const event_record& e) noexcept;

/// Updates the event after it was `sent`, or skipped for lack of a report.
JAUSCAT_CONSTEXPR void note_sent(event_record& e, bool sent, time_point now) noexcept;

/// Whether the requester of both seems to have sent `later` instead of `earlier`: it has restarted and counts its
/// requests from the same number. `earlier` will then never be cancelled.
[[nodiscard]] JAUSCAT_CONSTEXPR bool supersedes(const event_record& later, const event_record& earlier) noexcept;

/// Whether a message that may name a report and an event means this one.
[[nodiscard]] JAUSCAT_CONSTEXPR bool is_selected(const event_record& e, std::optional<std::uint16_t> message_code,
                                                 std::optional<std::uint8_t> event_id) noexcept;

/// The event as Report Events lists it; points into `e`.
[[nodiscard]] JAUSCAT_CONSTEXPR reported_event as_reported(const event_record& e) noexcept;

} // namespace jauscat::jaus

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jaus/events/impl/event_record.ipp>
#endif
