// The functions of cycle_control.
#pragma once
#include <jauscat/ethercat/master/cycle_control.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION duration cycle_control::on_time(std::uint64_t reference_time, duration late) noexcept {
    const auto period = std::max<std::int64_t>(options_.period.count(), 1);
    const auto own = phase_error(reference_time - static_cast<std::uint64_t>(late.count()));
    error_ = duration{own} + late;
    const auto error = median(own);
    watch(error);
    if (is_locked_ && std::abs(error) > options_.outlier.count()) return on_missing();
    // Two oscillators are never further apart than 1000 ppm.
    const auto most = period * std::int64_t{integral()} / 1'000;
    sum_ = std::clamp(sum_ + error, -most, most);
    const duration wanted{-error / std::max(std::int64_t{options_.proportional}, std::int64_t{1}) - steady()};
    return std::clamp(wanted, -options_.largest_correction, options_.largest_correction);
}

JAUSCAT_FUNCTION std::int64_t cycle_control::drift() const noexcept {
    return -steady() * 1'000'000'000 / std::max<std::int64_t>(options_.period.count(), 1);
}

JAUSCAT_FUNCTION std::int64_t cycle_control::phase_error(std::uint64_t time) const noexcept {
    const auto period = std::max<std::int64_t>(options_.period.count(), 1);
    const auto since = static_cast<std::int64_t>(time % static_cast<std::uint64_t>(period));
    auto error = (since - options_.phase.count()) % period;
    if (error > period / 2) error -= period;
    if (error <= -((period + 1) / 2)) error += period;
    return error;
}

JAUSCAT_FUNCTION std::int64_t cycle_control::median(std::int64_t error) noexcept {
    if (!std::exchange(has_begun_, true)) last_ = before_ = error;
    const auto middle = std::max(std::min(last_, before_), std::min(std::max(last_, before_), error));
    before_ = std::exchange(last_, error);
    return middle;
}

JAUSCAT_FUNCTION void cycle_control::watch(std::int64_t error) noexcept {
    mean_ += (error * mean_scale - mean_) / 10;
    deviation_ += std::abs(error_.count()) - deviation_ / deviation_scale;
    const auto size = std::chrono::abs(mean_error());
    if (is_locked_) {
        count_ = size > options_.lose_beyond || std::abs(error) > options_.outlier.count() ? count_ + 1 : 0;
        if (count_ < options_.lose_after) return;
    } else {
        count_ = size < options_.lock_within ? count_ + 1 : 0;
        if (count_ < options_.lock_after) return;
    }
    is_locked_ = !is_locked_;
    count_ = 0;
}

} // namespace jauscat::ethercat
