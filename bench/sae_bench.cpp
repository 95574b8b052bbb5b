// Translation under the table of SAE JAUS against code written by hand.
#include "hand_written_translator.hpp"
#include "pair.hpp"
#include <jauscat/schema/translation/sae_table.hpp>
#include <jauscat/translate/translator.hpp>

#include <algorithm>
#include <random>
#include <vector>

namespace {

namespace translation = jauscat::translation;
namespace sae = jauscat::sae;
using bytes = std::vector<std::byte>;
using in_bytes = std::span<const std::byte>;
using out_bytes = std::span<std::byte>;
using translator = jauscat::translate::translator<translation::sae_table>;
using segments = translation::sae_segments;

[[gnu::noinline, gnu::flatten]] std::size_t forth(in_bytes message, out_bytes packet) {
    return translator::to_packet(message, packet)->size();
}
[[gnu::noinline, gnu::flatten]] std::size_t back(in_bytes packet, out_bytes message) {
    return translator::from_packet(packet, message)->size();
}

// By hand, with the library's look-up of an ID.
[[gnu::noinline, gnu::flatten]] std::size_t forth_by_hand(in_bytes message, out_bytes packet) {
    using namespace hand_written::detail;
    const std::byte* const m = message.data();
    std::byte* const p = packet.data();
    if (message.size() < 16) return 0;
    const std::size_t body = message.size() - 14, data = body + 7;
    if (data > 1540 || packet.size() < 56 + data) return 0;
    const auto place = segments::find(static_cast<std::uint16_t>(u16(m + 12)));
    if (m[0] != std::byte{} || u16(m + 1) != message.size() || (m[3] & std::byte{0xC0}) != std::byte{} ||
        place.rank == 0)
        return 0;
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
    put32(p + 40, std::to_integer<std::uint32_t>(m[5]));
    put32(p + 44, 0x2000 + 256u * place.segment + std::to_integer<std::uint32_t>(m[4]));
    put32(p + 48, place.rank);
    put32(p + 52, static_cast<std::uint32_t>(data));
    p[56] = m[3];
    std::memcpy(p + 57, m + 6, 6);
    std::memcpy(p + 63, m + 14, body);
    return 56 + data;
}
[[gnu::noinline, gnu::flatten]] std::size_t back_by_hand(in_bytes packet, out_bytes message) {
    using namespace hand_written::detail;
    const std::byte* const p = packet.data();
    std::byte* const m = message.data();
    if (packet.size() < 56) return 0;
    const std::size_t data = u32(p + 52);
    if (data > packet.size() - 56 || data < 9 || data > 1540) return 0;
    const std::size_t body = data - 7;
    const std::uint32_t node = u32(p + 40), index = u32(p + 44), rank = u32(p + 48);
    if (message.size() < 14 + body) return 0;
    std::uint16_t id = 0;
    if (node > 255 || index < 0x2000 || index > 0x2FFF || !segments::find((index - 0x2000) / 256, rank, id)) return 0;
    if (u32(p) != 0x20 || u32(p + 8) != 0 || u32(p + 16) < 16 + data || u32(p + 24) != 0 || u32(p + 28) != 0x00650008 ||
        u32(p + 32) != 0 || u32(p + 36) != 0 || (p[56] & std::byte{0xC0}) != std::byte{})
        return 0;
    m[0] = std::byte{};
    put16(m + 1, static_cast<unsigned>(14 + body));
    m[3] = p[56];
    m[4] = static_cast<std::byte>(index);
    m[5] = static_cast<std::byte>(node);
    std::memcpy(m + 6, p + 57, 6);
    put16(m + 12, id);
    std::memcpy(m + 14, p + 63, body);
    return 14 + body;
}

/// Adds both directions for messages of any ID with `body` bytes behind the ID. False when the sides differ.
bool add(const std::string& name, std::vector<bytes>& messages, std::vector<bytes>& packets, std::size_t body) {
    static std::array<std::byte, translator::max_packet_size> packet, other_packet, message;
    std::mt19937 random{7};
    bool agree = true;
    for (std::size_t i = 0; i != 1024; ++i) {
        bytes made(16 + body);
        std::ranges::generate(made, [&] { return static_cast<std::byte>(random()); });
        const sae::message_head head{.transport = {.size = static_cast<std::uint16_t>(made.size()),
                                                   .destination = {.component = 33,
                                                                   .node = 2,
                                                                   .subsystem = static_cast<std::uint16_t>(random())},
                                                   .source = {.component = 4, .node = 3, .subsystem = 2}},
                                     .message_id = segments::codes[random() % segments::codes.size()]};
        agree = agree && jauscat::wire::encode(head, made);
        const auto size = forth(made, packet);
        agree = agree && size != 0 && size == forth_by_hand(made, other_packet) &&
                std::ranges::equal(std::span{packet}.first(size), std::span{other_packet}.first(size));
        for (const auto way : {back, back_by_hand})
            agree = agree && way(std::span{packet}.first(size), message) == made.size() &&
                    std::ranges::equal(std::span{message}.first(made.size()), made);
        packets.emplace_back(packet.begin(), packet.begin() + static_cast<std::ptrdiff_t>(size));
        messages.push_back(std::move(made));
    }
    const auto into_packet = [](auto way) { return [way](const bytes& m) { return way(m, packet); }; };
    const auto into_message = [](auto way) { return [way](const bytes& p) { return way(p, message); }; };
    const std::span from{messages}, to{packets};
    bench::pair(name + ", to packet", from, into_packet(forth), from, into_packet(forth_by_hand));
    bench::pair(name + ", to message", to, into_message(back), to, into_message(back_by_hand));
    return agree;
}

} // namespace

bool bench::add_sae_benchmarks() {
    static std::vector<bytes> messages[3], packets[3];
    return add("SAE table, no fields", messages[0], packets[0], 0) &&
           add("SAE table, 20 bytes of fields", messages[1], packets[1], 20) &&
           add("SAE table, largest body", messages[2], packets[2], translator::max_body - 2);
}
