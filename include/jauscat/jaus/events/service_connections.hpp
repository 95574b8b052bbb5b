// Service connections, provider side: requests, rates, due times. RA 3.3 part 3, codes 0008h to 000Ch. The consumer
// side is service_consumer.hpp.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/jaus/events/update_rate.hpp>
#include <jauscat/jaus/message/hook.hpp>
#include <jauscat/jaus/message/peer_share.hpp>
#include <jauscat/jaus/message/stands_for.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/jaus/dynamic_configuration.hpp>

#include <optional>

namespace jauscat::jaus {

/// A report that may be connected to.
struct connectable_report {
    std::uint16_t command_code{};              ///< of the report
    double min_rate{};                         ///< hertz; a lower request gets this rate
    double max_rate{update_rate::max};         ///< hertz; a higher request gets this rate
    std::uint32_t presence_vector{0xFFFFFFFF}; ///< bits of its fields; a request's other bits are ignored
};

/// Writes the body of report `command_code`, with the fields selected by `presence_vector`, to the front of `body` and
/// returns its size; empty if there is no report now.
using report_filler = hook<std::optional<std::size_t>(std::uint16_t command_code, std::uint32_t presence_vector,
                                                      std::span<std::byte> body)>;
/// Whether a component may connect: connection_created, or the reason why not, for example insufficient_authority.
using connection_policy = hook<service_connection_response(const header&, const create_service_connection&)>;

/// A service connection of a provider.
struct service_connection {
    address consumer{};
    std::uint16_t command_code{};    ///< of the report; 0: no connection
    std::uint32_t presence_vector{}; ///< the fields that are reported
    std::uint8_t priority{};         ///< of the request, and of its reports
    bool active{};                   ///< sends; false: suspended
    double rate{};                   ///< hertz, as confirmed
    time_point due{};                ///< when the next report is
    std::uint16_t sent{};            ///< reports, modulo 65536: the next one's sequence number
};

/// Answers requests for service connections and sends the reports.
///
/// A component has one connection for each report code: the header of a report names no connection, so two could not be
/// distinguished. A repeated request changes rate and presence vector and keeps instance ID and sequence number, so
/// that a lost confirmation is harmless. Only the requester may activate, suspend and terminate. The RA has no answer
/// to these three; the caller acknowledges them on request (see message_outcome). Reports are due at absolute times,
/// one period apart, from the request on; a late one is sent once, however many periods have passed. A report may have
/// 4080 bytes: its sequence number counts sends, so it cannot be cut. The components of one node have three quarters of
/// the places at most, see peer_share.
///
///     const auto fill = [&](std::uint16_t code, std::uint32_t fields, std::span<std::byte> body) { ... };
///     jaus::service_connections<16> connections{self, reports, fill, memory};
template <std::size_t Capacity> class service_connections {
    static_assert(Capacity >= 1 && Capacity <= 256, "service_connections: instance IDs are one byte");

  public:
    /// `memory` holds a header and the longest report. All but `self` must outlive this. Without a policy all requests
    /// are accepted, so that any sender can direct reports at any component.
    constexpr service_connections(const address& self, std::span<const connectable_report> reports, report_filler fill,
                                  std::span<std::byte> memory, connection_policy policy = {}) noexcept
        : self_{self},
          reports_{reports},
          fill_{fill},
          memory_{memory.first(std::min(memory.size(), header_size + max_body_size))},
          policy_{policy} {}

    /// Takes Create (answered by Confirm), Activate, Suspend and Terminate Service Connection. A request without a
    /// place left is answered with connection_refused, one without rate with invalid_service_connection_parameters, one
    /// for another report with command_not_supported. Requested fields that the report does not have are left out.
    constexpr message_outcome on_message(const header& head, std::span<const std::byte> body, time_point now,
                                         message_sink out) noexcept {
        if (is_acknowledgement(head)) return message_outcome::unhandled;
        switch (head.command_code) {
        case command_code_of<create_service_connection>:
            return decode_for<create_service_connection>(
                body, [&](const create_service_connection& request) { return create(head, request, now, out); });
        case command_code_of<activate_service_connection>:
            return change<activate_service_connection>(head, body, [&](service_connection& c) {
                if (!c.active) c.due = now;
                c.active = true;
            });
        case command_code_of<suspend_service_connection>:
            return change<suspend_service_connection>(head, body, [](service_connection& c) { c.active = false; });
        case command_code_of<terminate_service_connection>:
            return change<terminate_service_connection>(head, body, [](service_connection& c) { c = {}; });
        default: return message_outcome::unhandled;
        }
    }

    /// Sends the reports that are due.
    constexpr void on_time(time_point now, message_sink out) noexcept {
        for (service_connection& c : connections_) {
            if (!sends(c) || c.due > now) continue;
            c.due = instant_after(c.due, period_of(c.rate), now);
            send(c, out);
        }
    }
    /// When the next report is due; none without an active connection.
    [[nodiscard]] constexpr std::optional<time_point> next_event() const noexcept {
        std::optional<time_point> next;
        for (const service_connection& c : connections_)
            if (sends(c) && (!next || c.due < *next)) next = c.due;
        return next;
    }

    /// Terminates the connections of those that have disappeared, see stands_for; returns how many.
    constexpr std::size_t on_lost(const address& consumer) noexcept {
        std::size_t count = 0;
        for (service_connection& c : connections_) {
            if (c.command_code == 0 || !stands_for(consumer, c.consumer)) continue;
            c = {};
            ++count;
        }
        return count;
    }
    /// Terminates all, for example at shutdown. The RA has no message for it: consumers notice the silence.
    constexpr void clear() noexcept { connections_ = {}; }

    /// Calls `takes(supported_message)` and `sends` for each message of service connections, and for the reports.
    constexpr void list_messages(auto&& takes, auto&& sends) const {
        if (reports_.empty()) return;
        for (const auto code :
             {command_code_of<create_service_connection>, command_code_of<activate_service_connection>,
              command_code_of<suspend_service_connection>, command_code_of<terminate_service_connection>})
            takes(supported_message{code});
        sends(supported_message{command_code_of<confirm_service_connection>});
        for (const auto& report : reports_) sends(supported_message{report.command_code, report.presence_vector});
    }

    /// All places; the index is the instance ID. Those with command code 0 are free.
    [[nodiscard]] constexpr std::span<const service_connection> connections() const noexcept { return connections_; }
    /// Reports that were due but not sent, because there was no report or it exceeded the memory.
    [[nodiscard]] constexpr std::uint64_t skipped() const noexcept { return skipped_; }

  private:
    using response = service_connection_response;

    [[nodiscard]] static constexpr bool sends(const service_connection& c) noexcept {
        return c.command_code != 0 && c.active;
    }
    constexpr message_outcome create(const header& head, const create_service_connection& request, time_point now,
                                     message_sink out) noexcept {
        confirm_service_connection confirmed{.command_code = request.command_code};
        const auto report = std::ranges::find(reports_, request.command_code, &connectable_report::command_code);
        service_connection* const place = place_for(head.source, request.command_code);
        double rate{};
        if (reports_.empty()) {
            confirmed.response_code = response::component_does_not_support_service_connections;
        } else if (report == reports_.end()) {
            confirmed.response_code = response::command_not_supported;
        } else if (rate = sayable_rate(std::max(request.requested_periodic_update_rate, report->min_rate),
                                       report->max_rate);
                   request.requested_periodic_update_rate == 0 || rate == 0) {
            confirmed.response_code = response::invalid_service_connection_parameters;
        } else if (policy_) {
            confirmed.response_code = policy_(head, request);
        }
        if (confirmed.response_code == response::connection_created && place == nullptr)
            confirmed.response_code = response::connection_refused;
        if (confirmed.response_code == response::connection_created) {
            if (place->command_code == 0 || !place->active || place->rate != rate) place->due = now;
            *place = {.consumer = head.source,
                      .command_code = request.command_code,
                      .presence_vector = request.requested_presence_vector & report->presence_vector,
                      .priority = head.priority,
                      .active = true,
                      .rate = rate,
                      .due = place->due,
                      .sent = place->sent};
            confirmed.instance_id = static_cast<std::uint8_t>(place - connections_.data());
            confirmed.confirmed_periodic_update_rate = rate;
        }
        static_cast<void>(answer(head, self_, confirmed, out));
        return confirmed.response_code == response::connection_created ? message_outcome::handled
                                                                       : message_outcome::refused;
    }
    // The connection that there is, or a free place.
    [[nodiscard]] constexpr service_connection* place_for(const address& consumer, std::uint16_t code) noexcept {
        service_connection* found = nullptr;
        std::size_t of_node = 0;
        for (service_connection& c : connections_) {
            if (c.command_code == code && c.consumer == consumer) return &c;
            if (c.command_code == 0 && found == nullptr) found = &c;
            of_node += c.command_code != 0 && are_of_one_node(c.consumer, consumer);
        }
        return of_node < peer_share(Capacity) ? found : nullptr;
    }
    template <class Message, class F>
    constexpr message_outcome change(const header& head, std::span<const std::byte> body, F change) noexcept {
        return decode_for<Message>(body, [&](const Message& request) {
            if (request.command_code == 0 || request.instance_id >= Capacity) return message_outcome::refused;
            service_connection& c = connections_[request.instance_id];
            if (c.command_code != request.command_code || c.consumer != head.source) return message_outcome::refused;
            change(c);
            return message_outcome::handled;
        });
    }
    constexpr void send(service_connection& c, message_sink out) noexcept {
        ++skipped_;
        if (memory_.size() < header_size) return;
        const auto size = fill_(c.command_code, c.presence_vector, memory_.subspan(header_size));
        if (!size || *size > memory_.size() - header_size) return;
        const header head{.priority = c.priority,
                          .service_connection = true,
                          .command_code = c.command_code,
                          .destination = c.consumer,
                          .source = self_,
                          .data_size = static_cast<std::uint16_t>(*size),
                          .sequence_number = c.sent};
        if (!wire::encode(head, memory_)) return;
        --skipped_;
        ++c.sent;
        out(memory_.first(header_size + *size));
    }

    address self_;
    std::span<const connectable_report> reports_;
    report_filler fill_;
    std::span<std::byte> memory_;
    connection_policy policy_;
    std::array<service_connection, Capacity> connections_{};
    std::uint64_t skipped_{};
};

} // namespace jauscat::jaus
