// The application layer's states, why a slave refuses one, and the registers that carry both. ETG.1000.6, clause 6.4;
// ETG.1020.
#pragma once

#include <jauscat/wire/schema.hpp>

#include <cstdint>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::ethercat {

/// State of the application layer, in AL control and AL status.
enum class al_state : std::uint8_t { init = 1, pre_op = 2, boot = 3, safe_op = 4, op = 8 };

/// Whether it is one of them. A slave whose application has not started, or fails, may show any other value.
[[nodiscard]] constexpr bool is_known(al_state state) noexcept {
    return state == al_state::init || state == al_state::pre_op || state == al_state::boot ||
           state == al_state::safe_op || state == al_state::op;
}

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

/// AL control (0x0120): the state requested by a master.
struct al_control {
    al_state state{};         ///< the requested state
    bool acknowledge{};       ///< clears an error indication
    bool request_device_id{}; ///< requests the slave's identification in the AL status code

    struct schema : wire::items {
        using T = al_control;
        using type = layout<bit_fields<u16le, bit_field<&T::state, 4>, bit_field<&T::acknowledge, 1>,
                                       bit_field<&T::request_device_id, 1>, reserved<10>>>;
    };
};

/// AL status (0x0130) up to AL status code (0x0134), 6 bytes: one datagram reads both.
struct al_status {
    al_state state{};        ///< the state it is in
    bool error{};            ///< the last request failed or the state was lost: see `code`
    bool device_id_loaded{}; ///< the AL status code is the slave's identification
    std::uint16_t gap{};     ///< reserved
    al_status_code code{};

    struct schema : wire::items {
        using T = al_status;
        using type = layout<bit_fields<u16le, bit_field<&T::state, 4>, bit_field<&T::error, 1>,
                                       bit_field<&T::device_id_loaded, 1>, reserved<10>>,
                            field<&T::gap, u16le>, field<&T::code, enumeration<al_status_code, u16le>>>;
    };
};

} // namespace jauscat::ethercat
