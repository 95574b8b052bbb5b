// Counters of the datagrams at a socket.
#pragma once

#include <jauscat/net/config/verdict.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace jauscat::net {

/// Counts since the socket was opened. Every datagram that reached the socket is in one of the first nine, except
/// those without a message, which are in `errors`.
struct udp_counters {
    std::uint64_t received{};  ///< messages passed to the handler
    std::uint64_t dropped{};   ///< datagrams that the kernel dropped because the socket's buffer was full; updated by
                               ///< the next received datagram
    std::uint64_t oversize{};  ///< datagrams larger than the largest over IPv4
    std::uint64_t malformed{}; ///< refused by the filter: no valid JAUS header
    std::uint64_t unknown_peer{};     ///< refused by the filter: no system has this JAUS source
    std::uint64_t other_framing{};    ///< refused by the filter: of AS5669-2007, which the system is not configured for
    std::uint64_t other_generation{}; ///< refused by the filter: SAE JAUS, which the node does not take
    std::uint64_t wrong_sender{};     ///< refused by the filter: the JAUS source belongs to another address
    std::uint64_t rate_limited{};     ///< refused by the filter: above the rate limit of the peer

    std::uint64_t sent{};        ///< messages that the network accepted
    std::uint64_t would_block{}; ///< messages refused because a buffer was full
    std::uint64_t refused{};     ///< messages answered with an ICMP error: closed port, no route
    std::uint64_t errors{};      ///< all other failures, in both directions

    /// Counts a datagram by the gate's verdict.
    constexpr void count(verdict v) noexcept {
        switch (v) {
        case verdict::accepted: ++received; break;
        case verdict::malformed: ++malformed; break;
        case verdict::unknown_peer: ++unknown_peer; break;
        case verdict::other_framing: ++other_framing; break;
        case verdict::other_generation: ++other_generation; break;
        case verdict::wrong_sender: ++wrong_sender; break;
        case verdict::rate_limited: ++rate_limited; break;
        }
    }
    friend bool operator==(const udp_counters&, const udp_counters&) = default;
};

struct named_counter {
    std::string_view name{};
    std::uint64_t udp_counters::* value{}; ///< its member
};
/// All counters, the most useful first.
inline constexpr std::array udp_counter_list{named_counter{"received", &udp_counters::received},
                                             named_counter{"dropped", &udp_counters::dropped},
                                             named_counter{"oversize", &udp_counters::oversize},
                                             named_counter{"malformed", &udp_counters::malformed},
                                             named_counter{"unknown peer", &udp_counters::unknown_peer},
                                             named_counter{"other framing", &udp_counters::other_framing},
                                             named_counter{"other generation", &udp_counters::other_generation},
                                             named_counter{"wrong sender", &udp_counters::wrong_sender},
                                             named_counter{"rate-limited", &udp_counters::rate_limited},
                                             named_counter{"sent", &udp_counters::sent},
                                             named_counter{"would block", &udp_counters::would_block},
                                             named_counter{"refused", &udp_counters::refused},
                                             named_counter{"errors", &udp_counters::errors}};

/// The increase since `before`.
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
