// The master's side of one axis of a CiA 402 drive: in each cycle its feedback comes in and its targets go out. Time is
// an argument.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/base/result.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/ethercat/cia402/axis_errc.hpp>
#include <jauscat/ethercat/cia402/motion_profile.hpp>
#include <jauscat/schema/ethercat/cia402.hpp>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

namespace jauscat::cia402 {

/// What a drive says in each cycle. Objects that its process data do not have are 0.
struct axis_feedback {
    std::uint16_t statusword{};
    cia402::mode mode{}; ///< mode display (6061h)
    std::int32_t position{};
    std::int32_t velocity{};
    std::int16_t torque{};
    std::uint16_t error_code{};
    bool has_position{true}; ///< 6064h is in the process data
    bool has_velocity{true}; ///< 606Ch is in the process data; else the velocity is derived from positions
    bool is_current{true};   ///< of the last cycle; else the drive is silent, and these are its last values
    friend constexpr bool operator==(const axis_feedback&, const axis_feedback&) = default;
};

/// What a drive is told in each cycle.
struct axis_targets {
    std::uint16_t controlword{};
    cia402::mode mode{};
    std::int32_t position{};
    std::int32_t velocity{};
    std::int16_t torque{};
    std::uint32_t profile_velocity{};
    friend constexpr bool operator==(const axis_targets&, const axis_targets&) = default;
};

/// Properties of an axis. Positions, velocities and accelerations in the drive's units.
struct axis_options {
    /// Between two set-points: equals 60C2h. Where on_cycle is called more often, set-points keep to real time.
    duration cycle{std::chrono::milliseconds{1}};
    duration step_time{std::chrono::seconds{2}};        ///< until the drive takes a state, mode or set-point
    duration rest_time{std::chrono::seconds{2}};        ///< until it is at rest, by ramp or quick stop
    duration ramp_time{duration::max()};                ///< of rest_time: a ramp that takes longer is a quick stop
    duration reset_time{std::chrono::milliseconds{50}}; ///< for which fault reset is 0, and then 1
    std::uint32_t reset_attempts{3};
    std::int32_t min_position{std::numeric_limits<std::int32_t>::min()};
    std::int32_t max_position{std::numeric_limits<std::int32_t>::max()};
    double max_velocity{1e6};         ///< units of velocity
    double acceleration{1e6};         ///< units of velocity a second
    double deceleration{1e6};         ///< units of velocity a second
    std::int16_t max_torque{1000};    ///< per mille of the rated torque
    double torque_slope{10'000};      ///< per mille of the rated torque a second
    std::int32_t standstill{10};      ///< units of velocity: up to this it is at rest
    double velocity_of_position{1.0}; ///< velocity units of one position unit a second; above 0
    /// In cyclic synchronous position the drive sets bit 12 while it follows its target, and the axis waits for it.
    /// False: some drives never set it, and are taken to follow as soon as they are enabled.
    bool shows_following{true};
};

/// How a target has been accepted.
enum class acceptance : std::uint8_t {
    exact,
    limited, ///< a limit of axis_options is used in its place
};

/// What an axis waits for, if its drive has not done yet what it was told.
enum class axis_wait : std::uint8_t {
    nothing,
    feedback,        ///< the drive's first inputs
    next_state,      ///< the next state on the way to operation enabled
    mode,            ///< the mode of operation
    following,       ///< bit 12 of the statusword, in cyclic synchronous position
    standstill,      ///< the end of the ramp or of the quick stop
    leaving_enabled, ///< that the drive leaves operation enabled; after step_time the voltage is disabled
    known_state,     ///< a statusword that stands for a state
    reset,           ///< the end of the fault
};

/// The end of "waits for ...", for logs.
[[nodiscard]] constexpr std::string_view describe(axis_wait what) noexcept {
    switch (what) {
    case axis_wait::nothing: return "nothing";
    case axis_wait::feedback: return "the drive's inputs";
    case axis_wait::next_state: return "the drive to take the next state";
    case axis_wait::mode: return "the drive to show the mode of operation";
    case axis_wait::following: return "bit 12 of the statusword: the drive follows its target position";
    case axis_wait::standstill: return "the drive to stand still";
    case axis_wait::leaving_enabled: return "the drive to leave operation enabled";
    case axis_wait::known_state: return "a statusword that stands for a state";
    case axis_wait::reset: return "the end of the fault";
    }
    return "nothing";
}

enum class axis_state : std::uint8_t {
    unknown,   ///< no feedback yet
    disabled,  ///< without torque
    enabling,  ///< on the way to operation enabled, or between two modes
    enabled,   ///< follows targets
    stopping,  ///< to rest: by ramp or quick stop
    resetting, ///< of a fault
    failed,    ///< see error(); at rest or on the way to it
};

/// The state in words, for logs.
[[nodiscard]] constexpr std::string_view describe(axis_state state) noexcept {
    switch (state) {
    case axis_state::unknown: return "unknown";
    case axis_state::disabled: return "disabled";
    case axis_state::enabling: return "enabling";
    case axis_state::enabled: return "enabled";
    case axis_state::stopping: return "stopping";
    case axis_state::resetting: return "resetting";
    case axis_state::failed: return "failed";
    }
    return "unknown";
}

/// A state machine that takes one step for each observed status. Only `reset` ends a failure, and only `enable` starts
/// motion again: no other event does.
class axis {
  public:
    constexpr axis() noexcept = default;
    explicit constexpr axis(const axis_options& options) noexcept : options_{options}, period_{options.cycle} {}

    [[nodiscard]] constexpr const axis_options& options() const noexcept { return options_; }
    [[nodiscard]] constexpr const axis_error& error() const noexcept { return error_; }
    [[nodiscard]] constexpr const axis_feedback& feedback() const noexcept { return feedback_; }
    [[nodiscard]] constexpr const axis_targets& targets() const noexcept { return targets_; }
    /// The drive's state; nothing without feedback, or where the statusword stands for none.
    [[nodiscard]] constexpr std::optional<cia402::state> drive_state() const noexcept { return seen_; }

    [[nodiscard]] JAUSCAT_CONSTEXPR axis_state state() const noexcept;

    /// What the drive is to do next, also after a failure.
    [[nodiscard]] JAUSCAT_CONSTEXPR axis_wait waits_for() const noexcept;

    /// To operation enabled, one transition for each status. Error: has_failed.
    JAUSCAT_CONSTEXPR result<void, axis_errc> enable() noexcept;
    /// Brings the axis to rest by ramp, then to switch on disabled; by quick stop where the ramp would take too long.
    JAUSCAT_CONSTEXPR void disable() noexcept;
    /// To rest by the drive's quick stop (605Ah), and off.
    JAUSCAT_CONSTEXPR void quick_stop() noexcept { change_goal(goal::quick_stop); }
    /// While `on`, the axis comes to rest and stays enabled; targets set before are discarded, also the set-point of a
    /// drive in profile position.
    JAUSCAT_CONSTEXPR void halt(bool on) noexcept;
    /// Clears the error; resets a fault of the drive by the edge of its bit. The axis is off afterwards.
    JAUSCAT_CONSTEXPR void reset() noexcept;
    /// Changes the mode of operation. Targets set before are discarded; the axis comes to rest by ramp, also in its old
    /// mode, which the drive may keep for a time. After a second change, before the drive has followed the first, what
    /// the drive shows counts from the fifth cycle on: until then it may show an earlier mode.
    JAUSCAT_CONSTEXPR void set_mode(mode wanted) noexcept;

    /// Modes: cyclic synchronous position, through a profile within the limits; profile position. Errors: not_enabled,
    /// wrong_mode.
    JAUSCAT_CONSTEXPR result<acceptance, axis_errc> move_to(std::int32_t position) noexcept;
    /// Modes: cyclic synchronous velocity, by ramp; profile velocity. Errors: not_enabled, wrong_mode.
    JAUSCAT_CONSTEXPR result<acceptance, axis_errc> run_at(std::int32_t velocity) noexcept;
    /// Modes: cyclic synchronous torque, profile torque; by ramp. Errors: not_enabled, wrong_mode.
    JAUSCAT_CONSTEXPR result<acceptance, axis_errc> push_with(std::int16_t torque) noexcept;
    /// Mode: homing, by the method in 6098h. Errors: not_enabled, wrong_mode.
    JAUSCAT_CONSTEXPR result<void, axis_errc> home() noexcept;
    /// The last `home` has ended with success.
    [[nodiscard]] constexpr bool is_homed() const noexcept { return is_homed_; }
    /// All targets have been reached, or none was set: profile at its end, set-point taken and reached, velocity there.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool is_target_reached() const noexcept;
    /// The last velocity is at most `axis_options::standstill`. Without 606Ch: the position has changed by at most one
    /// unit, or by as much as that velocity allows, for `still_time`. Without positions either it is not known: false.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool is_at_standstill() const noexcept;
    /// Of the motor, in units of velocity: 606Ch, or derived from the last two positions.
    [[nodiscard]] JAUSCAT_CONSTEXPR double velocity() const noexcept;
    /// For which positions are compared where a drive has no velocity.
    static constexpr duration still_time{std::chrono::milliseconds{20}};
    /// The drive reports that it is behind its target position (bit 13), before or without a fault.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool has_following_error() const noexcept;
    /// The drive reports that a limit of its own is active.
    [[nodiscard]] constexpr bool is_limited_by_drive() const noexcept { return has_bit(status_bits::internal_limit); }

    /// The cycles of the bus, in which on_cycle is called, have this period: at first axis_options::cycle.
    constexpr void change_period(duration period) noexcept { period_ = period; }

    /// One cycle with current feedback: the targets for the next outputs.
    JAUSCAT_CONSTEXPR const axis_targets& on_cycle(const axis_feedback& feedback, time_point now) noexcept;
    /// The last `on_cycle` has moved the set-points on: not one that came less than half a cycle after another.
    [[nodiscard]] constexpr bool has_moved_on() const noexcept { return step_ > 0; }
    /// One cycle without current feedback: the axis has failed, and its outputs request the quick stop.
    JAUSCAT_CONSTEXPR const axis_targets& on_lost() noexcept;

  private:
    using ds = cia402::state;
    enum class goal : std::uint8_t { off, on, quick_stop };
    enum class reset_phase : std::uint8_t { none, requested, low, high };
    enum class handshake : std::uint8_t { idle, offered, released };

    // Controlwords in turn after which no other one is on the way to the drive: what it does, it has been told to.
    static constexpr unsigned enough_words = 3;
    // From quick stop active, the longest way to operation enabled.
    static constexpr int steps_to_on = 4;
    // Cycles after the start of homing, or after a second change of mode, in which the status may be that of the
    // earlier one.
    static constexpr unsigned status_latency = 4;

    [[nodiscard]] JAUSCAT_CONSTEXPR bool is_position_mode() const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR bool is_velocity_mode() const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR static bool is_torque_mode(mode which) noexcept;
    /// To its set-point or its home, whatever the targets are.
    [[nodiscard]] JAUSCAT_CONSTEXPR static bool moves_by_itself(mode which) noexcept;
    /// In a torque mode that the drive shows; until then it moves in its old mode.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool is_pushing() const noexcept;
    [[nodiscard]] constexpr bool has_bit(std::uint16_t bit) const noexcept { return (feedback_.statusword & bit) != 0; }
    [[nodiscard]] JAUSCAT_CONSTEXPR bool has_fault() const noexcept;
    [[nodiscard]] constexpr double velocity_factor() const noexcept { return options_.velocity_of_position; }
    [[nodiscard]] JAUSCAT_CONSTEXPR double seconds() const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR motion_limits limits() const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR static std::int32_t rounded(double value) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR static acceptance accepted(bool exact) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR axis_errc refusal(bool has_target) const noexcept;

    JAUSCAT_CONSTEXPR void change_goal(goal to) noexcept;
    JAUSCAT_CONSTEXPR void forget_targets() noexcept;
    JAUSCAT_CONSTEXPR void lose_synchronisation() noexcept;
    JAUSCAT_CONSTEXPR void fail(axis_errc code) noexcept;

    JAUSCAT_CONSTEXPR void on_fault() noexcept;
    JAUSCAT_CONSTEXPR void refuse_reset() noexcept;
    JAUSCAT_CONSTEXPR void observe_position(time_point now) noexcept;
    JAUSCAT_CONSTEXPR void forget_positions() noexcept;
    /// The seconds by which the set-points move on in this cycle.
    [[nodiscard]] JAUSCAT_CONSTEXPR double next_step(time_point now) noexcept;

    [[nodiscard]] JAUSCAT_CONSTEXPR std::uint16_t next_control(time_point now) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR std::uint16_t control_in_fault(time_point now) noexcept;
    JAUSCAT_CONSTEXPR void enter(reset_phase phase, time_point now) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR std::uint16_t control_towards_on(bool is_late) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR std::uint16_t control_towards_off(time_point now, bool is_late) noexcept;
    /// The ramp to rest may go on, as far as is known.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool has_ramp_time(time_point now) const noexcept;
    /// The ramp to rest has ended; without torque an axis may coast.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool is_resting() const noexcept;
    /// The drive follows its target position, or does not say it.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool follows() const noexcept;

    JAUSCAT_CONSTEXPR void move(time_point now) noexcept;
    /// Targets that do not move the axis, whichever mode it is in.
    JAUSCAT_CONSTEXPR void hold() noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR bool shows_mode() const noexcept;
    /// It shows the mode, and follows its target position where the mode has one.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool takes_targets() const noexcept;
    /// Whether the drive takes targets; for that it has a time.
    JAUSCAT_CONSTEXPR bool synchronise(time_point now) noexcept;
    /// Until the drive takes targets: the axis comes to rest by ramp in the mode that it is in; targets then follow
    /// where the axis is.
    JAUSCAT_CONSTEXPR void await_drive() noexcept;
    JAUSCAT_CONSTEXPR void take_over() noexcept;
    JAUSCAT_CONSTEXPR void brake() noexcept;
    /// The profile, at a velocity in units of position a second, from where the axis is.
    JAUSCAT_CONSTEXPR void start_at(double velocity) noexcept;

    JAUSCAT_CONSTEXPR void step(time_point now) noexcept;
    /// The commanded velocity in units of position a second, so that the axis stops before its limits.
    [[nodiscard]] JAUSCAT_CONSTEXPR double allowed_velocity() const noexcept;
    /// The commanded torque; none further out at a limit of the position, or faster at that of the velocity.
    [[nodiscard]] JAUSCAT_CONSTEXPR double allowed_torque() const noexcept;
    JAUSCAT_CONSTEXPR void offer_set_point(time_point now) noexcept;
    JAUSCAT_CONSTEXPR void watch_homing() noexcept;

    axis_options options_{};
    axis_feedback feedback_{};
    axis_targets targets_{};
    axis_error error_{};
    std::optional<cia402::state> seen_{};
    bool has_feedback_{};
    goal goal_{};
    bool goal_changed_{};
    bool was_enabled_{};      // since the goal is `on`, with no other command on the way
    unsigned enable_words_{}; // "enable operation", one after the other, up to enough_words
    bool was_seen_enabled_{}; // in the last cycle
    bool is_synchronised_{};
    bool is_braking_{};          // without synchronisation
    unsigned doubtful_cycles_{}; // in which the mode that the drive shows may be an earlier one
    bool halted_{};
    bool is_after_halt_{};                    // the drive may still have the set-point of before
    time_point since_{};                      // the drive's state, or the goal
    time_point goal_since_{};                 // whatever the drive's state is
    duration period_{options_.cycle};         // until the targets are sent
    std::optional<time_point> moved_until_{}; // the set-points are those of this time
    double step_{};                           // seconds of this step of the set-points, 0 while they are held

    struct seen_position {
        std::int32_t at{};
        time_point since{};
    };
    std::optional<seen_position> still_at_{}, last_position_{};
    bool is_still_{};
    double derived_velocity_{};
    std::optional<time_point> mode_since_{};

    reset_phase reset_{};
    time_point reset_since_{};
    std::uint32_t attempts_{};

    motion_profile profile_{};
    double torque_{};
    std::optional<std::int32_t> position_goal_{};
    double velocity_goal_{};
    int torque_goal_{};
    handshake handshake_{};
    bool is_offered_{}; // the position goal, in profile position
    time_point handshake_since_{};
    bool is_homing_{}, is_homed_{};
    unsigned homing_cycles_{};
};

} // namespace jauscat::cia402

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/cia402/impl/axis.ipp>
#endif
