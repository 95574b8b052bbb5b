// Names of messages.
#pragma once
#include <jauscat/schema/jaus/catalog.hpp>
#include <jauscat/text/hex.hpp>

#include <cstdint>
#include <string>

namespace jauscat::text {

/// The standard's name of a command code, or `command code 0x9999`.
[[nodiscard]] inline std::string message_name(std::uint16_t command_code) {
    for (const auto& entry : jaus::catalog)
        if (entry.command_code == command_code) return std::string{entry.name};
    return "command code " + hex_number(command_code, 4);
}

} // namespace jauscat::text
