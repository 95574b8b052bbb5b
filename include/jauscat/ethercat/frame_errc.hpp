// Errors of frames.
#pragma once

#include <cstdint>
#include <string_view>

namespace jauscat::ethercat {

enum class frame_errc : std::uint8_t {
    ok,
    too_short,           ///< the bytes end inside the Ethernet or the EtherCAT header
    not_ethercat,        ///< another EtherType
    not_datagrams,       ///< EtherCAT, but network variables or a mailbox gateway message
    length_beyond_frame, ///< the header announces more bytes than there are
    truncated_datagram,  ///< a datagram reaches beyond the announced length
    length_mismatch,     ///< the last datagram ends before the announced length
    empty,               ///< no datagram was added
    no_space,            ///< the output buffer or the frame is full
    field_out_of_range,  ///< a header field is wider than its bits
};

/// The error in one line, for logs.
[[nodiscard]] constexpr std::string_view describe(frame_errc error) noexcept {
    switch (error) {
    case frame_errc::ok: return "ok";
    case frame_errc::too_short: return "too short: the frame ends inside its headers";
    case frame_errc::not_ethercat: return "not EtherCAT: the EtherType is not 0x88A4";
    case frame_errc::not_datagrams: return "not datagrams: the EtherCAT frame is of another type than 1";
    case frame_errc::length_beyond_frame: return "length beyond frame: the header announces more bytes than arrived";
    case frame_errc::truncated_datagram: return "truncated datagram: a datagram reaches beyond the announced length";
    case frame_errc::length_mismatch: return "length mismatch: the datagrams end before the announced length";
    case frame_errc::empty: return "empty: a frame needs at least one datagram";
    case frame_errc::no_space: return "no space: the datagrams do not fit the buffer or an Ethernet frame";
    case frame_errc::field_out_of_range: return "field out of range: a header field is wider than its bits";
    }
    return "unknown error";
}

} // namespace jauscat::ethercat
