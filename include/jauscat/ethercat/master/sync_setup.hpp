// Switches the SYNC signals of slaves on, at start times that fit together.
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

/// The system time of the first SYNC0: not before `earliest`, a multiple of the period since 2000, plus the shift.
[[nodiscard]] constexpr std::uint64_t sync_start(std::uint64_t earliest, const sync_settings& sync) noexcept {
    const auto period = std::max<std::uint64_t>(sync.period(), 1);
    const auto shift = static_cast<std::uint64_t>(sync.shift.count());
    return (earliest - shift + period - 1) / period * period + shift;
}

/// State machine: `request` adds the datagrams of the present step, `reply` takes their return and moves on. One frame
/// for each three slaves, and two.
class sync_setup {
  public:
    sync_setup() noexcept = default;
    JAUSCAT_FUNCTION explicit sync_setup(const start_sync& job) noexcept;

    [[nodiscard]] bool has_reference() const noexcept { return reference_ != slaves_.size(); }
    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }
    [[nodiscard]] std::uint64_t start() const noexcept { return start_; }

    JAUSCAT_FUNCTION void request(frame_builder& frame) const noexcept;

    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point, const master_config&) noexcept;

  private:
    enum class step : std::uint8_t { read, write, verify };

    [[nodiscard]] JAUSCAT_FUNCTION static bool takes_part(const clock_record& slave) noexcept;
    // Behind the slaves of the present frame, which holds three that take part.
    [[nodiscard]] JAUSCAT_FUNCTION std::size_t last() const noexcept;

    // The start time comes before the activation, which is in the same frame. The owner of the units is written only
    // where the slave is to have some of them: there are slaves that do not like it.
    JAUSCAT_FUNCTION static void request(frame_builder& frame, const clock_record& slave) noexcept;

    JAUSCAT_FUNCTION void take_time(const datagram_view& back) noexcept;
    // Once more, with more time.
    JAUSCAT_FUNCTION progress late() noexcept;
    JAUSCAT_FUNCTION progress go(step next) noexcept;

    static constexpr unsigned max_attempts = 4;

    std::span<clock_record> slaves_{};
    std::size_t reference_{};
    step step_{};
    std::size_t first_{}; // of the present frame
    std::uint64_t time_{};
    std::uint64_t lead_{};
    std::uint64_t start_{};
    unsigned attempts_{};
    master_result<> result_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/sync_setup.ipp>
#endif
