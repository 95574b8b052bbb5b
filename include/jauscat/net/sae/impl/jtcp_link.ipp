// The functions of jtcp_link.
#pragma once
#include <jauscat/net/bind_error.hpp>
#include <jauscat/net/sae/detail/bounded_writer.hpp>
#include <jauscat/net/sae/jtcp_link.hpp>
#include <jauscat/sae/transport/jtcp.hpp>

#include <boost/asio/error.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <string>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

struct jtcp_link::connection {
    connection(boost::asio::ip::tcp::socket opened, std::uint64_t number, const jtcp_options& options,
               std::function<void()> failed)
        : socket{std::move(opened)},
          key{number},
          message(std::max(options.message_size, sae::transport_overhead)),
          out{socket, options.max_waiting, [done = std::move(failed)](const boost::system::error_code&) { done(); }} {}

    boost::asio::ip::tcp::socket socket;
    std::uint64_t key;
    std::vector<std::byte> message;
    sae::jtcp_reader reader{message};
    sae::jtcp_writer writer{};
    detail::bounded_writer<boost::asio::ip::tcp::socket> out;
    std::vector<std::byte> written{};
    std::array<std::byte, 4096> input{};
    token_bucket bucket{};
};

JAUSCAT_DECL jtcp_link::jtcp_link(boost::asio::io_context& context, sae::transport& transport,
                                  const jtcp_options& options)
    : context_{context},
      options_{options},
      acceptor_{context},
      pause_{context},
      driver_{context, transport, [this](const sae::outgoing_datagram& datagram) { put(datagram); }} {
    if (!options.listen) return;
    boost::system::error_code error;
    acceptor_.open(options.listen->protocol(), error);
    if (!error) acceptor_.set_option(boost::asio::socket_base::reuse_address{true}, error);
    if (!error) acceptor_.bind(*options.listen, error);
    if (!error) acceptor_.listen(boost::asio::socket_base::max_listen_connections, error);
    if (error)
        throw open_error{bind_error(error,
                                    "cannot accept connections at TCP port " + std::to_string(options.listen->port()),
                                    options.listen->port(), "-tlpn")};
}

JAUSCAT_DECL jtcp_link::~jtcp_link() {
    try {
        stop();
    } catch (...) { // of the log; the sockets are closed in any case
    }
}

JAUSCAT_DECL void jtcp_link::start(sae_handlers handlers) {
    driver_.start(std::move(handlers));
    if (acceptor_.is_open()) accept();
}

JAUSCAT_DECL void jtcp_link::stop() {
    alive_ = std::make_shared<char>();
    driver_.stop();
    boost::system::error_code ignored;
    acceptor_.close(ignored);
    pause_.cancel();
    while (!connections_.empty()) close(connections_.begin()->first);
}

JAUSCAT_DECL void jtcp_link::accept() {
    acceptor_.async_accept([this, token = std::weak_ptr<char>{alive_}](const boost::system::error_code& error,
                                                                       boost::asio::ip::tcp::socket socket) {
        if (token.expired() || error == boost::asio::error::operation_aborted) return;
        if (!error) {
            accepted(std::move(socket));
            return accept();
        }
        // Such as too many open files: trying again at once would only fail again.
        driver_.report("accepting a connection failed: " + error.message());
        pause_.expires_after(std::chrono::milliseconds{100});
        pause_.async_wait([this, token](const boost::system::error_code& aborted) {
            if (!aborted && !token.expired()) accept();
        });
    });
}

JAUSCAT_DECL void jtcp_link::accepted(boost::asio::ip::tcp::socket socket) {
    boost::system::error_code error;
    const auto from = socket.remote_endpoint(error);
    if (error) return; // it was closed meanwhile
    if (!options_.accepted.empty() && std::ranges::find(options_.accepted, from.address()) == options_.accepted.end())
        ++counters_.unknown_peer;
    else if (connections_.size() >= options_.max_connections)
        ++counters_.no_capacity;
    else {
        ++counters_.accepted;
        open(std::move(socket));
    }
}

JAUSCAT_DECL void jtcp_link::connect(const endpoint& to) {
    auto socket = std::make_shared<boost::asio::ip::tcp::socket>(context_);
    socket->async_connect(
        to, [this, socket, to, token = std::weak_ptr<char>{alive_}](const boost::system::error_code& error) {
            if (token.expired()) return;
            if (error)
                return driver_.report("cannot connect to " + to.address().to_string() + ' ' +
                                      std::to_string(to.port()) + ": " + error.message());
            if (connections_.size() >= options_.max_connections) {
                ++counters_.no_capacity;
                return;
            }
            ++counters_.connected;
            open(std::move(*socket));
        });
}

JAUSCAT_DECL void jtcp_link::open(boost::asio::ip::tcp::socket socket) {
    boost::system::error_code ignored;
    socket.set_option(boost::asio::ip::tcp::no_delay{true}, ignored);
    const auto key = ++last_key_;
    const auto opened = std::make_shared<connection>(std::move(socket), key, options_,
                                                     [this, key, token = std::weak_ptr<char>{alive_}] {
                                                         if (!token.expired()) close(key);
                                                     });
    connections_.emplace(key, opened);
    receive(opened);
}

JAUSCAT_DECL void jtcp_link::receive(const std::shared_ptr<connection>& from) {
    from->socket.async_read_some(
        boost::asio::buffer(from->input),
        [this, from, token = std::weak_ptr<char>{alive_}](const boost::system::error_code& error, std::size_t size) {
            if (token.expired() || !connections_.contains(from->key)) return;
            if (error) return close(from->key);
            received(*from, std::span{from->input}.first(size));
            if (token.expired() || !connections_.contains(from->key)) return;
            if (from->reader.error() != sae::transport_errc::ok) {
                ++counters_.wrong;
                return close(from->key);
            }
            receive(from);
        });
}

JAUSCAT_DECL void jtcp_link::received(connection& from, std::span<const std::byte> bytes) {
    from.reader.on_bytes(bytes, [&, token = std::weak_ptr<char>{alive_}](const sae::split_transport_message& packet) {
        if (token.expired()) return; // a handler has stopped it
        if (from.bucket.take(options_.limit, now()))
            driver_.on_packet({from.key}, packet);
        else
            ++counters_.rate_limited;
    });
}

JAUSCAT_DECL void jtcp_link::put(const sae::outgoing_datagram& datagram) {
    if (!datagram.to) {
        for (const auto& [key, to] : connections_) write(to, datagram.message());
        return;
    }
    if (const auto found = connections_.find(datagram.to->value); found != connections_.end())
        write(found->second, datagram.message());
}

JAUSCAT_DECL void jtcp_link::write(const std::shared_ptr<connection>& to, std::span<const std::byte> message) {
    to->written.resize(1 + message.size());
    auto writer = to->writer; // the version byte is still to be sent if this is dropped
    const auto bytes = writer.put(message, to->written);
    if (!bytes || !to->out.write(*bytes, to)) {
        ++counters_.dropped;
        return;
    }
    to->writer = writer;
}

JAUSCAT_DECL void jtcp_link::close(std::uint64_t key) {
    const auto found = connections_.find(key);
    if (found == connections_.end()) return;
    boost::system::error_code ignored;
    found->second->socket.close(ignored);
    connections_.erase(found);
    driver_.transport().forget({key});
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::net
