// An emulated EtherCAT slave: a slave controller and the application behind it (states, SII, mailbox, CoE, process
// data). Implements the standard, independent of the master.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/ethercat/slave/esc.hpp>
#include <jauscat/ethercat/slave/object_dictionary.hpp>
#include <jauscat/ethercat/slave/sii_image.hpp>
#include <jauscat/ethercat/slave/slave_mailbox.hpp>
#include <jauscat/ethercat/slave/slave_process_data.hpp>
#include <jauscat/ethercat/slave/sync_report.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/sii.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// A slave with a CoE mailbox and, if its description has any, process data.
class slave {
  public:
    /// `objects`, what `description` refers to, and the memory in `options` must outlive the slave.
    slave(const slave_description& description, object_dictionary objects, const coe_options& options = {}) noexcept
        : description_{description},
          mailbox_{description, objects, options},
          sii_{make_sii_image(description,
                              {.sdo_information = objects.is_described(), .complete_access = objects.is_described()})},
          process_data_{description} {
        set_clock_error({});
    }

    /// Restarts as after power-on: the station address is gone, the state is INIT.
    void power_on() noexcept {
        esc_.reset();
        esc_.store(esc_registers::pdi_control, {sii_pdi_control});
        esc_.store(esc_registers::station_alias, {description_.station_alias});
        esc_.store(esc_registers::sii_request,
                   {.eight_byte_reads = description_.eight_byte_sii_reads, .two_address_bytes = sii_.size() > 2048});
        mailbox_.power_on(esc_);
        process_data_.power_on(esc_);
        sync0_count_ = 0;
        report_ = {};
    }
    /// Whether another slave is connected behind this one, for masters that look at the wiring. Kept at power-on.
    void set_downstream(bool connected) noexcept { esc_.set_downstream(connected); }
    /// The same for any port, 1 to 3, of a slave with branches.
    void set_connected(std::size_t port, bool connected) noexcept { esc_.set_connected(port, connected); }
    /// What is wrong with its clock. Restarts it as after power-on.
    void set_clock_error(const clock_error& error) noexcept {
        esc_.set_clock(description_.clock, error);
        power_on();
    }

    /// A frame passes: it is changed in place, then the application works.
    void process(std::span<std::byte> frame) noexcept {
        pass(frame);
        work();
    }

    /// The controller's part of `process`: the application does not get to run.
    void pass(std::span<std::byte> frame) noexcept { esc_.pass(frame); }

    /// The same for a slave with a distributed clock: the frame begins to arrive `now`, by any clock that does not go
    /// back.
    void process(std::span<std::byte> frame, time_point now) noexcept {
        pass(frame, now);
        work();
    }
    void pass(std::span<std::byte> frame, time_point now) noexcept {
        pass_time(now);
        esc_.pass(frame, now);
    }
    /// The frame that has passed begins to come back at a port, 1 to 3, `now`: the clock stores the time if it was
    /// asked to.
    void frame_returned(std::size_t port, time_point now) noexcept { esc_.frame_returned(port, now); }
    /// Lets the clock run until `now`; without frames this is when SYNC signals come.
    void pass_time(time_point now) noexcept {
        if (!esc_.has_clock()) return;
        esc_.clock().advance(now);
        const auto count = esc_.clock().take_sync0();
        sync0_count_ += count;
        const auto& activation = esc_.clock().activation();
        report_.type = !activation.on || !activation.sync0 ? sync_type::free_run
                       : activation.sync1                  ? sync_type::sync1
                                                           : sync_type::sync0;
        report_.sync0_cycle = report_.type == sync_type::free_run ? 0 : esc_.load(esc_registers::dc_sync0_cycle).value;
        if (state() != al_state::op) return;
        process_data_.on_sync0(count);
        report_.missed = static_cast<std::uint16_t>(std::min<std::uint64_t>(process_data_.sync_missed(), 0xFFFF));
        report_.error = process_data_.missed_in_row() != 0;
        const auto limit = description_.sync_missed_limit;
        if (limit != 0 && process_data_.missed_in_row() >= limit) leave_op(al_status_code::synchronization);
    }
    /// Its clock; without one it stands still.
    [[nodiscard]] const slave_clock& clock() const noexcept { return esc_.clock(); }
    /// SYNC0 signals since power-on.
    [[nodiscard]] std::uint64_t sync0_count() const noexcept { return sync0_count_; }
    /// Those of them in OP that found no outputs written since the one before.
    [[nodiscard]] std::uint64_t sync_missed() const noexcept { return process_data_.sync_missed(); }

    /// For `standard_objects::show`, so that a master can read it.
    [[nodiscard]] const sync_report& synchronization() const noexcept { return report_; }

    /// The application's part of `process`: states, SII, process data and mailbox.
    void work() noexcept {
        if (esc_.take_al_control()) change_state();
        if (esc_.take_sii_command()) access_sii();
        process_data_.work(esc_, state());
        if (state() != al_state::init) mailbox_.work(esc_);
    }

    /// The SyncManager watchdog: a slave in OP that has a master's outputs no longer goes to SAFE-OP with an error
    /// (001Bh). To be called every few milliseconds; a host that never does has no watchdog. Time is any that does not
    /// go back.
    void on_time(time_point now) noexcept {
        if (state() != al_state::op || !process_data_.expired(esc_, now)) return;
        leave_op(al_status_code::sync_manager_watchdog);
    }

    /// The outputs in force: those that a master wrote last in OP. The application decides which state is safe without
    /// a master: see `state`.
    [[nodiscard]] std::span<const std::byte> outputs() const noexcept { return process_data_.outputs(); }
    /// True once after each write of the outputs in OP.
    bool take_outputs() noexcept { return process_data_.take_outputs(); }
    /// What a master reads from SAFE-OP on; the application writes it.
    [[nodiscard]] std::span<std::byte> inputs() noexcept {
        return esc_.bytes(process_memory::inputs, description_.input_size());
    }

    [[nodiscard]] al_status status() const noexcept { return esc_.load(esc_registers::al_status); }
    [[nodiscard]] al_state state() const noexcept { return status().state; }
    /// 0 until a master has given one.
    [[nodiscard]] std::uint16_t station_address() const noexcept {
        return esc_.load(esc_registers::station_address).value;
    }

  private:
    void leave_op(al_status_code why) noexcept {
        const al_status lost{.state = al_state::safe_op, .error = true, .code = why};
        esc_.store(esc_registers::al_status, lost);
        mailbox_.set_state(lost.state);
    }

    void change_state() noexcept {
        const auto control = esc_.load(esc_registers::al_control);
        auto changed = status();
        const auto before = changed.state;
        if (changed.error && !control.acknowledge && control.state > changed.state) return;
        const bool from_init = changed.state == al_state::init;
        changed.error = false;
        changed.code = refusal(changed.state, control.state);
        if (changed.code == al_status_code::none) {
            changed.state = control.state;
        } else {
            changed.error = true;
        }
        changed.device_id_loaded = control.request_device_id && description_.device_id && !changed.error;
        if (changed.device_id_loaded) changed.code = static_cast<al_status_code>(*description_.device_id);
        if (from_init || changed.state == al_state::init) mailbox_.forget(esc_);
        esc_.store(esc_registers::al_status, changed);
        if (changed.state != before) enter(changed.state); // a request that changes nothing does not feed the watchdog
    }

    void enter(al_state state) noexcept {
        process_data_.enter(esc_, state);
        mailbox_.set_state(state);
    }

    // ETG.1000.6, table 106: one step up at a time, any step down.
    [[nodiscard]] al_status_code refusal(al_state from, al_state to) noexcept {
        switch (to) {
        case al_state::init: return al_status_code::none;
        case al_state::boot: return al_status_code::boot_not_supported;
        case al_state::pre_op:
            if (from != al_state::init) return al_status_code::none;
            return mailbox_.is_configured(esc_) ? al_status_code::none : al_status_code::mailbox_pre_op;
        case al_state::safe_op:
            if (from == al_state::init) return al_status_code::invalid_state_change;
            if (from == al_state::op) return al_status_code::none;
            if (needs_sync() && !makes_sync0()) return al_status_code::dc_sync_configuration;
            return process_data_.refusal(esc_);
        case al_state::op:
            if (from != al_state::safe_op && from != al_state::op) return al_status_code::invalid_state_change;
            if (needs_sync() && (!makes_sync0() || esc_.clock().activation_status().sync0_pending))
                return al_status_code::no_sync;
            return process_data_.refusal(esc_);
        }
        return al_status_code::unknown_state;
    }

    [[nodiscard]] bool needs_sync() const noexcept { return description_.needs_sync && esc_.has_clock(); }
    [[nodiscard]] bool makes_sync0() const noexcept {
        return esc_.clock().activation().on && esc_.clock().activation().sync0;
    }

    void access_sii() noexcept {
        auto access = esc_.load(esc_registers::sii_access);
        access.request.busy = false;
        if (access.request.cmd == sii_command::read) {
            const std::size_t count = description_.eight_byte_sii_reads ? 8 : 4;
            for (std::size_t i = 0; i != count; ++i) {
                const std::size_t at = std::size_t{access.request.address} * 2 + i;
                access.data[i] = at < sii_.size() ? sii_[at] : std::byte{0xFF};
            }
        } else {
            access.request.command_error = true; // this memory is read only
        }
        access.request.cmd = sii_command::clear;
        esc_.store(esc_registers::sii_access, access);
    }

    slave_description description_;
    slave_mailbox mailbox_;
    sii_image sii_;
    slave_process_data process_data_;
    esc esc_{};
    std::uint64_t sync0_count_{};
    sync_report report_{};
};

} // namespace jauscat::ethercat
