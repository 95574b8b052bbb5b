// Concept of a link: sends and receives whole Ethernet frames.
#pragma once

#include <chrono>
#include <concepts>
#include <cstddef>
#include <span>

namespace jauscat::ethercat {

namespace detail {

template <class L>
concept sends_frames = requires(L& medium, std::span<const std::byte> frame) {
    { medium.send(frame) } -> std::same_as<bool>;
};
template <class L>
concept receives_frames = requires(L& medium, std::span<std::byte> buffer, std::chrono::nanoseconds timeout) {
    { medium.receive(buffer, timeout) } -> std::same_as<std::size_t>;
};

} // namespace detail

/// A medium for EtherCAT frames.
///
/// A frame is a full Ethernet frame, whatever the medium: 14-byte Ethernet header with EtherType 88A4h, EtherCAT
/// header, datagrams, zeros up to 60 bytes; no check sequence. The link replaces a source address of all zeros by its
/// own; any other is sent unchanged, because a slave returns the master's.
///
/// - `send(frame)`: false if the medium did not send the frame; there will be no reply.
/// - `receive(buffer, timeout)`: the size of the frame now in `buffer`, or 0 when none came in time or the medium
///   failed. A frame that does not fit the buffer is dropped; 1514 bytes hold every frame. A timeout of 0 looks once
///   and does not wait.
template <class L> concept link = detail::sends_frames<L> && detail::receives_frames<L>;

/// Does not compile for what is no link, and says which operation is missing.
template <class Link> consteval void require_link() noexcept {
    static_assert(detail::sends_frames<Link>,
                  "link: there is no send(std::span<const std::byte> frame) that returns a bool");
    static_assert(detail::receives_frames<Link>, "link: there is no receive(std::span<std::byte> buffer,"
                                                 " std::chrono::nanoseconds timeout) that returns a std::size_t");
}

} // namespace jauscat::ethercat
