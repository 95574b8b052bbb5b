// Counts the slaves of a ring and resets the configuration left by an earlier master.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/dc_registers.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>

#include <cstddef>
#include <cstdint>

namespace jauscat::ethercat {

/// State machine: `request` adds the datagrams of the present step, `reply` takes their return. Three frames and a few
/// polls, however many slaves there are.
class ring_scan {
  public:
    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }
    [[nodiscard]] std::uint16_t slaves() const noexcept { return slaves_; }

    JAUSCAT_FUNCTION void request(frame_builder& frame) const noexcept;

    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point now, const master_config& config) noexcept;

  private:
    enum class step : std::uint8_t { count, clear, wait_init };
    static constexpr std::size_t fmmus_cleared = 8, managers_cleared = 8; // as the largest controllers have

    step step_{};
    std::uint16_t slaves_{};
    timeout timeout_{};
    master_result<> result_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/ring_scan.ipp>
#endif
