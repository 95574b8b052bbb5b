// The functions of component.
#pragma once
#include <jauscat/bridge/component.hpp>

namespace jauscat::bridging {

JAUSCAT_FUNCTION component::component(const jaus::address& self, slave_front& front, process_part& part,
                                      const jaus::component_options& options) noexcept
    : component{self, front, &part, {}, options} {}

JAUSCAT_FUNCTION component::component(const jaus::address& self, std::span<slave_front* const> group,
                                      process_part& part, const jaus::component_options& options) noexcept
    : component{self, *group.front(), &part, group, options} {}

JAUSCAT_FUNCTION void component::on_time(time_point now, jaus::message_sink out) {
    show_pending_stops();
    core_.on_time(now, out);
    follow_up(now, out);
}

JAUSCAT_FUNCTION std::optional<time_point> component::next_event() const {
    return motion_is_dropped_ || foreign_motion_is_dropped_ ? std::optional{time_point::min()} : core_.next_event();
}

JAUSCAT_FUNCTION void component::shut_down(time_point now, jaus::message_sink out) {
    ends_ = true;
    core_.change(jaus::state_event::shutdown);
    if (stops_.settled()) require_rest(stop_cause::program_ends);
    follow_up(now, out);
}

JAUSCAT_FUNCTION void component::on_slave_lost(time_point now, jaus::message_sink out) {
    if (process_)
        process_->end([&](const jaus::header& head) { on_not_executed(head, {.why = refusal::slave_down}, now, out); });
    fail(stop_cause::slave_absent, out);
    follow_up(now, out);
}

JAUSCAT_FUNCTION void component::on_step(const std::optional<drive_fault>& fault, time_point now,
                                         jaus::message_sink out) {
    const bool was_faulted = fault_.has_value();
    fault_ = fault;
    tell_faults(fault);
    if (was_faulted && !fault) front_.watcher().fault_ended(*this);
    if (!was_faulted && fault)
        fail(stop_cause::drive_fault, out);
    else if (fault && core_.state() == jaus::primary_status_code::initialize)
        core_.change(jaus::state_event::failed); // after a Reset
    if (was_faulted || fault) follow_up(now, out);
}

JAUSCAT_FUNCTION std::size_t component::stop_message(stop_order what, std::span<std::byte> out) const noexcept {
    const jaus::header head{.ack_nak = jaus::ack_nak::request, .destination = self(), .source = self()};
    if (what == stop_order::emergency) {
        jaus::set_emergency stop{};
        stop.emergency_code.set(jaus::set_emergency_code::transition_to_emergency);
        return jaus::make_message(head, stop, out)->size();
    }
    if (what == stop_order::clear_emergency) {
        jaus::clear_emergency clear{};
        clear.emergency_code.set(jaus::clear_emergency_code::clear_emergency);
        return jaus::make_message(head, clear, out)->size();
    }
    jaus::set_wrench_effort nothing{};
    wire::visit(nothing, [](auto, auto& effort) { effort = 0.0; });
    return jaus::make_message(head, nothing, out)->size();
}

JAUSCAT_FUNCTION void component::on_confirmed(stop_order what, time_point now, jaus::message_sink out) {
    stops_.confirmed(what);
    if (!stops_.stop_is_pending()) answer_waiting(false, true, now, out);
    if (!stops_.clear_is_pending()) answer_waiting(true, what == stop_order::clear_emergency, now, out);
    if (stops_.settled()) front_.watcher().settled(*this);
    follow_up(now, out);
}

JAUSCAT_FUNCTION void component::on_refused(stop_order what, bool unknown, const refusal_reason& why, time_point now,
                                            jaus::message_sink out) {
    const bool goes_on = stops_.refused(what, unknown, now);
    front_.watcher().stop_refused(*this, what, why, stops_.refusals());
    if (!goes_on) answer_waiting(true, false, now, out);
    if (!stops_.stop_is_pending()) answer_waiting(false, true, now, out);
    if (goes_on && stops_.settled()) front_.watcher().settled(*this); // it is at rest, and has no emergencies
    follow_up(now, out);
}

JAUSCAT_FUNCTION void component::on_executed(const jaus::header& head, time_point now, jaus::message_sink out) {
    static_cast<void>(core_.finish(head, true, now, out)); // not requested by every message
}

JAUSCAT_FUNCTION void component::on_not_executed(const jaus::header& head, const refusal_reason& why, time_point now,
                                                 jaus::message_sink out) {
    front_.watcher().refused(*this, head, why);
    static_cast<void>(core_.finish(head, false, now, out)); // not requested by every message
}

JAUSCAT_FUNCTION void component::on_not_accepted(const jaus::header& head, time_point now, jaus::message_sink out) {
    on_not_executed(head, {.why = refusal::not_accepted}, now, out);
    if (!stops_.stop_is_pending()) require_rest(stop_cause::not_accepted);
}

JAUSCAT_FUNCTION component::component(const jaus::address& self, slave_front& front, process_part* part,
                                      std::span<slave_front* const> group,
                                      const jaus::component_options& options) noexcept
    : front_{front},
      stops_{front.timing().stop_interval},
      core_{self,
            memory_,
            {.on_state = jaus::bound<&component::changed_state>(*this),
             .on_controller = jaus::bound<&component::changed_controller>(*this),
             .on_state_command = jaus::bound<&component::state_command>(*this)},
            options} {
    std::array<slave_front*, 1> one{&front};
    const auto fronts = group.empty() ? std::span<slave_front* const>{one} : group;
    if (part != nullptr) process_.emplace(*part, fronts);
    for (auto* const each : fronts) static_cast<void>(each->add(*this)); // has room: see above
    stops_.require_rest();                                               // what the actuator does is not known yet
}

JAUSCAT_FUNCTION jaus::message_outcome component::accept(jaus::header head, bytes body, time_point now,
                                                         jaus::message_sink out) {
    const auto refuse = [&](refusal why) {
        front_.watcher().refused(*this, head, {.why = why});
        return jaus::message_outcome::refused;
    };
    if (process_ && !process_->part().uses_mailbox() && !process_->takes(head)) return jaus::message_outcome::unhandled;
    if (!is_up()) return refuse(refusal::slave_down);
    const order message{.header = head, .unit = this, .expires = deadline{now, front_.timing().order_timeout}};
    const auto superseded = [&](const jaus::header& older) {
        on_not_executed(older, {.why = refusal::superseded}, now, out);
    };
    switch (front_.orders().push(message, body, superseded, places_of_others())) {
    case queued::full: return refuse(refusal::queue_full);
    case queued::too_large: return refuse(refusal::too_large);
    case queued::merged: front_.watcher().merged(*this, head); break;
    case queued::last: break;
    }
    front_.wake();
    return jaus::message_outcome::deferred;
}

JAUSCAT_FUNCTION std::size_t component::places_of_others() const noexcept {
    const auto& orders = front_.orders();
    if (!orders.has_one_of(*this)) return 0;
    return static_cast<std::size_t>(std::ranges::count_if(front_.components(), [&](const component* each) {
        return &each->front_ == &front_ && !orders.has_one_of(*each);
    }));
}

JAUSCAT_FUNCTION jaus::message_outcome component::state_command(const jaus::header& head) {
    using enum jaus::message_outcome;
    if (head.command_code == jaus::command_code_of<jaus::reset> && process_) process_->reset();
    if (head.command_code == jaus::command_code_of<jaus::resume>) return handled;
    if (head.command_code == jaus::command_code_of<jaus::clear_emergency>) {
        if (core_.state() == jaus::primary_status_code::emergency) return handled; // others hold it
        stops_.require_clear();
        front_.wake();
    }
    if (stops_.settled()) return handled;
    // The core passes a repeated Set Emergency on; of other commands a message with a waiting one's header is new.
    const auto same = [&](const jaus::header& each) {
        return each.source == head.source && each.sequence_number == head.sequence_number &&
               each.command_code == head.command_code &&
               head.command_code == jaus::command_code_of<jaus::set_emergency>;
    };
    const auto known = std::span{waiting_}.first(waiting_count_);
    if (head.ack_nak != jaus::ack_nak::request || std::ranges::any_of(known, same)) return deferred;
    if (waiting_count_ == waiting_.size())
        return refused; // executed; a repeat finds a place when the others are confirmed
    waiting_[waiting_count_++] = head;
    return deferred;
}

JAUSCAT_FUNCTION void component::answer_waiting(bool clears, bool executed, time_point now, jaus::message_sink out) {
    std::size_t left = 0;
    for (const jaus::header& each : std::span{waiting_}.first(waiting_count_))
        if ((each.command_code == jaus::command_code_of<jaus::clear_emergency>) == clears)
            static_cast<void>(core_.finish(each, executed, now, out)); // not requested by every message
        else
            waiting_[left++] = each;
    waiting_count_ = left;
}

JAUSCAT_FUNCTION void component::changed_state(jaus::primary_status_code from, jaus::primary_status_code to) {
    front_.watcher().changed_state(*this, from, to);
    if (to == jaus::primary_status_code::emergency)
        require_emergency(stop_cause::state);
    else if (from == jaus::primary_status_code::ready && is_up())
        require_rest(ends_ ? stop_cause::program_ends : stop_cause::state);
}

JAUSCAT_FUNCTION void component::changed_controller(const std::optional<jaus::controller>& by,
                                                    jaus::control_change why) {
    const bool is_lost = why == jaus::control_change::lost;
    if (core_.control().lost_mover()) return require_rest(stop_cause::sender_lost); // a loss, but not of control
    front_.watcher().changed_controller(*this, why);
    if (is_lost) require_rest(stop_cause::controller_lost);
    // Queued motion commands of others than the new controller are dropped, and none of theirs is executed later.
    if (why == jaus::control_change::lost || why == jaus::control_change::released) return;
    if (by && process_ && process_->has_command_of_others(by->address)) require_rest(stop_cause::control_taken);
    foreign_motion_is_dropped_ = true;
    front_.wake();
}

JAUSCAT_FUNCTION void component::fail(stop_cause why, jaus::message_sink out) {
    using enum jaus::primary_status_code;
    was_at_rest_ = was_at_rest_ || core_.state() == standby || core_.state() == emergency;
    require_stop_of_state(why);
    core_.change(jaus::state_event::failed);
    core_.reject_control(out);
}

JAUSCAT_FUNCTION void component::require_stop_of_state(stop_cause why) {
    if (core_.state() == jaus::primary_status_code::emergency)
        require_emergency(why);
    else
        require_rest(why);
}

JAUSCAT_FUNCTION void component::require_rest(stop_cause why) {
    stops_.require_rest();
    core_.at_rest();
    drops_motion();
    front_.watcher().stop_required(*this, stop_order::rest, why);
}

JAUSCAT_FUNCTION void component::require_emergency(stop_cause why) {
    stops_.require_emergency();
    core_.at_rest();
    drops_motion();
    front_.watcher().stop_required(*this, stop_order::emergency, why);
}

JAUSCAT_FUNCTION void component::tell_faults(const std::optional<drive_fault>& one) {
    if (!one) {
        told_fault_count_ = 0;
        return;
    }
    std::array<drive_fault, fault_capacity> faults{};
    auto count = process_ ? process_->faults(faults) : 0;
    if (count == 0) faults[count++] = *one;
    const auto known = told_faults_;
    const auto known_end = known.begin() + static_cast<std::ptrdiff_t>(told_fault_count_);
    told_fault_count_ = 0;
    for (const auto& each : std::span{faults}.first(count)) {
        const auto told = std::span{told_faults_}.first(told_fault_count_);
        if (std::ranges::find(told, each) != told.end()) continue; // another axis of the same drive
        told_faults_[told_fault_count_++] = each;
        if (std::find(known.begin(), known_end, each) == known_end) front_.watcher().faulted(*this, each);
    }
}

JAUSCAT_FUNCTION void component::show_pending_stops() noexcept {
    core_.set_secondary_status((is_up() ? 0 : secondary_status::slave_absent) |
                               (fault_ ? secondary_status::drive_fault : 0) |
                               (stops_.rest_is_pending() ? secondary_status::rest_unconfirmed : 0) |
                               (stops_.emergency_is_pending() ? secondary_status::emergency_unconfirmed : 0) |
                               (stops_.clear_is_pending() ? secondary_status::clear_unconfirmed : 0));
}

JAUSCAT_FUNCTION void component::drops_motion() {
    motion_is_dropped_ = true;
    front_.wake();
}

JAUSCAT_FUNCTION void component::follow_up(time_point now, jaus::message_sink out) {
    if (std::exchange(foreign_motion_is_dropped_, false)) {
        const auto& controller = core_.control().controller();
        drop_motion(now, out, [&](const jaus::address& who) { return !controller || controller->address != who; });
    }
    if (std::exchange(motion_is_dropped_, false)) {
        drop_motion(now, out, [](const jaus::address&) { return true; });
        if (!stops_.clear_is_pending()) answer_waiting(true, false, now, out); // a new emergency arrived before
    }
    if (!is_up() || fault_ || !stops_.settled()) return;
    if (core_.state() == jaus::primary_status_code::failure) core_.change(jaus::state_event::reset);
    if (core_.state() != jaus::primary_status_code::initialize) return;
    core_.change(jaus::state_event::initialized);
    if (std::exchange(was_at_rest_, false)) core_.change(jaus::state_event::standby);
}

} // namespace jauscat::bridging
