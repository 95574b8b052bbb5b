// Heartbeats, identification and services of a component.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/jaus/component/core_messages.hpp>
#include <jauscat/schema/jaus/communications.hpp>
#include <jauscat/schema/jaus/dynamic_configuration.hpp>

#include <chrono>
#include <optional>

namespace jauscat::jaus {

/// Identification of a component, node or subsystem. The text must outlive all users.
struct identity {
    std::string_view identification{}; ///< up to 80 characters
    std::uint16_t type{};              ///< see report_identification
    std::uint8_t authority_code{};     ///< 0 lowest to 255 highest
};

/// Identification and services of a component.
struct component_description {
    identity name{.type = 60001};                                        ///< identification
    std::span<const offered_service> services = core_messages::services; ///< up to 255; none counts as the core service
};

/// Destination and period of heartbeats.
struct heartbeat {
    address to{};                             ///< destination
    duration period{std::chrono::seconds{1}}; ///< 0: none are sent
};

/// Heartbeats to the own node manager, as for components.
[[nodiscard]] constexpr heartbeat heartbeat_to_node_manager(const address& self) noexcept {
    return {.to = {.instance = 1, .component = 1, .node = self.node, .subsystem = self.subsystem}};
}
/// Heartbeats to all node managers, as for a node manager.
[[nodiscard]] constexpr heartbeat heartbeat_to_all() noexcept {
    return {.to = {.instance = 1, .component = 1, .node = 255, .subsystem = 255}};
}

/// The part of a component that sends Report Heartbeat Pulse (4202h) and answers Query Heartbeat Pulse (2202h), Query
/// Identification (2B00h) and Query Services (2B03h). It answers for the component alone: identification of the
/// subsystem or node is refused, since the node manager has those.
class described_component {
  public:
    /// `memory`, which must outlive this: for Report Services, see answer.
    constexpr described_component(const address& self, const component_description& description, const heartbeat& beat,
                                  std::span<std::byte> memory) noexcept
        : self_{self}, description_{description}, beat_{beat}, memory_{memory} {
        // Some nodes repeat Query Services until a service is reported.
        if (description.services.empty()) description_.services = core_messages::services;
    }

    /// Refused are also answers for which the memory is too small and texts of more than 80 characters.
    constexpr message_outcome on_message(const header& head, std::span<const std::byte> body, time_point,
                                         message_sink out) noexcept {
        if (is_acknowledgement(head)) return message_outcome::unhandled;
        const auto done = [](bool sent) { return sent ? message_outcome::handled : message_outcome::refused; };
        switch (head.command_code) {
        case command_code_of<query_heartbeat_pulse>:
            return decode_for<query_heartbeat_pulse>(body, [&](const auto&) {
                return done(answer(head, self_, report_heartbeat_pulse{}, out).has_value());
            });
        case command_code_of<query_identification>:
            return decode_for<query_identification>(body, [&](const query_identification& query) {
                return done(query.query_type == query_type::component_identification &&
                            answer(head, self_, identification(query.query_type, description_.name), out).has_value());
            });
        case command_code_of<query_services>:
            return decode_for<query_services>(body, [&](const auto&) {
                return done(answer(head, self_, report_services{description_.services}, memory_, out).has_value());
            });
        default: return message_outcome::unhandled;
        }
    }

    /// Sends a heartbeat when it is time, the first at once. A late call sends one, not what has been missed.
    constexpr void on_time(time_point now, message_sink out) noexcept {
        if (beat_.period <= duration{} || now < next_) return;
        const time_point following = saturating_add(next_, beat_.period);
        next_ = following > now ? following : saturating_add(now, beat_.period);
        static_cast<void>(put({.destination = beat_.to, .source = self_}, report_heartbeat_pulse{}, out));
    }
    [[nodiscard]] constexpr std::optional<time_point> next_event() const noexcept {
        if (beat_.period <= duration{}) return std::nullopt;
        return next_;
    }
    /// No effect: nothing depends on another component.
    constexpr void on_lost(const address&) noexcept {}

    [[nodiscard]] static constexpr report_identification identification(query_type whose,
                                                                        const identity& name) noexcept {
        return {whose, name.authority_code, name.type, name.identification};
    }

  private:
    address self_;
    component_description description_;
    heartbeat beat_;
    std::span<std::byte> memory_;
    time_point next_{duration::min() / 2};
};

} // namespace jauscat::jaus
