// Messages from a UDP port, as they arrive.
#pragma once
#include "record.hpp"
#include <jauscat/net/detail/endpoint_text.hpp>
#include <jauscat/net/node/run_until.hpp>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/multicast.hpp>
#include <boost/asio/ip/udp.hpp>

#include <functional>

namespace jausdump {

/// Another program has the port.
struct port_taken : input_error {
    using input_error::input_error;
};

/// Receives at a port of all interfaces until `stop` returns true.
class udp_listener {
  public:
    /// Other programs may listen for the same multicast messages, so the port is shared. Throws input_error, and
    /// port_taken.
    udp_listener(std::uint16_t port, const std::vector<std::string>& groups) : socket_{context_, udp::v4()} {
        boost::system::error_code error;
        socket_.set_option(udp::socket::reuse_address{true});
        socket_.bind({udp::v4(), port}, error);
        if (error == boost::asio::error::address_in_use) throw port_taken{"another program has the port"};
        if (error) throw input_error{"cannot listen on UDP port " + std::to_string(port) + ": " + error.message()};
        for (const auto& group : groups) {
            const auto address = boost::asio::ip::make_address_v4(group, error);
            if (!error) socket_.set_option(boost::asio::ip::multicast::join_group{address}, error);
            if (error) throw input_error{"cannot join the multicast group " + group + ": " + error.message()};
        }
    }

    /// Port that is listened on.
    [[nodiscard]] std::uint16_t port() const { return socket_.local_endpoint().port(); }

    void run(const std::function<void(std::span<const std::byte>, const origin&)>& datagram,
             const std::function<bool()>& stop) {
        receive(datagram);
        while (!jauscat::net::run_until(context_, std::chrono::milliseconds{100}, stop)) {}
    }

  private:
    using udp = boost::asio::ip::udp;

    void receive(const std::function<void(std::span<const std::byte>, const origin&)>& datagram) {
        socket_.async_receive_from(boost::asio::buffer(buffer_), from_,
                                   [&](boost::system::error_code error, std::size_t size) {
                                       if (!error)
                                           datagram(std::span{buffer_}.first(size),
                                                    {.place = "packet",
                                                     .number = ++received_,
                                                     .time = std::chrono::system_clock::now().time_since_epoch(),
                                                     .from = jauscat::net::detail::text(from_),
                                                     .to = jauscat::net::detail::text(socket_.local_endpoint())});
                                       receive(datagram);
                                   });
    }

    boost::asio::io_context context_{};
    udp::socket socket_;
    udp::endpoint from_{};
    std::vector<std::byte> buffer_ = std::vector<std::byte>(65536);
    std::size_t received_{};
};

} // namespace jausdump
