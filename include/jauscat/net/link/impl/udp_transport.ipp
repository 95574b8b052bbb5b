// The functions of udp_transport.
#pragma once
#include <jauscat/net/detail/mapped_address.hpp>
#include <jauscat/net/link/detail/bind_udp.hpp>
#include <jauscat/net/link/detail/icmp_errors.hpp>
#include <jauscat/net/link/detail/send_parts.hpp>
#include <jauscat/net/link/udp_transport.hpp>

#include <cerrno>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

JAUSCAT_DECL udp_transport::udp_transport(boost::asio::io_context& context, const endpoint& local,
                                          const udp_options& options)
    : socket_{context}, v6_{local.protocol() == boost::asio::ip::udp::v6()} {
    detail::bind_udp(socket_, local, options);
    detail::want_icmp_errors(socket_, local.protocol());
    detail::want_drop_count(socket_);
    detail::want_arrival_time(socket_);
}

JAUSCAT_DECL void udp_transport::start(message_handler on_message, error_handler on_error) {
    on_message_ = std::move(on_message);
    on_error_ = std::move(on_error);
    receive();
}

JAUSCAT_DECL result<void, error> udp_transport::send(std::span<const std::byte> message, const endpoint& to,
                                                     jaus::framing framing) {
    const jaus::message_prefix first{framing, message.size()};
    const auto prefix = first.bytes();
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

JAUSCAT_DECL void udp_transport::post(std::span<const std::byte> message, const endpoint& to, jaus::framing framing) {
    const jaus::message_prefix first{framing, message.size()};
    const auto prefix = first.bytes();
    if (!handing_on_ || message.empty() || prefix.size() + message.size() > max_posted_size) {
        if (const auto done = send(message, to, framing); !done) tell(done.error().message);
        return;
    }
    if (out_.full()) flush();
    out_.push(prefix, message, detail::for_socket(to, v6_));
}

JAUSCAT_DECL void udp_transport::stop() {
    flush();
    boost::system::error_code ignored;
    socket_.close(ignored);
}

JAUSCAT_DECL void udp_transport::receive() {
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

JAUSCAT_DECL void udp_transport::receive_batches() {
    for (int batches = 0; socket_.is_open() && batches != max_batches; ++batches) {
        const int error = batch_.empty() ? batch_.receive(socket_.native_handle()) : 0;
        if (error == EAGAIN && batches != 0) return; // an error would have been reported before
        if (error != 0) return receive_failed(error);
        hand_on_batch();
    }
}

JAUSCAT_DECL void udp_transport::hand_on_batch() {
    handing_on_ = true;
    try {
        while (socket_.is_open() && !batch_.empty()) received();
    } catch (...) {
        end_batch();
        throw;
    }
    end_batch();
}

JAUSCAT_DECL void udp_transport::end_batch() {
    handing_on_ = false;
    flush();
}

JAUSCAT_DECL void udp_transport::flush() {
    while (!out_.empty()) {
        int failed = out_.send(socket_.native_handle(), counters_.sent);
        if (failed != 0 && take_refusals() > 0) failed = out_.send(socket_.native_handle(), counters_.sent);
        if (failed == 0) return;
        const auto to = detail::unmapped(out_.front());
        out_.pop();
        tell(not_sent(to, failed).message);
    }
}

JAUSCAT_DECL error udp_transport::not_sent(const endpoint& to, int failed) {
    const std::error_code reason{failed, std::generic_category()};
    auto problem = "cannot send to " + detail::text(to) + ": " + reason.message();
    if (!detail::is_back_pressure(failed))
        return failure({.code = errc::not_sent, .reason = reason, .message = std::move(problem)});
    ++counters_.would_block;
    problem += "; the network takes less than is sent: send more slowly, or set send_buffer";
    return {.code = errc::back_pressure, .reason = reason, .message = std::move(problem)};
}

JAUSCAT_DECL void udp_transport::received() {
    auto part = jaus::remove_framing(batch_.bytes());
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
        return;
    }
    hand_on(part, from);
    while (!part.rest.empty() && socket_.is_open()) {
        part = jaus::next_message(part);
        if (part.message.empty())
            return report("a datagram from " + detail::text(from) + ": its last " + std::to_string(part.rest.size()) +
                          " bytes are no message of AS5669-2007 (judp1)");
        hand_on(part, from);
    }
}

JAUSCAT_DECL void udp_transport::hand_on(const jaus::framed_message& part, const endpoint& from) {
    if (const auto decision = filter_ ? filter_(part.message, from, part.how) : verdict::accepted;
        decision != verdict::accepted)
        counters_.count(decision);
    else if (part.message.empty())
        report("a datagram from " + detail::text(from) + " holds no message");
    else {
        ++counters_.received;
        if (!unreachable_.empty()) unreachable_.erase(from);
        on_message_(part.message, from, part.how);
    }
}

JAUSCAT_DECL void udp_transport::receive_failed(int error) {
    // An error that `send` has removed from the queue meanwhile was reported there.
    if (take_refusals() == 0 && error != ECONNREFUSED && error != EAGAIN && error != EINTR)
        report("receiving failed: " + std::generic_category().message(error));
}

JAUSCAT_DECL void udp_transport::count_drops(std::uint32_t dropped) noexcept {
    if (dropped == 0) return; // the kernel reports only numbers above 0
    counters_.dropped += dropped - std::exchange(dropped_, dropped);
}

JAUSCAT_DECL std::size_t udp_transport::take_refusals() {
    return detail::take_icmp_errors(socket_, [this](const endpoint& sent_to, std::error_code error) {
        ++counters_.refused;
        const auto to = detail::unmapped(sent_to);
        if (is_news(to, error))
            tell(detail::text(to) + (error == std::errc::connection_refused ? ": closed port: no program receives there"
                                                                            : ": not delivered: " + error.message()));
    });
}

JAUSCAT_DECL bool udp_transport::is_news(const endpoint& peer, std::error_code error) {
    constexpr std::size_t most = 256;
    if (unreachable_.size() == most && !unreachable_.contains(peer)) return true;
    return std::exchange(unreachable_[peer], error) != error;
}

JAUSCAT_DECL void udp_transport::tell(const std::string& text) {
    if (on_error_) on_error_(text);
}

JAUSCAT_DECL void udp_transport::report(const std::string& text) {
    ++counters_.errors;
    tell(text);
}

JAUSCAT_DECL error udp_transport::failure(error what) {
    ++counters_.errors;
    return what;
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::net
