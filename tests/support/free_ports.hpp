// Ports for tests whose nodes must know each other's before they have them.
#pragma once

#include <boost/asio/error.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/system/system_error.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace support {

/// UDP ports that nobody has at `ip`, all different. They lie below those that a system gives to sockets that want any
/// (on Linux 32768 and up), so that another test's socket does not take one in the meantime.
template <std::size_t N>
std::array<std::uint16_t, N> free_ports(const boost::asio::ip::address& ip = boost::asio::ip::address_v4::loopback()) {
    using udp = boost::asio::ip::udp;
    std::random_device random;
    std::uniform_int_distribution<unsigned> any{10'000, 32'767};
    boost::asio::io_context context;
    std::vector<udp::socket> sockets; // all are held until the last is found
    std::array<std::uint16_t, N> ports{};
    for (auto& port : ports) {
        boost::system::error_code error;
        do {
            port = static_cast<std::uint16_t>(any(random));
            sockets.emplace_back(context, ip.is_v4() ? udp::v4() : udp::v6()).bind({ip, port}, error);
        } while (error == boost::asio::error::address_in_use);
        if (error) throw boost::system::system_error{error};
    }
    return ports;
}

} // namespace support
