// The distributed clock of an emulated slave controller: local time with a drift, the control that follows the
// reference clock, and the SYNC unit. esc_memory.hpp has its registers.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/schema/ethercat/dc_registers.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace jauscat::ethercat {

/// What is wrong with the oscillator of a slave, and when it was switched on.
struct clock_error {
    std::int32_t drift{};  ///< parts per billion; positive: it is fast. Within 1 000 000.
    std::uint64_t start{}; ///< local time, in ns, at the first instant that the slave is told
    std::uint32_t step{1}; ///< the local time is read in multiples of so many ns: 10 in an ET1100
};

/// Time in, time out. The local time is free-running but for the control, which changes its speed by up to 760 ppm so
/// that local time + offset - delay equals the times received. How fast it does is not in the standard: a difference is
/// worked off in some hundred received times, however far apart these are.
class slave_clock {
  public:
    /// As after power-on; the error stays.
    JAUSCAT_CONSTEXPR void power_on() noexcept;
    /// The local time starts again.
    JAUSCAT_CONSTEXPR void set_error(const clock_error& error) noexcept;

    /// It is `now`: any time that does not go back.
    JAUSCAT_CONSTEXPR void advance(time_point now) noexcept;

    /// In ns, as the registers show it.
    [[nodiscard]] constexpr std::uint64_t local_time() const noexcept { return local_ - local_ % error_.step; }
    /// Local time + offset: all slaves' are equal at one instant if all is well.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::uint64_t system_time() const noexcept;
    /// What it will be at `now`, which is not before the last `advance`, if no frame passes.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::uint64_t system_time(time_point now) const noexcept;
    /// The reference clock's time when the present frame passed it: what a master reads.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::uint64_t reference_time() const noexcept { return system_time() - delay_; }

    constexpr void set_delay(std::uint32_t ns) noexcept { delay_ = ns; }
    /// A SYNC unit that is on does not fire for the times that are jumped over.
    JAUSCAT_CONSTEXPR void set_offset(std::int64_t ns) noexcept;

    /// A received time, of which the low 32 bits count.
    JAUSCAT_CONSTEXPR void compare(std::uint32_t received) noexcept;
    /// dc_speed_start has been written: the control starts anew.
    JAUSCAT_CONSTEXPR void restart(std::uint16_t speed_start, const dc_filters& filters) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR dc_difference difference() const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR dc_speed_difference speed_difference() const noexcept;

    /// dc_activation has been written; `start` and the cycles are what the registers hold.
    JAUSCAT_CONSTEXPR void activate(const dc_activation& activation, std::uint64_t start, std::uint32_t sync0_cycle,
                                    std::uint32_t sync1_cycle, clock_width width) noexcept;
    [[nodiscard]] constexpr const dc_activation& activation() const noexcept { return activation_; }
    [[nodiscard]] constexpr const dc_activation_status& activation_status() const noexcept { return status_; }
    /// System time of the next one; the largest number if there will be none.
    [[nodiscard]] constexpr std::uint64_t next_sync0() const noexcept { return next_sync0_; }
    [[nodiscard]] constexpr std::uint64_t next_sync1() const noexcept { return next_sync1_; }
    /// How many there were since the last call.
    constexpr std::uint64_t take_sync0() noexcept { return std::exchange(sync0_count_, 0); }
    constexpr std::uint64_t take_sync1() noexcept { return std::exchange(sync1_count_, 0); }

    static constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();

  private:
    static constexpr std::int64_t mean_scale = 256;

    // The quotient as a multiple of 2^-32.
    JAUSCAT_CONSTEXPR static std::int64_t scaled(std::int64_t numerator, std::int64_t denominator) noexcept;
    // The speed that a speed counter difference makes: see dc_speed_difference.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::int64_t speed_of(std::int64_t difference) const noexcept;
    [[nodiscard]] constexpr std::int32_t most_difference() const noexcept { return speed_start_ - 0x7F; }

    // Proportional to the mean difference, and to the sum of the differences. Limited to what keeps 16 averaged values
    // stable; a larger speed start makes it slower.
    JAUSCAT_CONSTEXPR void control(std::int32_t error, std::int64_t passed) noexcept;
    // The largest difference whose speed is not above the wanted one.
    JAUSCAT_CONSTEXPR void set_speed(std::int64_t wanted) noexcept;

    [[nodiscard]] constexpr std::uint64_t sync0_period() const noexcept { return sync0_cycle_; }
    // A SYNC1 later than a SYNC0 cycle leaves SYNC0s out.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::uint64_t sync1_period() const noexcept;

    JAUSCAT_CONSTEXPR void begin(std::uint64_t start, clock_width width) noexcept;

    JAUSCAT_CONSTEXPR void sync() noexcept;
    // How many instants have passed, the first being `next`, which moves on. Without a period there is one.
    JAUSCAT_CONSTEXPR static std::uint64_t pass(std::uint64_t& next, std::uint64_t period, std::uint64_t now) noexcept;
    JAUSCAT_CONSTEXPR void skip(std::uint64_t& next, std::uint64_t period) noexcept;

    clock_error error_{};
    bool runs_{}; // it has been told a time
    time_point now_{};
    std::uint64_t local_{};
    std::int64_t fraction_{};   // of a ns of the local time, in 2^-32
    std::int64_t drift_{};      // in 2^-32
    std::int64_t correction_{}; // in 2^-32
    std::int64_t offset_{};
    std::uint32_t delay_{};

    std::uint16_t speed_start_{0x1000};
    dc_filters filters_{.difference = 4, .speed = 12};
    std::int32_t speed_difference_{};
    std::int64_t mean_{};     // difference, in 1 / mean_scale ns
    std::int64_t integral_{}; // speed, in 2^-40
    bool compares_{};         // a time has been received since the restart
    std::uint64_t compared_at_{};

    dc_activation activation_{};
    dc_activation_status status_{};
    std::uint32_t sync0_cycle_{}, sync1_cycle_{};
    std::uint64_t next_sync0_{never}, next_sync1_{never};
    std::uint64_t sync0_count_{}, sync1_count_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/slave/impl/slave_clock.ipp>
#endif
