// An EtherCAT datagram: header, data, working counter. ETG.1000.4, clause 5.4.
#pragma once

#include <jauscat/wire/schema.hpp>

#include <cstdint>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::ethercat {

/// What a slave does with a datagram, and what it then adds to the working counter.
enum class command : std::uint8_t {
    nop = 0,   ///< no operation; +0
    aprd = 1,  ///< auto-increment read: the slave that receives ADP 0; +1
    apwr = 2,  ///< auto-increment write; +1
    aprw = 3,  ///< auto-increment read, then write; +1 and +2
    fprd = 4,  ///< configured-address read: the slave whose station address (or enabled alias) is ADP; +1
    fpwr = 5,  ///< configured-address write; +1
    fprw = 6,  ///< configured-address read, then write; +1 and +2
    brd = 7,   ///< broadcast read: bitwise or of all slaves; +1 each
    bwr = 8,   ///< broadcast write; +1 each
    brw = 9,   ///< broadcast read, then write; +1 and +2 each
    lrd = 10,  ///< logical read through FMMUs; +1
    lwr = 11,  ///< logical write through FMMUs; +1
    lrw = 12,  ///< logical read and write through FMMUs; +1 and +2
    armw = 13, ///< auto-increment: the addressed slave reads, all others write; +1 each
    frmw = 14, ///< configured address: the addressed slave reads, all others write; +1 each
};

/// Datagram header, 10 bytes. `length` bytes of data and a datagram_trailer follow.
struct datagram_header {
    command cmd{};          ///< reader or writer, and form of the address
    std::uint8_t index{};   ///< the master's tag, returned unchanged
    std::uint16_t adp{};    ///< position, station address, or low half of a logical address
    std::uint16_t ado{};    ///< offset in the slave's memory, or high half of a logical address
    std::uint16_t length{}; ///< bytes of data, 0 to 1486
    bool circulating{};     ///< set by a slave whose port 0 is closed: the ring is broken
    bool more{};            ///< another datagram follows in this frame
    std::uint16_t irq{};    ///< event request bits that the slaves or in

    struct schema : wire::items {
        using T = datagram_header;
        using type = layout<
            field<&T::cmd, enumeration<command, u8>>,
            field<&T::index, u8>,
            field<&T::adp, u16le>,
            field<&T::ado, u16le>,
            bit_fields<u16le,
                bit_field<&T::length, 11>,
                reserved<3>,
                bit_field<&T::circulating, 1>,
                bit_field<&T::more, 1>>,
            field<&T::irq, u16le>>;
    };
};

/// What follows a datagram's data, 2 bytes.
struct datagram_trailer {
    std::uint16_t working_counter{}; ///< number of slaves that executed the command, see `command`

    struct schema : wire::items {
        using T = datagram_trailer;
        using type = layout<field<&T::working_counter, u16le>>;
    };
};

} // namespace jauscat::ethercat
