// Slave Information Interface (SII): the content of a slave's EEPROM. ETG.2010. Addresses are in words of 2 bytes.
#pragma once

#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::ethercat {

/// Word addresses of the fixed part, and of the first category.
namespace sii_words {
inline constexpr std::uint16_t configuration = 0x00; ///< what the slave controller loads at power-on
inline constexpr std::uint16_t station_alias = 0x04; ///< in the configuration
inline constexpr std::uint16_t identity = 0x08;      ///< vendor of the slave
inline constexpr std::uint16_t mailbox = 0x18;       ///< offsets, sizes and protocols of the standard mailbox
inline constexpr std::uint16_t size = 0x3E;          ///< of the memory
inline constexpr std::uint16_t categories = 0x40;    ///< the first category; each states the position of the next one
} // namespace sii_words

/// Words 0x00 to 0x07: what the slave controller loads at power-on, 16 bytes.
struct sii_configuration {
    std::uint16_t pdi_control{};         ///< kind of the interface to the slave's application
    std::uint16_t pdi_configuration{};   ///< settings of this interface
    std::uint16_t sync_impulse_length{}; ///< 10 ns
    std::uint16_t pdi_configuration_2{}; ///< more settings of this interface
    std::uint16_t station_alias{};       ///< a second station address; 0: none
    std::array<std::byte, 4> gap{};      ///< reserved
    std::uint16_t checksum{};            ///< low byte: CRC-8 of the 14 bytes before it, polynomial 0x07, start 0xFF

    struct schema : wire::items {
        using T = sii_configuration;
        using type = layout<
            field<&T::pdi_control, u16le>,
            field<&T::pdi_configuration, u16le>,
            field<&T::sync_impulse_length, u16le>,
            field<&T::pdi_configuration_2, u16le>,
            field<&T::station_alias, u16le>,
            field<&T::gap, octets<4>>,
            field<&T::checksum, u16le>>;
    };
};

/// Bytes of words 0x00 to 0x06: covered by the checksum, and copied to an ESI file.
inline constexpr std::size_t sii_configuration_checked = 14;

/// Words 0x08 to 0x0F: identity of the slave, 16 bytes.
struct sii_identity {
    std::uint32_t vendor{};   ///< number that the EtherCAT Technology Group gave the vendor; object 1018h:1
    std::uint32_t product{};  ///< the vendor's product code; object 1018h:2
    std::uint32_t revision{}; ///< object 1018h:3
    std::uint32_t serial{};   ///< object 1018h:4

    struct schema : wire::items {
        using T = sii_identity;
        using type = layout<
            field<&T::vendor, u32le>,
            field<&T::product, u32le>,
            field<&T::revision, u32le>,
            field<&T::serial, u32le>>;
    };
};

/// Words 0x18 to 0x1C: the standard mailbox, 10 bytes.
struct sii_mailbox {
    std::uint16_t receive_offset{}; ///< master to slave, SyncManager 0
    std::uint16_t receive_size{};   ///< bytes
    std::uint16_t send_offset{};    ///< slave to master, SyncManager 1
    std::uint16_t send_size{};      ///< bytes
    bool aoe{};                     ///< ADS over EtherCAT
    bool eoe{};                     ///< Ethernet over EtherCAT
    bool coe{};                     ///< CANopen over EtherCAT: SDOs
    bool foe{};                     ///< file access over EtherCAT
    bool soe{};                     ///< servo drive profile over EtherCAT
    bool voe{};                     ///< the vendor's own

    struct schema : wire::items {
        using T = sii_mailbox;
        using type = layout<
            field<&T::receive_offset, u16le>,
            field<&T::receive_size, u16le>,
            field<&T::send_offset, u16le>,
            field<&T::send_size, u16le>,
            bit_fields<u16le,
                bit_field<&T::aoe, 1>,
                bit_field<&T::eoe, 1>,
                bit_field<&T::coe, 1>,
                bit_field<&T::foe, 1>,
                bit_field<&T::soe, 1>,
                bit_field<&T::voe, 1>,
                reserved<10>>>;
    };
};

/// Words 0x3E and 0x3F, 4 bytes.
struct sii_size {
    std::uint16_t kibit{};   ///< size of the memory in Kibit, less 1
    std::uint16_t version{}; ///< 1

    struct schema : wire::items {
        using T = sii_size;
        using type = layout<
            field<&T::kibit, u16le>,
            field<&T::version, u16le>>;
    };
};

/// Kinds of categories. 1 to 9 are the device's own.
enum class sii_category : std::uint16_t {
    device_specific = 1,
    strings = 10,
    general = 30,
    fmmu = 40,
    sync_manager = 41,
    fmmu_extension = 42, ///< FMMUX
    sync_unit = 43,
    tx_pdo = 50,
    rx_pdo = 51,
    dc = 60,
    end = 0xFFFF,
};

/// Header of a category, 4 bytes; its data follow.
struct sii_category_header {
    sii_category category{}; ///< what the data are
    std::uint16_t words{};   ///< length of the data

    struct schema : wire::items {
        using T = sii_category_header;
        using type = layout<
            field<&T::category, enumeration<sii_category, u16le>>,
            field<&T::words, u16le>>;
    };
};

/// Category general, 32 bytes.
struct sii_general {
    std::uint8_t group{};              ///< index of a string, from 1; 0: none
    std::uint8_t image{};              ///< index of a string
    std::uint8_t order{};              ///< index of a string
    std::uint8_t name{};               ///< index of a string
    std::uint8_t gap{};                ///< reserved
    bool sdo{};                        ///< takes SDOs
    bool sdo_information{};            ///< answers SDO information
    bool pdo_assign{};                 ///< objects 1C12h and 1C13h can be written
    bool pdo_configuration{};          ///< PDO mapping objects can be written
    bool upload_at_start{};            ///< a master is to read the mapping when it starts
    bool complete_access{};            ///< takes a whole object in one transfer
    std::uint8_t foe{};                ///< file access; 0: no
    std::uint8_t eoe{};                ///< Ethernet; 0: no
    std::array<std::byte, 3> soe{};    ///< servo drive profile: channels
    std::uint8_t flags{};              ///< bit 0: SAFE-OP is enabled; bit 1: no LRW
    std::int16_t ebus_current{};       ///< mA
    std::array<std::byte, 2> gap_2{};  ///< reserved
    std::uint16_t ports{};             ///< 4 bits per port: 0 none, 1 MII, 3 EBUS
    std::array<std::byte, 14> gap_3{}; ///< reserved

    struct schema : wire::items {
        using T = sii_general;
        using type = layout<
            field<&T::group, u8>,
            field<&T::image, u8>,
            field<&T::order, u8>,
            field<&T::name, u8>,
            field<&T::gap, u8>,
            bit_fields<u8,
                bit_field<&T::sdo, 1>,
                bit_field<&T::sdo_information, 1>,
                bit_field<&T::pdo_assign, 1>,
                bit_field<&T::pdo_configuration, 1>,
                bit_field<&T::upload_at_start, 1>,
                bit_field<&T::complete_access, 1>,
                reserved<2>>,
            field<&T::foe, u8>,
            field<&T::eoe, u8>,
            field<&T::soe, octets<3>>,
            field<&T::flags, u8>,
            field<&T::ebus_current, i16le>,
            field<&T::gap_2, octets<2>>,
            field<&T::ports, u16le>,
            field<&T::gap_3, octets<14>>>;
    };
};

/// Bit of `sii_general::flags`: the slave does not execute LRW.
inline constexpr std::uint8_t sii_no_lrw = 0x02;

/// Bits of `sii_sync_manager::enable`.
namespace sii_enable {
inline constexpr std::uint8_t enabled = 0x01;
inline constexpr std::uint8_t virtual_manager = 0x04; ///< not switched on: an FMMU alone maps what is at its place
} // namespace sii_enable

/// What a SyncManager of category SyncM is for.
enum class sii_sync_manager_use : std::uint8_t { none = 0, mailbox_out = 1, mailbox_in = 2, outputs = 3, inputs = 4 };

/// One entry of category SyncM, 8 bytes.
struct sii_sync_manager {
    std::uint16_t start{};      ///< where its memory begins
    std::uint16_t length{};     ///< bytes
    std::uint8_t control{};     ///< as in the SyncManager's register
    std::uint8_t status{};      ///< not used
    std::uint8_t enable{};      ///< bit 0: enabled; bit 2: virtual, there are only registers or memory behind it
    sii_sync_manager_use use{}; ///< what it is for; none: the control byte says its direction

    struct schema : wire::items {
        using T = sii_sync_manager;
        using type = layout<
            field<&T::start, u16le>,
            field<&T::length, u16le>,
            field<&T::control, u8>,
            field<&T::status, u8>,
            field<&T::enable, u8>,
            field<&T::use, enumeration<sii_sync_manager_use, u8>>>;
    };
};

/// What an FMMU of category FMMU is for: one byte each, in the order of the FMMUs.
enum class sii_fmmu_use : std::uint8_t { none = 0, outputs = 1, inputs = 2, mailbox_state = 3 };

/// Head of a category TxPDO or RxPDO, 8 bytes; its entries follow, and then the next PDO.
struct sii_pdo {
    std::uint16_t index{};          ///< 1600h to 17FFh outputs, 1A00h to 1BFFh inputs
    std::uint8_t entries{};         ///< how many follow
    std::uint8_t sync_manager{};    ///< that carries it from the start; 255: none
    std::uint8_t synchronization{}; ///< number of a DC setting
    std::uint8_t name{};            ///< index of a string
    std::uint16_t flags{};          ///< such as: mandatory, fixed

    struct schema : wire::items {
        using T = sii_pdo;
        using type = layout<
            field<&T::index, u16le>,
            field<&T::entries, u8>,
            field<&T::sync_manager, u8>,
            field<&T::synchronization, u8>,
            field<&T::name, u8>,
            field<&T::flags, u16le>>;
    };
};

/// One entry of a PDO, 8 bytes.
struct sii_pdo_entry {
    std::uint16_t index{};    ///< of the object; 0: a gap
    std::uint8_t subindex{};  ///< of the object
    std::uint8_t name{};      ///< index of a string
    std::uint8_t data_type{}; ///< of `data_types`
    std::uint8_t bits{};      ///< of its value
    std::uint16_t flags{};    ///< reserved

    struct schema : wire::items {
        using T = sii_pdo_entry;
        using type = layout<
            field<&T::index, u16le>,
            field<&T::subindex, u8>,
            field<&T::name, u8>,
            field<&T::data_type, u8>,
            field<&T::bits, u8>,
            field<&T::flags, u16le>>;
    };
};

/// One mode of category DC, 24 bytes: how a distributed clock may synchronize the slave.
struct sii_clock_mode {
    std::uint32_t cycle_time_0{};    ///< ns, of SYNC0; 0: a multiple of the bus cycle
    std::int32_t shift_time_0{};     ///< ns, of SYNC0
    std::int32_t shift_time_1{};     ///< ns, of SYNC1
    std::int16_t cycle_factor_1{};   ///< of SYNC1, in cycles of SYNC0
    std::uint16_t assign_activate{}; ///< registers 0980h and 0981h
    std::int16_t cycle_factor_0{};   ///< of SYNC0, in cycles of the bus
    std::uint8_t name{};             ///< index of a string
    std::uint8_t description{};      ///< index of a string
    std::array<std::byte, 4> gap{};  ///< reserved

    struct schema : wire::items {
        using T = sii_clock_mode;
        using type = layout<
            field<&T::cycle_time_0, u32le>,
            field<&T::shift_time_0, i32le>,
            field<&T::shift_time_1, i32le>,
            field<&T::cycle_factor_1, i16le>,
            field<&T::assign_activate, u16le>,
            field<&T::cycle_factor_0, i16le>,
            field<&T::name, u8>,
            field<&T::description, u8>,
            field<&T::gap, octets<4>>>;
    };
};

} // namespace jauscat::ethercat
