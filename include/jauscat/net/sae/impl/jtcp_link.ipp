// The functions of jtcp_link.
#pragma once
#include <jauscat/net/bind_error.hpp>
#include <jauscat/net/detail/endpoint_text.hpp>
#include <jauscat/net/sae/detail/bounded_writer.hpp>
#include <jauscat/net/sae/detail/keep_alive.hpp>
#include <jauscat/net/sae/jtcp_link.hpp>
#include <jauscat/sae/transport/jtcp.hpp>

#include <boost/asio/error.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <string>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

/// A peer to which a connection is to be kept.
struct jtcp_link::target {
    target(boost::asio::io_context& context, const endpoint& peer, const pause_limits& limits)
        : to{peer}, pause{limits}, timer{context} {}

    endpoint to;
    growing_pause pause;
    boost::asio::steady_timer timer; ///< of an attempt, and of the pause behind it
    std::shared_ptr<boost::asio::ip::tcp::socket> attempt{};
    std::string reason{}; ///< of the last failure that was logged; empty after a connection
};

struct jtcp_link::connection {
    connection(boost::asio::ip::tcp::socket opened, std::uint64_t number, const endpoint& from,
               const jtcp_options& options, std::function<void(const boost::system::error_code&)> failed)
        : socket{std::move(opened)},
          idle{socket.get_executor()},
          key{number},
          peer{from},
          message(std::max(options.message_size, sae::transport_overhead)),
          out{socket, options.max_waiting, std::move(failed)} {}

    boost::asio::ip::tcp::socket socket;
    boost::asio::steady_timer idle;
    std::uint64_t key;
    endpoint peer;
    std::shared_ptr<target> wanted{}; ///< where it was made by `connect`
    time_point heard_at{now()};
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
    : context_{context}, options_{options}, acceptor_{context}, pause_{context}, medium_{context, transport, putter()} {
    if (options.listen) listen();
}
JAUSCAT_DECL jtcp_link::jtcp_link(boost::asio::io_context& context, transport_driver& driver,
                                  const jtcp_options& options)
    : context_{context}, options_{options}, acceptor_{context}, pause_{context}, medium_{driver, putter()} {
    if (options.listen) listen();
}

JAUSCAT_DECL void jtcp_link::listen() {
    const auto& at = *options_.listen;
    boost::system::error_code error;
    acceptor_.open(at.protocol(), error);
    if (!error) acceptor_.set_option(boost::asio::socket_base::reuse_address{true}, error);
    if (!error) acceptor_.bind(at, error);
    if (!error) acceptor_.listen(boost::asio::socket_base::max_listen_connections, error);
    if (error)
        throw open_error{bind_error(error, "cannot accept connections at TCP port " + std::to_string(at.port()),
                                    at.port(), "-tlpn")};
}

JAUSCAT_DECL jtcp_link::~jtcp_link() {
    try {
        stop();
    } catch (...) { // of the log; the sockets are closed in any case
    }
}

JAUSCAT_DECL void jtcp_link::start(sae_handlers handlers) {
    medium_.start(std::move(handlers));
    if (acceptor_.is_open()) accept();
}

JAUSCAT_DECL void jtcp_link::stop() {
    alive_ = std::make_shared<char>();
    medium_.stop();
    boost::system::error_code ignored;
    acceptor_.close(ignored);
    pause_.cancel();
    for (const auto& to : targets_) {
        to->timer.cancel();
        if (to->attempt) to->attempt->close(ignored);
    }
    targets_.clear();
    while (!connections_.empty()) close(connections_.begin()->first, {});
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
        medium_.report("accepting a connection failed: " + error.message());
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
    if (!options_.accepted.empty() && std::ranges::find(options_.accepted, from.address()) == options_.accepted.end()) {
        ++counters_.unknown_peer;
        medium_.report("a connection from " + detail::text(from) +
                       " is refused: its host is not accepted; give it as ip of a system with <jtcp>, or in the option"
                       " accepted");
    } else if (connections_.size() >= options_.max_connections)
        ++counters_.no_capacity;
    else {
        ++counters_.accepted;
        open(std::move(socket), from, {});
    }
}

JAUSCAT_DECL void jtcp_link::connect(const endpoint& to) {
    targets_.push_back(std::make_shared<target>(context_, to, options_.reconnect));
    try_to_connect(targets_.back());
}

// Whoever takes the attempt from the target decides: its connection, or its timeout.
JAUSCAT_DECL void jtcp_link::try_to_connect(const std::shared_ptr<target>& to) {
    to->attempt = std::make_shared<boost::asio::ip::tcp::socket>(context_);
    if (!options_.from.is_unspecified()) {
        boost::system::error_code error;
        to->attempt->open(to->to.protocol(), error);
        if (!error) to->attempt->bind({options_.from, 0}, error);
        if (error) return not_connected(to, "from " + options_.from.to_string() + ": " + error.message());
    }
    if (options_.connect_timeout > duration{}) give_up_later(to);
    to->attempt->async_connect(to->to, [this, socket = to->attempt, to,
                                        token = std::weak_ptr<char>{alive_}](const boost::system::error_code& error) {
        if (token.expired() || to->attempt != socket) return;
        to->attempt.reset();
        to->timer.cancel();
        if (error) return not_connected(to, error.message());
        if (connections_.size() >= options_.max_connections) {
            ++counters_.no_capacity;
            return not_connected(to, "there are " + std::to_string(options_.max_connections) +
                                         " connections already (option max_connections)");
        }
        ++counters_.connected;
        if (!to->reason.empty()) medium_.report("connected to " + detail::text(to->to) + " again");
        to->reason.clear();
        open(std::move(*socket), to->to, to);
    });
}

JAUSCAT_DECL void jtcp_link::give_up_later(const std::shared_ptr<target>& to) {
    to->timer.expires_at(to_steady(saturating_add(now(), options_.connect_timeout)));
    to->timer.async_wait([this, socket = to->attempt, to,
                          token = std::weak_ptr<char>{alive_}](const boost::system::error_code& aborted) {
        if (aborted || token.expired() || to->attempt != socket) return;
        to->attempt.reset();
        boost::system::error_code ignored;
        socket->close(ignored);
        const auto limit = std::chrono::duration_cast<std::chrono::milliseconds>(options_.connect_timeout);
        not_connected(to, "no answer within " + std::to_string(limit.count()) + " ms (option connect_timeout)");
    });
}

JAUSCAT_DECL void jtcp_link::not_connected(const std::shared_ptr<target>& to, const std::string& why) {
    ++counters_.failed;
    if (to->reason != why)
        medium_.report("cannot connect to " + detail::text(to->to) + ": " + why +
                       "; it is tried again: start the program there, or correct the address");
    to->reason = why;
    try_again_later(to);
}

JAUSCAT_DECL void jtcp_link::try_again_later(const std::shared_ptr<target>& to) {
    to->timer.expires_after(std::chrono::duration_cast<std::chrono::steady_clock::duration>(to->pause.next()));
    to->timer.async_wait([this, to, token = std::weak_ptr<char>{alive_}](const boost::system::error_code& aborted) {
        if (!aborted && !token.expired()) try_to_connect(to);
    });
}

JAUSCAT_DECL void jtcp_link::open(boost::asio::ip::tcp::socket socket, const endpoint& peer,
                                  const std::shared_ptr<target>& wanted) {
    boost::system::error_code ignored;
    socket.set_option(boost::asio::ip::tcp::no_delay{true}, ignored);
    if (options_.keep_alive > duration{} && !detail::set_keep_alive(socket, options_.keep_alive))
        medium_.report("the connection with " + detail::text(peer) +
                       " has no keep-alive: " + last_system_error().message());
    const auto key = ++last_key_;
    const auto opened = std::make_shared<connection>(
        std::move(socket), key, peer, options_,
        [this, key, token = std::weak_ptr<char>{alive_}](const boost::system::error_code& error) {
            if (!token.expired()) close(key, error.message());
        });
    opened->wanted = wanted;
    connections_.emplace(key, opened);
    if (options_.idle_limit > duration{}) watch_idle(opened);
    receive(opened);
}

JAUSCAT_DECL void jtcp_link::watch_idle(const std::shared_ptr<connection>& to) {
    to->idle.expires_at(to_steady(saturating_add(to->heard_at, options_.idle_limit)));
    to->idle.async_wait([this, token = std::weak_ptr<char>{alive_},
                         watched = std::weak_ptr{to}](const boost::system::error_code& aborted) {
        const auto it = watched.lock();
        if (aborted || token.expired() || !it) return;
        if (now() - it->heard_at < options_.idle_limit) return watch_idle(it);
        ++counters_.idle;
        close(it->key, "nothing came from it for longer than idle_limit");
    });
}

JAUSCAT_DECL void jtcp_link::receive(const std::shared_ptr<connection>& from) {
    from->socket.async_read_some(
        boost::asio::buffer(from->input),
        [this, from, token = std::weak_ptr<char>{alive_}](const boost::system::error_code& error, std::size_t size) {
            if (token.expired() || !connections_.contains(from->key)) return;
            if (error)
                return close(from->key, error == boost::asio::error::eof ? "the peer has closed it" : error.message());
            from->heard_at = now();
            received(*from, std::span{from->input}.first(size));
            if (token.expired() || !connections_.contains(from->key)) return;
            if (from->reader.error() != sae::transport_errc::ok) {
                ++counters_.wrong;
                return close(from->key, std::string{describe(from->reader.error())});
            }
            receive(from);
        });
}

JAUSCAT_DECL void jtcp_link::received(connection& from, std::span<const std::byte> bytes) {
    from.reader.on_bytes(bytes, [&, token = std::weak_ptr<char>{alive_}](const sae::split_transport_message& packet) {
        if (token.expired()) return; // a handler has stopped it
        if (from.wanted) from.wanted->pause.reset();
        if (from.bucket.take(options_.limit, now()))
            medium_.on_packet({from.key}, packet);
        else
            ++counters_.rate_limited;
    });
}

JAUSCAT_DECL std::optional<jtcp_link::endpoint> jtcp_link::peer_of(sae::endpoint_key key) const {
    const auto found = connections_.find(transport_medium::own_key(key).value);
    return found == connections_.end() ? std::nullopt : std::optional{found->second->peer};
}

JAUSCAT_DECL std::optional<sae::endpoint_key> jtcp_link::connection_to(const endpoint& to) const {
    const auto found = std::ranges::find_if(connections_, [&](const auto& one) {
        const auto& wanted = one.second->wanted;
        return wanted && wanted->to == to;
    });
    return found == connections_.end() ? std::nullopt : std::optional{medium_.in_transport({found->first})};
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

// Without a reason the link stops.
JAUSCAT_DECL void jtcp_link::close(std::uint64_t key, const std::string& why) {
    const auto found = connections_.find(key);
    if (found == connections_.end()) return;
    const auto closed = found->second;
    boost::system::error_code ignored;
    closed->socket.close(ignored);
    closed->idle.cancel();
    connections_.erase(found);
    medium_.forget({key});
    if (why.empty()) return;
    if (closed->wanted) {
        closed->wanted->reason = why;
        try_again_later(closed->wanted);
    }
    medium_.report("the connection with " + detail::text(closed->peer) + " has ended: " + why +
                   (closed->wanted ? "; it is made again" : ""));
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::net
