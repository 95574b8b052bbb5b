// Waits for a frame at a socket with minimal latency.
#pragma once

#include <jauscat/net/now.hpp>
#include <jauscat/schema/ethercat/frame.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <optional>
#include <poll.h>
#include <span>
#include <sys/socket.h>

namespace jauscat::net::detail {

/// Makes a blocking receive at `socket` return after 10 ms without a frame; the kernel rounds up, to 20 ms at most.
inline void limit_blocking(int socket) noexcept {
    const timeval slice{.tv_sec = 0, .tv_usec = 10'000};
    ::setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &slice, sizeof slice);
}

/// The wait of one end of a link: it polls for some time, then sleeps.
///
/// Polling for a few microseconds is cheaper than sleeping and waking. If the sender is a process on the same
/// processor, the poll delays it; so after a poll without a result that was followed by a frame, the next 200 receives
/// sleep at once. docs/performance-notes.md has the measurements.
class frame_wait {
  public:
    explicit frame_wait(duration busy_poll) noexcept : busy_poll_{busy_poll} {}

    void busy_poll(duration time) noexcept {
        busy_poll_ = time;
        without_poll_ = 0;
    }

    /// Repeats `attempt(flags)`, a receive at `socket` that was prepared by `limit_blocking`. `attempt` returns the
    /// size of a frame in `buffer`, nothing if there was none, or 0 if the medium failed. Returns the size, padded to
    /// 60 bytes, or 0 after `timeout`. A buffer below 60 bytes receives nothing.
    template <class Attempt>
    std::size_t receive(int socket, std::span<std::byte> buffer, duration timeout, Attempt attempt) {
        constexpr auto shortest = ethercat::min_frame_size;
        if (buffer.size() < shortest) return 0;
        auto at = now();
        const deadline end{at, std::max(timeout, duration{})};
        const auto poll_end = without_poll_ == 0 ? at + std::min(timeout, busy_poll_) : at;
        if (without_poll_ != 0) --without_poll_;
        const bool polls = at < poll_end;
        for (;;) {
            const bool sleeps = at >= poll_end;
            // A blocking receive needs one system call, ppoll and receive need two; but only ppoll is exact.
            const bool blocks = sleeps && end.remaining(at) > longest_block;
            if (sleeps && !blocks && !end.is_reached(at)) sleep(socket, end.remaining(at));
            if (const std::optional<std::size_t> size = attempt(blocks ? 0 : MSG_DONTWAIT)) {
                if (polls && sleeps) without_poll_ = receives_without_poll;
                if (*size == 0 || *size >= shortest) return *size;
                std::ranges::fill(buffer.first(shortest).subspan(*size), std::byte{});
                return shortest;
            }
            at = now();
            if (end.is_reached(at)) return 0;
        }
    }

  private:
    static constexpr std::chrono::milliseconds longest_block{18}; // below the master's 20 ms
    static constexpr unsigned receives_without_poll = 200;

    static void sleep(int socket, duration time) noexcept {
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time);
        const timespec wait{.tv_sec = static_cast<std::time_t>(seconds.count()),
                            .tv_nsec = static_cast<long>((time - seconds).count())};
        pollfd readable{.fd = socket, .events = POLLIN, .revents = 0};
        ::ppoll(&readable, 1, &wait, nullptr); // the next attempt finds the reason why it ended
    }

    duration busy_poll_;
    unsigned without_poll_{};
};

} // namespace jauscat::net::detail
