// Decision on a received datagram, before its content is processed.
#pragma once

#include <cstdint>
#include <string_view>

namespace jauscat::net {

/// Decided for each datagram. Of all but `taken` nothing goes further and nothing is answered: whoever sends them can
/// make a node count, and nothing else.
enum class verdict : std::uint8_t {
    taken,
    malformed,    ///< it does not begin with a JAUS header that could be answered
    unknown_peer, ///< no peer of the configuration has its JAUS source
    wrong_sender, ///< a peer has its JAUS source, but it does not come from there
    rate_limited, ///< its peer has sent too much in too short a time
};

[[nodiscard]] constexpr std::string_view describe(verdict v) noexcept {
    switch (v) {
    case verdict::taken: return "taken";
    case verdict::malformed: return "malformed: no JAUS header that could be answered";
    case verdict::unknown_peer: return "unknown peer: no system has the message's JAUS source";
    case verdict::wrong_sender: return "wrong sender: the message's JAUS source is another's";
    case verdict::rate_limited: return "rate-limited: the peer sends too much";
    }
    return "unknown verdict";
}

} // namespace jauscat::net
