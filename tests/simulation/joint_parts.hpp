// The joint_part of an arm of simulated drives.
#pragma once

#include <jauscat/bridge/process_part.hpp>

#include <cstddef>
#include <memory>

namespace simulation {

/// `joints`: 1, 2, 3, 4, 6 or 8, in drives of 1 or 2 axes each.
[[nodiscard]] std::unique_ptr<jauscat::bridging::process_part> make_joint_part(std::size_t joints, std::size_t axes);

} // namespace simulation
