// Errors of the SAE JAUS transport.
#pragma once
#include <cstdint>
#include <string_view>

namespace jauscat::sae {

/// Why bytes are no message, or no message is written or sent.
enum class transport_errc : std::uint8_t {
    ok,
    truncated,           ///< fewer bytes than the header states
    wrong_size,          ///< the header states fewer bytes than header and sequence number need
    wrong_version,       ///< the version is not that of AS5669A
    unknown_type,        ///< a message type other than 0
    compressed,          ///< header compression that leaves bytes out, or answers a proposal
    invalid_source,      ///< the source does not name one component
    invalid_destination, ///< a part of the destination is 0
    not_one_component,   ///< wildcard or broadcast, where only one component can acknowledge or get several packets
    local_destination,   ///< sending: the destination is a component of this transport
    no_message_id,       ///< the payload is shorter than a message ID
    invalid_header,      ///< a value of the header is wider than its bits, or not for sending
    too_large,           ///< more bytes than a packet, or the receiver's memory, holds
    no_space,            ///< the output span is too small
    no_capacity,         ///< every place for packets that wait is taken
    unknown_source,      ///< sending: the source is no component of this transport
    unknown_peer,        ///< sending: the destination was not heard, and the medium has no group
    header_checksum,     ///< JSerial: the checksum of version and length is wrong
    packet_checksum,     ///< JSerial: the checksum of the message is wrong
    noise,               ///< JSerial: bytes outside of a frame, or a marker where none may be
};

/// The error in one line, for logs.
[[nodiscard]] constexpr std::string_view describe(transport_errc error) noexcept {
    switch (error) {
    case transport_errc::ok: return "ok";
    case transport_errc::truncated: return "truncated: fewer bytes than the header states";
    case transport_errc::wrong_size: return "wrong size: fewer bytes stated than the header has";
    case transport_errc::wrong_version: return "wrong version: the version byte is not 2 (AS5669A)";
    case transport_errc::unknown_type: return "unknown type: the message type is not 0";
    case transport_errc::compressed: return "compressed: the message has a compressed header, which is not supported";
    case transport_errc::invalid_source: return "invalid source: a part of the source ID is 0 or a wildcard";
    case transport_errc::invalid_destination: return "invalid destination: a part of the destination ID is 0";
    case transport_errc::not_one_component:
        return "not one component: a broadcast is neither acknowledged nor sent in several packets";
    case transport_errc::local_destination: return "local destination: the component is not behind the network";
    case transport_errc::no_message_id: return "no message ID: the payload has fewer than 2 bytes";
    case transport_errc::invalid_header: return "invalid header: a value is wider than its field, or not for sending";
    case transport_errc::too_large: return "too large: the message exceeds the packet size or the receiver's memory";
    case transport_errc::no_space: return "no space: the output buffer is too small";
    case transport_errc::no_capacity: return "no capacity: too many packets wait";
    case transport_errc::unknown_source: return "unknown source: no component of this transport has the source ID";
    case transport_errc::unknown_peer: return "unknown peer: nothing was received from the destination";
    case transport_errc::header_checksum: return "header checksum: version and length of the serial frame are damaged";
    case transport_errc::packet_checksum: return "packet checksum: the message of the serial frame is damaged";
    case transport_errc::noise: return "noise: bytes of the serial line that are no frame";
    }
    return "unknown error";
}

} // namespace jauscat::sae
