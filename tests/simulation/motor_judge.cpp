#include "simulation/motor_judge.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace simulation {
namespace {

namespace cia402 = jauscat::cia402;

bool has_power(cia402::state state) {
    return state == cia402::state::operation_enabled || state == cia402::state::quick_stop_active ||
           state == cia402::state::fault_reaction_active;
}
bool is_following(const motor_sample& one) {
    return one.is_operational && !one.is_disturbed && !one.holds && one.state == cia402::state::operation_enabled;
}
bool has_set_points(const motor_sample& one) {
    return is_following(one) && one.mode == cia402::mode::cyclic_synchronous_position;
}
std::string number(double value, std::string_view unit) { return std::to_string(std::llround(value)).append(unit); }

} // namespace

std::optional<motor_breach> motor_judge::look(const motor_sample& now) {
    auto found = check_limits(now);
    if (!found) found = check_power(now);
    if (auto step = check_set_point(now); !found) found = std::move(step);
    if (auto ramp = check_acceleration(now); !found) found = std::move(ramp);
    last_ = now;
    return found;
}

// The drive's position controller overshoots by less than 15 %. A motor brakes behind a limit for as long as its ramp
// or its quick stop takes from the highest velocity.
std::optional<motor_breach> motor_judge::check_limits(const motor_sample& now) const {
    const double fastest = limits_.velocity * 1.15 + motor_judge::standstill;
    if (std::abs(now.velocity) > fastest)
        return motor_breach{"a velocity of at most " + number(fastest, "/s"), number(now.velocity, "/s")};
    const double slowest = std::min(limits_.acceleration, limits_.quick_stop);
    const double braking = limits_.velocity * limits_.velocity / (2 * slowest) + limits_.velocity / 20;
    if (now.position < limits_.min_position - braking || now.position > limits_.max_position + braking)
        return motor_breach{"a position from " + number(limits_.min_position, " to ") +
                                number(limits_.max_position, ", and ") + number(braking, " to brake"),
                            number(now.position, "")};
    return std::nullopt;
}

std::optional<motor_breach> motor_judge::check_power(const motor_sample& now) {
    const bool is_new = now.at - without_power_at_ < to_increment;
    if (!has_power(now.state)) without_power_at_ = now.at;
    if (has_power(now.state) && last_ && !has_power(last_->state)) powered_at_ = now.at;
    if (is_new || !last_ || now.is_disturbed || last_->is_disturbed || !turns(now.velocity)) return std::nullopt;
    if (last_->is_operational && !now.is_operational)
        return motor_breach{"OP until the motor stands still", "out of OP at " + number(now.velocity, "/s")};
    if (has_power(last_->state) && !has_power(now.state))
        return motor_breach{"torque until the motor stands still", "switched off at " + number(now.velocity, "/s")};
    return std::nullopt;
}

std::optional<motor_breach> motor_judge::check_set_point(const motor_sample& now) {
    if (!last_ || !has_set_points(now) || !has_set_points(*last_)) {
        set_point_at_ = now.at;
        return std::nullopt;
    }
    if (now.target_position == last_->target_position) return std::nullopt;
    const double seconds = std::chrono::duration<double>{now.at - set_point_at_}.count();
    const double most = limits_.velocity * (seconds * 1.1 + 0.0002) + 2;
    const double step =
        std::abs(static_cast<double>(now.target_position) - static_cast<double>(last_->target_position));
    set_point_at_ = now.at;
    if (step <= most) return std::nullopt;
    return motor_breach{"a set-point at most " + number(most, " from the last one"), number(step, "")};
}

// Over 50 ms, since each set-point is followed with a delay. A drive that takes positions in motion waits for its
// second set-point, and may change its mode again meanwhile: neither its first nor its last velocity is that of a
// moment in a mode that it has just taken.
std::optional<motor_breach> motor_judge::check_acceleration(const motor_sample& now) {
    constexpr time window = std::chrono::milliseconds{50};
    const bool follows = is_following(now) && last_ && is_following(*last_);
    const bool has_mode = now.at - mode_since_ >= to_second_set_point;
    const bool is_new_mode = follows && now.mode != last_->mode;
    if (!follows || is_new_mode) mode_since_ = now.at;
    if (!follows || (is_new_mode && has_mode)) {
        ramp_since_ = now.at;
        ramp_from_ = now.velocity;
        return std::nullopt;
    }
    if (now.at - ramp_since_ < window || is_new_mode || !has_mode) return std::nullopt;
    const double seconds = std::chrono::duration<double>{now.at - ramp_since_}.count();
    const double most = limits_.acceleration * seconds * 1.25 + limits_.velocity * 0.15 + motor_judge::standstill;
    const double change = std::abs(now.velocity - ramp_from_);
    ramp_since_ = now.at;
    ramp_from_ = now.velocity;
    if (change <= most) return std::nullopt;
    return motor_breach{"a velocity that changes by at most " + number(most, "/s in 50 ms"), number(change, "/s")};
}

} // namespace simulation
