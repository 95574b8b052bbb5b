// The process data watchdog of an EtherCAT slave controller: registers and their times. ET1100 data sheet, section II.
#pragma once

#include <jauscat/schema/ethercat/esc_registers.hpp>

#include <chrono>
#include <cstdint>

namespace jauscat::ethercat {

namespace esc_registers {
inline constexpr esc_register_of<esc_word> watchdog_divider{
    {0x0400, 2}}; ///< length of its unit: 40 ns times the value plus 2
inline constexpr esc_register_of<esc_word> pdi_watchdog{
    {0x0410, 2}}; ///< time in which the slave's application must come by
inline constexpr esc_register_of<esc_word> process_data_watchdog{
    {0x0420, 2}}; ///< time, in units by `watchdog_divider`; 0: off
inline constexpr esc_register_of<esc_word> watchdog_status{{0x0440, 2}}; ///< bit 0: not expired
/// How often the watchdogs have expired, at most 255: of the process data, and in the upper byte of the application. A
/// write clears both.
inline constexpr esc_register_of<esc_word> watchdog_counters{{0x0442, 2}};
} // namespace esc_registers

inline constexpr std::uint16_t default_watchdog_divider = 2498; ///< units of 100 us
inline constexpr std::uint16_t default_watchdog_time = 1000;    ///< of these units: 100 ms

/// What the registers' values mean: (divider + 2) x 40 ns is one unit.
[[nodiscard]] constexpr std::chrono::nanoseconds watchdog_time(std::uint16_t divider, std::uint16_t units) noexcept {
    return (std::int64_t{divider} + 2) * units * std::chrono::nanoseconds{40};
}

/// The default: 100 ms.
inline constexpr std::chrono::nanoseconds default_watchdog =
    watchdog_time(default_watchdog_divider, default_watchdog_time);

/// Units of 100 us, the default divider's, that are not shorter than `time`; 0 where there are none: 100 us to 6.5535
/// s.
[[nodiscard]] constexpr std::uint16_t watchdog_units(std::chrono::nanoseconds time) noexcept {
    constexpr auto unit = watchdog_time(default_watchdog_divider, 1);
    constexpr std::uint16_t most = 0xFFFF;
    if (time <= time.zero() || time > most * unit) return 0;
    return static_cast<std::uint16_t>((time + unit - std::chrono::nanoseconds{1}) / unit);
}

} // namespace jauscat::ethercat
