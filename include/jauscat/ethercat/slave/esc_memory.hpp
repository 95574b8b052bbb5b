// The memory of an emulated EtherCAT slave controller: registers, process memory, and the SyncManagers that decide
// which access counts. esc.hpp processes frames.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/ethercat/slave/slave_clock.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/dc_registers.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/watchdog.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

namespace jauscat::ethercat {

/// Register file, 8 KiB of process memory, 8 SyncManagers, the registers of 8 FMMUs and, if it has one, those of a
/// distributed clock.
class esc_memory {
  public:
    static constexpr std::size_t memory_size = 0x3000; ///< bytes: 0x1000 of registers, then process memory
    static constexpr std::size_t sync_manager_count = 8;
    static constexpr std::size_t fmmu_count = 8;

    constexpr esc_memory() noexcept { reset(); }

    /// As after power-on: state INIT, station address 0, all SyncManagers and FMMUs off, no system time.
    constexpr void reset() noexcept {
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

    /// Whether another slave is connected to port 1. Kept over a reset.
    constexpr void set_downstream(bool connected) noexcept { set_connected(1, connected); }
    /// Whether another slave is connected to a port, 1 to 3. Kept over a reset.
    constexpr void set_connected(std::size_t port, bool connected) noexcept {
        connected_[port] = connected;
        show_link();
    }

    /// Gives it a clock, or none, as after power-on. Kept over a reset.
    constexpr void set_clock(clock_width width, const clock_error& error) noexcept {
        width_ = width;
        clock_.set_error(error);
        reset();
    }
    [[nodiscard]] constexpr bool has_clock() const noexcept { return width_ != clock_width::no_clock; }
    [[nodiscard]] constexpr const slave_clock& clock() const noexcept { return clock_; }
    [[nodiscard]] constexpr slave_clock& clock() noexcept { return clock_; }
    /// It is `now`: a frame begins to pass the processing unit. Times in registers are those of this instant.
    constexpr void begin_frame(time_point now) noexcept {
        latches_ = false;
        if (!has_clock()) return;
        clock_.advance(now);
        show_clock();
    }
    /// The same frame begins to come back at a port, `now`.
    constexpr void frame_returned(std::size_t port, time_point now) noexcept {
        if (!has_clock()) return;
        clock_.advance(now);
        if (latches_) latch(port);
    }

    /// The application's view of a register.
    template <wire::message T> [[nodiscard]] constexpr T load(const esc_register_of<T>& at) const noexcept {
        T value{};
        static_cast<void>(wire::decode_prefix(value, std::span{memory_}.subspan(at.address)));
        return value;
    }
    /// Writes a register as the slave itself does, without the rules for masters.
    template <wire::message T>
    constexpr void store(const esc_register_of<T>& at, const std::type_identity_t<T>& value) noexcept {
        static_cast<void>(wire::encode(value, std::span{memory_}.subspan(at.address)));
    }

    /// The SyncManager `n`, from 0.
    [[nodiscard]] constexpr sync_manager manager(std::size_t n) const noexcept {
        return load(nth(esc_registers::sync_manager, n));
    }
    /// The memory of a SyncManager; empty if it is outside of the memory.
    [[nodiscard]] constexpr std::span<std::byte> area(const sync_manager& sm) noexcept {
        if (std::size_t{sm.start} + sm.length > memory_size) return {};
        return std::span{memory_}.subspan(sm.start, sm.length);
    }
    /// Mailbox `n` has been filled (true) or emptied (false).
    constexpr void set_full(std::size_t n, bool full) noexcept {
        auto sm = manager(n);
        sm.full = sm.write_event = full;
        sm.read_event = !full;
        store(nth(esc_registers::sync_manager, n), sm);
    }
    /// The application has completed the master's repeat request of SyncManager `n`.
    constexpr void acknowledge_repeat(std::size_t n) noexcept {
        auto sm = manager(n);
        sm.repeat_acknowledge = sm.repeat_request;
        store(nth(esc_registers::sync_manager, n), sm);
    }

    /// True once after each write of all of buffered SyncManager `n`.
    constexpr bool take_written(std::size_t n) noexcept { return std::exchange(written_[n], false); }
    /// The slave shuts a SyncManager (true), or opens it.
    constexpr void disable(std::size_t n, bool disabled) noexcept {
        auto sm = manager(n);
        sm.pdi_disable = disabled;
        store(nth(esc_registers::sync_manager, n), sm);
    }
    /// The FMMU `n`, from 0.
    [[nodiscard]] constexpr fmmu mapping(std::size_t n) const noexcept { return load(nth(esc_registers::fmmu, n)); }
    /// Memory, regardless of the SyncManagers; within `memory_size`.
    [[nodiscard]] constexpr std::span<std::byte> bytes(std::size_t start, std::size_t size) noexcept {
        return std::span{memory_}.subspan(start, size);
    }

    /// True once after each write to AL control.
    constexpr bool take_al_control() noexcept { return std::exchange(al_control_written_, false); }
    /// True once after each command to the SII; the controller shows busy until `sii_done`.
    constexpr bool take_sii_command() noexcept { return std::exchange(sii_command_written_, false); }

    /// A master's read of memory, or'ed to what `out` holds where `combine`. False if it does not count.
    [[nodiscard]] constexpr bool read(std::size_t address, std::span<std::byte> out, bool combine = false) noexcept {
        if (!may_access(address, out.size(), sync_manager_direction::master_reads)) return false;
        for (std::size_t i = 0; i != out.size(); ++i)
            out[i] = combine ? out[i] | memory_[address + i] : memory_[address + i];
        complete(address, out.size());
        return true;
    }

    /// A master's write of memory. False if it does not count.
    [[nodiscard]] constexpr bool write(std::size_t address, std::span<const std::byte> in) noexcept {
        if (!may_access(address, in.size(), sync_manager_direction::master_writes)) return false;
        for (std::size_t i = 0; i != in.size(); ++i)
            if (is_writable(address + i)) memory_[address + i] = in[i];
        complete(address, in.size());
        const auto touches = [&](esc_register r) {
            return address < r.address + r.size && address + in.size() > r.address;
        };
        if (touches(esc_registers::al_control)) al_control_written_ = true;
        if (touches(esc_registers::sii_control)) start_sii(address, in);
        if (has_clock() && touches(esc_registers::distributed_clock)) write_clock(address, in);
        for (std::size_t n = 0; n != sync_manager_count; ++n)
            if (touches(nth(esc_registers::sync_manager, n))) switch_off_if_disabled(n);
        return true;
    }

  private:
    /// Calls f(n, manager) for each SyncManager that is enabled and shares a byte with the access.
    constexpr void for_managers(std::size_t address, std::size_t size, auto&& f) noexcept {
        if (address + size <= esc_registers::process_ram.address) return;
        for (std::size_t n = 0; n != sync_manager_count; ++n) {
            const auto sm = manager(n);
            if (!sm.enable || sm.length == 0) continue;
            if (address < std::size_t{sm.start} + sm.length && address + size > sm.start) f(n, sm);
        }
    }

    // A SyncManager's area opens with its first byte, and for one direction; a mailbox only if it has a message to read
    // or is empty for writing.
    [[nodiscard]] constexpr bool may_access(std::size_t address, std::size_t size,
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

    // An area changes hands with its last byte.
    constexpr void complete(std::size_t address, std::size_t size) noexcept {
        for_managers(address, size, [&](std::size_t n, const sync_manager& sm) {
            open_[n] = address + size < std::size_t{sm.start} + sm.length;
            if (open_[n]) return;
            if (sm.mode == sync_manager_mode::mailbox) return set_full(n, !sm.full);
            exchange_buffer(n, sm.direction);
        });
    }

    // The master always accesses the first of three buffers; the status has the number of the active one.
    constexpr void exchange_buffer(std::size_t n, sync_manager_direction direction) noexcept {
        auto sm = manager(n);
        const bool written = direction == sync_manager_direction::master_writes;
        sm.write_event = written;
        sm.read_event = !written;
        if (written) sm.last_buffer = static_cast<std::uint8_t>((sm.last_buffer + 1) % 3);
        store(nth(esc_registers::sync_manager, n), sm);
        if (written) written_[n] = true;
    }

    // A port has a link if something is connected, port 0 always. Ports 2 and 3 exist only then.
    constexpr void show_link() noexcept {
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

    constexpr void store_time(const esc_register_of<dc_time>& at, std::uint64_t ns) noexcept {
        if (width_ == clock_width::bits_64)
            store(at, {ns});
        else
            store(low_half(at), {static_cast<std::uint32_t>(ns)});
    }
    constexpr void show_clock() noexcept {
        store_time(esc_registers::dc_system_time, clock_.reference_time());
        show_control();
        show_sync();
    }
    constexpr void show_control() noexcept {
        store(esc_registers::dc_difference, clock_.difference());
        store(esc_registers::dc_speed_difference, clock_.speed_difference());
    }
    constexpr void show_sync() noexcept {
        store(esc_registers::dc_activation_status, clock_.activation_status());
        if (clock_.next_sync0() != slave_clock::never) store_time(esc_registers::dc_start_time, clock_.next_sync0());
        if (clock_.next_sync1() != slave_clock::never) store_time(esc_registers::dc_next_sync1, clock_.next_sync1());
    }
    constexpr void latch(std::size_t port) noexcept {
        const auto at = static_cast<std::uint16_t>(esc_registers::dc_receive_times.address + 4 * port);
        store(esc_register_of<dc_time_32>{{at, 4}}, {static_cast<std::uint32_t>(clock_.local_time())});
    }

    // What a master's write to the clock does beside what it stores.
    constexpr void write_clock(std::size_t address, std::span<const std::byte> in) noexcept {
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
    constexpr void set_offset() noexcept {
        const auto offset = load(esc_registers::dc_offset).value;
        clock_.set_offset(width_ == clock_width::bits_64 ? offset : static_cast<std::uint32_t>(offset));
    }
    // A start time of 4 bytes is the next one that ends so.
    [[nodiscard]] constexpr std::uint64_t start_time(bool extends) const noexcept {
        const auto start = load(esc_registers::dc_start_time).value;
        const auto now = clock_.system_time();
        return extends ? now + (static_cast<std::uint32_t>(start) - static_cast<std::uint32_t>(now)) : start;
    }
    [[nodiscard]] constexpr bool is_masters_sync() const noexcept {
        return !load(esc_registers::dc_cyclic_control).sync_by_pdi;
    }
    // Registers of the clock that keep what a master writes.
    [[nodiscard]] constexpr bool is_writable_clock(std::size_t address) const noexcept {
        namespace registers = esc_registers;
        if (!has_clock()) return false;
        const auto in_time = [&](const esc_register& r) {
            return is_within(r, address) && (width_ == clock_width::bits_64 || address - r.address < 4);
        };
        if (is_within(registers::dc_cyclic_control, address)) return true;
        if (is_within(registers::dc_latch0_control, address)) return !load(registers::dc_cyclic_control).latch0_by_pdi;
        if (is_within(registers::dc_latch1_control, address)) return !load(registers::dc_cyclic_control).latch1_by_pdi;
        const bool is_sync =
            in_time(registers::dc_offset) || is_within(registers::dc_delay, address) ||
            is_within(registers::dc_speed_start, address) || is_within(registers::dc_filters, address) ||
            is_within(registers::dc_activation, address) || in_time(registers::dc_start_time) ||
            is_within(registers::dc_sync0_cycle, address) || is_within(registers::dc_sync1_cycle, address);
        return is_sync && is_masters_sync();
    }

    [[nodiscard]] static constexpr bool is_within(const esc_register& r, std::size_t address) noexcept {
        return address >= r.address && address < std::size_t{r.address} + r.size;
    }

    // Registers that a master may write. A write to another one is counted in the working counter, and ignored.
    [[nodiscard]] constexpr bool is_writable(std::size_t address) const noexcept {
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
               within(esc_registers::al_control) || within(esc_registers::ecat_event_mask) ||
               within(esc_registers::watchdog_divider) || within(esc_registers::pdi_watchdog) ||
               within(esc_registers::process_data_watchdog) || within(esc_registers::sii_owner) ||
               (within(esc_registers::sii_address) && sii_is_masters());
    }

    [[nodiscard]] constexpr bool sii_is_masters() const noexcept { return !load(esc_registers::sii_owner).pdi; }

    // Read-only bits keep their value; the command and the write enable are copied, and any command makes the SII busy.
    constexpr void start_sii(std::size_t address, std::span<const std::byte> in) noexcept {
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

    constexpr void switch_off_if_disabled(std::size_t n) noexcept {
        auto sm = manager(n);
        if (sm.enable) return;
        open_[n] = false;
        sm.full = sm.write_event = sm.read_event = sm.repeat_acknowledge = false;
        sm.last_buffer = 0;
        store(nth(esc_registers::sync_manager, n), sm);
    }

    std::array<std::byte, memory_size> memory_{};
    std::array<bool, sync_manager_count> open_{};
    std::array<bool, sync_manager_count> written_{};
    bool al_control_written_{};
    bool sii_command_written_{};
    std::array<bool, 4> connected_{}; // by port; 0 is not used
    clock_width width_{};
    slave_clock clock_{};
    bool latches_{}; // the present frame has been told to store the times at which it comes back
};

} // namespace jauscat::ethercat
