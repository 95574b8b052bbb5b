// Options of a bridge for one link.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/bridge/delivery.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/clock_jobs.hpp>
#include <jauscat/ethercat/master/clock_record.hpp>
#include <jauscat/ethercat/master/process_object.hpp>
#include <jauscat/ethercat/master/sdo_options.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace jauscat::bridging {

/// A slave that components stand in front of.
struct slave_options {
    std::uint16_t position{};            ///< in the ring, from 0
    slave_identity identity{};           ///< subsystem, station address = JAUS node, instance
    bool cyclic{};                       ///< runs in OP: what fits its process data goes by them
    ethercat::identity_check expected{}; ///< another slave is not brought up
    std::uint8_t node{};                 ///< JAUS node of its components; 0: the station address
    /// SYNC signals of its distributed clock; none: it runs freely. Only of a cyclic slave, in a ring with memory for
    /// clocks. A SYNC0 cycle of 0 is the period.
    ethercat::sync_settings sync{};
    /// In PRE-OP already, by another job of the master: it is not brought up, also not after a loss.
    bool is_taken_over{};
    /// Get their places in the process data of a cyclic slave that no part uses, and stay in place.
    std::span<ethercat::process_object> objects{};
};

/// The times of a bridge. `at_rest_within` derives them from the one that counts.
struct bridge_options {
    ethercat::master_config master{};
    ethercat::download_options download{};
    /// Cycle time of the process data. 0: no cycles.
    duration period{};
    /// The system time of distributed clocks when the time here is 0, in ns since 2000-01-01.
    std::uint64_t system_time{};
    /// How distributed clocks are set up. Once the cycles bring the reference time, they do in place of drift frames.
    ethercat::clock_options clocks{};
    /// For how long a slave's clock may take to follow the reference clock, and the cycles to do so.
    duration clock_timeout{std::chrono::seconds{20}};
    /// A slave in OP without new outputs for so long stops by itself. Written to every cyclic slave, and read back.
    duration watchdog{};
    /// A slave is lost if its state has not been read in the cycles of this time; a cyclic slave also if it has not
    /// exchanged process data in OP in them. Time in which no cycle took place, because this program did not run, does
    /// not count.
    duration longest_silence{};
    /// The oldest inputs from which a query is answered, by the clock, and the time that a slave has to execute what is
    /// in its outputs.
    duration data_limit{};
    /// A part that is not able to come to rest by its ramp in this time is refused; see process_times. 0: not compared.
    duration rest_limit{};
    /// A part whose ramp would take longer is to stop in another way. 0: as its own options say.
    duration ramp_limit{};
    /// Interval between checks of the slaves' states, while no slave has process data.
    duration check_interval{};
    /// A Report Heartbeat Pulse is written to a slave by mailbox that has got no message for so long: it stops by
    /// itself when none comes. 0: never.
    duration keep_alive{};
    /// For the components: a controller that has been silent for so long is lost; see jaus::control_options.
    duration control_timeout{};
    /// Interval between attempts to bring a slave up.
    duration bring_up_interval{std::chrono::milliseconds{500}};
    /// Interval between attempts of a stop order that the slave refuses; see pending_stops.
    duration stop_interval{std::chrono::milliseconds{20}};
    /// A job of others for the same slave, or the transfers of other slaves where they occupy all lanes of the ring,
    /// may delay a stop order for so long; then one is cancelled. The slave of a cancelled transfer is lost.
    duration stop_timeout{std::chrono::milliseconds{50}};
    /// A message that still waits for its slave after so long is refused.
    duration order_timeout{std::chrono::milliseconds{500}};
};

/// Defaults of `limit` below.
inline constexpr std::chrono::milliseconds at_rest_by_mailbox{500};
inline constexpr std::chrono::milliseconds at_rest_in_cycles{100};

/// Options that bring an actuator to rest within `limit` after its controller, the link, the slave's state or this
/// program is lost; docs/safety.md has the sum of the times. `period`: of the process data, 0 for none; `limit` is at
/// least 4 of them. With process data a slave may be silent for 50 ms at most, or two periods.
[[nodiscard]] constexpr bridge_options at_rest_within(duration limit, duration period = {}) noexcept {
    constexpr auto second = duration{std::chrono::seconds{1}};
    return {.master = {.state_timeout = second, .mailbox_timeout = std::max<duration>(limit / 2, second / 4)},
            .period = period,
            .watchdog = limit / 10 * 9, // a slave takes time to notice that it has expired
            .longest_silence =
                period == duration{} ? limit / 5 * 3 : std::min<duration>(limit / 2, std::max(second / 20, 2 * period)),
            .data_limit = limit / 5 * 4,
            .rest_limit = limit,
            // The rest of the limit after the loss of a controller, without the cycles in which the slaves are told.
            .ramp_limit = std::max(limit / 10 * 3 - 2 * period, std::min<duration>(period, limit)),
            .check_interval = limit / 10,
            .keep_alive = std::min<duration>(limit / 5, second / 10),
            .control_timeout = limit / 10 * 7};
}

} // namespace jauscat::bridging
