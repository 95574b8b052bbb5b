// What a master knows of a slave's distributed clock.
#pragma once

#include <jauscat/schema/ethercat/dc_registers.hpp>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace jauscat::ethercat {

/// Synchronization signals of a slave, as its ESI file has them (Dc/OpMode).
struct sync_settings {
    std::uint16_t assign_activate{};  ///< 0300h: SYNC0, 0700h: SYNC0 and SYNC1; 0: none
    std::uint32_t sync0_cycle{};      ///< ns
    std::uint32_t sync1_delay{};      ///< ns from SYNC0 to SYNC1, register 09A4h
    std::chrono::nanoseconds shift{}; ///< of SYNC0 from the multiples of the cycle since 2000; positive: later

    friend bool operator==(const sync_settings&, const sync_settings&) = default;
    /// Between two SYNC1, or two SYNC0 where there is none: a later SYNC1 leaves SYNC0s out.
    [[nodiscard]] constexpr std::uint64_t period() const noexcept {
        const bool has_sync1 = (assign_activate & 0x0400) != 0;
        if (!has_sync1 || sync0_cycle == 0) return sync0_cycle;
        return (std::uint64_t{sync1_delay / sync0_cycle} + 1) * sync0_cycle;
    }
};

/// The clock of one slave. The caller sets the first members; `set_up_clocks` and `start_sync` do the others.
struct clock_record {
    static constexpr std::uint16_t no_parent = 0xFFFF;

    std::uint16_t station{}; ///< station address
    bool runs{};             ///< it is in SAFE-OP or OP, or its clock is in use: its offset is not changed
    sync_settings sync{};    ///< for `start_sync`

    clock_width width{};                     ///< whether it has a clock
    std::array<bool, 4> open{};              ///< ports with something connected
    std::array<std::uint32_t, 4> received{}; ///< local times at the ports
    std::uint64_t processing_time{};         ///< local time of the same frame
    std::uint16_t parent{no_parent};         ///< place of the slave before it; none: the master
    std::uint8_t parent_port{};              ///< that it is connected to there
    std::uint32_t delay{};                   ///< ns, from the reference clock
    std::int64_t offset{};                   ///< ns, from its local time to the system time
    dc_difference difference{};              ///< from the reference clock, when it was last looked at
    std::uint64_t start_time{};              ///< system time of its first SYNC0

    [[nodiscard]] constexpr bool has_clock() const noexcept { return width != clock_width::no_clock; }
    [[nodiscard]] constexpr std::size_t open_ports() const noexcept {
        std::size_t count = 0;
        for (const bool each : open) count += each ? 1 : 0;
        return count;
    }
};

} // namespace jauscat::ethercat
