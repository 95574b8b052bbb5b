// Control of a component: request, grant, takeover, release, loss; refusal of other senders' commands. RA 3.3 part 3,
// core subgroup, and the notes on authority.
#pragma once
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

    [[nodiscard]] constexpr command_rule rule(std::uint16_t command_code) const noexcept {
        const auto& harmless = options_.harmless;
        const bool is_harmless = std::ranges::find(harmless, command_code) != harmless.end();
        return is_harmless ? command_rule::open : rule_of(command_code);
    }
    /// Whether the message is admitted. Call once for each received message: counts refusals.
    constexpr bool admits(const header& head) noexcept {
        if (controls(head.source) || !controller_ || rule(head.command_code) == command_rule::open) return true;
        ++refused_;
        return false;
    }
    /// Call for every received message, also repetitions and acknowledgements: messages of the controller keep its
    /// control alive.
    constexpr void heard(const address& who, time_point now) noexcept {
        if (!controls(who)) return;
        heard_ = now;
        asked_ = 0;
    }
    /// Whether this message is the heartbeat pulse that was requested from the controller.
    constexpr bool takes_pulse(const header& head) noexcept {
        const bool is_it =
            pulses_ != 0 && head.command_code == command_code_of<report_heartbeat_pulse> && controls(head.source);
        pulses_ = static_cast<std::uint8_t>(pulses_ - is_it);
        return is_it;
    }
    [[nodiscard]] constexpr bool controls(const address& who) const noexcept {
        return controller_ && controller_->address == who;
    }

    /// Takes Request and Release Component Control, Set Component Authority, and the queries of authority and control.
    /// Ask `admits` first. Confirm and Reject Component Control are for the other side: see held_control.
    constexpr message_outcome on_message(const header& head, std::span<const std::byte> body, time_point now,
                                         message_sink out) noexcept {
        switch (head.command_code) {
        case command_code_of<set_component_authority>:
            return decode_for<set_component_authority>(body, [&](const auto& m) { authority_ = m.authority_code; });
        case command_code_of<request_component_control>:
            return decode_for<request_component_control>(
                body, [&](const auto& m) { request(head, m.authority_code, now, out); });
        case command_code_of<release_component_control>:
            return decode_for<release_component_control>(body, [&](const auto&) {
                if (controls(head.source)) end(control_change::released);
            });
        case command_code_of<query_component_authority>:
            return decode_for<query_component_authority>(body, [&](const auto&) {
                static_cast<void>(answer(head, self_, report_component_authority{authority_}, out));
            });
        case command_code_of<query_component_control>:
            return decode_for<query_component_control>(body, [&](const auto&) {
                const auto [who, code] = controller_.value_or(jaus::controller{});
                static_cast<void>(
                    answer(head, self_,
                           report_component_control{who.subsystem, who.node, who.component, who.instance, code}, out));
            });
        default: return message_outcome::unhandled;
        }
    }

    /// The component takes control back: the controller, if there is one, gets Reject Component Control.
    constexpr void reject(message_sink out) noexcept { take_back(control_change::rejected, out); }
    /// Removes the components for which `gone(const address&)` is true: a controller among them loses control. No
    /// message is sent to it.
    constexpr void on_lost(auto&& gone) noexcept {
        if (controller_ && gone(std::as_const(controller_->address))) end(control_change::lost);
    }
    /// Queries the pulse of a silent controller, and ends the control of one that has been silent for the timeout.
    constexpr void on_time(time_point now, message_sink out) noexcept {
        const auto due = next_event();
        if (!due || now < *due) return;
        if (now >= saturating_add(heard_, options_.timeout)) return take_back(control_change::lost, out);
        asked_ = (now - heard_) / quarter();
        if (pulses_ != 255) ++pulses_;
        static_cast<void>(put({.destination = controller_->address, .source = self_}, query_heartbeat_pulse{}, out));
    }
    [[nodiscard]] constexpr std::optional<time_point> next_event() const noexcept {
        if (!controller_ || options_.timeout == options_.timeout.zero()) return std::nullopt;
        return saturating_add(heard_, std::min((asked_ + 1) * quarter(), options_.timeout));
    }

  private:
    constexpr void request(const header& head, std::uint8_t authority, time_point now, message_sink out) noexcept {
        using enum component_control_response;
        const bool is_controller = controls(head.source);
        if (controller_ && !is_controller && authority <= controller_->authority_code) {
            static_cast<void>(answer(head, self_, confirm_component_control{control_not_accepted}, out));
            return;
        }
        const bool is_other = controller_ && !is_controller;
        if (is_other) take_back(control_change::taken_over, out);
        last_change_ = is_other ? control_change::taken_over : control_change::granted;
        if (!is_controller) pulses_ = 0;
        controller_ = jaus::controller{head.source, authority};
        heard(head.source, now);
        static_cast<void>(answer(head, self_, confirm_component_control{control_accepted}, out));
    }

    [[nodiscard]] constexpr duration quarter() const noexcept { return std::max(options_.timeout / 4, duration{1}); }
    constexpr void end(control_change why) noexcept {
        controller_.reset();
        last_change_ = why;
    }
    // Sends Reject Component Control to the controller.
    constexpr void take_back(control_change why, message_sink out) noexcept {
        if (!controller_) return;
        static_cast<void>(put({.destination = controller_->address, .source = self_}, reject_component_control{}, out));
        end(why);
    }

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
