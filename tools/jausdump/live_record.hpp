// Messages of jausdump for the live view.
#pragma once
#include "record.hpp"
#include <jauscat/net/live/live_feed.hpp>

#include <cstdint>

namespace jausdump {

inline void show(jauscat::net::live_feed& feed, const record& message) {
    using jauscat::net::live_way;
    if (message.head) return feed.message(live_way::seen, message.bytes);
    if (!message.sae || !message.sae->message_id) return;
    const auto& sae = *message.sae;
    const auto packed = [](const jauscat::sae::jaus_id& id) {
        return std::uint32_t{id.subsystem} << 16U | std::uint32_t{id.node} << 8U | id.component;
    };
    feed.message(live_way::seen, jauscat::net::live_sae_message{.message_id = *sae.message_id,
                                                                .from = sae.header ? packed(sae.header->source) : 0,
                                                                .to = sae.header ? packed(sae.header->destination) : 0,
                                                                .message = message.bytes,
                                                                .payload_begin = sae.payload_begin,
                                                                .payload_size = sae.payload_size,
                                                                .is_whole = message.kind != kind::part});
}

} // namespace jausdump
