// Control of a component: request, grant, takeover, release, loss; refusal of other senders' commands. RA 3.3 part 3,
// core subgroup, and the notes on authority.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/jaus/component/command_rules.hpp>
#include <jauscat/schema/jaus/communications.hpp>
#include <jauscat/schema/jaus/core.hpp>

#include <algorithm>
#include <chrono>
#include <optional>

namespace jauscat::jaus {

struct controller {
    jaus::address address{};       ///< of the component in control
    std::uint8_t authority_code{}; ///< 0 lowest to 255 highest, as in its request
    friend constexpr bool operator==(const controller&, const controller&) = default;
};

/// Cause of a change of the controller.
enum class control_change : std::uint8_t {
    granted,    ///< control was granted, or the controller's authority changed
    taken_over, ///< one of higher authority has it
    released,   ///< the controller has given it back
    rejected,   ///< the component has revoked it
    lost,       ///< the controller has disappeared, or was silent for the timeout
};

struct control_options {
    /// The component's own authority, until Set Component Authority.
    std::uint8_t authority_code{};
    /// User-defined codes that cause no motion: accepted from every sender, in every state. All other user-defined
    /// codes count as motion commands, see command_rules. Must outlive the component.
    std::span<const std::uint16_t> harmless{};
    /// Timeout: control is lost without a message of the controller for this time. After a quarter of it the controller
    /// is queried for its heartbeat pulse, so that an idle controller keeps control. 0: never.
    duration timeout{std::chrono::milliseconds{500}};
};

/// Control of one component, component side. A request of higher authority than the controller's takes control over,
/// and the old controller gets Reject Component Control; one of equal or lower authority is answered with "control not
/// accepted". The controller may ask again, also with another authority: that is accepted and counts as life. There is
/// no queue of requests.
class component_control {
  public:
    constexpr explicit component_control(const address& self, const control_options& options = {}) noexcept
        : self_{self}, authority_{options.authority_code}, options_{options} {}

    /// The controller, if any.
    [[nodiscard]] constexpr const std::optional<jaus::controller>& controller() const noexcept { return controller_; }
    /// Cause of the last change; meaningless before control was first granted.
    [[nodiscard]] constexpr control_change last_change() const noexcept { return last_change_; }
    /// The component's own authority code.
    [[nodiscard]] constexpr std::uint8_t authority_code() const noexcept { return authority_; }
    /// Number of commands from senders other than the controller that `admits` refused.
    [[nodiscard]] constexpr std::uint64_t refused() const noexcept { return refused_; }

    [[nodiscard]] JAUSCAT_CONSTEXPR command_rule rule(std::uint16_t command_code) const noexcept;
    /// Whether the message is admitted. Call once for each received message: counts refusals.
    JAUSCAT_CONSTEXPR bool admits(const header& head) noexcept;
    /// Call for every received message, also repetitions and acknowledgements: messages of the controller keep its
    /// control alive.
    JAUSCAT_CONSTEXPR void heard(const address& who, time_point now) noexcept;
    /// Whether this message is the heartbeat pulse that was requested from the controller.
    JAUSCAT_CONSTEXPR bool takes_pulse(const header& head) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR bool controls(const address& who) const noexcept;

    /// Takes Request and Release Component Control, Set Component Authority, and the queries of authority and control.
    /// Ask `admits` first. Confirm and Reject Component Control are for the other side: see held_control.
    JAUSCAT_CONSTEXPR message_outcome on_message(const header& head, std::span<const std::byte> body, time_point now,
                                                 message_sink out) noexcept;

    /// The component takes control back: the controller, if there is one, gets Reject Component Control.
    JAUSCAT_CONSTEXPR void reject(message_sink out) noexcept { take_back(control_change::rejected, out); }
    /// Removes the components for which `gone(const address&)` is true: a controller among them loses control. No
    /// message is sent to it.
    constexpr void on_lost(auto&& gone) noexcept {
        if (controller_ && gone(std::as_const(controller_->address))) end(control_change::lost);
    }
    /// Queries the pulse of a silent controller, and ends the control of one that has been silent for the timeout.
    JAUSCAT_CONSTEXPR void on_time(time_point now, message_sink out) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR std::optional<time_point> next_event() const noexcept;

  private:
    JAUSCAT_CONSTEXPR void request(const header& head, std::uint8_t authority, time_point now,
                                   message_sink out) noexcept;

    [[nodiscard]] constexpr duration quarter() const noexcept { return std::max(options_.timeout / 4, duration{1}); }
    JAUSCAT_CONSTEXPR void end(control_change why) noexcept;
    // Sends Reject Component Control to the controller.
    JAUSCAT_CONSTEXPR void take_back(control_change why, message_sink out) noexcept;

    address self_;
    std::uint8_t authority_;
    control_options options_;
    std::optional<jaus::controller> controller_{};
    control_change last_change_{};
    time_point heard_{};
    std::int64_t asked_{};  // quarters of the timeout without a message from the controller, at the last query
    std::uint8_t pulses_{}; // queried and not yet received
    std::uint64_t refused_{};
};

} // namespace jauscat::jaus

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jaus/component/impl/component_control.ipp>
#endif
