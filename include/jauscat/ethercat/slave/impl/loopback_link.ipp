// The functions of loopback_link.
#pragma once
#include <jauscat/ethercat/slave/loopback_link.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION loopback_link::loopback_link(std::span<slave> slaves) noexcept : slaves_{slaves} {
    for (auto& each : slaves) each.set_downstream(&each != &slaves.back());
}

JAUSCAT_FUNCTION bool loopback_link::send(std::span<const std::byte> frame) noexcept {
    if (size_ != 0 || frame.size() > frame_.size()) return false;
    std::ranges::copy(frame, frame_.begin());
    size_ = frame.size();
    for (auto& device : slaves_) device.process(std::span{frame_}.first(size_));
    return true;
}

JAUSCAT_FUNCTION std::size_t loopback_link::receive(std::span<std::byte> buffer, std::chrono::nanoseconds) noexcept {
    const std::size_t size = std::exchange(size_, 0);
    if (size > buffer.size()) return 0;
    std::ranges::copy(std::span{frame_}.first(size), buffer.begin());
    return size;
}

} // namespace jauscat::ethercat
