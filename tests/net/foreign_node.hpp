// A node without this library: a plain socket, and bytes written by hand.
#pragma once

#include "support/until.hpp"
#include <jauscat/net/link/multicast.hpp>

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/steady_timer.hpp>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <vector>

namespace net_test {

/// subsystem, node, component, instance, as people say it.
using jaus_id = std::array<unsigned, 4>;

/// What the JAUS01.0 prefix is followed by: header and body.
struct raw_message {
    unsigned code{};
    jaus_id source{}, destination{};
    unsigned properties{0x0206}; ///< version 2, priority 6; 10h: acknowledgement wanted, 40h: service connection
    unsigned sequence{};
    std::vector<unsigned> body{};
};

inline std::vector<std::byte> datagram_of(const raw_message& m, bool with_prefix = true) {
    std::vector<unsigned> all;
    if (with_prefix) all = {'J', 'A', 'U', 'S', '0', '1', '.', '0'};
    const auto put = [&](std::initializer_list<unsigned> values) { all.insert(all.end(), values); };
    const unsigned size = static_cast<unsigned>(m.body.size());
    put({m.properties & 0xFF, m.properties >> 8, m.code & 0xFF, m.code >> 8});
    put({m.destination[3], m.destination[2], m.destination[1], m.destination[0]});
    put({m.source[3], m.source[2], m.source[1], m.source[0]});
    put({size & 0xFF, size >> 8, m.sequence & 0xFF, m.sequence >> 8});
    all.insert(all.end(), m.body.begin(), m.body.end());
    std::vector<std::byte> bytes;
    for (const unsigned value : all) bytes.push_back(static_cast<std::byte>(value));
    return bytes;
}

/// The other way round; nothing for what is not JAUS01.0 and a header with as many bytes behind it as it says.
inline std::optional<raw_message> read_datagram(const std::vector<std::byte>& bytes) {
    constexpr std::array prefix{'J', 'A', 'U', 'S', '0', '1', '.', '0'};
    const auto at = [&](std::size_t i) { return std::to_integer<unsigned>(bytes[i]); };
    if (bytes.size() < 24) return {};
    for (std::size_t i = 0; i != 8; ++i)
        if (at(i) != static_cast<unsigned char>(prefix[i])) return {};
    raw_message m{.code = at(10) + at(11) * 256,
                  .source = {at(19), at(18), at(17), at(16)},
                  .destination = {at(15), at(14), at(13), at(12)},
                  .properties = at(8) + at(9) * 256,
                  .sequence = at(22) + at(23) * 256};
    if (bytes.size() != 24 + at(20) + at(21) % 16 * 256) return {};
    for (std::size_t i = 24; i != bytes.size(); ++i) m.body.push_back(at(i));
    return m;
}

/// Its socket, on the loopback interface.
class foreign_node {
  public:
    using udp = boost::asio::ip::udp;

    explicit foreign_node(boost::asio::io_context& context, std::uint16_t port = 0)
        : context_{context}, socket_{context, udp::endpoint{boost::asio::ip::address_v4::loopback(), port}} {}

    [[nodiscard]] std::uint16_t port() const { return socket_.local_endpoint().port(); }
    void send(std::uint16_t to, const std::vector<std::byte>& datagram) {
        socket_.send_to(boost::asio::buffer(datagram), {boost::asio::ip::address_v4::loopback(), to});
    }
    void send(std::uint16_t to, const raw_message& m) { send(to, datagram_of(m)); }

    void send_to_group(const jauscat::net::multicast_options& group, const raw_message& m) {
        jauscat::net::set_multicast_sending(socket_, group);
        socket_.send_to(boost::asio::buffer(datagram_of(m)), {group.group, group.port});
    }
    /// Sends this every 100 ms while the context runs, until the end of this or fall_silent().
    void repeat(std::uint16_t to, const raw_message& m) {
        send(to, m);
        timer_.expires_after(std::chrono::milliseconds{100});
        timer_.async_wait([this, to, m](boost::system::error_code error) {
            if (!error && !is_silent_) repeat(to, m);
        });
    }

    void fall_silent() { is_silent_ = true; } // a timer that has expired cannot be cancelled any more

    /// The next datagram, while the node that is tested runs; empty when none comes.
    std::vector<std::byte> receive(std::chrono::milliseconds patience = support::wait_limit) {
        if (!jauscat::net::run_until(context_, patience, [&] { return socket_.available() != 0; })) return {};
        std::vector<std::byte> bytes(65536);
        bytes.resize(socket_.receive(boost::asio::buffer(bytes)));
        return bytes;
    }
    /// The next message with this code; others are dropped, and nothing comes of what is not a message.
    std::optional<raw_message> wait_for(unsigned code, std::chrono::milliseconds patience = support::wait_limit) {
        const auto end = std::chrono::steady_clock::now() + patience;
        while (std::chrono::steady_clock::now() < end) {
            const auto bytes = receive(std::chrono::duration_cast<std::chrono::milliseconds>(
                end - std::chrono::steady_clock::now() + std::chrono::milliseconds{1}));
            if (bytes.empty()) continue;
            auto m = read_datagram(bytes);
            if (!m) return {};
            if (m->code == code) return m;
        }
        return {};
    }

  private:
    boost::asio::io_context& context_;
    udp::socket socket_;
    boost::asio::steady_timer timer_{context_};
    bool is_silent_{};
};

} // namespace net_test
