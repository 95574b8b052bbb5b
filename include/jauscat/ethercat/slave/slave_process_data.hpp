// The process data of an emulated slave: required SyncManagers, validity of outputs, watchdog.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/ethercat/slave/esc_memory.hpp>
#include <jauscat/ethercat/slave/slave_description.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/watchdog.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace jauscat::ethercat {

/// Without process data in the description: nothing is expected of the SyncManagers, and nothing happens.
class slave_process_data {
  public:
    /// Of the slave's areas for process data, which must outlive this.
    JAUSCAT_FUNCTION explicit slave_process_data(const slave_description& description) noexcept;

    JAUSCAT_FUNCTION void set_sizes(std::size_t outputs, std::size_t inputs) noexcept;

    JAUSCAT_FUNCTION void power_on(esc_memory& memory) noexcept;

    /// Reason for refusing SAFE-OP or OP; `none` if allowed.
    [[nodiscard]] JAUSCAT_FUNCTION al_status_code refusal(const esc_memory& memory) const noexcept;

    /// The slave is in `state` now: below SAFE-OP its process data are shut.
    JAUSCAT_FUNCTION void enter(esc_memory& memory, al_state state) noexcept;

    /// A frame has passed.
    JAUSCAT_FUNCTION void work(esc_memory& memory, al_state state) noexcept;

    /// The outputs in force: what the master has sent last while the slave was in OP.
    [[nodiscard]] JAUSCAT_FUNCTION std::span<const std::byte> outputs() const noexcept;
    /// The inputs of the `n`-th of their SyncManagers; empty where there is none.
    [[nodiscard]] JAUSCAT_FUNCTION std::span<std::byte> inputs(esc_memory& memory, std::size_t n) const noexcept;
    /// Whether there were outputs in OP since the last call.
    bool take_outputs() noexcept { return std::exchange(taken_over_, false); }

    /// Whether the outputs have not been written for the watchdog's time. Only in OP.
    [[nodiscard]] JAUSCAT_FUNCTION bool expired(esc_memory& memory, time_point now) noexcept;

    /// In OP so many SYNC0 have come since the last call. Each needs outputs that were written since the one before.
    JAUSCAT_FUNCTION void on_sync0(std::uint64_t count) noexcept;
    /// SYNC0s that found no new outputs, in OP: since power-on, and since the last ones that did.
    [[nodiscard]] std::uint64_t sync_missed() const noexcept { return sync_missed_; }
    [[nodiscard]] std::uint64_t missed_in_row() const noexcept { return missed_in_row_; }

  private:
    // What the description has in one direction, and whether that is more than fits.
    struct amount {
        bool none{};
        std::size_t size{};

        [[nodiscard]] bool fits() const noexcept { return none || size != 0; }
    };
    [[nodiscard]] const amount& of(const data_area& area) const noexcept { return area.is_output ? outputs_ : inputs_; }
    [[nodiscard]] JAUSCAT_FUNCTION bool accepts(const data_area& area, const sync_manager& sm) const noexcept;
    [[nodiscard]] std::span<const data_area> areas() const noexcept { return other_.empty() ? usual_ : other_; }

    JAUSCAT_FUNCTION static void show_watchdog(esc_memory& memory, bool running) noexcept;

    amount outputs_, inputs_;
    std::array<data_area, 2> usual_;
    std::span<const data_area> other_;
    std::array<std::byte, process_memory::max_outputs> in_force_{};
    bool taken_over_{}; // and the application has not looked yet
    bool fed_{};        // the watchdog's time of the last check
    bool is_fresh_{};   // outputs have been written since the last SYNC0
    std::uint64_t sync_missed_{}, missed_in_row_{};
    time_point last_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/slave/impl/slave_process_data.ipp>
#endif
