// The functions of held_control.
#pragma once
#include <jauscat/jaus/component/held_control.hpp>

namespace jauscat::jaus {

JAUSCAT_CONSTEXPR held_control::held_control(const address& self, const address& target,
                                             const held_control_options& options,
                                             hook<void(control_state)> changed) noexcept
    : self_{self}, target_{target}, options_{options}, changed_{changed} {}

JAUSCAT_CONSTEXPR void held_control::ask(std::uint8_t authority_code, time_point now, message_sink out) noexcept {
    authority_ = authority_code;
    asked_ = 0;
    if (state_ != control_state::held) enter(control_state::asking);
    request(now, out);
}

JAUSCAT_CONSTEXPR void held_control::release(message_sink out) noexcept {
    const bool tell = is_wanted();
    enter(control_state::none);
    if (tell) static_cast<void>(put(head(), release_component_control{}, out));
}

JAUSCAT_CONSTEXPR message_outcome held_control::on_message(const header& from, std::span<const std::byte> body,
                                                           time_point now, message_sink out) noexcept {
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

JAUSCAT_CONSTEXPR void held_control::on_time(time_point now, message_sink out) noexcept {
    const auto due = next_event();
    if (!due || now < *due) return;
    if (!options_.retry.allows_another(asked_))
        enter(control_state::unanswered);
    else
        request(now, out);
}

JAUSCAT_CONSTEXPR std::optional<time_point> held_control::next_event() const noexcept {
    if (state_ == control_state::asking || (state_ == control_state::held && asked_ != 0))
        return saturating_add(at_, options_.retry.interval);
    if (state_ == control_state::held && options_.renewal > options_.renewal.zero())
        return saturating_add(at_, options_.renewal);
    return std::nullopt;
}

JAUSCAT_CONSTEXPR void held_control::on_lost(const address& who) noexcept {
    if (is_wanted() && stands_for(who, target_)) enter(control_state::lost);
}

JAUSCAT_CONSTEXPR bool held_control::is_wanted() const noexcept {
    return state_ == control_state::held || state_ == control_state::asking;
}

JAUSCAT_CONSTEXPR void held_control::request(time_point now, message_sink out) noexcept {
    ++asked_;
    at_ = now;
    static_cast<void>(put(head(), request_component_control{authority_}, out));
}

JAUSCAT_CONSTEXPR void held_control::confirm(bool accepted, time_point now, message_sink out) noexcept {
    if (!is_wanted()) {
        if (accepted) static_cast<void>(put(head(), release_component_control{}, out));
        return;
    }
    asked_ = 0;
    at_ = now;
    if (accepted) return enter(control_state::held);
    enter(state_ == control_state::held ? control_state::lost : control_state::refused);
}

JAUSCAT_CONSTEXPR void held_control::enter(control_state state) noexcept {
    const bool was_wanted = is_wanted();
    const bool is_new = std::exchange(state_, state) != state;
    if (was_wanted && !is_wanted()) releases_ = max_releases;
    if (is_new && changed_) changed_(state);
}

} // namespace jauscat::jaus
