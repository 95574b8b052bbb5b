// Sends several datagrams with one system call (Linux sendmmsg), from reused memory.
#pragma once

#include <boost/asio/ip/udp.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <memory>
#include <span>
#include <sys/socket.h>
#include <sys/uio.h>

namespace jauscat::net::detail {

/// Up to `capacity` queued datagrams of at most `MaxSize` bytes each.
template <std::size_t MaxSize> class send_batch {
  public:
    using endpoint = boost::asio::ip::udp::endpoint;
    static constexpr std::size_t capacity = 32;

    send_batch() {
        for (std::size_t i = 0; i != capacity; ++i) {
            parts_[i].iov_base = memory_.get() + i * MaxSize;
            messages_[i].msg_hdr.msg_iov = &parts_[i];
            messages_[i].msg_hdr.msg_iovlen = 1;
        }
    }
    send_batch(const send_batch&) = delete;
    send_batch& operator=(const send_batch&) = delete;

    [[nodiscard]] bool empty() const noexcept { return next_ == count_; }
    [[nodiscard]] bool full() const noexcept { return count_ == capacity; }

    /// Copies a datagram of two parts. The batch must not be full, nor the datagram too large.
    void push(std::span<const std::byte> first, std::span<const std::byte> second, const endpoint& to) noexcept {
        auto* const out = memory_.get() + count_ * MaxSize;
        std::ranges::copy(second, std::ranges::copy(first, out).out);
        parts_[count_].iov_len = first.size() + second.size();
        targets_[count_] = to;
        auto& head = messages_[count_].msg_hdr;
        head.msg_name = targets_[count_].data();
        head.msg_namelen = static_cast<socklen_t>(to.size());
        ++count_;
    }

    /// Sends as many as the network accepts, without waiting. Returns 0 if all were sent, or errno of the first that
    /// was refused, which is then the front. `sent` counts.
    template <class Count> int send(int socket, Count& sent) noexcept {
        while (!empty()) {
            const auto left = static_cast<unsigned>(count_ - next_);
            const int taken = ::sendmmsg(socket, &messages_[next_], left, MSG_DONTWAIT | MSG_NOSIGNAL);
            if (taken < 0) return errno;
            next_ += static_cast<std::size_t>(taken);
            sent += static_cast<Count>(taken);
        }
        next_ = count_ = 0;
        return 0;
    }

    /// Destination of the first remaining datagram.
    [[nodiscard]] const endpoint& front() const noexcept { return targets_[next_]; }

    /// Removes it.
    void pop() noexcept {
        if (++next_ == count_) next_ = count_ = 0;
    }

  private:
    std::unique_ptr<std::byte[]> memory_ = std::make_unique_for_overwrite<std::byte[]>(capacity * MaxSize);
    std::array<endpoint, capacity> targets_{};
    std::array<iovec, capacity> parts_{};
    std::array<mmsghdr, capacity> messages_{};
    std::size_t next_{}, count_{};
};

} // namespace jauscat::net::detail
