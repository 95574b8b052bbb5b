// Framing of JAUS messages in UDP datagrams: none (`bare`), the prefix `JAUS01.0` of the RA, or that of AS5669-2007.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace jauscat::jaus {

enum class framing : std::uint8_t {
    bare,   ///< the message alone, its 16-byte header first
    jaus01, ///< the 8 characters `JAUS01.0`, then the message
    judp1,  ///< JUDP of AS5669-2007: the version 1, then one or more messages of RA 3.x, each behind two zeros (no
            ///< header compression) and its size in two bytes, the high one first
};

/// The framing's name, as a configuration file spells it: "bare", "JAUS01.0" or "judp1".
constexpr std::string_view name(framing f) noexcept {
    switch (f) {
    case framing::bare: return "bare";
    case framing::jaus01: return "JAUS01.0";
    case framing::judp1: return "judp1";
    }
    return "unknown framing";
}

/// The bytes in front of a message.
class message_prefix {
  public:
    /// Of `jaus01` and `judp1`, in bytes.
    static constexpr std::size_t jaus01_size = 8, judp1_size = 5, max_size = 8;

    constexpr message_prefix(framing how, std::size_t message_size) noexcept {
        const auto put = [this](unsigned char byte) { bytes_[size_++] = std::byte{byte}; };
        if (how == framing::jaus01)
            for (const char c : std::string_view{"JAUS01.0"}) put(static_cast<unsigned char>(c));
        if (how != framing::judp1) return;
        for (const unsigned byte : {1U, 0U, 0U}) put(static_cast<unsigned char>(byte));
        put(static_cast<unsigned char>(message_size >> 8 & 0xFF));
        put(static_cast<unsigned char>(message_size & 0xFF));
    }
    [[nodiscard]] constexpr std::span<const std::byte> bytes() const noexcept { return std::span{bytes_}.first(size_); }

  private:
    std::array<std::byte, max_size> bytes_{};
    std::size_t size_{};
};

/// A message of a datagram. `message` points into the datagram and may be empty.
struct framed_message {
    framing how{};                        ///< the framing found
    std::span<const std::byte> message{}; ///< header and body
    std::span<const std::byte> rest{};    ///< the messages behind it, of judp1
};

namespace detail {
inline constexpr std::size_t judp1_head_size = 4; ///< before each message

// Empty where the bytes do not begin with a message of judp1 without header compression.
constexpr framed_message judp1_message(std::span<const std::byte> bytes) noexcept {
    constexpr std::size_t header_size = 16;
    if (bytes.size() < judp1_head_size || bytes[0] != std::byte{} || bytes[1] != std::byte{}) return {};
    const auto size = std::to_integer<std::size_t>(bytes[2]) << 8 | std::to_integer<std::size_t>(bytes[3]);
    if (size < header_size || size > bytes.size() - judp1_head_size) return {};
    return {framing::judp1, bytes.subspan(judp1_head_size, size), bytes.subspan(judp1_head_size + size)};
}
} // namespace detail

/// Takes off the prefix if there is one. `rest` of a datagram of several messages is for next_message.
///
/// No form can be mistaken for another: a bare message has its version, 2, in its second byte. That of `JAUS01.0` would
/// be version 1 and set a reserved bit, that of judp1 is 0.
constexpr framed_message remove_framing(std::span<const std::byte> datagram) noexcept {
    const message_prefix mark{framing::jaus01, 0};
    if (datagram.size() >= message_prefix::jaus01_size &&
        std::ranges::equal(datagram.first(message_prefix::jaus01_size), mark.bytes()))
        return {framing::jaus01, datagram.subspan(message_prefix::jaus01_size), {}};
    if (!datagram.empty() && datagram[0] == std::byte{1})
        if (const auto first = detail::judp1_message(datagram.subspan(1)); !first.message.empty()) return first;
    return {framing::bare, datagram, {}};
}
/// The message behind `before`; an empty one, and in `rest` the bytes that are none, where these are no message.
constexpr framed_message next_message(const framed_message& before) noexcept {
    const auto next = detail::judp1_message(before.rest);
    return next.message.empty() ? framed_message{before.how, {}, before.rest} : next;
}

/// The generations of JAUS over UDP, which share a port.
enum class datagram_form : std::uint8_t {
    unknown,          ///< none of these
    bare,             ///< a message of RA 3.2 or 3.3 alone
    jaus01,           ///< the same behind `JAUS01.0`
    judp1,            ///< AS5669-2007: messages of RA 3.x
    judp1_compressed, ///< the same with header compression
    judp2,            ///< AS5669A: messages of SAE services
};

/// The form in one line, for logs.
[[nodiscard]] constexpr std::string_view describe(datagram_form form) noexcept {
    switch (form) {
    case datagram_form::unknown: return "no known form of JAUS";
    case datagram_form::bare: return "a bare message of RA 3.2 or 3.3";
    case datagram_form::jaus01: return "JAUS01.0";
    case datagram_form::judp1: return "AS5669-2007";
    case datagram_form::judp1_compressed: return "AS5669-2007 with header compression";
    case datagram_form::judp2: return "SAE JAUS (AS5669A, version 2)";
    }
    return "unknown form";
}

/// What the first bytes of a datagram say that it is. A bare message has its version, 2, in its second byte, where
/// AS5669A has the message type, 0.
[[nodiscard]] constexpr datagram_form form_of(std::span<const std::byte> datagram) noexcept {
    const auto number = [&](std::size_t at) { return std::to_integer<unsigned>(datagram[at]); };
    const framing how = remove_framing(datagram).how;
    if (how == framing::jaus01) return datagram_form::jaus01;
    if (how == framing::judp1) return datagram_form::judp1;
    if (datagram.size() >= 15 && number(0) == 2 && (number(1) & 0x3F) == 0) {
        const std::size_t size = number(2) | number(3) << 8;
        if (size >= 14 && size < datagram.size()) return datagram_form::judp2;
    }
    if (datagram.size() >= 5 && number(0) == 1 && (number(1) != 0 || number(2) != 0) && (number(1) & 0x3F) != 2) {
        const std::size_t size = number(3) << 8 | number(4);
        if (size != 0 && size <= datagram.size() - 5) return datagram_form::judp1_compressed;
    }
    return datagram.size() >= 16 && (number(1) & 0x3F) == 2 ? datagram_form::bare : datagram_form::unknown;
}

/// What a datagram is that is no message of RA 3.2 or 3.3, where its first bytes say it; else empty.
constexpr std::string_view foreign_form(std::span<const std::byte> datagram) noexcept {
    switch (form_of(datagram)) {
    case datagram_form::judp2: return "SAE JAUS (AS5669A, version 2), which is not supported";
    case datagram_form::judp1_compressed: return "AS5669-2007 with header compression, which is not supported";
    default: return {};
    }
}

} // namespace jauscat::jaus
