// The Ethernet header and the EtherCAT frame header, which precede the datagrams. ETG.1000.4, clause 5.3.
#pragma once

#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::ethercat {

inline constexpr std::uint16_t ether_type_ethercat = 0x88A4; ///< EtherType of EtherCAT frames
inline constexpr std::uint16_t ether_type_vlan = 0x8100;     ///< EtherType of a VLAN tag (IEEE 802.1Q)
inline constexpr std::size_t min_frame_size = 60;            ///< bytes, without the frame check sequence
inline constexpr std::size_t max_frame_size = 1514;          ///< bytes, without the frame check sequence
inline constexpr std::size_t max_datagrams_size = 1498;      ///< bytes that all datagrams of a frame may take
inline constexpr std::size_t max_datagram_data = 1486;       ///< bytes of data that one datagram may carry

/// IEEE 802.3 header, 14 bytes. Slaves ignore the addresses; an EtherCAT slave controller sets bit 1 of the source's
/// first byte.
struct ethernet_header {
    std::array<std::byte, 6> destination{}; ///< any; mostly FF:FF:FF:FF:FF:FF
    std::array<std::byte, 6> source{};      ///< the master's interface
    std::uint16_t ether_type{};             ///< 88A4h: EtherCAT; 8100h: a vlan_tag follows

    struct schema : wire::items {
        using T = ethernet_header;
        using type = layout<
            field<&T::destination, octets<6>>,
            field<&T::source, octets<6>>,
            field<&T::ether_type, u16be>>;
    };
};

/// IEEE 802.1Q tag, 4 bytes, between the Ethernet header and what its EtherType announces.
struct vlan_tag {
    std::uint16_t control{};    ///< priority and number of the VLAN
    std::uint16_t ether_type{}; ///< of what follows

    struct schema : wire::items {
        using T = vlan_tag;
        using type = layout<
            field<&T::control, u16be>,
            field<&T::ether_type, u16be>>;
    };
};

/// What an EtherCAT frame carries.
enum class frame_type : std::uint8_t { datagrams = 1, network_variables = 4, mailbox_gateway = 5 };

/// EtherCAT frame header, 2 bytes.
struct frame_header {
    std::uint16_t length{}; ///< bytes of all datagrams, without this header and without padding; 0 to 2047
    frame_type type{};      ///< what it carries

    struct schema : wire::items {
        using T = frame_header;
        using type = layout<
            bit_fields<u16le,
                bit_field<&T::length, 11>,
                reserved<1>,
                bit_field<&T::type, 4>>>;
    };
};

} // namespace jauscat::ethercat
