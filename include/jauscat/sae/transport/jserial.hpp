// JSerial: messages of AS5669A on a serial line, between markers, with two checksums.
#pragma once
#include <jauscat/sae/transport/judp.hpp>

#include <algorithm>
#include <optional>

namespace jauscat::sae {

namespace detail {

inline constexpr std::byte dle{0x10}, soh{0x01}, stx{0x02}, etx{0x03};
inline constexpr std::uint16_t first_checksum = 0xFFFF;

// Reflected CCITT polynomial, not inverted at the end.
constexpr std::uint16_t checksum(std::uint16_t sum, std::byte byte) noexcept {
    unsigned changed = (std::to_integer<unsigned>(byte) ^ sum) & 0xFF;
    changed = (changed ^ changed << 4) & 0xFF;
    return static_cast<std::uint16_t>((sum >> 8) ^ changed << 8 ^ changed << 3 ^ changed >> 4);
}

// Writes into a span as long as there is space.
class stuffed_writer {
  public:
    constexpr explicit stuffed_writer(std::span<std::byte> out) noexcept : out_{out} {}
    constexpr void marker(std::byte which) noexcept {
        put(dle);
        put(which);
    }
    constexpr void byte(std::byte value) noexcept {
        sum_ = checksum(sum_, value);
        plain(value);
    }
    constexpr void number(std::size_t value) noexcept {
        byte(static_cast<std::byte>(value & 0xFF));
        byte(static_cast<std::byte>(value >> 8 & 0xFF));
    }
    [[nodiscard]] constexpr std::uint16_t sum() const noexcept { return sum_; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }

  private:
    constexpr void plain(std::byte value) noexcept {
        put(value);
        if (value == dle) put(value);
    }
    constexpr void put(std::byte value) noexcept {
        if (size_ < out_.size()) out_[size_] = value;
        ++size_;
    }

    std::span<std::byte> out_;
    std::size_t size_{}; // that it takes, also beyond the space
    std::uint16_t sum_{first_checksum};
};

} // namespace detail

/// Bytes of the frame of a message of `size` bytes, if every byte is doubled.
[[nodiscard]] constexpr std::size_t max_serial_frame_size(std::size_t size) noexcept { return 6 + 2 * (3 + 4 + size); }

/// Writes the frame of a whole message to the front of `out`, and returns it. Without the optional address. Errors:
/// no_space, too_large.
[[nodiscard]] constexpr result<std::span<std::byte>, transport_errc>
put_serial_frame(std::span<const std::byte> message, std::span<std::byte> out) noexcept {
    if (message.size() > 0xFFFF) return transport_errc::too_large;
    detail::stuffed_writer frame{out};
    frame.marker(detail::soh);
    frame.byte(transport_version);
    frame.number(message.size());
    frame.marker(detail::stx);
    frame.number(frame.sum());
    for (const std::byte b : message) frame.byte(b);
    const auto sum = frame.sum();
    frame.marker(detail::etx);
    frame.number(sum);
    if (frame.size() > out.size()) return transport_errc::no_space;
    return out.first(frame.size());
}

/// A frame of a serial line, or why there is none.
struct serial_frame {
    transport_errc
        error{}; ///< wrong_version, wrong_size, too_large, truncated, header_checksum, packet_checksum, noise
    std::optional<std::array<std::byte, 2>> address{}; ///< as received, where the frame has one
    std::span<const std::byte> message{};              ///< for `split`; valid during the call

    [[nodiscard]] constexpr explicit operator bool() const noexcept { return error == transport_errc::ok; }
};

/// Finds the frames in the bytes of a serial line, which may arrive in any pieces. A damaged frame is reported once;
/// the next one is found by its marker.
class jserial_reader {
  public:
    /// `buffer` holds the largest message, and must outlive the reader.
    constexpr explicit jserial_reader(std::span<std::byte> buffer) noexcept : buffer_{buffer} {}

    /// Calls `take(const serial_frame&)` for each frame, and for each run of bytes that is none.
    constexpr void on_bytes(std::span<const std::byte> bytes, auto&& take) {
        for (const std::byte b : bytes) {
            if (after_dle_) {
                after_dle_ = false;
                if (b != detail::dle)
                    marker(b, take);
                else if (state_ == state::outside)
                    after_dle_ = true; // the first one may be noise in front of a frame
                else
                    data(b, take);
            } else if (b == detail::dle) {
                after_dle_ = true;
            } else {
                data(b, take);
            }
        }
    }

  private:
    enum class state : std::uint8_t {
        outside,  // of a frame
        head,     // version, length and address
        head_sum, // checksum of these
        message,  // up to its end marker
        sum,      // checksum behind the end marker
    };

    constexpr void fail(transport_errc why, auto& take) {
        state_ = state::outside;
        is_noise_told_ = true; // what follows belongs to the frame
        take(serial_frame{.error = why});
    }
    constexpr void marker(std::byte which, auto& take) {
        if (which == detail::soh) {
            if (state_ != state::outside) fail(transport_errc::truncated, take);
            state_ = state::head;
            is_noise_told_ = false;
            size_ = 0;
            sum_ = detail::first_checksum;
        } else if (state_ == state::outside) {
            noise(take);
        } else if (which == detail::stx && state_ == state::head) {
            end_head(take);
        } else if (which == detail::etx && state_ == state::message) {
            if (size_ != length_) return fail(transport_errc::truncated, take);
            state_ = state::sum;
            has_low_byte_ = false;
        } else {
            fail(which == detail::etx ? transport_errc::truncated : transport_errc::noise, take);
        }
    }
    constexpr void noise(auto& take) {
        if (!std::exchange(is_noise_told_, true)) take(serial_frame{.error = transport_errc::noise});
    }
    constexpr void end_head(auto& take) {
        if (size_ != short_head && size_ != head_.size()) return fail(transport_errc::noise, take);
        if ((head_[0] & std::byte{0x0F}) != transport_version) return fail(transport_errc::wrong_version, take);
        length_ = std::to_integer<std::size_t>(head_[1]) | std::to_integer<std::size_t>(head_[2]) << 8;
        address_.reset();
        if (size_ != short_head) address_ = std::array{head_[3], head_[4]};
        state_ = state::head_sum;
        has_low_byte_ = false;
    }
    // Nothing until both bytes of the checksum are there; then whether it is that of the bytes.
    constexpr std::optional<bool> is_sum(std::byte b) noexcept {
        if (!std::exchange(has_low_byte_, true)) {
            low_byte_ = b;
            return {};
        }
        return (std::to_integer<unsigned>(low_byte_) | std::to_integer<unsigned>(b) << 8) == sum_;
    }
    constexpr void data(std::byte b, auto& take) {
        switch (state_) {
        case state::outside: noise(take); break;
        case state::head:
            if (size_ == head_.size()) return fail(transport_errc::noise, take);
            head_[size_++] = b;
            sum_ = detail::checksum(sum_, b);
            break;
        case state::head_sum:
            if (const auto good = is_sum(b)) {
                if (!*good) return fail(transport_errc::header_checksum, take);
                if (length_ < transport_overhead) return fail(transport_errc::wrong_size, take);
                if (length_ > buffer_.size()) return fail(transport_errc::too_large, take);
                sum_ = detail::checksum(detail::checksum(sum_, low_byte_), b);
                state_ = state::message;
                size_ = 0;
            }
            break;
        case state::message:
            if (size_ == length_) return fail(transport_errc::truncated, take);
            buffer_[size_++] = b;
            sum_ = detail::checksum(sum_, b);
            break;
        case state::sum:
            if (const auto good = is_sum(b)) {
                state_ = state::outside;
                is_noise_told_ = false;
                take(*good ? serial_frame{.address = address_, .message = buffer_.first(length_)}
                           : serial_frame{.error = transport_errc::packet_checksum});
            }
            break;
        }
    }

    static constexpr std::size_t short_head = 3;

    std::span<std::byte> buffer_;
    std::array<std::byte, 5> head_{}; // version, length, address
    std::optional<std::array<std::byte, 2>> address_{};
    std::size_t size_{};   // bytes of head or message
    std::size_t length_{}; // of the message, as stated
    std::uint16_t sum_{};
    std::byte low_byte_{};
    state state_{};
    bool after_dle_{};
    bool has_low_byte_{};
    bool is_noise_told_{}; // of this run of bytes
};

} // namespace jauscat::sae
