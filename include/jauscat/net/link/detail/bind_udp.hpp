// Opens a UDP socket at a given port, with an explanation of failures.
#pragma once

#include <jauscat/net/bind_error.hpp>
#include <jauscat/net/config/udp_options.hpp>
#include <jauscat/net/detail/endpoint_text.hpp>
#include <jauscat/net/open_error.hpp>

#include <boost/asio/ip/udp.hpp>

#include <algorithm>
#include <limits>
#include <string>
#include <sys/socket.h>

namespace jauscat::net::detail {

/// Asio has no SO_REUSEPORT, and its buffer sizes are of type int.
inline void set_udp_options(boost::asio::ip::udp::socket& socket, const udp_options& options) {
    const auto set = [&socket](int name, std::size_t value) {
        constexpr auto most = static_cast<std::size_t>(std::numeric_limits<int>::max());
        const int number = static_cast<int>(std::min(value, most));
        if (value != 0) ::setsockopt(socket.native_handle(), SOL_SOCKET, name, &number, sizeof number);
    };
    set(SO_REUSEADDR, options.reuse_address ? 1 : 0);
    set(SO_REUSEPORT, options.reuse_port ? 1 : 0);
    set(SO_RCVBUF, options.receive_buffer);
    set(SO_SNDBUF, options.send_buffer);
}

/// Opens `socket` and binds it to `local`. Throws `open_error`.
inline void bind_udp(boost::asio::ip::udp::socket& socket, const boost::asio::ip::udp::endpoint& local,
                     const udp_options& options = {}) {
    boost::system::error_code error;
    socket.open(local.protocol(), error);
    if (!error) {
        set_udp_options(socket, options);
        socket.bind(local, error);
    }
    if (error) throw open_error{bind_error(error, "cannot receive at UDP " + text(local), local.port(), "-ulpn")};
}

} // namespace jauscat::net::detail
