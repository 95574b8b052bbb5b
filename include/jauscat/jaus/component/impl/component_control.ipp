// The functions of component_control.
#pragma once
#include <jauscat/jaus/component/component_control.hpp>

namespace jauscat::jaus {

JAUSCAT_CONSTEXPR command_rule component_control::rule(std::uint16_t command_code) const noexcept {
    const auto& harmless = options_.harmless;
    const bool is_harmless = std::ranges::find(harmless, command_code) != harmless.end();
    return is_harmless ? command_rule::open : rule_of(command_code);
}

JAUSCAT_CONSTEXPR bool component_control::admits(const header& head) noexcept {
    if (controls(head.source) || !controller_ || rule(head.command_code) == command_rule::open) return true;
    ++refused_;
    return false;
}

JAUSCAT_CONSTEXPR void component_control::heard(const address& who, time_point now) noexcept {
    if (!controls(who)) return;
    heard_ = now;
    asked_ = 0;
}

JAUSCAT_CONSTEXPR bool component_control::takes_pulse(const header& head) noexcept {
    const bool is_it =
        pulses_ != 0 && head.command_code == command_code_of<report_heartbeat_pulse> && controls(head.source);
    pulses_ = static_cast<std::uint8_t>(pulses_ - is_it);
    return is_it;
}

JAUSCAT_CONSTEXPR bool component_control::controls(const address& who) const noexcept {
    return controller_ && controller_->address == who;
}

JAUSCAT_CONSTEXPR message_outcome component_control::on_message(const header& head, std::span<const std::byte> body,
                                                                time_point now, message_sink out) noexcept {
    switch (head.command_code) {
    case command_code_of<set_component_authority>:
        return decode_for<set_component_authority>(body, [&](const auto& m) { authority_ = m.authority_code; });
    case command_code_of<request_component_control>:
        return decode_for<request_component_control>(body,
                                                     [&](const auto& m) { request(head, m.authority_code, now, out); });
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

JAUSCAT_CONSTEXPR void component_control::on_time(time_point now, message_sink out) noexcept {
    const auto due = next_event();
    if (!due || now < *due) return;
    if (now >= saturating_add(heard_, options_.timeout)) return take_back(control_change::lost, out);
    asked_ = (now - heard_) / quarter();
    if (pulses_ != 255) ++pulses_;
    static_cast<void>(put({.destination = controller_->address, .source = self_}, query_heartbeat_pulse{}, out));
}

JAUSCAT_CONSTEXPR std::optional<time_point> component_control::next_event() const noexcept {
    if (!controller_ || options_.timeout == options_.timeout.zero()) return std::nullopt;
    return saturating_add(heard_, std::min((asked_ + 1) * quarter(), options_.timeout));
}

JAUSCAT_CONSTEXPR void component_control::request(const header& head, std::uint8_t authority, time_point now,
                                                  message_sink out) noexcept {
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

JAUSCAT_CONSTEXPR void component_control::end(control_change why) noexcept {
    controller_.reset();
    last_change_ = why;
}

JAUSCAT_CONSTEXPR void component_control::take_back(control_change why, message_sink out) noexcept {
    if (!controller_) return;
    static_cast<void>(put({.destination = controller_->address, .source = self_}, reject_component_control{}, out));
    end(why);
}

} // namespace jauscat::jaus
