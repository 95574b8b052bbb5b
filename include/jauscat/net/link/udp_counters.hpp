// Counters of the datagrams at a socket.
#pragma once

#include <jauscat/net/config/verdict.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

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

    /// Counts a datagram by what the gate said of it.
    constexpr void count(verdict v) noexcept {
        switch (v) {
        case verdict::taken: ++received; break;
        case verdict::malformed: ++malformed; break;
        case verdict::unknown_peer: ++unknown_peer; break;
        case verdict::wrong_sender: ++wrong_sender; break;
        case verdict::rate_limited: ++rate_limited; break;
        }
    }
    friend bool operator==(const udp_counters&, const udp_counters&) = default;
};

struct named_counter {
    std::string_view name{};
    std::uint64_t udp_counters::* value{}; ///< where it stands
};
/// All counters, in the order in which people want them.
inline constexpr std::array udp_counter_list{named_counter{"received", &udp_counters::received},
                                             named_counter{"dropped", &udp_counters::dropped},
                                             named_counter{"oversize", &udp_counters::oversize},
                                             named_counter{"malformed", &udp_counters::malformed},
                                             named_counter{"unknown peer", &udp_counters::unknown_peer},
                                             named_counter{"wrong sender", &udp_counters::wrong_sender},
                                             named_counter{"rate-limited", &udp_counters::rate_limited},
                                             named_counter{"sent", &udp_counters::sent},
                                             named_counter{"would block", &udp_counters::would_block},
                                             named_counter{"refused", &udp_counters::refused},
                                             named_counter{"errors", &udp_counters::errors}};

/// What has happened since `before`.
constexpr udp_counters operator-(udp_counters now, const udp_counters& before) noexcept {
    for (const auto& counter : udp_counter_list) now.*counter.value -= before.*counter.value;
    return now;
}

/// "received 12, wrong sender 3": those that are not 0, in one line, for logs; "nothing" if all are.
inline std::string summary(const udp_counters& counts) {
    std::string line;
    for (const auto& [name, value] : udp_counter_list)
        if (counts.*value != 0)
            line += (line.empty() ? "" : ", ") + std::string{name} + ' ' + std::to_string(counts.*value);
    return line.empty() ? "nothing" : line;
}

} // namespace jauscat::net
