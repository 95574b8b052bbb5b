// Instants of simulated time.
#pragma once

#include <jauscat/base/time.hpp>

namespace support {

/// `instant{5ms}`: 5 ms after the epoch of jauscat::clock. As a parameter it takes `5ms` and a time_point.
struct instant {
    jauscat::time_point at{};

    template <class Rep, class Period>
    constexpr instant(std::chrono::duration<Rep, Period> since_epoch) noexcept // NOLINT(google-explicit-constructor)
        : at{jauscat::duration{since_epoch}} {}
    constexpr instant(jauscat::time_point when) noexcept : at{when} {}     // NOLINT(google-explicit-constructor)
    constexpr operator jauscat::time_point() const noexcept { return at; } // NOLINT(google-explicit-constructor)

    friend constexpr auto operator<=>(const instant&, const instant&) noexcept = default;
    friend constexpr bool operator==(const instant&, const instant&) noexcept = default;
    friend constexpr auto operator<=>(jauscat::time_point a, const instant& b) noexcept { return a <=> b.at; }
    friend constexpr bool operator==(jauscat::time_point a, const instant& b) noexcept { return a == b.at; }
    friend constexpr jauscat::time_point operator+(const instant& a, jauscat::duration b) noexcept { return a.at + b; }
};

} // namespace support
