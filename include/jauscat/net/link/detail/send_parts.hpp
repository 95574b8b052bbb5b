// Sends a datagram from two pieces of memory, without waiting.
#pragma once

#include <boost/asio/ip/udp.hpp>

#include <array>
#include <cerrno>
#include <cstddef>
#include <span>
#include <sys/socket.h>
#include <sys/uio.h>

namespace jauscat::net::detail {

/// Returns errno, or 0.
inline int send_parts(boost::asio::ip::udp::socket& socket, std::span<const std::byte> first,
                      std::span<const std::byte> second, const boost::asio::ip::udp::endpoint& to) noexcept {
    const auto part = [](std::span<const std::byte> bytes) { // sendmsg only reads it
        return iovec{.iov_base = const_cast<std::byte*>(bytes.data()), .iov_len = bytes.size()};
    };
    std::array parts{part(first), part(second)};
    auto target = to;
    msghdr message{};
    message.msg_name = target.data();
    message.msg_namelen = static_cast<socklen_t>(target.size());
    message.msg_iov = parts.data();
    message.msg_iovlen = parts.size();
    return ::sendmsg(socket.native_handle(), &message, MSG_DONTWAIT | MSG_NOSIGNAL) >= 0 ? 0 : errno;
}

/// Whether a retry may succeed: a buffer of the socket or of the interface was full.
constexpr bool is_back_pressure(int error) noexcept {
    return error == EAGAIN || error == EWOULDBLOCK || error == ENOBUFS;
}

} // namespace jauscat::net::detail
