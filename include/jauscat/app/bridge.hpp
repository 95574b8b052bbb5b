// JAUS components whose actuators are slaves of an EtherCAT bus.
#pragma once
#include <jauscat/app/bridge_options.hpp>
#include <jauscat/app/bus.hpp>
#include <jauscat/app/node.hpp>
#include <jauscat/schema/jaus/core.hpp>

#include <functional>
#include <memory>
#include <vector>

namespace jauscat {
namespace bridging {
class any_exchange;
struct drive_fault;
class process_part;
struct observer;
struct slave_identity;
} // namespace bridging

inline namespace JAUSCAT_WAY {
namespace app {

class bridge_state;
/// Makes the exchange of packets under a translation table. Compiled once for the library's tables; for another one
/// include <jauscat/app/own_table.hpp>.
template <class Table> std::unique_ptr<bridging::any_exchange> make_exchange(const bridging::slave_identity& slave);
using exchange_maker = std::unique_ptr<bridging::any_exchange> (*)(const bridging::slave_identity& slave);

} // namespace app

/// Carries the messages of components to slaves by a translation table, and their reports back.
///
///     jauscat::bridge bridge{node, bus, translation::seed_table{}};
///     bridge.serve({.component = 33}, bus.slave({.position = 0}));
///     return node.run();
///
/// A component serves the core messages (state, control, emergencies, acknowledgement) by itself; the slave has all
/// others as objects. Its actuator is brought to rest, by a Set Wrench Effort of zeros, when the component leaves
/// Ready, when its controller is lost, when the slave was away, and when node, bridge or bus end; in an emergency the
/// slave gets Set Emergency. A stop order overtakes all else and is repeated until the slave confirms it. While the
/// slave does not answer, or a drive behind the component has a fault, the component is in Failure; docs/safety.md has
/// the contract. Losses, faults of drives, refused stop orders and emergencies are logged by the node and called back.
///
/// The bridge works while its node runs. The first slave gets the number of the node as its station address, each
/// further one a free address from 254 down; a slave that takes its JAUS ID from its station address then has that
/// number for its node, and the bridge changes it in all messages. A slave has up to 8 components. All bridges of a bus
/// share its master; each has its own options, and the process data have the shortest of their periods.
class bridge {
  public:
    /// Node and bus have the same io_context. Throws `std::invalid_argument` for another one and for options out of
    /// range.
    template <class Table>
    bridge(node& of, bus& on, const Table&, const bridge_options& options = {})
        : bridge{of, on, &app::make_exchange<Table>, options} {}
    /// Brings its actuators to rest, for at most 0.7 s.
    JAUSCAT_DECL ~bridge();
    bridge(const bridge&) = delete;
    bridge& operator=(const bridge&) = delete;

    /// Adds a component in front of a slave, before the node is started. A slave that is chosen by alias, name or
    /// identity is looked for on the whole bus, until it is found. Throws `std::invalid_argument` for an ID that is no
    /// component's or that the node has already, and for a slave of another bus; `std::logic_error` if the node runs.
    JAUSCAT_DECL void serve(const served_component& component, const slave& by);
    /// The same with messages by process data, as `part` carries them: for a process image of the application's see
    /// process_image in <jauscat/app/own_table.hpp>, for all else bridging::process_part. Throws
    /// `std::invalid_argument` also if the bridge has no period. Without a part, wrench efforts of component 33 go by
    /// process data, if there is a period.
    JAUSCAT_DECL void serve(const served_component& component, const slave& by,
                            std::unique_ptr<bridging::process_part> part);
    /// A component in front of 1 to 32 slaves, in the order that the part gets: element i of a JAUS list is for the
    /// slave i. If one is lost, all others are brought to rest. The part of several slaves does without mailboxes.
    JAUSCAT_DECL void serve(const served_component& component, const std::vector<slave>& group,
                            std::unique_ptr<bridging::process_part> part);

    /// Called when a slave answers and takes messages.
    JAUSCAT_DECL void when_up(std::function<void(const slave_choice& slave)> f);
    /// Called when a slave is lost: its components are in Failure.
    JAUSCAT_DECL void when_lost(std::function<void(const slave_choice& slave, boost::system::error_code why)> f);
    /// Called when a component has changed its state.
    JAUSCAT_DECL void
    when_changed(std::function<void(const jaus::address& component, jaus::primary_status_code now)> f);
    /// Called when the slave has confirmed all stop orders of a component.
    JAUSCAT_DECL void when_at_rest(std::function<void(const jaus::address& component)> f);
    /// Called for each emergency that a slave has sent.
    JAUSCAT_DECL void
    when_emergency(std::function<void(const slave_choice& slave, const ethercat::coe_emergency& emergency)> f);
    /// Called for each fault of a drive behind a component (<jauscat/bridge/process_part.hpp>): the component is in
    /// Failure. `fault.slave` is the drive's index among the slaves that `serve` got.
    JAUSCAT_DECL void
    when_faulted(std::function<void(const jaus::address& component, const bridging::drive_fault& fault)> f);
    /// Called when no drive behind a component has a fault any more.
    JAUSCAT_DECL void when_fault_ended(std::function<void(const jaus::address& component)> f);
    /// All slaves have confirmed all stop orders, also lost ones. After the end of the node: those that answered then
    /// have confirmed that they are at rest.
    [[nodiscard]] JAUSCAT_DECL bool at_rest() const;
    /// All slaves answer and take messages.
    [[nodiscard]] JAUSCAT_DECL bool is_up() const;

    /// For a log of each step, before the node is started: the functions of `by` (<jauscat/bridge/observer.hpp>) take
    /// the place of the lines about slaves and components in the node's log. They are called while the bridge works, in
    /// the thread of the bus if it has one, and must not use the bridge; they must outlive it.
    JAUSCAT_DECL void observe(const bridging::observer& by);

  private:
    JAUSCAT_DECL bridge(node& of, bus& on, app::exchange_maker make, const bridge_options& options);

    std::shared_ptr<app::bridge_state> state_;
};

} // namespace JAUSCAT_WAY
} // namespace jauscat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/app/impl/bridge.ipp>
#    include <jauscat/app/impl/bridge_state.ipp>
#    include <jauscat/app/impl/served_slave.ipp>
#    include <jauscat/app/impl/wrench_effort_part.ipp>
#endif
