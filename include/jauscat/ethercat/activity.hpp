// What the master's state machines share: times, results of a step, and what is known of a slave.
#pragma once

#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/ethercat/master_errc.hpp>
#include <jauscat/schema/ethercat/coe.hpp>
#include <jauscat/schema/ethercat/sii.hpp>

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::ethercat {

/// Time since any epoch, as the caller counts it.
using time_point = std::chrono::nanoseconds;

/// How long a master waits, and how often it tries.
struct master_config {
    /// A frame that is not back by now is lost. Choose it at least as long as a frame can be under way: a mailbox
    /// message that reaches a slave after its successor would be executed again.
    std::chrono::nanoseconds frame_timeout{std::chrono::milliseconds{20}};
    /// How often a lost frame is repeated. With the default, a slave that is a process may be kept waiting for 0.2 s.
    unsigned retries{9};
    std::chrono::nanoseconds poll_interval{std::chrono::microseconds{50}}; ///< between two looks at what is not ready
    std::chrono::nanoseconds sii_timeout{std::chrono::milliseconds{100}};  ///< for one read of the SII
    std::chrono::nanoseconds state_timeout{std::chrono::seconds{5}};       ///< for one change of state
    std::chrono::nanoseconds mailbox_timeout{std::chrono::seconds{1}};     ///< for one mailbox request and its answer
};

/// How a state machine goes on after a reply.
enum class progress : std::uint8_t {
    send, ///< the next frame at once
    wait, ///< the next frame after the poll interval
    done, ///< finished: see the outcome
};

/// The datagrams of a reply, in the order they were sent.
using replies = std::span<const datagram_view>;

/// What the master knows of a slave that it has brought up.
struct slave_record {
    std::uint16_t position{}; ///< in the ring, from 0
    std::uint16_t station{};  ///< configured station address
    sii_identity identity{};
    sii_mailbox mailbox{};
    std::uint8_t last_counter{};       ///< of the last mailbox request; 0: none yet
    std::uint8_t last_reply_counter{}; ///< of the last mailbox message received
    std::uint8_t abandoned_counter{};  ///< of a request that was given up: its answer may still come
    bool drained{};                    ///< no old message waits in the reply mailbox
    /// Of a transfer in segments that was given up and not yet aborted: sent before the next one.
    std::optional<sdo_abort> unfinished{};
};

/// Limits how long a state machine polls for one thing.
class patience {
  public:
    /// Starts over: something else is waited for.
    constexpr void renew() noexcept { since_.reset(); }
    /// True once `limit` has passed since the first call after `renew`.
    constexpr bool exhausted(time_point now, std::chrono::nanoseconds limit) noexcept {
        if (!since_) since_ = now;
        return now - *since_ >= limit;
    }

  private:
    std::optional<time_point> since_{};
};

} // namespace jauscat::ethercat
