// The functions of packet_queue.
#pragma once
#include <jauscat/sae/transport/packet_queue.hpp>

namespace jauscat::sae {

JAUSCAT_CONSTEXPR std::string_view describe(sent_outcome outcome) noexcept {
    switch (outcome) {
    case sent_outcome::acknowledged: return "acknowledged";
    case sent_outcome::refused: return "refused by the receiver (negative reply)";
    case sent_outcome::timed_out: return "no acknowledgement in time";
    }
    return "unknown";
}

JAUSCAT_CONSTEXPR packet_queue::packet_queue(std::span<queued_packet> places, std::span<std::byte> memory,
                                             const retry_policy& retry) noexcept
    : places_{places}, memory_{memory}, retry_{retry} {}

JAUSCAT_CONSTEXPR std::size_t packet_queue::payload_capacity() const noexcept {
    const std::size_t share = places_.empty() ? 0 : memory_.size() / places_.size();
    return share <= transport_overhead + 1 ? 0 : std::min(share - transport_overhead - 1, max_payload_size);
}

JAUSCAT_CONSTEXPR std::span<std::byte> packet_queue::bytes_of(const queued_packet& place) const noexcept {
    const std::size_t share = memory_.size() / places_.size();
    return memory_.subspan(static_cast<std::size_t>(&place - places_.data()) * share, share);
}

JAUSCAT_CONSTEXPR std::size_t packet_queue::waiting() const noexcept {
    return static_cast<std::size_t>(
        std::ranges::count_if(places_, [](const queued_packet& p) { return p.phase != state::free; }));
}

JAUSCAT_CONSTEXPR result<void, transport_errc> packet_queue::put(const transport_header& head,
                                                                 const cut_payload& payload, std::uint16_t first_number,
                                                                 bool is_repeated, time_point now) noexcept {
    const std::size_t kept_free = head.priority == priority::safety_critical ? 0 : places_.size() / 4;
    if (payload.packets() + kept_free > places_.size()) return transport_errc::too_large;
    if (waiting() + payload.packets() + kept_free > places_.size()) return transport_errc::no_capacity;
    std::size_t packet = 0;
    for (queued_packet& place : places_) {
        if (packet == payload.packets()) break;
        if (place.phase != state::free) continue;
        transport_header numbered = head;
        numbered.fragment_flag = payload.flag(packet);
        if (is_repeated) numbered.acknowledgement = acknowledgement::request;
        const auto number = static_cast<std::uint16_t>(first_number + packet);
        const auto written = put_datagram(numbered, payload.part(packet), number, bytes_of(place));
        if (!written) { // the first packet fails, or none: their headers and sizes differ in nothing that fails later
            return written.error() == transport_errc::no_space ? transport_errc::too_large : written.error();
        }
        place = {.phase = state::queued,
                 .priority = head.priority,
                 .is_repeated = is_repeated,
                 .source = head.source,
                 .destination = head.destination,
                 .number = number,
                 .first_number = first_number,
                 .size = written->size(),
                 .due = now,
                 .order = order_++};
        ++packet;
    }
    return {};
}

JAUSCAT_CONSTEXPR void packet_queue::finish(queued_packet& packet, sent_outcome outcome) noexcept {
    const auto is_of_message = [&](const queued_packet& p) {
        return (p.phase == state::queued || p.phase == state::awaiting) && p.first_number == packet.first_number &&
               p.source == packet.source && p.destination == packet.destination && &p != &packet;
    };
    if (outcome == sent_outcome::acknowledged && std::ranges::any_of(places_, is_of_message)) {
        packet = {}; // others are missing
        return;
    }
    for (queued_packet& p : places_)
        if (is_of_message(p)) p = {};
    packet.phase = state::finished;
    packet.outcome = outcome;
}

JAUSCAT_CONSTEXPR std::optional<packet_queue::datagram> packet_queue::next_datagram(time_point now) noexcept {
    for (queued_packet& p : places_) {
        if (p.phase != state::awaiting || p.due > now) continue;
        if (retry_.allows_another(p.attempts))
            p.phase = state::queued;
        else
            finish(p, sent_outcome::timed_out);
    }
    queued_packet* next = nullptr;
    for (queued_packet& p : places_) {
        if (p.phase != state::queued || p.due > now) continue;
        if (next == nullptr || p.priority > next->priority || (p.priority == next->priority && p.order < next->order))
            next = &p;
    }
    if (next == nullptr) return {};
    const datagram out{next->destination, bytes_of(*next).first(next->size)};
    if (next->is_repeated) {
        next->phase = state::awaiting;
        ++next->attempts;
        next->due = saturating_add(now, retry_.interval);
    } else {
        *next = {};
    }
    return out;
}

JAUSCAT_CONSTEXPR bool packet_queue::on_reply(const transport_header& head, std::uint16_t number) noexcept {
    for (queued_packet& p : places_) {
        const bool is_sent = p.phase == state::awaiting || (p.phase == state::queued && p.attempts != 0);
        if (!is_sent || p.number != number || p.source != head.destination || p.destination != head.source) continue;
        finish(p, head.acknowledgement == acknowledgement::ack ? sent_outcome::acknowledged : sent_outcome::refused);
        return true;
    }
    return false;
}

JAUSCAT_CONSTEXPR std::optional<finished_message> packet_queue::next_outcome() noexcept {
    for (queued_packet& p : places_) {
        if (p.phase != state::finished) continue;
        const finished_message done{p.outcome, p.source, p.destination, p.first_number};
        p = {};
        return done;
    }
    return {};
}

JAUSCAT_CONSTEXPR std::optional<time_point> packet_queue::next_event() const noexcept {
    std::optional<time_point> first;
    for (const queued_packet& p : places_)
        if ((p.phase == state::queued || p.phase == state::awaiting) && (!first || p.due < *first)) first = p.due;
    return first;
}

} // namespace jauscat::sae
