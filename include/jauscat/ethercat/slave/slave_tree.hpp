// Emulated slaves on cables: a frame takes time to each slave, so that their clocks store the times of a real bus.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/ethercat/slave/slave.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// A slave, and its cable to the slave before it.
struct wired_slave {
    slave* device{};
    std::size_t parent{};       ///< its place in the tree; of the first slave, which the master is connected to, none
    std::size_t parent_port{1}; ///< 1 to 3
    duration cable{};           ///< delay from there to here, and back
};

/// Slaves in the order in which frames pass them: behind each slave come those at its port 3, then at 1, then at 2.
class slave_tree {
  public:
    /// `slaves` outlive the tree. Each needs `through`, from one port to the next.
    explicit slave_tree(std::span<wired_slave> slaves, duration through = {}) noexcept
        : slaves_{slaves}, through_{through} {
        for (auto& each : slaves)
            for (std::size_t port = 1; port != 4; ++port) each.device->set_connected(port, false);
        for (auto& each : slaves.subspan(slaves.empty() ? 0 : 1))
            slaves[each.parent].device->set_connected(each.parent_port, true);
    }

    /// The frame is sent `now`: passes all slaves and is changed in place, then their applications work. Gives when it
    /// is back. The next one is sent later.
    time_point process(std::span<std::byte> frame, time_point now) noexcept {
        const auto back = pass(frame, now);
        for (auto& each : slaves_) each.device->work();
        return back;
    }
    /// The controllers' part of `process`: the applications do not get to run.
    time_point pass(std::span<std::byte> frame, time_point now) noexcept {
        for (std::size_t i = 0; i != slaves_.size(); ++i) {
            if (i != 0) now = climb(i - 1, slaves_[i].parent, now);
            now += slaves_[i].cable;
            slaves_[i].device->pass(frame, now);
            now += through_;
        }
        if (slaves_.empty()) return now;
        return climb(slaves_.size() - 1, 0, now) + slaves_.front().cable;
    }

  private:
    // The way back from a slave to one before it.
    time_point climb(std::size_t from, std::size_t to, time_point now) noexcept {
        for (; from != to && from != 0; from = slaves_[from].parent) {
            const auto& child = slaves_[from];
            now += child.cable;
            slaves_[child.parent].device->frame_returned(child.parent_port, now);
            now += through_;
        }
        return now;
    }

    std::span<wired_slave> slaves_;
    duration through_;
};

} // namespace jauscat::ethercat
