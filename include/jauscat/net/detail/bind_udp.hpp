// Opening a UDP socket at a given port, with an explanation when that fails.
#pragma once

#include <jauscat/net/detail/endpoint_text.hpp>
#include <jauscat/net/open_error.hpp>

#include <boost/asio/error.hpp>
#include <boost/asio/ip/udp.hpp>

#include <string>

namespace jauscat::net::detail {

/// Opens `socket` and binds it to `local`. Throws `open_error`.
inline void bind_udp(boost::asio::ip::udp::socket& socket, const boost::asio::ip::udp::endpoint& local) {
    boost::system::error_code error;
    socket.open(local.protocol(), error);
    if (!error) socket.bind(local, error);
    if (!error) return;

    const auto port = std::to_string(local.port());
    auto reason = "cannot receive at UDP " + text(local) + ": " + error.message();
    if (error == boost::asio::error::address_in_use)
        reason += "; find the program that holds the port with: ss -ulpn 'sport = :" + port + "'";
    else if (error == boost::system::errc::address_not_available)
        reason += "; this machine does not have that address: see ip -brief address";
    else if (error == boost::asio::error::access_denied)
        reason += "; ports below 1024 are for privileged programs: take a higher one";
    throw open_error{reason};
}

} // namespace jauscat::net::detail
