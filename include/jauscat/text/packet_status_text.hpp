// Text of a confirmation packet.
#pragma once
#include <jauscat/ethercat/hilscher/packet_status.hpp>
#include <jauscat/text/hex.hpp>

namespace jauscat::text {

/// `no such object in the dictionary (ulSta 0xC0650031, abort code 0x06020000)`.
[[nodiscard]] inline std::string explain(hilscher::packet_status status) {
    const auto code = hilscher::abort_of(status);
    std::string text{hilscher::describe(status)};
    text += " (ulSta " + hex_number(static_cast<std::uint32_t>(status), 8);
    if (code != ethercat::abort_code::none) text += ", abort code " + hex_number(static_cast<std::uint32_t>(code), 8);
    return text + ")";
}

} // namespace jauscat::text
