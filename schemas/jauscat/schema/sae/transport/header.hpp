// The header of the SAE JAUS transport. AS5669A, general transport header: little endian, no padding.
#pragma once
#include <jauscat/wire/schema.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae {

/// A JAUS ID, written subsystem.node.component. Assignable: subsystem 1 to 65534, node and component 1 to 254. The
/// highest number of a part is its wildcard.
struct jaus_id {
    std::uint8_t component{};
    std::uint8_t node{};
    std::uint16_t subsystem{};
    friend constexpr bool operator==(const jaus_id&, const jaus_id&) = default;

    struct schema : wire::items {
        using T = jaus_id;
        using type = layout<
            field<&T::component, u8>,
            field<&T::node, u8>,
            field<&T::subsystem, u16le>>;
    };
};

/// Properties, bits 0 and 1.
enum class priority : std::uint8_t {
    low = 0,
    standard = 1,
    high = 2,
    safety_critical = 3,
};

/// Properties, bits 2 and 3. 3 has no meaning.
enum class broadcast : std::uint8_t {
    none = 0,
    local = 1,
    global = 2,
};

/// Properties, bits 4 and 5.
enum class acknowledgement : std::uint8_t {
    none = 0,    ///< no reply wanted
    request = 1, ///< reply wanted
    nak = 2,     ///< negative reply
    ack = 3,     ///< positive reply: no payload, the sequence number is that of the acknowledged packet
};

/// Properties, bits 6 and 7: the packet's place in a message of several packets.
enum class fragment_flag : std::uint8_t {
    single = 0,
    first = 1,
    middle = 2,
    last = 3,
};

/// Header compression, bits 6 and 7 of the first byte.
enum class compression : std::uint8_t {
    none = 0,
    proposed = 1,   ///< the message is complete; number and length say what the sender would like to leave out
    answered = 2,   ///< accepted or refused, by the length
    compressed = 3, ///< bytes are left out that the receiver remembers
};

/// 12 bytes in front of the payload. With header compression, compression_fields follow the size.
struct transport_header {
    std::uint8_t message_type{};        ///< 0: ordinary message; 1 to 32 are reserved
    sae::compression compression{};     ///< never sent
    std::uint16_t size{};               ///< bytes of the message: header, payload and sequence number
    sae::priority priority{sae::priority::standard}; ///< of the message
    sae::broadcast broadcast{};         ///< reach of the message
    sae::acknowledgement acknowledgement{}; ///< acknowledgement asked for or given
    sae::fragment_flag fragment_flag{}; ///< place in a message of several packets
    jaus_id destination{};              ///< may have wildcards
    jaus_id source{};                   ///< names one component
    friend constexpr bool operator==(const transport_header&, const transport_header&) = default;

    struct schema : wire::items {
        using T = transport_header;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::message_type, 6>,
                bit_field<&T::compression, 2>>,
            field<&T::size, u16le>,
            bit_fields<u8,
                bit_field<&T::priority, 2>,
                bit_field<&T::broadcast, 2>,
                bit_field<&T::acknowledgement, 2>,
                bit_field<&T::fragment_flag, 2>>,
            nested<&T::destination>,
            nested<&T::source>>;
    };
};

/// Two bytes behind the size, in a message with header compression.
struct compression_fields {
    std::uint8_t number{}; ///< under which the receiver remembers the bytes
    std::uint8_t length{}; ///< of the bytes at the front of the message that are left out
    friend constexpr bool operator==(const compression_fields&, const compression_fields&) = default;

    struct schema : wire::items {
        using T = compression_fields;
        using type = layout<
            field<&T::number, u8>,
            field<&T::length, u8>>;
    };
};

/// Two bytes behind the payload.
struct sequence_number {
    std::uint16_t value{}; ///< counted by each source, 0 after 65535; a repeated packet keeps it
    friend constexpr bool operator==(const sequence_number&, const sequence_number&) = default;

    struct schema : wire::items {
        using T = sequence_number;
        using type = layout<
            field<&T::value, u16le>>;
    };
};

} // namespace jauscat::sae
