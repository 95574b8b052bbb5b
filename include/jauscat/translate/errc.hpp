// Errors of translation.
#pragma once
#include <cstdint>
#include <string_view>

namespace jauscat::translate {

/// Why a translation was refused. `ok` is zero.
enum class errc : std::uint8_t {
    ok,
    truncated,                ///< fewer bytes than the header, or than the packet says it has
    no_space,                 ///< the output span is smaller than the result
    wrong_size,               ///< the size that a header states, or that an object has, is not the size of what came
    too_large,                ///< more bytes than one packet carries, or than the object under fixed_length has
    unknown_command_code,     ///< the code has no rank in the table's list
    unknown_index,            ///< the object index stands for no component
    unknown_subindex,         ///< the subindex stands for no command code
    reserved_value,           ///< a value (a data flag, a sequence position) that the standard reserves
    out_of_range,             ///< a packet's value does not fit the JAUS field it belongs to
    wrong_packet,             ///< a field that this table fixes has another value: not a packet of this table
    fragment_to_slave,        ///< delivery: part of a large data set; reassemble it first
    broadcast_names_no_slave, ///< delivery: the destination node is 255 or 0
    no_capacity,              ///< process image: too many commands wait for their acknowledgement
    actuator_not_ready,       ///< process data: an emergency, a fault, or no current inputs of a drive
};

/// The error in one line, for logs.
[[nodiscard]] constexpr std::string_view describe(errc error) noexcept {
    switch (error) {
    case errc::ok: return "ok";
    case errc::truncated: return "truncated: shorter than its header says";
    case errc::no_space: return "no space: the output buffer is too small";
    case errc::wrong_size: return "wrong size: the size in the header is not the size of the data";
    case errc::too_large: return "too large: the data does not fit one SDO packet or its object";
    case errc::unknown_command_code: return "unknown command code: it has no rank in this table";
    case errc::unknown_index: return "unknown index: no component has this object";
    case errc::unknown_subindex: return "unknown subindex: no command code has this rank";
    case errc::reserved_value: return "reserved value in the data flag or the packet's sequence position";
    case errc::out_of_range: return "out of range: a packet field exceeds the JAUS field it stands for";
    case errc::wrong_packet: return "wrong packet: not an SDO download request of this table";
    case errc::fragment_to_slave: return "cannot be delivered: part of a large data set, reassemble it first";
    case errc::broadcast_names_no_slave: return "cannot be delivered: the destination node names no slave";
    case errc::no_capacity: return "no capacity: too many commands wait for their acknowledgement";
    case errc::actuator_not_ready: return "the actuator is not ready: an emergency, a fault, or a drive is silent";
    }
    return "unknown error";
}

} // namespace jauscat::translate
