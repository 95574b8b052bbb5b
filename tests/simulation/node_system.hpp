// Nodes of two subsystems that know each other directly or by their primaries, and exchange reports and broadcasts.
#pragma once

#include "simulation/world.hpp"

#include <memory>

namespace simulation {

/// Runs until its end. `absent`: actors that are left out, by the bit of their number.
class node_system {
  public:
    node_system() = default;
    node_system(const node_system&) = delete;
    node_system& operator=(const node_system&) = delete;
    virtual ~node_system() = default;
};
[[nodiscard]] std::unique_ptr<node_system> make_node_system(world& w, std::uint32_t absent);

} // namespace simulation
