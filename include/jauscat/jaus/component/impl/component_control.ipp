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
    const bool is_admitted = would_admit(head);
    if (!is_admitted) ++refused_;
    return is_admitted;
}

JAUSCAT_CONSTEXPR bool component_control::would_admit(const header& head) const noexcept {
    if (controls(head.source)) return true;
    const command_rule rule_of_it = rule(head.command_code);
    const bool needs_control = controller_.has_value() || (rule_of_it == command_rule::moving &&
                                                           options_.without_control == motion_without_control::refused);
    return !needs_control || rule_of_it == command_rule::open;
}

JAUSCAT_CONSTEXPR void component_control::heard(const header& head, time_point now) noexcept {
    if (head.command_code == command_code_of<query_heartbeat_pulse>) return;
    const auto hear = [&](watch& life) {
        life.heard = now;
        life.asked = 0;
    };
    if (controls(head.source)) hear(life_);
    if (mover* const found = mover_of(head.source)) hear(found->life);
}

JAUSCAT_CONSTEXPR bool component_control::takes_pulse(const header& head) noexcept {
    if (head.command_code != command_code_of<report_heartbeat_pulse>) return false;
    const auto take = [](watch& life) {
        const bool is_it = life.pulses != 0;
        life.pulses = static_cast<std::uint8_t>(life.pulses - is_it);
        return is_it;
    };
    if (controls(head.source) && take(life_)) return true;
    mover* const found = mover_of(head.source);
    return found != nullptr && take(found->life);
}

JAUSCAT_CONSTEXPR bool component_control::controls(const address& who) const noexcept {
    return controller_ && controller_->address == who;
}

JAUSCAT_CONSTEXPR void component_control::obeyed(const header& head, message_outcome outcome, time_point now) noexcept {
    const bool is_executed = outcome == message_outcome::handled;
    if (!is_executed && outcome != message_outcome::deferred) return;
    if (!is_motion(head)) return;
    mover& sender = watched(head.source, now);
    if (is_executed)
        replace_others(sender.sender);
    else
        ++sender.waiting;
}

JAUSCAT_CONSTEXPR void component_control::finished(const header& head, bool executed, time_point now) noexcept {
    if (!is_motion(head)) return;
    mover* found = mover_of(head.source);
    if (found == nullptr && executed) found = &watched(head.source, now);
    if (found == nullptr) return;              // the actuators were brought to rest meanwhile
    if (found->waiting != 0) --found->waiting; // else it is one from before the actuators were brought to rest
    found->is_in_force = true;
    if (executed) replace_others(head.source);
}

JAUSCAT_CONSTEXPR void component_control::at_rest() noexcept {
    mover_count_ = 0;
    lost_mover_.reset();
}

JAUSCAT_CONSTEXPR bool component_control::is_moved_by(const address& who) const noexcept {
    return std::ranges::find(moving(), who, &mover::sender) != moving().end();
}

JAUSCAT_CONSTEXPR component_control::mover* component_control::mover_of(const address& who) noexcept {
    const auto all = moving();
    const auto found = std::ranges::find(all, who, &mover::sender);
    return found == all.end() ? nullptr : &*found;
}

JAUSCAT_CONSTEXPR component_control::mover& component_control::watched(const address& who, time_point now) noexcept {
    mover added{.sender = who, .life = {.heard = now}};
    if (const mover* const known = mover_of(who)) {
        added = *known;
        remove(*known);
    }
    if (mover_count_ == movers_.size()) {
        const auto all = moving();
        const auto waiting = std::ranges::find(all, false, &mover::is_in_force);
        remove(waiting == all.end() ? all.front() : *waiting);
    }
    return movers_[mover_count_++] = added;
}

JAUSCAT_CONSTEXPR void component_control::remove(const mover& gone) noexcept {
    for (auto i = static_cast<std::size_t>(&gone - movers_.data()); i + 1 < mover_count_; ++i)
        movers_[i] = movers_[i + 1];
    --mover_count_;
}

JAUSCAT_CONSTEXPR void component_control::replace_others(const address& who) noexcept {
    for (std::size_t i = mover_count_; i-- != 0;) {
        movers_[i].is_in_force = movers_[i].sender == who;
        if (!movers_[i].is_in_force && movers_[i].waiting == 0) remove(movers_[i]);
    }
}

JAUSCAT_CONSTEXPR void component_control::lose(const address& who) noexcept {
    lost_mover_ = who;
    mover_count_ = 0; // all come to rest
}

JAUSCAT_CONSTEXPR bool component_control::is_motion(const header& head) const noexcept {
    return options_.without_control != motion_without_control::unwatched &&
           rule(head.command_code) == command_rule::moving;
}

JAUSCAT_CONSTEXPR time_point component_control::next_event(const watch& life) const noexcept {
    return saturating_add(life.heard, std::min((life.asked + 1) * quarter(), options_.timeout));
}

JAUSCAT_CONSTEXPR bool component_control::look(watch& life, const address& who, time_point now,
                                               message_sink out) noexcept {
    if (now < next_event(life)) return true;
    if (now >= saturating_add(life.heard, options_.timeout)) return false;
    life.asked = (now - life.heard) / quarter();
    if (life.pulses != 255) ++life.pulses;
    static_cast<void>(put({.destination = who, .source = self_}, query_heartbeat_pulse{}, out));
    return true;
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
    if (!is_timed()) return;
    if (controller_ && !look(life_, controller_->address, now, out)) take_back(control_change::lost, out);
    for (mover& each : moving())
        if (!controls(each.sender) && !look(each.life, each.sender, now, out)) return lose(each.sender);
}

JAUSCAT_CONSTEXPR std::optional<time_point> component_control::next_event() const noexcept {
    std::optional<time_point> first;
    if (!is_timed()) return first;
    if (controller_) first = next_event(life_);
    for (const mover& each : moving())
        if (const auto next = next_event(each.life); !controls(each.sender) && (!first || next < *first)) first = next;
    return first;
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
    if (!is_controller) life_ = {};
    controller_ = jaus::controller{head.source, authority};
    heard(head, now);
    static_cast<void>(answer(head, self_, confirm_component_control{control_accepted}, out));
}

JAUSCAT_CONSTEXPR void component_control::end(control_change why) noexcept {
    controller_.reset();
    last_change_ = why;
    if (why == control_change::lost) mover_count_ = 0; // all come to rest
}

JAUSCAT_CONSTEXPR void component_control::take_back(control_change why, message_sink out) noexcept {
    if (!controller_) return;
    static_cast<void>(put({.destination = controller_->address, .source = self_}, reject_component_control{}, out));
    end(why);
}

} // namespace jauscat::jaus
