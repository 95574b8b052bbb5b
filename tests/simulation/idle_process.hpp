// A process that does nothing by itself, for tests that say all that happens.
#pragma once

#include "simulation/process.hpp"

namespace simulation {

class idle_process final : public process {
  public:
    using process::process;

  private:
    void boot() override {}
    void kill() override {}
    void receive(const datagram&) override {}
    void run() override {}
    std::optional<time> next() override { return std::nullopt; }
};

} // namespace simulation
