// Text for the codes that a slave reports.
#pragma once

#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/coe.hpp>
#include <jauscat/schema/ethercat/mailbox.hpp>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace jauscat::ethercat {

namespace detail {

template <class Code> struct code_text {
    Code code;
    std::string_view text;
};

inline constexpr code_text<abort_code> abort_texts[]{
    {abort_code::none, "no abort"},
    {abort_code::toggle_bit, "toggle bit not alternated"},
    {abort_code::timeout, "SDO protocol timeout"},
    {abort_code::command_specifier, "command specifier unknown or not valid"},
    {abort_code::block_size, "invalid block size"},
    {abort_code::sequence_number, "invalid sequence number"},
    {abort_code::crc, "CRC error"},
    {abort_code::out_of_memory, "out of memory"},
    {abort_code::unsupported_access, "access to the object is not supported"},
    {abort_code::write_only, "the object can only be written"},
    {abort_code::read_only, "the object can only be read"},
    {abort_code::subindex_0_not_zero, "subindex cannot be written while subindex 0 is not 0: write 0 there first"},
    {abort_code::complete_access, "complete access is not supported for this object"},
    {abort_code::exceeds_mailbox, "the object is larger than the mailbox"},
    {abort_code::mapped_to_rx_pdo, "the object is mapped to an RxPDO: SDO download blocked"},
    {abort_code::no_object, "no such object in the dictionary"},
    {abort_code::not_mappable, "the object cannot be mapped into a PDO"},
    {abort_code::pdo_length, "the mapped objects would exceed the length of the PDO"},
    {abort_code::parameter_incompatible, "parameters are incompatible"},
    {abort_code::device_incompatible, "internal incompatibility of the device"},
    {abort_code::hardware, "access failed because of a hardware error"},
    {abort_code::length_mismatch, "data type or length does not match the object: a slave that takes exact sizes only "
                                  "needs the translation table's option fixed_length"},
    {abort_code::length_too_high, "data are longer than the object"},
    {abort_code::length_too_low, "data are shorter than the object"},
    {abort_code::no_subindex, "no such subindex in the object"},
    {abort_code::value_range, "value out of range"},
    {abort_code::value_too_high, "value too high"},
    {abort_code::value_too_low, "value too low"},
    {abort_code::module_list, "the configured modules do not match the detected ones"},
    {abort_code::max_below_min, "the maximum is below the minimum"},
    {abort_code::resource, "resource not available"},
    {abort_code::general, "general error"},
    {abort_code::cannot_store, "data cannot be transferred or stored"},
    {abort_code::local_control, "data cannot be transferred or stored because of local control"},
    {abort_code::device_state, "data cannot be transferred or stored in the present device state"},
    {abort_code::no_dictionary, "there is no object dictionary"},
    {abort_code::no_data, "no data available"},
};

inline constexpr code_text<al_status_code> al_status_texts[]{
    {al_status_code::none, "no error"},
    {al_status_code::unspecified, "unspecified error"},
    {al_status_code::no_memory, "no memory"},
    {al_status_code::invalid_device_setup, "invalid device setup"},
    {al_status_code::invalid_revision, "invalid revision"},
    {al_status_code::sii_mismatch, "SII does not match the firmware"},
    {al_status_code::firmware_update, "firmware update failed"},
    {al_status_code::licence, "licence error"},
    {al_status_code::invalid_state_change, "invalid requested state change"},
    {al_status_code::unknown_state, "unknown requested state"},
    {al_status_code::boot_not_supported, "bootstrap is not supported"},
    {al_status_code::no_firmware, "no valid firmware"},
    {al_status_code::mailbox_boot, "invalid mailbox configuration for bootstrap"},
    {al_status_code::mailbox_pre_op, "invalid mailbox configuration for PRE-OP"},
    {al_status_code::sync_manager, "invalid SyncManager configuration"},
    {al_status_code::no_inputs, "no valid inputs available"},
    {al_status_code::no_outputs, "no valid outputs"},
    {al_status_code::synchronization, "synchronization error"},
    {al_status_code::sync_manager_watchdog, "SyncManager watchdog"},
    {al_status_code::sync_manager_types, "invalid SyncManager types"},
    {al_status_code::output_configuration, "invalid output configuration"},
    {al_status_code::input_configuration, "invalid input configuration"},
    {al_status_code::watchdog_configuration, "invalid watchdog configuration"},
    {al_status_code::needs_cold_start, "needs a cold start"},
    {al_status_code::needs_init, "needs INIT"},
    {al_status_code::needs_pre_op, "needs PRE-OP"},
    {al_status_code::needs_safe_op, "needs SAFE-OP"},
    {al_status_code::input_mapping, "invalid input mapping"},
    {al_status_code::output_mapping, "invalid output mapping"},
    {al_status_code::inconsistent_settings, "inconsistent settings"},
    {al_status_code::no_free_run, "free run is not supported"},
    {al_status_code::no_synchronization, "synchronization is not supported"},
    {al_status_code::needs_three_buffers, "free run needs three buffers"},
    {al_status_code::background_watchdog, "background watchdog"},
    {al_status_code::no_valid_io, "no valid inputs and outputs"},
    {al_status_code::fatal_sync, "fatal synchronization error"},
    {al_status_code::no_sync, "no synchronization signal"},
    {al_status_code::cycle_too_small, "cycle time too small"},
    {al_status_code::dc_sync_configuration, "invalid DC SYNC configuration"},
    {al_status_code::dc_latch_configuration, "invalid DC latch configuration"},
    {al_status_code::pll, "PLL error"},
    {al_status_code::dc_io, "DC synchronization: input or output error"},
    {al_status_code::dc_timeout, "DC synchronization timeout"},
    {al_status_code::dc_cycle_time, "invalid DC cycle time"},
    {al_status_code::dc_sync0_cycle_time, "invalid DC SYNC0 cycle time"},
    {al_status_code::dc_sync1_cycle_time, "invalid DC SYNC1 cycle time"},
    {al_status_code::mailbox_aoe, "AoE mailbox error"},
    {al_status_code::mailbox_eoe, "EoE mailbox error"},
    {al_status_code::mailbox_coe, "CoE mailbox error"},
    {al_status_code::mailbox_foe, "FoE mailbox error"},
    {al_status_code::mailbox_soe, "SoE mailbox error"},
    {al_status_code::mailbox_voe, "VoE mailbox error"},
    {al_status_code::sii_no_access, "the application has no access to the SII"},
    {al_status_code::sii_error, "SII error"},
    {al_status_code::external_hardware, "external hardware is not ready"},
    {al_status_code::restarted_locally, "slave restarted locally"},
    {al_status_code::device_id_updated, "device identification updated"},
    {al_status_code::module_list, "the configured modules do not match the detected ones"},
    {al_status_code::supply_voltage_low, "supply voltage too low"},
    {al_status_code::supply_voltage_high, "supply voltage too high"},
    {al_status_code::temperature_low, "temperature too low"},
    {al_status_code::temperature_high, "temperature too high"},
    {al_status_code::controller_available, "application controller available"},
};

inline constexpr code_text<mailbox_error_code> mailbox_error_texts[]{
    {mailbox_error_code::none, "no error"},
    {mailbox_error_code::syntax, "syntax of the mailbox header is wrong"},
    {mailbox_error_code::unsupported_protocol, "the mailbox protocol is not supported"},
    {mailbox_error_code::invalid_channel, "the mailbox channel is wrong"},
    {mailbox_error_code::service_not_supported, "the service of the mailbox protocol is not supported"},
    {mailbox_error_code::invalid_header, "the header of the mailbox protocol is wrong"},
    {mailbox_error_code::size_too_short, "the mailbox message is too short"},
    {mailbox_error_code::no_more_memory, "no memory for the mailbox message"},
    {mailbox_error_code::invalid_size, "the size of the mailbox message is inconsistent"},
    {mailbox_error_code::service_in_work, "the mailbox service is still at work: retry, or restart the slave"},
};

template <class Code, std::size_t N>
[[nodiscard]] constexpr std::string_view text_of(const code_text<Code> (&texts)[N], Code code,
                                                 std::string_view unknown) noexcept {
    const auto found = std::ranges::find(texts, code, &code_text<Code>::code);
    return found != std::end(texts) ? found->text : unknown;
}

} // namespace detail

/// Unknown codes have a generic text; print the number beside it.
[[nodiscard]] constexpr std::string_view describe(abort_code code) noexcept {
    return detail::text_of(detail::abort_texts, code, "unknown abort code");
}

[[nodiscard]] constexpr std::string_view describe(al_state state) noexcept {
    switch (state) {
    case al_state::init: return "INIT";
    case al_state::pre_op: return "PRE-OP";
    case al_state::boot: return "BOOT";
    case al_state::safe_op: return "SAFE-OP";
    case al_state::op: return "OP";
    }
    return "an unknown state";
}

[[nodiscard]] constexpr std::string_view describe(al_status_code code) noexcept {
    return detail::text_of(detail::al_status_texts, code, "unknown AL status code");
}

[[nodiscard]] constexpr std::string_view describe(mailbox_error_code code) noexcept {
    return detail::text_of(detail::mailbox_error_texts, code, "unknown mailbox error");
}

} // namespace jauscat::ethercat
