// An emulated EtherCAT slave controller: memory, registers and SyncManagers, as the hardware treats a passing frame.
// What an application does behind it is in slave.hpp.
#pragma once

#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace jauscat::ethercat {

/// Register file, 8 KiB of process memory and 8 SyncManagers. Has no FMMU: logical commands pass unanswered.
class esc {
  public:
    static constexpr std::size_t memory_size = 0x3000; ///< bytes: 0x1000 of registers, then process memory
    static constexpr std::size_t sync_manager_count = 8;

    constexpr esc() noexcept { reset(); }

    /// As after power-on: state INIT, station address 0, all SyncManagers off.
    constexpr void reset() noexcept {
        memory_.fill(std::byte{});
        open_.fill(false);
        al_control_written_ = sii_command_written_ = false;
        constexpr std::array<std::byte, 8> description{
            std::byte{0x11}, std::byte{1},                  // type, revision
            std::byte{1},    std::byte{0},                  // build
            std::byte{0},    std::byte{sync_manager_count}, // FMMUs, SyncManagers
            std::byte{8},    std::byte{0x0F},               // RAM in KiB, ports 0 and 1 MII
        };
        std::ranges::copy(description, memory_.begin());
        store(esc_registers::dl_status, esc_word{0x5610}); // link on port 0, ports 1 to 3 closed
        store(esc_registers::al_status, al_status{.state = al_state::init});
    }

    /// Does to a frame what the controller does while it passes: executes the datagrams that address this slave, counts
    /// positions, and marks the source address as locally administered. Leaves anything but EtherCAT untouched.
    constexpr void pass(std::span<std::byte> frame) noexcept {
        mutable_frame_view view;
        if (!view.parse(frame)) return;
        ethernet_header ethernet{};
        static_cast<void>(wire::decode_prefix(ethernet, frame));
        ethernet.source[0] |= std::byte{0x02};
        static_cast<void>(wire::encode(ethernet, frame));
        for (const auto datagram : view) execute(datagram);
    }

    /// The application's view of a register.
    template <wire::message T> [[nodiscard]] constexpr T load(esc_register at) const noexcept {
        T value{};
        static_cast<void>(wire::decode_prefix(value, std::span{memory_}.subspan(at.address)));
        return value;
    }
    template <wire::message T> constexpr void store(esc_register at, const T& value) noexcept {
        static_cast<void>(wire::encode(value, std::span{memory_}.subspan(at.address)));
    }

    /// Where SyncManager `n` has its registers.
    static constexpr esc_register sync_manager_register(std::size_t n) noexcept {
        return {static_cast<std::uint16_t>(esc_registers::sync_manager.address + n * esc_registers::sync_manager.size),
                esc_registers::sync_manager.size};
    }
    [[nodiscard]] constexpr sync_manager manager(std::size_t n) const noexcept {
        return load<sync_manager>(sync_manager_register(n));
    }
    /// The memory of a SyncManager; empty when it lies outside.
    [[nodiscard]] constexpr std::span<std::byte> area(const sync_manager& sm) noexcept {
        if (std::size_t{sm.start} + sm.length > memory_size) return {};
        return std::span{memory_}.subspan(sm.start, sm.length);
    }
    /// Mailbox `n` has been filled (true) or emptied (false).
    constexpr void set_full(std::size_t n, bool full) noexcept {
        auto sm = manager(n);
        sm.full = sm.write_event = full;
        sm.read_event = !full;
        store(sync_manager_register(n), sm);
    }
    /// The application has done what the master's repeat request of SyncManager `n` asked.
    constexpr void acknowledge_repeat(std::size_t n) noexcept {
        auto sm = manager(n);
        sm.repeat_acknowledge = sm.repeat_request;
        store(sync_manager_register(n), sm);
    }

    /// True once after each write to AL control.
    constexpr bool take_al_control() noexcept { return std::exchange(al_control_written_, false); }
    /// True once after each command to the SII; the controller shows busy until `sii_done`.
    constexpr bool take_sii_command() noexcept { return std::exchange(sii_command_written_, false); }

  private:
    constexpr void execute(const basic_datagram<std::byte>& d) noexcept {
        auto header = d.header;
        bool hit = false, reads = false, writes = false;
        const bool by_position = header.adp == 0;
        switch (header.cmd) {
        case command::aprd: hit = by_position, reads = true; break;
        case command::apwr: hit = by_position, writes = true; break;
        case command::aprw: hit = by_position, reads = writes = true; break;
        case command::fprd: hit = is_station(header.adp), reads = true; break;
        case command::fpwr: hit = is_station(header.adp), writes = true; break;
        case command::fprw: hit = is_station(header.adp), reads = writes = true; break;
        case command::brd: hit = reads = true; break;
        case command::bwr: hit = writes = true; break;
        case command::brw: hit = reads = writes = true; break;
        case command::armw: hit = true, reads = by_position, writes = !reads; break;
        case command::frmw: hit = true, reads = is_station(header.adp), writes = !reads; break;
        case command::nop:
        case command::lrd:
        case command::lwr:
        case command::lrw:
        default: return;
        }
        const bool broadcast = header.cmd == command::brd || header.cmd == command::bwr || header.cmd == command::brw;
        if (broadcast || header.cmd == command::armw || header.cmd <= command::aprw) ++header.adp;

        unsigned counter = d.working_counter;
        if (hit && reads && writes) { // the data are exchanged: what is written has to be kept while it is read over
            std::array<std::byte, max_datagram_data> sent{};
            std::ranges::copy(d.data, sent.begin());
            if (read(header.ado, d.data, broadcast)) counter += 1;
            if (write(header.ado, std::span{sent}.first(d.data.size()))) counter += 2;
        } else if (hit && reads) {
            if (read(header.ado, d.data, broadcast)) counter += 1;
        } else if (hit) {
            if (write(header.ado, d.data)) counter += 1;
        }
        static_cast<void>(wire::encode(header, d.bytes));
        static_cast<void>(wire::encode(datagram_trailer{static_cast<std::uint16_t>(counter)},
                                       d.bytes.last(wire::max_size<datagram_trailer>)));
    }

    [[nodiscard]] constexpr bool is_station(std::uint16_t address) const noexcept {
        if (address == load<esc_word>(esc_registers::station_address).value) return true;
        const bool alias_enabled = (memory_[esc_registers::dl_control.address + 3] & std::byte{1}) != std::byte{};
        return alias_enabled && address == load<esc_word>(esc_registers::station_alias).value;
    }

    constexpr bool read(std::uint16_t address, std::span<std::byte> out, bool combine) noexcept {
        if (!may_access(address, out.size(), sync_manager_direction::master_reads)) return false;
        for (std::size_t i = 0; i != out.size(); ++i)
            out[i] = combine ? out[i] | memory_[address + i] : memory_[address + i];
        complete(address, out.size());
        return true;
    }

    constexpr bool write(std::uint16_t address, std::span<const std::byte> in) noexcept {
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
            if (touches(sync_manager_register(n))) switch_off_if_disabled(n);
        return true;
    }

    /// Calls f(n, manager) for each mailbox that is enabled and shares a byte with the access.
    constexpr void for_mailboxes(std::size_t address, std::size_t size, auto&& f) noexcept {
        if (address + size <= esc_registers::process_ram.address) return;
        for (std::size_t n = 0; n != sync_manager_count; ++n) {
            const auto sm = manager(n);
            if (sm.mode != sync_manager_mode::mailbox || !sm.enable || sm.length == 0) continue;
            if (address < std::size_t{sm.start} + sm.length && address + size > sm.start) f(n, sm);
        }
    }

    // A mailbox opens with its first byte, for one direction, and only while there is something to read or room to
    // write.
    [[nodiscard]] constexpr bool may_access(std::size_t address, std::size_t size,
                                            sync_manager_direction direction) noexcept {
        if (size == 0 || address + size > memory_size) return false;
        bool allowed = true;
        for_mailboxes(address, size, [&](std::size_t n, const sync_manager& sm) {
            const bool wants_full = direction == sync_manager_direction::master_reads;
            if (sm.direction != direction || sm.full != wants_full) allowed = false;
            if (address > sm.start && !open_[n]) allowed = false;
        });
        return allowed;
    }

    // A mailbox changes hands with its last byte.
    constexpr void complete(std::size_t address, std::size_t size) noexcept {
        for_mailboxes(address, size, [&](std::size_t n, const sync_manager& sm) {
            open_[n] = address + size < std::size_t{sm.start} + sm.length;
            if (!open_[n]) set_full(n, !sm.full);
        });
    }

    // What a master may change: the rest keeps its value, though the access counts.
    [[nodiscard]] constexpr bool is_writable(std::size_t address) const noexcept {
        if (address >= esc_registers::process_ram.address) return true;
        const std::size_t managers = esc_registers::sync_manager.address;
        if (address >= managers && address < managers + sync_manager_count * esc_registers::sync_manager.size) {
            const std::size_t byte = (address - managers) % esc_registers::sync_manager.size;
            const bool enabled = manager((address - managers) / esc_registers::sync_manager.size).enable;
            return byte == 6 || (byte < 5 && !enabled); // 5 and 7 are the slave's; 0 to 4 are fixed while enabled
        }
        const auto within = [&](esc_register r) { return address >= r.address && address < r.address + r.size; };
        return within(esc_registers::station_address) || within(esc_registers::dl_control) ||
               within(esc_registers::al_control) || within(esc_registers::ecat_event_mask) ||
               within(esc_registers::sii_owner) || (within(esc_registers::sii_address) && sii_is_masters());
    }

    [[nodiscard]] constexpr bool sii_is_masters() const noexcept {
        return !load<sii_owner>(esc_registers::sii_owner).pdi;
    }

    // Read-only bits stay; the command and the write enable are taken over, and any command makes the SII busy.
    constexpr void start_sii(std::size_t address, std::span<const std::byte> in) noexcept {
        if (!sii_is_masters() || address > esc_registers::sii_control.address) return;
        const auto written = in.subspan(esc_registers::sii_control.address - address);
        std::array<std::byte, wire::max_size<sii_request>> bytes{};
        std::ranges::copy(written.first(std::min<std::size_t>(written.size(), 2)), bytes.begin());
        sii_request asked{};
        static_cast<void>(wire::decode_prefix(asked, bytes));
        auto now = load<sii_request>(esc_registers::sii_control);
        now.write_enable = asked.write_enable;
        now.cmd = asked.cmd;
        now.command_error = now.write_enable_error = false;
        now.busy = sii_command_written_ = asked.cmd != sii_command::clear;
        store(esc_registers::sii_control, now);
    }

    constexpr void switch_off_if_disabled(std::size_t n) noexcept {
        auto sm = manager(n);
        if (sm.enable) return;
        open_[n] = false;
        sm.full = sm.write_event = sm.read_event = sm.repeat_acknowledge = false;
        store(sync_manager_register(n), sm);
    }

    std::array<std::byte, memory_size> memory_{};
    std::array<bool, sync_manager_count> open_{};
    bool al_control_written_{};
    bool sii_command_written_{};
};

} // namespace jauscat::ethercat
