// Headers before a payload in a capture: link layers, also of serial lines, IPv4, UDP, TCP.
#pragma once
#include <jauscat/schema/ethercat/frame.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>

namespace jausdump {

/// Linux cooked capture, version 1: 16 bytes.
struct cooked_header {
    std::uint16_t direction{};
    std::uint16_t hardware_type{};
    std::uint16_t address_size{};
    std::array<std::byte, 8> address{};
    std::uint16_t protocol{}; ///< an EtherType
};

/// Linux cooked capture, version 2: 20 bytes.
struct cooked_header_2 {
    std::uint16_t protocol{}; ///< an EtherType
    std::array<std::byte, 18> rest{};
};

/// What a record of the link type RTAC_SERIAL says; others report a change of the line's state.
enum class rtac_event : std::uint8_t { status_change, data_tx_start, data_rx_start, data_tx_end, data_rx_end };

/// RTAC_SERIAL: 12 bytes, then bytes of the serial line.
struct rtac_serial_header {
    std::uint32_t seconds{}, microseconds{};
    rtac_event event{};
    std::uint8_t control_lines{};
    std::uint16_t footer{};
};

/// IPv4, RFC 791: 20 bytes, then options.
struct ipv4_header {
    std::uint8_t words{}; ///< of this header with its options, each 4 bytes
    std::uint8_t version{};
    std::uint8_t service{};
    std::uint16_t total_size{}; ///< bytes with this header
    std::uint16_t identification{};
    std::uint16_t fragment_offset{}; ///< in units of 8 bytes
    bool more_fragments{};
    bool dont_fragment{};
    std::uint8_t time_to_live{};
    std::uint8_t protocol{};
    std::uint16_t checksum{};
    std::array<std::byte, 4> source{};
    std::array<std::byte, 4> destination{};
};

/// UDP, RFC 768: 8 bytes.
struct udp_header {
    std::uint16_t source_port{};
    std::uint16_t destination_port{};
    std::uint16_t size{}; ///< bytes with this header
    std::uint16_t checksum{};
};

/// TCP, RFC 9293: 20 bytes, then options.
struct tcp_header {
    std::uint16_t source_port{};
    std::uint16_t destination_port{};
    std::uint32_t sequence_number{};
    std::uint32_t acknowledged{};
    std::uint8_t unused{};
    std::uint8_t words{}; ///< of this header with its options, each 4 bytes
    bool finishes{};
    bool synchronises{};
    std::uint8_t other_flags{};
    std::uint16_t window{};
    std::uint16_t checksum{};
    std::uint16_t urgent{};
};

} // namespace jausdump

// One line per field.
// clang-format off
namespace jauscat {

template <> struct wire::schema<jausdump::cooked_header> {
    using T = jausdump::cooked_header;
    using type = layout<
        field<&T::direction, u16be>,
        field<&T::hardware_type, u16be>,
        field<&T::address_size, u16be>,
        field<&T::address, octets<8>>,
        field<&T::protocol, u16be>>;
};

template <> struct wire::schema<jausdump::cooked_header_2> {
    using T = jausdump::cooked_header_2;
    using type = layout<
        field<&T::protocol, u16be>,
        field<&T::rest, octets<18>>>;
};

template <> struct wire::schema<jausdump::ipv4_header> {
    using T = jausdump::ipv4_header;
    using type = layout<
        bit_fields<u8,
            bit_field<&T::words, 4>,
            bit_field<&T::version, 4>>,
        field<&T::service, u8>,
        field<&T::total_size, u16be>,
        field<&T::identification, u16be>,
        bit_fields<u16be,
            bit_field<&T::fragment_offset, 13>,
            bit_field<&T::more_fragments, 1>,
            bit_field<&T::dont_fragment, 1>,
            reserved<1>>,
        field<&T::time_to_live, u8>,
        field<&T::protocol, u8>,
        field<&T::checksum, u16be>,
        field<&T::source, octets<4>>,
        field<&T::destination, octets<4>>>;
};

template <> struct wire::schema<jausdump::udp_header> {
    using T = jausdump::udp_header;
    using type = layout<
        field<&T::source_port, u16be>,
        field<&T::destination_port, u16be>,
        field<&T::size, u16be>,
        field<&T::checksum, u16be>>;
};

template <> struct wire::schema<jausdump::rtac_serial_header> {
    using T = jausdump::rtac_serial_header;
    using type = layout<
        field<&T::seconds, u32be>,
        field<&T::microseconds, u32be>,
        field<&T::event, enumeration<jausdump::rtac_event, u8>>,
        field<&T::control_lines, u8>,
        field<&T::footer, u16be>>;
};

template <> struct wire::schema<jausdump::tcp_header> {
    using T = jausdump::tcp_header;
    using type = layout<
        field<&T::source_port, u16be>,
        field<&T::destination_port, u16be>,
        field<&T::sequence_number, u32be>,
        field<&T::acknowledged, u32be>,
        bit_fields<u8,
            bit_field<&T::unused, 4>,
            bit_field<&T::words, 4>>,
        bit_fields<u8,
            bit_field<&T::finishes, 1>,
            bit_field<&T::synchronises, 1>,
            bit_field<&T::other_flags, 6>>,
        field<&T::window, u16be>,
        field<&T::checksum, u16be>,
        field<&T::urgent, u16be>>;
};

} // namespace jauscat
