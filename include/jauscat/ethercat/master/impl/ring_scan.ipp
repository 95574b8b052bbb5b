// The functions of ring_scan.
#pragma once
#include <jauscat/ethercat/master/ring_scan.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION void ring_scan::request(frame_builder& frame) const noexcept {
    switch (step_) {
    case step::count: frame.add(command::brd, 0, esc_registers::type.address, std::size_t{1}); break;
    case step::clear: // what a slave does not have, it leaves alone
        frame.write_all(esc_registers::al_control, {.state = al_state::init, .acknowledge = true});
        frame.add(command::bwr, 0, esc_registers::dl_control.address + 1, std::size_t{1}); // ports open by themselves
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

JAUSCAT_FUNCTION progress ring_scan::reply(replies datagrams, time_point now, const master_config& config) noexcept {
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

} // namespace jauscat::ethercat
