// Options of a UDP socket.
#pragma once

#include <boost/asio/ip/address.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace jauscat::net {

struct udp_options {
    /// SO_REUSEADDR: several sockets at one address and port. A multicast datagram is given to each of them; one for
    /// the host itself to the socket that was bound last.
    bool reuse_address{};
    /// SO_REUSEPORT: the same for programs of one user; datagrams for the host itself are spread over the sockets by
    /// their sender, so that one sender always meets the same program.
    bool reuse_port{};
    /// Bytes that the kernel may hold for this socket, either way; 0 leaves the system's default. The kernel doubles
    /// the number for its own bookkeeping and cuts it at net.core.rmem_max and net.core.wmem_max.
    std::size_t receive_buffer{};
    std::size_t send_buffer{}; ///< the same, for what is sent
};

/// A multicast group, and how to reach it. The defaults are those of JAUS over UDP.
struct multicast_options {
    boost::asio::ip::address group{boost::asio::ip::make_address_v4(0xE0010001)}; ///< 224.1.0.1
    std::uint16_t port{3794};     ///< where the members of the group listen
    std::string interface_name{}; ///< such as eth0; empty: the routing table chooses
    std::uint8_t ttl{1}; ///< routers that a datagram may pass, and one; 1 stays on the local network, 0 on this host
    bool loop{true};     ///< programs on this host receive what is sent here
    friend bool operator==(const multicast_options&, const multicast_options&) = default;
};

} // namespace jauscat::net
