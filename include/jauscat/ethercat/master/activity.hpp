// Configuration of the master, results of a step of its state machines, timeouts.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/ethercat/master/master_errc.hpp>

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::ethercat {

using jauscat::time_point;

/// Timeouts and retries of the master.
struct master_config {
    /// A frame that is not back by now is lost, and asked for again.
    std::chrono::nanoseconds frame_timeout{std::chrono::milliseconds{20}};
    /// The longest time that a frame can be in transit. After a lost frame the next one is sent only after this time: a
    /// slave that gets a mailbox message after its successor executes it again, because it compares only with the last
    /// counter.
    std::chrono::nanoseconds frame_lifetime{std::chrono::milliseconds{20}};
    /// The link may deliver a frame twice, as an IP network may. Each frame is then given its lifetime, answered or
    /// not, which makes a transfer slow: leave it off on a wire.
    bool frames_may_be_copied{};
    /// How often a lost frame is repeated. With the default, a slave that is a process may be kept waiting for 0.2 s.
    unsigned retries{9};
    std::chrono::nanoseconds poll_interval{std::chrono::microseconds{50}}; ///< between two looks at what is not ready
    std::chrono::nanoseconds sii_timeout{std::chrono::milliseconds{100}};  ///< for one read of the SII
    std::chrono::nanoseconds state_timeout{std::chrono::seconds{5}};       ///< for one change of state
    std::chrono::nanoseconds mailbox_timeout{std::chrono::seconds{1}};     ///< for one mailbox request and its answer
    std::uint32_t logical_base{}; ///< where the process image begins; give the same to process_data
};

/// Next action of a state machine.
enum class progress : std::uint8_t {
    send, ///< the next frame at once
    wait, ///< the next frame after the poll interval
    done, ///< finished: see the result
};

/// The datagrams of a reply, in the order they were sent.
using replies = std::span<const datagram_view>;

/// Whether one slave has executed each of them, as commands to a station address want it. Errors: duplicate_station,
/// working_counter.
[[nodiscard]] constexpr master_result<> executed_by_one(replies datagrams) noexcept {
    for (const auto& datagram : datagrams) {
        if (datagram.working_counter > 1)
            return master_error{.code = master_errc::duplicate_station, .working_counter = datagram.working_counter};
        if (datagram.working_counter == 0) return master_error{.code = master_errc::working_counter};
    }
    return {};
}

/// Limits how long a state machine polls for one thing.
class timeout {
  public:
    /// Starts over: something else is waited for.
    constexpr void renew() noexcept { since_.reset(); }
    /// True once `limit` has passed since the first call after `renew`.
    constexpr bool expired(time_point now, std::chrono::nanoseconds limit) noexcept {
        if (!since_) since_ = now;
        return now - *since_ >= limit;
    }

  private:
    std::optional<time_point> since_{};
};

} // namespace jauscat::ethercat
