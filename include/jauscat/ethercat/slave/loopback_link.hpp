// Link in memory: a sent frame passes through emulated slaves and is then received.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/slave/slave.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <span>
#include <utility>

namespace jauscat::ethercat {

/// Models `link`. Holds one frame: the next one is accepted after it has been received.
class loopback_link {
  public:
    /// `slaves`, in ring order, outlive the link. None at all returns frames as they are.
    JAUSCAT_FUNCTION explicit loopback_link(std::span<slave> slaves) noexcept;

    /// Hands the frame to the slaves at once; false where it is too long, or another waits to be fetched.
    [[nodiscard]] JAUSCAT_FUNCTION bool send(std::span<const std::byte> frame) noexcept;

    /// Never waits: a frame is there at once or not at all.
    [[nodiscard]] JAUSCAT_FUNCTION std::size_t receive(std::span<std::byte> buffer, std::chrono::nanoseconds) noexcept;

  private:
    std::span<slave> slaves_;
    std::array<std::byte, max_frame_size> frame_{};
    std::size_t size_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/slave/impl/loopback_link.ipp>
#endif
