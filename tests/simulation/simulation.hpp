// One run of a whole system, and the story of one that went wrong.
#pragma once

#include "simulation/contract.hpp"
#include "simulation/faults.hpp"
#include "simulation/story.hpp"

#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace simulation {

/// Which system.
enum class system_kind : std::uint8_t {
    any,     ///< the seed says which
    jaus,    ///< robots that are JAUS components themselves
    mailbox, ///< a bridge with slaves by mailbox
    cyclic,  ///< a bridge with slaves by process data
    mixed,   ///< a bridge with both
    drives,  ///< a bridge with arms of 1 to 8 joints: up to 8 drives in a ring
    robot,   ///< a bridge with all of these in one ring
    clocks,  ///< a bridge with arms of drives that have SYNC signals of distributed clocks
    nodes,   ///< nodes of two subsystems, with primaries or without, and their events and service connections
    joints,  ///< a joint with limits behind a component, without a network: its motor is judged
};
inline constexpr unsigned system_count = 9; ///< without `any`
[[nodiscard]] std::string_view name_of(system_kind kind);
[[nodiscard]] std::optional<system_kind> system_of(const std::string& name);

/// What is simulated.
struct settings {
    std::uint64_t seed{};
    time length{std::chrono::seconds{60}}; ///< simulated
    system_kind system{};
    fault_set faults{every_fault};
    std::uint32_t absent{}; ///< actors that are left out, by the bit of their number
    std::ostream* trace{};  ///< gets a line for all that happens and is sent
    friend bool operator==(const settings&, const settings&) = default;
};

/// What became of it.
struct run_result {
    std::optional<violation> broken{};
    system_kind system{}; ///< not `any`
    time length{};        ///< simulated
    std::uint64_t steps{};
    std::uint64_t digest{};
    fault_counts faults{};
    comparison_counts compared{};
    std::vector<std::string> names{}; ///< of the actors; 0 is the network
    std::vector<happening> story{};   ///< its end, if the contract was broken
};

[[nodiscard]] run_result run(const settings& what);

/// The same fault of the system under test with fewer faults around it and fewer actors.
[[nodiscard]] settings shrink(const settings& what, const violation& broken);

/// The violation, and the events that matter, one on a line.
[[nodiscard]] std::string story_text(const settings& what, const run_result& result, bool whole = false);

} // namespace simulation
