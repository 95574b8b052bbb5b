// Events of a bridge, for logs, traces and displays.
#pragma once
#include <jauscat/bridge/pending_stops.hpp>
#include <jauscat/bridge/process_part.hpp>
#include <jauscat/ethercat/master/clock_cycle.hpp>
#include <jauscat/ethercat/master/master_errc.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>
#include <jauscat/jaus/component/component_control.hpp>
#include <jauscat/jaus/component/component_state.hpp>
#include <jauscat/jaus/message/hook.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/schema/ethercat/coe.hpp>
#include <jauscat/schema/ethercat/hilscher.hpp>
#include <jauscat/translate/table.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::bridging {

class component;
class slave_front;

/// Cause of the loss of a slave.
enum class loss : std::uint8_t {
    no_answer,       ///< frames do not return, or the slave does not answer mailbox messages
    no_station,      ///< no reply at its station address: the slave was reset
    left_state,      ///< it is in another state than it has to be in, or in none that is known
    no_process_data, ///< it does not take part in the exchange, or takes no commands
};

/// Cause of a refusal.
enum class refusal : std::uint8_t {
    slave_down,     ///< the slave does not answer
    queue_full,     ///< too many messages wait for the slave
    too_large,      ///< more bytes than an SDO carries
    expired,        ///< it waited too long
    superseded,     ///< a newer command of the same sender replaced it
    stopped,        ///< a stop order was executed first
    not_translated, ///< see `error`
    by_slave,       ///< the slave or the master refused it: see `status` and `of_master`
    not_accepted,   ///< the slave has not executed the command from its process data in time
    stale,          ///< the slave's inputs are too old to answer from
};

/// Cause of a refusal, with details.
struct refusal_reason {
    refusal why{};
    translate::errc error{};
    hilscher::packet_status status{};
    ethercat::master_error of_master{};
};

/// Cause of a stop order.
enum class stop_cause : std::uint8_t {
    state,           ///< the component has gone to a state other than Ready
    controller_lost, ///< the controller was lost without releasing control
    control_taken,   ///< a component has got control while a command of another waited for its execution
    sender_lost,     ///< the sender of the motion command in force was lost; it had no control
    slave_absent,    ///< the slave does not answer: what it does is not known
    slave_returned,  ///< it answers: its first order
    not_accepted,    ///< the slave has not executed a command from its outputs in time
    drive_fault,     ///< a drive behind the component reports a fault
    program_ends,
};

/// The functions that a bridge calls on events: see jaus::hook. All may be left out; none may call the bridge.
///
///     const auto lost = [&](const bridging::slave_front&, bridging::loss, const ethercat::master_error&) { ... };
///     const bridging::observer watcher{.slave_lost = lost};
struct observer {
    /// The slave answers; not `ready` while its process data are being set up.
    jaus::hook<void(const slave_front& slave, const ethercat::slave_record& record, bool ready)> slave_up{};
    /// An attempt to bring it up has failed.
    jaus::hook<void(const slave_front& slave, const ethercat::master_error& why)> bring_up_failed{};
    /// `why` has details of the master's error.
    jaus::hook<void(const slave_front& slave, loss what, const ethercat::master_error& why)> slave_lost{};
    jaus::hook<void(const slave_front& slave, const ethercat::coe_emergency& emergency)> slave_emergency{};
    /// The distributed clocks of the ring agree better or worse than before, by an upper bound of their differences in
    /// ns. For each slave with SYNC signals.
    jaus::hook<void(const slave_front& slave, ethercat::clock_agreement how, std::uint32_t difference)> clocks_agree{};
    /// The slave does not take Report Heartbeat Pulse: nothing stops it when this program ends without a word.
    jaus::hook<void(const slave_front& slave, const refusal_reason& why)> no_keep_alive{};

    jaus::hook<void(const component& unit, jaus::primary_status_code from, jaus::primary_status_code to)>
        changed_state{};
    jaus::hook<void(const component& unit, jaus::control_change why)> changed_controller{};
    /// The actuator needs a stop order.
    jaus::hook<void(const component& unit, stop_order what, stop_cause why)> stop_required{};
    /// The actuator has refused it, for the `attempts`th time: it is tried again.
    jaus::hook<void(const component& unit, stop_order what, const refusal_reason& why, unsigned attempts)>
        stop_refused{};
    /// The actuator has confirmed all pending orders, but for emergencies for which it has no object.
    jaus::hook<void(const component& unit)> settled{};

    /// A drive of the component has a fault, or another one than before: it is in Failure. Once for each fault.
    jaus::hook<void(const component& unit, const drive_fault& what)> faulted{};
    /// None has a fault any more.
    jaus::hook<void(const component& unit)> fault_ended{};

    /// A message was translated into this packet.
    jaus::hook<void(const slave_front& slave, std::span<const std::byte> packet)> translated{};
    /// The report of a query is fetched by this packet.
    jaus::hook<void(const slave_front& slave, std::span<const std::byte> packet)> asks_report{};
    /// A command or a stop order went to the process data, with this number; `outputs` are those of the first slave.
    jaus::hook<void(const slave_front& slave, std::uint32_t count, std::span<const std::byte> outputs)> into_image{};
    /// A command is merged with the one before, which the slave has not executed: fields that only the earlier one
    /// carries are executed with it. In the queue, which refuses the earlier one; or in the outputs, after
    /// `into_image`.
    jaus::hook<void(const component& unit, const jaus::header& message)> merged{};
    /// A query was answered from the inputs.
    jaus::hook<void(const slave_front& slave, std::span<const std::byte> inputs)> from_image{};
    jaus::hook<void(const component& unit, const jaus::header& message, const refusal_reason& why)> refused{};
};

} // namespace jauscat::bridging
