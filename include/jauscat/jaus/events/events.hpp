// Events, provider side: requests, triggers, due times. RA 3.3 part 3, codes 01F0h to 01F4h, 21F0h, 41F0h and 41F1h.
// The consumer side is event_consumer.hpp.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/jaus/events/event_record.hpp>
#include <jauscat/jaus/message/peer_share.hpp>
#include <jauscat/jaus/message/stands_for.hpp>
#include <jauscat/schema/jaus/dynamic_configuration.hpp>

namespace jauscat::jaus {

/// Creates, updates, cancels and sends events; event_record.hpp describes the triggers. Only the requester of an event
/// may update or cancel it. A repeated request is confirmed again and restarts its event. If no place is free, an event
/// that its requester has superseded is replaced. The components of one node have three quarters of the places at most,
/// see peer_share.
///
///     const auto fill = [&](std::uint16_t code, std::span<const std::byte> query, std::span<std::byte> body) { ... };
///     constexpr std::array reports{jaus::eventful_report{0x4404, &jaus::read_field<jaus::report_velocity_state>}};
///     jaus::events<16> events{self, reports, fill, memory};
///     events.changed(0x4404, body, now, out);
template <std::size_t Capacity> class events {
    static_assert(Capacity >= 1 && Capacity <= 64, "events: more than 64 may not fit one Report Events");

  public:
    /// `memory`: 24 bytes and twice the longest report; less than 256 bytes are too few for all answers, and Report
    /// Events takes up to 1 byte and 62 for each event. All but `self` must outlive this. Without a policy all requests
    /// are accepted, so that any sender can direct reports at any component.
    constexpr events(const address& self, std::span<const eventful_report> reports, event_filler fill,
                     std::span<std::byte> memory, event_policy policy = {}) noexcept
        : self_{self}, reports_{reports}, fill_{fill}, policy_{policy} {
        const std::size_t overhead = header_size + wire::min_size<event>;
        const std::size_t room = memory.size() < overhead ? 0 : (memory.size() - overhead) / 2;
        report_ = memory.last(std::min(room, max_body_size - wire::min_size<event>));
        message_ = memory.first(memory.size() - report_.size());
    }

    /// Takes Create, Update and Cancel Event (answered by Confirm or Reject Event Request; a cancel by a confirmation
    /// of each event that is gone) and Query Events (answered by Report Events).
    constexpr message_outcome on_message(const header& head, std::span<const std::byte> body, time_point now,
                                         message_sink out) noexcept {
        if (is_acknowledgement(head)) return message_outcome::unhandled;
        switch (head.command_code) {
        case command_code_of<create_event>:
            return decode_for<create_event>(body, [&](const auto& m) { return create(head, m, now, out); });
        case command_code_of<update_event>:
            return decode_for<update_event>(body, [&](const auto& m) { return update(head, m, now, out); });
        case command_code_of<cancel_event>:
            return decode_for<cancel_event>(body, [&](const auto& m) { return cancel(head, m, out); });
        case command_code_of<query_events>:
            return decode_for<query_events>(body, [&](const auto& m) { return report(head, m, out); });
        default: return message_outcome::unhandled;
        }
    }

    /// Call when report `code` has changed; `body` is the new one with all its fields.
    constexpr void changed(std::uint16_t code, std::span<const std::byte> body, time_point now,
                           message_sink out) noexcept {
        for (event_record& e : events_) {
            if (e.message_code != code || code == 0 || !triggers(e, *report_of(code), body)) continue;
            if (is_periodic(e.setup.event_type)) {
                if (!e.pending && e.due < now) e.due = instant_after(e.due, period_of(e.setup.rate), now);
                e.pending = true;
                continue;
            }
            e.pending = true;
            if (e.due <= now) e.setup.query.empty() ? send(e, body, now, out) : send_filled(e, now, out);
        }
    }

    /// Sends what is due.
    constexpr void on_time(time_point now, message_sink out) noexcept {
        for (event_record& e : events_) {
            if (const auto next = due_of(e); !next || *next > now) continue;
            if (is_periodic(e.setup.event_type)) e.due = instant_after(e.due, period_of(e.setup.rate), now);
            send_filled(e, now, out);
        }
    }
    /// When on_time has something to send.
    [[nodiscard]] constexpr std::optional<time_point> next_event() const noexcept {
        std::optional<time_point> first;
        for (const event_record& e : events_)
            if (const auto next = due_of(e); next && (!first || *next < *first)) first = next;
        return first;
    }

    /// Cancels the events of those that have disappeared, see stands_for; returns how many.
    constexpr std::size_t on_lost(const address& requester) noexcept {
        std::size_t count = 0;
        for (event_record& e : events_) {
            if (e.message_code == 0 || !stands_for(requester, e.requester)) continue;
            e = {};
            ++count;
        }
        return count;
    }

    /// Calls `takes(supported_message)` and `sends` for each message of events, and for the reports.
    constexpr void list_messages(auto&& takes, auto&& sends) const {
        if (reports_.empty()) return;
        for (const auto code : {command_code_of<create_event>, command_code_of<update_event>,
                                command_code_of<cancel_event>, command_code_of<query_events>})
            takes(supported_message{code});
        for (const auto code : {command_code_of<confirm_event_request>, command_code_of<reject_event_request>,
                                command_code_of<event>, command_code_of<report_events>})
            sends(supported_message{code});
        for (const auto& report : reports_) sends(supported_message{report.command_code});
    }

    /// All places; those with message code 0 are free.
    [[nodiscard]] constexpr std::span<const event_record> records() const noexcept { return events_; }
    /// Events that were due but not sent, because there was no report or it exceeded the memory.
    [[nodiscard]] constexpr std::uint64_t skipped() const noexcept { return skipped_; }

  private:
    template <coded_message T> constexpr bool reply(const header& head, const T& body, message_sink out) noexcept {
        return put_in(answer_to(head, self_), body, out);
    }
    template <coded_message T> constexpr bool put_in(const header& head, const T& body, message_sink out) noexcept {
        const auto message = make_message(head, body, message_);
        if (message) out(*message);
        return message.has_value();
    }
    constexpr message_outcome reject(const header& head, std::uint8_t request, event_response why,
                                     std::string_view text, message_sink out) noexcept {
        reply(head, reject_event_request{.local_request_id = request, .response_code = why, .error_message = text},
              out);
        return message_outcome::refused;
    }
    constexpr void confirm(const header& head, std::uint8_t request, const event_record& e, message_sink out) noexcept {
        confirm_event_request confirmed{
            .local_request_id = request, .message_code = e.message_code, .event_id = e.event_id};
        if (e.setup.rate != 0) confirmed.confirmed_periodic_rate = e.setup.rate;
        reply(head, confirmed, out);
    }
    [[nodiscard]] constexpr const eventful_report* report_of(std::uint16_t code) const noexcept {
        const auto found = std::ranges::find(reports_, code, &eventful_report::command_code);
        return found == reports_.end() || code == 0 ? nullptr : &*found;
    }

    constexpr message_outcome create(const header& head, const create_event& m, time_point now,
                                     message_sink out) noexcept {
        checked_setup checked = check_setup(m, report_of(m.message_code));
        if (checked.response == event_response::successful && policy_) {
            checked.response = policy_(head, m.message_code);
            checked.error_message = "not admitted";
        }
        if (checked.response != event_response::successful)
            return reject(head, m.local_request_id, checked.response, checked.error_message, out);
        const auto same = std::ranges::find_if(events_, [&](const event_record& e) {
            return e.message_code == m.message_code && e.requester == head.source &&
                   e.local_request_id == m.local_request_id && e.setup == checked.setup;
        });
        if (same != events_.end()) {
            same->order = ++last_order_;
            confirm(head, m.local_request_id, set_up(*same, checked.setup, now), out);
            start(*same, now, out);
            return message_outcome::handled;
        }
        event_record* const place = free_place(head.source);
        if (place == nullptr)
            return reject(head, m.local_request_id, event_response::connection_refused, "too many events", out);
        *place = {.requester = head.source,
                  .message_code = m.message_code,
                  .event_id = free_id(),
                  .local_request_id = m.local_request_id,
                  .priority = head.priority,
                  .order = ++last_order_};
        confirm(head, m.local_request_id, set_up(*place, checked.setup, now), out);
        start(*place, now, out);
        return message_outcome::handled;
    }
    constexpr message_outcome update(const header& head, const update_event& m, time_point now,
                                     message_sink out) noexcept {
        const auto e = std::ranges::find_if(events_, [&](const event_record& r) {
            return r.message_code != 0 && r.event_id == m.event_id && r.requester == head.source;
        });
        if (e == events_.end())
            return reject(head, m.local_request_id, event_response::error_invalid_event_id_for_update_request,
                          "no such event", out);
        if (e->message_code != m.message_code)
            return reject(head, m.local_request_id, event_response::invalid_event_setup,
                          "the event is of another message", out);
        const checked_setup checked = check_setup(m, report_of(m.message_code));
        if (checked.response != event_response::successful)
            return reject(head, m.local_request_id, checked.response, checked.error_message, out);
        e->local_request_id = m.local_request_id;
        e->order = ++last_order_;
        confirm(head, m.local_request_id, set_up(*e, checked.setup, now), out);
        start(*e, now, out);
        return message_outcome::handled;
    }
    constexpr message_outcome cancel(const header& head, const cancel_event& m, message_sink out) noexcept {
        bool any = false;
        for (event_record& e : events_) {
            if (e.requester != head.source || !is_selected(e, m.message_code, m.event_id)) continue;
            const event_record gone = std::exchange(e, {});
            confirm(head, m.local_request_id, gone, out);
            any = true;
        }
        if (any) return message_outcome::handled;
        return reject(head, m.local_request_id, event_response::error_invalid_event_id_for_update_request,
                      "no such event", out);
    }
    // The events of all requesters.
    constexpr message_outcome report(const header& head, const query_events& m, message_sink out) noexcept {
        std::array<reported_event, Capacity> reported{};
        std::size_t count = 0;
        for (const event_record& e : events_) {
            if (is_selected(e, m.message_code, m.event_id) && (!m.event_type || *m.event_type == e.setup.event_type))
                reported[count++] = as_reported(e);
        }
        const bool fits = reply(head, report_events{.event = std::span{reported}.first(count)}, out);
        return fits ? message_outcome::handled : message_outcome::refused;
    }

    // A free place, or that of an event that its requester has superseded; where the requester's node has its share, of
    // an event of this node.
    [[nodiscard]] constexpr event_record* free_place(const address& requester) noexcept {
        const auto is_its = [&](const event_record& e) {
            return e.message_code != 0 && are_of_one_node(e.requester, requester);
        };
        const bool has_share = std::cmp_greater_equal(std::ranges::count_if(events_, is_its), peer_share(Capacity));
        auto found = has_share ? events_.end() : std::ranges::find(events_, 0, &event_record::message_code);
        if (found == events_.end())
            found = std::ranges::find_if(events_, [&](const event_record& old) {
                return (!has_share || is_its(old)) &&
                       std::ranges::any_of(events_, [&](const event_record& e) { return supersedes(e, old); });
            });
        return found == events_.end() ? nullptr : &*found;
    }
    [[nodiscard]] constexpr std::uint8_t free_id() noexcept {
        do {
            last_id_ = static_cast<std::uint8_t>(last_id_ % 255 + 1);
        } while (std::ranges::any_of(
            events_, [&](const event_record& e) { return e.message_code != 0 && e.event_id == last_id_; }));
        return last_id_;
    }
    constexpr const event_record& set_up(event_record& e, const event_setup& setup, time_point now) noexcept {
        const eventful_report* const report = report_of(e.message_code);
        arm(e, setup, *report, now);
        // Changes are detected relative to the present report, if there is one.
        if (!is_on_change(setup.event_type) || !setup.condition.field) return e;
        if (const auto size = fill_(e.message_code, {}, report_); size && *size <= report_.size())
            static_cast<void>(triggers(e, *report, report_.first(*size)));
        return e;
    }
    constexpr void start(event_record& e, time_point now, message_sink out) noexcept {
        if (e.setup.event_type == event_type::one_time_on_demand) send_filled(e, now, out);
    }
    constexpr void send(event_record& e, std::span<const std::byte> body, time_point now, message_sink out) noexcept {
        const header head{.priority = e.priority, .destination = e.requester, .source = self_};
        const bool sent = put_in(head,
                                 event{.event_id = e.event_id,
                                       .message_code = e.message_code,
                                       .event_sequence_number = e.sequence_number,
                                       .report_message_body = body},
                                 out);
        skipped_ += !sent;
        note_sent(e, sent, now);
    }
    constexpr void send_filled(event_record& e, time_point now, message_sink out) noexcept {
        const auto size = fill_(e.message_code, {e.setup.query.begin(), e.setup.query.size()}, report_);
        if (size && *size <= report_.size()) {
            send(e, report_.first(*size), now, out);
        } else {
            ++skipped_;
            note_sent(e, false, now);
        }
    }

    address self_;
    std::span<const eventful_report> reports_;
    event_filler fill_;
    event_policy policy_;
    std::span<std::byte> message_, report_;
    std::array<event_record, Capacity> events_{};
    std::uint64_t skipped_{};
    std::uint8_t last_id_{};
    std::uint32_t last_order_{};
};

} // namespace jauscat::jaus
