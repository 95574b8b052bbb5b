// Why a socket could not be bound, and what to do.
#pragma once

#include <jauscat/net/error.hpp>

#include <boost/asio/error.hpp>
#include <boost/system/error_code.hpp>

#include <cstdint>
#include <string>
#include <utility>

namespace jauscat::net {

/// `what` could not be done, such as "cannot receive at UDP 127.0.0.1:3794"; `sockets` is the option of `ss` that
/// lists the sockets of the protocol.
inline net::error bind_error(const boost::system::error_code& error, std::string what, std::uint16_t port,
                             const char* sockets) {
    net::error why{.code = errc::not_opened, .reason = error, .message = std::move(what) + ": " + error.message()};
    if (error == boost::asio::error::address_in_use) {
        why.code = errc::address_in_use;
        why.message += "; find the program that holds the port with: ss " + std::string{sockets} +
                       " 'sport = :" + std::to_string(port) + "'";
    } else if (error == boost::system::errc::address_not_available) {
        why.code = errc::unknown_address;
        why.message += "; this machine does not have that address: see ip -brief address";
    } else if (error == boost::asio::error::access_denied) {
        why.code = errc::not_permitted;
        why.message += "; ports below 1024 are for privileged programs: take a higher one";
    }
    return why;
}

} // namespace jauscat::net
