// Runs whose digest is recorded: what all programs send and tell in them.
#pragma once

#include "simulation/simulation.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace simulation {

struct recorded_run {
    settings what{};
    std::uint64_t digest{}; ///< 0: not recorded
    std::string note{};     ///< lines in front of it
    bool breaks{};          ///< the contract, in the present code
};

/// Of recorded_runs.txt. std::runtime_error with the line where it cannot be read.
[[nodiscard]] std::vector<recorded_run> read_recorded_runs(const std::string& path);

/// A line of the file.
[[nodiscard]] std::string line_of(const recorded_run& one);

/// With the digests of the present code. `jobs` at once.
[[nodiscard]] std::vector<recorded_run> renewed(std::vector<recorded_run> runs, unsigned jobs);

} // namespace simulation
