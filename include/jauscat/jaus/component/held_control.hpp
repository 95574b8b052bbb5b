// Control of another component, controller side: request with retries, renewal, loss, release. RA 3.3 part 3, core
// subgroup. The other side is component_control.hpp.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/jaus/message/hook.hpp>
#include <jauscat/jaus/message/stands_for.hpp>
#include <jauscat/schema/jaus/communications.hpp>
#include <jauscat/schema/jaus/core.hpp>

#include <chrono>
#include <optional>
#include <utility>

namespace jauscat::jaus {

/// State of the control of another component.
enum class control_state : std::uint8_t {
    none,       ///< not wanted, or released
    asking,     ///< requested, no answer yet
    held,       ///< confirmed
    refused,    ///< not confirmed: another of at least this authority has it
    lost,       ///< ended by Reject Component Control: another component of higher authority has it, or it expired
    unanswered, ///< abandoned: no answer to the maximum number of requests
};

struct held_control_options {
    retry_policy retry{.interval = std::chrono::seconds{1}, .attempts = 3}; ///< of a request that is not answered
    /// Interval of renewing requests: keeps control alive at the component, and detects its loss. 0: never.
    duration renewal{};
};

/// Control of the component `target` by the component `self`. After a refusal or a loss, call ask() to try again.
class held_control {
  public:
    /// `changed` is called with each new state; it must outlive this object.
    JAUSCAT_CONSTEXPR held_control(const address& self, const address& target, const held_control_options& options = {},
                                   hook<void(control_state)> changed = {}) noexcept;

    /// Whether control is held, requested or lost.
    [[nodiscard]] constexpr control_state state() const noexcept { return state_; }
    [[nodiscard]] constexpr const address& target() const noexcept { return target_; }

    /// Requests control, or another authority if it is held already. `authority_code`: 0 lowest to 255 highest.
    JAUSCAT_CONSTEXPR void ask(std::uint8_t authority_code, time_point now, message_sink out) noexcept;
    /// Releases control, or ends the request. The message is not answered: send it with acknowledgement request
    /// (component::send) where it must not be lost.
    JAUSCAT_CONSTEXPR void release(message_sink out) noexcept;

    /// Handles Confirm and Reject Component Control from the target, and its Query Heartbeat Pulse while control is
    /// requested or held. A confirmation of control that was not requested is answered with a release, and so are the
    /// first Query Heartbeat Pulses after a release, which may have been lost.
    JAUSCAT_CONSTEXPR message_outcome on_message(const header& from, std::span<const std::byte> body, time_point now,
                                                 message_sink out) noexcept;
    /// Repeats and renews requests.
    JAUSCAT_CONSTEXPR void on_time(time_point now, message_sink out) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR std::optional<time_point> next_event() const noexcept;
    /// The component `who` is lost; an octet of 255 means all of that level.
    JAUSCAT_CONSTEXPR void on_lost(const address& who) noexcept;

  private:
    static constexpr unsigned max_releases = 8;

    [[nodiscard]] JAUSCAT_CONSTEXPR bool is_wanted() const noexcept;
    [[nodiscard]] constexpr header head() const noexcept { return {.destination = target_, .source = self_}; }
    JAUSCAT_CONSTEXPR void request(time_point now, message_sink out) noexcept;
    JAUSCAT_CONSTEXPR void confirm(bool accepted, time_point now, message_sink out) noexcept;
    JAUSCAT_CONSTEXPR void enter(control_state state) noexcept;

    address self_;
    address target_;
    held_control_options options_;
    hook<void(control_state)> changed_;
    control_state state_{};
    std::uint8_t authority_{};
    std::uint32_t asked_{}; // requests since the last answer
    unsigned releases_{};   // sent when the target still queries the pulse
    time_point at_{};       // of the last request or answer
};

} // namespace jauscat::jaus

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jaus/component/impl/held_control.ipp>
#endif
