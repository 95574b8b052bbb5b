// The joints of an arm, one axis of a CiA 402 drive each: JAUS joint messages in, all targets out in one cycle. Time is
// an argument.
#pragma once
#include <jauscat/base/result.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/bridge/joints/joint_errc.hpp>
#include <jauscat/ethercat/cia402/axis.hpp>
#include <jauscat/ethercat/cia402/axis_places.hpp>
#include <jauscat/schema/translation/joint_tables.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace jauscat::bridging {

/// One joint.
struct joint_options {
    std::size_t slave{};          ///< index of its drive in the span of images
    std::size_t drive_axis{};     ///< its axis of that drive, from 0
    cia402::axis_places places{}; ///< in the drive's process data
    cia402::axis_options axis{};  ///< its limits are applied after those of `scale`
    translation::joint_scale scale{};
};

/// How old the inputs of a drive are.
enum class input_age : std::uint8_t {
    lost,    ///< the drive is not in OP, or silent for longer than its time-out: its axes fail
    late,    ///< the drive is silent, for less than that: its axes keep their targets, or go on to rest
    current, ///< of the last cycle, with the drive in OP
};

/// Process data of one drive; of a drive that is lost they are empty.
struct drive_image {
    std::span<std::byte> outputs{};
    std::span<const std::byte> inputs{};
    input_age age{};
};

enum class joint_group_state : std::uint8_t {
    unknown,   ///< not all axes have had feedback yet
    at_rest,   ///< no command is in force: axes without torque, or on the way there
    starting,  ///< a command waits until all axes are enabled in its mode
    moving,    ///< a command is in force
    emergency, ///< quick stop, until clear_emergency
    failed,    ///< an axis has failed; the others come to rest by ramp
};

/// `Joints` axes that obey one message at a time: the last one decides the mode of all. A command enables the axes; it
/// takes effect in all of them in the same cycle.
template <std::size_t Joints> class joint_group {
    static_assert(Joints >= 1 && Joints <= 64, "joint_group: a group has 1 to 64 joints");

  public:
    constexpr explicit joint_group(const std::array<joint_options, Joints>& joints) noexcept {
        for (std::size_t i = 0; i != Joints; ++i) {
            axes_[i] = cia402::axis{joints[i].axis};
            places_[i] = joints[i].places;
            slaves_[i] = joints[i].slave;
            scales_[i] = joints[i].scale;
        }
    }

    /// Whether the joints' parameters are valid, and their process data have what at least one of the three commands
    /// needs.
    [[nodiscard]] constexpr bool is_usable() const noexcept {
        return std::ranges::all_of(scales_, [](const auto& each) { return is_valid(each); }) &&
               (serves(jaus::command_code_of<jaus::set_joint_positions>) ||
                serves(jaus::command_code_of<jaus::set_joint_velocities>) ||
                serves(jaus::command_code_of<jaus::set_joint_efforts>));
    }
    /// Whether the process data of all joints have what this command needs.
    [[nodiscard]] constexpr bool serves(std::uint16_t code) const noexcept {
        const auto mode = mode_of(code);
        return mode &&
               std::ranges::all_of(places_, [&](const auto& each) { return each.missing_for(*mode) == nullptr; });
    }
    [[nodiscard]] constexpr const cia402::axis& axis(std::size_t joint) const noexcept { return axes_[joint]; }

    [[nodiscard]] static constexpr bool is_command(std::uint16_t code) noexcept { return mode_of(code).has_value(); }
    [[nodiscard]] static constexpr bool is_report(std::uint16_t code) noexcept {
        return code == jaus::command_code_of<jaus::report_joint_positions> ||
               code == jaus::command_code_of<jaus::report_joint_velocities> ||
               code == jaus::command_code_of<jaus::report_joint_efforts>;
    }

    /// Takes Set Joint Positions, Velocities or Efforts, if `serves` it; returns the joints for which a limit is used
    /// in place of the commanded value. A refused message changes nothing.
    constexpr result<translate::axis_bits, joint_errc> command(std::uint16_t code,
                                                               std::span<const std::byte> body) noexcept {
        const auto mode = mode_of(code);
        if (!mode || !serves(code)) return joint_errc::unknown_message;
        if (is_emergency_) return joint_errc::in_emergency;
        if (has_failed()) return joint_errc::has_failed;
        targets wanted{};
        const auto limited = translated(*mode, body, wanted);
        if (!limited)
            return limited.error() == translate::errc::wrong_size ? joint_errc::wrong_count : joint_errc::malformed;
        forget_command();
        pending_ = wanted;
        for (auto& each : axes_) {
            each.halt(false);
            each.set_mode(*mode);
            static_cast<void>(each.enable()); // has not failed
        }
        return *limited;
    }
    /// The cycles have this period from now on; set-points keep the one of axis_options::cycle.
    constexpr void change_period(duration period) noexcept {
        for (auto& each : axes_) each.change_period(period);
    }
    /// To rest by ramp, then without torque.
    constexpr void stop() noexcept {
        forget_command();
        for (auto& each : axes_) each.disable();
    }
    /// Quick stop of all axes, in the outputs of the next step. Commands are refused until `clear_emergency`.
    constexpr void emergency() noexcept {
        is_emergency_ = true;
        forget_command();
        for (auto& each : axes_) each.quick_stop();
    }
    /// The axes stay at rest.
    constexpr void clear_emergency() noexcept { is_emergency_ = false; }
    /// Clears the errors and resets the faults of the drives. The axes stay at rest.
    constexpr void reset() noexcept {
        forget_command();
        for (auto& each : axes_) each.reset();
    }

    /// One cycle: inputs in, targets out, for all drives.
    constexpr void step(std::span<const drive_image> drives, time_point now) noexcept {
        if (pending_ && are_all(cia402::axis_state::enabled)) apply();
        for (std::size_t i = 0; i != Joints; ++i) {
            const drive_image drive = slaves_[i] < drives.size() ? drives[slaves_[i]] : drive_image{};
            // Its outputs keep what they have, but all get a new command's targets in the same cycle.
            if (drive.age == input_age::late && !is_new_[i] && (pending_ || in_force_)) continue;
            if (drive.age != input_age::lost && places_[i].statusword.fits(drive.inputs.size())) {
                auto feedback = places_[i].load(drive.inputs);
                feedback.is_current = drive.age == input_age::current;
                axes_[i].on_cycle(feedback, now);
                if (axes_[i].has_moved_on()) is_new_[i] = false;
            } else {
                axes_[i].on_lost();
            }
        }
        without_target_.reset();
        for (std::size_t i = 0; i != Joints && in_force_ && !without_target_; ++i)
            if (axes_[i].state() == cia402::axis_state::enabling) without_target_ = i;
        if ((has_failed() || without_target_) && !is_emergency_) stop();
        for (std::size_t i = 0; i != Joints; ++i)
            if (slaves_[i] < drives.size()) places_[i].store(axes_[i].targets(), drives[slaves_[i]].outputs);
    }

    [[nodiscard]] constexpr joint_group_state state() const noexcept {
        using enum joint_group_state;
        if (has_failed()) return failed;
        if (is_emergency_) return emergency;
        for (const auto& each : axes_)
            if (each.state() == cia402::axis_state::unknown) return unknown;
        if (pending_) return starting;
        return in_force_ ? moving : at_rest;
    }
    /// A command is in force, and all axes follow their targets.
    [[nodiscard]] constexpr bool is_following() const noexcept {
        return state() == joint_group_state::moving && are_all(cia402::axis_state::enabled);
    }
    /// The outputs of the last step have the targets of the command in force, for all drives.
    [[nodiscard]] constexpr bool has_targets() const noexcept {
        return is_following() && std::ranges::none_of(is_new_, std::identity{});
    }
    /// The drive of a joint has left operation enabled and stands still: what `stop` and `emergency` lead to. Not known
    /// of a drive that is lost.
    [[nodiscard]] constexpr bool is_at_rest(std::size_t joint) const noexcept {
        const auto& axis = axes_[joint];
        const auto drive = axis.drive_state();
        return drive && *drive != cia402::state::operation_enabled && axis.is_at_standstill() &&
               axis.error().code != cia402::axis_errc::inputs_lost;
    }
    [[nodiscard]] constexpr bool is_at_rest() const noexcept {
        for (std::size_t i = 0; i != Joints; ++i)
            if (!is_at_rest(i)) return false;
        return true;
    }
    /// In the last step the drive of this joint did not follow the command in force any more, or showed another mode:
    /// all axes come to rest by ramp.
    [[nodiscard]] constexpr std::optional<std::size_t> joint_without_target() const noexcept { return without_target_; }
    /// The first axis that has failed.
    [[nodiscard]] constexpr std::optional<std::size_t> failed_joint() const noexcept {
        for (std::size_t i = 0; i != Joints; ++i)
            if (axes_[i].error().code != cia402::axis_errc::ok) return i;
        return {};
    }

    /// Writes the body of Report Joint Positions, Velocities or Efforts from the last feedback. Errors:
    /// unknown_message, not_current (an axis has no current feedback), no_space.
    [[nodiscard]] constexpr result<std::span<std::byte>, joint_errc> report(std::uint16_t code,
                                                                            std::span<std::byte> body) const noexcept {
        if (!is_report(code)) return joint_errc::unknown_message;
        for (const auto& each : axes_)
            if (each.state() == cia402::axis_state::unknown || each.error().code == cia402::axis_errc::inputs_lost)
                return joint_errc::not_current;
        const auto written = code == jaus::command_code_of<jaus::report_joint_positions>
                                 ? reported<translation::report_joint_positions_table<Joints>>(body)
                             : code == jaus::command_code_of<jaus::report_joint_velocities>
                                 ? reported<translation::report_joint_velocities_table<Joints>>(body)
                                 : reported<translation::report_joint_efforts_table<Joints>>(body);
        if (!written) return joint_errc::no_space;
        return *written;
    }

  private:
    struct targets {
        cia402::mode mode{};
        std::array<std::int32_t, Joints> values{};
    };

    [[nodiscard]] static constexpr std::optional<cia402::mode> mode_of(std::uint16_t code) noexcept {
        if (code == jaus::command_code_of<jaus::set_joint_positions>) return cia402::mode::cyclic_synchronous_position;
        if (code == jaus::command_code_of<jaus::set_joint_velocities>) return cia402::mode::cyclic_synchronous_velocity;
        if (code == jaus::command_code_of<jaus::set_joint_efforts>) return cia402::mode::cyclic_synchronous_torque;
        return {};
    }
    [[nodiscard]] constexpr bool has_failed() const noexcept { return failed_joint().has_value(); }
    [[nodiscard]] constexpr bool are_all(cia402::axis_state state) const noexcept {
        return std::ranges::all_of(axes_, [state](const auto& each) { return each.state() == state; });
    }
    constexpr void forget_command() noexcept {
        pending_.reset();
        in_force_ = false;
        is_new_.fill(false);
    }

    [[nodiscard]] constexpr result<translate::axis_bits, translate::errc>
    translated(cia402::mode mode, std::span<const std::byte> body, targets& wanted) const noexcept {
        wanted.mode = mode;
        const auto keep = [&wanted](std::size_t joint, const auto&, auto value) { wanted.values[joint] = value; };
        switch (mode) {
        case cia402::mode::cyclic_synchronous_position:
            return translate::object_translator<translation::set_joint_positions_table<Joints>>::to_objects(
                body, scales_, keep);
        case cia402::mode::cyclic_synchronous_velocity:
            return translate::object_translator<translation::set_joint_velocities_table<Joints>>::to_objects(
                body, scales_, keep);
        default:
            return translate::object_translator<translation::set_joint_efforts_table<Joints>>::to_objects(body, scales_,
                                                                                                          keep);
        }
    }
    constexpr void apply() noexcept {
        for (std::size_t i = 0; i != Joints; ++i) {
            const auto value = pending_->values[i];
            switch (pending_->mode) {
            case cia402::mode::cyclic_synchronous_position: static_cast<void>(axes_[i].move_to(value)); break;
            case cia402::mode::cyclic_synchronous_velocity: static_cast<void>(axes_[i].run_at(value)); break;
            default: static_cast<void>(axes_[i].push_with(static_cast<std::int16_t>(value))); break;
            }
        }
        pending_.reset();
        in_force_ = true;
        is_new_.fill(true);
    }
    template <class Table>
    [[nodiscard]] constexpr result<std::span<std::byte>, translate::errc>
    reported(std::span<std::byte> body) const noexcept {
        return translate::object_translator<Table>::from_objects(
            [this](std::size_t joint, const cia402::object& object) -> std::int32_t {
                const auto& feedback = axes_[joint].feedback();
                if (object.index == cia402::objects::position_actual.index) return feedback.position;
                if (object.index == cia402::objects::velocity_actual.index) return feedback.velocity;
                return feedback.torque;
            },
            scales_, body);
    }

    std::array<cia402::axis, Joints> axes_{};
    std::array<cia402::axis_places, Joints> places_{};
    std::array<std::size_t, Joints> slaves_{};
    std::array<translation::joint_scale, Joints> scales_{};
    std::optional<targets> pending_{};
    std::optional<std::size_t> without_target_{};
    bool in_force_{};
    std::array<bool, Joints> is_new_{}; // the outputs of the axis do not have its targets yet
    bool is_emergency_{};
};

} // namespace jauscat::bridging
