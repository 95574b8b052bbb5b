// Text of an error of the master.
#pragma once
#include <jauscat/ethercat/code_texts.hpp>
#include <jauscat/ethercat/master/master_errc.hpp>
#include <jauscat/text/hex.hpp>

#include <string>

namespace jauscat::text {

/// `object 0x1A1A:0: the slave aborted the transfer: ... (0x06020000)`: with the object, the sizes and the reason that
/// the error names.
[[nodiscard]] inline std::string explain(const ethercat::master_error& error) {
    using enum ethercat::master_errc;
    std::string text;
    if (error.index != 0) text += "object " + hex_number(error.index, 4) + ":" + std::to_string(error.subindex) + ": ";
    if (error.code == no_direction) text += "SyncManager " + std::to_string(error.sync_manager) + ": ";
    text += describe(error);
    if (error.code == size_mismatch || error.code == data_too_long)
        text +=
            " (" + std::to_string(error.bytes) + " bytes expected, " + std::to_string(error.found_bytes) + " found)";
    if (error.code == wrong_mapping) {
        const auto place = [](unsigned bits, unsigned first) {
            return bits == 0 ? std::string{"none"}
                             : std::to_string(bits) + " bits from bit " + std::to_string(first) + " on";
        };
        text += " (" + place(error.bits, error.first_bit) + " expected, " + place(error.found_bits, error.found_at) +
                " found)";
    }
    if (const auto reason = describe_reason(error); !reason.empty())
        text += ": " + std::string{reason} + " (" + hex_number(reason_code(error), 8) + ")";
    return text;
}

} // namespace jauscat::text
