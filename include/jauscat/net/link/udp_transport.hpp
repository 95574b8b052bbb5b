// JAUS messages over UDP with Boost.Asio: one socket, one thread, no allocation for a message without errors.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/jaus/message/framing.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/net/config/verdict.hpp>
#include <jauscat/net/detail/handler_memory.hpp>
#include <jauscat/net/detail/mapped_address.hpp>
#include <jauscat/net/error.hpp>
#include <jauscat/net/link/detail/bind_udp.hpp>
#include <jauscat/net/link/detail/icmp_errors.hpp>
#include <jauscat/net/link/detail/receive_batch.hpp>
#include <jauscat/net/link/detail/send_batch.hpp>
#include <jauscat/net/link/detail/send_parts.hpp>
#include <jauscat/net/link/multicast.hpp>
#include <jauscat/net/link/udp_counters.hpp>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>

#include <cerrno>
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

/// Sends messages from one UDP port and receives them there, with or without the `JAUS01.0` prefix.
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

    /// Called with each datagram's content, framing removed, before it is processed; it may be empty.
    using filter = std::function<verdict(std::span<const std::byte> message, const endpoint& from)>;

    /// Opens and binds the socket; port 0: selected by the system. Throws `open_error`. A socket bound to `::` also
    /// receives and sends IPv4; its endpoints are then those of IPv4.
    udp_transport(boost::asio::io_context& context, const endpoint& local, const udp_options& options = {})
        : socket_{context}, v6_{local.protocol() == boost::asio::ip::udp::v6()} {
        detail::bind_udp(socket_, local, options);
        detail::want_icmp_errors(socket_, local.protocol());
        detail::want_drop_count(socket_);
        detail::want_arrival_time(socket_);
    }
    udp_transport(const udp_transport&) = delete;
    udp_transport& operator=(const udp_transport&) = delete;

    /// Starts to receive while the io_context runs, up to 128 datagrams between two of its other handlers. An exception
    /// of a handler leaves `run` and ends receiving; `start` again to continue with the next datagram.
    void start(message_handler on_message, error_handler on_error) {
        on_message_ = std::move(on_message);
        on_error_ = std::move(on_error);
        receive();
    }

    /// Passes on what `accept` takes, and counts the rest without a report: unsolicited datagrams must not flood the
    /// log.
    void set_filter(filter accept) { filter_ = std::move(accept); }

    /// Also receives the datagrams of a group; see net::join_group for the conditions. Throws `open_error`.
    void join(const multicast_options& options) { join_group(socket_, options); }

    /// Sets interface, reach and loopback of datagrams sent to a group. Throws `open_error`.
    void send_multicast_by(const multicast_options& options) { set_multicast_sending(socket_, options); }

    /// Sends one message with the given framing; does not wait. Fails for an empty message, one that does not fit a
    /// datagram, and if the network refuses at once; a closed port at the peer is reported later, to the error handler.
    result<void, error> send(std::span<const std::byte> message, const endpoint& to,
                             jaus::framing framing = jaus::framing::bare) {
        const auto prefix = jaus::prefix(framing);
        if (message.empty())
            return failure({.code = errc::empty_message, .reason = {}, .message = "an empty message is not sent"});
        if (prefix.size() + message.size() > max_datagram_size)
            return failure({.code = errc::too_large,
                            .reason = {},
                            .message = "a message of " + std::to_string(message.size()) +
                                       " bytes does not fit a datagram of " + std::to_string(max_datagram_size) +
                                       " bytes; send it in several packets"});
        flush();
        const auto target = detail::for_socket(to, v6_);
        int failed = detail::send_parts(socket_, prefix, message, target);
        // The error of an earlier datagram, maybe to another peer, is reported instead of sending: remove it and
        // repeat.
        if (failed != 0 && take_refusals() > 0) failed = detail::send_parts(socket_, prefix, message, target);
        if (failed != 0) return not_sent(to, failed);
        ++counters_.sent;
        return {};
    }

    /// As `send`, but replies of a message handler are queued until the datagrams that were received together have been
    /// processed, and then sent with one system call: a tenth less time for each message under load. Errors of the
    /// network are passed to the error handler.
    void post(std::span<const std::byte> message, const endpoint& to, jaus::framing framing = jaus::framing::bare) {
        const auto prefix = jaus::prefix(framing);
        if (!handing_on_ || message.empty() || prefix.size() + message.size() > max_posted_size) {
            if (const auto done = send(message, to, framing); !done) tell(done.error().message);
            return;
        }
        if (out_.full()) flush();
        out_.push(prefix, message, detail::for_socket(to, v6_));
    }

    /// In a message handler: the time of the message in the socket. Too short at first if no other socket of the
    /// machine uses arrival times, because Linux enables them with a delay.
    [[nodiscard]] duration waited() const noexcept { return waited_; }

    /// Closes the socket and leaves its groups. Sent and posted messages go out; no handler is called afterwards.
    void stop() {
        flush();
        boost::system::error_code ignored;
        socket_.close(ignored);
    }

    /// The local endpoint.
    endpoint local() const { return socket_.local_endpoint(); }
    /// Since construction.
    const udp_counters& counts() const noexcept { return counters_; }

  private:
    void receive() {
        // By the token a completion that was already queued detects whether the transport still exists.
        auto complete = [this, token = std::weak_ptr<char>{alive_}](boost::system::error_code error) {
            if (token.expired() || !socket_.is_open()) return;
            if (error)
                report("waiting for datagrams failed: " + error.message());
            else
                receive_batches();
            if (socket_.is_open()) receive();
        };
        // Datagrams left by an exception are processed as soon as the io_context runs: a UDP socket is always writable.
        const auto event = batch_.empty() ? socket_.wait_read : socket_.wait_write;
        socket_.async_wait(event, detail::remembered_handler{std::move(complete), memory_});
    }

    /// Sleeping and waking costs as much as several datagrams, so it polls once more before, a limited number of times:
    /// the io_context has other handlers.
    void receive_batches() {
        for (int batches = 0; socket_.is_open() && batches != max_batches; ++batches) {
            const int error = batch_.empty() ? batch_.receive(socket_.native_handle()) : 0;
            if (error == EAGAIN && batches != 0) return; // an error would have been reported before
            if (error != 0) return receive_failed(error);
            hand_on_batch();
        }
    }

    void hand_on_batch() {
        handing_on_ = true;
        try {
            while (socket_.is_open() && !batch_.empty()) received();
        } catch (...) {
            end_batch();
            throw;
        }
        end_batch();
    }
    void end_batch() {
        handing_on_ = false;
        flush();
    }

    /// Sends posted messages.
    void flush() {
        while (!out_.empty()) {
            int failed = out_.send(socket_.native_handle(), counters_.sent);
            if (failed != 0 && take_refusals() > 0) failed = out_.send(socket_.native_handle(), counters_.sent);
            if (failed == 0) return;
            const auto to = detail::unmapped(out_.front());
            out_.pop();
            tell(not_sent(to, failed).message);
        }
    }

    error not_sent(const endpoint& to, int failed) {
        const std::error_code reason{failed, std::generic_category()};
        auto problem = "cannot send to " + detail::text(to) + ": " + reason.message();
        if (!detail::is_back_pressure(failed))
            return failure({.code = errc::not_sent, .reason = reason, .message = std::move(problem)});
        ++counters_.would_block;
        problem += "; the network takes less than is sent: send more slowly, or set send_buffer";
        return {.code = errc::back_pressure, .reason = reason, .message = std::move(problem)};
    }

    void received() {
        const auto [framing, message] = jaus::remove_framing(batch_.bytes());
        const auto from = detail::unmapped(batch_.from());
        const bool truncated = batch_.truncated();
        count_drops(batch_.dropped_before());
        waited_ = batch_.waited();
        batch_.pop(); // before a handler may throw; the bytes stay until the next batch
        if (truncated) {
            ++counters_.oversize;
            if (!filter_)
                tell("a datagram from " + detail::text(from) + " is larger than " + std::to_string(max_datagram_size) +
                     " bytes and was dropped");
        } else if (const auto decision = filter_ ? filter_(message, from) : verdict::accepted;
                   decision != verdict::accepted)
            counters_.count(decision);
        else if (message.empty())
            report("a datagram from " + detail::text(from) + " holds no message");
        else {
            ++counters_.received;
            if (!unreachable_.empty()) unreachable_.erase(from);
            on_message_(message, from, framing);
        }
    }

    void receive_failed(int error) {
        // An error that `send` has removed from the queue meanwhile was reported there.
        if (take_refusals() == 0 && error != ECONNREFUSED && error != EAGAIN && error != EINTR)
            report("receiving failed: " + std::generic_category().message(error));
    }

    void count_drops(std::uint32_t dropped) noexcept {
        if (dropped == 0) return; // the kernel reports only numbers above 0
        counters_.dropped += dropped - std::exchange(dropped_, dropped);
    }

    std::size_t take_refusals() {
        return detail::take_icmp_errors(socket_, [this](const endpoint& sent_to, std::error_code error) {
            ++counters_.refused;
            const auto to = detail::unmapped(sent_to);
            if (is_news(to, error))
                tell(detail::text(to) + (error == std::errc::connection_refused
                                             ? ": closed port: no program receives there"
                                             : ": not delivered: " + error.message()));
        });
    }
    /// An absent peer is sent a heartbeat each second, so its error is reported once. With more peers than the limit
    /// every error is reported.
    bool is_news(const endpoint& peer, std::error_code error) {
        constexpr std::size_t most = 256;
        if (unreachable_.size() == most && !unreachable_.contains(peer)) return true;
        return std::exchange(unreachable_[peer], error) != error;
    }

    void tell(const std::string& text) {
        if (on_error_) on_error_(text);
    }
    void report(const std::string& text) {
        ++counters_.errors;
        tell(text);
    }
    error failure(error what) {
        ++counters_.errors;
        return what;
    }

    static constexpr int max_batches = 4;
    static constexpr std::size_t max_posted_size =
        jaus::prefix(jaus::framing::jaus01).size() + jaus::header_size + jaus::max_body_size;

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

} // namespace jauscat::net
