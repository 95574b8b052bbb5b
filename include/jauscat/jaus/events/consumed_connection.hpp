// Service connection of a consumer: states, results, options.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/events/older_numbers.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/schema/jaus/core.hpp>

#include <chrono>

namespace jauscat::jaus {

enum class consumed_state : std::uint8_t {
    free,       ///< no connection
    asking,     ///< not confirmed yet; asked again at each interval
    active,     ///< confirmed, and reports come
    stale,      ///< no report for three periods; asked again at each interval
    suspended,  ///< by suspend()
    refused,    ///< by the provider, for the reason in `response`
    unanswered, ///< abandoned: no answer to the maximum number of requests
    ending,     ///< by end(); until the provider is silent
};

/// A service connection of a consumer.
struct consumed_connection {
    address provider{}; ///< provider of the reports
    consumed_state state{};
    std::uint8_t instance_id{};               ///< as confirmed
    service_connection_response response{};   ///< of the last confirmation
    bool confirmed{};                         ///< the instance ID is known
    bool heard{};                             ///< `sequence_number` is that of a report
    std::uint16_t sequence_number{};          ///< the highest so far
    older_numbers older{};                    ///< than that
    time_point anew_until{time_point::min()}; ///< until then, reports of an earlier count may be late
    create_service_connection request{};      ///< as requested
    double rate{};                            ///< hertz, as confirmed
    time_point due{};                         ///< when to ask again, notice the silence, or be done
    time_point asked_at{};                    ///< when a message was last sent to the provider
    std::uint32_t requests{};                 ///< that were not answered
    std::uint64_t received{};                 ///< reports in order
    std::uint64_t lost{};                     ///< reports missing between those in order
    std::uint64_t dropped{};                  ///< duplicate and out-of-order reports
};

/// Meaning of a message to a consumer.
enum class consumer_notice : std::uint8_t {
    unhandled,  ///< handled by other parts
    malformed,  ///< a confirmation that does not decode
    confirmed,  ///< the provider has accepted
    refused,    ///< the provider has not
    report,     ///< the body is the newest report of the connection
    old_report, ///< a duplicate or out-of-order report; ignore its body
    ignored,    ///< of a connection that is not wanted any more
};
/// The news, and the connection it is of.
struct consumer_outcome {
    consumer_notice what{};
    std::size_t place{};  ///< in connections()
    std::uint64_t lost{}; ///< reports missing just before this one
    friend constexpr bool operator==(const consumer_outcome&, const consumer_outcome&) = default;
};

struct consumer_options {
    /// Of a request that is not answered. A stale connection is requested again without limit.
    retry_policy retry{.interval = std::chrono::seconds{1}, .attempts = 5};
    unsigned silent_periods{3}; ///< without a report make a connection stale
};

} // namespace jauscat::jaus
