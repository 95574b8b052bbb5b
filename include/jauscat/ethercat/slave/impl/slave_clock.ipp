// The functions of slave_clock.
#pragma once
#include <jauscat/ethercat/slave/slave_clock.hpp>

namespace jauscat::ethercat {

JAUSCAT_CONSTEXPR void slave_clock::power_on() noexcept {
    const auto error = error_;
    const auto now = now_;
    const bool runs = runs_;
    *this = {};
    set_error(error);
    now_ = now;
    runs_ = runs;
}

JAUSCAT_CONSTEXPR void slave_clock::set_error(const clock_error& error) noexcept {
    error_ = error;
    drift_ = scaled(error.drift, 1'000'000'000);
    local_ = error.start;
    fraction_ = 0;
}

JAUSCAT_CONSTEXPR void slave_clock::advance(time_point now) noexcept {
    if (!std::exchange(runs_, true)) now_ = now;
    constexpr std::int64_t most = std::int64_t{1} << 40; // with the speed's 2^-32, of which there are 2^22, no overflow
    while (now > now_) {
        const std::int64_t passed = std::min<std::int64_t>((now - now_).count(), most);
        const std::int64_t more = fraction_ + passed * (drift_ + correction_);
        local_ += static_cast<std::uint64_t>(passed + (more >> 32));
        fraction_ = more & 0xFFFFFFFF;
        now_ += duration{passed};
    }
    sync();
}

JAUSCAT_CONSTEXPR std::uint64_t slave_clock::system_time() const noexcept {
    return local_time() + static_cast<std::uint64_t>(offset_);
}

JAUSCAT_CONSTEXPR std::uint64_t slave_clock::system_time(time_point now) const noexcept {
    auto later = *this;
    later.advance(now);
    return later.system_time();
}

JAUSCAT_CONSTEXPR void slave_clock::set_offset(std::int64_t ns) noexcept {
    offset_ = ns;
    skip(next_sync0_, sync0_period());
    skip(next_sync1_, sync1_period());
}

JAUSCAT_CONSTEXPR void slave_clock::compare(std::uint32_t received) noexcept {
    const auto error = static_cast<std::int32_t>(static_cast<std::uint32_t>(reference_time()) - received);
    mean_ += (std::int64_t{error} * mean_scale - mean_) / (std::int64_t{1} << std::min<int>(filters_.difference, 15));
    const auto passed = static_cast<std::int64_t>(local_ - compared_at_);
    if (std::exchange(compares_, true)) control(error, std::clamp<std::int64_t>(passed, 1'000, 1'000'000'000));
    compared_at_ = local_;
}

JAUSCAT_CONSTEXPR void slave_clock::restart(std::uint16_t speed_start, const dc_filters& filters) noexcept {
    speed_start_ = std::clamp<std::uint16_t>(speed_start, 0x0080, 0x3FFF);
    filters_ = filters;
    mean_ = integral_ = correction_ = 0;
    speed_difference_ = 0;
    compares_ = false;
}

JAUSCAT_CONSTEXPR dc_difference slave_clock::difference() const noexcept {
    return dc_difference::of(static_cast<std::int32_t>(mean_ / mean_scale));
}

JAUSCAT_CONSTEXPR dc_speed_difference slave_clock::speed_difference() const noexcept {
    return {static_cast<std::int16_t>(speed_difference_)};
}

JAUSCAT_CONSTEXPR void slave_clock::activate(const dc_activation& activation, std::uint64_t start,
                                             std::uint32_t sync0_cycle, std::uint32_t sync1_cycle,
                                             clock_width width) noexcept {
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

JAUSCAT_CONSTEXPR std::int64_t slave_clock::scaled(std::int64_t numerator, std::int64_t denominator) noexcept {
    return numerator * (std::int64_t{1} << 32) / denominator;
}

JAUSCAT_CONSTEXPR std::int64_t slave_clock::speed_of(std::int64_t difference) const noexcept {
    return scaled(difference, 5 * (speed_start_ + difference + 2) * (speed_start_ - difference + 2));
}

JAUSCAT_CONSTEXPR void slave_clock::control(std::int32_t error, std::int64_t passed) noexcept {
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

JAUSCAT_CONSTEXPR void slave_clock::set_speed(std::int64_t wanted) noexcept {
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

JAUSCAT_CONSTEXPR std::uint64_t slave_clock::sync1_period() const noexcept {
    return sync0_cycle_ == 0 ? 0 : (std::uint64_t{sync1_cycle_ / sync0_cycle_} + 1) * sync0_cycle_;
}

JAUSCAT_CONSTEXPR void slave_clock::begin(std::uint64_t start, clock_width width) noexcept {
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

JAUSCAT_CONSTEXPR void slave_clock::sync() noexcept {
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

JAUSCAT_CONSTEXPR std::uint64_t slave_clock::pass(std::uint64_t& next, std::uint64_t period,
                                                  std::uint64_t now) noexcept {
    if (next > now) return 0;
    const auto count = period == 0 ? 1 : (now - next) / period + 1;
    next = period == 0 ? never : next + count * period;
    return count;
}

JAUSCAT_CONSTEXPR void slave_clock::skip(std::uint64_t& next, std::uint64_t period) noexcept {
    static_cast<void>(pass(next, period, system_time()));
}

} // namespace jauscat::ethercat
