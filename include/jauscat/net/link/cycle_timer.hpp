// Waits for periodic instants, for a loop that exchanges process data. The instants are absolute, so that the duration
// of a cycle does not shift the next ones.
#pragma once

#include <jauscat/net/now.hpp>

#include <chrono>
#include <cstdint>
#include <ctime>
#include <sys/prctl.h>

namespace jauscat::net {

/// Periodic instants on CLOCK_MONOTONIC (std::chrono::steady_clock); the first is one period after construction. For
/// one thread, whose timer slack it sets to the minimum: by default Linux lets a thread oversleep by 50 microseconds.
class cycle_timer {
  public:
    /// `period` is above 0. In the last `spin` of each wait the thread polls the clock, which uses processor time and
    /// avoids the wake-up latency; 0: it sleeps until the end.
    explicit cycle_timer(duration period, duration spin = {}) noexcept : period_{period}, spin_{spin}, due_{now()} {
        ::prctl(PR_SET_TIMERSLACK, 1UL); // 1 ns; 0 would be the default again
    }

    /// Waits for the next instant and returns the delay, 0 or more. An instant that has passed by less than half a
    /// period is still used, because a caller that waited until the end of a cycle is a little late. Instants that have
    /// passed by more are skipped and counted as overruns. The later ones shift only by `shift`.
    duration wait() noexcept {
        due_ += period_;
        auto at = now();
        if (const auto missed = (at - due_ + period_ / 2) / period_; missed > 0) {
            overruns_ += static_cast<std::uint64_t>(missed);
            due_ += missed * period_;
        }
        if (at < due_ - spin_) sleep_until(due_ - spin_);
        do {
            at = now();
        } while (at < due_);
        return at - due_;
    }

    /// The next instant, and all later ones, come later by this; negative: earlier.
    void shift(duration by) noexcept { due_ += by; }
    /// The instant of the last `wait`, less what it was shifted by since.
    [[nodiscard]] time_point due() const noexcept { return due_; }
    /// Number of skipped instants.
    [[nodiscard]] std::uint64_t overruns() const noexcept { return overruns_; }

  private:
    static void sleep_until(time_point instant) noexcept {
        const auto time = instant.time_since_epoch();
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time);
        const timespec until{.tv_sec = static_cast<std::time_t>(seconds.count()),
                             .tv_nsec = static_cast<long>((time - seconds).count())};
        // A signal ends it early; then the calling loop polls for the rest of the period.
        ::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
    }

    duration period_;
    duration spin_;
    time_point due_;
    std::uint64_t overruns_{};
};

} // namespace jauscat::net
