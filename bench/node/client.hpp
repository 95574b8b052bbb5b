// The asking side of node_bench, component 1.1.32.1: keeps a number of requests on their way and times each answer.
#pragma once

#include <jauscat/jaus/message/message.hpp>
#include <jauscat/net/link/latency_histogram.hpp>
#include <jauscat/schema/jaus/core.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <netinet/in.h>
#include <optional>
#include <span>
#include <stdexcept>
#include <sys/socket.h>
#include <sys/time.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace node_bench {

namespace jaus = jauscat::jaus;
using clock = std::chrono::steady_clock;
using std::chrono::nanoseconds;

inline sockaddr_in loopback(std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
}

/// A UDP socket on the loopback interface whose receives end after 20 ms without anything.
inline int open_socket() {
    const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    const auto any = loopback(0);
    const timeval slice{.tv_sec = 0, .tv_usec = 20'000};
    if (socket < 0 || ::bind(socket, reinterpret_cast<const sockaddr*>(&any), sizeof any) != 0 ||
        ::setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &slice, sizeof slice) != 0)
        throw std::runtime_error{"no UDP socket on the loopback interface"};
    return socket;
}

inline std::uint16_t port_of(int socket) {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.sin_port);
}

struct load_result {
    std::uint64_t answered{};
    std::uint64_t lost{};
    nanoseconds time{};
    jauscat::net::latency_histogram latency{};

    double per_second() const { return static_cast<double>(answered) / std::chrono::duration<double>(time).count(); }
};

/// Sends Query Component Status, many at a time in one system call, so that it costs less than what it measures.
class client {
  public:
    client() {
        for (std::size_t i = 0; i != most; ++i) {
            parts_[i] = {.iov_base = out_[i].data(), .iov_len = jaus::header_size};
            answers_[i] = {.iov_base = in_[i].data(), .iov_len = in_[i].size()};
            sends_[i].msg_hdr.msg_iov = &parts_[i];
            receives_[i].msg_hdr.msg_iov = &answers_[i];
            sends_[i].msg_hdr.msg_iovlen = receives_[i].msg_hdr.msg_iovlen = 1;
        }
    }
    client(const client&) = delete;
    client& operator=(const client&) = delete;
    ~client() { ::close(socket_); }

    std::uint16_t port() const { return port_of(socket_); }

    /// Who is asked.
    jaus::address to{1, 33, 1, 2};

    /// Keeps `window` requests, at most 64, on their way to `port` for `time`.
    load_result run(std::uint16_t port, std::size_t window, nanoseconds time) {
        const auto target = loopback(port);
        if (::connect(socket_, reinterpret_cast<const sockaddr*>(&target), sizeof target) != 0)
            throw std::runtime_error{"cannot connect on the loopback interface"};
        load_result result;
        const auto start = clock::now();
        send(window);
        for (auto now = start; now - start < time;) {
            const int got =
                ::recvmmsg(socket_, receives_.data(), static_cast<unsigned>(window), MSG_WAITFORONE, nullptr);
            now = clock::now();
            if (got <= 0) { // all that were on their way are gone
                result.lost += on_way_;
                forget();
                send(window);
                continue;
            }
            std::size_t answers = 0;
            for (int i = 0; i != got; ++i) {
                const auto sent = answered(i);
                if (!sent) continue;
                result.latency.add(now - *sent);
                ++answers;
            }
            result.answered += answers;
            if (answers != 0) send(answers);
        }
        result.time = clock::now() - start;
        while (::recvmmsg(socket_, receives_.data(), most, MSG_WAITFORONE, nullptr) > 0) {}
        forget();
        return result;
    }

    /// Sends `per_ms` requests each millisecond for `time`, whatever is answered.
    load_result run_paced(std::uint16_t port, std::size_t per_ms, nanoseconds time) {
        const auto target = loopback(port);
        if (::connect(socket_, reinterpret_cast<const sockaddr*>(&target), sizeof target) != 0)
            throw std::runtime_error{"cannot connect on the loopback interface"};
        load_result result;
        const auto take = [&](int flags) {
            const int got = ::recvmmsg(socket_, receives_.data(), most, flags, nullptr);
            for (int i = 0; i < got; ++i)
                if (const auto sent = answered(i)) {
                    result.latency.add(clock::now() - *sent);
                    ++result.answered;
                }
            return got > 0;
        };
        const auto start = clock::now();
        for (auto due = start; due - start < time; due += std::chrono::milliseconds{1}) {
            std::this_thread::sleep_until(due);
            send(per_ms);
            while (take(MSG_DONTWAIT)) {}
        }
        result.time = clock::now() - start;
        while (take(MSG_WAITFORONE)) {}
        result.lost = on_way_;
        forget();
        return result;
    }

  private:
    static constexpr std::size_t most = 64;
    using packet = std::array<std::byte, 64>;

    /// When the request was sent that the `i`th received message answers; nothing for any other message, such as a
    /// heartbeat, and for the answer to a request that counts as lost.
    std::optional<clock::time_point> answered(int i) {
        jaus::header head;
        const auto at = static_cast<std::size_t>(i);
        const auto received = std::span{in_[at]}.first(std::min<std::size_t>(receives_[at].msg_len, in_[at].size()));
        if (!jauscat::wire::decode_prefix(head, received) ||
            (head.command_code != jaus::command_code_of<jaus::report_component_status> &&
             head.command_code != jaus::command_code_of<jaus::query_component_status>)) // an echo
            return {};
        const auto sent = std::exchange(sent_[head.sequence_number], clock::time_point{});
        if (sent == clock::time_point{}) return {};
        --on_way_;
        return sent;
    }
    void forget() {
        std::ranges::fill(sent_, clock::time_point{});
        on_way_ = 0;
    }

    void send(std::size_t count) {
        for (std::size_t i = 0; i != count; ++i) {
            const jaus::header head{.destination = to, .source = {1, 32, 1, 1}, .sequence_number = ++sequence_};
            if (!jaus::make_message(head, jaus::query_component_status{}, out_[i]))
                throw std::runtime_error{"no message"};
            sent_[sequence_] = clock::now();
        }
        on_way_ += count;
        for (std::size_t done = 0; done < count;) {
            const int taken = ::sendmmsg(socket_, &sends_[done], static_cast<unsigned>(count - done), 0);
            if (taken > 0) done += static_cast<std::size_t>(taken);
        }
    }

    int socket_{open_socket()};
    std::uint16_t sequence_{};
    std::size_t on_way_{};
    std::vector<clock::time_point> sent_ = std::vector<clock::time_point>(65536); ///< by sequence number; 0: answered
    std::array<packet, most> out_{}, in_{};
    std::array<iovec, most> parts_{}, answers_{};
    std::array<mmsghdr, most> sends_{}, receives_{};
};

} // namespace node_bench
