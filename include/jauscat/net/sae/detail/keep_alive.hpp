// Keep-alive probes of a TCP connection.
#pragma once

#include <jauscat/base/time.hpp>

#include <boost/asio/ip/tcp.hpp>

#include <algorithm>
#include <chrono>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

namespace jauscat::net::detail {

/// A peer that does not answer is detected within about twice `silence`, also while bytes wait to be acknowledged.
/// False if the system refuses an option.
inline bool set_keep_alive(boost::asio::ip::tcp::socket& socket, duration silence) noexcept {
    using std::chrono::duration_cast;
    constexpr int probes = 3;
    const int seconds =
        static_cast<int>(std::clamp<std::int64_t>(duration_cast<std::chrono::seconds>(silence).count(), 1, 3600));
    const auto set = [&](int level, int name, int value) {
        return ::setsockopt(socket.native_handle(), level, name, &value, sizeof value) == 0;
    };
    return set(SOL_SOCKET, SO_KEEPALIVE, 1) && set(IPPROTO_TCP, TCP_KEEPIDLE, seconds) &&
           set(IPPROTO_TCP, TCP_KEEPINTVL, std::max(seconds / probes, 1)) && set(IPPROTO_TCP, TCP_KEEPCNT, probes) &&
           set(IPPROTO_TCP, TCP_USER_TIMEOUT, 2000 * seconds);
}

} // namespace jauscat::net::detail
