// Set-points with limited velocity and acceleration, one for each cycle. No memory, no clock.
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace jauscat::cia402 {

/// Limits of a motion, in units of position, a second and a second squared; all above 0.
struct motion_limits {
    double velocity{};
    double acceleration{};
    double deceleration{};
};

namespace detail {

[[nodiscard]] constexpr double magnitude(double value) noexcept { return value < 0 ? -value : value; }

// std::sqrt is not constexpr in C++20.
[[nodiscard]] constexpr double square_root(double value) noexcept {
    if (!std::is_constant_evaluated()) return std::sqrt(value);
    if (value <= 0) return 0;
    double root = value < 1 ? 1 : value;
    for (double next = (root + value / root) / 2; next < root; next = (root + value / root) / 2) root = next;
    return root;
}

/// `from` moved towards `to` by at most `step`.
[[nodiscard]] constexpr double approach(double from, double to, double step) noexcept {
    return to > from ? std::min(to, from + step) : std::max(to, from - step);
}

} // namespace detail

/// The highest velocity of a step of `seconds` after which `deceleration` stops within `distance`; 0 at a distance of 0
/// or below.
[[nodiscard]] constexpr double stopping_velocity(double distance, double deceleration, double seconds) noexcept {
    if (distance <= 0) return 0;
    return deceleration * (detail::square_root(seconds * seconds + 2 * distance / deceleration) - seconds);
}

/// A point that moves within limits.
class motion_profile {
  public:
    constexpr void reset(double position, double velocity) noexcept {
        position_ = position;
        velocity_ = velocity;
    }
    [[nodiscard]] constexpr double position() const noexcept { return position_; }
    [[nodiscard]] constexpr double velocity() const noexcept { return velocity_; }

    /// One step of `seconds` towards rest at `goal`.
    constexpr void step_to(double goal, const motion_limits& limits, double seconds) noexcept {
        const double distance = goal - position_, step = limits.deceleration * seconds;
        if (detail::magnitude(distance) <= step * seconds && detail::magnitude(velocity_) <= 2 * step) {
            reset(goal, 0);
            return;
        }
        const double fastest = stopping_velocity(detail::magnitude(distance), limits.deceleration, seconds);
        step_at(distance < 0 ? -fastest : fastest, limits, seconds);
    }
    /// One step of `seconds` towards the velocity `goal`.
    constexpr void step_at(double goal, const motion_limits& limits, double seconds) noexcept {
        const double wanted = std::clamp(goal, -limits.velocity, limits.velocity);
        const bool slows = velocity_ > 0 ? wanted < velocity_ : wanted > velocity_;
        // Through 0, the rest of the step is left for the next one.
        const double to = velocity_ * wanted < 0 ? 0 : wanted;
        const double rate = velocity_ != 0 && slows ? limits.deceleration : limits.acceleration;
        velocity_ = detail::approach(velocity_, to, rate * seconds);
        position_ += velocity_ * seconds;
    }

  private:
    double position_{};
    double velocity_{};
};

} // namespace jauscat::cia402
