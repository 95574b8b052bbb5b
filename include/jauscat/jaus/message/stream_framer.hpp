// Finds JAUS messages in a stream of bytes that has no marks between them, such as a serial line. A message's length
// comes from its header; after noise the place is found again by an impossible header or by the line falling idle.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/message/message.hpp>

#include <algorithm>
#include <array>
#include <span>

namespace jauscat::jaus {

/// Whether these can be the first bytes of a message with a body of at most `max_body` bytes: version 2, no reserved
/// bit, a defined data flag, and a source that names one component. RA 3.3 part 2, message header.
[[nodiscard]] constexpr bool possible_header(const header& head, std::size_t max_body) noexcept {
    const auto flag = static_cast<unsigned>(head.data_flag); // a single packet has none of the four bits, others one
    return head.version == 2 && head.reserved == 0 && head.data_size <= max_body && (flag & (flag - 1)) == 0 &&
           names_one_component(head.source);
}

/// Processes bytes as they arrive and delivers complete messages. A header that announces more than the buffer holds
/// counts as noise.
///
///     std::array<std::byte, jaus::header_size + 256> buffer{};
///     jaus::stream_framer framer{buffer, 20ms};
///     framer.on_bytes(received, now, [&](std::span<const std::byte> message) { ... });
///     framer.on_time(now, the same); // every few milliseconds, also when nothing is received
class stream_framer {
  public:
    /// `buffer` holds one message and must outlive the framer. `idle` is the silence after which an incomplete message
    /// is dropped: senders must not pause that long inside a message.
    template <std::size_t Size>
    requires(Size >= header_size)
    constexpr stream_framer(std::array<std::byte, Size>& buffer, duration idle) noexcept
        : buffer_{buffer}, idle_{idle} {}

    /// Bytes that arrived at `now`. Calls `take(std::span<const std::byte>)` for each whole message, header first; the
    /// bytes are valid during the call.
    constexpr void on_bytes(std::span<const std::byte> bytes, time_point now, auto&& take) {
        on_time(now, take);
        if (!bytes.empty()) heard_ = now;
        while (!bytes.empty()) {
            const std::size_t count = std::min(bytes.size(), buffer_.size() - size_);
            std::copy_n(bytes.data(), count, buffer_.data() + size_);
            size_ += count;
            bytes = bytes.subspan(count);
            if (size_ >= wanted_) search(false, take);
        }
    }

    /// Drops an incomplete message once the line has been silent for the idle time. Its header was noise, so messages
    /// inside its bytes are found and passed to `take`.
    constexpr void on_time(time_point now, auto&& take) {
        if (size_ != 0 && now - heard_ >= idle_) search(true, take);
    }

  private:
    // Delivers complete messages and drops noise; at the end also an incomplete message. A possible header announces a
    // message that fits the buffer, so there is always space for the next byte.
    constexpr void search(bool no_more, auto& take) {
        std::size_t at = 0;
        wanted_ = header_size;
        while (size_ - at >= header_size) {
            const auto bytes = std::span<const std::byte>{buffer_}.subspan(at, size_ - at);
            header head{};
            static_cast<void>(wire::decode_prefix(head, bytes));
            const std::size_t total = header_size + head.data_size;
            const bool possible = possible_header(head, buffer_.size() - header_size);
            if (possible && bytes.size() >= total) {
                take(bytes.first(total));
                at += total;
            } else if (possible && !no_more) {
                wanted_ = total;
                break;
            } else {
                ++at;
            }
        }
        if (no_more) at = size_;
        std::copy(buffer_.data() + at, buffer_.data() + size_, buffer_.data());
        size_ -= at;
    }

    std::span<std::byte> buffer_;
    duration idle_;
    time_point heard_{};
    std::size_t size_{};              // bytes that wait
    std::size_t wanted_{header_size}; // bytes that must wait before there is something to decide
};

} // namespace jauscat::jaus
