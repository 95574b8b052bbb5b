// How a bridge works with the slaves of one link.
#pragma once
#include <jauscat/ethercat/activity.hpp>
#include <jauscat/ethercat/delivery.hpp>
#include <jauscat/ethercat/sdo_options.hpp>

#include <chrono>
#include <cstdint>

namespace jauscat::bridge {

/// A slave that components stand in front of.
struct slave_options {
    std::uint16_t position{};            ///< in the ring, from 0
    ethercat::slave_identity identity{}; ///< subsystem, station address = JAUS node, instance
    bool cyclic{};                       ///< runs in OP: what fits its process data goes by them
};

/// The times of a bridge. Defaults bring an actuator to rest within 500 ms by mailbox and within 100 ms in cycles after
/// something is lost; docs/safety.md says how they add up.
struct bridge_options {
    ethercat::master_config master{.frame_timeout = std::chrono::milliseconds{20},
                                   .state_timeout = std::chrono::seconds{1},
                                   .mailbox_timeout = std::chrono::milliseconds{250}};
    ethercat::download_options download{};
    /// From one cycle of process data to the next. 0: no cycles.
    std::chrono::nanoseconds period{};
    /// A slave in OP without new outputs for so long stops by itself. Written to every cyclic slave, and read back.
    std::chrono::milliseconds watchdog{100};
    /// A cyclic slave that has not taken part in the exchange, in OP, for so long is lost.
    std::chrono::nanoseconds longest_silence{std::chrono::milliseconds{100}};
    /// A slave by mailbox that has not answered for so long is lost.
    std::chrono::nanoseconds longest_mailbox_silence{std::chrono::milliseconds{400}};
    /// From one look at the state of a slave by mailbox to the next.
    std::chrono::nanoseconds check_interval{std::chrono::milliseconds{100}};
    /// A Report Heartbeat Pulse is written to a slave by mailbox that has got no message for so long: it may stop when
    /// none comes. 0: never.
    std::chrono::nanoseconds keep_alive{std::chrono::milliseconds{100}};
    /// From one attempt to bring a slave up to the next.
    std::chrono::nanoseconds bring_up_interval{std::chrono::milliseconds{500}};
    /// From a stop order that a slave refuses to the next attempt.
    std::chrono::nanoseconds stop_interval{std::chrono::milliseconds{20}};
    /// A job of the master that stands in the way of a stop order for longer is given up.
    std::chrono::nanoseconds stop_patience{std::chrono::milliseconds{30}};
    /// A message that still waits for its slave after so long is refused.
    std::chrono::nanoseconds order_timeout{std::chrono::milliseconds{500}};
};

} // namespace jauscat::bridge
