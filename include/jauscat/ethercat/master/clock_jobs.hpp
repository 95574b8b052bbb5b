// The master's jobs for distributed clocks: what they need, and what they give.
#pragma once

#include <jauscat/ethercat/master/clock_record.hpp>
#include <jauscat/ethercat/master/clock_topology.hpp>
#include <jauscat/ethercat/master/master_errc.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// How clocks are set up.
struct clock_options {
    clock_delay_options delay{};
    /// Frames that bring the reference time to all slaves, one right after the other, so that they learn their drift.
    unsigned drift_frames{15'000};
    /// The largest difference from the reference clock, in ns, that counts as settled.
    std::uint32_t limit{1'000};
    /// While a clock is off by more than the limit, so many times a tenth of the frames follows.
    unsigned repeats{10};
};

/// What set_up_clocks has found.
struct clock_network {
    std::uint16_t reference{};       ///< station address of the reference clock
    clock_width reference_width{};   ///< of its time
    std::size_t clocks{};            ///< slaves with a clock
    std::uint16_t working_counter{}; ///< of a frame that brings the reference time to all slaves
    std::uint32_t difference{};      ///< the largest one from the reference clock, in ns
};

/// Measures delays, sets offsets and lets all clocks follow the reference clock, the first slave that has one. The
/// slaves have station addresses and are in INIT or PRE-OP, except those whose record says `runs`. `slaves` are those
/// of the whole ring, in the order of their positions; what is found is in them then. Errors: wrong_station,
/// duplicate_station, working_counter, no_clock, clock_topology, clock_delay, clock_unsettled.
struct set_up_clocks {
    std::span<clock_record> slaves{};
    std::uint64_t system_time{}; ///< of the master now, in ns since 2000-01-01: what the clocks will count from
    clock_options options{};
    using result_type = master_result<clock_network>;
};

/// Switches SYNC signals on as each record's `sync` says, all starting at multiples of their periods since 2000 plus
/// their shifts. For slaves in PRE-OP, after set_up_clocks; the cycles with the reference time should run. Gives the
/// earliest start time; each slave's is in its record. Errors: duplicate_station, working_counter, no_clock, sync_late.
struct start_sync {
    std::span<clock_record> slaves{}; ///< as set_up_clocks has left them
    /// Of the master now, in ns since 2000-01-01: needed only where the reference clock has 32 bits.
    std::uint64_t system_time{};
    std::chrono::nanoseconds lead{std::chrono::milliseconds{100}}; ///< from now to the first signal, at least
    using result_type = master_result<std::uint64_t>;
};

} // namespace jauscat::ethercat
