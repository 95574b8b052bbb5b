// Detects that a peer's port is closed. Linux reports ICMP errors to an unconnected UDP socket only on request, with
// the destination of the refused datagram, in the socket's error queue.
#pragma once

#include <boost/asio/ip/udp.hpp>

#include <array>
#include <cstddef>
#include <cstring>
#include <linux/errqueue.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <system_error>

namespace jauscat::net::detail {

/// Enables ICMP errors. From then on a send or receive may fail with the error of an earlier send.
inline void want_icmp_errors(boost::asio::ip::udp::socket& socket, const boost::asio::ip::udp& protocol) {
    const int on = 1;
    const bool v6 = protocol == boost::asio::ip::udp::v6();
    ::setsockopt(socket.native_handle(), v6 ? IPPROTO_IPV6 : IPPROTO_IP, v6 ? IPV6_RECVERR : IP_RECVERR, &on,
                 sizeof on);
}

/// Removes all errors from the queue: `report(destination of the datagram, std::error_code)`. Returns their number.
template <class Report> std::size_t take_icmp_errors(boost::asio::ip::udp::socket& socket, Report report) {
    std::size_t count = 0;
    for (;; ++count) {
        boost::asio::ip::udp::endpoint sent_to;
        alignas(cmsghdr) std::array<std::byte, 512> control{};
        msghdr message{};
        message.msg_name = sent_to.data();
        message.msg_namelen = static_cast<socklen_t>(sent_to.capacity());
        message.msg_control = control.data();
        message.msg_controllen = control.size();
        if (::recvmsg(socket.native_handle(), &message, MSG_ERRQUEUE | MSG_DONTWAIT) < 0) return count;

        sent_to.resize(message.msg_namelen);
        for (auto* part = CMSG_FIRSTHDR(&message); part != nullptr; part = CMSG_NXTHDR(&message, part)) {
            if (part->cmsg_type != IP_RECVERR && part->cmsg_type != IPV6_RECVERR) continue;
            sock_extended_err error{};
            std::memcpy(&error, CMSG_DATA(part), sizeof error);
            report(sent_to, std::error_code{static_cast<int>(error.ee_errno), std::generic_category()});
        }
    }
}

} // namespace jauscat::net::detail
