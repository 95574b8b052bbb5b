// The distributed clock of an emulated slave controller: local time with a drift, the control that follows the
// reference clock, and the SYNC unit. esc_memory.hpp has its registers.
#pragma once

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
    constexpr void power_on() noexcept {
        const auto error = error_;
        const auto now = now_;
        const bool runs = runs_;
        *this = {};
        set_error(error);
        now_ = now;
        runs_ = runs;
    }
    /// The local time starts again.
    constexpr void set_error(const clock_error& error) noexcept {
        error_ = error;
        drift_ = scaled(error.drift, 1'000'000'000);
        local_ = error.start;
        fraction_ = 0;
    }

    /// It is `now`: any time that does not go back.
    constexpr void advance(time_point now) noexcept {
        if (!std::exchange(runs_, true)) now_ = now;
        constexpr std::int64_t most = std::int64_t{1}
                                      << 40; // with the speed's 2^-32, of which there are 2^22, no overflow
        while (now > now_) {
            const std::int64_t passed = std::min<std::int64_t>((now - now_).count(), most);
            const std::int64_t more = fraction_ + passed * (drift_ + correction_);
            local_ += static_cast<std::uint64_t>(passed + (more >> 32));
            fraction_ = more & 0xFFFFFFFF;
            now_ += duration{passed};
        }
        sync();
    }

    /// In ns, as the registers show it.
    [[nodiscard]] constexpr std::uint64_t local_time() const noexcept { return local_ - local_ % error_.step; }
    /// Local time + offset: all slaves' are equal at one instant if all is well.
    [[nodiscard]] constexpr std::uint64_t system_time() const noexcept {
        return local_time() + static_cast<std::uint64_t>(offset_);
    }
    /// What it will be at `now`, which is not before the last `advance`, if no frame passes.
    [[nodiscard]] constexpr std::uint64_t system_time(time_point now) const noexcept {
        auto later = *this;
        later.advance(now);
        return later.system_time();
    }
    /// The reference clock's time when the present frame passed it: what a master reads.
    [[nodiscard]] constexpr std::uint64_t reference_time() const noexcept { return system_time() - delay_; }

    constexpr void set_delay(std::uint32_t ns) noexcept { delay_ = ns; }
    /// A SYNC unit that is on does not fire for the times that are jumped over.
    constexpr void set_offset(std::int64_t ns) noexcept {
        offset_ = ns;
        skip(next_sync0_, sync0_period());
        skip(next_sync1_, sync1_period());
    }

    /// A received time, of which the low 32 bits count.
    constexpr void compare(std::uint32_t received) noexcept {
        const auto error = static_cast<std::int32_t>(static_cast<std::uint32_t>(reference_time()) - received);
        mean_ +=
            (std::int64_t{error} * mean_scale - mean_) / (std::int64_t{1} << std::min<int>(filters_.difference, 15));
        const auto passed = static_cast<std::int64_t>(local_ - compared_at_);
        if (std::exchange(compares_, true)) control(error, std::clamp<std::int64_t>(passed, 1'000, 1'000'000'000));
        compared_at_ = local_;
    }
    /// dc_speed_start has been written: the control starts anew.
    constexpr void restart(std::uint16_t speed_start, const dc_filters& filters) noexcept {
        speed_start_ = std::clamp<std::uint16_t>(speed_start, 0x0080, 0x3FFF);
        filters_ = filters;
        mean_ = integral_ = correction_ = 0;
        speed_difference_ = 0;
        compares_ = false;
    }
    [[nodiscard]] constexpr dc_difference difference() const noexcept {
        return dc_difference::of(static_cast<std::int32_t>(mean_ / mean_scale));
    }
    [[nodiscard]] constexpr dc_speed_difference speed_difference() const noexcept {
        return {static_cast<std::int16_t>(speed_difference_)};
    }

    /// dc_activation has been written; `start` and the cycles are what the registers hold.
    constexpr void activate(const dc_activation& activation, std::uint64_t start, std::uint32_t sync0_cycle,
                            std::uint32_t sync1_cycle, clock_width width) noexcept {
        const bool was_on = activation_.on;
        activation_ = activation;
        sync0_cycle_ = sync0_cycle;
        sync1_cycle_ = sync1_cycle;
        if (!activation.on) {
            next_sync0_ = next_sync1_ = never;
            status_ = {};
            return;
        }
        if (was_on) return;
        begin(start, width);
    }
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
    static constexpr std::int64_t scaled(std::int64_t numerator, std::int64_t denominator) noexcept {
        return numerator * (std::int64_t{1} << 32) / denominator;
    }
    // The speed that a speed counter difference makes: see dc_speed_difference.
    [[nodiscard]] constexpr std::int64_t speed_of(std::int64_t difference) const noexcept {
        return scaled(difference, 5 * (speed_start_ + difference + 2) * (speed_start_ - difference + 2));
    }
    [[nodiscard]] constexpr std::int32_t most_difference() const noexcept { return speed_start_ - 0x7F; }

    // Proportional to the mean difference, and to the sum of the differences. Limited to what keeps 16 averaged values
    // stable; a larger speed start makes it slower.
    constexpr void control(std::int32_t error, std::int64_t passed) noexcept {
        constexpr std::int64_t most = std::int64_t{1} << 22; // ns: beyond it the speed is at its limit anyway
        const int depth = std::clamp<int>(filters_.speed, 8, 15);
        const std::int64_t slow = std::max<std::int64_t>(speed_start_, 0x1000);
        const auto mean = std::clamp(mean_ / mean_scale, -most, most);
        const auto now = std::clamp<std::int64_t>(error, -most, most);
        const auto proportional = scaled(-mean, passed) / (1 << (depth / 2 - 1)) * 0x1000 / slow;
        const auto step = -now * (std::int64_t{1} << 40) / passed / (1 << depth) * 0x1000 / slow;
        const auto limit = speed_of(most_difference());
        const auto wanted = proportional + (integral_ >> 8);
        const bool at_limit = wanted >= limit ? step > 0 : wanted <= -limit && step < 0;
        if (!at_limit) integral_ = std::clamp(integral_ + step, -limit * 256, limit * 256);
        set_speed(std::clamp(wanted, -limit, limit));
    }
    // The largest difference whose speed is not above the wanted one.
    constexpr void set_speed(std::int64_t wanted) noexcept {
        std::int32_t low = -most_difference(), high = most_difference();
        while (low < high) {
            const auto middle = (low + high + 1) >> 1;
            if (speed_of(middle) <= wanted)
                low = middle;
            else
                high = middle - 1;
        }
        speed_difference_ = low;
        correction_ = speed_of(low);
    }

    [[nodiscard]] constexpr std::uint64_t sync0_period() const noexcept { return sync0_cycle_; }
    // A SYNC1 later than a SYNC0 cycle leaves SYNC0s out.
    [[nodiscard]] constexpr std::uint64_t sync1_period() const noexcept {
        return sync0_cycle_ == 0 ? 0 : (std::uint64_t{sync1_cycle_ / sync0_cycle_} + 1) * sync0_cycle_;
    }

    constexpr void begin(std::uint64_t start, clock_width width) noexcept {
        const auto now = system_time();
        const bool is_short = width == clock_width::bits_32 || activation_.near_future_short;
        const std::uint64_t near = is_short ? std::uint64_t{1} << 31 : std::uint64_t{1} << 63;
        if (width == clock_width::bits_32) // what has passed comes again when the time wraps
            start = now + (static_cast<std::uint32_t>(start) - static_cast<std::uint32_t>(now));
        const bool is_near = start - now < near;
        if (!is_near && activation_.check_start) start = now;
        next_sync0_ = start < now ? never : start;
        next_sync1_ = next_sync0_ == never ? never : next_sync0_ + sync1_cycle_;
        status_ = {.sync0_pending = activation_.sync0, .sync1_pending = activation_.sync1, .start_not_near = !is_near};
        sync();
    }

    constexpr void sync() noexcept {
        if (!activation_.on) return;
        const auto now = system_time();
        if (const auto count = pass(next_sync0_, sync0_period(), now); count != 0 && activation_.sync0) {
            sync0_count_ += count;
            status_.sync0_pending = false;
        }
        if (const auto count = pass(next_sync1_, sync1_period(), now); count != 0 && activation_.sync1) {
            sync1_count_ += count;
            status_.sync1_pending = false;
        }
    }
    // How many instants have passed, the first being `next`, which moves on. Without a period there is one.
    static constexpr std::uint64_t pass(std::uint64_t& next, std::uint64_t period, std::uint64_t now) noexcept {
        if (next > now) return 0;
        const auto count = period == 0 ? 1 : (now - next) / period + 1;
        next = period == 0 ? never : next + count * period;
        return count;
    }
    constexpr void skip(std::uint64_t& next, std::uint64_t period) noexcept {
        static_cast<void>(pass(next, period, system_time()));
    }

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
