// Link in memory: a sent frame passes through emulated slaves and is then received.
#pragma once

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
    explicit loopback_link(std::span<slave> slaves) noexcept : slaves_{slaves} {
        for (auto& each : slaves) each.set_downstream(&each != &slaves.back());
    }

    /// Hands the frame to the slaves at once; false where it is too long, or another waits to be fetched.
    [[nodiscard]] bool send(std::span<const std::byte> frame) noexcept {
        if (size_ != 0 || frame.size() > frame_.size()) return false;
        std::ranges::copy(frame, frame_.begin());
        size_ = frame.size();
        for (auto& device : slaves_) device.process(std::span{frame_}.first(size_));
        return true;
    }

    /// Never waits: a frame is there at once or not at all.
    [[nodiscard]] std::size_t receive(std::span<std::byte> buffer, std::chrono::nanoseconds) noexcept {
        const std::size_t size = std::exchange(size_, 0);
        if (size > buffer.size()) return 0;
        std::ranges::copy(std::span{frame_}.first(size), buffer.begin());
        return size;
    }

  private:
    std::span<slave> slaves_;
    std::array<std::byte, max_frame_size> frame_{};
    std::size_t size_{};
};

} // namespace jauscat::ethercat
