// Receives several datagrams from a UDP socket with one system call (Linux recvmmsg), into reused memory.
#pragma once

#include <boost/asio/ip/udp.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <sys/socket.h>
#include <sys/uio.h>
#include <time.h>

namespace jauscat::net::detail {

/// Up to `capacity` datagrams of at most `MaxSize` bytes each.
///
/// The memory is reserved once. Only the pages that datagrams need are touched: with messages of up to one page, one
/// page for each datagram of the largest batch so far.
template <std::size_t MaxSize> class receive_batch {
  public:
    using endpoint = boost::asio::ip::udp::endpoint;

    /// This many datagrams share the two system calls of a wake-up.
    static constexpr std::size_t capacity = 32;

    receive_batch() {
        for (std::size_t i = 0; i != capacity; ++i) {
            parts_[i] = {.iov_base = memory_.get() + i * stride, .iov_len = MaxSize};
            auto& head = messages_[i].msg_hdr;
            head.msg_iov = &parts_[i];
            head.msg_iovlen = 1;
            head.msg_name = senders_[i].data();
            head.msg_control = control_[i].bytes.data();
        }
        renew(capacity);
    }
    receive_batch(const receive_batch&) = delete;
    receive_batch& operator=(const receive_batch&) = delete;

    /// Receives what is queued at `socket`, without waiting. Returns errno; 0 if there was at least one.
    int receive(int socket) noexcept {
        renew(count_);
        next_ = count_ = 0;
        const int count = ::recvmmsg(socket, messages_.data(), capacity, MSG_DONTWAIT, nullptr);
        if (count < 0) return errno;
        count_ = static_cast<std::size_t>(count);
        taken_at_ = time_of_day();
        return 0;
    }

    [[nodiscard]] bool empty() const noexcept { return next_ == count_; }

    /// Removes the first remaining datagram.
    void pop() noexcept { ++next_; }

    /// The first remaining datagram.
    [[nodiscard]] std::span<const std::byte> bytes() const noexcept {
        return {memory_.get() + next_ * stride, messages_[next_].msg_len};
    }
    [[nodiscard]] const endpoint& from() {
        senders_[next_].resize(messages_[next_].msg_hdr.msg_namelen);
        return senders_[next_];
    }
    /// It was larger than `MaxSize`; the rest is lost.
    [[nodiscard]] bool truncated() const noexcept { return (messages_[next_].msg_hdr.msg_flags & MSG_TRUNC) != 0; }

    /// Number of datagrams that the kernel had dropped at this socket, modulo 2^32, when it received this one. See
    /// `want_drop_count`.
    [[nodiscard]] std::uint32_t dropped_before() noexcept {
        return told_by_kernel<std::uint32_t>(SO_RXQ_OVFL).value_or(0);
    }
    /// Its time in the socket when the batch was received; 0 if the kernel does not report it. See
    /// `want_arrival_time`.
    [[nodiscard]] std::chrono::nanoseconds waited() noexcept {
        const auto arrived = told_by_kernel<timespec>(SCM_TIMESTAMPNS);
        if (!arrived) return {};
        return std::max(taken_at_ - in_nanoseconds(*arrived), std::chrono::nanoseconds{}); // the clock may be set back
    }

  private:
    /// A control message of the first remaining datagram.
    template <class T> [[nodiscard]] std::optional<T> told_by_kernel(int type) noexcept {
        auto& head = messages_[next_].msg_hdr;
        for (auto* part = CMSG_FIRSTHDR(&head); part != nullptr; part = CMSG_NXTHDR(&head, part)) {
            if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != type) continue;
            T value{};
            std::memcpy(&value, CMSG_DATA(part), sizeof value);
            return value;
        }
        return std::nullopt;
    }
    [[nodiscard]] static std::chrono::nanoseconds in_nanoseconds(const timespec& t) noexcept {
        return std::chrono::seconds{t.tv_sec} + std::chrono::nanoseconds{t.tv_nsec};
    }
    /// The clock of the kernel's arrival times.
    [[nodiscard]] static std::chrono::nanoseconds time_of_day() noexcept {
        timespec now{};
        ::clock_gettime(CLOCK_REALTIME, &now);
        return in_nanoseconds(now);
    }
    /// Restores the sizes of the first `count`, which the kernel has overwritten.
    void renew(std::size_t count) noexcept {
        for (std::size_t i = 0; i != count; ++i) {
            messages_[i].msg_hdr.msg_namelen = static_cast<socklen_t>(senders_[i].capacity());
            messages_[i].msg_hdr.msg_controllen = control_[i].bytes.size();
        }
    }

    /// Not a multiple of a page: otherwise the first bytes of all would compete for the same lines of the cache.
    static constexpr std::size_t stride = (MaxSize / 64 + 2) * 64;

    struct control {
        alignas(cmsghdr) std::array<std::byte, CMSG_SPACE(sizeof(std::uint32_t)) + CMSG_SPACE(sizeof(timespec))> bytes;
    };

    std::unique_ptr<std::byte[]> memory_ = std::make_unique_for_overwrite<std::byte[]>(capacity * stride);
    std::array<endpoint, capacity> senders_{};
    std::array<control, capacity> control_{};
    std::array<iovec, capacity> parts_{};
    std::array<mmsghdr, capacity> messages_{};
    std::size_t next_{}, count_{};
    std::chrono::nanoseconds taken_at_{};
};

/// Makes the kernel report with each datagram the number of those dropped because the socket's buffer was full.
inline void want_drop_count(boost::asio::ip::udp::socket& socket) noexcept {
    const int on = 1;
    ::setsockopt(socket.native_handle(), SOL_SOCKET, SO_RXQ_OVFL, &on, sizeof on);
}

/// Makes the kernel report the arrival time of each datagram.
inline void want_arrival_time(boost::asio::ip::udp::socket& socket) noexcept {
    const int on = 1;
    ::setsockopt(socket.native_handle(), SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on);
}

} // namespace jauscat::net::detail
