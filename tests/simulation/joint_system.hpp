// One joint with limits behind a component, without a network: its motor is judged.
#pragma once

#include "simulation/world.hpp"

#include <cstdint>
#include <memory>
#include <optional>

namespace simulation {

/// What is unusual about a run; the seed says which, one at a time, so that none hides another. There are more of those
/// that have checks of their own.
enum class joint_trial : std::uint8_t {
    plain,
    period_changes,  ///< another user of the bus has a shorter period
    no_velocity,     ///< the process data have no velocity (606Ch)
    long_ramp,       ///< a ramp that takes longer than the limit
    slow_enabling,   ///< a brake that opens late
    lasting_fault,   ///< a drive fault that Reset does not end
    mode_refused,    ///< the drive does not take a mode
    silent_sender,   ///< a sender without control that dies
    stops_following, ///< a drive that does not follow its target position for some time
};
inline constexpr std::uint64_t joint_trial_turn = 16; ///< seeds that have all of them
[[nodiscard]] constexpr joint_trial joint_trial_of(std::uint64_t seed) noexcept {
    switch (seed % joint_trial_turn) {
    case 8: return joint_trial::silent_sender;
    case 9:
    case 12:
    case 14: return joint_trial::stops_following;
    default: return static_cast<joint_trial>(seed % 8);
    }
}

/// Counted as this one each time.
[[nodiscard]] constexpr std::optional<fault> fault_of_trial(joint_trial what) noexcept {
    if (what == joint_trial::plain) return std::nullopt;
    constexpr auto first = static_cast<unsigned>(fault::joint_period_changed) - 1;
    return static_cast<fault>(first + static_cast<unsigned>(what));
}

/// It runs until its end.
[[nodiscard]] std::unique_ptr<actor> make_joint_system(world& w, joint_trial what);

} // namespace simulation
