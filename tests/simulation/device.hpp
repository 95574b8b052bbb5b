// What stands at a place of the simulated ring: a slave and the application behind it.
#pragma once

#include "simulation/generator.hpp"
#include <jauscat/ethercat/slave/slave.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace simulation {

namespace ethercat = jauscat::ethercat;

class device {
  public:
    device() = default;
    device(const device&) = delete;
    device& operator=(const device&) = delete;
    virtual ~device() = default;

    [[nodiscard]] virtual ethercat::slave& slave() noexcept = 0;
    [[nodiscard]] virtual const ethercat::slave& slave() const noexcept = 0;
    /// As after power-on: what it did and knew is gone.
    virtual void power_on(time now) = 0;
    /// An application works whether frames pass or not.
    virtual void on_time(time now) = 0;
    /// A frame passes, `late` after it was sent. `frozen`: the controller alone works, the application does not.
    void pass(std::span<std::byte> frame, time now, time late, bool frozen) {
        slave().pass(frame, jauscat::time_point{now + late});
        if (!frozen) on_time(now);
    }
};

} // namespace simulation
