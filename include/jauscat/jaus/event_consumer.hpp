// Events, the side that asks: requests repeated until they are answered, and events matched with what was asked for. RA
// 3.3 part 3, codes 01F0h to 01F4h and 41F1h. The side that reports is events.hpp.
#pragma once
#include <jauscat/jaus/answer.hpp>
#include <jauscat/jaus/event_setup.hpp>

#include <chrono>

namespace jauscat::jaus {

/// Where a requested event stands.
enum class requested_state : std::uint8_t {
    free,       ///< no event
    asking,     ///< not answered yet; asked again at each patience
    active,     ///< confirmed
    rejected,   ///< by the provider, for the reason in `response`
    unanswered, ///< given up: no answer to as many requests as were to be made
    cancelling, ///< by cancel(); until the provider has answered, or as many cancels were not
};

/// Bytes of a Create Event whose query has max_event_query.
inline constexpr std::size_t max_create_event_size = 42 + max_event_query;

/// An event of a consumer.
struct requested_event {
    address provider{};
    requested_state state{};
    event_response response{};       ///< of the last answer
    std::uint16_t message_code{};    ///< of the report
    bool one_time{};                 ///< is over with the first event
    bool confirmed{};                ///< the event ID is known
    bool heard{};                    ///< `sequence_number` is that of an event
    std::uint8_t local_request_id{}; ///< of the request that waits for an answer
    std::uint8_t event_id{};         ///< as confirmed
    std::uint8_t sequence_number{};  ///< of the last event
    double rate{};                   ///< hertz, as confirmed; 0: none was
    std::chrono::nanoseconds due{};  ///< when to ask again
    unsigned requests{};             ///< that were not answered
    std::uint64_t received{};        ///< events
    std::uint64_t lost{};            ///< events missing between those, as far as 8 bits can count
    wire::inline_list<std::byte, max_create_event_size> request{}; ///< the body of Create Event
};

/// What a message was to a consumer of events.
enum class event_news : std::uint8_t {
    not_mine,  ///< another's business
    malformed, ///< one of its messages that does not decode
    confirmed, ///< the provider has accepted
    rejected,  ///< the provider has not
    cancelled, ///< the event is gone
    event,     ///< `report` is the body of a report
    repeated,  ///< an event that came before, or after a later one
    unknown,   ///< an event that was not asked for, or answers a request that was not made
};
/// The news, and the event it is of.
struct event_outcome {
    event_news what{};
    std::size_t place{};                 ///< in requested()
    unsigned lost{};                     ///< events missing just before this one
    std::uint16_t message_code{};        ///< of the report in an event
    std::span<const std::byte> report{}; ///< its body, in the message
};

/// Asks for events and matches what comes with what was asked for.
template <std::size_t Capacity> class event_consumer {
  public:
    /// `patience`: between requests that are not answered; `requests`: how many of those.
    constexpr explicit event_consumer(const address& self, std::chrono::nanoseconds patience = std::chrono::seconds{1},
                                      unsigned requests = 5) noexcept
        : self_{self}, patience_{patience}, most_requests_{requests} {}

    /// Sends `wanted`, whose local request ID is replaced. Returns the event's place in requested(); none where all are
    /// taken or the message cannot be made.
    constexpr std::optional<std::size_t> create(const address& provider, create_event wanted,
                                                std::chrono::nanoseconds now, message_sink out) noexcept {
        const auto place = std::ranges::find_if(requested_, [](const requested_event& e) {
            return e.state == requested_state::free || e.state == requested_state::rejected ||
                   e.state == requested_state::unanswered;
        });
        if (place == requested_.end()) return std::nullopt;
        requested_event e{.provider = provider,
                          .state = requested_state::asking,
                          .message_code = wanted.message_code,
                          .one_time = wanted.event_type == event_type::one_time_on_demand,
                          .local_request_id = wanted.local_request_id = ++last_id_};
        e.request.resize(max_create_event_size);
        const auto size = wire::encode(wanted, std::span{e.request.begin(), e.request.size()});
        if (!size) return std::nullopt;
        e.request.resize(size.size());
        *place = e;
        ask(*place, now, out);
        return static_cast<std::size_t>(place - requested_.begin());
    }
    /// Cancels an event. Its place is free when the provider has answered, or has not often enough.
    constexpr void cancel(std::size_t place, std::chrono::nanoseconds now, message_sink out) noexcept {
        if (place >= Capacity || requested_[place].state == requested_state::free) return;
        requested_event& e = requested_[place];
        if (!e.confirmed && e.state != requested_state::asking) {
            e = {};
            return;
        }
        e.state = requested_state::cancelling;
        e.requests = 0;
        if (e.confirmed) e.local_request_id = ++last_id_;
        ask(e, now, out);
    }

    /// Takes Confirm and Reject Event Request, and Event.
    constexpr event_outcome on_message(const header& head, std::span<const std::byte> body,
                                       std::chrono::nanoseconds now, message_sink out) noexcept {
        event_outcome outcome{};
        if (is_acknowledgement(head)) return outcome;
        const auto decoded_by = [&]<class T>(T message, auto handle) {
            if (wire::decode(message, body))
                handle(message);
            else
                outcome.what = event_news::malformed;
            return outcome;
        };
        switch (head.command_code) {
        case confirm_event_request::command_code:
            return decoded_by(confirm_event_request{}, [&](const confirm_event_request& m) {
                answered(head.source, m.local_request_id, outcome, [&](requested_event& e) {
                    e.response = m.response_code;
                    e.event_id = m.event_id;
                    e.rate = m.confirmed_periodic_rate.value_or(0);
                    confirmed(e, outcome, now, out);
                });
            });
        case reject_event_request::command_code:
            return decoded_by(reject_event_request{}, [&](const reject_event_request& m) {
                answered(head.source, m.local_request_id, outcome, [&](requested_event& e) {
                    const bool gone = e.state == requested_state::cancelling;
                    outcome.what = gone ? event_news::cancelled : event_news::rejected;
                    e.response = m.response_code;
                    e.state = requested_state::rejected;
                    if (gone) e = {};
                });
            });
        case event::command_code: return decoded_by(event{}, [&](const event& m) { heard(head.source, m, outcome); });
        default: return outcome;
        }
    }

    /// Asks again.
    constexpr void on_time(std::chrono::nanoseconds now, message_sink out) noexcept {
        for (requested_event& e : requested_) {
            if (!waits(e) || e.due > now) continue;
            if (e.requests < most_requests_)
                ask(e, now, out);
            else if (e.state == requested_state::asking)
                e.state = requested_state::unanswered;
            else
                e = {};
        }
    }
    /// When on_time has something to do.
    [[nodiscard]] constexpr std::optional<std::chrono::nanoseconds> next_event() const noexcept {
        std::optional<std::chrono::nanoseconds> next;
        for (const requested_event& e : requested_)
            if (waits(e) && (!next || e.due < *next)) next = e.due;
        return next;
    }

    [[nodiscard]] constexpr std::span<const requested_event> requested() const noexcept { return requested_; }

  private:
    [[nodiscard]] static constexpr bool waits(const requested_event& e) noexcept {
        return e.state == requested_state::asking || e.state == requested_state::cancelling;
    }
    // Until the ID is known there is nothing to cancel by, so the request is made once more: the provider knows it.
    constexpr void ask(requested_event& e, std::chrono::nanoseconds now, message_sink out) noexcept {
        const header head{.destination = e.provider, .source = self_};
        if (e.confirmed) {
            put(head,
                cancel_event{
                    .local_request_id = e.local_request_id, .message_code = e.message_code, .event_id = e.event_id},
                out);
        } else {
            std::array<std::byte, header_size + max_create_event_size> bytes{};
            create_event wanted{};
            static_cast<void>(wire::decode(wanted, std::span{e.request.begin(), e.request.size()}));
            if (const result size = make_message(head, wanted, bytes)) out(std::span{bytes}.first(size.size()));
        }
        ++e.requests;
        e.due = now + patience_;
    }
    constexpr void answered(const address& source, std::uint8_t id, event_outcome& outcome, auto handle) noexcept {
        const auto e = std::ranges::find_if(requested_, [&](const requested_event& r) {
            return waits(r) && r.provider == source && r.local_request_id == id;
        });
        if (e == requested_.end()) {
            outcome.what = event_news::unknown;
            return;
        }
        outcome.place = static_cast<std::size_t>(e - requested_.begin());
        handle(*e);
    }
    constexpr void confirmed(requested_event& e, event_outcome& outcome, std::chrono::nanoseconds now,
                             message_sink out) noexcept {
        e.requests = 0;
        if (e.state == requested_state::asking) {
            e.confirmed = true;
            e.state = requested_state::active;
            outcome.what = event_news::confirmed;
        } else if (e.confirmed) {
            e = {};
            outcome.what = event_news::cancelled;
        } else { // cancelled before its ID was known
            e.confirmed = true;
            e.local_request_id = ++last_id_;
            ask(e, now, out);
            outcome.what = event_news::confirmed;
        }
    }
    constexpr void heard(const address& source, const event& m, event_outcome& outcome) noexcept {
        outcome.message_code = m.message_code;
        outcome.report = m.report_message_body;
        const auto e = std::ranges::find_if(requested_, [&](const requested_event& r) {
            return r.state == requested_state::active && r.event_id == m.event_id && r.message_code == m.message_code &&
                   r.provider == source;
        });
        if (e == requested_.end()) {
            outcome.what = event_news::unknown;
            return;
        }
        outcome.place = static_cast<std::size_t>(e - requested_.begin());
        const auto ahead = static_cast<std::uint8_t>(m.event_sequence_number - e->sequence_number);
        if (e->heard && (ahead == 0 || ahead >= 128)) {
            outcome.what = event_news::repeated;
            return;
        }
        outcome.what = event_news::event;
        outcome.lost = e->heard ? ahead - 1u : 0;
        e->heard = true;
        e->sequence_number = m.event_sequence_number;
        ++e->received;
        e->lost += outcome.lost;
        if (e->one_time) *e = {};
    }

    address self_;
    std::chrono::nanoseconds patience_;
    unsigned most_requests_;
    std::array<requested_event, Capacity> requested_{};
    std::uint8_t last_id_{};
};

} // namespace jauscat::jaus
