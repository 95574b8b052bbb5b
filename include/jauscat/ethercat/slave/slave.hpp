// An emulated EtherCAT slave: a slave controller and the application behind it (states, SII, mailbox, CoE, process
// data). Implements the standard, independent of the master.
#pragma once

#include <jauscat/base/compilation.hpp>
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

/// A slave with a CoE mailbox and, if its description has any, process data. A master can write its SII, the first
/// sii_image::max_size bytes: what it loads of it holds from the next power-on, or when a master lets it load that.
class slave {
  public:
    /// `objects`, what `description` refers to, and the memory in `options` must outlive the slave.
    JAUSCAT_FUNCTION slave(const slave_description& description, object_dictionary objects,
                           const coe_options& options = {}) noexcept;

    /// Restarts as after power-on: the station address is gone, the state is INIT.
    JAUSCAT_FUNCTION void power_on() noexcept;
    /// Whether another slave is connected behind this one, for masters that look at the wiring. Kept at power-on.
    void set_downstream(bool connected) noexcept { esc_.set_downstream(connected); }
    /// The same for any port, 1 to 3, of a slave with branches.
    void set_connected(std::size_t port, bool connected) noexcept { esc_.set_connected(port, connected); }
    /// What is wrong with its clock. Restarts it as after power-on.
    JAUSCAT_FUNCTION void set_clock_error(const clock_error& error) noexcept;

    /// A frame passes: it is changed in place, then the application works.
    JAUSCAT_FUNCTION void process(std::span<std::byte> frame) noexcept;

    /// The controller's part of `process`: the application does not get to run.
    void pass(std::span<std::byte> frame) noexcept { esc_.pass(frame); }

    /// The same for a slave with a distributed clock: the frame begins to arrive `now`, by any clock that does not go
    /// back.
    JAUSCAT_FUNCTION void process(std::span<std::byte> frame, time_point now) noexcept;
    JAUSCAT_FUNCTION void pass(std::span<std::byte> frame, time_point now) noexcept;
    /// The frame that has passed begins to come back at a port, 1 to 3, `now`: the clock stores the time if it was
    /// asked to.
    void frame_returned(std::size_t port, time_point now) noexcept { esc_.frame_returned(port, now); }
    /// Lets the clock run until `now`; without frames this is when SYNC signals come.
    JAUSCAT_FUNCTION void pass_time(time_point now) noexcept;
    /// Its clock; without one it stands still.
    [[nodiscard]] const slave_clock& clock() const noexcept { return esc_.clock(); }
    /// SYNC0 signals since power-on.
    [[nodiscard]] std::uint64_t sync0_count() const noexcept { return sync0_count_; }
    /// Those of them in OP that found no outputs written since the one before.
    [[nodiscard]] std::uint64_t sync_missed() const noexcept { return process_data_.sync_missed(); }

    /// For `standard_objects::show`, so that a master can read it.
    [[nodiscard]] const sync_report& synchronization() const noexcept { return report_; }

    /// The application's part of `process`: states, SII, process data and mailbox.
    JAUSCAT_FUNCTION void work() noexcept;

    /// The SyncManager watchdog: a slave in OP that has a master's outputs no longer goes to SAFE-OP with an error
    /// (001Bh). To be called every few milliseconds; a host that never does has no watchdog. Time is any that does not
    /// go back.
    JAUSCAT_FUNCTION void on_time(time_point now) noexcept;

    /// From now on it expects so many bytes of process data (see process_memory), in place of what the description has.
    /// Not for a slave with slave_description::areas. In INIT and PRE-OP only.
    void set_process_data_sizes(std::size_t outputs, std::size_t inputs) noexcept {
        process_data_.set_sizes(outputs, inputs);
    }

    /// The outputs in force: those that a master wrote last in OP. The application decides which state is safe without
    /// a master: see `state`.
    [[nodiscard]] std::span<const std::byte> outputs() const noexcept { return process_data_.outputs(); }
    /// True once after each write of the outputs in OP.
    bool take_outputs() noexcept { return process_data_.take_outputs(); }
    /// What a master reads from SAFE-OP on; the application writes it. Of a slave with several SyncManagers of inputs
    /// (`slave_description::areas`) those of the `n`-th.
    [[nodiscard]] std::span<std::byte> inputs(std::size_t n = 0) noexcept { return process_data_.inputs(esc_, n); }

    /// Tells the master what has happened, by the next message that it reads from the mailbox. False in INIT, without a
    /// mailbox, and while slave_mailbox::max_emergencies wait: it is not told then.
    bool send_emergency(const coe_emergency& what) noexcept {
        return state() != al_state::init && mailbox_.send_emergency(what);
    }

    [[nodiscard]] al_status status() const noexcept { return esc_.load(esc_registers::al_status); }
    [[nodiscard]] al_state state() const noexcept { return status().state; }
    /// 0 until a master has given one.
    [[nodiscard]] JAUSCAT_FUNCTION std::uint16_t station_address() const noexcept;

  private:
    JAUSCAT_FUNCTION void leave_op(al_status_code why) noexcept;

    JAUSCAT_FUNCTION void change_state() noexcept;

    JAUSCAT_FUNCTION void enter(al_state state) noexcept;

    // ETG.1000.6, table 106: one step up at a time, any step down.
    [[nodiscard]] JAUSCAT_FUNCTION al_status_code refusal(al_state from, al_state to) noexcept;

    [[nodiscard]] bool needs_sync() const noexcept { return description_.needs_sync && esc_.has_clock(); }
    [[nodiscard]] JAUSCAT_FUNCTION bool makes_sync0() const noexcept;

    JAUSCAT_FUNCTION void access_sii() noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION std::byte sii_byte(std::size_t at) const noexcept;
    // As the slave controller does at power-on.
    JAUSCAT_FUNCTION void load_configuration(sii_request& status) noexcept;

    slave_description description_;
    slave_mailbox mailbox_;
    sii_image sii_;
    slave_process_data process_data_;
    esc esc_{};
    std::uint64_t sync0_count_{};
    sync_report report_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/slave/impl/slave.ipp>
#endif
