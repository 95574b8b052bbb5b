// The functions of slave_process_data.
#pragma once
#include <jauscat/ethercat/slave/slave_process_data.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION slave_process_data::slave_process_data(const slave_description& description) noexcept
    : outputs_{description.output_manager(), process_memory::outputs, description.output_size(),
               description.outputs.empty()},
      inputs_{description.input_manager(), process_memory::inputs, description.input_size(),
              description.inputs.empty()} {}

JAUSCAT_FUNCTION void slave_process_data::power_on(esc_memory& memory) noexcept {
    in_force_.fill(std::byte{});
    taken_over_ = fed_ = is_fresh_ = false;
    sync_missed_ = 0;
    missed_in_row_ = 0;
    enter(memory, al_state::init);
}

JAUSCAT_FUNCTION al_status_code slave_process_data::refusal(const esc_memory& memory) const noexcept {
    if (!outputs_.fits()) return al_status_code::output_mapping;
    if (!inputs_.fits()) return al_status_code::input_mapping;
    if (!outputs_.accepts(memory.manager(outputs_.manager), sync_manager_direction::master_writes))
        return al_status_code::output_configuration;
    if (!inputs_.accepts(memory.manager(inputs_.manager), sync_manager_direction::master_reads))
        return al_status_code::input_configuration;
    return al_status_code::none;
}

JAUSCAT_FUNCTION void slave_process_data::enter(esc_memory& memory, al_state state) noexcept {
    const bool shut = state != al_state::safe_op && state != al_state::op;
    if (!outputs_.none) memory.disable(outputs_.manager, shut);
    if (!inputs_.none) memory.disable(inputs_.manager, shut);
    if (state == al_state::op) fed_ = is_fresh_ = true; // the watchdog begins to wait now
    missed_in_row_ = 0;
    show_watchdog(memory, true);
}

JAUSCAT_FUNCTION void slave_process_data::work(esc_memory& memory, al_state state) noexcept {
    if (!memory.take_written(outputs_.manager) || outputs_.none) return;
    fed_ = is_fresh_ = true;
    if (state != al_state::op) return;
    std::ranges::copy(memory.bytes(outputs_.start, outputs_.size), in_force_.begin());
    taken_over_ = true;
}

JAUSCAT_FUNCTION std::span<const std::byte> slave_process_data::outputs() const noexcept {
    return std::span{in_force_}.first(outputs_.size);
}

JAUSCAT_FUNCTION bool slave_process_data::expired(esc_memory& memory, time_point now) noexcept {
    const auto manager = memory.manager(outputs_.manager);
    const auto time = watchdog_time(memory.load(esc_registers::watchdog_divider).value,
                                    memory.load(esc_registers::process_data_watchdog).value);
    if (std::exchange(fed_, false)) {
        last_ = now;
        return false;
    }
    if (outputs_.none || !manager.watchdog || time == time.zero() || now - last_ < time) return false;
    show_watchdog(memory, false);
    auto counters = memory.load(esc_registers::watchdog_counters);
    if ((counters.value & 0xFF) != 0xFF) ++counters.value;
    memory.store(esc_registers::watchdog_counters, counters);
    return true;
}

JAUSCAT_FUNCTION void slave_process_data::on_sync0(std::uint64_t count) noexcept {
    if (count == 0 || outputs_.none) return;
    const auto missed = count - (std::exchange(is_fresh_, false) ? 1 : 0);
    missed_in_row_ = missed == count ? missed_in_row_ + missed : missed;
    sync_missed_ += missed;
}

JAUSCAT_FUNCTION bool slave_process_data::area::accepts(const sync_manager& sm,
                                                        sync_manager_direction direction) const noexcept {
    if (none) return !sm.enable || sm.length == 0;
    return sm.enable && sm.mode == sync_manager_mode::buffered && sm.direction == direction && sm.start == start &&
           sm.length == size;
}

JAUSCAT_FUNCTION void slave_process_data::show_watchdog(esc_memory& memory, bool running) noexcept {
    memory.store(esc_registers::watchdog_status, {static_cast<std::uint16_t>(running ? 1 : 0)});
}

} // namespace jauscat::ethercat
