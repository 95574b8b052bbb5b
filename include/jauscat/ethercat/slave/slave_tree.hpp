// Emulated slaves on cables: a frame takes time to each slave, so that their clocks store the times of a real bus.
#pragma once

#include <jauscat/base/compilation.hpp>
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
    JAUSCAT_FUNCTION explicit slave_tree(std::span<wired_slave> slaves, duration through = {}) noexcept;

    /// The frame is sent `now`: passes all slaves and is changed in place, then their applications work. Gives when it
    /// is back. The next one is sent later.
    JAUSCAT_FUNCTION time_point process(std::span<std::byte> frame, time_point now) noexcept;
    /// The controllers' part of `process`: the applications do not get to run.
    JAUSCAT_FUNCTION time_point pass(std::span<std::byte> frame, time_point now) noexcept;

  private:
    // The way back from a slave to one before it.
    JAUSCAT_FUNCTION time_point climb(std::size_t from, std::size_t to, time_point now) noexcept;

    std::span<wired_slave> slaves_;
    duration through_;
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/slave/impl/slave_tree.ipp>
#endif
