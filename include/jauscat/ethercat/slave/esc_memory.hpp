// The memory of an emulated EtherCAT slave controller: registers, process memory, and the SyncManagers that decide
// which access counts. esc.hpp processes frames.
#pragma once

#include <jauscat/base/compilation.hpp>
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

    JAUSCAT_CONSTEXPR esc_memory() noexcept { reset(); }

    /// As after power-on: state INIT, station address 0, all SyncManagers and FMMUs off, no system time.
    JAUSCAT_CONSTEXPR void reset() noexcept;

    /// Whether another slave is connected to port 1. Kept over a reset.
    JAUSCAT_CONSTEXPR void set_downstream(bool connected) noexcept { set_connected(1, connected); }
    /// Whether another slave is connected to a port, 1 to 3. Kept over a reset.
    JAUSCAT_CONSTEXPR void set_connected(std::size_t port, bool connected) noexcept;

    /// Gives it a clock, or none, as after power-on. Kept over a reset.
    JAUSCAT_CONSTEXPR void set_clock(clock_width width, const clock_error& error) noexcept;
    [[nodiscard]] constexpr bool has_clock() const noexcept { return width_ != clock_width::no_clock; }
    [[nodiscard]] constexpr const slave_clock& clock() const noexcept { return clock_; }
    [[nodiscard]] constexpr slave_clock& clock() noexcept { return clock_; }
    /// It is `now`: a frame begins to pass the processing unit. Times in registers are those of this instant.
    JAUSCAT_CONSTEXPR void begin_frame(time_point now) noexcept;
    /// The same frame begins to come back at a port, `now`.
    JAUSCAT_CONSTEXPR void frame_returned(std::size_t port, time_point now) noexcept;

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
    [[nodiscard]] JAUSCAT_CONSTEXPR sync_manager manager(std::size_t n) const noexcept;
    /// The memory of a SyncManager; empty if it is outside of the memory.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::span<std::byte> area(const sync_manager& sm) noexcept;
    /// Mailbox `n` has been filled (true) or emptied (false).
    JAUSCAT_CONSTEXPR void set_full(std::size_t n, bool full) noexcept;
    /// The application has completed the master's repeat request of SyncManager `n`.
    JAUSCAT_CONSTEXPR void acknowledge_repeat(std::size_t n) noexcept;

    /// True once after each write of all of buffered SyncManager `n`.
    constexpr bool take_written(std::size_t n) noexcept { return std::exchange(written_[n], false); }
    /// The slave shuts a SyncManager (true), or opens it.
    JAUSCAT_CONSTEXPR void disable(std::size_t n, bool disabled) noexcept;
    /// The FMMU `n`, from 0.
    [[nodiscard]] constexpr fmmu mapping(std::size_t n) const noexcept { return load(nth(esc_registers::fmmu, n)); }
    /// Memory, regardless of the SyncManagers; within `memory_size`.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::span<std::byte> bytes(std::size_t start, std::size_t size) noexcept;

    /// True once after each write to AL control.
    constexpr bool take_al_control() noexcept { return std::exchange(al_control_written_, false); }
    /// True once after each command to the SII; the controller shows busy until `sii_done`.
    constexpr bool take_sii_command() noexcept { return std::exchange(sii_command_written_, false); }

    /// A master's read of memory, or'ed to what `out` holds where `combine`. False if it does not count.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool read(std::size_t address, std::span<std::byte> out,
                                              bool combine = false) noexcept;

    /// A master's write of memory. False if it does not count.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool write(std::size_t address, std::span<const std::byte> in) noexcept;

  private:
    /// Calls f(n, manager) for each SyncManager that is enabled and shares a byte with the access.
    constexpr void for_managers(std::size_t address, std::size_t size, auto&& f) noexcept {
        if (address + size <= esc_registers::digital_outputs.address) return;
        for (std::size_t n = 0; n != sync_manager_count; ++n) {
            const auto sm = manager(n);
            if (!sm.enable || sm.length == 0) continue;
            if (address < std::size_t{sm.start} + sm.length && address + size > sm.start) f(n, sm);
        }
    }

    // A SyncManager's area opens with its first byte, and for one direction; a mailbox only if it has a message to read
    // or is empty for writing.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool may_access(std::size_t address, std::size_t size,
                                                    sync_manager_direction direction) noexcept;

    // An area changes hands with its last byte.
    JAUSCAT_CONSTEXPR void complete(std::size_t address, std::size_t size) noexcept;

    // The master always accesses the first of three buffers; the status has the number of the active one.
    JAUSCAT_CONSTEXPR void exchange_buffer(std::size_t n, sync_manager_direction direction) noexcept;

    // A port has a link if something is connected, port 0 always. Ports 2 and 3 exist only then.
    JAUSCAT_CONSTEXPR void show_link() noexcept;

    JAUSCAT_CONSTEXPR void store_time(const esc_register_of<dc_time>& at, std::uint64_t ns) noexcept;
    JAUSCAT_CONSTEXPR void show_clock() noexcept;
    JAUSCAT_CONSTEXPR void show_control() noexcept;
    JAUSCAT_CONSTEXPR void show_sync() noexcept;
    JAUSCAT_CONSTEXPR void latch(std::size_t port) noexcept;

    // What a master's write to the clock does beside what it stores.
    JAUSCAT_CONSTEXPR void write_clock(std::size_t address, std::span<const std::byte> in) noexcept;
    JAUSCAT_CONSTEXPR void set_offset() noexcept;
    // A start time of 4 bytes is the next one that ends so.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::uint64_t start_time(bool extends) const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR bool is_masters_sync() const noexcept;
    // Registers of the clock that keep what a master writes.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool is_writable_clock(std::size_t address) const noexcept;

    [[nodiscard]] JAUSCAT_CONSTEXPR static bool is_within(const esc_register& r, std::size_t address) noexcept;

    // Registers that a master may write. A write to another one is counted in the working counter, and ignored.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool is_writable(std::size_t address) const noexcept;

    [[nodiscard]] constexpr bool sii_is_masters() const noexcept { return !load(esc_registers::sii_owner).pdi; }

    // Read-only bits keep their value; the command and the write enable are copied, and any command makes the SII busy.
    JAUSCAT_CONSTEXPR void start_sii(std::size_t address, std::span<const std::byte> in) noexcept;

    JAUSCAT_CONSTEXPR void switch_off_if_disabled(std::size_t n) noexcept;

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

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/slave/impl/esc_memory.ipp>
#endif
