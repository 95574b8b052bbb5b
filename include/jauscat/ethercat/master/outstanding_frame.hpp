// The frame that awaits its reply, and the check whether a received frame is that reply.
#pragma once

#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/ethercat/master/activity.hpp>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// At most one frame of up to `Capacity` datagrams that is under way; and what was last sent under each index.
template <std::size_t Capacity> class outstanding_frame {
  public:
    static constexpr std::size_t capacity = Capacity;

    /// Whether a reply is awaited.
    [[nodiscard]] bool waits() const noexcept { return waits_; }
    /// When the frame was sent.
    [[nodiscard]] time_point sent_at() const noexcept { return sent_at_; }
    /// Cancels the frame; a late reply is ignored.
    void forget() noexcept {
        if (!waits_) return;
        waits_ = false;
        missing_sent_at_ = sent_at_;
        ++missing_;
    }

    /// `frame` is on its way. It is one this project built.
    void sent(std::span<const std::byte> frame, time_point now) noexcept {
        frame_view view;
        static_cast<void>(view.parse(frame));
        count_ = 0;
        for (const auto datagram : view)
            if (count_ != capacity) sent_[count_++] = datagram.header;
        if (count_ != 0) marks_[sent_.front().index] = mark_of(sent_.front());
        waits_ = count_ != 0;
        sent_at_ = now;
        if (now - missing_sent_at_ > longest_delay) missing_ = 0;
    }

    /// Whether `frame` may be one of the last that were sent here: a late or a second reply.
    [[nodiscard]] bool may_be_own(const frame_view& frame) const noexcept {
        const auto first = frame.begin();
        return first != frame.end() && marks_[(*first).header.index] == mark_of((*first).header);
    }
    /// Whether `frame`, which was not waited for, was sent here. If not, another master uses this wire. Of older frames
    /// is only known how many have not come back: a slave that was suspended may send hundreds of them at once.
    bool claim(const frame_view& frame) noexcept {
        const bool is_own = missing_ != 0 || may_be_own(frame);
        if (missing_ != 0) --missing_;
        return is_own;
    }

    /// The datagrams of `frame` if it is a reply to what was sent last, else none. A slave changes data, counters,
    /// event bits and, except with station addresses, ADP; all else has to be as it was sent. The datagrams are views
    /// of `frame` and are kept here until the next call.
    replies match(const frame_view& frame) noexcept {
        std::size_t matched = 0;
        for (const auto datagram : frame) {
            if (matched == count_ || !answers(sent_[matched], datagram.header)) return {};
            replies_[matched++] = datagram;
        }
        if (matched == 0 || matched != count_) return {};
        waits_ = false;
        return replies{replies_}.first(matched);
    }

  private:
    static bool answers(const datagram_header& sent, const datagram_header& back) noexcept {
        const bool station = sent.cmd == command::fprd || sent.cmd == command::fpwr || sent.cmd == command::fprw;
        return back.cmd == sent.cmd && back.index == sent.index && back.ado == sent.ado && back.length == sent.length &&
               (!station || back.adp == sent.adp);
    }

    static std::uint32_t mark_of(const datagram_header& sent) noexcept {
        return std::uint32_t{sent.ado} << 16 | std::uint32_t{sent.length} << 5 | static_cast<std::uint32_t>(sent.cmd);
    }

    static constexpr std::chrono::nanoseconds longest_delay = std::chrono::seconds{10};

    std::array<std::uint32_t, 256> marks_{}; // 0, a command that does nothing, where an index was not used
    std::array<datagram_header, capacity> sent_{};
    std::array<datagram_view, capacity> replies_{};
    std::size_t count_{}; // of the datagrams that were sent last
    bool waits_{};
    time_point sent_at_{};
    std::uint64_t missing_{};      // frames that have not come back
    time_point missing_sent_at_{}; // the last of these
};

} // namespace jauscat::ethercat
