// Sets distributed clocks up: open ports, receive times, delays, offsets, restart of the control, drift.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/clock_jobs.hpp>
#include <jauscat/ethercat/master/clock_topology.hpp>
#include <jauscat/schema/ethercat/dc_registers.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// State machine: `request` adds the datagrams of the present step, `reply` takes their return and moves on. For n
/// slaves about 0.7 n frames, and those that carry the reference time.
class clock_setup {
  public:
    clock_setup() noexcept = default;
    explicit clock_setup(const set_up_clocks& job) noexcept
        : slaves_{job.slaves}, options_{job.options}, begun_{job.system_time} {}

    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }
    [[nodiscard]] const clock_network& network() const noexcept { return network_; }

    JAUSCAT_FUNCTION void request(frame_builder& frame) const noexcept;

    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point now, const master_config&) noexcept;

  private:
    enum class step : std::uint8_t { look, latch, read, write, drift, check };

    static constexpr std::size_t datagrams_per_frame = 15;

    // The slaves of the present frame.
    [[nodiscard]] JAUSCAT_FUNCTION std::span<clock_record> batch() const noexcept;

    // A slave has as many datagrams in each frame of a step.
    [[nodiscard]] JAUSCAT_FUNCTION std::size_t count(const clock_record& slave) const noexcept;
    JAUSCAT_FUNCTION void request(frame_builder& frame, const clock_record& slave) const noexcept;
    JAUSCAT_FUNCTION master_result<> take(clock_record& slave, replies datagrams) noexcept;

    JAUSCAT_FUNCTION progress step_done() noexcept;

    [[nodiscard]] clock_record& reference() const noexcept { return slaves_[reference_]; }

    JAUSCAT_FUNCTION progress compute() noexcept;

    // Time of the reference clock when the frame passed it: that of the clocks that run, the master's if none does.
    [[nodiscard]] JAUSCAT_FUNCTION std::uint64_t time_of_latch() const noexcept;

    JAUSCAT_FUNCTION progress drift(unsigned frames) noexcept;
    JAUSCAT_FUNCTION progress drifted(const datagram_view& back) noexcept;
    JAUSCAT_FUNCTION progress checked() noexcept;

    JAUSCAT_FUNCTION progress go(step next) noexcept;
    JAUSCAT_FUNCTION progress fail(const master_error& error) noexcept;

    JAUSCAT_FUNCTION progress fail_at(std::uint16_t station) noexcept;

    static constexpr std::uint16_t speed_start = 0x1000;

    std::span<clock_record> slaves_{};
    clock_options options_{};
    step step_{};
    std::size_t first_{}; // of the present frame
    std::size_t reference_{};
    bool has_begun_{};
    std::uint64_t begun_{}; // system time at begun_at_
    time_point begun_at_{};
    std::uint64_t latched_{};        // system time of the frame that passed all slaves
    std::uint64_t reference_time_{}; // as it was last seen
    unsigned drift_left_{};
    unsigned repeats_{};
    clock_network network_{};
    master_result<> result_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/clock_setup.ipp>
#endif
