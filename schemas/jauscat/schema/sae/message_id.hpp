// The message ID in front of each payload of SAE JAUS.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::sae {

/// Little-endian, in the first two bytes. Nothing where the payload has fewer: an acknowledgement has none.
[[nodiscard]] constexpr std::optional<std::uint16_t> message_id_of(std::span<const std::byte> payload) noexcept {
    if (payload.size() < sizeof(std::uint16_t)) return std::nullopt;
    return static_cast<std::uint16_t>(std::to_integer<unsigned>(payload[0]) | std::to_integer<unsigned>(payload[1])
                                                                                  << 8U);
}

} // namespace jauscat::sae
