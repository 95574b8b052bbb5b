// Random numbers that depend on the seed alone: std's distributions differ from one library to another.
#pragma once

#include <jauscat/base/time.hpp>

#include <chrono>
#include <cstdint>
#include <optional>

namespace simulation {

using time = std::chrono::nanoseconds; ///< since the start, or a duration

[[nodiscard]] constexpr std::optional<time> since_start(std::optional<jauscat::time_point> at) noexcept {
    return at ? std::optional{at->time_since_epoch()} : std::nullopt;
}

/// splitmix64: fast, and every seed is good.
class generator {
  public:
    constexpr explicit generator(std::uint64_t seed) noexcept : state_{seed} {}

    constexpr std::uint64_t next() noexcept {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EB;
        return z ^ (z >> 31U);
    }
    /// 0 to `end` - 1; `end` is at most 2^32.
    constexpr std::uint32_t below(std::uint64_t end) noexcept {
        return static_cast<std::uint32_t>(((next() >> 32U) * end) >> 32U);
    }
    constexpr bool chance(unsigned per_million) noexcept { return below(1'000'000) < per_million; }
    constexpr time between(time from, time to) noexcept {
        const auto span = static_cast<std::uint64_t>((to - from).count()) + 1;
        return from + time{static_cast<std::int64_t>(next() % span)};
    }
    /// A generator of its own for the actor or the purpose of this number.
    [[nodiscard]] constexpr generator stream(std::uint64_t number) const noexcept {
        generator made{state_ ^ (number * 0xD1342543DE82EF95)};
        return generator{made.next()};
    }

  private:
    std::uint64_t state_;
};

} // namespace simulation
