// Waiting for a frame with a precision below a millisecond: a short busy poll first, since an answer that is a few
// microseconds away costs less than being put to sleep and woken; then ppoll, which takes nanoseconds.
// Where the other end is a program that needs the same processor, the busy poll only holds it up.
#pragma once

#include <jauscat/schema/ethercat/frame.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <optional>
#include <poll.h>
#include <span>

namespace jauscat::net::detail {

/// Repeats `attempt` until it gives the size of a frame in `buffer`, which is then padded to 60 bytes, or until
/// `timeout` is over, then 0. `attempt` does not wait; it returns nothing when there is nothing to receive, and 0 when
/// the medium failed. A buffer below 60 bytes receives nothing.
template <class Attempt>
std::size_t receive_frame(int socket, std::span<std::byte> buffer, std::chrono::nanoseconds timeout,
                          std::chrono::nanoseconds busy_poll, Attempt attempt) {
    constexpr auto shortest = ethercat::min_frame_size;
    if (buffer.size() < shortest) return 0;
    using clock = std::chrono::steady_clock;
    const auto start = clock::now();
    const auto longest = std::chrono::nanoseconds{clock::time_point::max() - start};
    const auto deadline = start + std::min(timeout, longest);
    const auto sleep_from = start + std::min(timeout, busy_poll);
    for (;;) {
        if (const std::optional<std::size_t> size = attempt()) {
            if (*size == 0 || *size >= shortest) return *size;
            std::ranges::fill(buffer.first(shortest).subspan(*size), std::byte{});
            return shortest;
        }
        const auto now = clock::now();
        if (now >= deadline) return 0;
        if (now < sleep_from) continue;
        const std::chrono::nanoseconds left = deadline - now;
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(left);
        const timespec wait{.tv_sec = static_cast<std::time_t>(seconds.count()),
                            .tv_nsec = static_cast<long>((left - seconds).count())};
        pollfd readable{.fd = socket, .events = POLLIN, .revents = 0};
        ::ppoll(&readable, 1, &wait, nullptr); // whatever ends it, a signal included, the next attempt finds out
    }
}

} // namespace jauscat::net::detail
