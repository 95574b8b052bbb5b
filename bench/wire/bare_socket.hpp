// A packet socket by hand, with every option that could make it faster: the floor for what a link can reach, and the
// comparison of the options.
#pragma once

#include "report.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <linux/filter.h>
#include <linux/if_packet.h>
#include <net/if.h>
#include <poll.h>
#include <span>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace wire_bench {

struct socket_options {
    std::string name{};
    nanoseconds busy_poll{}; ///< looks at the socket for that long before it sleeps
    bool qdisc_bypass{};
    bool filter{};
    int so_busy_poll{}; ///< microseconds
};

class bare_socket {
  public:
    bare_socket(const std::string& interface, const socket_options& options) : options_{options} {
        const int on = 1;
        if (options.qdisc_bypass) set(SOL_PACKET, PACKET_QDISC_BYPASS, on);
        if (options.so_busy_poll != 0) set(SOL_SOCKET, SO_BUSY_POLL, options.so_busy_poll);
        if (options.filter) {
            std::array program{
                sock_filter{BPF_LD | BPF_H | BPF_ABS, 0, 0, 12}, sock_filter{BPF_JMP | BPF_JEQ | BPF_K, 0, 3, 0x88A4},
                sock_filter{BPF_LD | BPF_B | BPF_ABS, 0, 0, 15}, sock_filter{BPF_ALU | BPF_RSH | BPF_K, 0, 0, 4},
                sock_filter{BPF_JMP | BPF_JEQ | BPF_K, 1, 0, 1}, sock_filter{BPF_RET | BPF_K, 0, 0, 0},
                sock_filter{BPF_RET | BPF_K, 0, 0, 0xFFFF}};
            set(SOL_SOCKET, SO_ATTACH_FILTER, sock_fprog{.len = program.size(), .filter = program.data()});
        }
        set(SOL_SOCKET, SO_RCVTIMEO, timeval{.tv_sec = 0, .tv_usec = 20'000});
        sockaddr_ll address{};
        address.sll_family = AF_PACKET;
        address.sll_protocol = htons(0x88A4);
        address.sll_ifindex = static_cast<int>(::if_nametoindex(interface.c_str()));
        if (::bind(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) fail("bind");
    }
    ~bare_socket() { ::close(socket_); }
    bare_socket(const bare_socket&) = delete;
    bare_socket& operator=(const bare_socket&) = delete;

    void send(std::span<const std::byte> frame) const { ::send(socket_, frame.data(), frame.size(), 0); }

    /// The size of a frame that has arrived; 0 where there is none.
    std::size_t receive_waiting(std::span<std::byte> buffer) const {
        return static_cast<std::size_t>(
            std::max(::recv(socket_, buffer.data(), buffer.size(), MSG_DONTWAIT), ssize_t{0}));
    }
    /// The size of the frame; 0 after 20 ms without one.
    std::size_t receive(std::span<std::byte> buffer) const {
        using clock = std::chrono::steady_clock;
        if (options_.busy_poll != nanoseconds{}) {
            const auto end = clock::now() + options_.busy_poll;
            do {
                const auto size = ::recv(socket_, buffer.data(), buffer.size(), MSG_DONTWAIT);
                if (size > 0) return static_cast<std::size_t>(size);
            } while (clock::now() < end);
        }
        return static_cast<std::size_t>(std::max(::recv(socket_, buffer.data(), buffer.size(), 0), ssize_t{0}));
    }

  private:
    template <class Value> void set(int level, int option, const Value& value) const {
        if (::setsockopt(socket_, level, option, &value, sizeof value) != 0) fail("setsockopt");
    }
    [[noreturn]] static void fail(const char* what) {
        std::perror(what);
        std::exit(1);
    }

    socket_options options_;
    int socket_{::socket(AF_PACKET, SOCK_RAW, 0)};
};

/// Sends every frame of an interface back as it is.
class bare_echo {
  public:
    bare_echo(const std::string& interface, const socket_options& options, int processor)
        : socket_{interface, options}, thread_{[this, processor] {
              pin(processor);
              std::array<std::byte, 1600> frame{};
              while (!stop_)
                  if (const auto size = socket_.receive(frame); size != 0) socket_.send(std::span{frame}.first(size));
          }} {}
    ~bare_echo() {
        stop_ = true;
        thread_.join();
    }
    bare_echo(const bare_echo&) = delete;
    bare_echo& operator=(const bare_echo&) = delete;

  private:
    bare_socket socket_;
    std::atomic<bool> stop_{};
    std::thread thread_;
};

/// A frame of 60 bytes that says it holds one datagram.
inline std::array<std::byte, 60> bare_frame() {
    std::array<std::byte, 60> frame{};
    std::fill_n(frame.begin(), 6, std::byte{0xFF});
    frame[12] = std::byte{0x88}, frame[13] = std::byte{0xA4}, frame[14] = std::byte{14}, frame[15] = std::byte{0x10};
    return frame;
}

inline void measure_echo(row& into, unsigned count, const socket_options& options, int processor) {
    bare_echo echo{"jc1", options, processor};
    const bare_socket socket{"jc0", options};
    const auto frame = bare_frame();
    std::array<std::byte, 1600> back{};
    measure(into, count, [&] {
        socket.send(frame);
        while (socket.receive(back) == 0) socket.send(frame); // lost while the other end was being opened
    });
}

/// The options next to each other, in rounds, so that what else the machine does meets all of them alike.
inline void compare_options(unsigned count, int processor) {
    using std::chrono::microseconds;
    std::vector<socket_options> all;
    for (const int poll : {0, 5, 20, 50, 200})
        all.push_back({.name = "busy poll " + std::to_string(poll) + " us", .busy_poll = microseconds{poll}});
    for (const int poll : {0, 20}) {
        const auto name = [&](const char* option) {
            return option + std::string{", busy poll "} + std::to_string(poll) + " us";
        };
        all.push_back({.name = name("filter"), .busy_poll = microseconds{poll}, .filter = true});
        all.push_back({.name = name("PACKET_QDISC_BYPASS"), .busy_poll = microseconds{poll}, .qdisc_bypass = true});
        all.push_back({.name = name("SO_BUSY_POLL 50"), .busy_poll = microseconds{poll}, .so_busy_poll = 50});
    }
    constexpr unsigned rounds = 9;
    std::deque<row> rows(all.size());
    for (unsigned round = 0; round != rounds; ++round)
        for (std::size_t i = 0; i != all.size(); ++i) {
            rows[i].name = all[i].name;
            measure_echo(rows[i], count / rounds, all[i], processor);
        }
    print_head();
    for (const auto& each : rows) print(each);
}

} // namespace wire_bench
