// One axis of an emulated drive: state machine, modes, limits, and a motor with inertia and friction. Time is an
// argument.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/ethercat/cia402/drive_values.hpp>
#include <jauscat/ethercat/cia402/motion_profile.hpp>
#include <jauscat/schema/ethercat/cia402.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace jauscat::cia402 {

/// The motor and its load, at the shaft.
struct motor_model {
    double rated_acceleration{1e7}; ///< increments/s^2 at the rated torque: the inertia
    double friction{0.001};         ///< per mille of the rated torque for each increment/s
    double max_speed{1e6};          ///< increments/s
    double position_gain{100};      ///< of the position controller, 1/s
};

/// Faults and disturbances.
struct disturbance {
    std::uint16_t fault{};                  ///< the cause of a fault with this code is there
    bool no_voltage{};                      ///< the supply of the power stage is off
    bool blocked{};                         ///< the shaft does not turn
    bool warning{};                         ///< bit 7
    bool holds{};                           ///< bit 12 is 0: it does not follow its target position
    double load{};                          ///< torque against the motor, per mille of the rated torque
    std::optional<cia402::state> refused{}; ///< a state that the drive does not enter
};

class emulated_axis {
  public:
    constexpr emulated_axis() noexcept = default;
    explicit constexpr emulated_axis(const motor_model& motor) noexcept : motor_{motor} {}

    /// The values of its objects; those that are written are read at the next `on_time`.
    drive_values values{};
    disturbance disturbed{};

    [[nodiscard]] constexpr cia402::state state() const noexcept { return state_; }
    [[nodiscard]] constexpr double position() const noexcept { return position_; }
    [[nodiscard]] constexpr double velocity() const noexcept { return velocity_; }
    /// Turns the shaft to a position.
    JAUSCAT_CONSTEXPR void place(double position) noexcept;

    /// New targets have come: in cyclic synchronous position they are reached within the interpolation time (60C2h).
    JAUSCAT_CONSTEXPR void on_targets() noexcept { interpolation_left_ = interpolation_time(); }
    /// Up to `now`; `is_operational`: the slave is in OP. A drive that was and is no more stops with error 7500h. At
    /// most 0.1 s are simulated at once.
    JAUSCAT_CONSTEXPR void on_time(time_point now, bool is_operational) noexcept;

  private:
    using ds = cia402::state;
    static constexpr double longest_step = 0.001;
    static constexpr double at_rest = 1.0; // increments/s

    [[nodiscard]] constexpr mode active_mode() const noexcept { return static_cast<mode>(values.mode_display); }
    [[nodiscard]] JAUSCAT_CONSTEXPR bool is_cyclic_position() const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR bool has_position_limits() const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR double interpolation_time() const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR static std::int32_t rounded(double value) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR bool has_torque() const noexcept;

    // States.

    JAUSCAT_CONSTEXPR void enter(ds next) noexcept;
    JAUSCAT_CONSTEXPR void start_motion() noexcept;
    JAUSCAT_CONSTEXPR void fail(std::uint16_t code) noexcept;
    JAUSCAT_CONSTEXPR void lose_communication() noexcept;

    JAUSCAT_CONSTEXPR void change_state(bool is_operational) noexcept;
    JAUSCAT_CONSTEXPR void leave_to(ds next, std::int16_t option) noexcept;
    JAUSCAT_CONSTEXPR void show_mode() noexcept;

    // Motion. All rates for `seconds`.

    JAUSCAT_CONSTEXPR void step(double seconds) noexcept;
    [[nodiscard]] constexpr bool is_power_off() const noexcept { return stop_option_ == 0; }
    JAUSCAT_CONSTEXPR void stop(double seconds) noexcept;
    /// What follows when it has come to rest.
    JAUSCAT_CONSTEXPR void end_stop() noexcept;

    JAUSCAT_CONSTEXPR void drive(double seconds) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR double within_limits(double target) noexcept;
    /// `value`, a velocity or torque, or 0 where it points out of the position limits.
    [[nodiscard]] JAUSCAT_CONSTEXPR double inwards(double value) noexcept;
    JAUSCAT_CONSTEXPR void take_set_point() noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR bool is_reached() const noexcept;
    /// Methods 35 and 37: here and now. The others have no switches.
    JAUSCAT_CONSTEXPR void home() noexcept;

    JAUSCAT_CONSTEXPR void follow_position(double demand, double seconds) noexcept;
    JAUSCAT_CONSTEXPR void follow_velocity(double wanted, double seconds) noexcept;
    /// The motor under a torque, per mille.
    JAUSCAT_CONSTEXPR void turn(double torque, double seconds) noexcept;
    JAUSCAT_CONSTEXPR void watch_following(double seconds) noexcept;

    // What it shows.

    JAUSCAT_CONSTEXPR void show(bool is_operational) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR unsigned mode_bits() const noexcept;

    enum class homing : std::uint8_t { idle, done, failed };
    static constexpr std::uint16_t under_voltage = 0x3220;

    motor_model motor_{};
    cia402::state state_{};
    std::uint16_t control_before_{};
    std::optional<cia402::state> leaves_to_{}; // while it slows down in operation enabled
    std::int16_t stop_option_{};
    bool has_time_{}, was_operational_{};
    time_point last_{};

    double position_{}, velocity_{}, torque_{};
    double demand_{}, velocity_demand_{}, torque_ramp_{};
    double interpolation_left_{};
    motion_profile profile_{};
    std::optional<double> set_point_{}, next_set_point_{};
    bool acknowledged_{};
    homing homing_{};
    bool homing_started_{};
    bool is_limited_{}, is_behind_{};
    double behind_for_{}; // seconds
};

} // namespace jauscat::cia402

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/cia402/impl/emulated_axis.ipp>
#endif
