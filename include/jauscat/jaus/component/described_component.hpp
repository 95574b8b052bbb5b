// Heartbeats, identification and services of a component.
#pragma once
#include <jauscat/base/compilation.hpp>
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
[[nodiscard]] JAUSCAT_CONSTEXPR heartbeat heartbeat_to_node_manager(const address& self) noexcept;
/// Heartbeats to all node managers, as for a node manager.
[[nodiscard]] JAUSCAT_CONSTEXPR heartbeat heartbeat_to_all() noexcept;

/// The part of a component that sends Report Heartbeat Pulse (4202h) and answers Query Heartbeat Pulse (2202h), Query
/// Identification (2B00h) and Query Services (2B03h). It answers for the component alone: identification of the
/// subsystem or node is refused, since the node manager has those.
class described_component {
  public:
    /// `memory`, which must outlive this: for Report Services, see answer.
    JAUSCAT_CONSTEXPR described_component(const address& self, const component_description& description,
                                          const heartbeat& beat, std::span<std::byte> memory) noexcept;

    /// Refused are also answers for which the memory is too small and texts of more than 80 characters.
    JAUSCAT_CONSTEXPR message_outcome on_message(const header& head, std::span<const std::byte> body, time_point,
                                                 message_sink out) noexcept;

    /// Sends a heartbeat when it is time, the first at once. A late call sends one, not what has been missed.
    JAUSCAT_CONSTEXPR void on_time(time_point now, message_sink out) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR std::optional<time_point> next_event() const noexcept;
    /// No effect: nothing depends on another component.
    constexpr void on_lost(const address&) noexcept {}

    [[nodiscard]] JAUSCAT_CONSTEXPR static report_identification identification(query_type whose,
                                                                                const identity& name) noexcept;

  private:
    address self_;
    component_description description_;
    heartbeat beat_;
    std::span<std::byte> memory_;
    time_point next_{duration::min() / 2};
    std::uint16_t beats_{}; ///< sent, modulo 65536
};

} // namespace jauscat::jaus

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jaus/component/impl/described_component.ipp>
#endif
