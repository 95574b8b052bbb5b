// Waiting for the next of many instants that are one period apart, for a loop that exchanges process data. The instants
// are absolute, so that what a cycle takes does not shift the ones after it.
#pragma once

#include <chrono>
#include <cstdint>
#include <ctime>
#include <sys/prctl.h>

namespace jauscat::net {

/// Periodic instants on CLOCK_MONOTONIC (std::chrono::steady_clock); the first is one period after the timer is made.
/// Used by one thread, whose sleeps it makes as exact as the system can: by default Linux lets an ordinary thread
/// oversleep by 50 microseconds.
class cycle_timer {
  public:
    using clock = std::chrono::steady_clock;

    /// `period` is above 0. The last `spin` of each wait is spent awake, looking at the clock: that costs processor
    /// time and saves the time a sleeping thread takes to wake; 0 sleeps all the time.
    explicit cycle_timer(std::chrono::nanoseconds period, std::chrono::nanoseconds spin = {}) noexcept
        : period_{period}, spin_{spin}, due_{clock::now()} {
        ::prctl(PR_SET_TIMERSLACK, 1UL); // 1 ns; 0 would be the default again
    }

    /// Waits for the next instant and returns by how much it came later, 0 or more. An instant that is over by less
    /// than half a period is still used: who waited for something until the end of a cycle is late by a little.
    /// Instants that are over for longer are left out and counted as overruns. Those after them stay where they are.
    std::chrono::nanoseconds wait() noexcept {
        due_ += period_;
        auto now = clock::now();
        if (const auto missed = (now - due_ + period_ / 2) / period_; missed > 0) {
            overruns_ += static_cast<std::uint64_t>(missed);
            due_ += missed * period_;
        }
        if (now < due_ - spin_) sleep_until(due_ - spin_);
        do {
            now = clock::now();
        } while (now < due_);
        return now - due_;
    }

    /// The instant that the last `wait` waited for.
    [[nodiscard]] clock::time_point due() const noexcept { return due_; }
    /// How many instants were left out.
    [[nodiscard]] std::uint64_t overruns() const noexcept { return overruns_; }

  private:
    static void sleep_until(clock::time_point instant) noexcept {
        const auto time = instant.time_since_epoch();
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time);
        const timespec until{.tv_sec = static_cast<std::time_t>(seconds.count()),
                             .tv_nsec = static_cast<long>((time - seconds).count())};
        // A signal ends it early; then the loop that called spins for the rest of the period.
        ::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
    }

    std::chrono::nanoseconds period_;
    std::chrono::nanoseconds spin_;
    clock::time_point due_;
    std::uint64_t overruns_{};
};

} // namespace jauscat::net
