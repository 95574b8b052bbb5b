// Registers of an EtherCAT slave controller (ESC): addresses, and the layout of those a mailbox master uses.
// ETG.1000.4, clause 6; ET1100 data sheet, section II.
#pragma once

#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace jauscat::ethercat {

/// Where a register stands in a slave's memory, and its size in bytes.
struct esc_register {
    std::uint16_t address{};
    std::uint16_t size{};
};

namespace esc_registers {
inline constexpr esc_register type{0x0000, 1};
inline constexpr esc_register revision{0x0001, 1};
inline constexpr esc_register build{0x0002, 2};
inline constexpr esc_register fmmu_count{0x0004, 1};
inline constexpr esc_register sync_manager_count{0x0005, 1};
inline constexpr esc_register ram_size{0x0006, 1}; ///< KiB
inline constexpr esc_register ports{0x0007, 1};    ///< 2 bits per port: 0 none, 1 not configured, 2 EBUS, 3 MII
inline constexpr esc_register features{0x0008, 2};
inline constexpr esc_register station_address{0x0010, 2};
inline constexpr esc_register station_alias{0x0012, 2};
inline constexpr esc_register dl_control{0x0100, 4};
inline constexpr esc_register dl_status{0x0110, 2};
inline constexpr esc_register al_control{0x0120, 2};
inline constexpr esc_register al_status{0x0130, 2};
inline constexpr esc_register al_status_code{0x0134, 2};
inline constexpr esc_register pdi_control{0x0140, 2};
inline constexpr esc_register ecat_event_mask{0x0200, 2};
inline constexpr esc_register ecat_event_request{0x0210, 2};
inline constexpr esc_register error_counters{0x0300, 20}; ///< a write to any of them clears its group
inline constexpr esc_register sii_owner{0x0500, 1};
inline constexpr esc_register sii_control{0x0502, 2};
inline constexpr esc_register sii_address{0x0504, 4}; ///< in words
inline constexpr esc_register sii_data{0x0508, 8};
inline constexpr esc_register fmmu{0x0600, 16};        ///< FMMU 0; the next ones follow
inline constexpr esc_register sync_manager{0x0800, 8}; ///< SyncManager 0; the next ones follow
inline constexpr esc_register process_ram{0x1000, 0};  ///< mailboxes and process data; size by `ram_size`
} // namespace esc_registers

/// State of the application layer, in AL control and AL status.
enum class al_state : std::uint8_t { init = 1, pre_op = 2, boot = 3, safe_op = 4, op = 8 };

/// Why a slave did not take a state or left it. Other values occur: they pass through. ETG.1020, table 11.
enum class al_status_code : std::uint16_t {
    none = 0x0000,
    unspecified = 0x0001,
    no_memory = 0x0002,
    invalid_device_setup = 0x0003,
    invalid_revision = 0x0004,
    sii_mismatch = 0x0006,
    firmware_update = 0x0007,
    licence = 0x000E,
    invalid_state_change = 0x0011,
    unknown_state = 0x0012,
    boot_not_supported = 0x0013,
    no_firmware = 0x0014,
    mailbox_boot = 0x0015,
    mailbox_pre_op = 0x0016,
    sync_manager = 0x0017,
    no_inputs = 0x0018,
    no_outputs = 0x0019,
    synchronization = 0x001A,
    sync_manager_watchdog = 0x001B,
    sync_manager_types = 0x001C,
    output_configuration = 0x001D,
    input_configuration = 0x001E,
    watchdog_configuration = 0x001F,
    needs_cold_start = 0x0020,
    needs_init = 0x0021,
    needs_pre_op = 0x0022,
    needs_safe_op = 0x0023,
    input_mapping = 0x0024,
    output_mapping = 0x0025,
    inconsistent_settings = 0x0026,
    no_free_run = 0x0027,
    no_synchronization = 0x0028,
    needs_three_buffers = 0x0029,
    background_watchdog = 0x002A,
    no_valid_io = 0x002B,
    fatal_sync = 0x002C,
    no_sync = 0x002D,
    cycle_too_small = 0x002E,
    dc_sync_configuration = 0x0030,
    dc_latch_configuration = 0x0031,
    pll = 0x0032,
    dc_io = 0x0033,
    dc_timeout = 0x0034,
    dc_cycle_time = 0x0035,
    dc_sync0_cycle_time = 0x0036,
    dc_sync1_cycle_time = 0x0037,
    mailbox_aoe = 0x0041,
    mailbox_eoe = 0x0042,
    mailbox_coe = 0x0043,
    mailbox_foe = 0x0044,
    mailbox_soe = 0x0045,
    mailbox_voe = 0x004F,
    sii_no_access = 0x0050,
    sii_error = 0x0051,
    external_hardware = 0x0052,
    restarted_locally = 0x0060,
    device_id_updated = 0x0061,
    module_list = 0x0070,
    supply_voltage_low = 0x0080,
    supply_voltage_high = 0x0081,
    temperature_low = 0x0082,
    temperature_high = 0x0083,
    controller_available = 0x00F0,
};

/// A register of 2 bytes that is a plain number, such as the station address.
struct esc_word {
    std::uint16_t value{};
};

/// AL control (0x0120): the state a master asks for.
struct al_control {
    al_state state{};
    bool acknowledge{}; ///< clears an error indication
    bool request_device_id{};
};

/// AL status (0x0130) up to AL status code (0x0134), 6 bytes: one datagram reads both.
struct al_status {
    al_state state{};
    bool error{}; ///< the last request failed or the state was lost: see `code`
    bool device_id_loaded{};
    std::uint16_t gap{};
    al_status_code code{};
};

/// How a SyncManager hands memory over.
enum class sync_manager_mode : std::uint8_t { buffered = 0, mailbox = 2 };

/// Who writes a SyncManager's memory.
enum class sync_manager_direction : std::uint8_t { master_reads = 0, master_writes = 1 };

/// SyncManager (0x0800 + 8 n), 8 bytes.
struct sync_manager {
    std::uint16_t start{};
    std::uint16_t length{}; ///< bytes
    sync_manager_mode mode{};
    sync_manager_direction direction{};
    bool ecat_interrupt{};
    bool pdi_interrupt{};
    bool watchdog{};
    bool write_event{}; ///< status, read only: written completely
    bool read_event{};  ///< status, read only: read completely
    bool full{};        ///< status, read only: the mailbox holds a message
    std::uint8_t last_buffer{};
    std::uint8_t buffer_in_use{};
    bool enable{};
    bool repeat_request{}; ///< toggled by the master: give the last mailbox message again
    bool latch_ecat{};
    bool latch_pdi{};
    bool pdi_disable{};        ///< the slave has switched this SyncManager off
    bool repeat_acknowledge{}; ///< equals `repeat_request` once the slave has done so
};

/// SyncManagers 0 and 1 (0x0800), 16 bytes: one datagram configures a mailbox.
struct mailbox_managers {
    sync_manager out{}; ///< master to slave
    sync_manager in{};  ///< slave to master
};

/// The last three bytes of a SyncManager (0x0805 + 8 n): what polling and the repeat request need.
struct sync_manager_handshake {
    bool full{};
    bool enable{};
    bool repeat_request{};
    bool repeat_acknowledge{};
};

/// Activate byte of a SyncManager (0x0806 + 8 n).
struct sync_manager_activate {
    bool enable{};
    bool repeat_request{};
};

/// SII owner (0x0500).
struct sii_owner {
    bool pdi{};   ///< true gives the memory to the slave's application
    bool force{}; ///< takes it back whatever the application does
};

/// Command to the SII memory.
enum class sii_command : std::uint8_t { clear = 0, read = 1, write = 2, reload = 4 };

/// SII control (0x0502) and address (0x0504), 6 bytes: one datagram starts an access.
struct sii_request {
    bool write_enable{};
    bool eight_byte_reads{};  ///< read only: a read gives 8 bytes of data, else 4
    bool two_address_bytes{}; ///< read only: memory of more than 16 Kibit
    sii_command cmd{};
    bool checksum_error{};     ///< read only
    bool not_loaded{};         ///< read only
    bool command_error{};      ///< read only: no acknowledge, or a command it cannot do
    bool write_enable_error{}; ///< read only
    bool busy{};               ///< read only
    std::uint32_t address{};   ///< in words
};

/// SII control, address and data (0x0502 to 0x050F), 14 bytes: one datagram reads the outcome of an access.
struct sii_access {
    sii_request request{};
    std::array<std::byte, 8> data{};
};

} // namespace jauscat::ethercat

// One line per field, as in the standard's table.
// clang-format off
namespace jauscat {

template <> struct wire::schema<ethercat::esc_word> { using type = layout<field<&ethercat::esc_word::value, u16le>>; };

template <> struct wire::schema<ethercat::al_control> {
    using T = ethercat::al_control;
    using type = layout<
        bits<u16le,
            bit<&T::state, 4>,
            bit<&T::acknowledge, 1>,
            bit<&T::request_device_id, 1>,
            reserved<10>>>;
};

template <> struct wire::schema<ethercat::al_status> {
    using T = ethercat::al_status;
    using type = layout<
        bits<u16le,
            bit<&T::state, 4>,
            bit<&T::error, 1>,
            bit<&T::device_id_loaded, 1>,
            reserved<10>>,
        field<&T::gap, u16le>,
        field<&T::code, enumeration<ethercat::al_status_code, u16le>>>;
};

template <> struct wire::schema<ethercat::sync_manager> {
    using T = ethercat::sync_manager;
    using type = layout<
        field<&T::start, u16le>,
        field<&T::length, u16le>,
        bits<u8,
            bit<&T::mode, 2>,
            bit<&T::direction, 2>,
            bit<&T::ecat_interrupt, 1>,
            bit<&T::pdi_interrupt, 1>,
            bit<&T::watchdog, 1>,
            reserved<1>>,
        bits<u8,
            bit<&T::write_event, 1>,
            bit<&T::read_event, 1>,
            reserved<1>,
            bit<&T::full, 1>,
            bit<&T::last_buffer, 2>,
            bit<&T::buffer_in_use, 2>>,
        bits<u8,
            bit<&T::enable, 1>,
            bit<&T::repeat_request, 1>,
            reserved<4>,
            bit<&T::latch_ecat, 1>,
            bit<&T::latch_pdi, 1>>,
        bits<u8,
            bit<&T::pdi_disable, 1>,
            bit<&T::repeat_acknowledge, 1>,
            reserved<6>>>;
};

template <> struct wire::schema<ethercat::mailbox_managers> {
    using T = ethercat::mailbox_managers;
    using type = layout<
        nested<&T::out>,
        nested<&T::in>>;
};

template <> struct wire::schema<ethercat::sync_manager_handshake> {
    using T = ethercat::sync_manager_handshake;
    using type = layout<
        bits<u8,
            reserved<3>,
            bit<&T::full, 1>,
            reserved<4>>,
        bits<u8,
            bit<&T::enable, 1>,
            bit<&T::repeat_request, 1>,
            reserved<6>>,
        bits<u8,
            reserved<1>,
            bit<&T::repeat_acknowledge, 1>,
            reserved<6>>>;
};

template <> struct wire::schema<ethercat::sync_manager_activate> {
    using T = ethercat::sync_manager_activate;
    using type = layout<
        bits<u8,
            bit<&T::enable, 1>,
            bit<&T::repeat_request, 1>,
            reserved<6>>>;
};

template <> struct wire::schema<ethercat::sii_owner> {
    using T = ethercat::sii_owner;
    using type = layout<
        bits<u8,
            bit<&T::pdi, 1>,
            bit<&T::force, 1>,
            reserved<6>>>;
};

template <> struct wire::schema<ethercat::sii_request> {
    using T = ethercat::sii_request;
    using type = layout<
        bits<u16le,
            bit<&T::write_enable, 1>,
            reserved<5>,
            bit<&T::eight_byte_reads, 1>,
            bit<&T::two_address_bytes, 1>,
            bit<&T::cmd, 3>,
            bit<&T::checksum_error, 1>,
            bit<&T::not_loaded, 1>,
            bit<&T::command_error, 1>,
            bit<&T::write_enable_error, 1>,
            bit<&T::busy, 1>>,
        field<&T::address, u32le>>;
};

template <> struct wire::schema<ethercat::sii_access> {
    using T = ethercat::sii_access;
    using type = layout<
        nested<&T::request>,
        field<&T::data, octets<8>>>;
};

} // namespace jauscat
