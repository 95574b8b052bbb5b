// Both tables by hand: what a programmer with the two layouts beside the keyboard writes. The floor for the translator.
#pragma once
#include <jauscat/schema/translation/command_ranks.hpp>
#include <jauscat/wire/code_index.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace hand_written {

namespace detail {

inline constexpr auto rank_of = [] {
    std::array<std::uint8_t, 65536> ranks{};
    std::uint8_t rank = 0;
    for (const std::uint16_t code : jauscat::translation::ra_command_codes) ranks[code] = ++rank;
    return ranks;
}();

/// The rank of a command code, 0 for an unknown one: a load from 64 KiB.
struct direct_look_up {
    unsigned operator()(unsigned code) const { return rank_of[code]; }
};
/// The same by the library's look-up in 500 bytes.
struct small_look_up {
    unsigned operator()(unsigned code) const {
        using ranks = jauscat::wire::code_index<jauscat::translation::ra_command_codes>;
        return static_cast<unsigned>(ranks::find(static_cast<std::uint16_t>(code)) + 1); // npos becomes 0
    }
};

inline unsigned u16(const std::byte* p) {
    std::uint16_t v;
    std::memcpy(&v, p, 2);
    return v;
}
inline std::uint32_t u32(const std::byte* p) {
    std::uint32_t v;
    std::memcpy(&v, p, 4);
    return v;
}
inline void put16(std::byte* p, unsigned v) {
    const auto w = static_cast<std::uint16_t>(v);
    std::memcpy(p, &w, 2);
}
inline void put32(std::byte* p, std::uint32_t v) { std::memcpy(p, &v, 4); }

} // namespace detail

/// JAUS message to packet; 0 if it cannot be translated.
template <class LookUp = detail::direct_look_up>
std::size_t translate_forth(std::span<const std::byte> message, std::span<std::byte> packet) {
    using namespace detail;
    const std::byte* const m = message.data();
    std::byte* const p = packet.data();
    if (message.size() < 16) return 0;
    const std::size_t body = message.size() - 16, data = body + 8;
    if (data > 1540 || packet.size() < 56 + data) return 0;
    const unsigned control = u16(m + 12), rank = LookUp{}(u16(m + 2));
    if ((control & 0xFFF) != body || rank == 0) return 0;
    std::uint32_t ext = 0;
    switch (control >> 12) {
    case 0: ext = 0; break;
    case 1: ext = 0x80; break;
    case 2: ext = 0xC0; break;
    case 4: ext = 0x2C0; break;
    case 8: ext = 0x40; break;
    default: return 0;
    }
    put32(p + 0, std::to_integer<std::uint32_t>(m[7]));
    put32(p + 4, 0);
    put32(p + 8, std::to_integer<std::uint32_t>(m[4]));
    put32(p + 12, 0);
    put32(p + 16, static_cast<std::uint32_t>(16 + data));
    put32(p + 20, 0);
    put32(p + 24, 0);
    put32(p + 28, 0x00650008);
    put32(p + 32, ext);
    put32(p + 36, 0);
    put32(p + 40, std::to_integer<std::uint32_t>(m[6]));
    put32(p + 44, 6900 + std::to_integer<std::uint32_t>(m[5]));
    put32(p + 48, rank);
    put32(p + 52, static_cast<std::uint32_t>(data));
    std::memcpy(p + 56, m, 2);
    std::memcpy(p + 58, m + 8, 4);
    std::memcpy(p + 62, m + 14, 2);
    if (body != 0) std::memcpy(p + 64, m + 16, body);
    return 56 + data;
}

/// Packet to JAUS message; 0 if it is not a packet of the seed table.
inline std::size_t translate_back(std::span<const std::byte> packet, std::span<std::byte> message) {
    using namespace detail;
    const std::byte* const p = packet.data();
    std::byte* const m = message.data();
    if (packet.size() < 56) return 0;
    const std::size_t data = u32(p + 52);
    if (data > packet.size() - 56 || data < 8 || data > 1540) return 0;
    const std::size_t body = data - 8;
    const std::uint32_t subsystem = u32(p), instance = u32(p + 8), node = u32(p + 40), index = u32(p + 44),
                        rank = u32(p + 48);
    if (message.size() < 16 + body) return 0;
    if (subsystem > 255 || instance > 255 || node > 255 || index < 6900 || index > 6900 + 255 || rank == 0 ||
        rank > 158)
        return 0;
    if (u32(p + 16) < 16 + data || u32(p + 24) != 0 || u32(p + 28) != 0x00650008 || u32(p + 36) != 0) return 0;
    unsigned flag = 0;
    switch (u32(p + 32)) {
    case 0: flag = 0; break;
    case 0x80: flag = 1; break;
    case 0xC0: flag = 2; break;
    case 0x2C0: flag = 4; break;
    case 0x40: flag = 8; break;
    default: return 0;
    }
    std::memcpy(m, p + 56, 2);
    put16(m + 2, jauscat::translation::ra_command_codes[rank - 1]);
    m[4] = static_cast<std::byte>(instance);
    m[5] = static_cast<std::byte>(index - 6900);
    m[6] = static_cast<std::byte>(node);
    m[7] = static_cast<std::byte>(subsystem);
    std::memcpy(m + 8, p + 58, 4);
    put16(m + 12, static_cast<unsigned>(body) | flag << 12);
    std::memcpy(m + 14, p + 62, 2);
    if (body != 0) std::memcpy(m + 16, p + 64, body);
    return 16 + body;
}

namespace self_contained {

template <class LookUp = detail::direct_look_up>
std::size_t translate_forth(std::span<const std::byte> message, std::span<std::byte> packet) {
    using namespace detail;
    const std::byte* const m = message.data();
    std::byte* const p = packet.data();
    if (message.size() < 16) return 0;
    const std::size_t body = message.size() - 16, data = body + 12;
    if (data > 1540 || packet.size() < 56 + data) return 0;
    const unsigned rank = LookUp{}(u16(m + 2));
    if ((u16(m + 12) & 0xFFF) != body || rank == 0) return 0;
    put32(p + 0, 0x20);
    put32(p + 4, 0);
    put32(p + 8, 0);
    put32(p + 12, 0);
    put32(p + 16, static_cast<std::uint32_t>(16 + data));
    put32(p + 20, 0);
    put32(p + 24, 0);
    put32(p + 28, 0x00650008);
    put32(p + 32, 0);
    put32(p + 36, 0);
    put32(p + 40, std::to_integer<std::uint32_t>(m[6]));
    put32(p + 44, 6900 + std::to_integer<std::uint32_t>(m[5]));
    put32(p + 48, rank);
    put32(p + 52, static_cast<std::uint32_t>(data));
    std::memcpy(p + 56, m, 2);
    p[58] = m[4];
    p[59] = m[7];
    std::memcpy(p + 60, m + 8, 8);
    if (body != 0) std::memcpy(p + 68, m + 16, body);
    return 56 + data;
}

inline std::size_t translate_back(std::span<const std::byte> packet, std::span<std::byte> message) {
    using namespace detail;
    const std::byte* const p = packet.data();
    std::byte* const m = message.data();
    if (packet.size() < 56) return 0;
    const std::size_t data = u32(p + 52);
    if (data > packet.size() - 56 || data < 12 || data > 1540) return 0;
    const std::size_t body = data - 12;
    const std::uint32_t node = u32(p + 40), index = u32(p + 44), rank = u32(p + 48);
    if (message.size() < 16 + body) return 0;
    if (node > 255 || index < 6900 || index > 6900 + 255 || rank == 0 || rank > 158) return 0;
    if (u32(p) != 0x20 || u32(p + 8) != 0 || u32(p + 16) < 16 + data || u32(p + 24) != 0 || u32(p + 28) != 0x00650008 ||
        u32(p + 32) != 0 || u32(p + 36) != 0 || (u16(p + 64) & 0xFFF) != body)
        return 0;
    std::memcpy(m, p + 56, 2);
    put16(m + 2, jauscat::translation::ra_command_codes[rank - 1]);
    m[4] = p[58];
    m[5] = static_cast<std::byte>(index - 6900);
    m[6] = static_cast<std::byte>(node);
    m[7] = p[59];
    std::memcpy(m + 8, p + 60, 8);
    if (body != 0) std::memcpy(m + 16, p + 68, body);
    return 16 + body;
}

} // namespace self_contained

} // namespace hand_written
