// A CiA 402 drive on a bus, in the units of an application.
#pragma once
#include <jauscat/app/bus.hpp>
#include <jauscat/ethercat/cia402/axis.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {
class drive_state;
}

/// An axis in units of the application: radians or metres, and newton metres or newtons.
struct drive_options {
    std::size_t axis{};      ///< of a drive with several, from 0
    double increments{1};    ///< units of position of the drive in one of the application
    double velocity_units{}; ///< units of velocity of the drive in one of the application a second; 0: `increments`
    double torque_units{1};  ///< per mille of the rated torque in one unit of the application
    double max_velocity{};   ///< a second; more than 0
    double acceleration{};   ///< a second, in a second; more than 0
    double deceleration{};   ///< the same; 0: as `acceleration`
    double max_torque{};     ///< 0: the rated torque
    std::optional<double> min_position{};
    std::optional<double> max_position{};
    double position_window{}; ///< a position is reached within it; 0: what the axis moves in 1 ms at `max_velocity`
    double velocity_window{}; ///< a velocity is reached within it, a second; 0: a hundredth of `max_velocity`
    duration settling_time{std::chrono::seconds{1}}; ///< from the end of the profile until the motor is at the target
    cia402::axis_options times{}; ///< its times, the slope of the torque, `standstill` and `shows_following`
    operate_options operate{};    ///< of its slave: the period is one that 60C2h can have, such as 1 ms
};

/// What is known of a drive after a cycle, in units of the application.
struct drive_feedback {
    cia402::axis_state state{};
    cia402::axis_wait waits_for{}; ///< what it has been told to do, and has not done yet
    cia402::mode mode{};
    double position{};
    double velocity{}; ///< a second
    double torque{};
    bool is_current{};        ///< of the last cycle
    bool is_target_reached{}; ///< by the motor, within the window; or there is none
    bool is_limited{};        ///< the last target is beyond a limit, which was used in its place
    cia402::axis_error error{};
};

/// An axis of a slave with process data of CiA 402. A handle, copied like a pointer. It has two sides:
/// - operations, which end when the drive has done what it was told, or has failed. The next operation or target
///   replaces the one that waits, which then ends with operation_aborted; its cancellation ends the wait alone.
/// - values for `bus::every_cycle`: `feedback()`, and targets that count from the next cycle on.
///
/// Errors of operations: those of slave::async_operate, cia402::axis_errc (`drive_fault`, `not_enabled`, `wrong_mode`,
/// ...), slave_lost, and needs_cycles before `async_operate`. A drive that has failed comes to rest; only `async_reset`
/// ends that, and only `async_enable` lets it move again. The end of the bus brings it to rest by a quick stop.
///
///     jauscat::drive wheel{bus.slave({.position = 0}), {.increments = 10'000, .max_velocity = 2, .acceleration = 4}};
///     co_await wheel.async_operate();
///     co_await wheel.async_enable(cia402::mode::cyclic_synchronous_position);
///     co_await wheel.async_move_to(1.5);
class drive {
  public:
    /// Throws `std::invalid_argument` for options out of range.
    JAUSCAT_DECL drive(const slave& of, const drive_options& options);

    /// Takes the slave to OP. Its objects are where its PDO mapping has them; 60C2h gets the period. The axis is off.
    /// `void(error_code)`, as all operations here.
    template <class Token = default_token> auto async_operate(Token&& token = Token{}) {
        return initiate(&drive::operate, token);
    }
    /// To operation enabled in this mode. not_configurable: the mode needs an object that the process data do not have.
    template <class Token = default_token> auto async_enable(cia402::mode mode, Token&& token = Token{}) {
        return initiate(&drive::enable, token, mode);
    }
    /// To rest by ramp, and off.
    template <class Token = default_token> auto async_disable(Token&& token = Token{}) {
        return initiate(&drive::disable, token);
    }
    /// To rest by quick stop, and off.
    template <class Token = default_token> auto async_quick_stop(Token&& token = Token{}) {
        return initiate(&drive::stop_quickly, token);
    }
    /// Clears the error, and resets a fault of the drive. The axis is off.
    template <class Token = default_token> auto async_reset(Token&& token = Token{}) {
        return initiate(&drive::reset, token);
    }
    /// Until the motor is at the position. not_reached: it is not within `drive_options::settling_time` after the end
    /// of the profile; in profile position, after it stands still. The axis keeps its target. Position modes.
    template <class Token = default_token> auto async_move_to(double position, Token&& token = Token{}) {
        return initiate(&drive::begin_move, token, position);
    }
    /// Until the motor has the velocity. not_reached as of a position. Velocity modes.
    template <class Token = default_token> auto async_run_at(double velocity, Token&& token = Token{}) {
        return initiate(&drive::begin_run, token, velocity);
    }
    /// By the method in 6098h. Homing mode.
    template <class Token = default_token> auto async_home(Token&& token = Token{}) {
        return initiate(&drive::home, token);
    }

    /// For each cycle: the target from the next one on. Errors: not_enabled, wrong_mode, std::errc::invalid_argument
    /// (not a number).
    JAUSCAT_DECL app::error_code move_to(double position) const;
    JAUSCAT_DECL app::error_code run_at(double velocity) const;
    JAUSCAT_DECL app::error_code push_with(double torque) const;
    /// While `on`, it comes to rest and stays enabled.
    JAUSCAT_DECL void halt(bool on) const;
    [[nodiscard]] JAUSCAT_DECL drive_feedback feedback() const;
    /// The axis behind it, in units of the drive. For use in `bus::every_cycle`, or without a thread of the bus.
    [[nodiscard]] JAUSCAT_DECL const cia402::axis& axis() const noexcept;

  private:
    JAUSCAT_DECL void operate(const app::operation_ptr<>& done) const;
    JAUSCAT_DECL void enable(const app::operation_ptr<>& done, cia402::mode mode) const;
    JAUSCAT_DECL void disable(const app::operation_ptr<>& done) const;
    JAUSCAT_DECL void stop_quickly(const app::operation_ptr<>& done) const;
    JAUSCAT_DECL void reset(const app::operation_ptr<>& done) const;
    JAUSCAT_DECL void begin_move(const app::operation_ptr<>& done, double position) const;
    JAUSCAT_DECL void begin_run(const app::operation_ptr<>& done, double velocity) const;
    JAUSCAT_DECL void home(const app::operation_ptr<>& done) const;
    [[nodiscard]] JAUSCAT_DECL boost::asio::any_io_executor executor() const noexcept;

    template <class Token, class... Arguments>
    auto initiate(void (drive::*what)(const app::operation_ptr<>&, Arguments...) const, Token&& token,
                  Arguments... arguments) {
        return boost::asio::async_initiate<Token, void(app::error_code)>(
            [](auto handler, const drive& self, auto begin, auto... with) {
                (self.*begin)(app::make_operation<>(std::move(handler), app::no_conversion{}, self.executor()),
                              with...);
            },
            token, *this, what, arguments...);
    }

    std::shared_ptr<app::drive_state> state_;
};

} // namespace JAUSCAT_WAY
} // namespace jauscat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/app/impl/drive.ipp>
#endif
