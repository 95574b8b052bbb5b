// The functions of start_up.
#pragma once
#include <jauscat/ethercat/cia402/start_up.hpp>

namespace jauscat::cia402 {

JAUSCAT_CONSTEXPR std::optional<interpolation_period> interpolation_period_of(duration cycle) noexcept {
    constexpr std::int64_t highest = std::numeric_limits<std::uint8_t>::max();
    constexpr int milliseconds = -3;
    std::int64_t count = std::chrono::nanoseconds{cycle}.count();
    int index = -9;
    while (count % 10 == 0 && (index < milliseconds || count > highest)) {
        count /= 10;
        ++index;
    }
    if (count <= 0 || count > highest) return {};
    return interpolation_period{static_cast<std::uint8_t>(count), static_cast<std::int8_t>(index)};
}

JAUSCAT_CONSTEXPR axis_start_up::axis_start_up(duration cycle, const axis_places& places, std::size_t axis) noexcept {
    if (const auto period = interpolation_period_of(cycle)) {
        append(objects::interpolation_time, axis, period->value);
        append(objects::interpolation_index, axis, period->index);
    }
    if (!places.mode.is_mapped() && places.fixed_mode != mode::none)
        append(objects::mode_of_operation, axis, static_cast<std::int8_t>(places.fixed_mode));
}

JAUSCAT_CONSTEXPR std::span<const start_up_value> axis_start_up::values() const noexcept {
    return std::span{values_}.first(count_);
}

} // namespace jauscat::cia402
