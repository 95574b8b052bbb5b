// Both tables again, by plain loops and byte offsets, with no schema and no template: what the library must agree with.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace jauscat::test {

// clang-format off
inline constexpr std::array<std::uint16_t, 158> plain_codes{
    0x0001, 0x0002, 0x0003, 0x0004, 0x0005, 0x0006, 0x0007, 0x0008, 0x0009, 0x000A, 0x000B, 0x000C,
    0x000D, 0x000E, 0x000F, 0x0010, 0x0011, 0x01F0, 0x01F1, 0x01F2, 0x01F3, 0x01F4, 0x0200, 0x0201,
    0x0202, 0x0405, 0x0406, 0x0407, 0x0408, 0x040A, 0x040C, 0x040D, 0x040F, 0x0410, 0x0601, 0x0602,
    0x0603, 0x0604, 0x0605, 0x0606, 0x0607, 0x0608, 0x0801, 0x0802, 0x0805, 0x0806, 0x0A20, 0x0A21,
    0x0A24, 0x0A25, 0x0D01, 0x0E00, 0x0E01, 0x0E02, 0x0E03, 0x0E04, 0x0E05, 0x0E06, 0x2001, 0x2002,
    0x200D, 0x2011, 0x21F0, 0x2200, 0x2201, 0x2202, 0x2400, 0x2401, 0x2402, 0x2403, 0x2404, 0x2405,
    0x2406, 0x2407, 0x2408, 0x240A, 0x240B, 0x240C, 0x240D, 0x240E, 0x240F, 0x2410, 0x2600, 0x2601,
    0x2602, 0x2603, 0x2604, 0x2605, 0x2800, 0x2801, 0x2802, 0x2804, 0x2805, 0x2806, 0x2807, 0x2A21,
    0x2A22, 0x2A23, 0x2B00, 0x2B01, 0x2B02, 0x2B03, 0x2D00, 0x2D01, 0x2E00, 0x2E01, 0x4001, 0x4002,
    0x400D, 0x4011, 0x41F0, 0x41F1, 0x4200, 0x4201, 0x4202, 0x4400, 0x4401, 0x4402, 0x4403, 0x4404,
    0x4405, 0x4406, 0x4407, 0x4408, 0x440A, 0x440B, 0x440C, 0x440D, 0x440E, 0x440F, 0x4410, 0x4600,
    0x4601, 0x4602, 0x4603, 0x4604, 0x4605, 0x4800, 0x4801, 0x4802, 0x4804, 0x4805, 0x4806, 0x4807,
    0x4A20, 0x4A21, 0x4A22, 0x4A23, 0x4A24, 0x4B00, 0x4B01, 0x4B02, 0x4B03, 0x4D00, 0x4D01, 0x4E00,
    0x4E01, 0x0404,
};
// clang-format on

enum class plain_table { seed, self_contained };

namespace plain {

using bytes = std::vector<std::byte>;

inline unsigned byte(const bytes& in, std::size_t at) { return std::to_integer<unsigned>(in[at]); }
inline void put_word(bytes& out, std::uint32_t value) {
    for (int i = 0; i != 4; ++i, value >>= 8) out.push_back(static_cast<std::byte>(value & 0xFF));
}
inline std::uint32_t word(const bytes& in, std::size_t at) {
    return byte(in, at) | byte(in, at + 1) << 8 | byte(in, at + 2) << 16 | byte(in, at + 3) << 24;
}
inline void append(bytes& out, const bytes& in, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i != to; ++i) out.push_back(in[i]);
}

struct flag_pair {
    unsigned flag;
    std::uint32_t ul_ext;
};
inline constexpr std::array<flag_pair, 5> flags{{{0, 0x000}, {1, 0x080}, {2, 0x0C0}, {8, 0x040}, {4, 0x2C0}}};

} // namespace plain

/// The packet of a message that is known to be translatable.
inline std::vector<std::byte> plain_forth(plain_table table, const std::vector<std::byte>& message) {
    using namespace plain;
    bytes data;
    append(data, message, 0, 2);
    if (table == plain_table::self_contained) {
        data.push_back(message[4]);
        data.push_back(message[7]);
    }
    append(data, message, 8, 12);
    if (table == plain_table::self_contained) append(data, message, 12, 14);
    append(data, message, 14, message.size());

    std::uint32_t ul_ext = 0;
    for (const auto& pair : flags)
        if (pair.flag == byte(message, 13) >> 4) ul_ext = pair.ul_ext;
    std::uint32_t rank = 0;
    for (std::uint32_t i = 0; i != plain_codes.size(); ++i)
        if (plain_codes[i] == (byte(message, 2) | byte(message, 3) << 8)) rank = i + 1;

    const bool is_seed = table == plain_table::seed;
    const auto n = static_cast<std::uint32_t>(data.size());
    bytes packet;
    put_word(packet, is_seed ? byte(message, 7) : 0x20);
    put_word(packet, 0);
    put_word(packet, is_seed ? byte(message, 4) : 0);
    put_word(packet, 0);
    put_word(packet, 16 + n);
    put_word(packet, 0);
    put_word(packet, 0);
    put_word(packet, 0x00650008);
    put_word(packet, is_seed ? ul_ext : 0);
    put_word(packet, 0);
    put_word(packet, byte(message, 6));
    put_word(packet, 6900 + byte(message, 5));
    put_word(packet, rank);
    put_word(packet, n);
    append(packet, data, 0, data.size());
    return packet;
}

/// The message of a packet, or nothing where either table must refuse it.
inline std::optional<std::vector<std::byte>> plain_back(plain_table table, const std::vector<std::byte>& packet) {
    using namespace plain;
    if (packet.size() < 56) return {};
    const bool is_seed = table == plain_table::seed;
    const std::uint32_t dest = word(packet, 0), dest_id = word(packet, 8), len = word(packet, 16),
                        ext = word(packet, 32);
    const std::uint32_t node = word(packet, 40), index = word(packet, 44), rank = word(packet, 48),
                        n = word(packet, 52);
    const std::uint32_t kept = is_seed ? 8 : 12;
    if (n < kept || n > 1540 || n > packet.size() - 56 || len < n || len - n < 16) return {};
    if (word(packet, 24) != 0 || word(packet, 28) != 0x00650008 || word(packet, 36) != 0) return {};
    if (node > 255 || index < 6900 || index > 6900 + 255 || rank < 1 || rank > 158) return {};

    unsigned flag = 16;
    for (const auto& pair : flags)
        if (pair.ul_ext == ext) flag = pair.flag;
    if (is_seed ? dest > 255 || dest_id > 255 || flag == 16 : dest != 0x20 || dest_id != 0 || ext != 0) return {};

    const std::uint32_t size = n - kept;
    bytes message;
    append(message, packet, 56, 58);
    message.push_back(static_cast<std::byte>(plain_codes[rank - 1] & 0xFF));
    message.push_back(static_cast<std::byte>(plain_codes[rank - 1] >> 8));
    message.push_back(is_seed ? static_cast<std::byte>(dest_id) : packet[58]);
    message.push_back(static_cast<std::byte>(index - 6900));
    message.push_back(static_cast<std::byte>(node));
    message.push_back(is_seed ? static_cast<std::byte>(dest) : packet[59]);
    append(message, packet, is_seed ? 58 : 60, is_seed ? 62 : 64);
    if (is_seed) {
        message.push_back(static_cast<std::byte>(size & 0xFF));
        message.push_back(static_cast<std::byte>(size >> 8 | flag << 4));
    } else {
        append(message, packet, 64, 66);
        if ((byte(packet, 64) | (byte(packet, 65) & 0x0F) << 8) != size) return {};
    }
    append(message, packet, 56 + kept - 2, 56 + n);
    return message;
}

} // namespace jauscat::test
