// The functions of esc_memory.
#pragma once
#include <jauscat/ethercat/slave/esc_memory.hpp>

namespace jauscat::ethercat {

JAUSCAT_CONSTEXPR void esc_memory::reset() noexcept {
    memory_.fill(std::byte{});
    open_.fill(false);
    written_.fill(false);
    al_control_written_ = sii_command_written_ = false;
    latches_ = false;
    clock_.power_on();
    store(esc_registers::description, {.type = 0x11, // FMMUs map bits, too
                                       .revision = 1,
                                       .build = 1,
                                       .fmmus = fmmu_count,
                                       .sync_managers = sync_manager_count,
                                       .ram = 8,
                                       .dc = has_clock(),
                                       .dc_64 = width_ == clock_width::bits_64,
                                       .dc_sync_activation = has_clock()});
    if (has_clock()) {
        store(esc_registers::dc_speed_start, {0x1000});
        store(esc_registers::dc_filters, {.difference = 4, .speed = 12});
        store(esc_registers::dc_pulse_length, {100});
    }
    store(esc_registers::al_status, {.state = al_state::init});
    store(esc_registers::watchdog_divider, {default_watchdog_divider});
    store(esc_registers::pdi_watchdog, {default_watchdog_time});
    store(esc_registers::process_data_watchdog, {default_watchdog_time});
    show_link();
}

JAUSCAT_CONSTEXPR void esc_memory::set_connected(std::size_t port, bool connected) noexcept {
    connected_[port] = connected;
    show_link();
}

JAUSCAT_CONSTEXPR void esc_memory::set_clock(clock_width width, const clock_error& error) noexcept {
    width_ = width;
    clock_.set_error(error);
    reset();
}

JAUSCAT_CONSTEXPR void esc_memory::begin_frame(time_point now) noexcept {
    latches_ = false;
    if (!has_clock()) return;
    clock_.advance(now);
    show_clock();
}

JAUSCAT_CONSTEXPR void esc_memory::frame_returned(std::size_t port, time_point now) noexcept {
    if (!has_clock()) return;
    clock_.advance(now);
    if (latches_) latch(port);
}

JAUSCAT_CONSTEXPR sync_manager esc_memory::manager(std::size_t n) const noexcept {
    return load(nth(esc_registers::sync_manager, n));
}

JAUSCAT_CONSTEXPR std::span<std::byte> esc_memory::area(const sync_manager& sm) noexcept {
    if (std::size_t{sm.start} + sm.length > memory_size) return {};
    return std::span{memory_}.subspan(sm.start, sm.length);
}

JAUSCAT_CONSTEXPR void esc_memory::set_full(std::size_t n, bool full) noexcept {
    auto sm = manager(n);
    sm.full = sm.write_event = full;
    sm.read_event = !full;
    store(nth(esc_registers::sync_manager, n), sm);
}

JAUSCAT_CONSTEXPR void esc_memory::acknowledge_repeat(std::size_t n) noexcept {
    auto sm = manager(n);
    sm.repeat_acknowledge = sm.repeat_request;
    store(nth(esc_registers::sync_manager, n), sm);
}

JAUSCAT_CONSTEXPR void esc_memory::disable(std::size_t n, bool disabled) noexcept {
    auto sm = manager(n);
    sm.pdi_disable = disabled;
    store(nth(esc_registers::sync_manager, n), sm);
}

JAUSCAT_CONSTEXPR std::span<std::byte> esc_memory::bytes(std::size_t start, std::size_t size) noexcept {
    return std::span{memory_}.subspan(start, size);
}

JAUSCAT_CONSTEXPR bool esc_memory::read(std::size_t address, std::span<std::byte> out, bool combine) noexcept {
    if (!may_access(address, out.size(), sync_manager_direction::master_reads)) return false;
    for (std::size_t i = 0; i != out.size(); ++i)
        out[i] = combine ? out[i] | memory_[address + i] : memory_[address + i];
    complete(address, out.size());
    return true;
}

JAUSCAT_CONSTEXPR bool esc_memory::write(std::size_t address, std::span<const std::byte> in) noexcept {
    if (!may_access(address, in.size(), sync_manager_direction::master_writes)) return false;
    for (std::size_t i = 0; i != in.size(); ++i)
        if (is_writable(address + i)) memory_[address + i] = in[i];
    complete(address, in.size());
    const auto touches = [&](esc_register r) {
        return address < r.address + r.size && address + in.size() > r.address;
    };
    if (touches(esc_registers::al_control)) al_control_written_ = true;
    if (touches(esc_registers::sii_control)) start_sii(address, in);
    if (touches(esc_registers::watchdog_counters)) store(esc_registers::watchdog_counters, {});
    if (has_clock() && touches(esc_registers::distributed_clock)) write_clock(address, in);
    for (std::size_t n = 0; n != sync_manager_count; ++n)
        if (touches(nth(esc_registers::sync_manager, n))) switch_off_if_disabled(n);
    return true;
}

JAUSCAT_CONSTEXPR bool esc_memory::may_access(std::size_t address, std::size_t size,
                                              sync_manager_direction direction) noexcept {
    if (size == 0 || address + size > memory_size) return false;
    bool allowed = true;
    for_managers(address, size, [&](std::size_t n, const sync_manager& sm) {
        const bool wants_full = direction == sync_manager_direction::master_reads;
        if (sm.direction != direction || sm.pdi_disable) allowed = false;
        if (sm.mode == sync_manager_mode::mailbox && sm.full != wants_full) allowed = false;
        if (address > sm.start && !open_[n]) allowed = false;
    });
    return allowed;
}

JAUSCAT_CONSTEXPR void esc_memory::complete(std::size_t address, std::size_t size) noexcept {
    for_managers(address, size, [&](std::size_t n, const sync_manager& sm) {
        open_[n] = address + size < std::size_t{sm.start} + sm.length;
        if (open_[n]) return;
        if (sm.mode == sync_manager_mode::mailbox) return set_full(n, !sm.full);
        exchange_buffer(n, sm.direction);
    });
}

JAUSCAT_CONSTEXPR void esc_memory::exchange_buffer(std::size_t n, sync_manager_direction direction) noexcept {
    auto sm = manager(n);
    const bool written = direction == sync_manager_direction::master_writes;
    sm.write_event = written;
    sm.read_event = !written;
    if (written) sm.last_buffer = static_cast<std::uint8_t>((sm.last_buffer + 1) % 3);
    store(nth(esc_registers::sync_manager, n), sm);
    if (written) written_[n] = true;
}

JAUSCAT_CONSTEXPR void esc_memory::show_link() noexcept {
    store(esc_registers::dl_status, {.link_0 = true,
                                     .link_1 = connected_[1],
                                     .link_2 = connected_[2],
                                     .link_3 = connected_[3],
                                     .communication_0 = true,
                                     .closed_1 = !connected_[1],
                                     .communication_1 = connected_[1],
                                     .closed_2 = !connected_[2],
                                     .communication_2 = connected_[2],
                                     .closed_3 = !connected_[3],
                                     .communication_3 = connected_[3]});
    constexpr unsigned mii = 3, first_two = 0x0F;
    memory_[esc_registers::ports.address] =
        static_cast<std::byte>(first_two | (connected_[2] ? mii << 4 : 0u) | (connected_[3] ? mii << 6 : 0u));
}

JAUSCAT_CONSTEXPR void esc_memory::store_time(const esc_register_of<dc_time>& at, std::uint64_t ns) noexcept {
    if (width_ == clock_width::bits_64)
        store(at, {ns});
    else
        store(low_half(at), {static_cast<std::uint32_t>(ns)});
}

JAUSCAT_CONSTEXPR void esc_memory::show_clock() noexcept {
    store_time(esc_registers::dc_system_time, clock_.reference_time());
    show_control();
    show_sync();
}

JAUSCAT_CONSTEXPR void esc_memory::show_control() noexcept {
    store(esc_registers::dc_difference, clock_.difference());
    store(esc_registers::dc_speed_difference, clock_.speed_difference());
}

JAUSCAT_CONSTEXPR void esc_memory::show_sync() noexcept {
    store(esc_registers::dc_activation_status, clock_.activation_status());
    if (clock_.next_sync0() != slave_clock::never) store_time(esc_registers::dc_start_time, clock_.next_sync0());
    if (clock_.next_sync1() != slave_clock::never) store_time(esc_registers::dc_next_sync1, clock_.next_sync1());
}

JAUSCAT_CONSTEXPR void esc_memory::latch(std::size_t port) noexcept {
    const auto at = static_cast<std::uint16_t>(esc_registers::dc_receive_times.address + 4 * port);
    store(esc_register_of<dc_time_32>{{at, 4}}, {static_cast<std::uint32_t>(clock_.local_time())});
}

JAUSCAT_CONSTEXPR void esc_memory::write_clock(std::size_t address, std::span<const std::byte> in) noexcept {
    const auto touches = [&](const esc_register& r) {
        return address < std::size_t{r.address} + r.size && address + in.size() > r.address;
    };
    if (address == esc_registers::dc_receive_times.address) {
        latches_ = true;
        latch(0);
        store_time(esc_registers::dc_processing_time, clock_.local_time());
    }
    constexpr auto received = low_half(esc_registers::dc_system_time);
    if (address <= received.address && address + in.size() >= std::size_t{received.address} + received.size) {
        dc_time_32 time{};
        static_cast<void>(wire::decode_prefix(time, in.subspan(received.address - address)));
        clock_.compare(time.value);
    }
    if (touches(esc_registers::dc_delay)) clock_.set_delay(load(esc_registers::dc_delay).value);
    if (touches(esc_registers::dc_offset)) set_offset();
    if (touches(esc_registers::dc_speed_start) && is_masters_sync())
        clock_.restart(load(esc_registers::dc_speed_start).value, load(esc_registers::dc_filters));
    show_control();
    const bool starts = touches(esc_registers::dc_start_time);
    if ((!starts && !touches(esc_registers::dc_activation)) || !is_masters_sync()) return;
    auto activation = load(esc_registers::dc_activation);
    if (starts && activation.on_by_start_time) activation.on = true;
    activation.test_pulse = false;
    store(esc_registers::dc_activation, activation);
    const bool is_short = in.size() <= 4 && activation.extend_start;
    clock_.activate(activation, start_time(starts && is_short), load(esc_registers::dc_sync0_cycle).value,
                    load(esc_registers::dc_sync1_cycle).value, width_);
    show_sync();
}

JAUSCAT_CONSTEXPR void esc_memory::set_offset() noexcept {
    const auto offset = load(esc_registers::dc_offset).value;
    clock_.set_offset(width_ == clock_width::bits_64 ? offset : static_cast<std::uint32_t>(offset));
}

JAUSCAT_CONSTEXPR std::uint64_t esc_memory::start_time(bool extends) const noexcept {
    const auto start = load(esc_registers::dc_start_time).value;
    const auto now = clock_.system_time();
    return extends ? now + (static_cast<std::uint32_t>(start) - static_cast<std::uint32_t>(now)) : start;
}

JAUSCAT_CONSTEXPR bool esc_memory::is_masters_sync() const noexcept {
    return !load(esc_registers::dc_cyclic_control).sync_by_pdi;
}

JAUSCAT_CONSTEXPR bool esc_memory::is_writable_clock(std::size_t address) const noexcept {
    namespace registers = esc_registers;
    if (!has_clock()) return false;
    const auto in_time = [&](const esc_register& r) {
        return is_within(r, address) && (width_ == clock_width::bits_64 || address - r.address < 4);
    };
    if (is_within(registers::dc_cyclic_control, address)) return true;
    if (is_within(registers::dc_latch0_control, address)) return !load(registers::dc_cyclic_control).latch0_by_pdi;
    if (is_within(registers::dc_latch1_control, address)) return !load(registers::dc_cyclic_control).latch1_by_pdi;
    const bool is_sync = in_time(registers::dc_offset) || is_within(registers::dc_delay, address) ||
                         is_within(registers::dc_speed_start, address) || is_within(registers::dc_filters, address) ||
                         is_within(registers::dc_activation, address) || in_time(registers::dc_start_time) ||
                         is_within(registers::dc_sync0_cycle, address) || is_within(registers::dc_sync1_cycle, address);
    return is_sync && is_masters_sync();
}

JAUSCAT_CONSTEXPR bool esc_memory::is_within(const esc_register& r, std::size_t address) noexcept {
    return address >= r.address && address < std::size_t{r.address} + r.size;
}

JAUSCAT_CONSTEXPR bool esc_memory::is_writable(std::size_t address) const noexcept {
    if (address >= esc_registers::process_ram.address) return true;
    const std::size_t managers = esc_registers::sync_manager.address;
    if (address >= managers && address < managers + sync_manager_count * esc_registers::sync_manager.size) {
        const std::size_t byte = (address - managers) % esc_registers::sync_manager.size;
        const bool enabled = manager((address - managers) / esc_registers::sync_manager.size).enable;
        return byte == 6 || (byte < 5 && !enabled); // 5 and 7 are the slave's; 0 to 4 are fixed while enabled
    }
    const std::size_t mappings = esc_registers::fmmu.address;
    if (address >= mappings && address < mappings + fmmu_count * esc_registers::fmmu.size)
        return (address - mappings) % esc_registers::fmmu.size < 13; // the last 3 bytes are reserved
    if (is_within(esc_registers::distributed_clock, address)) return is_writable_clock(address);
    const auto within = [&](const esc_register& r) { return is_within(r, address); };
    return within(esc_registers::station_address) || within(esc_registers::dl_control) ||
           within(esc_registers::digital_outputs) || within(esc_registers::al_control) ||
           within(esc_registers::ecat_event_mask) || within(esc_registers::watchdog_divider) ||
           within(esc_registers::pdi_watchdog) || within(esc_registers::process_data_watchdog) ||
           within(esc_registers::sii_owner) ||
           ((within(esc_registers::sii_address) || within(esc_registers::sii_data)) && sii_is_masters());
}

JAUSCAT_CONSTEXPR void esc_memory::start_sii(std::size_t address, std::span<const std::byte> in) noexcept {
    if (!sii_is_masters() || address > esc_registers::sii_control.address) return;
    const auto written = in.subspan(esc_registers::sii_control.address - address);
    std::array<std::byte, wire::max_size<sii_request>> bytes{};
    std::ranges::copy(written.first(std::min<std::size_t>(written.size(), 2)), bytes.begin());
    sii_request asked{};
    static_cast<void>(wire::decode_prefix(asked, bytes));
    auto now = load(esc_registers::sii_request);
    now.write_enable = asked.write_enable;
    now.cmd = asked.cmd;
    now.command_error = now.write_enable_error = false;
    now.busy = sii_command_written_ = asked.cmd != sii_command::clear;
    store(esc_registers::sii_request, now);
}

JAUSCAT_CONSTEXPR void esc_memory::switch_off_if_disabled(std::size_t n) noexcept {
    auto sm = manager(n);
    if (sm.enable) return;
    open_[n] = false;
    sm.full = sm.write_event = sm.read_event = sm.repeat_acknowledge = false;
    sm.last_buffer = 0;
    store(nth(esc_registers::sync_manager, n), sm);
}

} // namespace jauscat::ethercat
