// The functions of transport.
#pragma once
#include <jauscat/sae/transport/transport.hpp>

namespace jauscat::sae {

JAUSCAT_CONSTEXPR transport::transport(std::span<local_component> components, const transport_memory& memory,
                                       const transport_options& options) noexcept
    : components_{components},
      options_{options},
      peers_{memory.peers, options.peer_timeout},
      filter_{memory.seen, options.duplicate_window},
      reassembler_{memory.fragments, memory.fragment_bytes, memory.message, options.fragment_timeout},
      queue_{memory.queue, memory.queue_bytes, options.retry},
      replies_{memory.replies} {
    options_.payload_size = std::min(options_.payload_size, queue_.payload_capacity());
}

JAUSCAT_CONSTEXPR local_component* transport::component_of(const jaus_id& id) const noexcept {
    const auto found = std::ranges::find(components_, id, &local_component::id);
    return found == components_.end() ? nullptr : &*found;
}

JAUSCAT_CONSTEXPR void transport::reply(endpoint_key to, const split_transport_message& packet) noexcept {
    // A broadcast has no single receiver that could acknowledge it.
    if (packet.header.acknowledgement != acknowledgement::request || !names_one_component(packet.header.destination))
        return;
    if (reply_count_ == replies_.size()) {
        ++counters_.lost_replies;
        return;
    }
    replies_[(first_reply_ + reply_count_++) % replies_.size()] = {
        to, acknowledgement_of(packet.header, packet.header.destination), packet.sequence_number};
}

JAUSCAT_CONSTEXPR transport::processed transport::process(endpoint_key from, const split_transport_message& packet,
                                                          time_point now) noexcept {
    const transport_header& head = packet.header;
    if (!packet) {
        ++counters_.of(packet.error);
        return {};
    }
    if (component_of(head.source) != nullptr) {
        ++counters_.own;
        return {};
    }
    if (options_.is_closed) {
        const known_peer* const peer = peers_.find(head.source);
        if (peer == nullptr || !peer->is_fixed) {
            ++counters_.unknown_source;
            return {};
        }
    }
    const learnt where = peers_.on_packet(head.source, from, now);
    if (where == learnt::wrong_endpoint) {
        ++counters_.wrong_endpoint;
        return {};
    }
    if (where == learnt::no_capacity) ++counters_.unlearnt;
    if (std::ranges::none_of(components_, [&](const local_component& c) { return covers(head.destination, c.id); })) {
        ++counters_.not_here;
        return {};
    }
    if (is_acknowledgement(head)) {
        ++(queue_.on_reply(head, packet.sequence_number) ? counters_.replies : counters_.late_replies);
        return {};
    }
    if (head.fragment_flag == fragment_flag::single && packet.payload.size() < 2) {
        ++counters_.of(transport_errc::no_message_id);
        return {};
    }
    switch (filter_.on_packet(head, packet.payload, packet.sequence_number, now)) {
    case seen::no_capacity: ++counters_.no_capacity; return {};
    case seen::repeated:
        ++counters_.repeated;
        reply(from, packet);
        return {};
    case seen::fresh: break;
    }
    if (head.fragment_flag != fragment_flag::single) return process_part(from, packet, now);
    ++counters_.packets;
    reply(from, packet);
    return {packet.payload, packet.sequence_number};
}

JAUSCAT_CONSTEXPR transport::processed transport::process_part(endpoint_key from, const split_transport_message& packet,
                                                               time_point now) noexcept {
    const auto got = reassembler_.on_packet(packet.header, packet.payload, packet.sequence_number, now);
    switch (got.outcome) {
    case fragment_outcome::no_capacity:
    case fragment_outcome::too_large: // its repeat is refused again
        filter_.forget(packet.header, packet.payload, packet.sequence_number);
        ++(got.outcome == fragment_outcome::too_large ? counters_.of(transport_errc::too_large)
                                                      : counters_.no_capacity);
        return {};
    case fragment_outcome::repeated:
        ++counters_.repeated;
        reply(from, packet);
        return {};
    case fragment_outcome::whole:
        if (got.payload.size() >= 2) break;
        ++counters_.of(transport_errc::no_message_id);
        return {};
    case fragment_outcome::waiting: break;
    }
    ++counters_.packets;
    reply(from, packet);
    if (got.outcome == fragment_outcome::waiting) return {};
    return {got.payload, got.first_number};
}

JAUSCAT_CONSTEXPR result<std::uint16_t, transport_errc>
transport::send(const outgoing_message& message, std::span<const std::byte> payload, time_point now) noexcept {
    local_component* const source = component_of(message.source);
    if (source == nullptr) return transport_errc::unknown_source;
    if (message.broadcast > broadcast::global) return transport_errc::invalid_header;
    if (has_zero(message.destination)) return transport_errc::invalid_destination;
    if (component_of(message.destination) != nullptr) return transport_errc::local_destination;
    if (payload.size() < 2) return transport_errc::no_message_id;
    const cut_payload cut{payload, options_.payload_size};
    const bool is_for_one = names_one_component(message.destination);
    const bool is_known = peers_.find(message.destination) != nullptr;
    const bool is_broadcast = !is_for_one || message.broadcast != broadcast::none;
    if (is_broadcast && (message.is_acknowledged || cut.packets() != 1)) return transport_errc::not_one_component;
    if (!is_known && (!options_.has_group || cut.packets() != 1)) return transport_errc::unknown_peer;
    transport_header head{.priority = message.priority,
                          .broadcast = message.broadcast,
                          .destination = message.destination,
                          .source = message.source};
    if (is_for_one && !is_known) {
        head.broadcast = broadcast::global;
        head.acknowledgement = acknowledgement::request;
    }
    const std::uint16_t number = source->next_number;
    if (const auto taken = queue_.put(head, cut, number, message.is_acknowledged, now); !taken) return taken.error();
    source->next_number = static_cast<std::uint16_t>(number + cut.packets());
    return number;
}

JAUSCAT_CONSTEXPR std::optional<finished_message> transport::next_outcome() noexcept { return queue_.next_outcome(); }

JAUSCAT_CONSTEXPR std::optional<time_point> transport::next_event() const noexcept {
    return reply_count_ != 0 ? time_point::min() : queue_.next_event();
}

JAUSCAT_CONSTEXPR bool transport::fix(const jaus_id& id, endpoint_key endpoint) noexcept {
    return peers_.fix(id, endpoint);
}

JAUSCAT_CONSTEXPR bool transport::learn(const jaus_id& id, endpoint_key endpoint, time_point now) noexcept {
    const auto what = peers_.on_packet(id, endpoint, now);
    return what != learnt::no_capacity && what != learnt::wrong_endpoint;
}

JAUSCAT_CONSTEXPR void transport::forget(endpoint_key endpoint) noexcept { peers_.forget(endpoint); }

JAUSCAT_CONSTEXPR std::optional<outgoing_datagram> transport::next_datagram(time_point now) noexcept {
    if (reply_count_ != 0) {
        const queued_reply& next = replies_[first_reply_];
        first_reply_ = (first_reply_ + 1) % replies_.size();
        --reply_count_;
        const auto written = put_datagram(next.header, {}, next.number, reply_bytes_);
        if (written) return outgoing_datagram{next.to, *written};
    }
    while (const auto packet = queue_.next_datagram(now)) {
        const known_peer* const peer = peers_.find(packet->destination);
        if (peer != nullptr) return outgoing_datagram{peer->endpoint, packet->bytes};
        if (options_.has_group) return outgoing_datagram{std::nullopt, packet->bytes};
        ++counters_.unknown_peers;
    }
    return {};
}

} // namespace jauscat::sae
