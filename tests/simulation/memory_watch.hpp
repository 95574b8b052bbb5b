// Memory that grows breaks the contract.
#pragma once

#include "simulation/memory.hpp"
#include "simulation/world.hpp"

namespace simulation {

/// Memory after the first part of a run is what later parts are measured by.
class memory_watch {
  public:
    explicit memory_watch(world& w) : world_{w} {}
    void look() {
        if (world_.now() < next_) return;
        next_ = world_.now() + std::chrono::seconds{1};
        const auto held = live_bytes();
        if (world_.now() < std::chrono::seconds{20}) {
            usual_ = std::max(usual_, held);
        } else if (held > 2 * usual_ + (4 << 20)) {
            world_.breaks({.point = contract::memory,
                           .expected = "not much more than the " + std::to_string(usual_) + " bytes at the begin",
                           .found = std::to_string(held) + " bytes"});
        }
    }

  private:
    world& world_;
    time next_{};
    std::ptrdiff_t usual_{};
};

} // namespace simulation
