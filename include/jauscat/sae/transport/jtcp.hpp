// JTCP: messages of AS5669A in a byte stream. One version byte for each connection and direction, then messages back to
// back.
#pragma once
#include <jauscat/sae/transport/judp.hpp>

#include <algorithm>

namespace jauscat::sae {

/// Writes the bytes of one direction of a connection.
class jtcp_writer {
  public:
    /// Copies a whole message to `out`, behind the version byte if it is the first one. Error: no_space.
    [[nodiscard]] constexpr result<std::span<std::byte>, transport_errc> put(std::span<const std::byte> message,
                                                                             std::span<std::byte> out) noexcept {
        const std::size_t before = is_first_ ? 1 : 0;
        if (out.size() < before + message.size()) return transport_errc::no_space;
        if (is_first_) out[0] = transport_version;
        std::ranges::copy(message, out.begin() + static_cast<std::ptrdiff_t>(before));
        is_first_ = false;
        return out.first(before + message.size());
    }

  private:
    bool is_first_{true};
};

/// Finds the messages in the bytes of one direction of a connection, which may arrive in any pieces.
///
/// A message that is larger than the buffer is skipped. A wrong version, or a size that cannot be, leaves no way to
/// find the next message: the connection is then to be closed.
class jtcp_reader {
  public:
    /// `buffer` holds the largest message, at least 14 bytes, and must outlive the reader.
    constexpr explicit jtcp_reader(std::span<std::byte> buffer) noexcept : buffer_{buffer} {}

    /// Calls `take(const split_transport_message&)` for each message; it may have an error, too_large among them. Its
    /// bytes are valid during the call. Ignores bytes after an error of the connection.
    constexpr void on_bytes(std::span<const std::byte> bytes, auto&& take) {
        if (!has_version_ && !bytes.empty() && error_ == transport_errc::ok) {
            if (bytes[0] != transport_version) error_ = transport_errc::wrong_version;
            has_version_ = true;
            bytes = bytes.subspan(1);
        }
        while (!bytes.empty() && error_ == transport_errc::ok) {
            const std::size_t count = std::min(bytes.size(), skipped_ != 0 ? skipped_ : wanted() - size_);
            const auto part = bytes.first(count);
            bytes = bytes.subspan(count);
            if (skipped_ != 0) {
                skipped_ -= count;
                continue;
            }
            std::ranges::copy(part, buffer_.begin() + static_cast<std::ptrdiff_t>(size_));
            size_ += count;
            if (size_ == transport_overhead) judge_size(take);
            if (size_ >= transport_overhead && size_ == wanted()) deliver(take);
        }
    }
    /// Why the connection is to be closed: wrong_version or wrong_size; ok while it is good.
    [[nodiscard]] constexpr transport_errc error() const noexcept { return error_; }
    /// Whether a message has begun and is not complete: at the end of the connection it is lost.
    [[nodiscard]] constexpr bool is_inside_message() const noexcept { return size_ != 0 || skipped_ != 0; }

  private:
    // Each message has at least the overhead.
    [[nodiscard]] constexpr std::size_t wanted() const noexcept {
        if (size_ < transport_overhead) return transport_overhead;
        return std::to_integer<std::size_t>(buffer_[1]) | std::to_integer<std::size_t>(buffer_[2]) << 8;
    }
    constexpr void judge_size(auto& take) {
        const std::size_t size = wanted();
        if (size < transport_overhead) {
            error_ = transport_errc::wrong_size;
        } else if (size > buffer_.size()) {
            split_transport_message m{};
            static_cast<void>(wire::decode_prefix(m.header, buffer_));
            m.error = transport_errc::too_large;
            skipped_ = size - size_;
            size_ = 0;
            take(std::as_const(m));
        }
    }
    constexpr void deliver(auto& take) {
        const auto m = split(buffer_.first(std::exchange(size_, 0)));
        if (m.error == transport_errc::wrong_size) error_ = m.error;
        take(m);
    }

    std::span<std::byte> buffer_;
    std::size_t size_{};    // bytes that wait
    std::size_t skipped_{}; // bytes to skip
    bool has_version_{};
    transport_errc error_{};
};

} // namespace jauscat::sae
