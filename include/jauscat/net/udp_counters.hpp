// What became of the datagrams at a socket: back-pressure and refusals, in numbers.
#pragma once

#include <jauscat/net/verdict.hpp>

#include <cstdint>

namespace jauscat::net {

/// Counts since the socket was opened. Every datagram that reached the socket is in one of the first seven, except
/// those in `errors` that held no message.
struct udp_counters {
    std::uint64_t received{};  ///< messages given to the handler
    std::uint64_t dropped{};   ///< datagrams that the kernel dropped because the socket's buffer was full; known with
                               ///< the next datagram that is received
    std::uint64_t oversize{};  ///< datagrams larger than the largest over IPv4
    std::uint64_t malformed{}; ///< refused by the filter: no JAUS header that could be answered
    std::uint64_t unknown_peer{}; ///< refused by the filter: nobody of that JAUS source is known
    std::uint64_t wrong_sender{}; ///< refused by the filter: the JAUS source is another's
    std::uint64_t rate_limited{}; ///< refused by the filter: more than the peer may send

    std::uint64_t sent{};        ///< messages that the network took
    std::uint64_t would_block{}; ///< messages that it did not take because its buffers were full
    std::uint64_t refused{};     ///< messages that a peer's machine or a router sent back: closed port, no way
    std::uint64_t errors{};      ///< everything else that failed, either way

    constexpr void count(verdict v) noexcept {
        switch (v) {
        case verdict::taken: ++received; break;
        case verdict::malformed: ++malformed; break;
        case verdict::unknown_peer: ++unknown_peer; break;
        case verdict::wrong_sender: ++wrong_sender; break;
        case verdict::rate_limited: ++rate_limited; break;
        }
    }
};

} // namespace jauscat::net
