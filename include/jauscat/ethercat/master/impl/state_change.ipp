// The functions of state_change.
#pragma once
#include <jauscat/ethercat/master/state_change.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION state_change state_change::to_init(std::uint16_t station, const slave_timeouts& limits) noexcept {
    state_change change{station, al_state::init, limits};
    change.from_ = al_state::init;
    change.step_ = step::acknowledge;
    return change;
}

JAUSCAT_FUNCTION state_change state_change::step_up(std::uint16_t station, al_state from,
                                                    const slave_timeouts& limits) noexcept {
    state_change change{station, above(from), limits};
    change.from_ = from;
    change.next_ = change.goal_;
    change.step_ = step::request;
    return change;
}

JAUSCAT_FUNCTION void state_change::request(frame_builder& frame) const noexcept {
    switch (step_) {
    case step::acknowledge:
        return frame.write(station_, esc_registers::al_control,
                           {.state = is_known(from_) ? from_ : al_state::init, .acknowledge = true});
    case step::request: return frame.write(station_, esc_registers::al_control, {.state = next_});
    case step::look:
    case step::wait_acknowledged:
    case step::wait: frame.read(station_, esc_registers::al_status);
    }
}

JAUSCAT_FUNCTION progress state_change::reply(replies datagrams, time_point now, const master_config& config) noexcept {
    if (result_ = executed_by_one(datagrams); !result_) return progress::done;
    if (step_ == step::acknowledge) return go(step::wait_acknowledged);
    if (step_ == step::request) return go(step::wait);

    const auto status = datagrams.front().value(esc_registers::al_status);
    const bool late = timeout_.expired(now, limit(config));
    switch (step_) {
    case step::look: from_ = status.state; return status.error ? go(step::acknowledge) : on_the_way();
    case step::wait_acknowledged:
        from_ = status.state;
        if (!status.error) return on_the_way();
        return late ? fail({.code = master_errc::al_error, .al_status = status.code}) : progress::wait;
    default:
        if (status.error) return fail({.code = master_errc::al_error, .al_status = status.code});
        if (status.state != next_)
            return late ? fail({.code = master_errc::state_timeout, .state = status.state}) : progress::wait;
        from_ = next_;
        return on_the_way();
    }
}

JAUSCAT_FUNCTION std::chrono::nanoseconds state_change::limit(const master_config& config) const noexcept {
    using enum al_state;
    slave_timeouts::milliseconds own{};
    if (step_ == step::wait && from_ < next_)
        own = next_ == pre_op ? limits_.pre_op : limits_.safe_op_op;
    else if (step_ == step::wait)
        own = from_ == op && next_ == safe_op ? limits_.back_to_safe_op : limits_.back_to_init;
    return own.count() != 0 ? std::chrono::nanoseconds{own} : config.state_timeout;
}

JAUSCAT_FUNCTION progress state_change::on_the_way() noexcept {
    if (from_ == goal_) return progress::done;
    next_ = towards(from_, goal_);
    return go(step::request);
}

JAUSCAT_FUNCTION al_state state_change::towards(al_state from, al_state goal) noexcept {
    if (!is_known(from)) return al_state::init;
    if (goal == al_state::boot || from == al_state::boot) return from == al_state::init ? goal : al_state::init;
    return goal < from ? goal : above(from);
}

JAUSCAT_FUNCTION al_state state_change::above(al_state state) noexcept {
    switch (state) {
    case al_state::init: return al_state::pre_op;
    case al_state::pre_op: return al_state::safe_op;
    default: return al_state::op;
    }
}

JAUSCAT_FUNCTION progress state_change::go(step next) noexcept {
    step_ = next;
    timeout_.renew();
    return progress::send;
}

JAUSCAT_FUNCTION progress state_change::fail(const master_error& error) noexcept {
    result_ = error;
    return progress::done;
}

} // namespace jauscat::ethercat
