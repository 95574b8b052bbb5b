// The faults of the simulated system: which kinds there are, how often each strikes, and how often it has.
#pragma once

#include "simulation/generator.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace simulation {

/// What can go wrong. The order is that of `fault_names`.
enum class fault : std::uint8_t {
    datagram_lost,
    datagram_doubled,
    datagram_delayed,
    network_parted,
    process_killed,
    process_frozen,
    clock_leap,
    same_numbers,
    number_zero,
    message_doubled,
    kinds_mixed,
    body_malformed,
    mute_controller,
    frame_lost,
    frame_delayed,
    cable_out,
    slave_frozen,
    slave_restarted,
    slave_aborts,
    slave_falls_back,
    mailbox_recounted,
    other_master,
    odd_watchdog,
    unknown_state,
    bridge_ended,
    frame_doubled,
    frame_damaged,
    slaves_swapped,
    station_doubled,
    drive_fault,
    drive_unpowered,
    drive_deaf,
    watchdog_kept,
    error_reported,
    slave_slow,
    wall_clock_back,
    joint_period_changed,
    joint_without_velocity,
    joint_long_ramp,
    joint_late_brake,
    joint_lasting_fault,
    joint_mode_refused,
    joint_sender_silent,
    joint_stops_following,
    slave_emergency,
};
inline constexpr std::array<std::string_view, 45> fault_names{"datagram-lost",        "datagram-doubled",
                                                              "datagram-delayed",     "network-parted",
                                                              "process-killed",       "process-frozen",
                                                              "clock-leap",           "same-numbers",
                                                              "number-zero",          "message-doubled",
                                                              "kinds-mixed",          "body-malformed",
                                                              "mute-controller",      "frame-lost",
                                                              "frame-delayed",        "cable-out",
                                                              "slave-frozen",         "slave-restarted",
                                                              "slave-aborts",         "slave-falls-back",
                                                              "mailbox-recounted",    "other-master",
                                                              "odd-watchdog",         "unknown-state",
                                                              "bridge-ended",         "frame-doubled",
                                                              "frame-damaged",        "slaves-swapped",
                                                              "station-doubled",      "drive-fault",
                                                              "drive-unpowered",      "drive-deaf",
                                                              "watchdog-kept",        "error-reported",
                                                              "slave-slow",           "wall-clock-back",
                                                              "joint-period-changed", "joint-without-velocity",
                                                              "joint-long-ramp",      "joint-late-brake",
                                                              "joint-lasting-fault",  "joint-mode-refused",
                                                              "joint-sender-silent",  "joint-stops-following",
                                                              "slave-emergency"};
inline constexpr std::size_t fault_count = fault_names.size();

[[nodiscard]] constexpr std::string_view name_of(fault kind) noexcept {
    return fault_names[static_cast<std::size_t>(kind)];
}
[[nodiscard]] constexpr std::optional<fault> fault_of(std::string_view name) noexcept {
    for (std::size_t i = 0; i != fault_count; ++i)
        if (fault_names[i] == name) return static_cast<fault>(i);
    return std::nullopt;
}

/// Kinds of faults, one bit for each.
using fault_set = std::uint64_t;
inline constexpr fault_set every_fault = (fault_set{1} << fault_count) - 1;
[[nodiscard]] constexpr fault_set only(fault kind) noexcept { return fault_set{1} << static_cast<unsigned>(kind); }

/// How often each kind has struck.
using fault_counts = std::array<std::uint64_t, fault_count>;

/// Decides when a fault strikes. Each kind draws from a generator of its own, so that one that is switched off leaves
/// the others as they are. A seed has each kind often, seldom or not at all: rare faults are not hidden by frequent
/// ones.
class fault_source {
  public:
    fault_source(generator seed, fault_set enabled) : enabled_{enabled} {
        for (std::size_t i = 0; i != fault_count; ++i) {
            streams_[i] = seed.stream(i + 1);
            constexpr std::array weights{0U, 1U, 1U, 5U};
            weight_[i] = weights[streams_[i].below(weights.size())];
        }
    }
    /// Whether it strikes now, which it does `per_million` times of a million where it is seldom.
    bool strikes(fault kind, unsigned per_million) noexcept {
        const auto i = static_cast<std::size_t>(kind);
        const bool drawn = streams_[i].chance(std::min(per_million * weight_[i], 500'000U));
        if (!drawn || (enabled_ & only(kind)) == 0) return false;
        ++counts_[i];
        return true;
    }
    [[nodiscard]] bool allows(fault kind) const noexcept { return (enabled_ & only(kind)) != 0; }
    /// One that a program makes of its own each time.
    void note(fault kind) noexcept { ++counts_[static_cast<std::size_t>(kind)]; }
    /// When to ask next about a kind that strikes once in `mean`.
    time pause(fault kind, time mean) noexcept { return random(kind).between(mean / 8, 2 * mean - mean / 8); }
    /// For what a fault is like.
    generator& random(fault kind) noexcept { return streams_[static_cast<std::size_t>(kind)]; }
    [[nodiscard]] const fault_counts& counts() const noexcept { return counts_; }

  private:
    fault_set enabled_;
    std::array<unsigned, fault_count> weight_{};
    fault_counts counts_{};
    std::array<generator, fault_count> streams_ = filled(std::make_index_sequence<fault_count>{});

    template <std::size_t... I> static std::array<generator, fault_count> filled(std::index_sequence<I...>) {
        return {generator{I}...};
    }
};

} // namespace simulation
