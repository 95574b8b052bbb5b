// The functions of axis.
#pragma once
#include <jauscat/ethercat/cia402/axis.hpp>

namespace jauscat::cia402 {

JAUSCAT_CONSTEXPR axis_state axis::state() const noexcept {
    if (reset_ != reset_phase::none) return axis_state::resetting;
    if (error_.code != axis_errc::ok) return axis_state::failed;
    if (!has_feedback_) return axis_state::unknown;
    if (goal_ == goal::on) return is_synchronised_ ? axis_state::enabled : axis_state::enabling;
    const bool has_torque = !seen_ || *seen_ == cia402::state::operation_enabled ||
                            (*seen_ == cia402::state::quick_stop_active && !is_at_standstill());
    return has_torque ? axis_state::stopping : axis_state::disabled;
}

JAUSCAT_CONSTEXPR axis_wait axis::waits_for() const noexcept {
    if (!has_feedback_) return axis_wait::feedback;
    if (reset_ != reset_phase::none || has_fault()) return axis_wait::reset;
    if (!seen_) return axis_wait::known_state;
    const bool is_enabled = *seen_ == ds::operation_enabled;
    if (goal_ == goal::on) {
        if (!is_enabled || !was_enabled_) return axis_wait::next_state;
        if (feedback_.mode != targets_.mode) return axis_wait::mode;
        return follows() ? axis_wait::nothing : axis_wait::following;
    }
    if (is_enabled)
        return is_at_standstill() || goal_ == goal::quick_stop ? axis_wait::leaving_enabled : axis_wait::standstill;
    if (*seen_ == ds::quick_stop_active && !is_at_standstill()) return axis_wait::standstill;
    return axis_wait::nothing;
}

JAUSCAT_CONSTEXPR bool axis::follows() const noexcept {
    return targets_.mode != mode::cyclic_synchronous_position || !options_.shows_following ||
           has_bit(status_bits::follows_target);
}

JAUSCAT_CONSTEXPR result<void, axis_errc> axis::enable() noexcept {
    if (error_.code != axis_errc::ok) return axis_errc::has_failed;
    if (goal_ != goal::on) change_goal(goal::on);
    return {};
}

JAUSCAT_CONSTEXPR void axis::disable() noexcept {
    if (goal_ == goal::on) change_goal(goal::off);
}

JAUSCAT_CONSTEXPR void axis::halt(bool on) noexcept {
    is_after_halt_ = is_after_halt_ || (halted_ && !on);
    halted_ = on;
    forget_targets();
}

JAUSCAT_CONSTEXPR void axis::reset() noexcept {
    if (goal_ == goal::on) change_goal(goal::off);
    attempts_ = 0;
    if (has_fault())
        reset_ = reset_phase::requested; // the error stands until the drive has left its fault
    else
        error_ = {};
}

JAUSCAT_CONSTEXPR void axis::set_mode(mode wanted) noexcept {
    if (wanted == targets_.mode) return;
    if (!is_synchronised_) doubtful_cycles_ = status_latency;
    // Its set-points are continued; velocities are taken from what the drive says.
    is_braking_ = is_braking_ || (is_synchronised_ && targets_.mode == mode::cyclic_synchronous_position);
    targets_.mode = wanted;
    lose_synchronisation();
    mode_since_.reset();
}

JAUSCAT_CONSTEXPR result<acceptance, axis_errc> axis::move_to(std::int32_t position) noexcept {
    if (const auto refused = refusal(is_position_mode()); refused != axis_errc::ok) return refused;
    position_goal_ = std::clamp(position, options_.min_position, options_.max_position);
    is_offered_ = false;
    return accepted(*position_goal_ == position);
}

JAUSCAT_CONSTEXPR result<acceptance, axis_errc> axis::run_at(std::int32_t velocity) noexcept {
    if (const auto refused = refusal(is_velocity_mode()); refused != axis_errc::ok) return refused;
    velocity_goal_ = std::clamp(static_cast<double>(velocity), -options_.max_velocity, options_.max_velocity);
    return accepted(velocity_goal_ == velocity);
}

JAUSCAT_CONSTEXPR result<acceptance, axis_errc> axis::push_with(std::int16_t torque) noexcept {
    if (const auto refused = refusal(is_torque_mode(targets_.mode)); refused != axis_errc::ok) return refused;
    torque_goal_ = std::clamp(static_cast<int>(torque), -options_.max_torque, int{options_.max_torque});
    return accepted(torque_goal_ == torque);
}

JAUSCAT_CONSTEXPR result<void, axis_errc> axis::home() noexcept {
    if (const auto refused = refusal(targets_.mode == mode::homing); refused != axis_errc::ok) return refused;
    is_homing_ = true;
    is_homed_ = false;
    homing_cycles_ = 0;
    return {};
}

JAUSCAT_CONSTEXPR bool axis::is_target_reached() const noexcept {
    switch (targets_.mode) {
    case mode::cyclic_synchronous_position:
        return profile_.velocity() == 0 && (!position_goal_ || targets_.position == *position_goal_);
    case mode::profile_position:
        return handshake_ == handshake::idle && (!position_goal_ || is_offered_) &&
               has_bit(status_bits::target_reached);
    case mode::cyclic_synchronous_velocity: return profile_.velocity() * velocity_factor() == velocity_goal_;
    case mode::profile_velocity: return has_bit(status_bits::target_reached);
    case mode::homing: return !is_homing_;
    default: return torque_ == torque_goal_;
    }
}

JAUSCAT_CONSTEXPR bool axis::is_at_standstill() const noexcept {
    return feedback_.has_velocity ? detail::magnitude(feedback_.velocity) <= options_.standstill : is_still_;
}

JAUSCAT_CONSTEXPR bool axis::has_following_error() const noexcept {
    return is_position_mode() && seen_ == ds::operation_enabled && has_bit(status_bits::following_error);
}

JAUSCAT_CONSTEXPR const axis_targets& axis::on_cycle(const axis_feedback& feedback, time_point now) noexcept {
    feedback_ = feedback;
    const auto seen = state_of(feedback.statusword);
    if (seen != seen_ || !has_feedback_ || goal_changed_) since_ = now;
    if (!has_feedback_ || goal_changed_) goal_since_ = now;
    goal_changed_ = false;
    has_feedback_ = true;
    seen_ = seen;
    observe_position(now);
    step_ = next_step(now);
    if (has_fault()) on_fault();
    targets_.controlword = next_control(now);
    const bool enables = targets_.controlword == control_of(command::enable_operation);
    enable_words_ = enables ? std::min(enable_words_ + 1, enough_words) : 0;
    move(now);
    if (doubtful_cycles_ != 0) --doubtful_cycles_;
    return targets_;
}

JAUSCAT_CONSTEXPR const axis_targets& axis::on_lost() noexcept {
    if (has_feedback_) fail(axis_errc::inputs_lost);
    has_feedback_ = false;
    enable_words_ = 0;
    forget_positions();
    goal_ = goal::quick_stop;
    reset_ = reset_phase::none;
    lose_synchronisation();
    targets_.controlword = control_of(command::quick_stop);
    targets_.velocity = 0;
    targets_.torque = 0;
    return targets_;
}

JAUSCAT_CONSTEXPR bool axis::is_position_mode() const noexcept {
    return targets_.mode == mode::cyclic_synchronous_position || targets_.mode == mode::profile_position;
}

JAUSCAT_CONSTEXPR bool axis::is_velocity_mode() const noexcept {
    return targets_.mode == mode::cyclic_synchronous_velocity || targets_.mode == mode::profile_velocity;
}

JAUSCAT_CONSTEXPR bool axis::is_torque_mode(mode which) noexcept {
    return which == mode::cyclic_synchronous_torque || which == mode::profile_torque;
}

JAUSCAT_CONSTEXPR bool axis::moves_by_itself(mode which) noexcept {
    return which == mode::profile_position || which == mode::homing;
}

JAUSCAT_CONSTEXPR bool axis::is_pushing() const noexcept { return is_torque_mode(targets_.mode) && shows_mode(); }

JAUSCAT_CONSTEXPR bool axis::has_fault() const noexcept {
    return has_feedback_ && (seen_ == ds::fault || seen_ == ds::fault_reaction_active);
}

JAUSCAT_CONSTEXPR double axis::seconds() const noexcept {
    return std::chrono::duration<double>{options_.cycle}.count();
}

JAUSCAT_CONSTEXPR motion_limits axis::limits() const noexcept {
    const double factor = velocity_factor();
    return {.velocity = options_.max_velocity / factor,
            .acceleration = options_.acceleration / factor,
            .deceleration = options_.deceleration / factor};
}

JAUSCAT_CONSTEXPR std::int32_t axis::rounded(double value) noexcept {
    constexpr double lowest = std::numeric_limits<std::int32_t>::min();
    constexpr double highest = std::numeric_limits<std::int32_t>::max();
    return static_cast<std::int32_t>(std::clamp(value + (value < 0 ? -0.5 : 0.5), lowest, highest));
}

JAUSCAT_CONSTEXPR acceptance axis::accepted(bool exact) noexcept {
    return exact ? acceptance::exact : acceptance::limited;
}

JAUSCAT_CONSTEXPR axis_errc axis::refusal(bool has_target) const noexcept {
    if (state() != axis_state::enabled || halted_) return axis_errc::not_enabled;
    return has_target ? axis_errc::ok : axis_errc::wrong_mode;
}

JAUSCAT_CONSTEXPR void axis::change_goal(goal to) noexcept {
    goal_ = to;
    goal_changed_ = true;
    was_enabled_ = false;
    if (to != goal::off) lose_synchronisation(); // on the way to off, the ramp goes on from where it is
    forget_targets();
}

JAUSCAT_CONSTEXPR void axis::forget_targets() noexcept {
    position_goal_.reset();
    velocity_goal_ = 0;
    torque_goal_ = 0;
    is_homing_ = false;
}

JAUSCAT_CONSTEXPR void axis::lose_synchronisation() noexcept {
    is_synchronised_ = false;
    is_after_halt_ = false;
    handshake_ = handshake::idle;
    forget_targets();
}

JAUSCAT_CONSTEXPR void axis::fail(axis_errc code) noexcept {
    if (error_.code == axis_errc::ok) error_ = {.code = code, .state = seen_};
    if (goal_ != goal::quick_stop) change_goal(goal::quick_stop);
}

JAUSCAT_CONSTEXPR void axis::on_fault() noexcept {
    if (reset_ != reset_phase::none) return;
    if (error_.code == axis_errc::ok) error_ = {.code = axis_errc::drive_fault, .state = seen_};
    if (error_.drive_code == error_codes::none) error_.drive_code = feedback_.error_code;
    if (goal_ != goal::off) change_goal(goal::off);
    lose_synchronisation();
}

JAUSCAT_CONSTEXPR void axis::observe_position(time_point now) noexcept {
    if (feedback_.has_velocity || !feedback_.has_position) {
        is_still_ = false;
        return;
    }
    if (!feedback_.is_current) return forget_positions(); // nothing is known of this time
    // A stop order comes between two cycles, with the position of the last one.
    const duration elapsed = last_position_ ? now - last_position_->since : period_;
    if (elapsed > duration{} && elapsed >= period_ / 2) {
        const double moved = last_position_ ? static_cast<double>(feedback_.position) - last_position_->at : 0;
        derived_velocity_ = moved / std::chrono::duration<double>{elapsed}.count() * velocity_factor();
        last_position_ = seen_position{feedback_.position, now};
    }

    const double allowed =
        std::max(1.0, options_.standstill / velocity_factor() * std::chrono::duration<double>{still_time}.count());
    const bool has_moved =
        !still_at_ || detail::magnitude(static_cast<double>(feedback_.position) - still_at_->at) > allowed;
    if (has_moved) still_at_ = seen_position{feedback_.position, now};
    is_still_ = !has_moved && (is_still_ || now - still_at_->since >= still_time);
    // The next window begins here, so that a slow motion adds up.
    if (is_still_ && now - still_at_->since >= still_time) still_at_ = seen_position{feedback_.position, now};
}

JAUSCAT_CONSTEXPR void axis::forget_positions() noexcept {
    is_still_ = false;
    still_at_.reset();
    last_position_.reset();
}

JAUSCAT_CONSTEXPR double axis::velocity() const noexcept {
    return feedback_.has_velocity ? feedback_.velocity : derived_velocity_;
}

JAUSCAT_CONSTEXPR double axis::next_step(time_point now) noexcept {
    // Set-points are those of the time at which they are sent, also where the bus runs faster than the axis, and where
    // a stop order comes between two cycles. They are ahead of it by an eighth of a cycle at most, so that jitter costs
    // no step. What is missed in excess of a cycle of the axis is not made up for.
    const auto usual = std::min(period_, options_.cycle);
    const auto sent = now + period_;
    if (!moved_until_ || *moved_until_ < sent - options_.cycle) moved_until_ = sent - options_.cycle;
    const auto step = std::min<duration>(options_.cycle, sent + usual / 8 - *moved_until_);
    if (step < usual / 2) return 0;
    *moved_until_ += step;
    return std::chrono::duration<double>{step}.count();
}

JAUSCAT_CONSTEXPR void axis::refuse_reset() noexcept {
    reset_ = reset_phase::none;
    error_ = {.code = axis_errc::reset_refused, .state = seen_, .drive_code = feedback_.error_code};
}

JAUSCAT_CONSTEXPR std::uint16_t axis::next_control(time_point now) noexcept {
    if (has_fault()) return control_in_fault(now);
    if (reset_ != reset_phase::none) {
        if (!seen_) return control_of(command::disable_voltage); // not known to have left the fault
        reset_ = reset_phase::none;
        error_ = {};
    }
    const bool is_late = now - since_ >= options_.step_time;
    const bool is_stop_late = now - goal_since_ >= options_.step_time;
    switch (goal_) {
    case goal::on:
        // Also where each step comes in time, and the drive goes back again.
        return control_towards_on(is_late ||
                                  (!was_enabled_ && (now - goal_since_) / steps_to_on >= options_.step_time));
    case goal::off: return control_towards_off(now, is_late);
    case goal::quick_stop:
        if (is_stop_late && (!seen_ || *seen_ == ds::operation_enabled)) { // it does not do as it is told
            fail(axis_errc::step_timeout);
            return control_of(command::disable_voltage);
        }
        // At rest, and told for long enough: no torque is needed any more.
        if (is_late && seen_ == ds::quick_stop_active && is_at_standstill())
            return control_of(command::disable_voltage);
        if (now - goal_since_ >= options_.rest_time && seen_ == ds::quick_stop_active && !is_at_standstill())
            fail(axis_errc::step_timeout); // it is told, and brakes on
        break;
    }
    return control_of(seen_ != ds::switch_on_disabled ? command::quick_stop : command::disable_voltage);
}

JAUSCAT_CONSTEXPR std::uint16_t axis::control_in_fault(time_point now) noexcept {
    const bool has_waited = now - reset_since_ >= options_.reset_time;
    switch (reset_) {
    case reset_phase::none: return control_of(command::disable_voltage);
    case reset_phase::requested: enter(reset_phase::low, now); break;
    case reset_phase::low:
        if (has_waited && seen_ == ds::fault) {
            ++attempts_;
            enter(reset_phase::high, now);
        } else if (now - reset_since_ >= options_.step_time) { // its reaction to the fault does not end
            refuse_reset();
        }
        break;
    case reset_phase::high:
        if (!has_waited) break;
        if (attempts_ < options_.reset_attempts) {
            enter(reset_phase::low, now);
        } else {
            refuse_reset();
        }
        break;
    }
    return control_of(reset_ == reset_phase::high ? command::fault_reset : command::disable_voltage);
}

JAUSCAT_CONSTEXPR void axis::enter(reset_phase phase, time_point now) noexcept {
    reset_ = phase;
    reset_since_ = now;
}

JAUSCAT_CONSTEXPR std::uint16_t axis::control_towards_on(bool is_late) noexcept {
    if (was_enabled_ && seen_ != ds::operation_enabled)
        fail(axis_errc::enable_lost);
    else if (is_late && seen_ != ds::operation_enabled)
        fail(axis_errc::step_timeout);
    if (goal_ != goal::on) return control_of(command::quick_stop);
    if (!seen_) return control_of(command::quick_stop);
    switch (*seen_) {
    case ds::switch_on_disabled: return control_of(command::shutdown);
    case ds::ready_to_switch_on: return control_of(command::switch_on);
    case ds::switched_on: return control_of(command::enable_operation);
    case ds::operation_enabled:
        was_enabled_ = was_enabled_ || enable_words_ + 1 >= enough_words;
        return control_of(command::enable_operation);
    case ds::quick_stop_active: return control_of(is_at_standstill() ? command::disable_voltage : command::quick_stop);
    default: return control_of(command::disable_voltage);
    }
}

JAUSCAT_CONSTEXPR std::uint16_t axis::control_towards_off(time_point now, bool is_late) noexcept {
    if (!seen_) { // what it does is not known
        if (now - goal_since_ >= options_.step_time) fail(axis_errc::step_timeout);
        return control_of(now - since_ < options_.step_time ? command::quick_stop : command::disable_voltage);
    }
    // The status follows some cycles later. A command that ends the ramp is not taken back until it does.
    const auto last = command_of(targets_.controlword, 0);
    switch (*seen_) {
    case ds::operation_enabled:
        if (now - goal_since_ >= saturating_add(options_.rest_time, options_.step_time)) fail(axis_errc::step_timeout);
        if (is_resting() || last == command::switch_on) return control_of(command::switch_on); // disable operation
        if (last == command::enable_operation && has_ramp_time(now)) return control_of(command::enable_operation);
        return control_of(command::quick_stop);
    case ds::switched_on: break;
    case ds::quick_stop_active:
        if (now - goal_since_ >= saturating_add(options_.rest_time, options_.step_time) && !is_at_standstill())
            fail(axis_errc::step_timeout); // it is told, and brakes on
        return control_of(is_at_standstill() ? command::disable_voltage : command::quick_stop);
    default: return control_of(command::disable_voltage);
    }
    if (is_late) fail(axis_errc::step_timeout);
    return control_of(command::shutdown);
}

JAUSCAT_CONSTEXPR bool axis::has_ramp_time(time_point now) const noexcept {
    const duration whole = std::min(options_.rest_time, options_.ramp_time), left = whole - (now - goal_since_);
    const double needed = is_pushing() ? detail::magnitude(torque_) / options_.torque_slope
                                       : detail::magnitude(profile_.velocity()) / limits().deceleration;
    return left > duration{} && needed <= std::chrono::duration<double>{left}.count();
}

JAUSCAT_CONSTEXPR bool axis::is_resting() const noexcept {
    if (is_pushing()) return torque_ == 0;
    return profile_.velocity() == 0 && is_at_standstill();
}

JAUSCAT_CONSTEXPR void axis::move(time_point now) noexcept {
    if (seen_ != ds::operation_enabled || (goal_ == goal::on && !was_enabled_)) {
        was_seen_enabled_ = false;
        hold();
        return;
    }
    if (goal_ == goal::quick_stop) { // the statusword follows one cycle later
        hold();
        return;
    }
    if (!std::exchange(was_seen_enabled_, true)) mode_since_.reset();
    if (goal_ == goal::on ? synchronise(now) : takes_targets())
        step(now);
    else
        await_drive();
}

JAUSCAT_CONSTEXPR bool axis::takes_targets() const noexcept { return shows_mode() && follows(); }

JAUSCAT_CONSTEXPR bool axis::shows_mode() const noexcept {
    return feedback_.mode == targets_.mode && doubtful_cycles_ == 0;
}

JAUSCAT_CONSTEXPR void axis::hold() noexcept {
    is_braking_ = false;
    profile_.reset(feedback_.position, 0);
    torque_ = 0;
    targets_.position = feedback_.position;
    targets_.velocity = 0;
    targets_.torque = 0;
}

JAUSCAT_CONSTEXPR bool axis::synchronise(time_point now) noexcept {
    if (takes_targets()) {
        if (!is_synchronised_ && !is_braking_) take_over();
        is_synchronised_ = true;
        is_braking_ = false;
        mode_since_.reset();
        return true;
    }
    if (is_synchronised_) lose_synchronisation(); // no longer follows: the target is discarded
    if (!mode_since_) mode_since_ = now;
    if (now - *mode_since_ >= options_.step_time) {
        fail(shows_mode() ? axis_errc::not_following : axis_errc::mode_refused);
        targets_.controlword = control_of(command::quick_stop);
    }
    return false;
}

JAUSCAT_CONSTEXPR void axis::await_drive() noexcept {
    // One that has the mode may follow at any time: the targets stay where it is. Without torque it coasts, and where
    // it moves by itself it is halted.
    const bool is_by_itself = !shows_mode() && moves_by_itself(feedback_.mode);
    const bool may_brake = !shows_mode() && !is_torque_mode(feedback_.mode) && !is_by_itself;
    if (is_by_itself) targets_.controlword |= control_bits::halt;
    if (may_brake && is_braking_)
        brake();
    else
        take_over();
    is_braking_ = may_brake && !is_resting();
}

JAUSCAT_CONSTEXPR void axis::brake() noexcept {
    profile_.step_at(0, limits(), step_);
    // Set-points go on where the drive may have them.
    if (feedback_.mode != mode::cyclic_synchronous_position && doubtful_cycles_ == 0) start_at(profile_.velocity());
    targets_.position = rounded(profile_.position());
    targets_.velocity = rounded(profile_.velocity() * velocity_factor());
}

JAUSCAT_CONSTEXPR void axis::take_over() noexcept {
    start_at(is_at_standstill() ? 0 : velocity() / velocity_factor());
    torque_ = 0;
    targets_.position = rounded(profile_.position());
    targets_.velocity = rounded(profile_.velocity() * velocity_factor());
    targets_.torque = 0;
}

JAUSCAT_CONSTEXPR void axis::start_at(double velocity) noexcept {
    // Where it will be when the targets are sent, in whole units.
    constexpr double most = std::numeric_limits<std::int32_t>::max();
    const double ahead = std::clamp(velocity * std::chrono::duration<double>{period_}.count(), -most, most);
    profile_.reset(static_cast<double>(feedback_.position) + static_cast<std::int32_t>(ahead), velocity);
}

JAUSCAT_CONSTEXPR void axis::step(time_point now) noexcept {
    const bool rests = goal_ != goal::on || halted_;
    switch (targets_.mode) {
    case mode::cyclic_synchronous_position:
        if (position_goal_ && !rests)
            profile_.step_to(*position_goal_, limits(), step_);
        else
            profile_.step_at(0, limits(), step_);
        targets_.position = rounded(profile_.position());
        targets_.velocity = rounded(profile_.velocity() * velocity_factor());
        break;
    case mode::cyclic_synchronous_velocity:
        profile_.step_at(rests ? 0 : allowed_velocity(), limits(), step_);
        targets_.position = feedback_.position;
        targets_.velocity = rounded(profile_.velocity() * velocity_factor());
        break;
    case mode::cyclic_synchronous_torque:
    case mode::profile_torque:
        torque_ = detail::approach(torque_, rests ? 0 : allowed_torque(), options_.torque_slope * step_);
        targets_.position = feedback_.position;
        targets_.torque = static_cast<std::int16_t>(rounded(torque_));
        break;
    case mode::profile_velocity:
        profile_.reset(feedback_.position, 0); // the drive has the ramp
        targets_.position = feedback_.position;
        targets_.velocity = rests ? 0 : rounded(allowed_velocity() * velocity_factor());
        if (rests) targets_.controlword |= control_bits::halt;
        break;
    case mode::profile_position:
        profile_.reset(feedback_.position, 0);
        if (rests) {
            targets_.controlword |= control_bits::halt;
            handshake_ = handshake::idle;
        } else {
            offer_set_point(now);
        }
        break;
    case mode::homing:
        profile_.reset(feedback_.position, 0);
        if (rests)
            targets_.controlword |= control_bits::halt;
        else
            watch_homing();
        break;
    default: break;
    }
}

JAUSCAT_CONSTEXPR double axis::allowed_velocity() const noexcept {
    const double at = feedback_.position, deceleration = limits().deceleration;
    return std::clamp(velocity_goal_ / velocity_factor(),
                      -stopping_velocity(at - options_.min_position, deceleration, seconds()),
                      stopping_velocity(options_.max_position - at, deceleration, seconds()));
}

JAUSCAT_CONSTEXPR double axis::allowed_torque() const noexcept {
    const bool upwards = torque_goal_ > 0, downwards = torque_goal_ < 0;
    const bool is_limited =
        (upwards && (feedback_.position >= options_.max_position || velocity() >= options_.max_velocity)) ||
        (downwards && (feedback_.position <= options_.min_position || velocity() <= -options_.max_velocity));
    return is_limited ? 0 : torque_goal_;
}

JAUSCAT_CONSTEXPR void axis::offer_set_point(time_point now) noexcept {
    const bool acknowledged = has_bit(status_bits::set_point_acknowledged);
    if (is_after_halt_ && !position_goal_) {
        position_goal_ = feedback_.position;
        is_offered_ = false;
    }
    if (handshake_ == handshake::idle && position_goal_ && !is_offered_ && !acknowledged) {
        targets_.position = *position_goal_;
        targets_.profile_velocity = static_cast<std::uint32_t>(rounded(options_.max_velocity));
        handshake_ = handshake::offered;
        is_offered_ = true;
        is_after_halt_ = false;
        handshake_since_ = now;
    } else if (handshake_ == handshake::offered && acknowledged) {
        handshake_ = handshake::released;
    } else if (handshake_ == handshake::released && !acknowledged) {
        handshake_ = handshake::idle;
    }
    if (is_after_halt_) targets_.controlword |= control_bits::halt; // it would go on to its last set-point
    if (handshake_ != handshake::offered) return;
    targets_.controlword |= control_bits::new_set_point | control_bits::change_immediately;
    if (now - handshake_since_ >= options_.step_time) fail(axis_errc::not_acknowledged);
}

JAUSCAT_CONSTEXPR void axis::watch_homing() noexcept {
    if (!is_homing_) return;
    targets_.controlword |= control_bits::start_homing;
    if (homing_cycles_ < status_latency) {
        ++homing_cycles_;
    } else if (has_bit(status_bits::homing_error)) {
        fail(axis_errc::homing_failed);
    } else if (has_bit(status_bits::homing_attained) && has_bit(status_bits::target_reached)) {
        is_homing_ = false;
        is_homed_ = true;
    }
}

} // namespace jauscat::cia402
