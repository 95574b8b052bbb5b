// Service connections to the reports of the core service, and events of them, for components that have no others.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/jaus/events/core_reports.hpp>
#include <jauscat/jaus/events/events.hpp>
#include <jauscat/jaus/events/service_connections.hpp>

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace jauscat::net::detail {

/// A part of a component.
class core_subscriptions {
  public:
    using bytes = std::span<const std::byte>;
    static constexpr std::size_t most = 32; ///< connections, and events

    /// `answer` answers queries for the reports, and must outlive this. `more`: a report of which there are events as
    /// well, which `fill_more` writes.
    core_subscriptions(const jaus::address& self, jaus::query_answer answer,
                       std::optional<jaus::eventful_report> more = {}, jaus::event_filler fill_more = {})
        : self_{self},
          answer_{answer},
          fill_more_{fill_more},
          eventful_{eventful(more)},
          connections_{self, connectable, *this, connection_memory_},
          events_{self, eventful_, *this, event_memory_} {}
    core_subscriptions(const core_subscriptions&) = delete;
    core_subscriptions& operator=(const core_subscriptions&) = delete;

    jaus::message_outcome on_message(const jaus::header& head, bytes body, time_point now, jaus::message_sink out) {
        now_ = now;
        auto outcome = connections_.on_message(head, body, now, out);
        if (outcome != jaus::message_outcome::unhandled) return outcome;
        outcome = events_.on_message(head, body, now, out);
        has_events_ = has_events_ || outcome == jaus::message_outcome::handled;
        return outcome;
    }
    void on_time(time_point now, jaus::message_sink out) {
        now_ = now;
        connections_.on_time(now, out);
        events_.on_time(now, out);
    }
    [[nodiscard]] std::optional<time_point> next_event() const {
        std::optional<time_point> first = next_look_;
        for (const auto next : {connections_.next_event(), events_.next_event()})
            if (next && (!first || *next < *first)) first = next;
        return first;
    }
    void on_lost(const jaus::address& who) {
        connections_.on_lost(who);
        events_.on_lost(who);
    }
    void list_messages(auto&& takes, auto&& sends) const {
        connections_.list_messages(takes, sends);
        events_.list_messages(takes, sends);
    }

    /// Call when the component may have changed, and after on_time: sends the events of reports that are not as before.
    /// While there are such events it is due every 10 ms, since a component also changes by what its actuator does.
    void look(time_point now, jaus::message_sink out) {
        if (!has_events_) return; // as in most components
        now_ = now;
        next_look_.reset();
        for (std::size_t i = 0; i != jaus::core_reports.size(); ++i) {
            const auto& report = jaus::core_reports[i];
            const auto is_of_it = [&](const auto& e) { return e.message_code == report.command_code; };
            if (!report.on_change || std::ranges::none_of(events_.records(), is_of_it)) {
                last_[i].reset();
                continue;
            }
            next_look_ = saturating_add(now, jaus::period_of(jaus::max_core_report_rate));
            const auto size = (*this)(report.command_code, bytes{}, look_memory_);
            if (!size) continue;
            const auto body = bytes{look_memory_}.first(*size);
            if (last_[i] && std::ranges::equal(*last_[i], body)) continue;
            const bool is_first = !last_[i];
            last_[i].emplace(body.begin(), body.end());
            if (!is_first) events_.changed(report.command_code, body, now, out);
        }
    }
    /// The report `more` is now `body`.
    void changed(std::uint16_t code, bytes body, time_point now, jaus::message_sink out) {
        events_.changed(code, body, now, out);
    }

    /// For connections and events.
    std::optional<std::size_t> operator()(std::uint16_t code, std::uint32_t presence, std::span<std::byte> body) const {
        const auto* const report = jaus::core_report_of(code);
        if (report == nullptr) return std::nullopt;
        return jaus::write_core_report(*report, self_, presence, body, now_, answer_);
    }
    std::optional<std::size_t> operator()(std::uint16_t code, bytes query, std::span<std::byte> body) const {
        const auto* const report = jaus::core_report_of(code);
        if (report == nullptr) return fill_more_(code, query, body);
        return jaus::write_core_report(*report, self_, query, body, now_, answer_);
    }

  private:
    static constexpr auto connectable = [] {
        std::array<jaus::connectable_report, jaus::core_reports.size()> all{};
        std::ranges::transform(jaus::core_reports, all.begin(), [](const jaus::core_report& one) {
            return jaus::connectable_report{.command_code = one.command_code,
                                            .max_rate = jaus::max_core_report_rate,
                                            .presence_vector = one.presence_bits()};
        });
        return all;
    }();
    static std::vector<jaus::eventful_report> eventful(const std::optional<jaus::eventful_report>& more) {
        std::vector<jaus::eventful_report> all;
        for (const auto& one : jaus::core_reports)
            all.push_back({.command_code = one.command_code,
                           .read_field = one.read_field,
                           .max_rate = jaus::max_core_report_rate,
                           .on_change = one.on_change});
        if (more) all.push_back(*more);
        return all;
    }

    jaus::address self_;
    jaus::query_answer answer_;
    jaus::event_filler fill_more_;
    std::vector<jaus::eventful_report> eventful_;
    std::vector<std::byte> connection_memory_ = std::vector<std::byte>(4096);
    std::vector<std::byte> event_memory_ = std::vector<std::byte>(3 * std::size_t{4096});
    std::vector<std::byte> look_memory_ = std::vector<std::byte>(4096);
    std::array<std::optional<std::vector<std::byte>>, jaus::core_reports.size()> last_{}; ///< while there are events
    time_point now_{};
    bool has_events_{}; ///< there have been some
    std::optional<time_point> next_look_{};
    jaus::service_connections<most> connections_;
    jaus::events<most> events_;
};

} // namespace jauscat::net::detail
