// Converts IPv4-mapped addresses of IPv6 sockets (::ffff:127.0.0.1) to IPv4.
#pragma once

#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/udp.hpp>

namespace jauscat::net::detail {

/// The form of the configuration: IPv4 if mapped.
inline boost::asio::ip::address unmapped(const boost::asio::ip::address& address) {
    namespace ip = boost::asio::ip;
    if (address.is_v4() || !address.to_v6().is_v4_mapped()) return address;
    return ip::make_address_v4(ip::v4_mapped, address.to_v6());
}
inline boost::asio::ip::udp::endpoint unmapped(const boost::asio::ip::udp::endpoint& endpoint) {
    return {unmapped(endpoint.address()), endpoint.port()};
}

/// The form that a socket needs: mapped if the socket is IPv6.
inline boost::asio::ip::udp::endpoint for_socket(const boost::asio::ip::udp::endpoint& endpoint, bool v6) {
    namespace ip = boost::asio::ip;
    if (!v6 || endpoint.address().is_v6()) return endpoint;
    return {ip::make_address_v6(ip::v4_mapped, endpoint.address().to_v4()), endpoint.port()};
}

} // namespace jauscat::net::detail
