// Ports for tests whose nodes must know each other's before they have them.
#pragma once

#include <boost/asio/error.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/system/system_error.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace support {

/// TCP sockets of the same numbers as the ports that were given, until the test ends.
struct port_marks {
    boost::asio::io_context context{};
    std::vector<boost::asio::ip::tcp::socket> held{};
};
inline port_marks& marked_ports() {
    static port_marks all;
    return all;
}

/// UDP ports that nobody has at `ip`, and that no other call has given, here or in a test that runs beside. They lie
/// below those that a system gives to sockets that want any (on Linux 32768 and up), so that another test's socket does
/// not take one in the meantime.
template <std::size_t N>
std::array<std::uint16_t, N> free_ports(const boost::asio::ip::address& ip = boost::asio::ip::address_v4::loopback()) {
    using boost::asio::ip::tcp, boost::asio::ip::udp;
    auto& [context, held] = marked_ports();
    std::random_device random;
    std::uniform_int_distribution<unsigned> any{10'000, 32'767};
    std::array<std::uint16_t, N> ports{};
    for (auto& port : ports) {
        boost::system::error_code error;
        do {
            port = static_cast<std::uint16_t>(any(random));
            tcp::socket mark{context, ip.is_v4() ? tcp::v4() : tcp::v6()};
            mark.bind({ip, port}, error);
            if (!error) udp::socket{context, ip.is_v4() ? udp::v4() : udp::v6()}.bind({ip, port}, error);
            if (!error) held.push_back(std::move(mark));
        } while (error == boost::asio::error::address_in_use);
        if (error) throw boost::system::system_error{error};
    }
    return ports;
}

} // namespace support
