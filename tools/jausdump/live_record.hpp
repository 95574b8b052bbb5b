// Messages of jausdump for the live view.
#pragma once
#include "record.hpp"
#include <jauscat/net/live/live_feed.hpp>

#include <cstdint>

namespace jausdump {

inline void show(jauscat::net::live_feed& feed, const record& message) {
    using jauscat::net::live_way;
    if (message.head) return feed.message(live_way::seen, message.bytes);
    if (!message.sae || !(message.sae->message_id || message.kind == kind::acknowledgement)) return;
    const auto& sae = *message.sae;
    const auto packed = [](const jauscat::sae::jaus_id& id) {
        return std::uint32_t{id.subsystem} << 16U | std::uint32_t{id.node} << 8U | id.component;
    };
    jauscat::net::live_sae_message shown{.message_id = sae.message_id.value_or(0),
                                         .message = message.bytes,
                                         .payload_begin = sae.payload_begin,
                                         .payload_size = sae.payload_size,
                                         .is_whole = message.kind != kind::part};
    if (sae.header) {
        shown.from = packed(sae.header->source);
        shown.to = packed(sae.header->destination);
        shown.acknowledgement = static_cast<jauscat::jaus::ack_nak>(sae.header->acknowledgement); // the same values
    }
    feed.message(live_way::seen, shown);
}

} // namespace jausdump
