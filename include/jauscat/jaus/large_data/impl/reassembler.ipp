// The functions of reassembler.
#pragma once
#include <jauscat/jaus/large_data/reassembler.hpp>

namespace jauscat::jaus {

JAUSCAT_CONSTEXPR std::string_view describe(reassembled what) noexcept {
    switch (what) {
    case reassembled::only: return "complete in one packet";
    case reassembled::waiting: return "part of a large data set of which packets are missing";
    case reassembled::whole: return "the last missing part of a large data set";
    case reassembled::repeated: return "part of a large data set that was received already";
    case reassembled::doubtful: return "equal to part of the large data set before, and may be a late copy of that";
    case reassembled::no_capacity: return "too many large data sets at a time: send it again later";
    case reassembled::too_large: return "the large data set has more bytes or packets than its memory holds";
    }
    return "unknown";
}

JAUSCAT_CONSTEXPR reassembler::reassembler(std::span<partial_data_set> places, std::span<held_packet> packets,
                                           std::span<std::byte> memory, duration timeout,
                                           reassembly_limits limits) noexcept
    : places_{places}, packets_{packets}, memory_{memory}, timeout_{timeout}, limits_{limits} {
    if (limits_.places_per_source == 0) limits_.places_per_source = (places.size() + 1) / 2;
}

JAUSCAT_CONSTEXPR partial_data_set* reassembler::find(const header& head) const noexcept {
    const auto found = std::ranges::find_if(places_, [&](const partial_data_set& set) {
        return set.packets != 0 && set.header.command_code == head.command_code && set.header.source == head.source;
    });
    return found == places_.end() ? nullptr : &*found;
}

JAUSCAT_CONSTEXPR bool reassembler::is_requested(const header& head) noexcept {
    return head.ack_nak == ack_nak::request;
}

JAUSCAT_CONSTEXPR bool reassembler::contradicts(const partial_data_set& set, const header& head,
                                                std::span<const std::byte> body) const noexcept {
    if (is_requested(set.header) && !is_requested(head)) return true;
    const bool ends = head.data_flag == data_flag::last;
    if (set.last && head.sequence_number > *set.last) return true;
    const auto held = share(packets_, set).first(set.packets);
    if (ends && !held.empty() && held.back().sequence_number > head.sequence_number) return true;
    const auto at = position(held, head.sequence_number);
    if (at == held.end() || at->sequence_number != head.sequence_number) return false;
    const bool ended = set.last == head.sequence_number;
    return (ends != ended && head.data_flag != data_flag::repeated) || !std::ranges::equal(body_of(set, *at), body);
}

JAUSCAT_CONSTEXPR bool reassembler::comes_too_early(const partial_data_set* set, const header& head) noexcept {
    if (head.data_flag != data_flag::last || !is_requested(head)) return false;
    return set == nullptr || !set->begun || set->packets < head.sequence_number;
}

JAUSCAT_CONSTEXPR bool reassembler::may_be_another(const partial_data_set& set, const header& head,
                                                   time_point now) const noexcept {
    if (!set.begun) return now - set.begun_at > limits_.linger;
    if (is_requested(set.header) && is_requested(head)) return false;
    return now - set.last_heard_at > limits_.longest_gap ||
           (head.data_flag == data_flag::first && now - set.begun_at > limits_.linger);
}

JAUSCAT_CONSTEXPR const held_packet* reassembler::packet_of(const partial_data_set& set,
                                                            const header& head) const noexcept {
    const auto held = share(packets_, set).first(set.packets);
    const auto at = position(held, head.sequence_number);
    return at != held.end() && at->sequence_number == head.sequence_number ? &*at : nullptr;
}

JAUSCAT_CONSTEXPR bool reassembler::holds(const partial_data_set* set, const header& head,
                                          std::span<const std::byte> body) const noexcept {
    const auto* const packet = set == nullptr ? nullptr : packet_of(*set, head);
    return packet != nullptr && std::ranges::equal(body_of(*set, *packet), body);
}

JAUSCAT_CONSTEXPR duration reassembler::linger_of(const header& head) const noexcept {
    const bool repeats = head.data_flag == data_flag::last && is_requested(head);
    return std::max(limits_.linger, repeats ? limits_.linger_of_repeats : limits_.linger);
}

JAUSCAT_CONSTEXPR bool reassembler::is_straggler(const header& head, std::span<const std::byte> body, time_point now,
                                                 duration linger) const noexcept {
    return std::ranges::any_of(places_, [&](const partial_data_set& set) {
        return set.handed_on > head.sequence_number && now - set.last_heard_at < linger &&
               set.header.command_code == head.command_code && set.header.source == head.source &&
               std::ranges::equal(body_of(set, share(packets_, set)[head.sequence_number]), body);
    });
}

JAUSCAT_CONSTEXPR std::span<const std::byte> reassembler::body_of(const partial_data_set& set,
                                                                  const held_packet& packet) const noexcept {
    return share(memory_, set).subspan(packet.offset, packet.size);
}

JAUSCAT_CONSTEXPR std::span<held_packet>::iterator reassembler::position(std::span<held_packet> held,
                                                                         std::uint16_t number) noexcept {
    return std::ranges::lower_bound(held, number, {}, &held_packet::sequence_number);
}

JAUSCAT_CONSTEXPR bool reassembler::stale(const partial_data_set& set, time_point now) const noexcept {
    return now - set.last_heard_at >= timeout_;
}

} // namespace jauscat::jaus
