// The functions of emulated_axis.
#pragma once
#include <jauscat/ethercat/cia402/emulated_axis.hpp>

namespace jauscat::cia402 {

JAUSCAT_CONSTEXPR void emulated_axis::place(double position) noexcept {
    position_ = demand_ = position;
    velocity_ = 0;
}

JAUSCAT_CONSTEXPR void emulated_axis::on_time(time_point now, bool is_operational) noexcept {
    if (!std::exchange(has_time_, true)) last_ = now;
    const double elapsed = std::min(std::chrono::duration<double>{now - last_}.count(), 0.1);
    last_ = now;
    if (was_operational_ && !is_operational) lose_communication();
    was_operational_ = is_operational;
    change_state(is_operational);
    for (double left = elapsed; left > 1e-9; left -= longest_step) step(std::min(left, longest_step));
    show(is_operational);
}

JAUSCAT_CONSTEXPR bool emulated_axis::is_cyclic_position() const noexcept {
    return active_mode() == mode::cyclic_synchronous_position;
}

JAUSCAT_CONSTEXPR bool emulated_axis::has_position_limits() const noexcept {
    return values.min_position_limit < values.max_position_limit;
}

JAUSCAT_CONSTEXPR double emulated_axis::interpolation_time() const noexcept {
    double seconds = values.interpolation_time;
    for (int i = values.interpolation_index; i < 0; ++i) seconds /= 10;
    return std::max(seconds, 1e-6);
}

JAUSCAT_CONSTEXPR std::int32_t emulated_axis::rounded(double value) noexcept {
    constexpr double lowest = std::numeric_limits<std::int32_t>::min();
    constexpr double highest = std::numeric_limits<std::int32_t>::max();
    return static_cast<std::int32_t>(std::clamp(value + (value < 0 ? -0.5 : 0.5), lowest, highest));
}

JAUSCAT_CONSTEXPR bool emulated_axis::has_torque() const noexcept {
    return state_ == ds::operation_enabled || state_ == ds::quick_stop_active || state_ == ds::fault_reaction_active;
}

JAUSCAT_CONSTEXPR void emulated_axis::enter(ds next) noexcept {
    if (disturbed.refused == next) return;
    if (next == ds::operation_enabled && state_ != ds::operation_enabled) start_motion();
    state_ = next;
    leaves_to_.reset();
}

JAUSCAT_CONSTEXPR void emulated_axis::start_motion() noexcept {
    demand_ = position_;
    profile_.reset(position_, velocity_);
    torque_ramp_ = 0;
    set_point_.reset();
    next_set_point_.reset();
    acknowledged_ = false;
}

JAUSCAT_CONSTEXPR void emulated_axis::fail(std::uint16_t code) noexcept {
    if (state_ == ds::fault || state_ == ds::fault_reaction_active) return;
    values.error_code = code;
    const bool moves = has_torque();
    state_ = ds::fault_reaction_active;
    leaves_to_.reset();
    stop_option_ = moves ? values.fault_reaction_option : std::int16_t{};
}

JAUSCAT_CONSTEXPR void emulated_axis::lose_communication() noexcept {
    if (state_ == ds::operation_enabled || state_ == ds::quick_stop_active) fail(error_codes::communication);
    values.controlword = 0; // disable voltage
}

JAUSCAT_CONSTEXPR void emulated_axis::change_state(bool is_operational) noexcept {
    const auto word = values.controlword;
    const auto cause = command_of(word, std::exchange(control_before_, word));
    if (disturbed.fault != error_codes::none) fail(disturbed.fault);
    if (disturbed.no_voltage && (state_ == ds::switched_on || has_torque())) fail(under_voltage);
    if (state_ == ds::not_ready_to_switch_on) return enter(ds::switch_on_disabled);
    show_mode();
    if (!is_operational && cause != command::disable_voltage && cause != command::fault_reset) return;
    const auto found = transition_of(state_, cause);
    if (state_ == ds::operation_enabled && cause == command::enable_operation) leaves_to_.reset();
    if (!found) return;
    switch (found->number) {
    case 3:
        if (!disturbed.no_voltage) enter(found->to);
        break;
    case 5: leave_to(found->to, values.disable_option); break;
    case 8: leave_to(found->to, values.shutdown_option); break;
    case 11:
        enter(found->to);
        stop_option_ = values.quick_stop_option;
        break;
    case 15:
        if (disturbed.fault != error_codes::none || disturbed.no_voltage) break;
        values.error_code = error_codes::none;
        enter(found->to);
        break;
    case 16:
        if (values.quick_stop_option >= 5) enter(found->to);
        break;
    default: enter(found->to); break;
    }
}

JAUSCAT_CONSTEXPR void emulated_axis::leave_to(ds next, std::int16_t option) noexcept {
    if (option == 0) return enter(next);
    leaves_to_ = next;
    stop_option_ = option;
}

JAUSCAT_CONSTEXPR void emulated_axis::show_mode() noexcept {
    const auto wanted = static_cast<mode>(values.mode_of_operation);
    if (wanted == active_mode() || !is_supported(values.supported_modes, wanted)) return;
    values.mode_display = values.mode_of_operation;
    homing_ = homing::idle;
    start_motion();
}

JAUSCAT_CONSTEXPR void emulated_axis::step(double seconds) noexcept {
    is_limited_ = false;
    const bool halts = state_ == ds::operation_enabled && !leaves_to_ && (values.controlword & control_bits::halt) != 0;
    if (halts) stop_option_ = values.halt_option;
    if ((values.controlword & control_bits::new_set_point) == 0) acknowledged_ = false;
    if (!has_torque() || (state_ != ds::operation_enabled && is_power_off()))
        turn(0, seconds);
    else if (state_ != ds::operation_enabled || leaves_to_ || halts)
        stop(seconds);
    else
        drive(seconds);
    end_stop();
    watch_following(seconds);
}

JAUSCAT_CONSTEXPR void emulated_axis::stop(double seconds) noexcept {
    const auto option = stop_option_ > 4 ? stop_option_ - 4 : int{stop_option_};
    const double rate = option == 1   ? values.profile_deceleration
                        : option == 2 ? values.quick_stop_deceleration
                                      : std::numeric_limits<double>::max();
    profile_.reset(position_, detail::approach(velocity_, 0, rate * seconds));
    torque_ramp_ = 0;
    demand_ = position_;
    follow_velocity(profile_.velocity(), seconds);
}

JAUSCAT_CONSTEXPR void emulated_axis::end_stop() noexcept {
    const bool rests = detail::magnitude(velocity_) < at_rest;
    if (state_ == ds::fault_reaction_active && (rests || is_power_off())) {
        state_ = ds::fault;
    } else if (state_ == ds::quick_stop_active && values.quick_stop_option < 5 && (rests || is_power_off())) {
        enter(ds::switch_on_disabled);
    } else if (leaves_to_ && rests) {
        enter(*leaves_to_);
    }
}

JAUSCAT_CONSTEXPR void emulated_axis::drive(double seconds) noexcept {
    const motion_limits limits{.velocity = static_cast<double>(values.profile_velocity),
                               .acceleration = static_cast<double>(values.profile_acceleration),
                               .deceleration = static_cast<double>(values.profile_deceleration)};
    switch (active_mode()) {
    case mode::cyclic_synchronous_position: {
        if (disturbed.holds) return follow_position(demand_, seconds);
        const double target = within_limits(static_cast<double>(values.target_position) + values.position_offset);
        const double part = interpolation_left_ > seconds ? seconds / interpolation_left_ : 1;
        interpolation_left_ = std::max(0.0, interpolation_left_ - seconds);
        follow_position(demand_ + (target - demand_) * part, seconds);
        break;
    }
    case mode::cyclic_synchronous_velocity:
        demand_ = position_;
        follow_velocity(inwards(static_cast<double>(values.target_velocity) + values.velocity_offset), seconds);
        break;
    case mode::cyclic_synchronous_torque:
        demand_ = position_;
        turn(inwards(static_cast<double>(values.target_torque) + values.torque_offset), seconds);
        break;
    case mode::profile_torque:
        demand_ = position_;
        torque_ramp_ = detail::approach(torque_ramp_, values.target_torque, values.torque_slope * seconds);
        turn(inwards(torque_ramp_), seconds);
        break;
    case mode::profile_velocity:
        demand_ = position_;
        profile_.step_at(inwards(values.target_velocity), {motor_.max_speed, limits.acceleration, limits.deceleration},
                         seconds);
        follow_velocity(profile_.velocity(), seconds);
        break;
    case mode::profile_position:
        take_set_point();
        if (set_point_)
            profile_.step_to(within_limits(*set_point_), limits, seconds);
        else
            profile_.step_at(0, limits, seconds);
        follow_position(profile_.position(), seconds);
        break;
    case mode::homing:
        home();
        follow_position(demand_, seconds);
        break;
    default: follow_position(demand_, seconds); break;
    }
}

JAUSCAT_CONSTEXPR double emulated_axis::within_limits(double target) noexcept {
    if (!has_position_limits()) return target;
    const double allowed = std::clamp<double>(target, values.min_position_limit, values.max_position_limit);
    is_limited_ = allowed != target;
    return allowed;
}

JAUSCAT_CONSTEXPR double emulated_axis::inwards(double value) noexcept {
    const bool outwards = has_position_limits() && ((value > 0 && position_ >= values.max_position_limit) ||
                                                    (value < 0 && position_ <= values.min_position_limit));
    is_limited_ = outwards;
    return outwards ? 0 : value;
}

JAUSCAT_CONSTEXPR void emulated_axis::take_set_point() noexcept {
    const bool offered = (values.controlword & control_bits::new_set_point) != 0;
    if (offered && !acknowledged_ && !next_set_point_) {
        const bool relative = (values.controlword & control_bits::relative) != 0;
        const double target = (relative ? set_point_.value_or(position_) : 0) + values.target_position;
        const bool at_once = (values.controlword & control_bits::change_immediately) != 0;
        (at_once || !set_point_ || is_reached() ? set_point_ : next_set_point_) = target;
        acknowledged_ = true;
    }
    if (next_set_point_ && is_reached()) set_point_ = std::exchange(next_set_point_, std::nullopt);
}

JAUSCAT_CONSTEXPR bool emulated_axis::is_reached() const noexcept {
    return set_point_ && profile_.velocity() == 0 &&
           detail::magnitude(*set_point_ - position_) <= values.position_window;
}

JAUSCAT_CONSTEXPR void emulated_axis::home() noexcept {
    const bool starts = (values.controlword & control_bits::start_homing) != 0;
    if (!starts) {
        if (homing_ == homing::failed) homing_ = homing::idle;
        homing_started_ = false;
        return;
    }
    if (std::exchange(homing_started_, true)) return;
    const bool here = values.homing_method == 35 || values.homing_method == 37;
    homing_ = here ? homing::done : homing::failed;
    if (here) place(values.home_offset);
}

JAUSCAT_CONSTEXPR void emulated_axis::follow_position(double demand, double seconds) noexcept {
    const double forward = (demand - demand_) / seconds;
    demand_ = demand;
    follow_velocity(forward + motor_.position_gain * (demand_ - position_ - forward * seconds), seconds);
}

JAUSCAT_CONSTEXPR void emulated_axis::follow_velocity(double wanted, double seconds) noexcept {
    velocity_demand_ = std::clamp(wanted, -motor_.max_speed, motor_.max_speed);
    turn((velocity_demand_ - velocity_) / seconds * 1000 / motor_.rated_acceleration + motor_.friction * velocity_,
         seconds);
}

JAUSCAT_CONSTEXPR void emulated_axis::turn(double torque, double seconds) noexcept {
    const double most = values.max_torque;
    if (has_torque()) is_limited_ = is_limited_ || detail::magnitude(torque) > most;
    torque_ = std::clamp(torque, -most, most);
    const double sum = torque_ - motor_.friction * velocity_ - disturbed.load;
    velocity_ += sum * motor_.rated_acceleration / 1000 * seconds;
    velocity_ = std::clamp(velocity_, -2 * motor_.max_speed, 2 * motor_.max_speed);
    if (disturbed.blocked) velocity_ = 0;
    position_ += velocity_ * seconds;
}

JAUSCAT_CONSTEXPR void emulated_axis::watch_following(double seconds) noexcept {
    const bool positions = is_cyclic_position() || active_mode() == mode::profile_position;
    is_behind_ = state_ == ds::operation_enabled && positions &&
                 detail::magnitude(demand_ - position_) > values.following_error_window;
    behind_for_ = is_behind_ ? behind_for_ + seconds : 0;
    if (behind_for_ * 1000 > values.following_error_time && is_behind_) fail(error_codes::following_error);
}

JAUSCAT_CONSTEXPR void emulated_axis::show(bool is_operational) noexcept {
    values.position_actual = rounded(position_);
    values.position_demand = rounded(demand_);
    values.velocity_actual = rounded(velocity_);
    values.velocity_demand = rounded(velocity_demand_);
    values.torque_actual = values.torque_demand = values.current_actual =
        static_cast<std::int16_t>(rounded(has_torque() ? torque_ : 0));
    values.following_error = rounded(demand_ - position_);
    unsigned word = status_of(state_);
    const auto set = [&word](std::uint16_t bit, bool on) {
        if (on) word |= bit;
    };
    set(status_bits::voltage_enabled, !disturbed.no_voltage);
    set(status_bits::warning, disturbed.warning);
    set(status_bits::remote, is_operational);
    set(status_bits::internal_limit, is_limited_);
    if (state_ == ds::operation_enabled) word |= mode_bits();
    values.statusword = static_cast<std::uint16_t>(word);
}

JAUSCAT_CONSTEXPR unsigned emulated_axis::mode_bits() const noexcept {
    const bool halts = (values.controlword & control_bits::halt) != 0;
    const bool rests = detail::magnitude(velocity_) < at_rest;
    const auto when = [](bool on, std::uint16_t bit) { return on ? unsigned{bit} : 0u; };
    switch (active_mode()) {
    case mode::cyclic_synchronous_position:
    case mode::cyclic_synchronous_velocity:
    case mode::cyclic_synchronous_torque:
        return when(!leaves_to_ && !halts && !(disturbed.holds && is_cyclic_position()), status_bits::follows_target) |
               when(is_behind_, status_bits::following_error);
    case mode::profile_position:
        return when(halts ? rests : is_reached() && !next_set_point_, status_bits::target_reached) |
               when(acknowledged_ || next_set_point_, status_bits::set_point_acknowledged) |
               when(is_behind_, status_bits::following_error);
    case mode::profile_velocity:
        return when(halts ? rests : profile_.velocity() == values.target_velocity, status_bits::target_reached) |
               when(rests, status_bits::speed_is_zero);
    case mode::homing:
        return when(homing_ == homing::done || (rests && (homing_ == homing::failed || !homing_started_)),
                    status_bits::target_reached) |
               when(homing_ == homing::done, status_bits::homing_attained) |
               when(homing_ == homing::failed, status_bits::homing_error);
    default: return 0;
    }
}

} // namespace jauscat::cia402
