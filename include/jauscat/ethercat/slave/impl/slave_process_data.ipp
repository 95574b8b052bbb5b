// The functions of slave_process_data.
#pragma once
#include <jauscat/ethercat/slave/slave_process_data.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION slave_process_data::slave_process_data(const slave_description& description) noexcept
    : outputs_{std::ranges::none_of(description.areas, &data_area::is_output) && description.outputs.empty(),
               description.output_size()},
      inputs_{std::ranges::all_of(description.areas, &data_area::is_output) && description.inputs.empty(),
              description.input_size()},
      usual_{{{.manager = static_cast<std::uint8_t>(description.output_manager()),
               .start = process_memory::outputs,
               .size = static_cast<std::uint16_t>(description.output_size()),
               .is_output = true},
              {.manager = static_cast<std::uint8_t>(description.input_manager()),
               .start = process_memory::inputs,
               .size = static_cast<std::uint16_t>(description.input_size())}}},
      other_{description.areas} {}

JAUSCAT_FUNCTION void slave_process_data::set_sizes(std::size_t outputs, std::size_t inputs) noexcept {
    outputs_ = {.none = outputs == 0, .size = outputs};
    inputs_ = {.none = inputs == 0, .size = inputs};
    usual_[0].size = static_cast<std::uint16_t>(outputs);
    usual_[1].size = static_cast<std::uint16_t>(inputs);
}

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
    for (const auto& each : areas())
        if (!accepts(each, memory.manager(each.manager)))
            return each.is_output ? al_status_code::output_configuration : al_status_code::input_configuration;
    return al_status_code::none;
}

JAUSCAT_FUNCTION void slave_process_data::enter(esc_memory& memory, al_state state) noexcept {
    const bool shut = state != al_state::safe_op && state != al_state::op;
    for (const auto& each : areas())
        if (!of(each).none) memory.disable(each.manager, shut);
    if (state == al_state::op) fed_ = is_fresh_ = true; // the watchdog begins to wait now
    missed_in_row_ = 0;
    show_watchdog(memory, true);
}

JAUSCAT_FUNCTION void slave_process_data::work(esc_memory& memory, al_state state) noexcept {
    std::size_t at = 0;
    for (const auto& each : areas()) {
        if (!each.is_output) continue;
        const auto place = std::exchange(at, at + each.size);
        if (!memory.take_written(each.manager) || !outputs_.fits() || outputs_.none) continue;
        fed_ = is_fresh_ = true;
        if (state != al_state::op) continue;
        std::ranges::copy(memory.bytes(each.start, each.size), in_force_.begin() + static_cast<std::ptrdiff_t>(place));
        taken_over_ = true;
    }
}

JAUSCAT_FUNCTION std::span<const std::byte> slave_process_data::outputs() const noexcept {
    return std::span{in_force_}.first(outputs_.size);
}

JAUSCAT_FUNCTION std::span<std::byte> slave_process_data::inputs(esc_memory& memory, std::size_t n) const noexcept {
    for (const auto& each : areas())
        if (!each.is_output && n-- == 0) return memory.bytes(each.start, inputs_.fits() ? each.size : 0);
    return {};
}

JAUSCAT_FUNCTION bool slave_process_data::expired(esc_memory& memory, time_point now) noexcept {
    const bool is_watched = std::ranges::any_of(
        areas(), [&](const data_area& each) { return each.is_output && memory.manager(each.manager).watchdog; });
    const auto time = watchdog_time(memory.load(esc_registers::watchdog_divider).value,
                                    memory.load(esc_registers::process_data_watchdog).value);
    if (std::exchange(fed_, false)) {
        last_ = now;
        return false;
    }
    if (outputs_.none || !is_watched || time == time.zero() || now - last_ < time) return false;
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

JAUSCAT_FUNCTION bool slave_process_data::accepts(const data_area& area, const sync_manager& sm) const noexcept {
    if (of(area).none) return !sm.enable || sm.length == 0;
    const auto direction =
        area.is_output ? sync_manager_direction::master_writes : sync_manager_direction::master_reads;
    return sm.enable && sm.mode == sync_manager_mode::buffered && sm.direction == direction && sm.start == area.start &&
           sm.length == area.size;
}

JAUSCAT_FUNCTION void slave_process_data::show_watchdog(esc_memory& memory, bool running) noexcept {
    memory.store(esc_registers::watchdog_status, {static_cast<std::uint16_t>(running ? 1 : 0)});
}

} // namespace jauscat::ethercat
