// Outcome of a message at a component.
#pragma once
#include <cstdint>
#include <string_view>

namespace jauscat::jaus {

enum class message_outcome : std::uint8_t {
    unhandled, ///< not handled here
    handled,   ///< done, and answered where the standard has an answer; an ACK is due if it was requested
    refused,   ///< understood, but not done: a NAK is due if an acknowledgement was requested
    malformed, ///< its own, but the body does not decode; nothing was done, a NAK is due
    deferred,  ///< executed later; acknowledged by component::finish
};

/// The outcome in one line, for logs.
[[nodiscard]] constexpr std::string_view describe(message_outcome what) noexcept {
    switch (what) {
    case message_outcome::unhandled: return "not handled here";
    case message_outcome::handled: return "handled";
    case message_outcome::refused: return "refused";
    case message_outcome::malformed: return "malformed: the body does not decode";
    case message_outcome::deferred: return "deferred: executed and acknowledged later";
    }
    return "unknown";
}

} // namespace jauscat::jaus
