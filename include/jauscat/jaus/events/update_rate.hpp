// The rates of service connections and of periodic events, as their messages can say them.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/schema/jaus/types.hpp>
#include <jauscat/wire/scaled.hpp>

#include <algorithm>
#include <chrono>

namespace jauscat::jaus {

/// Steps of 1092 / 65535 Hz.
using update_rate_codec = wire::scaled<wire::u16le, update_rate>;

/// The rate nearest to `rate` that a message can say and that is not above `most`; 0 where that is less than one step.
/// Both in hertz.
[[nodiscard]] constexpr double sayable_rate(double rate, double most) noexcept {
    most = std::clamp(most, 0.0, update_rate::max);
    if (!(rate > 0)) return 0;
    auto raw = update_rate_codec::to_raw(std::min(rate, most));
    if (raw != 0 && update_rate_codec::to_real(raw) > most) --raw;
    return update_rate_codec::to_real(raw);
}

/// The period of a rate above 0 Hz, to the nearest nanosecond.
[[nodiscard]] constexpr duration period_of(double rate) noexcept {
    return std::chrono::round<duration>(std::chrono::duration<double, std::nano>{1e9 / rate});
}

/// The first instant after `now` of those that lie `period` apart and hold `due`, which is not after `now`.
[[nodiscard]] constexpr time_point instant_after(time_point due, duration period, time_point now) noexcept {
    return due + ((now - due) / period + 1) * period;
}

} // namespace jauscat::jaus
