// Options of a UDP socket.
#pragma once

#include <boost/asio/ip/address.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace jauscat::net {

struct udp_options {
    /// SO_REUSEADDR: several sockets at one address and port. Each receives multicast datagrams; only the socket bound
    /// last receives unicast datagrams.
    bool reuse_address{};
    /// SO_REUSEPORT: the same for programs of one user; unicast datagrams are distributed over the sockets by sender,
    /// so that a sender always reaches the same program.
    bool reuse_port{};
    /// Size of the kernel's receive buffer; 0: the system's default. The kernel doubles the number for its own
    /// bookkeeping and limits it to net.core.rmem_max and net.core.wmem_max.
    std::size_t receive_buffer{};
    std::size_t send_buffer{}; ///< the same for sending
};

/// A multicast group, and how to reach it. The defaults are those of JAUS over UDP.
struct multicast_options {
    boost::asio::ip::address group{boost::asio::ip::make_address_v4(0xE0010001)}; ///< 224.1.0.1
    std::uint16_t port{3794};                                                     ///< of the members of the group
    std::string interface_name{}; ///< such as eth0; empty: the routing table chooses
    std::uint8_t ttl{1};          ///< number of routers that a datagram may pass, plus 1; 0 stays on this host
    bool loop{true};              ///< programs on this host receive what this socket sends
    friend bool operator==(const multicast_options&, const multicast_options&) = default;
};

} // namespace jauscat::net
