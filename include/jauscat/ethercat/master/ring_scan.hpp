// Counts the slaves of a ring and resets the configuration left by an earlier master.
#pragma once

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

    void request(frame_builder& frame) const noexcept {
        switch (step_) {
        case step::count: frame.add(command::brd, 0, esc_registers::type.address, std::size_t{1}); break;
        case step::clear: // what a slave does not have, it leaves alone
            frame.write_all(esc_registers::al_control, {.state = al_state::init, .acknowledge = true});
            frame.add(command::bwr, 0, esc_registers::dl_control.address + 1,
                      std::size_t{1}); // ports open by themselves
            frame.write_all(esc_registers::station_address, {});
            frame.add(command::bwr, 0, esc_registers::fmmu.address, fmmus_cleared * esc_registers::fmmu.size);
            frame.add(command::bwr, 0, esc_registers::sync_manager.address,
                      managers_cleared * esc_registers::sync_manager.size);
            frame.add(command::bwr, 0, esc_registers::dc_activation.address,
                      std::size_t{esc_registers::dc_activation.size});
            break;
        case step::wait_init: frame.read_all(esc_registers::al_status);
        }
    }

    progress reply(replies datagrams, time_point now, const master_config& config) noexcept {
        const auto& first = datagrams.front();
        if (step_ == step::count) {
            slaves_ = first.working_counter;
            if (slaves_ == 0) return progress::done;
            step_ = step::clear;
            return progress::send;
        }
        if (first.working_counter != slaves_) { // one came or went
            result_ = master_error{.code = master_errc::working_counter, .working_counter = first.working_counter};
            return progress::done;
        }
        if (step_ == step::clear) {
            step_ = step::wait_init;
            return progress::send;
        }
        const auto all = first.value(esc_registers::al_status); // the states of all slaves, or-ed
        if (all.state == al_state::init && !all.error) return progress::done;
        if (!timeout_.expired(now, config.state_timeout)) {
            if (all.error) step_ = step::clear; // one that came up since
            return progress::wait;
        }
        result_ = master_error{.code = master_errc::state_timeout, .state = all.state};
        return progress::done;
    }

  private:
    enum class step : std::uint8_t { count, clear, wait_init };
    static constexpr std::size_t fmmus_cleared = 8, managers_cleared = 8; // as the largest controllers have

    step step_{};
    std::uint16_t slaves_{};
    timeout timeout_{};
    master_result<> result_{};
};

} // namespace jauscat::ethercat
