// JAUS messages over UDP with Boost.Asio: one socket, one thread, no allocation for a message that goes well.
#pragma once

#include <jauscat/jaus/framing.hpp>
#include <jauscat/net/detail/bind_udp.hpp>
#include <jauscat/net/detail/icmp_errors.hpp>
#include <jauscat/net/outcome.hpp>

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace jauscat::net {

/// Sends messages from one UDP port and receives them there, with or without the `JAUS01.0` prefix.
/// Use it from the thread that runs the io_context.
class udp_transport {
  public:
    using endpoint = boost::asio::ip::udp::endpoint;

    /// Largest datagram over IPv4, prefix included, in bytes.
    static constexpr std::size_t max_datagram_size = 65507;

    /// Called with each message: its bytes (valid during the call), its sender, and how it was framed.
    using message_handler =
        std::function<void(std::span<const std::byte> message, const endpoint& from, jaus::framing framing)>;

    /// Called with a line of text for everything that went wrong without a caller to tell: a closed port at a peer,
    /// a datagram that holds no message, a failed receive. The transport goes on receiving.
    using error_handler = std::function<void(std::string_view text)>;

    struct counters {
        std::uint64_t received{}; ///< messages given to the handler
        std::uint64_t sent{};     ///< messages the network took
        std::uint64_t refused{};  ///< messages that a peer's machine or a router sent back: closed port, no way
        std::uint64_t errors{};   ///< everything else that failed, either way
    };

    /// Opens and binds the socket; port 0 lets the system choose. Throws `open_error`.
    udp_transport(boost::asio::io_context& context, const endpoint& local)
        : socket_{context}, buffer_(max_datagram_size + 1) {
        detail::bind_udp(socket_, local);
        detail::want_icmp_errors(socket_, local.protocol());
    }

    udp_transport(const udp_transport&) = delete;
    udp_transport& operator=(const udp_transport&) = delete;

    /// Receives from now on, while the io_context runs. An exception from a handler leaves the io_context's `run` and
    /// ends receiving; `start` again to go on.
    void start(message_handler on_message, error_handler on_error) {
        on_message_ = std::move(on_message);
        on_error_ = std::move(on_error);
        receive();
    }

    /// Sends one message with the given framing. Fails for an empty message, one that does not fit a datagram, and
    /// when the network refuses at once; a closed port at the peer is told later, to the error handler.
    outcome send(std::span<const std::byte> message, const endpoint& to, jaus::framing framing = jaus::framing::bare) {
        const auto prefix = jaus::prefix(framing);
        if (message.empty()) return failure("an empty message is not sent");
        if (prefix.size() + message.size() > max_datagram_size)
            return failure("a message of " + std::to_string(message.size()) + " bytes does not fit a datagram of " +
                           std::to_string(max_datagram_size) + " bytes; send it in several packets");

        const std::array parts{boost::asio::const_buffer{prefix.data(), prefix.size()},
                               boost::asio::const_buffer{message.data(), message.size()}};
        boost::system::error_code error;
        socket_.send_to(parts, to, 0, error);
        // An earlier datagram's refusal, perhaps another peer's, is reported in place of sending: take it and repeat.
        if (error && take_refusals() > 0) socket_.send_to(parts, to, 0, error);
        if (error) return failure("cannot send to " + detail::text(to) + ": " + error.message());
        ++counters_.sent;
        return {};
    }

    /// Closes the socket; no handler is called afterwards.
    void stop() {
        boost::system::error_code ignored;
        socket_.close(ignored);
    }

    /// Where this transport receives.
    endpoint local() const { return socket_.local_endpoint(); }

    const counters& counts() const noexcept { return counters_; }

  private:
    void receive() {
        // The token outlives nothing: it tells a completion that was already queued that the transport is gone.
        const auto complete = [this, token = std::weak_ptr<char>{alive_}](boost::system::error_code error,
                                                                          std::size_t size) {
            if (token.expired() || !socket_.is_open()) return;
            if (error)
                receive_failed(error);
            else
                received(std::span<const std::byte>{buffer_}.first(size));
            if (socket_.is_open()) receive();
        };
        socket_.async_receive_from(boost::asio::buffer(buffer_), from_, complete);
    }

    void received(std::span<const std::byte> datagram) {
        const auto [framing, message] = jaus::remove_framing(datagram);
        if (datagram.size() > max_datagram_size)
            report("a datagram from " + detail::text(from_) + " is larger than " + std::to_string(max_datagram_size) +
                   " bytes and was dropped");
        else if (message.empty())
            report("a datagram from " + detail::text(from_) + " holds no message");
        else {
            ++counters_.received;
            on_message_(message, from_, framing);
        }
    }

    void receive_failed(boost::system::error_code error) {
        // A refusal that `send` took from the queue in the meantime has been reported there.
        if (take_refusals() == 0 && error != boost::asio::error::connection_refused)
            report("receiving failed: " + error.message());
    }

    std::size_t take_refusals() {
        return detail::take_icmp_errors(socket_, [this](const endpoint& sent_to, std::error_code error) {
            ++counters_.refused;
            if (on_error_)
                on_error_(detail::text(sent_to) + (error == std::errc::connection_refused
                                                       ? ": closed port: no program receives there"
                                                       : ": not delivered: " + error.message()));
        });
    }

    void report(const std::string& text) {
        ++counters_.errors;
        if (on_error_) on_error_(text);
    }

    outcome failure(std::string text) {
        ++counters_.errors;
        return outcome{std::move(text)};
    }

    boost::asio::ip::udp::socket socket_;
    std::vector<std::byte> buffer_; ///< one byte more than the largest datagram, so that a larger one shows
    endpoint from_{};
    message_handler on_message_{};
    error_handler on_error_{};
    counters counters_{};
    std::shared_ptr<char> alive_{std::make_shared<char>()};
};

} // namespace jauscat::net
