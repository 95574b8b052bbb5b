// Changes a slave's AL state step by step; reports the AL status code of a refusal.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>

#include <chrono>
#include <cstdint>

namespace jauscat::ethercat {

/// State machine: `request` adds the datagram of the present step, `reply` takes its return. Upwards one state at a
/// time, as slaves have it; downwards at once. An error that stands from before is acknowledged first. From a state
/// that is not known the way leads over INIT.
class state_change {
  public:
    /// At most, of a request: bytes and datagrams.
    static constexpr std::size_t request_size() noexcept { return datagram_overhead + wire::max_size<al_status>; }
    static constexpr std::size_t request_datagrams() noexcept { return 1; }

    state_change() noexcept = default;
    /// From whatever state the slave is in to `goal`.
    state_change(std::uint16_t station, al_state goal, const slave_timeouts& limits = {}) noexcept
        : station_{station}, goal_{goal}, limits_{limits} {}

    /// To INIT, whatever the state and whatever error stands: one frame and one poll where the slave is quick.
    JAUSCAT_FUNCTION static state_change to_init(std::uint16_t station, const slave_timeouts& limits) noexcept;
    /// From a state that the slave is known to be in, one step up.
    JAUSCAT_FUNCTION static state_change step_up(std::uint16_t station, al_state from,
                                                 const slave_timeouts& limits) noexcept;

    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }

    JAUSCAT_FUNCTION void request(frame_builder& frame) const noexcept;

    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point now, const master_config& config) noexcept;

  private:
    enum class step : std::uint8_t { look, acknowledge, wait_acknowledged, request, wait };

    JAUSCAT_FUNCTION progress on_the_way() noexcept;
    // BOOT is entered and left by INIT only.
    JAUSCAT_FUNCTION static al_state towards(al_state from, al_state goal) noexcept;
    JAUSCAT_FUNCTION static al_state above(al_state state) noexcept;

    // Of the step from `from_` to `next_`.
    [[nodiscard]] JAUSCAT_FUNCTION std::chrono::nanoseconds limit(const master_config& config) const noexcept;

    JAUSCAT_FUNCTION progress go(step next) noexcept;
    JAUSCAT_FUNCTION progress fail(const master_error& error) noexcept;

    std::uint16_t station_{};
    al_state goal_{}, from_{}, next_{};
    step step_{};
    slave_timeouts limits_{};
    timeout timeout_{};
    master_result<> result_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/state_change.ipp>
#endif
