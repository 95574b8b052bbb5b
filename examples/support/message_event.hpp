// Members of events about JAUS messages.
#pragma once
#include "support/event.hpp"
#include <jauscat/text/hex.hpp>
#include <jauscat/text/jaus.hpp>

#include <cstddef>
#include <span>
#include <string>

namespace example {

inline const char* acknowledgement_name(jauscat::jaus::ack_nak what) {
    switch (what) {
    case jauscat::jaus::ack_nak::none: return "none";
    case jauscat::jaus::ack_nak::request: return "request";
    case jauscat::jaus::ack_nak::nak: return "nak";
    case jauscat::jaus::ack_nak::ack: return "ack";
    }
    return "unknown";
}

/// `name`: of the message.
inline event_members message_members(const jauscat::jaus::header& head, const std::string& name) {
    return {{"code", head.command_code},
            {"message", name},
            {"source", jauscat::text::to_text(head.source)},
            {"destination", jauscat::text::to_text(head.destination)},
            {"acknowledgement", acknowledgement_name(head.ack_nak)},
            {"sequence", head.sequence_number},
            {"size", jauscat::jaus::header_size + head.data_size}};
}
inline event_members message_members(const jauscat::jaus::header& head) {
    return message_members(head, jauscat::text::message_name(head.command_code));
}
inline event_members message_members(const jauscat::jaus::header& head, std::span<const std::byte> body,
                                     const std::string& name) {
    return message_members(head, name) + event_members{{"body", jauscat::text::hex(body)}};
}
inline event_members message_members(const jauscat::jaus::header& head, std::span<const std::byte> body) {
    return message_members(head) + event_members{{"body", jauscat::text::hex(body)}};
}

} // namespace example
