// The memory of an emulated EtherCAT slave controller: registers, process memory, and the SyncManagers that decide
// which access counts. esc.hpp processes frames.
#pragma once

#include <jauscat/schema/ethercat/al_state.hpp>
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

/// Register file, 8 KiB of process memory, 8 SyncManagers and the registers of 8 FMMUs; no distributed clock.
class esc_memory {
  public:
    static constexpr std::size_t memory_size = 0x3000; ///< bytes: 0x1000 of registers, then process memory
    static constexpr std::size_t sync_manager_count = 8;
    static constexpr std::size_t fmmu_count = 8;

    constexpr esc_memory() noexcept { reset(); }

    /// As after power-on: state INIT, station address 0, all SyncManagers and FMMUs off.
    constexpr void reset() noexcept {
        memory_.fill(std::byte{});
        open_.fill(false);
        written_.fill(false);
        al_control_written_ = sii_command_written_ = false;
        constexpr std::array<std::byte, 8> description{
            std::byte{0x11},       std::byte{1},                  // type, revision
            std::byte{1},          std::byte{0},                  // build
            std::byte{fmmu_count}, std::byte{sync_manager_count}, // FMMUs map bits, too: see `features`, all 0
            std::byte{8},          std::byte{0x0F},               // RAM in KiB, ports 0 and 1 MII
        };
        std::ranges::copy(description, memory_.begin());
        store(esc_registers::al_status, {.state = al_state::init});
        store(esc_registers::watchdog_divider, {default_watchdog_divider});
        store(esc_registers::pdi_watchdog, {default_watchdog_time});
        store(esc_registers::process_data_watchdog, {default_watchdog_time});
        show_link();
    }

    /// Whether another slave is connected to port 1. Kept over a reset.
    constexpr void set_downstream(bool connected) noexcept {
        downstream_ = connected;
        show_link();
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

    // DL status: link and communication on port 0, and on port 1 if a slave follows; the others are closed.
    constexpr void show_link() noexcept {
        store(esc_registers::dl_status, {.link_0 = true,
                                         .link_1 = downstream_,
                                         .communication_0 = true,
                                         .closed_1 = !downstream_,
                                         .communication_1 = downstream_,
                                         .closed_2 = true,
                                         .closed_3 = true});
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
        const auto within = [&](esc_register r) { return address >= r.address && address < r.address + r.size; };
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
    bool downstream_{};
};

} // namespace jauscat::ethercat
