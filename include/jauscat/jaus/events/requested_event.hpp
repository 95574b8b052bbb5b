// Event of a consumer: states, results.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/events/event_setup.hpp>
#include <jauscat/jaus/events/older_numbers.hpp>

namespace jauscat::jaus {

enum class requested_state : std::uint8_t {
    free,       ///< no event
    asking,     ///< not answered yet; asked again at each interval
    active,     ///< confirmed
    stale,      ///< the provider is silent, or has not the event any more; asked for again at each interval
    updating,   ///< by update(), not answered yet; until then the old or the new setup applies
    rejected,   ///< by the provider, for the reason in `response`
    unanswered, ///< abandoned: no answer to the maximum number of requests, or the provider is lost
    cancelling, ///< by cancel(); until the provider has answered, or as many cancels were not
};

/// Bytes of a Create Event with the largest query, max_event_query.
inline constexpr std::size_t max_create_event_size = 42 + max_event_query;

/// An event of a consumer.
struct requested_event {
    address provider{}; ///< provider of the events
    requested_state state{};
    event_response response{};       ///< of the last answer
    std::uint16_t message_code{};    ///< of the report
    event_type type{};               ///< what triggers it
    bool confirmed{};                ///< the event ID is known
    bool heard{};                    ///< `sequence_number` is that of an event
    std::uint8_t local_request_id{}; ///< of the request that waits for an answer
    std::uint8_t event_id{};         ///< as confirmed
    std::uint8_t sequence_number{};  ///< of the last event
    double rate{};                   ///< hertz, as confirmed; 0: none was
    time_point due{};                ///< when to ask again, or notice the silence
    older_numbers older{};           ///< than `sequence_number`
    time_point heard_at{};           ///< time of the last event
    std::uint32_t requests{};        ///< that were not answered
    std::uint64_t received{};        ///< events
    std::uint64_t lost{};            ///< events missing between those, as far as 8 bits can count
    wire::inline_list<std::byte, max_create_event_size>
        request{}; ///< the body of Create Event, or what Update Event has
    wire::inline_list<std::byte, max_create_event_size>
        accepted{}; ///< the one that was confirmed last; it holds again after a rejected update
};

/// Meaning of a message to an event consumer.
enum class event_notice : std::uint8_t {
    unhandled, ///< handled by other parts
    malformed, ///< one of its messages that does not decode
    confirmed, ///< the provider has accepted
    rejected,  ///< the provider has not
    cancelled, ///< the event is gone
    event,     ///< `report` is the body of a report
    repeated,  ///< a duplicate or out-of-order event
    unknown,   ///< an event that was not requested, or an answer to no request
};
struct event_outcome {
    event_notice what{};
    std::size_t place{};                 ///< in requested()
    unsigned lost{};                     ///< events missing just before this one
    std::uint16_t message_code{};        ///< of the report in an event
    std::span<const std::byte> report{}; ///< its body, in the message
};

/// The Update Event that sets an event up like a Create Event.
[[nodiscard]] JAUSCAT_CONSTEXPR update_event as_update(const create_event& m, std::uint8_t event_id) noexcept;

} // namespace jauscat::jaus

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jaus/events/impl/requested_event.ipp>
#endif
