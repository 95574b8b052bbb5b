// Decision on a received datagram, before its content is processed.
#pragma once

#include <cstdint>
#include <string_view>

namespace jauscat::net {

/// Decision on each datagram. All but `accepted` are dropped and not answered: their only effect is a counter.
enum class verdict : std::uint8_t {
    accepted,
    malformed,        ///< no valid JAUS header
    unknown_peer,     ///< no system of the configuration has its JAUS source
    wrong_sender,     ///< not from the address of the system that has its JAUS source
    rate_limited,     ///< more than the rate limit of its sender
    other_framing,    ///< of AS5669-2007, which the configuration does not have for its system
    other_generation, ///< of SAE JAUS, which the node does not take
};

[[nodiscard]] constexpr std::string_view describe(verdict v) noexcept {
    switch (v) {
    case verdict::accepted: return "accepted";
    case verdict::malformed: return "malformed: no JAUS header that could be answered";
    case verdict::unknown_peer: return "unknown peer: no system has the message's JAUS source";
    case verdict::other_framing:
        return "other framing: AS5669-2007; the system of the message's JAUS source needs framing=\"judp1\" in the"
               " configuration";
    case verdict::other_generation: return "other generation: SAE JAUS, which this node does not take";
    case verdict::wrong_sender: return "wrong sender: the message's JAUS source belongs to another system";
    case verdict::rate_limited: return "rate-limited: the peer sends too much";
    }
    return "unknown verdict";
}

} // namespace jauscat::net
