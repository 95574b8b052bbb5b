// Endpoints of UDP and TCP in messages.
#pragma once

#include <boost/asio/ip/basic_endpoint.hpp>

#include <string>

namespace jauscat::net::detail {

/// "127.0.0.1:39777" or "[::1]:39777".
template <class Protocol> std::string text(const boost::asio::ip::basic_endpoint<Protocol>& endpoint) {
    const auto ip = endpoint.address().to_string();
    return (endpoint.address().is_v6() ? '[' + ip + ']' : ip) + ':' + std::to_string(endpoint.port());
}

} // namespace jauscat::net::detail
