// Changes a slave's AL state step by step; reports the AL status code of a refusal.
#pragma once

#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>

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
    state_change(std::uint16_t station, al_state goal) noexcept : station_{station}, goal_{goal} {}

    /// To INIT, whatever the state and whatever error stands: one frame and one poll where the slave is quick.
    static state_change to_init(std::uint16_t station) noexcept {
        state_change change{station, al_state::init};
        change.from_ = al_state::init;
        change.step_ = step::acknowledge;
        return change;
    }
    /// From a state that the slave is known to be in, one step up.
    static state_change step_up(std::uint16_t station, al_state from) noexcept {
        state_change change{station, above(from)};
        change.next_ = change.goal_;
        change.step_ = step::request;
        return change;
    }

    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }

    void request(frame_builder& frame) const noexcept {
        switch (step_) {
        case step::acknowledge:
            return frame.write(station_, esc_registers::al_control,
                               {.state = is_known(from_) ? from_ : al_state::init, .acknowledge = true});
        case step::request: return frame.write(station_, esc_registers::al_control, {.state = next_});
        case step::look:
        case step::wait_acknowledged:
        case step::wait: frame.read(station_, esc_registers::al_status);
        }
    }

    progress reply(replies datagrams, time_point now, const master_config& config) noexcept {
        if (result_ = executed_by_one(datagrams); !result_) return progress::done;
        if (step_ == step::acknowledge) return go(step::wait_acknowledged);
        if (step_ == step::request) return go(step::wait);

        const auto status = datagrams.front().value(esc_registers::al_status);
        const bool late = timeout_.expired(now, config.state_timeout);
        switch (step_) {
        case step::look: from_ = status.state; return status.error ? go(step::acknowledge) : on_the_way();
        case step::wait_acknowledged:
            from_ = status.state;
            if (!status.error) return on_the_way();
            return late ? fail({.code = master_errc::al_error, .al_status = status.code}) : progress::wait;
        default:
            if (status.error) return fail({.code = master_errc::al_error, .al_status = status.code});
            if (status.state != next_)
                return late ? fail({.code = master_errc::state_timeout, .state = status.state}) : progress::wait;
            from_ = next_;
            return on_the_way();
        }
    }

  private:
    enum class step : std::uint8_t { look, acknowledge, wait_acknowledged, request, wait };

    progress on_the_way() noexcept {
        if (from_ == goal_) return progress::done;
        next_ = towards(from_, goal_);
        return go(step::request);
    }
    // BOOT is entered and left by INIT only.
    static al_state towards(al_state from, al_state goal) noexcept {
        if (!is_known(from)) return al_state::init;
        if (goal == al_state::boot || from == al_state::boot) return from == al_state::init ? goal : al_state::init;
        return goal < from ? goal : above(from);
    }
    static al_state above(al_state state) noexcept {
        switch (state) {
        case al_state::init: return al_state::pre_op;
        case al_state::pre_op: return al_state::safe_op;
        default: return al_state::op;
        }
    }

    progress go(step next) noexcept {
        step_ = next;
        timeout_.renew();
        return progress::send;
    }
    progress fail(const master_error& error) noexcept {
        result_ = error;
        return progress::done;
    }

    std::uint16_t station_{};
    al_state goal_{}, from_{}, next_{};
    step step_{};
    timeout timeout_{};
    master_result<> result_{};
};

} // namespace jauscat::ethercat
