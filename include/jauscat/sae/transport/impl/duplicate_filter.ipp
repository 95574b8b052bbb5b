// The functions of duplicate_filter.
#pragma once
#include <jauscat/sae/transport/duplicate_filter.hpp>

namespace jauscat::sae {

JAUSCAT_CONSTEXPR duplicate_filter::duplicate_filter(std::span<seen_packet> places, duration window) noexcept
    : places_{places}, window_{window} {}

// FNV-1a of 32 bits.
JAUSCAT_CONSTEXPR std::uint32_t duplicate_filter::digest_of(const transport_header& head,
                                                            std::span<const std::byte> payload) noexcept {
    std::uint32_t digest = 0x811C9DC5U;
    const auto add = [&](std::byte b) { digest = (digest ^ std::to_integer<std::uint32_t>(b)) * 0x01000193U; };
    add(static_cast<std::byte>(head.fragment_flag));
    for (const std::byte b : payload) add(b);
    return digest;
}

JAUSCAT_CONSTEXPR seen duplicate_filter::on_packet(const transport_header& head, std::span<const std::byte> payload,
                                                   std::uint16_t number, time_point now) noexcept {
    const bool wants_reply = head.acknowledgement == acknowledgement::request;
    const seen_packet packet{head.source, number, digest_of(head, payload), wants_reply, saturating_add(now, window_)};
    seen_packet* free = nullptr;
    seen_packet* oldest = nullptr; // without acknowledgement
    std::size_t of_node = 0;
    for (seen_packet& p : places_) {
        if (p.until <= now) {
            free = &p;
            continue;
        }
        if (p.source == packet.source && p.number == number && p.digest == packet.digest) return seen::repeated;
        if (p.is_acknowledged && p.source.subsystem == head.source.subsystem && p.source.node == head.source.node)
            ++of_node;
        if (!p.is_acknowledged && (oldest == nullptr || p.until < oldest->until)) oldest = &p;
    }
    if (free == nullptr) free = oldest;
    if (wants_reply && of_node >= jaus::peer_share(places_.size())) return seen::no_capacity;
    if (free == nullptr) return wants_reply ? seen::no_capacity : seen::fresh;
    *free = packet;
    return seen::fresh;
}

JAUSCAT_CONSTEXPR void duplicate_filter::forget(const transport_header& head, std::span<const std::byte> payload,
                                                std::uint16_t number) noexcept {
    const std::uint32_t digest = digest_of(head, payload);
    for (seen_packet& p : places_)
        if (p.source == head.source && p.number == number && p.digest == digest) p = {};
}

} // namespace jauscat::sae
