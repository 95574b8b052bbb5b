// Lets the cycles of a master follow the reference clock of its slaves.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace jauscat::ethercat {

/// How the cycles follow. The defaults suit a period of 1 ms and a start that jitters by some ten microseconds.
struct cycle_control_options {
    duration period{std::chrono::milliseconds{1}}; ///< of the cycles
    /// Reference time, modulo the period, at which the frame is to pass the reference clock. SYNC0 comes at multiples
    /// of the period plus its shift: keep half a period between the two.
    duration phase{std::chrono::microseconds{500}};
    unsigned proportional{20};                                  ///< a cycle corrects 1 / `proportional` of the error
    unsigned integral{2'000};                                   ///< and 1 / `integral` of the sum of the errors
    duration largest_correction{std::chrono::microseconds{20}}; ///< of one cycle
    /// A single error beyond this counts as a frame that was late, and corrects nothing, while the cycles are locked.
    duration outlier{std::chrono::microseconds{150}};
    duration lock_within{std::chrono::microseconds{8}}; ///< the mean error of `lock_after` cycles in a row
    unsigned lock_after{500};
    duration lose_beyond{std::chrono::microseconds{20}}; ///< the mean error of `lose_after` cycles in a row
    unsigned lose_after{200};

    /// In the middle of the period; above 1 ms all durations are as many times longer as the period is.
    [[nodiscard]] static constexpr cycle_control_options of_period(duration period) noexcept {
        cycle_control_options options{.period = period, .phase = period / 2};
        const std::int64_t longer = std::max<std::int64_t>(period / std::chrono::milliseconds{1}, 1);
        for (duration* each :
             {&options.largest_correction, &options.outlier, &options.lock_within, &options.lose_beyond})
            *each *= longer;
        return options;
    }
};

/// A controller with a proportional and an integral part. Each cycle's reference time in, the correction of the next
/// cycle's start out.
class cycle_control {
  public:
    explicit cycle_control(const cycle_control_options& options = {}) noexcept : options_{options} {}

    /// The reference clock's time when the last cycle's frame passed, which was sent `late` after it was due. Returns
    /// by how much later than after one period the next cycle is due.
    JAUSCAT_FUNCTION duration on_time(std::uint64_t reference_time, duration late = {}) noexcept;
    /// There is no reference time of the last cycle: the correction that its clock's drift needs.
    duration on_missing() noexcept { return duration{-steady()}; }

    /// The cycles follow the reference clock: slaves may go to OP.
    [[nodiscard]] bool is_locked() const noexcept { return is_locked_; }
    /// Of the last cycle's frame when it passed the reference clock; above 0: it was late.
    [[nodiscard]] duration error() const noexcept { return error_; }
    /// Of the instants at which the frames are due, whenever they were sent: moving average.
    [[nodiscard]] duration mean_error() const noexcept { return duration{mean_ / mean_scale}; }
    /// How far the frames are from their phase, early or late: moving average of some 250 cycles.
    [[nodiscard]] duration deviation() const noexcept { return duration{deviation_ / deviation_scale}; }
    /// How much faster this clock is than the reference clock, in parts per billion.
    [[nodiscard]] JAUSCAT_FUNCTION std::int64_t drift() const noexcept;

  private:
    static constexpr std::int64_t mean_scale = 16;
    static constexpr std::int64_t deviation_scale = 256;

    [[nodiscard]] std::int64_t integral() const noexcept { return std::max(options_.integral, 1u); }
    [[nodiscard]] std::int64_t steady() const noexcept { return sum_ / integral(); }

    // Within half a period; above 0: late.
    [[nodiscard]] JAUSCAT_FUNCTION std::int64_t phase_error(std::uint64_t time) const noexcept;
    // Of this error and the two before it: a single frame that was held up does not count.
    [[nodiscard]] JAUSCAT_FUNCTION std::int64_t median(std::int64_t error) noexcept;

    JAUSCAT_FUNCTION void watch(std::int64_t error) noexcept;

    cycle_control_options options_;
    std::int64_t sum_{};             // of the errors
    std::int64_t mean_{};            // in 1 / mean_scale ns
    std::int64_t deviation_{};       // in 1 / deviation_scale ns
    std::int64_t last_{}, before_{}; // the errors of the last cycles
    bool has_begun_{};
    duration error_{};
    unsigned count_{}; // cycles that speak for the other state
    bool is_locked_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/cycle_control.ipp>
#endif
