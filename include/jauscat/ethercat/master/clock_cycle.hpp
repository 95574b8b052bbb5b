// The first frame of each cycle of a bus with distributed clocks: distributes the reference time, watches the
// differences, and gives the correction by which the master's cycles follow.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/ethercat/master/clock_jobs.hpp>
#include <jauscat/ethercat/master/clock_topology.hpp>
#include <jauscat/ethercat/master/cycle_control.hpp>
#include <jauscat/ethercat/master/outstanding_frame.hpp>
#include <jauscat/schema/ethercat/dc_registers.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// When differences and silence count.
struct clock_watch_options {
    cycle_control_options control{};
    /// After so many cycles without an answer of the reference clock, the next slave with a clock takes its place.
    unsigned silent_cycles{3};
    std::uint32_t warning_limit{1'000}; ///< ns
    unsigned warning_cycles{100};       ///< in a row with a larger difference
    std::uint32_t error_limit{10'000};  ///< ns, in one cycle
};

/// How well the clocks agree.
enum class clock_agreement : std::uint8_t {
    good,
    warning, ///< the differences have been beyond the warning limit for some time
    error,   ///< they are beyond the error limit
};

/// Frames of the cycles, and what they have found.
struct clock_statistics {
    std::uint64_t sent{};
    std::uint64_t lost{};       ///< not back before the next cycle
    std::uint64_t unanswered{}; ///< without the reference clock's time, or with what the master had estimated
    std::uint64_t takeovers{};  ///< of another slave as reference clock
};

/// One frame per cycle, sent first: FRMW of the reference clock's system time to all slaves, and the differences of all
/// slaves (092Ch, or-ed). Runs beside process_data and a master on the same link: pass each received frame to
/// `on_frame` of all three in turn, until one accepts it.
class clock_cycle {
  public:
    /// `slaves` as set_up_clocks has left them, which has given `network`; they outlive this. `system_time` is the
    /// reference clock's at the first frame, within 2 s.
    JAUSCAT_FUNCTION clock_cycle(std::span<const clock_record> slaves, const clock_network& network,
                                 std::uint64_t system_time, const clock_watch_options& options = {}) noexcept;

    /// A cycle begins: writes its frame to `out`, at least 60 bytes, and returns its size; 0 where no clock is left. It
    /// is sent `now`, `late` after it was due.
    [[nodiscard]] JAUSCAT_FUNCTION std::size_t next_frame(std::span<std::byte> out, time_point now,
                                                          duration late = {}) noexcept;

    /// Takes a frame that arrived. False if it is none of ours.
    JAUSCAT_FUNCTION bool on_frame(std::span<const std::byte> frame) noexcept;

    /// The cycle ends. Returns by how much later than after one period the next one is due.
    JAUSCAT_FUNCTION duration end_cycle() noexcept;

    /// The frame of this cycle is not back yet.
    [[nodiscard]] bool waits() const noexcept { return outstanding_.waits(); }
    /// Whether the cycles follow the reference clock.
    [[nodiscard]] const cycle_control& control() const noexcept { return control_; }
    /// The reference clock's time when the last frame passed it, in ns since 2000-01-01; an estimate if it did not
    /// answer.
    [[nodiscard]] std::uint64_t reference_time() const noexcept { return time_; }
    /// Place of the reference clock; the number of slaves where none is left.
    [[nodiscard]] std::size_t reference() const noexcept { return reference_; }
    /// Its station address; 0 where none is left.
    [[nodiscard]] std::uint16_t reference_station() const noexcept {
        return is_lost() ? std::uint16_t{} : slaves_[reference_].station;
    }
    /// They were set up again, one more or one less among them; what is known of the reference time stays.
    JAUSCAT_FUNCTION void set_slaves(std::span<const clock_record> slaves, const clock_network& network) noexcept;
    /// Another slave's clock is the reference: the first one's, once it has been set up again.
    JAUSCAT_FUNCTION void set_reference(std::size_t place) noexcept;
    /// The next slave with a clock takes the place of the reference clock, which there is.
    JAUSCAT_FUNCTION void replace_reference() noexcept;
    /// No slave is left whose clock could be the reference: switch SYNC off, or leave OP.
    [[nodiscard]] bool is_lost() const noexcept { return reference_ == slaves_.size(); }
    /// As many slaves have taken the time as when the clocks were set up.
    [[nodiscard]] bool is_complete() const noexcept { return returned_ && working_counter_ == expected_counter_; }
    /// An upper bound of all differences from the reference clock in the last cycle, in ns; at most twice the largest.
    [[nodiscard]] std::uint32_t difference() const noexcept { return difference_; }
    [[nodiscard]] clock_agreement agreement() const noexcept { return agreement_; }
    [[nodiscard]] const clock_statistics& statistics() const noexcept { return statistics_; }

  private:
    [[nodiscard]] JAUSCAT_FUNCTION static bool begins_as_ours(const frame_view& frame) noexcept;

    // The time that has passed by this clock, less its drift.
    JAUSCAT_FUNCTION void estimate(time_point now) noexcept;
    // After a cycle without an answer it differs from the estimate, because a good one may be the reference time
    // itself.
    [[nodiscard]] std::uint64_t sent_time() const noexcept { return time_ + silent_ * 128u; }
    // What was sent comes back where the reference clock has not answered.
    JAUSCAT_FUNCTION void take_time(std::uint64_t time) noexcept;
    JAUSCAT_FUNCTION void judge(std::uint32_t difference) noexcept;
    // Another clock reads as the lost one's time, because its delay from there is subtracted: its slaves' delays stay.
    JAUSCAT_FUNCTION void silent() noexcept;

    std::span<const clock_record> slaves_;
    std::size_t reference_;
    clock_watch_options options_;
    cycle_control control_;
    std::uint64_t time_;
    std::uint16_t expected_counter_, working_counter_{};
    outstanding_frame<2> outstanding_{};
    std::uint8_t index_{};
    duration late_{}; // the last frame, after it was due
    bool has_time_{}, returned_{};
    bool estimates_{};
    time_point estimated_at_{};
    unsigned silent_{}; // cycles
    std::uint32_t difference_{};
    unsigned above_{}; // cycles beyond the warning limit
    clock_agreement agreement_{};
    clock_statistics statistics_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/clock_cycle.ipp>
#endif
