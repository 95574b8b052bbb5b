// Events of a bridge, for logs, traces and displays.
#pragma once
#include <jauscat/bridge/stop_debt.hpp>
#include <jauscat/ethercat/master/master_errc.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>
#include <jauscat/jaus/component/component_control.hpp>
#include <jauscat/jaus/component/component_state.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/schema/ethercat/coe.hpp>
#include <jauscat/schema/ethercat/hilscher.hpp>
#include <jauscat/translate/table.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::bridge {

class component;
class slave_front;

/// Cause of the loss of a slave.
enum class loss : std::uint8_t {
    no_answer,       ///< frames do not come back, or the slave does not answer its mail
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
    stopped,        ///< a stop order came first
    not_translated, ///< see `error`
    by_slave,       ///< the slave or the master refused it: see `status` and `outcome`
    not_taken,      ///< the slave has not taken the command out of its process data in time
    stale,          ///< the slave's inputs are too old to answer from
};

/// Cause of a refusal, with details.
struct refusal_reason {
    refusal why{};
    translate::errc error{};
    hilscher::packet_status status{};
    ethercat::outcome outcome{};
};

/// Cause of a stop order.
enum class stop_cause : std::uint8_t {
    state,           ///< the component has gone to a state other than Ready
    controller_lost, ///< the controller was lost without releasing control
    slave_away,      ///< the slave does not answer: what it does is not known
    slave_back,      ///< it answers: the first thing that it is told
    not_taken,       ///< the slave has not taken a command out of its outputs in time
    program_ends,
};

/// Receives the events of a bridge. All functions are optional; none may call the bridge.
class observer {
  public:
    virtual ~observer() = default;

    /// The slave answers; not `ready` while its process data are being set up.
    virtual void slave_up(const slave_front& /*slave*/, const ethercat::slave_record& /*record*/, bool /*ready*/) {}
    /// An attempt to bring it up has failed.
    virtual void bring_up_failed(const slave_front& /*slave*/, const ethercat::outcome& /*why*/) {}
    /// `why` says more where the master does.
    virtual void slave_lost(const slave_front& /*slave*/, loss /*what*/, const ethercat::outcome& /*why*/) {}
    virtual void slave_emergency(const slave_front& /*slave*/, const ethercat::coe_emergency& /*emergency*/) {}
    /// The slave does not take Report Heartbeat Pulse: nothing stops it when this program ends without a word.
    virtual void no_keep_alive(const slave_front& /*slave*/, const refusal_reason& /*why*/) {}

    virtual void changed_state(const component& /*unit*/, jaus::primary_status_code /*from*/,
                               jaus::primary_status_code /*to*/) {}
    virtual void changed_controller(const component& /*unit*/, jaus::control_change /*why*/) {}
    /// The actuator is owed a stop order from now on.
    virtual void owed(const component& /*unit*/, stop_order /*what*/, stop_cause /*why*/) {}
    /// The actuator has refused it, for the `attempts`th time: it is tried again.
    virtual void stop_refused(const component& /*unit*/, stop_order /*what*/, const refusal_reason& /*why*/,
                              unsigned /*attempts*/) {}
    /// The actuator has confirmed all that was owed.
    virtual void settled(const component& /*unit*/) {}

    /// A message was translated into this packet.
    virtual void translated(const slave_front& /*slave*/, std::span<const std::byte> /*packet*/) {}
    /// The report of a query is fetched by this packet.
    virtual void asks_report(const slave_front& /*slave*/, std::span<const std::byte> /*packet*/) {}
    /// A command went into the outputs, as the `count`th.
    virtual void into_image(const slave_front& /*slave*/, std::uint32_t /*count*/,
                            std::span<const std::byte> /*outputs*/) {}
    /// A query was answered from the inputs.
    virtual void from_image(const slave_front& /*slave*/, std::span<const std::byte> /*inputs*/) {}
    virtual void refused(const component& /*unit*/, const jaus::header& /*message*/, const refusal_reason& /*why*/) {}
};

} // namespace jauscat::bridge
