// The functions of fragment_reassembler.
#pragma once
#include <jauscat/sae/transport/fragments.hpp>

namespace jauscat::sae {

JAUSCAT_CONSTEXPR std::string_view describe(fragment_outcome outcome) noexcept {
    switch (outcome) {
    case fragment_outcome::waiting: return "part of a message of which packets are missing";
    case fragment_outcome::whole: return "the last missing part of a message";
    case fragment_outcome::repeated: return "part of a message that was received already";
    case fragment_outcome::no_capacity: return "too many parts of messages at a time: send it again later";
    case fragment_outcome::too_large: return "the message has more bytes than the memory for messages";
    }
    return "unknown";
}

JAUSCAT_CONSTEXPR fragment_reassembler::fragment_reassembler(std::span<held_fragment> places,
                                                             std::span<std::byte> parts, std::span<std::byte> whole,
                                                             duration timeout) noexcept
    : places_{places}, parts_{parts}, whole_{whole}, timeout_{timeout} {}

JAUSCAT_CONSTEXPR held_fragment* fragment_reassembler::find(const transport_header& head,
                                                            std::uint16_t number) const noexcept {
    const auto found = std::ranges::find_if(places_, [&](const held_fragment& f) {
        return f.is_used && f.number == number && f.source == head.source && f.destination == head.destination;
    });
    return found == places_.end() ? nullptr : &*found;
}

JAUSCAT_CONSTEXPR held_fragment* fragment_reassembler::free_place(const jaus_id& source) const noexcept {
    held_fragment* free = nullptr;
    std::size_t of_node = 0;
    for (held_fragment& f : places_) {
        if (!f.is_used)
            free = &f;
        else if (f.source.subsystem == source.subsystem && f.source.node == source.node)
            ++of_node;
    }
    return of_node < jaus::peer_share(places_.size()) ? free : nullptr;
}

JAUSCAT_CONSTEXPR std::span<std::byte> fragment_reassembler::bytes_of(const held_fragment& place) const noexcept {
    const std::size_t share = parts_.size() / places_.size();
    return parts_.subspan(static_cast<std::size_t>(&place - places_.data()) * share, share);
}

JAUSCAT_CONSTEXPR void fragment_reassembler::drop_old(time_point now) noexcept {
    for (held_fragment& f : places_)
        if (f.is_used && now - f.received_at >= timeout_) f.is_used = false;
}

JAUSCAT_CONSTEXPR void fragment_reassembler::drop(const transport_header& head, std::uint16_t from,
                                                  std::uint16_t to) noexcept {
    for (std::uint16_t number = from;; ++number) {
        if (held_fragment* const f = find(head, number)) f->is_used = false;
        if (number == to) return;
    }
}

JAUSCAT_CONSTEXPR std::size_t fragment_reassembler::held() const noexcept {
    return static_cast<std::size_t>(std::ranges::count_if(places_, &held_fragment::is_used));
}

JAUSCAT_CONSTEXPR fragment_reassembler::received fragment_reassembler::on_packet(const transport_header& head,
                                                                                 std::span<const std::byte> payload,
                                                                                 std::uint16_t number,
                                                                                 time_point now) noexcept {
    drop_old(now);
    if (places_.empty()) return {fragment_outcome::no_capacity};
    held_fragment* place = find(head, number);
    if (place != nullptr && place->flag == head.fragment_flag && place->size == payload.size() &&
        std::ranges::equal(bytes_of(*place).first(place->size), payload))
        return {fragment_outcome::repeated};
    // Other bytes under a number that is held: the source has restarted, or counted once around.
    if (place != nullptr)
        for (held_fragment& f : places_)
            if (f.is_used && f.source == head.source && f.destination == head.destination) f.is_used = false;
    place = free_place(head.source);
    if (place == nullptr) return {fragment_outcome::no_capacity};
    if (payload.size() > bytes_of(*place).size()) return {fragment_outcome::too_large};
    std::ranges::copy(payload, bytes_of(*place).begin());
    *place = {true, head.source, head.destination, number, head.fragment_flag, payload.size(), now};

    // The run of numbers around it, as far as it is held.
    std::uint16_t from = number, to = number;
    std::size_t size = payload.size();
    held_fragment* front = place;
    held_fragment* back = place;
    while (front->flag != fragment_flag::first) {
        held_fragment* const before = find(head, static_cast<std::uint16_t>(from - 1));
        if (before == nullptr || before->flag == fragment_flag::last) break;
        front = before;
        size += front->size;
        --from;
    }
    while (back->flag != fragment_flag::last) {
        held_fragment* const after = find(head, static_cast<std::uint16_t>(to + 1));
        if (after == nullptr || after->flag == fragment_flag::first) break;
        back = after;
        size += back->size;
        ++to;
    }
    if (size > whole_.size()) {
        drop(head, from, to);
        return {fragment_outcome::too_large};
    }
    if (front->flag != fragment_flag::first || back->flag != fragment_flag::last) return {fragment_outcome::waiting};
    auto out = whole_.begin();
    for (std::uint16_t at = from;; ++at) {
        const held_fragment& f = *find(head, at);
        out = std::ranges::copy(bytes_of(f).first(f.size), out).out;
        if (at == to) break;
    }
    drop(head, from, to);
    return {fragment_outcome::whole, whole_.first(size), from};
}

} // namespace jauscat::sae
