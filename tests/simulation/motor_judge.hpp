// Judges a motor by its own position and velocity, not by what the drive or the library reports of it.
#pragma once

#include "simulation/generator.hpp"
#include <jauscat/ethercat/cia402/emulated_axis.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace simulation {

/// Of a joint, in increments and seconds.
struct joint_limits {
    double velocity{}, acceleration{}, min_position{}, max_position{};
    double quick_stop{5e6}; ///< deceleration
};

/// A motor at one instant.
struct motor_sample {
    time at{};
    double position{}, velocity{};
    jauscat::cia402::state state{};
    jauscat::cia402::mode mode{};
    std::int32_t target_position{};
    bool is_operational{}; ///< its slave is in OP
    bool is_disturbed{};   ///< the cause of a fault is there: the drive switches itself off
    bool holds{};          ///< it does not follow its target position
};

/// What a motor did, and what it was allowed to do.
struct motor_breach {
    std::string expected{}, found{};
};

class motor_judge {
  public:
    /// Above this velocity a motor turns, in increments/s.
    static constexpr double standstill = 100;
    [[nodiscard]] static bool turns(double velocity) noexcept {
        return velocity > standstill || velocity < -standstill;
    }

    explicit motor_judge(const joint_limits& limits) noexcept : limits_{limits} {}
    /// To be called at least every millisecond.
    [[nodiscard]] std::optional<motor_breach> look(const motor_sample& now);
    /// A drive that was switched on between two increments moves to one of them first.
    [[nodiscard]] bool is_settling(time now) const noexcept { return now - powered_at_ < to_increment; }

  private:
    static constexpr time to_increment = std::chrono::milliseconds{10};
    static constexpr time to_second_set_point = std::chrono::milliseconds{20}; // two of the longest periods

    [[nodiscard]] std::optional<motor_breach> check_limits(const motor_sample& now) const;
    [[nodiscard]] std::optional<motor_breach> check_power(const motor_sample& now);
    [[nodiscard]] std::optional<motor_breach> check_set_point(const motor_sample& now);
    [[nodiscard]] std::optional<motor_breach> check_acceleration(const motor_sample& now);

    joint_limits limits_;
    std::optional<motor_sample> last_{};
    time set_point_at_{}, ramp_since_{}, mode_since_{};
    time without_power_at_{std::chrono::seconds{-1}}, powered_at_{std::chrono::seconds{-1}};
    double ramp_from_{};
};

} // namespace simulation
