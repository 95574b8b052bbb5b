// Events, consumer side: requests with retries, received events matched with requests. RA 3.3 part 3, codes 01F0h to
// 01F4h and 41F1h. The provider side is events.hpp.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/jaus/events/requested_event.hpp>
#include <jauscat/jaus/message/stands_for.hpp>

namespace jauscat::jaus {

/// Requests events and matches received events with the requests. A stale event is requested again without limit, so
/// that it survives a restart of the provider or a link failure.
///
/// A periodic event is stale after three periods without one. For the others Query Events is sent after a timeout; the
/// event is stale when no answer lists it. Report Events does not name the requester of an event: an event of another
/// requester with the same report and ID counts as this one.
///
/// An event that was not requested is cancelled: it is from before a restart of this program. So a component has one
/// event_consumer.
template <std::size_t Capacity> class event_consumer {
  public:
    /// `silence`: without an event that is not periodic, before its provider is asked; duration::max() for a provider
    /// that does not answer Query Events.
    constexpr explicit event_consumer(const address& self,
                                      const retry_policy& retry = {.interval = std::chrono::seconds{1}, .attempts = 5},
                                      duration silence = std::chrono::seconds{5}) noexcept
        : self_{self}, retry_{retry}, silence_{silence} {}

    /// Sends `wanted`, with a local request ID assigned here. Returns the event's place in requested(); empty if all
    /// are in use, a rate rounds to 0 or the message cannot be made.
    [[nodiscard]] constexpr std::optional<std::size_t> create(const address& provider, create_event wanted,
                                                              time_point now, message_sink out) noexcept {
        const auto place = std::ranges::find_if(requested_, [](const requested_event& e) {
            return e.state == requested_state::free || e.state == requested_state::rejected ||
                   e.state == requested_state::unanswered;
        });
        if (place == requested_.end()) return std::nullopt;
        requested_event e{.provider = provider, .message_code = wanted.message_code};
        if (!keep(e, wanted)) return std::nullopt;
        *place = e;
        place->state = requested_state::asking;
        ask(*place, now, out);
        return static_cast<std::size_t>(place - requested_.begin());
    }
    /// Changes an active event to `wanted`, with a local request ID assigned here. A rejection leaves the event
    /// unchanged; without an answer its setup is unknown. False if the event is not active, and if `wanted` is of
    /// another report or cannot be sent.
    [[nodiscard]] constexpr bool update(std::size_t place, create_event wanted, time_point now,
                                        message_sink out) noexcept {
        if (place >= Capacity || requested_[place].state != requested_state::active) return false;
        requested_event e = requested_[place];
        if (wanted.message_code != e.message_code || !keep(e, wanted)) return false;
        requested_[place] = e;
        requested_[place].state = requested_state::updating;
        ask(requested_[place], now, out);
        return true;
    }
    /// Cancels an event. Its place is free when the provider has answered, or has not often enough.
    constexpr void cancel(std::size_t place, time_point now, message_sink out) noexcept {
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

    /// Handles Confirm and Reject Event Request, and Event. Reads Report Events, and returns unhandled for it.
    constexpr event_outcome on_message(const header& head, std::span<const std::byte> body, time_point now,
                                       message_sink out) noexcept {
        event_outcome outcome{};
        if (is_acknowledgement(head)) return outcome;
        const auto decoded_by = [&]<class T>(T message, auto handle) {
            if (wire::decode(message, body))
                handle(message);
            else
                outcome.what = event_notice::malformed;
            return outcome;
        };
        switch (head.command_code) {
        case command_code_of<confirm_event_request>:
            return decoded_by(confirm_event_request{}, [&](const confirm_event_request& m) {
                answered(head.source, m.local_request_id, outcome, [&](requested_event& e) {
                    e.response = m.response_code;
                    e.heard = e.heard && e.event_id == m.event_id;
                    if (e.state == requested_state::stale) e.older.may_begin_anew();
                    e.event_id = m.event_id;
                    e.rate = m.confirmed_periodic_rate.value_or(0);
                    confirmed(e, outcome, now, out);
                });
            });
        case command_code_of<reject_event_request>:
            return decoded_by(reject_event_request{}, [&](const reject_event_request& m) {
                answered(head.source, m.local_request_id, outcome, [&](requested_event& e) {
                    const bool gone = e.state == requested_state::cancelling;
                    outcome.what = gone ? event_notice::cancelled : event_notice::rejected;
                    e.response = m.response_code;
                    e.confirmed = e.confirmed && e.state != requested_state::stale;
                    e.requests = 0;
                    e.state = requested_state::rejected;
                    if (gone)
                        e = {};
                    else if (e.confirmed) // an update
                        restore(e, now);
                });
            });
        case command_code_of<event>:
            return decoded_by(event{}, [&](const event& m) { heard(head.source, m, outcome, now, out); });
        case command_code_of<report_events>: listed(head.source, body, now); return outcome;
        default: return outcome;
        }
    }

    /// Repeats requests and detects timeouts.
    constexpr void on_time(time_point now, message_sink out) noexcept {
        for (requested_event& e : requested_) {
            if (!has_due(e) || e.due > now) continue;
            if (e.state == requested_state::active && !comes_at_rate(e) && retry_.allows_another(e.requests)) {
                query(e, now, out);
                continue;
            }
            if (e.state == requested_state::active) e.state = requested_state::stale;
            if (e.state == requested_state::stale || retry_.allows_another(e.requests))
                ask(e, now, out);
            else if (e.state == requested_state::asking)
                e.state = requested_state::unanswered;
            else if (e.state == requested_state::updating)
                activate(e, now);
            else
                e = {};
        }
    }
    /// When on_time has something to do.
    [[nodiscard]] constexpr std::optional<time_point> next_event() const noexcept {
        std::optional<time_point> next;
        for (const requested_event& e : requested_)
            if (has_due(e) && (!next || e.due < *next)) next = e.due;
        return next;
    }

    /// Drops the events of lost providers, see stands_for. Returns their number.
    constexpr std::size_t on_lost(const address& provider) noexcept {
        std::size_t count = 0;
        for (requested_event& e : requested_) {
            if ((!waits(e) && e.state != requested_state::active) || !stands_for(provider, e.provider)) continue;
            if (e.state == requested_state::cancelling)
                e = {};
            else
                e.state = requested_state::unanswered;
            ++count;
        }
        return count;
    }

    /// All places, free ones too.
    [[nodiscard]] constexpr std::span<const requested_event> requested() const noexcept { return requested_; }

  private:
    [[nodiscard]] static constexpr bool waits(const requested_event& e) noexcept {
        return e.state == requested_state::asking || e.state == requested_state::updating ||
               e.state == requested_state::cancelling || e.state == requested_state::stale;
    }
    static constexpr auto never = time_point::max();

    [[nodiscard]] static constexpr bool has_due(const requested_event& e) noexcept {
        return waits(e) || (e.state == requested_state::active && e.due != never);
    }
    [[nodiscard]] static constexpr bool comes_at_rate(const requested_event& e) noexcept {
        return e.type == event_type::periodic && e.rate > 0;
    }
    constexpr void activate(requested_event& e, time_point now) const noexcept {
        constexpr int silent_periods = 3;
        e.state = requested_state::active;
        e.due = saturating_add(now, comes_at_rate(e) ? silent_periods * period_of(e.rate) : silence_);
    }
    constexpr void restore(requested_event& e, time_point now) const noexcept {
        e.request = e.accepted;
        const auto holds = setup_of(e);
        e.type = holds.event_type;
        e.local_request_id = holds.local_request_id;
        activate(e, now);
    }
    [[nodiscard]] static constexpr create_event setup_of(const requested_event& e) noexcept {
        create_event setup{};
        static_cast<void>(wire::decode(setup, std::span<const std::byte>{e.request.begin(), e.request.size()}));
        return setup;
    }
    // A late confirmation also makes an event at the provider, which must be cancelled.
    [[nodiscard]] static constexpr bool may_be_answered(const requested_event& e) noexcept {
        return waits(e) || (e.state == requested_state::unanswered && !e.confirmed);
    }
    constexpr bool keep(requested_event& e, create_event& wanted) noexcept {
        wanted.local_request_id = e.local_request_id = ++last_id_;
        e.type = wanted.event_type;
        e.requests = 0;
        const auto rounds_to_0 = [](const std::optional<double>& rate) {
            return rate && *rate != 0 && sayable_rate(*rate, update_rate::max) == 0;
        };
        if (rounds_to_0(wanted.requested_periodic_rate) || rounds_to_0(wanted.requested_minimum_periodic_rate))
            return false;
        if (!e.request.resize(max_create_event_size)) return false;
        const auto encoded = wire::encode(wanted, std::span{e.request.begin(), e.request.size()});
        return encoded && e.request.resize(encoded->size());
    }
    // A cancel before the ID is known repeats the request, and the answer has the ID.
    constexpr void ask(requested_event& e, time_point now, message_sink out) noexcept {
        const auto wanted = setup_of(e);
        if (!e.confirmed || e.state == requested_state::stale)
            send(e, wanted, out);
        else if (e.state == requested_state::updating)
            send(e, as_update(wanted, e.event_id), out);
        else
            send(e,
                 cancel_event{
                     .local_request_id = e.local_request_id, .message_code = e.message_code, .event_id = e.event_id},
                 out);
        ++e.requests;
        e.due = saturating_add(now, retry_.interval);
    }
    constexpr void query(requested_event& e, time_point now, message_sink out) noexcept {
        send(e, query_events{.message_code = e.message_code, .event_id = e.event_id}, out);
        ++e.requests;
        e.due = saturating_add(now, retry_.interval);
    }
    // A list without an event may answer another query, so it proves nothing about this event.
    constexpr void listed(const address& source, std::span<const std::byte> body, time_point now) noexcept {
        const wire::view<report_events> report{body};
        if (!report) return;
        for (const auto reported : report.template get<&report_events::event>()) {
            const auto code = reported.template get<&reported_event::message_code>();
            const auto id = reported.template get<&reported_event::event_id>();
            for (requested_event& e : requested_) {
                if (e.state != requested_state::active || comes_at_rate(e) || e.requests == 0) continue;
                if (e.provider != source || e.message_code != code || e.event_id != id) continue;
                e.requests = 0;
                activate(e, now);
            }
        }
    }
    template <coded_message T> constexpr void send(const requested_event& e, const T& body, message_sink out) noexcept {
        std::array<std::byte, header_size + max_create_event_size + 1> bytes{}; // Update Event has one more: the ID
        const header head{.destination = e.provider, .source = self_};
        if (const auto message = make_message(head, body, bytes)) out(*message);
    }
    constexpr void answered(const address& source, std::uint8_t id, event_outcome& outcome, auto handle) noexcept {
        const auto e = std::ranges::find_if(requested_, [&](const requested_event& r) {
            return may_be_answered(r) && r.provider == source && r.local_request_id == id;
        });
        if (e == requested_.end()) {
            outcome.what = event_notice::unknown;
            return;
        }
        outcome.place = static_cast<std::size_t>(e - requested_.begin());
        handle(*e);
    }
    constexpr void confirmed(requested_event& e, event_outcome& outcome, time_point now, message_sink out) noexcept {
        e.requests = 0;
        if (e.state != requested_state::cancelling && e.state != requested_state::unanswered) {
            e.confirmed = true;
            e.accepted = e.request;
            activate(e, now);
            outcome.what = event_notice::confirmed;
        } else if (e.confirmed) {
            e = {};
            outcome.what = event_notice::cancelled;
        } else { // cancelled before its ID was known, or abandoned
            e.confirmed = true;
            e.state = requested_state::cancelling;
            e.local_request_id = ++last_id_;
            ask(e, now, out);
            outcome.what = event_notice::confirmed;
        }
    }
    constexpr void heard(const address& source, const event& m, event_outcome& outcome, time_point now,
                         message_sink out) noexcept {
        outcome.message_code = m.message_code;
        outcome.report = m.report_message_body;
        const auto e = std::ranges::find_if(requested_, [&](const requested_event& r) {
            return (r.state == requested_state::active || r.state == requested_state::updating ||
                    r.state == requested_state::stale) &&
                   r.event_id == m.event_id && r.message_code == m.message_code && r.provider == source;
        });
        if (e == requested_.end()) {
            outcome.what = event_notice::unknown;
            cancel_unknown(source, m, now, out);
            return;
        }
        outcome.place = static_cast<std::size_t>(e - requested_.begin());
        const auto ahead = static_cast<std::uint8_t>(m.event_sequence_number - e->sequence_number);
        const bool is_newer = ahead != 0 && ahead < 128;
        // 8 bits say nothing about a gap of 128 events and more. After a pause, no event is late by more than 64; one
        // with the number of the last is a copy of it, or newer.
        const bool has_paused = now - e->heard_at >= retry_.interval;
        const bool is_after_gap = has_paused && (ahead == 0 || (ahead >= 128 && ahead < 192));
        if (e->heard && !is_newer && !is_after_gap &&
            !e->older.begins_anew(m.event_sequence_number, static_cast<std::uint8_t>(-ahead))) {
            outcome.what = event_notice::repeated;
            return;
        }
        e->older = {};
        outcome.what = event_notice::event;
        outcome.lost = e->heard && is_newer ? ahead - 1u : 0;
        e->heard = true;
        e->heard_at = now;
        if (e->state != requested_state::updating) {
            e->requests = 0;
            activate(*e, now);
            if (e->type == event_type::first_change) e->due = never; // no other follows
        }
        e->sequence_number = m.event_sequence_number;
        ++e->received;
        e->lost += outcome.lost;
        if (e->type == event_type::one_time_on_demand) *e = {};
    }

    // Not while an answer may tell of it, and not again until there was time for an answer.
    constexpr void cancel_unknown(const address& source, const event& m, time_point now, message_sink out) noexcept {
        const bool may_become_known = std::ranges::any_of(requested_, [&](const requested_event& e) {
            return may_be_answered(e) && e.provider == source && e.message_code == m.message_code;
        });
        const bool is_cancelled = unwanted_.provider == source && unwanted_.message_code == m.message_code &&
                                  unwanted_.event_id == m.event_id && now < unwanted_.due;
        if (may_become_known || is_cancelled) return;
        unwanted_ = {.provider = source,
                     .message_code = m.message_code,
                     .local_request_id = ++last_id_,
                     .event_id = m.event_id,
                     .due = saturating_add(now, retry_.interval)};
        send(unwanted_,
             cancel_event{.local_request_id = last_id_, .message_code = m.message_code, .event_id = m.event_id}, out);
    }

    address self_;
    retry_policy retry_;
    duration silence_;
    std::array<requested_event, Capacity> requested_{};
    requested_event unwanted_{}; ///< cancelled last, without a request
    std::uint8_t last_id_{};
};

} // namespace jauscat::jaus
