// The JAUS message header. RA 3.3 part 2, message header: 16 bytes, little endian.
#pragma once
#include <jauscat/wire/schema.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::jaus {

/// A JAUS ID, written subsystem.node.component.instance. Each octet: 1 to 254, 255 for all of that level, 0 invalid.
struct address {
    std::uint8_t instance{};
    std::uint8_t component{};
    std::uint8_t node{};
    std::uint8_t subsystem{};
    friend constexpr bool operator==(const address&, const address&) = default;

    struct schema : wire::items {
        using T = address;
        using type = layout<
            field<&T::instance, u8>,
            field<&T::component, u8>,
            field<&T::node, u8>,
            field<&T::subsystem, u8>>;
    };
};

/// Message properties, bits 4 and 5.
enum class ack_nak : std::uint8_t {
    none = 0,    ///< no acknowledgement wanted
    request = 1, ///< acknowledgement wanted
    nak = 2,     ///< negative acknowledge response; no body
    ack = 3,     ///< acknowledge response; no body
};

/// Data control, bits 12 to 15: the packet's place in a large data set. Other values are reserved.
enum class data_flag : std::uint8_t {
    only = 0,     ///< only packet of a single-packet stream
    first = 1,    ///< first packet of a multi-packet stream
    middle = 2,   ///< normal packet between first and last
    repeated = 4, ///< retransmitted packet
    last = 8,     ///< last packet of a multi-packet stream
};

/// 16 bytes in front of every message body.
struct header {
    std::uint8_t priority{6};        ///< 0 lowest to 11 highest, 6 default; 12 to 15 safety critical
    jaus::ack_nak ack_nak{};         ///< acknowledgement asked for or given
    bool service_connection{};       ///< message of a service connection
    bool experimental{};             ///< message outside the standard
    std::uint8_t version{2};         ///< 0: RA 2.0 and 2.1, 1: 3.0 and 3.1, 2: 3.2 and 3.3
    std::uint8_t reserved{};         ///< 0 to 3; 0 in RA 3.3
    std::uint16_t command_code{};    ///< which message the body is
    address destination{};           ///< may use 255
    address source{};                ///< may not use 255
    std::uint16_t data_size{};       ///< bytes of body in this packet, at most 4080 by the RA (12 bits)
    jaus::data_flag data_flag{};     ///< place in a large data set
    std::uint16_t sequence_number{}; ///< 0 to 65535
    friend constexpr bool operator==(const header&, const header&) = default;

    struct schema : wire::items {
        using T = header;
        using type = layout<
            bit_fields<u16le,
                bit_field<&T::priority, 4>,
                bit_field<&T::ack_nak, 2>,
                bit_field<&T::service_connection, 1>,
                bit_field<&T::experimental, 1>,
                bit_field<&T::version, 6>,
                bit_field<&T::reserved, 2>>,
            field<&T::command_code, u16le>,
            nested<&T::destination>,
            nested<&T::source>,
            bit_fields<u16le,
                bit_field<&T::data_size, 12>,
                bit_field<&T::data_flag, 4>>,
            field<&T::sequence_number, u16le>>;
    };
};

/// Bytes of body that one packet may carry. RA 3.3 part 2, large data sets.
inline constexpr std::size_t max_body_size = 4080;

} // namespace jauscat::jaus
