// Concept of a link: sends and receives whole Ethernet frames.
#pragma once

#include <chrono>
#include <concepts>
#include <cstddef>
#include <span>

namespace jauscat::ethercat {

/// A medium for EtherCAT frames.
///
/// A frame is a full Ethernet frame, whatever the medium: 14-byte Ethernet header with EtherType 88A4h, EtherCAT
/// header, datagrams, zeros up to 60 bytes; no check sequence. A source address of all zeros asks the link to
/// put its own there; any other is sent as it is, because a slave returns the master's.
///
/// - `send(frame)`: false when the medium did not take the frame; nobody will answer it.
/// - `receive(buffer, timeout)`: the size of the frame now in `buffer`, or 0 when none came in time or the medium
///   failed. A frame that does not fit the buffer is dropped; 1514 bytes hold every frame. A timeout of 0 looks once
///   and does not wait.
template <class L>
concept link = requires(L& medium, std::span<const std::byte> frame, std::span<std::byte> buffer,
                        std::chrono::nanoseconds timeout) {
    { medium.send(frame) } -> std::same_as<bool>;
    { medium.receive(buffer, timeout) } -> std::same_as<std::size_t>;
};

} // namespace jauscat::ethercat
