// Service connections, consumer side: requests with retries, sequence numbers of reports, timeouts. RA 3.3 part 3,
// codes 0008h to 000Ch. The provider side is service_connections.hpp.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/jaus/events/consumed_connection.hpp>
#include <jauscat/jaus/events/update_rate.hpp>
#include <jauscat/jaus/message/hook.hpp>

#include <optional>

namespace jauscat::jaus {

/// Requests reports and counts them: one connection for each provider and report code, because a report's header names
/// no connection. A stale connection is requested again without limit, so that it survives a restart of the provider or
/// a link failure.
template <std::size_t Capacity> class service_consumer {
  public:
    /// `changed` is called with each new state of a connection; it must outlive this object.
    constexpr explicit service_consumer(const address& self, consumer_options options = {},
                                        hook<void(const consumed_connection&)> changed = {}) noexcept
        : self_{self}, options_{options}, changed_{changed} {}

    /// Requests report `code` from `provider` at `rate` hertz (at most 1092) with the fields of `presence_vector`, or
    /// changes the existing connection: if the provider refuses that, the connection ends. Returns its place in
    /// connections(); empty if all are in use, or the rate cannot be encoded.
    [[nodiscard]] constexpr std::optional<std::size_t> ask(const address& provider, std::uint16_t code, double rate,
                                                           std::uint32_t presence_vector, time_point now,
                                                           message_sink out) noexcept {
        if (sayable_rate(rate, update_rate::max) == 0 || rate > update_rate::max) return std::nullopt;
        consumed_connection* c = find(provider, code);
        const consumed_connection before = c == nullptr ? consumed_connection{} : *c;
        if (c == nullptr) c = free_place();
        if (c == nullptr) return std::nullopt;
        *c = {.provider = provider,
              .instance_id = before.instance_id,
              .confirmed = before.confirmed,
              .request = {.command_code = code,
                          .requested_periodic_update_rate = rate,
                          .requested_presence_vector = presence_vector}};
        enter(*c, consumed_state::asking);
        request(*c, now, out);
        return static_cast<std::size_t>(c - connections_.data());
    }
    /// Pauses a confirmed connection; false where there is none.
    [[nodiscard]] constexpr bool suspend(std::size_t place, time_point now, message_sink out) noexcept {
        if (place >= Capacity || !going_on(connections_[place])) return false;
        tell<suspend_service_connection>(connections_[place], now, out);
        enter(connections_[place], consumed_state::suspended);
        return true;
    }
    /// Activates a suspended connection; false if it is not suspended.
    [[nodiscard]] constexpr bool activate(std::size_t place, time_point now, message_sink out) noexcept {
        if (place >= Capacity || connections_[place].state != consumed_state::suspended) return false;
        consumed_connection& c = connections_[place];
        tell<activate_service_connection>(c, now, out);
        c.due = saturating_add(now, silence(c));
        enter(c, consumed_state::active);
        return true;
    }
    /// Terminates a connection. Its place is free when the provider has been silent for three periods, and for the
    /// timeout: a report that still comes shows that the message was lost, and has it sent again.
    constexpr void end(std::size_t place, time_point now, message_sink out) noexcept {
        if (place >= Capacity || connections_[place].state == consumed_state::free) return;
        consumed_connection& c = connections_[place];
        if (c.confirmed) tell<terminate_service_connection>(c, now, out);
        c.due = saturating_add(now, std::max(silence(c), options_.retry.interval));
        enter(c, consumed_state::ending);
    }

    /// Handles Confirm Service Connection, and the reports of connections; the caller reads their bodies.
    constexpr consumer_outcome on_message(const header& head, std::span<const std::byte> body, time_point now,
                                          message_sink out) noexcept {
        if (is_acknowledgement(head)) return {};
        if (head.command_code == command_code_of<confirm_service_connection>) return confirm(head, body, now, out);
        consumed_connection* const c = head.service_connection ? find(head.source, head.command_code) : nullptr;
        if (c == nullptr) return {};
        const auto place = static_cast<std::size_t>(c - connections_.data());
        switch (c->state) {
        case consumed_state::asking: // reports may overtake the confirmation
        case consumed_state::active:
        case consumed_state::stale: return count(*c, head.sequence_number, place, now);
        case consumed_state::suspended: // the message got lost
            if (now - c->asked_at >= options_.retry.interval) tell<suspend_service_connection>(*c, now, out);
            break;
        case consumed_state::refused:
        case consumed_state::ending:
            if (c->confirmed && now - c->asked_at >= options_.retry.interval)
                tell<terminate_service_connection>(*c, now, out);
            c->due = saturating_add(now, std::max(silence(*c), options_.retry.interval));
            break;
        default: break;
        }
        return {consumer_notice::ignored, place};
    }

    /// Repeats requests, detects timeouts, and frees ended connections.
    constexpr void on_time(time_point now, message_sink out) noexcept {
        for (consumed_connection& c : connections_) {
            if (!waits(c) || c.due > now) continue;
            if (c.state == consumed_state::ending) {
                enter(c, consumed_state::free);
                c = {};
            } else if (c.state == consumed_state::asking && !options_.retry.allows_another(c.requests)) {
                enter(c, consumed_state::unanswered);
            } else {
                if (c.state == consumed_state::active) enter(c, consumed_state::stale);
                request(c, now, out);
            }
        }
    }
    /// When on_time has something to do.
    [[nodiscard]] constexpr std::optional<time_point> next_event() const noexcept {
        std::optional<time_point> next;
        for (const consumed_connection& c : connections_)
            if (waits(c) && (!next || c.due < *next)) next = c.due;
        return next;
    }

    /// All places, free ones too.
    [[nodiscard]] constexpr std::span<const consumed_connection> connections() const noexcept { return connections_; }

  private:
    [[nodiscard]] static constexpr bool going_on(const consumed_connection& c) noexcept {
        return c.state == consumed_state::active || c.state == consumed_state::stale;
    }
    [[nodiscard]] static constexpr bool waits(const consumed_connection& c) noexcept {
        return going_on(c) || c.state == consumed_state::asking || c.state == consumed_state::ending;
    }
    [[nodiscard]] constexpr consumed_connection* find(const address& provider, std::uint16_t code) noexcept {
        const auto found = std::ranges::find_if(connections_, [&](const consumed_connection& c) {
            return c.state != consumed_state::free && c.request.command_code == code && c.provider == provider;
        });
        return found == connections_.end() ? nullptr : &*found;
    }
    // Refused and unanswered connections are replaced.
    [[nodiscard]] constexpr consumed_connection* free_place() noexcept {
        consumed_connection* found = nullptr;
        for (consumed_connection& c : connections_) {
            if (c.state == consumed_state::free) return &c;
            if (c.state == consumed_state::refused || c.state == consumed_state::unanswered) found = &c;
        }
        return found;
    }
    [[nodiscard]] constexpr duration silence(const consumed_connection& c) const noexcept {
        const double rate = c.rate > 0 ? c.rate : c.request.requested_periodic_update_rate;
        return options_.silent_periods * period_of(rate);
    }
    constexpr void enter(consumed_connection& c, consumed_state state) noexcept {
        if (std::exchange(c.state, state) != state && changed_) changed_(c);
    }
    [[nodiscard]] constexpr header head_to(const consumed_connection& c) const noexcept {
        return {.destination = c.provider, .source = self_};
    }
    constexpr void request(consumed_connection& c, time_point now, message_sink out) noexcept {
        static_cast<void>(put(head_to(c), c.request, out));
        ++c.requests;
        c.asked_at = now;
        c.due = saturating_add(now, options_.retry.interval);
    }
    template <class Message> constexpr void tell(consumed_connection& c, time_point now, message_sink out) noexcept {
        static_cast<void>(
            put(head_to(c), Message{.command_code = c.request.command_code, .instance_id = c.instance_id}, out));
        c.asked_at = now;
    }
    constexpr consumer_outcome confirm(const header& head, std::span<const std::byte> body, time_point now,
                                       message_sink out) noexcept {
        confirm_service_connection answered{};
        if (!wire::decode(answered, body)) return {.what = consumer_notice::malformed};
        consumed_connection* const c = find(head.source, answered.command_code);
        if (c == nullptr) return {};
        const auto place = static_cast<std::size_t>(c - connections_.data());
        const bool accepted = answered.response_code == service_connection_response::connection_created;
        if (accepted) {
            c->instance_id = answered.instance_id;
            c->confirmed = true;
        }
        // Late confirmation of an abandoned request.
        if (accepted && (c->state == consumed_state::ending || c->state == consumed_state::unanswered))
            end(place, now, out);
        if (c->state != consumed_state::asking && !going_on(*c)) return {consumer_notice::ignored, place};
        c->requests = 0;
        c->response = answered.response_code;
        // A rate of nothing would never be missed.
        if (!accepted || answered.confirmed_periodic_update_rate == 0) {
            // A refused change leaves the provider with the connection that it had.
            if (c->confirmed) tell<terminate_service_connection>(*c, now, out);
            enter(*c, consumed_state::refused);
            return {consumer_notice::refused, place};
        }
        c->rate = answered.confirmed_periodic_update_rate;
        if (c->state != consumed_state::active) {
            if (c->state == consumed_state::stale) c->older.may_begin_anew();
            c->due = saturating_add(now, silence(*c));
            enter(*c, consumed_state::active);
        }
        return {consumer_notice::confirmed, place};
    }
    constexpr consumer_outcome count(consumed_connection& c, std::uint16_t number, std::size_t place,
                                     time_point now) noexcept {
        const auto ahead = static_cast<std::uint16_t>(number - c.sequence_number);
        // After the provider has begun to count anew, a large step is that of a late report of its earlier count.
        const bool is_of_earlier_count = now < c.anew_until && ahead > older_numbers::most_late;
        const bool newer = !c.heard || (ahead != 0 && ahead < 0x8000 && !is_of_earlier_count);
        if (!newer) {
            if (!c.older.begins_anew(number, static_cast<std::uint16_t>(-ahead))) {
                ++c.dropped;
                return {consumer_notice::old_report, place};
            }
            c.anew_until = saturating_add(now, options_.retry.total());
        }
        const std::uint64_t lost = c.heard && newer ? ahead - 1u : 0u;
        c.heard = true;
        c.older = {};
        c.sequence_number = number;
        ++c.received;
        c.lost += lost;
        if (c.state != consumed_state::asking) {
            c.due = saturating_add(now, silence(c));
            enter(c, consumed_state::active);
        }
        return {consumer_notice::report, place, lost};
    }

    address self_;
    consumer_options options_;
    hook<void(const consumed_connection&)> changed_;
    std::array<consumed_connection, Capacity> connections_{};
};

} // namespace jauscat::jaus
