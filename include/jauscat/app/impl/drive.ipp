// The functions of drive.
#pragma once
#include <jauscat/app/detail/explained.hpp>
#include <jauscat/app/impl/drive_state.hpp>
#include <jauscat/app/impl/numbered.hpp>
#include <jauscat/ethercat/cia402/error_text.hpp>
#include <jauscat/ethercat/cia402/start_up.hpp>
#include <jauscat/text/hex.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

namespace detail {

/// The nearest number that the drive can have.
inline std::int32_t in_drive(double value) noexcept {
    using limits = std::numeric_limits<std::int32_t>;
    return static_cast<std::int32_t>(
        std::round(std::clamp<double>(value, double{limits::min()}, double{limits::max()})));
}

inline cia402::axis_options axis_options_of(const drive_options& options) {
    const auto require = [](bool holds, const char* what) {
        if (!holds) throw std::invalid_argument{std::string{"drive: "} + what};
    };
    const auto is_positive = [](double value) { return std::isfinite(value) && value > 0; };
    const double velocity_units = options.velocity_units == 0 ? options.increments : options.velocity_units;
    const double deceleration = options.deceleration == 0 ? options.acceleration : options.deceleration;
    require(std::isfinite(options.increments) && options.increments != 0, "increments is a number, and not 0");
    require(std::isfinite(velocity_units) && velocity_units / options.increments > 0,
            "velocity_units has the sign of increments");
    require(std::isfinite(options.torque_units) && options.torque_units != 0, "torque_units is a number, and not 0");
    require(is_positive(options.max_velocity), "max_velocity is more than 0");
    require(is_positive(options.acceleration), "acceleration is more than 0");
    require(is_positive(deceleration), "deceleration is more than 0");
    require(options.max_torque >= 0 && std::isfinite(options.max_torque), "max_torque is 0 or more");
    require(!options.min_position || !options.max_position || *options.min_position < *options.max_position,
            "min_position is below max_position");
    require(options.position_window >= 0 && std::isfinite(options.position_window), "position_window is 0 or more");
    require(options.velocity_window >= 0 && std::isfinite(options.velocity_window), "velocity_window is 0 or more");
    require(options.settling_time > options.settling_time.zero(), "settling_time is more than 0");
    require(options.axis < cia402::max_axes, "a drive has up to 8 axes");
    require(cia402::interpolation_period_of(options.operate.period).has_value(),
            "the period is one that 60C2h can have, such as 1 ms or 250 us");
    auto made = options.times;
    made.cycle = options.operate.period;
    made.max_velocity = options.max_velocity * std::abs(velocity_units);
    made.acceleration = options.acceleration * std::abs(velocity_units);
    made.deceleration = deceleration * std::abs(velocity_units);
    made.velocity_of_position = velocity_units / options.increments;
    if (options.max_torque != 0)
        made.max_torque =
            static_cast<std::int16_t>(std::min(options.max_torque * std::abs(options.torque_units), 32'767.0));
    const bool is_turned = options.increments < 0;
    if (const auto& low = is_turned ? options.max_position : options.min_position)
        made.min_position = in_drive(*low * options.increments);
    if (const auto& high = is_turned ? options.min_position : options.max_position)
        made.max_position = in_drive(*high * options.increments);
    return made;
}

} // namespace detail

JAUSCAT_DECL drive_state::drive_state(const slave& of, const drive_options& options)
    : slave_{of},
      options_{options},
      velocity_units_{options.velocity_units == 0 ? options.increments : options.velocity_units},
      axis_{detail::axis_options_of(options)} {}

JAUSCAT_DECL std::string drive_state::name() const {
    error_code error;
    const auto info = slave_.info(error);
    return error ? std::string{"the drive"} : name_of(info);
}
JAUSCAT_DECL error_code drive_state::error_of(const cia402::axis_error& error) const {
    const auto plain = make_error_code(error.code);
    auto text = name() + ": " + plain.message();
    if (error.drive_code != cia402::error_codes::none)
        text += ": " + numbered("%04Xh", error.drive_code) + " (" +
                std::string{cia402::describe_error_code(error.drive_code)} + ")";
    return explained(plain, text);
}

// ---- Operations.

JAUSCAT_DECL void drive_state::replace(operation_ptr<> done) {
    const auto before = std::exchange(done_, std::move(done));
    if (before) before->complete(boost::asio::error::operation_aborted);
}
JAUSCAT_DECL void drive_state::finish(error_code why) {
    const auto ended = std::exchange(done_, nullptr);
    if (ended) ended->complete(why);
}
/// Ends the operation that waits, if its wish is fulfilled or cannot be.
JAUSCAT_DECL void drive_state::settle(time_point now) {
    if (!done_) return;
    using enum cia402::axis_state;
    const auto state = axis_.state();
    if (state == failed && wish_ != wish::reset) return finish(error_of(axis_.error()));
    if (state == failed && axis_.error().code == cia402::axis_errc::reset_refused)
        return finish(error_of(axis_.error()));
    const bool is_done = [&] {
        switch (wish_) {
        case wish::enabled: return state == enabled;
        case wish::off:
        case wish::reset: return state == disabled;
        case wish::target: return state == enabled && is_at_target();
        case wish::homed: return state == enabled && axis_.is_homed();
        }
        return true;
    }();
    if (is_done) return finish({});
    if (wish_ == wish::target && state == enabled && is_too_late(now)) finish(error_of(cia402::axis_errc::not_reached));
}
/// Of a cyclic mode the axis knows where its set-points are, and of profile velocity the drive's bit may be that of the
/// target before; where the motor is, its feedback says.
JAUSCAT_DECL bool drive_state::is_at_target() const {
    if (!axis_.is_target_reached()) return false;
    const auto is_within = [](double value, double target, double window) {
        return std::abs(value - target) <= std::max(window, 1.0); // a unit of the drive at least
    };
    switch (axis_.targets().mode) {
    case cia402::mode::cyclic_synchronous_position: {
        const double window = options_.position_window != 0 ? options_.position_window : options_.max_velocity / 1000;
        return !axis_.feedback().has_position ||
               is_within(axis_.feedback().position, axis_.targets().position, window * std::abs(options_.increments));
    }
    case cia402::mode::profile_velocity:
    case cia402::mode::cyclic_synchronous_velocity: {
        const double window = options_.velocity_window != 0 ? options_.velocity_window : options_.max_velocity / 100;
        return is_within(axis_.velocity(), axis_.targets().velocity, window * std::abs(velocity_units_));
    }
    default: return true; // the drive's own bit
    }
}
/// Whether the motor has had the settling time: since the end of the set-points, or, where the drive has a profile of
/// its own, since it stands still.
JAUSCAT_DECL bool drive_state::is_too_late(time_point now) {
    const auto mode = axis_.targets().mode;
    const bool is_own_profile = mode == cia402::mode::profile_position || mode == cia402::mode::profile_velocity;
    if (!(is_own_profile ? axis_.is_at_standstill() : axis_.is_target_reached()))
        settles_since_.reset();
    else if (!settles_since_)
        settles_since_ = now;
    return settles_since_ && now - *settles_since_ >= options_.settling_time;
}

/// Goes on with `next()`, under the lock, unless an operation has failed or the drive's has ended.
template <class F> auto drive_state::later(const operation_ptr<>& done, F next) {
    return [self = shared_from_this(), done, next](error_code error, auto... results) {
        if (done->is_done()) return;
        if constexpr (std::is_invocable_v<F, error_code, decltype(results)...>) {
            next(error, results...);
        } else {
            if (error) return done->complete(error);
            next(results...);
        }
    };
}

JAUSCAT_DECL void drive_state::operate(const operation_ptr<>& done) {
    {
        const auto locked = lock();
        boost::system::error_code error;
        const auto station = slave_.info(error).station;
        const bool is_in_op = !error && slave_.bus()->data_at(station);
        if (is_in_op && uses(station)) return done->complete({});
        // A drive with several axes: another of them has taken it to OP.
        const auto known = is_in_op ? slave_.bus()->objects_of(station) : std::span<const ethercat::process_object>{};
        if (known.size() == objects_.size()) {
            std::ranges::copy(known, objects_.begin());
            operating();
            return done->complete({});
        }
        is_operating_ = false;
        finish(boost::asio::error::operation_aborted);
    }
    slave_.async_change(ethercat::al_state::pre_op, later(done, [this, done] { write_cycle_time({}, done); }));
}

namespace detail {

/// The slave has no such object: no other period than its own, or no such axis.
inline bool is_absent(error_code error) {
    return error == ethercat::abort_code::no_object || error == ethercat::abort_code::no_subindex;
}
inline std::uint8_t value_of(const cia402::interpolation_period& period, std::uint8_t subindex) noexcept {
    return subindex == 1 ? period.value : static_cast<std::uint8_t>(period.index);
}

} // namespace detail

JAUSCAT_DECL drive_state::cycle_time drive_state::after(const cycle_time& which) noexcept {
    if (which.subindex == 1) return {.axis = which.axis, .subindex = 2};
    return {.axis = which.axis + 1};
}
JAUSCAT_DECL void drive_state::write_cycle_time(cycle_time which, const operation_ptr<>& done) {
    if (which.axis == cia402::max_axes) return come_to_op(done);
    const auto index = cia402::objects::interpolation_time.index_of(which.axis);
    const auto value = detail::value_of(*cia402::interpolation_period_of(options_.operate.period), which.subindex);
    slave_.async_read<std::uint8_t>(index, which.subindex, later(done, [=, this](error_code error, std::uint8_t is) {
                                        if (detail::is_absent(error)) return come_to_op(done);
                                        if (error) return done->complete(error);
                                        if (is == value) return write_cycle_time(after(which), done);
                                        slave_.async_write(index, which.subindex, value,
                                                           later(done, [=, this] { verify_cycle_time(which, done); }));
                                    }));
}
JAUSCAT_DECL void drive_state::verify_cycle_time(cycle_time which, const operation_ptr<>& done) {
    const auto index = cia402::objects::interpolation_time.index_of(which.axis);
    const auto value = detail::value_of(*cia402::interpolation_period_of(options_.operate.period), which.subindex);
    slave_.async_read<std::uint8_t>(
        index, which.subindex, later(done, [=, this](std::uint8_t is) {
            if (is == value) return write_cycle_time(after(which), done);
            done->complete(explained(bus_errc::not_configurable,
                                     name() + ": " + text::hex_number(index, 4) + ":" + std::to_string(which.subindex) +
                                         " does not keep the period of the cycles: " + std::to_string(value) +
                                         " was written, " + std::to_string(is) + " is read"));
        }));
}
JAUSCAT_DECL void drive_state::come_to_op(const operation_ptr<>& done) {
    find_objects();
    auto how = options_.operate;
    how.objects = objects_;
    slave_.async_operate(how, later(done, [this, done] {
                             const auto locked = lock();
                             operating();
                             done->complete({});
                         }));
}
JAUSCAT_DECL void drive_state::find_objects() {
    namespace o = cia402::objects;
    constexpr std::array<const cia402::object*, 6> outputs{&o::controlword,     &o::mode_of_operation,
                                                           &o::target_position, &o::target_velocity,
                                                           &o::target_torque,   &o::profile_velocity};
    constexpr std::array<const cia402::object*, 6> inputs{&o::statusword,      &o::mode_display,  &o::position_actual,
                                                          &o::velocity_actual, &o::torque_actual, &o::error_code};
    std::size_t count = 0;
    const auto want = [&](const cia402::object& each, std::size_t axis, bool is_output) {
        objects_[count++] = {.index = each.index_of(axis), .subindex = each.subindex, .is_output = is_output};
    };
    for (std::size_t axis = 0; axis != cia402::max_axes; ++axis) {
        for (const auto* const each : outputs) want(*each, axis, true);
        for (const auto* const each : inputs) want(*each, axis, false);
    }
}
/// The slave is in OP, and its objects have their places.
JAUSCAT_DECL void drive_state::operating() {
    struct found_objects {
        std::span<const ethercat::process_object> all;
        bool is_output;
        [[nodiscard]] cia402::pdo_place find(const cia402::object& what, std::size_t axis) const {
            const auto found = std::ranges::find_if(all, [&](const ethercat::process_object& each) {
                return each.is_output == is_output && each.index == what.index_of(axis) &&
                       each.subindex == what.subindex;
            });
            if (found == all.end()) return {};
            return {
                .first_bit = found->first_bit, .bits = found->bits, .subindex = found->subindex, .index = found->index};
        }
    };
    places_ = cia402::places_of(found_objects{objects_, true}, found_objects{objects_, false}, options_.axis);
    axis_ = cia402::axis{axis_.options()};
    boost::system::error_code error;
    station_ = slave_.info(error).station;
    is_operating_ = true;
    slave_.bus()->add(shared_from_this());
}

JAUSCAT_DECL void drive_state::begin(operation_ptr<> done, wish what,
                                     const std::function<cia402::axis_errc(cia402::axis&)>& begin) {
    const auto locked = lock();
    if (!is_operating_)
        return done->complete(explained(bus_errc::needs_cycles, name() + " is not in operation: use async_operate"));
    if (const auto error = begin(axis_); error != cia402::axis_errc::ok) return done->complete(error_of(error));
    replace(std::move(done));
    wish_ = what;
    settles_since_.reset();
}
JAUSCAT_DECL void drive_state::enable(const operation_ptr<>& done, cia402::mode mode) {
    const auto locked = lock();
    if (!is_operating_ || places_.mode.is_mapped() || places_.fixed_mode == mode) return enable_in_mode(done, mode);
    // The mode goes by SDO.
    slave_.async_write(cia402::objects::mode_of_operation.index_of(options_.axis), 0, static_cast<std::int8_t>(mode),
                       later(done, [this, done, mode] {
                           const auto again = lock();
                           places_.fixed_mode = mode;
                           enable_in_mode(done, mode);
                       }));
}
JAUSCAT_DECL void drive_state::enable_in_mode(const operation_ptr<>& done, cia402::mode mode) {
    if (const auto* const lacks = is_operating_ ? places_.missing_for(mode) : nullptr)
        return done->complete(explained(
            bus_errc::not_configurable,
            name() + ": its process data do not have " + text::hex_number(lacks->index_of(options_.axis), 4) + " (" +
                std::string{lacks->name} + "), which mode " + std::to_string(static_cast<int>(mode)) + " needs"));
    begin(done, wish::enabled, [mode](cia402::axis& axis) {
        axis.set_mode(mode);
        return axis.enable().error();
    });
}

// ---- Values.

JAUSCAT_DECL cia402::axis_errc drive_state::set_position(double position) {
    const double wanted = position * options_.increments;
    const auto target = detail::in_drive(wanted);
    const auto taken = axis_.move_to(target);
    is_limited_ = taken && (*taken == cia402::acceptance::limited || std::abs(wanted - target) > 1);
    return taken.error();
}
JAUSCAT_DECL cia402::axis_errc drive_state::set_velocity(double velocity) {
    const double wanted = velocity * velocity_units_;
    const auto target = detail::in_drive(wanted);
    const auto taken = axis_.run_at(target);
    is_limited_ = taken && (*taken == cia402::acceptance::limited || std::abs(wanted - target) > 1);
    return taken.error();
}
JAUSCAT_DECL error_code drive_state::move_to(double position) {
    const auto locked = lock();
    if (!std::isfinite(position)) return boost::system::errc::make_error_code(boost::system::errc::invalid_argument);
    const auto error = set_position(position);
    if (error == cia402::axis_errc::ok) finish(boost::asio::error::operation_aborted);
    return make_error_code(error);
}
JAUSCAT_DECL error_code drive_state::run_at(double velocity) {
    const auto locked = lock();
    if (!std::isfinite(velocity)) return boost::system::errc::make_error_code(boost::system::errc::invalid_argument);
    const auto error = set_velocity(velocity);
    if (error == cia402::axis_errc::ok) finish(boost::asio::error::operation_aborted);
    return make_error_code(error);
}
JAUSCAT_DECL error_code drive_state::push_with(double torque) {
    const auto locked = lock();
    if (!std::isfinite(torque)) return boost::system::errc::make_error_code(boost::system::errc::invalid_argument);
    const double wanted = torque * options_.torque_units;
    const auto target = static_cast<std::int16_t>(std::round(std::clamp(wanted, -32'768.0, 32'767.0)));
    const auto taken = axis_.push_with(target);
    is_limited_ = taken && (*taken == cia402::acceptance::limited || std::abs(wanted - target) > 1);
    if (taken) finish(boost::asio::error::operation_aborted);
    return make_error_code(taken.error());
}
JAUSCAT_DECL void drive_state::halt(bool on) {
    const auto locked = lock();
    axis_.halt(on);
    if (on) finish(boost::asio::error::operation_aborted);
}
JAUSCAT_DECL drive_feedback drive_state::feedback() const {
    const auto locked = lock();
    const auto& seen = axis_.feedback();
    return {.state = axis_.state(),
            .waits_for = axis_.waits_for(),
            .mode = seen.mode,
            .position = seen.position / options_.increments,
            .velocity = axis_.velocity() / velocity_units_,
            .torque = seen.torque / options_.torque_units,
            .is_current = is_current_,
            .is_target_reached = is_at_target(),
            .is_limited = is_limited_,
            .error = axis_.error()};
}

// ---- The bus.

JAUSCAT_DECL void drive_state::on_cycle(time_point now) {
    const auto data = is_operating_ ? slave_.bus()->data_at(station_) : std::nullopt;
    is_current_ = false;
    if (!data) {
        axis_.on_lost();
        is_operating_ = false;
        return settle(now);
    }
    is_current_ = slave_.bus()->is_current(*data);
    // For less than its time-out a drive may be silent: it keeps its targets.
    if (!is_current_ && axis_.state() == cia402::axis_state::enabled) return;
    auto feedback = places_.load(data->inputs);
    feedback.is_current = is_current_;
    axis_.on_cycle(feedback, now);
    places_.store(axis_.targets(), data->outputs);
    settle(now);
}
JAUSCAT_DECL void drive_state::begin_rest() {
    axis_.quick_stop();
    finish(boost::asio::error::operation_aborted);
}
JAUSCAT_DECL bool drive_state::is_at_rest() const {
    const auto state = axis_.drive_state();
    return !is_operating_ || (state && *state != cia402::state::operation_enabled &&
                              *state != cia402::state::quick_stop_active && axis_.is_at_standstill());
}
JAUSCAT_DECL void drive_state::bus_ends() {
    is_operating_ = is_current_ = false;
    axis_.on_lost();
    finish(boost::asio::error::operation_aborted);
}

} // namespace app

JAUSCAT_DECL drive::drive(const slave& of, const drive_options& options)
    : state_{std::make_shared<app::drive_state>(of, options)} {}
JAUSCAT_DECL boost::asio::any_io_executor drive::executor() const noexcept { return state_->context().get_executor(); }
JAUSCAT_DECL void drive::operate(const app::operation_ptr<>& done) const { state_->operate(done); }
JAUSCAT_DECL void drive::enable(const app::operation_ptr<>& done, cia402::mode mode) const {
    state_->enable(done, mode);
}
JAUSCAT_DECL void drive::disable(const app::operation_ptr<>& done) const {
    state_->begin(done, app::drive_state::wish::off, [](cia402::axis& axis) {
        axis.disable();
        return cia402::axis_errc::ok;
    });
}
JAUSCAT_DECL void drive::stop_quickly(const app::operation_ptr<>& done) const {
    state_->begin(done, app::drive_state::wish::off, [](cia402::axis& axis) {
        axis.quick_stop();
        return cia402::axis_errc::ok;
    });
}
JAUSCAT_DECL void drive::reset(const app::operation_ptr<>& done) const {
    state_->begin(done, app::drive_state::wish::reset, [](cia402::axis& axis) {
        axis.reset();
        return cia402::axis_errc::ok;
    });
}
JAUSCAT_DECL void drive::begin_move(const app::operation_ptr<>& done, double position) const {
    if (!std::isfinite(position))
        return done->complete(boost::system::errc::make_error_code(boost::system::errc::invalid_argument));
    state_->begin(done, app::drive_state::wish::target, [&](cia402::axis&) { return state_->set_position(position); });
}
JAUSCAT_DECL void drive::begin_run(const app::operation_ptr<>& done, double velocity) const {
    if (!std::isfinite(velocity))
        return done->complete(boost::system::errc::make_error_code(boost::system::errc::invalid_argument));
    state_->begin(done, app::drive_state::wish::target, [&](cia402::axis&) { return state_->set_velocity(velocity); });
}
JAUSCAT_DECL void drive::home(const app::operation_ptr<>& done) const {
    state_->begin(done, app::drive_state::wish::homed, [](cia402::axis& axis) { return axis.home().error(); });
}
JAUSCAT_DECL app::error_code drive::move_to(double position) const { return state_->move_to(position); }
JAUSCAT_DECL app::error_code drive::run_at(double velocity) const { return state_->run_at(velocity); }
JAUSCAT_DECL app::error_code drive::push_with(double torque) const { return state_->push_with(torque); }
JAUSCAT_DECL void drive::halt(bool on) const { state_->halt(on); }
JAUSCAT_DECL drive_feedback drive::feedback() const { return state_->feedback(); }
JAUSCAT_DECL const cia402::axis& drive::axis() const noexcept { return state_->axis(); }

} // namespace JAUSCAT_WAY
} // namespace jauscat
