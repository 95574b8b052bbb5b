// Joins header, payload and sequence number to a message of AS5669A, and splits messages.
#pragma once
#include <jauscat/base/result.hpp>
#include <jauscat/sae/transport/errc.hpp>
#include <jauscat/sae/transport/jaus_id.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <array>
#include <span>

namespace jauscat::sae {

/// Bytes in front of the payload, behind it, and both.
inline constexpr std::size_t transport_header_size = wire::max_size<transport_header>;
inline constexpr std::size_t transport_trailer_size = wire::max_size<sequence_number>;
inline constexpr std::size_t transport_overhead = transport_header_size + transport_trailer_size;
/// Payload of a message whose size still fits the header.
inline constexpr std::size_t max_payload_size = 0xFFFF - transport_overhead;
/// Payload that known peers put into one packet.
inline constexpr std::size_t usual_payload_size = 4079;

/// Parts of a received message. `payload` points into the received bytes; that of an acknowledgement is empty.
struct split_transport_message {
    transport_errc error{};               ///< why it is no message to process
    transport_header header{};            ///< as received; `size` includes compression fields
    std::span<const std::byte> payload{}; ///< message ID first, unless the packet continues a message
    std::uint16_t sequence_number{};      ///< of the packet
    std::span<const std::byte> bytes{};   ///< the whole message; empty where its end is unknown
    std::span<const std::byte> rest{};    ///< the bytes behind it; empty where its end is unknown

    [[nodiscard]] constexpr explicit operator bool() const noexcept { return error == transport_errc::ok; }
};

namespace detail {
inline constexpr std::size_t bytes_before_compression_fields = 3;
inline constexpr std::size_t compression_size = wire::max_size<compression_fields>;
} // namespace detail

/// Splits the first message off `bytes`, which begin behind a medium's version byte. Errors: truncated and wrong_size,
/// where the end of the message is unknown; unknown_type, compressed, invalid_source, where `rest` has the next one.
///
/// A proposal of header compression is a complete message: its two bytes are skipped.
[[nodiscard]] constexpr split_transport_message split(std::span<const std::byte> bytes) noexcept {
    split_transport_message m{};
    const auto failed = [&m](transport_errc why) {
        m.error = why;
        return m;
    };
    if (bytes.size() < transport_header_size) return failed(transport_errc::truncated);
    static_cast<void>(wire::decode_prefix(m.header, bytes)); // the bytes suffice
    const std::size_t more = m.header.compression == compression::none ? 0 : detail::compression_size;
    const std::size_t size = m.header.size;
    if (size < transport_overhead + more) return failed(transport_errc::wrong_size);
    if (size > bytes.size()) return failed(transport_errc::truncated);
    m.bytes = bytes.first(size);
    m.rest = bytes.subspan(size);
    if (more != 0) {
        constexpr auto at = detail::bytes_before_compression_fields;
        std::array<std::byte, transport_header_size> plain{};
        std::ranges::copy(bytes.first(at), plain.begin());
        std::ranges::copy(bytes.subspan(at + more, plain.size() - at), plain.begin() + at);
        static_cast<void>(wire::decode(m.header, plain));
    }
    const std::size_t front = transport_header_size + more;
    m.payload = m.bytes.subspan(front, size - front - transport_trailer_size);
    sequence_number number{};
    static_cast<void>(wire::decode(number, m.bytes.last(transport_trailer_size)));
    m.sequence_number = number.value;
    if (m.header.message_type != 0) return failed(transport_errc::unknown_type);
    if (m.header.compression == compression::answered || m.header.compression == compression::compressed)
        return failed(transport_errc::compressed);
    if (!names_one_component(m.header.source)) return failed(transport_errc::invalid_source);
    return m;
}

/// Writes the message to the front of `out`, with the size taken from `payload`, and returns it. `payload` may lie
/// where it goes to. Errors: too_large, no_space, invalid_header (also for a message type and for header compression,
/// which are never sent), invalid_source, invalid_destination.
[[nodiscard]] constexpr result<std::span<std::byte>, transport_errc> join(transport_header head,
                                                                          std::span<const std::byte> payload,
                                                                          std::uint16_t number,
                                                                          std::span<std::byte> out) noexcept {
    if (payload.size() > max_payload_size) return transport_errc::too_large;
    const std::size_t size = transport_overhead + payload.size();
    if (out.size() < size) return transport_errc::no_space;
    if (head.message_type != 0 || head.compression != compression::none || head.broadcast > broadcast::global)
        return transport_errc::invalid_header;
    if (!names_one_component(head.source)) return transport_errc::invalid_source;
    if (has_zero(head.destination)) return transport_errc::invalid_destination;
    head.size = static_cast<std::uint16_t>(size);
    const auto place = out.subspan(transport_header_size, payload.size());
    if (place.data() != payload.data()) std::ranges::copy(payload, place.begin());
    if (!wire::encode(head, out)) return transport_errc::invalid_header;
    static_cast<void>(wire::encode(sequence_number{number}, out.subspan(size - transport_trailer_size)));
    return out.first(size);
}

/// Whether it is a reply to a packet, which is not acknowledged itself.
[[nodiscard]] constexpr bool is_acknowledgement(const transport_header& head) noexcept {
    return head.acknowledgement == acknowledgement::ack || head.acknowledgement == acknowledgement::nak;
}

/// The header of a reply (`how`) to a packet, from `self`; its sequence number is that of the packet.
[[nodiscard]] constexpr transport_header acknowledgement_of(const transport_header& request, const jaus_id& self,
                                                            acknowledgement how = acknowledgement::ack) noexcept {
    return {.priority = request.priority, .acknowledgement = how, .destination = request.source, .source = self};
}

} // namespace jauscat::sae
