// A JAUS component whose actuator is an EtherCAT slave: keeps state, control and acknowledgement, sends stop orders,
// and forwards all other messages to the slave.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/bridge/process_channel.hpp>
#include <jauscat/bridge/slave_front.hpp>
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/wire/visit.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace jauscat::bridging {

/// Faults of drives behind one component that its observer gets at the same time.
inline constexpr std::size_t fault_capacity = 64;

/// Bits of the secondary status code in Report Component Status.
namespace secondary_status {
inline constexpr std::uint32_t slave_absent = 1;          ///< the slave does not answer
inline constexpr std::uint32_t rest_unconfirmed = 2;      ///< the actuator has not confirmed that it is at rest
inline constexpr std::uint32_t emergency_unconfirmed = 4; ///< it has not confirmed the emergency
inline constexpr std::uint32_t clear_unconfirmed = 8;     ///< it has not confirmed the end of the emergency
inline constexpr std::uint32_t drive_fault = 16;          ///< a drive behind it has a fault
} // namespace secondary_status

/// Added to a node like a jaus::component. Its actuator is brought to rest, by a Set Wrench Effort with zeros in all
/// fields, when the component leaves Ready, when its controller is lost (not when that releases control), when the
/// slave was away, and when the program ends. In an emergency it gets Set Emergency instead. A stop order overtakes all
/// queued messages and is repeated until the actuator confirms it; then the message that caused it is acknowledged.
/// Queued commands are refused.
///
/// With a process_part, messages that it takes go by the slave's process data, and its `stop` takes the place of the
/// Set Wrench Effort.
///
/// While a slave does not answer, or a drive has a fault, the component is in Failure, and its controller gets Reject
/// Component Control. When the slave is back and at rest, the component is ready again, or in Standby if it was that or
/// in an emergency.
class component {
  public:
    using bytes = std::span<const std::byte>;

    /// The front must outlive it and have a free place: component_capacity.
    component(const jaus::address& self, slave_front& front, const jaus::component_options& options = {}) noexcept
        : component{self, front, nullptr, {}, options} {}
    /// With messages by process data. The slave is cyclic; the part must outlive this and serves no other component.
    JAUSCAT_FUNCTION component(const jaus::address& self, slave_front& front, process_part& part,
                               const jaus::component_options& options = {}) noexcept;
    /// In front of several slaves, 1 to group_capacity, in the order that the part gets. The part does without
    /// mailboxes.
    JAUSCAT_FUNCTION component(const jaus::address& self, std::span<slave_front* const> group, process_part& part,
                               const jaus::component_options& options = {}) noexcept;
    component(const component&) = delete;
    component& operator=(const component&) = delete;
    [[nodiscard]] const jaus::address& self() const noexcept { return core_.self(); }
    [[nodiscard]] jaus::primary_status_code state() const noexcept { return core_.state(); }
    [[nodiscard]] const jaus::component_control& control() const noexcept { return core_.control(); }
    /// The first slave.
    [[nodiscard]] const slave_front& front() const noexcept { return front_; }
    [[nodiscard]] slave_front& front() noexcept { return front_; }
    /// All slaves answer and take messages.
    [[nodiscard]] bool is_up() const noexcept { return process_ ? process_->is_started() : front_.up(); }
    /// Nullptr without process data.
    [[nodiscard]] process_channel* process() noexcept { return process_ ? &*process_ : nullptr; }
    [[nodiscard]] const process_channel* process() const noexcept { return process_ ? &*process_ : nullptr; }
    [[nodiscard]] const std::optional<drive_fault>& fault() const noexcept { return fault_; }
    /// Stop orders that the actuator has not confirmed.
    [[nodiscard]] const pending_stops& stops() const noexcept { return stops_; }

    /// `application` gets what the core leaves; what that leaves is the slave's.
    jaus::component_outcome on_message(const jaus::header& head, bytes body, time_point now, jaus::message_sink out,
                                       auto&& application) {
        jaus::require_application<std::remove_reference_t<decltype(application)>>();
        show_pending_stops();
        const auto what = core_.on_message(head, body, now, out, [&](const jaus::header& own, bytes own_body) {
            const auto answered = jaus::outcome_of(application(own, own_body));
            return answered == jaus::message_outcome::unhandled ? accept(own, own_body, now, out) : answered;
        });
        follow_up(now, out);
        return what;
    }
    JAUSCAT_FUNCTION void on_time(time_point now, jaus::message_sink out);
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<time_point> next_event() const;
    void on_lost(const jaus::address& who) { core_.on_lost(who); }
    /// See jaus::component.
    jaus::message_outcome answer_query(const jaus::header& query, bytes body, time_point now, jaus::message_sink out) {
        return core_.answer_query(query, body, now, out);
    }

    /// Brings the actuator to rest and refuses motion commands from now on. Call at the end of the program.
    JAUSCAT_FUNCTION void shut_down(time_point now, jaus::message_sink out);

    // For the ring.

    /// Called when all slaves answer again. Sends the pending stop orders at once.
    void on_slave_up() { require_stop_of_state(stop_cause::slave_returned); }
    JAUSCAT_FUNCTION void on_slave_lost(time_point now, jaus::message_sink out);
    /// After each step of the part.
    JAUSCAT_FUNCTION void on_step(const std::optional<drive_fault>& fault, time_point now, jaus::message_sink out);
    /// Writes the message of the stop order `what` to `out`; returns its size.
    [[nodiscard]] JAUSCAT_FUNCTION std::size_t stop_message(stop_order what, std::span<std::byte> out) const noexcept;
    /// The actuator has confirmed it.
    JAUSCAT_FUNCTION void on_confirmed(stop_order what, time_point now, jaus::message_sink out);
    /// The actuator has refused it; `unknown`: it has no object for it.
    JAUSCAT_FUNCTION void on_refused(stop_order what, bool unknown, const refusal_reason& why, time_point now,
                                     jaus::message_sink out);
    /// A message that `accept` has deferred was executed.
    JAUSCAT_FUNCTION void on_executed(const jaus::header& head, time_point now, jaus::message_sink out);
    /// It was not.
    JAUSCAT_FUNCTION void on_not_executed(const jaus::header& head, const refusal_reason& why, time_point now,
                                          jaus::message_sink out);

    /// A command is in the slave's outputs, and the slave has not executed it in time: it must not execute it later.
    JAUSCAT_FUNCTION void on_not_accepted(const jaus::header& head, time_point now, jaus::message_sink out);

  private:
    JAUSCAT_FUNCTION component(const jaus::address& self, slave_front& front, process_part* part,
                               std::span<slave_front* const> group, const jaus::component_options& options) noexcept;

    // Queues a message that the core did not take. It is acknowledged when it is delivered.
    JAUSCAT_FUNCTION jaus::message_outcome accept(jaus::header head, bytes body, time_point now,
                                                  jaus::message_sink out);

    // In the queue of the slave: one for each other component that has no message there. The first message of a
    // component takes the place that the others have left.
    [[nodiscard]] JAUSCAT_FUNCTION std::size_t places_of_others() const noexcept;

    // The core has obeyed a command that changes its state: acknowledged when the actuator has, too.
    JAUSCAT_FUNCTION jaus::message_outcome state_command(const jaus::header& head);
    JAUSCAT_FUNCTION void answer_waiting(bool clears, bool executed, time_point now, jaus::message_sink out);

    // In all other states the actuator is at rest already, or a stop order is pending.
    JAUSCAT_FUNCTION void changed_state(jaus::primary_status_code from, jaus::primary_status_code to);
    JAUSCAT_FUNCTION void changed_controller(const std::optional<jaus::controller>&, jaus::control_change why);
    JAUSCAT_FUNCTION void fail(stop_cause why, jaus::message_sink out);
    JAUSCAT_FUNCTION void require_stop_of_state(stop_cause why);
    JAUSCAT_FUNCTION void require_rest(stop_cause why);
    JAUSCAT_FUNCTION void require_emergency(stop_cause why);
    JAUSCAT_FUNCTION void tell_faults(const std::optional<drive_fault>& one);
    JAUSCAT_FUNCTION void show_pending_stops() noexcept;
    JAUSCAT_FUNCTION void drops_motion();

    // Executes what the hooks of the core have requested and what needs `out`.
    JAUSCAT_FUNCTION void follow_up(time_point now, jaus::message_sink out);
    void drop_motion(time_point now, jaus::message_sink out, auto&& is_unwanted) {
        const auto is_dropped = [&](const order& each) {
            return each.unit == this && !is_query(each.header) && is_unwanted(each.header.source);
        };
        front_.orders().remove_if(
            is_dropped, [&](const order& each) { on_not_executed(each.header, {.why = refusal::stopped}, now, out); });
        if (const auto& carried = front_.carried(); carried && is_dropped(*carried)) front_.withdraw_carried();
    }

    slave_front& front_;
    std::optional<process_channel> process_{};
    std::optional<drive_fault> fault_{};
    std::array<drive_fault, fault_capacity> told_faults_{}; // each once
    std::size_t told_fault_count_{};
    pending_stops stops_;
    std::array<jaus::header, 16> waiting_{}; // state commands that the actuator has not confirmed
    std::size_t waiting_count_{};
    bool motion_is_dropped_{};         // commands that wait are refused at the next opportunity
    bool foreign_motion_is_dropped_{}; // ... those that are not the controller's
    bool ends_{};                      // the program
    bool was_at_rest_{};               // the component was not ready when the slave was lost
    jaus::component_memory<16, 256, 4096> memory_{};
    jaus::component<> core_;
};

} // namespace jauscat::bridging

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/bridge/impl/component.ipp>
#endif
