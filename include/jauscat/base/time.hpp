// Time and retries: one clock, deadlines, and how often something is tried. No clock is read here.
#pragma once
#include <chrono>
#include <cstdint>

namespace jauscat {

using duration = std::chrono::nanoseconds;

/// The clock of all modules below the I/O line: monotonic, with an epoch that the caller chooses. Instants are
/// arguments, so it has no `now`; `net::now()` reads std::chrono::steady_clock.
struct clock {
    using duration = jauscat::duration;
    using rep = duration::rep;
    using period = duration::period;
    using time_point = std::chrono::time_point<clock>;
    static constexpr bool is_steady = true;
};
using time_point = clock::time_point;

/// `at + by`, at most time_point::max(): an instant that is never reached. A negative `by` is in the past.
[[nodiscard]] constexpr time_point saturating_add(time_point at, duration by) noexcept {
    if (by < duration{}) return at < time_point::min() - by ? time_point::min() : at + by;
    return at > time_point::max() - by ? time_point::max() : at + by;
}

[[nodiscard]] constexpr duration saturating_add(duration a, duration b) noexcept {
    if (b < duration{}) return a < duration::min() - b ? duration::min() : a + b;
    return a > duration::max() - b ? duration::max() : a + b;
}

/// The instant until which something is waited for.
class deadline {
  public:
    /// Never reached.
    constexpr deadline() noexcept = default;
    constexpr explicit deadline(time_point at) noexcept : at_{at} {}
    /// duration::max() is never reached; a negative `after` is over.
    constexpr deadline(time_point now, duration after) noexcept : at_{saturating_add(now, after)} {}

    [[nodiscard]] constexpr time_point at() const noexcept { return at_; }
    [[nodiscard]] constexpr bool is_reached(time_point now) const noexcept { return now >= at_; }
    /// 0 once it is reached.
    [[nodiscard]] constexpr duration remaining(time_point now) const noexcept {
        return is_reached(now) ? duration{} : at_ - now;
    }

    friend constexpr auto operator<=>(const deadline&, const deadline&) noexcept = default; // NOLINT: <=> has a 0

  private:
    time_point at_ = time_point::max();
};

/// How something is tried again that got no answer.
struct retry_policy {
    duration interval{};      ///< between two attempts, and after the last one until it has failed
    std::uint32_t attempts{}; ///< in all, the first one included; at least 1

    /// From the first attempt until it has failed.
    [[nodiscard]] constexpr duration total() const noexcept {
        return attempts != 0 && interval > duration::max() / attempts ? duration::max() : interval * attempts;
    }
    /// Whether another attempt is made after `made` of them.
    [[nodiscard]] constexpr bool allows_another(std::uint32_t made) const noexcept { return made < attempts; }

    friend constexpr bool operator==(const retry_policy&, const retry_policy&) noexcept = default;
};

} // namespace jauscat
