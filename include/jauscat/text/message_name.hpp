// Names of messages.
#pragma once
#include <jauscat/schema/jaus/catalog.hpp>
#include <jauscat/text/hex.hpp>

#include <cstdint>
#include <string>

namespace jauscat::text {

/// The standard's name of a command code, or `command code 0x9999`.
[[nodiscard]] inline std::string message_name(std::uint16_t command_code) {
    const auto name = jaus::standard_name(command_code);
    return name.empty() ? "command code " + hex_number(command_code, 4) : std::string{name};
}

/// `0x4405 (Report Wrench Effort)`
[[nodiscard]] inline std::string code_text(std::uint16_t command_code) {
    auto text = hex_number(command_code, 4);
    if (const auto name = jaus::standard_name(command_code); !name.empty()) ((text += " (") += name) += ')';
    return text;
}

} // namespace jauscat::text
