// Control of another component, controller side: request with retries, renewal, loss, release. RA 3.3 part 3, core
// subgroup. The other side is component_control.hpp.
#pragma once
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
    constexpr held_control(const address& self, const address& target, const held_control_options& options = {},
                           hook<void(control_state)> changed = {}) noexcept
        : self_{self}, target_{target}, options_{options}, changed_{changed} {}

    /// Whether control is held, requested or lost.
    [[nodiscard]] constexpr control_state state() const noexcept { return state_; }
    [[nodiscard]] constexpr const address& target() const noexcept { return target_; }

    /// Requests control, or another authority if it is held already. `authority_code`: 0 lowest to 255 highest.
    constexpr void ask(std::uint8_t authority_code, time_point now, message_sink out) noexcept {
        authority_ = authority_code;
        asked_ = 0;
        if (state_ != control_state::held) enter(control_state::asking);
        request(now, out);
    }
    /// Releases control, or ends the request. The message is not answered: send it with acknowledgement request
    /// (component::send) where it must not be lost.
    constexpr void release(message_sink out) noexcept {
        const bool tell = is_wanted();
        enter(control_state::none);
        if (tell) static_cast<void>(put(head(), release_component_control{}, out));
    }

    /// Handles Confirm and Reject Component Control from the target, and its Query Heartbeat Pulse while control is
    /// requested or held. A confirmation of control that was not requested is answered with a release, and so are the
    /// first Query Heartbeat Pulses after a release, which may have been lost.
    constexpr message_outcome on_message(const header& from, std::span<const std::byte> body, time_point now,
                                         message_sink out) noexcept {
        if (from.source != target_ || is_acknowledgement(from)) return message_outcome::unhandled;
        switch (from.command_code) {
        case command_code_of<confirm_component_control>:
            return decode_for<confirm_component_control>(body, [&](const confirm_component_control& m) {
                confirm(m.response_code == component_control_response::control_accepted, now, out);
            });
        case command_code_of<reject_component_control>:
            // There are components that answer a request so.
            return decode_for<reject_component_control>(body, [&](const reject_component_control&) {
                if (state_ == control_state::held) enter(control_state::lost);
                if (state_ == control_state::asking) enter(control_state::refused);
                releases_ = 0;
            });
        case command_code_of<query_heartbeat_pulse>:
            return decode_for<query_heartbeat_pulse>(body, [&](const query_heartbeat_pulse&) {
                if (is_wanted()) {
                    static_cast<void>(answer(from, self_, report_heartbeat_pulse{}, out));
                    return message_outcome::handled;
                }
                if (releases_ != 0) {
                    --releases_;
                    static_cast<void>(put(head(), release_component_control{}, out));
                }
                return message_outcome::unhandled;
            });
        default: return message_outcome::unhandled;
        }
    }
    /// Repeats and renews requests.
    constexpr void on_time(time_point now, message_sink out) noexcept {
        const auto due = next_event();
        if (!due || now < *due) return;
        if (!options_.retry.allows_another(asked_))
            enter(control_state::unanswered);
        else
            request(now, out);
    }
    [[nodiscard]] constexpr std::optional<time_point> next_event() const noexcept {
        if (state_ == control_state::asking || (state_ == control_state::held && asked_ != 0))
            return saturating_add(at_, options_.retry.interval);
        if (state_ == control_state::held && options_.renewal != options_.renewal.zero())
            return saturating_add(at_, options_.renewal);
        return std::nullopt;
    }
    /// The component `who` is lost; an octet of 255 means all of that level.
    constexpr void on_lost(const address& who) noexcept {
        if (is_wanted() && stands_for(who, target_)) enter(control_state::lost);
    }

  private:
    static constexpr unsigned max_releases = 8;

    [[nodiscard]] constexpr bool is_wanted() const noexcept {
        return state_ == control_state::held || state_ == control_state::asking;
    }
    [[nodiscard]] constexpr header head() const noexcept { return {.destination = target_, .source = self_}; }
    constexpr void request(time_point now, message_sink out) noexcept {
        ++asked_;
        at_ = now;
        static_cast<void>(put(head(), request_component_control{authority_}, out));
    }
    constexpr void confirm(bool accepted, time_point now, message_sink out) noexcept {
        if (!is_wanted()) {
            if (accepted) static_cast<void>(put(head(), release_component_control{}, out));
            return;
        }
        asked_ = 0;
        at_ = now;
        if (accepted) return enter(control_state::held);
        enter(state_ == control_state::held ? control_state::lost : control_state::refused);
    }
    constexpr void enter(control_state state) noexcept {
        const bool was_wanted = is_wanted();
        const bool is_new = std::exchange(state_, state) != state;
        if (was_wanted && !is_wanted()) releases_ = max_releases;
        if (is_new && changed_) changed_(state);
    }

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
