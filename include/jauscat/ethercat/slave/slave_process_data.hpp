// The process data of an emulated slave: required SyncManagers, validity of outputs, watchdog.
#pragma once

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
    /// Of the slave's areas for process data.
    explicit slave_process_data(const slave_description& description) noexcept
        : outputs_{description.output_manager(), process_memory::outputs, description.output_size(),
                   description.outputs.empty()},
          inputs_{description.input_manager(), process_memory::inputs, description.input_size(),
                  description.inputs.empty()} {}

    void power_on(esc_memory& memory) noexcept {
        in_force_.fill(std::byte{});
        taken_over_ = fed_ = is_fresh_ = false;
        sync_missed_ = 0;
        missed_in_row_ = 0;
        enter(memory, al_state::init);
    }

    /// Reason for refusing SAFE-OP or OP; `none` if allowed.
    [[nodiscard]] al_status_code refusal(const esc_memory& memory) const noexcept {
        if (!outputs_.fits()) return al_status_code::output_mapping;
        if (!inputs_.fits()) return al_status_code::input_mapping;
        if (!outputs_.accepts(memory.manager(outputs_.manager), sync_manager_direction::master_writes))
            return al_status_code::output_configuration;
        if (!inputs_.accepts(memory.manager(inputs_.manager), sync_manager_direction::master_reads))
            return al_status_code::input_configuration;
        return al_status_code::none;
    }

    /// The slave is in `state` now: below SAFE-OP its process data are shut.
    void enter(esc_memory& memory, al_state state) noexcept {
        const bool shut = state != al_state::safe_op && state != al_state::op;
        if (!outputs_.none) memory.disable(outputs_.manager, shut);
        if (!inputs_.none) memory.disable(inputs_.manager, shut);
        if (state == al_state::op) fed_ = is_fresh_ = true; // the watchdog begins to wait now
        missed_in_row_ = 0;
        show_watchdog(memory, true);
    }

    /// A frame has passed.
    void work(esc_memory& memory, al_state state) noexcept {
        if (!memory.take_written(outputs_.manager) || outputs_.none) return;
        fed_ = is_fresh_ = true;
        if (state != al_state::op) return;
        std::ranges::copy(memory.bytes(outputs_.start, outputs_.size), in_force_.begin());
        taken_over_ = true;
    }

    /// The outputs in force: what the master has sent last while the slave was in OP.
    [[nodiscard]] std::span<const std::byte> outputs() const noexcept {
        return std::span{in_force_}.first(outputs_.size);
    }
    /// Whether there were outputs in OP since the last call.
    bool take_outputs() noexcept { return std::exchange(taken_over_, false); }

    /// Whether the outputs have not been written for the watchdog's time. Only in OP.
    [[nodiscard]] bool expired(esc_memory& memory, time_point now) noexcept {
        const auto manager = memory.manager(outputs_.manager);
        const auto time = watchdog_time(memory.load(esc_registers::watchdog_divider).value,
                                        memory.load(esc_registers::process_data_watchdog).value);
        if (std::exchange(fed_, false)) {
            last_ = now;
            return false;
        }
        if (outputs_.none || !manager.watchdog || time == time.zero() || now - last_ < time) return false;
        show_watchdog(memory, false);
        return true;
    }

    /// In OP so many SYNC0 have come since the last call. Each needs outputs that were written since the one before.
    void on_sync0(std::uint64_t count) noexcept {
        if (count == 0 || outputs_.none) return;
        const auto missed = count - (std::exchange(is_fresh_, false) ? 1 : 0);
        missed_in_row_ = missed == count ? missed_in_row_ + missed : missed;
        sync_missed_ += missed;
    }
    /// SYNC0s that found no new outputs, in OP: since power-on, and since the last ones that did.
    [[nodiscard]] std::uint64_t sync_missed() const noexcept { return sync_missed_; }
    [[nodiscard]] std::uint64_t missed_in_row() const noexcept { return missed_in_row_; }

  private:
    struct area {
        std::size_t manager{}; // number of its SyncManager
        std::uint16_t start{};
        std::size_t size{};
        bool none{}; // the description has nothing in this direction

        [[nodiscard]] bool fits() const noexcept { return none || size != 0; }
        [[nodiscard]] bool accepts(const sync_manager& sm, sync_manager_direction direction) const noexcept {
            if (none) return !sm.enable || sm.length == 0;
            return sm.enable && sm.mode == sync_manager_mode::buffered && sm.direction == direction &&
                   sm.start == start && sm.length == size;
        }
    };

    static void show_watchdog(esc_memory& memory, bool running) noexcept {
        memory.store(esc_registers::watchdog_status, {static_cast<std::uint16_t>(running ? 1 : 0)});
    }

    area outputs_, inputs_;
    std::array<std::byte, process_memory::max_outputs> in_force_{};
    bool taken_over_{}; // and the application has not looked yet
    bool fed_{};        // the watchdog's time of the last check
    bool is_fresh_{};   // outputs have been written since the last SYNC0
    std::uint64_t sync_missed_{}, missed_in_row_{};
    time_point last_{};
};

} // namespace jauscat::ethercat
