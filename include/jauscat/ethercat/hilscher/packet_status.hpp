// Maps the results of SDO services: packet status (ulSta), abort code, error of the master.
#pragma once

#include <jauscat/ethercat/master/master_errc.hpp>
#include <jauscat/schema/ethercat/hilscher.hpp>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace jauscat::hilscher {

namespace detail {

using ethercat::abort_code;
using ethercat::master_errc;
template <class Meaning> struct status_of_meaning {
    Meaning meaning{};
    packet_status status{};
};

// Paired by meaning: the API's manual lists the status codes, the EtherCAT standard the abort codes.
inline constexpr status_of_meaning<abort_code> abort_statuses[]{
    {abort_code::toggle_bit, packet_status::sdo_abort_toggle},
    {abort_code::timeout, packet_status::sdo_abort_timeout},
    {abort_code::command_specifier, packet_status::sdo_abort_command_specifier},
    {abort_code::block_size, packet_status::sdo_abort_block_size},
    {abort_code::sequence_number, packet_status::sdo_abort_sequence_number},
    {abort_code::crc, packet_status::sdo_abort_crc},
    {abort_code::out_of_memory, packet_status::sdo_abort_memory},
    {abort_code::unsupported_access, packet_status::sdo_abort_access},
    {abort_code::write_only, packet_status::sdo_abort_write_only},
    {abort_code::read_only, packet_status::sdo_abort_read_only},
    {abort_code::no_object, packet_status::sdo_abort_no_object},
    {abort_code::not_mappable, packet_status::sdo_abort_pdo_mapping},
    {abort_code::pdo_length, packet_status::sdo_abort_pdo_length},
    {abort_code::parameter_incompatible, packet_status::sdo_abort_parameter_incompatible},
    {abort_code::device_incompatible, packet_status::sdo_abort_internal_incompatible},
    {abort_code::hardware, packet_status::sdo_abort_hardware},
    {abort_code::length_mismatch, packet_status::sdo_abort_data_size},
    {abort_code::length_too_high, packet_status::sdo_abort_data_too_long},
    {abort_code::length_too_low, packet_status::sdo_abort_data_too_short},
    {abort_code::no_subindex, packet_status::sdo_abort_no_subindex},
    {abort_code::value_range, packet_status::sdo_abort_value_range},
    {abort_code::value_too_high, packet_status::sdo_abort_value_too_high},
    {abort_code::value_too_low, packet_status::sdo_abort_value_too_low},
    {abort_code::max_below_min, packet_status::sdo_abort_max_below_min},
    {abort_code::general, packet_status::sdo_abort_general},
    {abort_code::cannot_store, packet_status::sdo_abort_transfer},
    {abort_code::local_control, packet_status::sdo_abort_local_control},
    {abort_code::device_state, packet_status::sdo_abort_device_state},
    {abort_code::no_dictionary, packet_status::sdo_abort_no_dictionary},
};

// Statuses of the master's errors. Errors without a status become `fail`.
inline constexpr status_of_meaning<master_errc> master_statuses[]{
    {master_errc::ok, packet_status::ok},
    {master_errc::not_sent, packet_status::no_link},
    {master_errc::no_reply, packet_status::coe_frame_lost},
    {master_errc::timeout, packet_status::coe_timeout},
    {master_errc::no_slave, packet_status::coe_slave_not_addressable},
    {master_errc::wrong_station, packet_status::coe_invalid_slave_id},
    {master_errc::duplicate_station, packet_status::coe_working_counter_error},
    {master_errc::working_counter, packet_status::coe_working_counter_error},
    {master_errc::no_mailbox, packet_status::coe_no_mailbox_support},
    {master_errc::no_coe, packet_status::coe_no_coe_support},
    {master_errc::al_error, packet_status::coe_invalid_communication_state},
    {master_errc::state_timeout, packet_status::coe_invalid_communication_state},
    {master_errc::too_many_slaves, packet_status::coe_no_resource},
    {master_errc::busy, packet_status::service_in_use},
    {master_errc::not_configured, packet_status::invalid_communication_state},
    {master_errc::mailbox_full, packet_status::coe_timeout},
    {master_errc::mailbox_timeout, packet_status::coe_timeout},
    {master_errc::mailbox_error, packet_status::coe_invalid_access},
    {master_errc::unexpected_reply, packet_status::sdo_abort_command_specifier},
    {master_errc::toggle_bit, packet_status::sdo_abort_toggle},
    {master_errc::size_mismatch, packet_status::sdo_abort_data_size},
    {master_errc::data_too_long, packet_status::coe_slave_response_too_big},
    {master_errc::no_space, packet_status::coe_internal_error},
};

template <class Meaning, std::size_t N>
[[nodiscard]] constexpr packet_status status_for(const status_of_meaning<Meaning> (&statuses)[N], Meaning meaning,
                                                 packet_status otherwise) noexcept {
    const auto found = std::ranges::find(statuses, meaning, &status_of_meaning<Meaning>::meaning);
    return found != std::end(statuses) ? found->status : otherwise;
}

} // namespace detail

/// The status of an abort code; sdo_abort_unknown for codes without one, such as 06010003h.
[[nodiscard]] constexpr packet_status status_of(ethercat::abort_code code) noexcept {
    if (code == ethercat::abort_code::none) return packet_status::ok;
    return detail::status_for(detail::abort_statuses, code, packet_status::sdo_abort_unknown);
}

/// The status of an error of the master.
[[nodiscard]] constexpr packet_status status_of(const ethercat::master_error& error) noexcept {
    if (error.code == ethercat::master_errc::sdo_abort || error.code == ethercat::master_errc::clear_refused)
        return error.abort == ethercat::abort_code::none ? packet_status::sdo_abort_unknown : status_of(error.abort);
    return detail::status_for(detail::master_statuses, error.code, packet_status::fail);
}

/// The abort code of a status; `none` for sdo_abort_unknown and for statuses that are no abort.
[[nodiscard]] constexpr ethercat::abort_code abort_of(packet_status status) noexcept {
    using pair = detail::status_of_meaning<ethercat::abort_code>;
    const auto found = std::ranges::find(detail::abort_statuses, status, &pair::status);
    return found != std::end(detail::abort_statuses) ? found->meaning : ethercat::abort_code::none;
}

/// Unknown codes have a generic text; print the number beside it.
[[nodiscard]] constexpr std::string_view describe(packet_status status) noexcept {
    if (const auto code = abort_of(status); code != ethercat::abort_code::none) return ethercat::describe(code);
    switch (status) {
    case packet_status::ok: return "ok";
    case packet_status::fail: return "the service failed";
    case packet_status::out_of_memory: return "no memory for the packet";
    case packet_status::unknown_command: return "this packet command is not known";
    case packet_status::unknown_destination: return "ulDest names no receiver";
    case packet_status::unknown_destination_id: return "ulDestId names no receiver";
    case packet_status::invalid_packet_length: return "ulLen is not the length of such a packet";
    case packet_status::invalid_extension: return "ulExt is not valid in this packet";
    case packet_status::invalid_parameter: return "a parameter of the packet is out of range";
    case packet_status::unknown_handle: return "no slave has this handle";
    case packet_status::command_invalid: return "the EtherCAT master does not know this command";
    case packet_status::no_link: return "no link: check cable and interface";
    case packet_status::critical_error_state: return "the EtherCAT master has failed and needs a reset";
    case packet_status::wrong_internal_state: return "the EtherCAT master is not in a state for this service";
    case packet_status::coe_invalid_slave_id: return "no slave has this station address";
    case packet_status::coe_no_resource: return "the EtherCAT master has no resources for another transfer";
    case packet_status::coe_internal_error: return "internal error of the EtherCAT master's CoE service";
    case packet_status::coe_invalid_index: return "no slave has this position";
    case packet_status::coe_invalid_communication_state: return "CoE needs a slave that is at least in PRE-OP";
    case packet_status::coe_frame_lost: return "a frame was lost";
    case packet_status::coe_timeout: return "the slave did not answer in time";
    case packet_status::coe_slave_not_addressable: return "the slave is absent or has no power";
    case packet_status::coe_invalid_list_type: return "this object list does not exist";
    case packet_status::coe_slave_response_too_big: return "the data do not fit the packet, the mailbox or the buffer";
    case packet_status::coe_invalid_access_bit_mask: return "the access mask is not valid";
    case packet_status::coe_working_counter_error: return "working counter: not one slave executed the command";
    case packet_status::service_in_use: return "the EtherCAT master is busy with another request";
    case packet_status::invalid_communication_state: return "the bus is not in a state for this service";
    case packet_status::coe_invalid_access: return "the slave refuses CoE messages";
    case packet_status::coe_no_mailbox_support: return "the slave has no mailbox";
    case packet_status::coe_no_coe_support: return "the slave's mailbox does not carry CoE";
    case packet_status::state_change_busy: return "the EtherCAT master is busy with a change of state";
    case packet_status::invalid_target_phase: return "there is no such state";
    case packet_status::sdo_abort_unknown: return "the slave aborted with a code that has no status of its own";
    default: return "unknown status";
    }
}

} // namespace jauscat::hilscher
