// Text form of JAUS addresses: subsystem.node.component.instance, as in 1.1.33.1.
#pragma once

#include <jauscat/schema/jaus/header.hpp>

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace jauscat::net {

/// Reads `subsystem.node.component.instance`, four decimal numbers from 0 to 255. Nothing for any other text.
[[nodiscard]] inline std::optional<jaus::address> parse_jausip(std::string_view text) noexcept {
    std::array<std::uint8_t, 4> levels{};
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (i > 0 && (at == end || *at++ != '.')) return {};
        const auto [next, error] = std::from_chars(at, end, levels[i]);
        if (error != std::errc{}) return {};
        at = next;
    }
    if (at != end) return {};
    return jaus::address{.instance = levels[3], .component = levels[2], .node = levels[1], .subsystem = levels[0]};
}

/// Writes `subsystem.node.component.instance`.
inline std::string to_jausip(const jaus::address& address) {
    return std::to_string(address.subsystem) + '.' + std::to_string(address.node) + '.' +
           std::to_string(address.component) + '.' + std::to_string(address.instance);
}

} // namespace jauscat::net
