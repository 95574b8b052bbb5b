// The clock of net/: std::chrono::steady_clock, as the instants that the modules below the I/O line take.
#pragma once

#include <jauscat/base/time.hpp>

#include <chrono>

namespace jauscat::net {

[[nodiscard]] inline time_point from_steady(std::chrono::steady_clock::time_point at) noexcept {
    return time_point{std::chrono::duration_cast<duration>(at.time_since_epoch())};
}
[[nodiscard]] inline std::chrono::steady_clock::time_point to_steady(time_point at) noexcept {
    using clock = std::chrono::steady_clock;
    return clock::time_point{std::chrono::duration_cast<clock::duration>(at.time_since_epoch())};
}
[[nodiscard]] inline time_point now() noexcept { return from_steady(std::chrono::steady_clock::now()); }

} // namespace jauscat::net
