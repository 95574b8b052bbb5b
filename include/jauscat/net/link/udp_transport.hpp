// JAUS messages over UDP with Boost.Asio: one socket, one thread, no allocation for a message without errors.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/message/framing.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/net/config/udp_options.hpp>
#include <jauscat/net/config/verdict.hpp>
#include <jauscat/net/detail/handler_memory.hpp>
#include <jauscat/net/error.hpp>
#include <jauscat/net/link/detail/receive_batch.hpp>
#include <jauscat/net/link/detail/send_batch.hpp>
#include <jauscat/net/link/multicast.hpp>
#include <jauscat/net/link/udp_counters.hpp>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

/// Sends messages from one UDP port and receives them there, in any jaus::framing.
/// Use it from the thread that runs the io_context.
class udp_transport {
  public:
    using endpoint = boost::asio::ip::udp::endpoint;
    /// Largest datagram over IPv4, prefix included, in bytes.
    static constexpr std::size_t max_datagram_size = 65507;
    /// Called with each message: its bytes (valid during the call), its sender and its framing.
    using message_handler =
        std::function<void(std::span<const std::byte> message, const endpoint& from, jaus::framing framing)>;

    /// Called with a line of text for each asynchronous error: a closed port at a peer, a datagram without a message, a
    /// failed receive. The transport continues to receive. Errors of sending to a peer are reported once, until a
    /// message from that peer arrives or the reason changes.
    using error_handler = std::function<void(std::string_view text)>;

    /// Called with each message and its framing, which is removed, before it is processed; it may be empty.
    using filter =
        std::function<verdict(std::span<const std::byte> message, const endpoint& from, jaus::framing framing)>;

    /// Opens and binds the socket; port 0: selected by the system. Throws `open_error`. A socket bound to `::` also
    /// receives and sends IPv4; its endpoints are then those of IPv4.
    JAUSCAT_DECL udp_transport(boost::asio::io_context& context, const endpoint& local,
                               const udp_options& options = {});
    udp_transport(const udp_transport&) = delete;
    udp_transport& operator=(const udp_transport&) = delete;

    /// Starts to receive while the io_context runs, up to 128 datagrams between two of its other handlers. An exception
    /// of a handler leaves `run` and ends receiving; `start` again to continue with the next datagram.
    JAUSCAT_DECL void start(message_handler on_message, error_handler on_error);

    /// Passes on what `accept` takes, and counts the rest without a report: unsolicited datagrams must not flood the
    /// log.
    void set_filter(filter accept) { filter_ = std::move(accept); }

    /// Also receives the datagrams of a group; see net::join_group for the conditions. Throws `open_error`.
    void join(const multicast_options& options) { join_group(socket_, options); }

    /// Sets interface, reach and loopback of datagrams sent to a group. Throws `open_error`.
    void send_multicast_by(const multicast_options& options) { set_multicast_sending(socket_, options); }

    /// Sends one message with the given framing; does not wait. Fails for an empty message, one that does not fit a
    /// datagram, and if the network refuses at once; a closed port at the peer is reported later, to the error handler.
    JAUSCAT_DECL result<void, error> send(std::span<const std::byte> message, const endpoint& to,
                                          jaus::framing framing = jaus::framing::bare);

    /// As `send`, but replies of a message handler are queued until the datagrams that were received together have been
    /// processed, and then sent with one system call: a tenth less time for each message under load. Errors of the
    /// network are passed to the error handler.
    JAUSCAT_DECL void post(std::span<const std::byte> message, const endpoint& to,
                           jaus::framing framing = jaus::framing::bare);

    /// In a message handler: the time of the message in the socket. Too short at first if no other socket of the
    /// machine uses arrival times, because Linux enables them with a delay.
    [[nodiscard]] duration waited() const noexcept { return waited_; }

    /// Closes the socket and leaves its groups. Sent and posted messages go out; no handler is called afterwards.
    JAUSCAT_DECL void stop();

    /// The local endpoint.
    endpoint local() const { return socket_.local_endpoint(); }
    /// Since construction.
    const udp_counters& counts() const noexcept { return counters_; }

  private:
    JAUSCAT_DECL void receive();

    /// Sleeping and waking costs as much as several datagrams, so it polls once more before, a limited number of times:
    /// the io_context has other handlers.
    JAUSCAT_DECL void receive_batches();

    JAUSCAT_DECL void hand_on_batch();
    JAUSCAT_DECL void end_batch();

    /// Sends posted messages.
    JAUSCAT_DECL void flush();

    JAUSCAT_DECL error not_sent(const endpoint& to, int failed);

    JAUSCAT_DECL void received();
    JAUSCAT_DECL void hand_on(const jaus::framed_message& part, const endpoint& from);

    JAUSCAT_DECL void receive_failed(int error);

    JAUSCAT_DECL void count_drops(std::uint32_t dropped) noexcept;

    JAUSCAT_DECL std::size_t take_refusals();
    /// An absent peer is sent a heartbeat each second, so its error is reported once. With more peers than the limit
    /// every error is reported.
    JAUSCAT_DECL bool is_news(const endpoint& peer, std::error_code error);

    JAUSCAT_DECL void tell(const std::string& text);
    JAUSCAT_DECL void report(const std::string& text);
    JAUSCAT_DECL error failure(error what);

    static constexpr int max_batches = 4;
    static constexpr std::size_t max_posted_size =
        jaus::message_prefix::max_size + jaus::header_size + jaus::max_body_size;

    boost::asio::ip::udp::socket socket_;
    bool v6_;
    detail::receive_batch<max_datagram_size> batch_{};
    detail::send_batch<max_posted_size> out_{};
    bool handing_on_{};
    message_handler on_message_{};
    error_handler on_error_{};
    filter filter_{};
    udp_counters counters_{};
    std::map<endpoint, std::error_code> unreachable_{}; ///< peers, and the last error of each
    duration waited_{};
    std::uint32_t dropped_{}; ///< the kernel's count, modulo 2^32, at the last datagram
    std::shared_ptr<detail::handler_memory> memory_{std::make_shared<detail::handler_memory>()};
    std::shared_ptr<char> alive_{std::make_shared<char>()};
};

} // namespace JAUSCAT_WAY
} // namespace jauscat::net

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/net/link/impl/udp_transport.ipp>
#endif
