// Registers of an EtherCAT slave controller (ESC): addresses, and the layout of those a master uses. dc_registers.hpp
// has those of the distributed clock. ETG.1000.4, clause 6; ET1100 data sheet, section II.
#pragma once

#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/error_counters.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::ethercat {

/// Address of a register in a slave's memory, and its size in bytes.
struct esc_register {
    std::uint16_t address{}; ///< in the slave's memory
    std::uint16_t size{};    ///< bytes
};

/// A register whose bytes have the layout of `Value`: frame_builder::read and write, and basic_datagram::value, take
/// it.
template <class Value> struct esc_register_of : esc_register {
    using value_type = Value;
};
/// The `n`-th of several registers that follow each other, from 0.
template <class Value>
[[nodiscard]] constexpr esc_register_of<Value> nth(const esc_register_of<Value>& first, std::size_t n) noexcept {
    return {{static_cast<std::uint16_t>(first.address + n * first.size), first.size}};
}

struct esc_word;
struct esc_description;
struct dl_status;
struct sync_manager;
struct mailbox_managers;
struct sync_manager_handshake;
struct sync_manager_activate;
struct fmmu;
struct sii_owner;
struct sii_request;
struct sii_access;

/// By address. Where a register stands twice, it is read or written with those that follow it.
namespace esc_registers {
inline constexpr esc_register_of<esc_description> description{{0x0000, 10}}; ///< `type` to `features`
inline constexpr esc_register type{0x0000, 1};                               ///< kind of the slave controller
inline constexpr esc_register revision{0x0001, 1};                           ///< of the slave controller
inline constexpr esc_register build{0x0002, 2};                              ///< of the slave controller
inline constexpr esc_register fmmu_count{0x0004, 1};                         ///< how many FMMUs it has
inline constexpr esc_register sync_manager_count{0x0005, 1};                 ///< how many SyncManagers it has
inline constexpr esc_register ram_size{0x0006, 1};                           ///< KiB
inline constexpr esc_register ports{0x0007, 1};    ///< 2 bits per port: 0 none, 1 not configured, 2 EBUS, 3 MII
inline constexpr esc_register features{0x0008, 2}; ///< what it can do: see esc_description
inline constexpr esc_register_of<esc_word> station_address{{0x0010, 2}}; ///< by which a master addresses it
inline constexpr esc_register_of<esc_word> station_alias{{0x0012, 2}};   ///< a second one, out of the SII
inline constexpr esc_register station_addresses{0x0010, 4};              ///< both of them
inline constexpr esc_register dl_control{0x0100, 4}; ///< which ports are open, and whether the alias counts
inline constexpr esc_register_of<ethercat::dl_status> dl_status{{0x0110, 2}};   ///< which ports have a link
inline constexpr esc_register_of<ethercat::al_control> al_control{{0x0120, 2}}; ///< the state requested by a master
inline constexpr esc_register_of<ethercat::al_status> al_status{
    {0x0130, 6}};                                        ///< the state it is in, up to `al_status_code`
inline constexpr esc_register al_status_code{0x0134, 2}; ///< the reason if it is not in the requested state
inline constexpr esc_register_of<esc_word> pdi_control{
    {0x0140, 2}};                                            ///< kind of the interface to the slave's application
inline constexpr esc_register ecat_event_mask{0x0200, 2};    ///< which events go into the datagrams' `irq`
inline constexpr esc_register ecat_event_request{0x0210, 2}; ///< the events there are
inline constexpr esc_register_of<ethercat::error_counters> error_counters{
    {0x0300, 20}}; ///< a write to any of them clears its group
inline constexpr esc_register_of<ethercat::sii_owner> sii_owner{{0x0500, 1}};     ///< owner of the SII memory
inline constexpr esc_register_of<ethercat::sii_request> sii_request{{0x0502, 6}}; ///< command, status and address
inline constexpr esc_register_of<ethercat::sii_access> sii_access{{0x0502, 14}};  ///< the same and the data
inline constexpr esc_register sii_control{0x0502, 2};                             ///< command and status of an access
inline constexpr esc_register sii_address{0x0504, 4};                             ///< in words
inline constexpr esc_register sii_data{0x0508, 8};                                ///< 4 or 8 bytes of it
inline constexpr esc_register_of<ethercat::fmmu> fmmu{{0x0600, 16}};              ///< FMMU 0; the next ones follow
inline constexpr esc_register_of<ethercat::sync_manager> sync_manager{
    {0x0800, 8}}; ///< SyncManager 0; the next ones follow
inline constexpr esc_register_of<ethercat::mailbox_managers> mailbox_managers{{0x0800, 16}}; ///< SyncManagers 0 and 1
inline constexpr esc_register digital_outputs{0x0F00, 4}; ///< of a controller without an application behind it
inline constexpr esc_register process_ram{0x1000, 0}; ///< mailboxes and process data; size by `ram_size`
} // namespace esc_registers

/// Status, activate and PDI control of SyncManager `n`.
[[nodiscard]] constexpr esc_register_of<sync_manager_handshake> sync_manager_handshake_of(std::size_t n) noexcept {
    return {{static_cast<std::uint16_t>(nth(esc_registers::sync_manager, n).address + 5), 3}};
}
/// Activate byte of SyncManager `n`.
[[nodiscard]] constexpr esc_register_of<sync_manager_activate> sync_manager_activate_of(std::size_t n) noexcept {
    return {{static_cast<std::uint16_t>(nth(esc_registers::sync_manager, n).address + 6), 1}};
}

/// A register of 2 bytes that is a plain number, such as the station address.
struct esc_word {
    std::uint16_t value{}; ///< the number

    struct schema : wire::items { using type = layout<field<&esc_word::value, u16le>>; };
};

/// What a slave controller can do (0x0000 to 0x0009), 10 bytes.
struct esc_description {
    std::uint8_t type{};          ///< kind of the slave controller
    std::uint8_t revision{};      ///< of the slave controller
    std::uint16_t build{};        ///< of the slave controller
    std::uint8_t fmmus{};         ///< how many it has
    std::uint8_t sync_managers{}; ///< how many it has
    std::uint8_t ram{};           ///< KiB
    std::uint8_t ports{};         ///< 2 bits per port: 0 none, 1 not configured, 2 EBUS, 3 MII
    bool byte_fmmu{};             ///< FMMUs map whole bytes only
    bool dc{};                    ///< distributed clocks
    bool dc_64{};                 ///< these have 64 bits, else 32
    bool ebus_low_jitter{};       ///< EBUS ports
    bool ebus_link_detection{};   ///< enhanced, of EBUS ports
    bool mii_link_detection{};    ///< enhanced, of MII ports
    bool separate_fcs_errors{};   ///< frames with a wrong check sequence are counted separately
    bool dc_sync_activation{};    ///< bits 3 to 7 of `dc_activation`; without it the clock may have no SYNC unit
    bool no_lrw{};                ///< LRW is not supported
    bool no_read_write{};         ///< BRW, APRW and FPRW are not supported
    bool fixed{};                 ///< FMMUs and SyncManagers cannot be changed

    struct schema : wire::items {
        using T = esc_description;
        using type = layout<
            field<&T::type, u8>,
            field<&T::revision, u8>,
            field<&T::build, u16le>,
            field<&T::fmmus, u8>,
            field<&T::sync_managers, u8>,
            field<&T::ram, u8>,
            field<&T::ports, u8>,
            bit_fields<u16le,
                bit_field<&T::byte_fmmu, 1>,
                reserved<1>,
                bit_field<&T::dc, 1>,
                bit_field<&T::dc_64, 1>,
                bit_field<&T::ebus_low_jitter, 1>,
                bit_field<&T::ebus_link_detection, 1>,
                bit_field<&T::mii_link_detection, 1>,
                bit_field<&T::separate_fcs_errors, 1>,
                bit_field<&T::dc_sync_activation, 1>,
                bit_field<&T::no_lrw, 1>,
                bit_field<&T::no_read_write, 1>,
                bit_field<&T::fixed, 1>,
                reserved<4>>>;
    };
};

/// State of one port of a slave (in DL status).
struct dl_port {
    bool link{};          ///< a cable with a signal
    bool closed{};        ///< frames do not leave here: they go on to the next port
    bool communication{}; ///< the link carries frames

    /// A slave, or the master, is connected here.
    [[nodiscard]] constexpr bool is_open() const noexcept { return !closed && communication; }
    friend constexpr bool operator==(const dl_port&, const dl_port&) noexcept = default;
};

/// DL status (0x0110), 2 bytes.
struct dl_status {
    bool pdi_operational{};         ///< the slave's application has loaded its SII
    bool pdi_watchdog_ok{};         ///< the application runs
    bool enhanced_link_detection{}; ///< is on
    bool link_0{}, link_1{}, link_2{}, link_3{};
    bool closed_0{}, communication_0{};
    bool closed_1{}, communication_1{};
    bool closed_2{}, communication_2{};
    bool closed_3{}, communication_3{};

    /// By port number, 0 to 3.
    [[nodiscard]] constexpr std::array<dl_port, 4> ports() const noexcept {
        return {{{link_0, closed_0, communication_0},
                 {link_1, closed_1, communication_1},
                 {link_2, closed_2, communication_2},
                 {link_3, closed_3, communication_3}}};
    }

    struct schema : wire::items {
        using T = dl_status;
        using type = layout<
            bit_fields<u16le,
                bit_field<&T::pdi_operational, 1>,
                bit_field<&T::pdi_watchdog_ok, 1>,
                bit_field<&T::enhanced_link_detection, 1>,
                reserved<1>,
                bit_field<&T::link_0, 1>,
                bit_field<&T::link_1, 1>,
                bit_field<&T::link_2, 1>,
                bit_field<&T::link_3, 1>,
                bit_field<&T::closed_0, 1>,
                bit_field<&T::communication_0, 1>,
                bit_field<&T::closed_1, 1>,
                bit_field<&T::communication_1, 1>,
                bit_field<&T::closed_2, 1>,
                bit_field<&T::communication_2, 1>,
                bit_field<&T::closed_3, 1>,
                bit_field<&T::communication_3, 1>>>;
    };
};

/// How a SyncManager hands memory over.
enum class sync_manager_mode : std::uint8_t { buffered = 0, mailbox = 2 };

/// Writer of a SyncManager's memory.
enum class sync_manager_direction : std::uint8_t { master_reads = 0, master_writes = 1 };

/// SyncManager (0x0800 + 8 n), 8 bytes.
struct sync_manager {
    std::uint16_t start{};              ///< where its memory begins
    std::uint16_t length{};             ///< bytes
    sync_manager_mode mode{};           ///< buffered for process data, or a mailbox
    sync_manager_direction direction{}; ///< writer of the memory
    bool ecat_interrupt{};              ///< an access is an event for the master
    bool pdi_interrupt{};               ///< an access is an event for the slave's application
    bool watchdog{};                    ///< a write restarts the process data watchdog
    bool write_event{};                 ///< status, read only: written completely
    bool read_event{};                  ///< status, read only: read completely
    bool full{};                        ///< status, read only: the mailbox holds a message
    std::uint8_t last_buffer{};         ///< status, read only: the buffer that was written last
    std::uint8_t buffer_in_use{};       ///< status, read only: buffers in use
    bool enable{};                      ///< without it the memory has no rules
    bool repeat_request{};              ///< toggled by the master: give the last mailbox message again
    bool latch_ecat{};                  ///< a master's access latches an event
    bool latch_pdi{};                   ///< the application's access latches an event
    bool pdi_disable{};                 ///< the slave has switched this SyncManager off
    bool repeat_acknowledge{};          ///< equals `repeat_request` once the slave has done so

    struct schema : wire::items {
        using T = sync_manager;
        using type = layout<
            field<&T::start, u16le>,
            field<&T::length, u16le>,
            bit_fields<u8,
                bit_field<&T::mode, 2>,
                bit_field<&T::direction, 2>,
                bit_field<&T::ecat_interrupt, 1>,
                bit_field<&T::pdi_interrupt, 1>,
                bit_field<&T::watchdog, 1>,
                reserved<1>>,
            bit_fields<u8,
                bit_field<&T::write_event, 1>,
                bit_field<&T::read_event, 1>,
                reserved<1>,
                bit_field<&T::full, 1>,
                bit_field<&T::last_buffer, 2>,
                bit_field<&T::buffer_in_use, 2>>,
            bit_fields<u8,
                bit_field<&T::enable, 1>,
                bit_field<&T::repeat_request, 1>,
                reserved<4>,
                bit_field<&T::latch_ecat, 1>,
                bit_field<&T::latch_pdi, 1>>,
            bit_fields<u8,
                bit_field<&T::pdi_disable, 1>,
                bit_field<&T::repeat_acknowledge, 1>,
                reserved<6>>>;
    };
};

/// SyncManagers 0 and 1 (0x0800), 16 bytes: one datagram configures a mailbox.
struct mailbox_managers {
    sync_manager out{}; ///< master to slave
    sync_manager in{};  ///< slave to master

    struct schema : wire::items {
        using T = mailbox_managers;
        using type = layout<
            nested<&T::out>,
            nested<&T::in>>;
    };
};

/// The last three bytes of a SyncManager (0x0805 + 8 n): what polling and the repeat request need.
struct sync_manager_handshake {
    bool full{};               ///< the mailbox holds a message
    bool enable{};             ///< the SyncManager is on
    bool repeat_request{};     ///< toggled by the master: give the last mailbox message again
    bool repeat_acknowledge{}; ///< equals `repeat_request` once the slave has done so

    struct schema : wire::items {
        using T = sync_manager_handshake;
        using type = layout<
            bit_fields<u8,
                reserved<3>,
                bit_field<&T::full, 1>,
                reserved<4>>,
            bit_fields<u8,
                bit_field<&T::enable, 1>,
                bit_field<&T::repeat_request, 1>,
                reserved<6>>,
            bit_fields<u8,
                reserved<1>,
                bit_field<&T::repeat_acknowledge, 1>,
                reserved<6>>>;
    };
};

/// Activate byte of a SyncManager (0x0806 + 8 n).
struct sync_manager_activate {
    bool enable{};         ///< the SyncManager is on
    bool repeat_request{}; ///< toggled by the master: give the last mailbox message again

    struct schema : wire::items {
        using T = sync_manager_activate;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::enable, 1>,
                bit_field<&T::repeat_request, 1>,
                reserved<6>>>;
    };
};

/// FMMU (0x0600 + 16 n), 16 bytes: maps some bits of the logical address space to the slave's memory.
struct fmmu {
    std::uint32_t logical_start{};  ///< where it begins in the logical address space
    std::uint16_t length{};         ///< bytes of the logical address space
    std::uint8_t first_bit{};       ///< in the first byte, 0 to 7
    std::uint8_t last_bit{};        ///< in the last byte, 0 to 7
    std::uint16_t physical_start{}; ///< where the memory begins
    std::uint8_t physical_bit{};    ///< in its first byte, 0 to 7
    bool read{};                    ///< a master may read
    bool write{};                   ///< a master may write
    bool enable{};                  ///< without it nothing is mapped

    struct schema : wire::items {
        using T = fmmu;
        using type = layout<
            field<&T::logical_start, u32le>,
            field<&T::length, u16le>,
            bit_fields<u8,
                bit_field<&T::first_bit, 3>,
                reserved<5>>,
            bit_fields<u8,
                bit_field<&T::last_bit, 3>,
                reserved<5>>,
            field<&T::physical_start, u16le>,
            bit_fields<u8,
                bit_field<&T::physical_bit, 3>,
                reserved<5>>,
            bit_fields<u8,
                bit_field<&T::read, 1>,
                bit_field<&T::write, 1>,
                reserved<6>>,
            bit_fields<u32le,
                bit_field<&T::enable, 1>,
                reserved<31>>>;
    };
};

/// SII owner (0x0500).
struct sii_owner {
    bool pdi{};   ///< true gives the memory to the slave's application
    bool force{}; ///< revokes it regardless of the application

    struct schema : wire::items {
        using T = sii_owner;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::pdi, 1>,
                bit_field<&T::force, 1>,
                reserved<6>>>;
    };
};

/// Command to the SII memory.
enum class sii_command : std::uint8_t { clear = 0, read = 1, write = 2, reload = 4 };

/// SII control (0x0502) and address (0x0504), 6 bytes: one datagram starts an access.
struct sii_request {
    bool write_enable{};       ///< has to be set in the write that has a write command
    bool eight_byte_reads{};   ///< read only: a read gives 8 bytes of data, else 4
    bool two_address_bytes{};  ///< read only: memory of more than 16 Kibit
    sii_command cmd{};         ///< what to do
    bool checksum_error{};     ///< read only
    bool not_loaded{};         ///< read only
    bool command_error{};      ///< read only: no acknowledge, or a command it cannot do
    bool write_enable_error{}; ///< read only
    bool busy{};               ///< read only
    std::uint32_t address{};   ///< in words

    struct schema : wire::items {
        using T = sii_request;
        using type = layout<
            bit_fields<u16le,
                bit_field<&T::write_enable, 1>,
                reserved<5>,
                bit_field<&T::eight_byte_reads, 1>,
                bit_field<&T::two_address_bytes, 1>,
                bit_field<&T::cmd, 3>,
                bit_field<&T::checksum_error, 1>,
                bit_field<&T::not_loaded, 1>,
                bit_field<&T::command_error, 1>,
                bit_field<&T::write_enable_error, 1>,
                bit_field<&T::busy, 1>>,
            field<&T::address, u32le>>;
    };
};

/// SII control, address and data (0x0502 to 0x050F), 14 bytes: one datagram reads the outcome of an access.
struct sii_access {
    sii_request request{};           ///< command, status and address
    std::array<std::byte, 8> data{}; ///< 4 or 8 bytes that were read, or 2 to be written

    struct schema : wire::items {
        using T = sii_access;
        using type = layout<
            nested<&T::request>,
            field<&T::data, octets<8>>>;
    };
};

} // namespace jauscat::ethercat
