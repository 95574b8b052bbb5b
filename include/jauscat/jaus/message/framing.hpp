// Framing of JAUS messages in UDP datagrams: none (`bare`), or the prefix `JAUS01.0` of the RA.
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
};

/// The framing's name, as a configuration file spells it: "bare" or "JAUS01.0".
constexpr std::string_view name(framing f) noexcept { return f == framing::bare ? "bare" : "JAUS01.0"; }

namespace detail {
inline constexpr std::array<std::byte, 8> jaus01_prefix{std::byte{'J'}, std::byte{'A'}, std::byte{'U'}, std::byte{'S'},
                                                        std::byte{'0'}, std::byte{'1'}, std::byte{'.'}, std::byte{'0'}};
}

/// The bytes that go in front of a message: 0 or 8 of them.
constexpr std::span<const std::byte> prefix(framing f) noexcept {
    return f == framing::bare ? std::span<const std::byte>{} : std::span<const std::byte>{detail::jaus01_prefix};
}

/// Parts of a datagram. `message` points into the datagram and may be empty.
struct framed_message {
    framing how{};                        ///< the framing found
    std::span<const std::byte> message{}; ///< header and body
};

/// Takes off the prefix if there is one.
///
/// A bare message cannot be mistaken for a prefixed one: read as a header, the prefix's second byte 'A' (41h) would
/// set bit 14 of the message properties, which is reserved and sent as 0, and give version 1 instead of 2.
constexpr framed_message remove_framing(std::span<const std::byte> datagram) noexcept {
    constexpr auto mark = prefix(framing::jaus01);
    if (datagram.size() >= mark.size() && std::ranges::equal(datagram.first(mark.size()), mark))
        return {framing::jaus01, datagram.subspan(mark.size())};
    return {framing::bare, datagram};
}

} // namespace jauscat::jaus
