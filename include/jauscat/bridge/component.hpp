// A JAUS component whose actuator is an EtherCAT slave: keeps state, control and acknowledgement, sends stop orders,
// and forwards all other messages to the slave.
#pragma once
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
    component(const jaus::address& self, slave_front& front, process_part& part,
              const jaus::component_options& options = {}) noexcept
        : component{self, front, &part, {}, options} {}
    /// In front of several slaves, 1 to group_capacity, in the order that the part gets. The part does without
    /// mailboxes.
    component(const jaus::address& self, std::span<slave_front* const> group, process_part& part,
              const jaus::component_options& options = {}) noexcept
        : component{self, *group.front(), &part, group, options} {}
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
    void on_time(time_point now, jaus::message_sink out) {
        show_pending_stops();
        core_.on_time(now, out);
        follow_up(now, out);
    }
    [[nodiscard]] std::optional<time_point> next_event() const {
        return motion_is_dropped_ || foreign_motion_is_dropped_ ? std::optional{time_point::min()} : core_.next_event();
    }
    void on_lost(const jaus::address& who) { core_.on_lost(who); }

    /// Brings the actuator to rest and refuses motion commands from now on. Call at the end of the program.
    void shut_down(time_point now, jaus::message_sink out) {
        ends_ = true;
        core_.change(jaus::state_event::shutdown);
        if (stops_.settled()) require_rest(stop_cause::program_ends);
        follow_up(now, out);
    }

    // For the ring.

    /// Called when all slaves answer again. Sends the pending stop orders at once.
    void on_slave_up() { require_stop_of_state(stop_cause::slave_returned); }
    void on_slave_lost(time_point now, jaus::message_sink out) {
        if (process_)
            process_->end(
                [&](const jaus::header& head) { on_not_executed(head, {.why = refusal::slave_down}, now, out); });
        fail(stop_cause::slave_absent, out);
        follow_up(now, out);
    }
    /// After each step of the part.
    void on_step(const std::optional<drive_fault>& fault, time_point now, jaus::message_sink out) {
        const bool was_faulted = fault_.has_value(), is_new = fault && fault != fault_;
        fault_ = fault;
        if (is_new) front_.watcher().faulted(*this, *fault);
        if (was_faulted && !fault) front_.watcher().fault_ended(*this);
        if (!was_faulted && fault)
            fail(stop_cause::drive_fault, out);
        else if (fault && core_.state() == jaus::primary_status_code::initialize)
            core_.change(jaus::state_event::failed); // after a Reset
        if (was_faulted || fault) follow_up(now, out);
    }
    /// Writes the message of the stop order `what` to `out`; returns its size.
    [[nodiscard]] std::size_t stop_message(stop_order what, std::span<std::byte> out) const noexcept {
        const jaus::header head{.ack_nak = jaus::ack_nak::request, .destination = self(), .source = self()};
        if (what == stop_order::emergency) {
            jaus::set_emergency stop{};
            stop.emergency_code.set(jaus::set_emergency_code::transition_to_emergency);
            return jaus::make_message(head, stop, out)->size();
        }
        if (what == stop_order::clear_emergency) {
            jaus::clear_emergency clear{};
            clear.emergency_code.set(jaus::clear_emergency_code::clear_emergency);
            return jaus::make_message(head, clear, out)->size();
        }
        jaus::set_wrench_effort nothing{};
        wire::visit(nothing, [](auto, auto& effort) { effort = 0.0; });
        return jaus::make_message(head, nothing, out)->size();
    }
    /// The actuator has confirmed it.
    void on_confirmed(stop_order what, time_point now, jaus::message_sink out) {
        stops_.confirmed(what);
        if (!stops_.stop_is_pending()) answer_waiting(false, true, now, out);
        if (!stops_.clear_is_pending()) answer_waiting(true, what == stop_order::clear_emergency, now, out);
        if (stops_.settled()) front_.watcher().settled(*this);
        follow_up(now, out);
    }
    /// The actuator has refused it; `unknown`: it has no object for it.
    void on_refused(stop_order what, bool unknown, const refusal_reason& why, time_point now, jaus::message_sink out) {
        const bool goes_on = stops_.refused(what, unknown, now);
        front_.watcher().stop_refused(*this, what, why, stops_.refusals());
        if (!goes_on) answer_waiting(true, false, now, out);
        if (!stops_.stop_is_pending()) answer_waiting(false, true, now, out);
        follow_up(now, out);
    }
    /// A message that `accept` has deferred was executed.
    void on_executed(const jaus::header& head, time_point now, jaus::message_sink out) {
        static_cast<void>(core_.finish(head, true, now, out)); // not requested by every message
    }
    /// It was not.
    void on_not_executed(const jaus::header& head, const refusal_reason& why, time_point now, jaus::message_sink out) {
        front_.watcher().refused(*this, head, why);
        static_cast<void>(core_.finish(head, false, now, out)); // not requested by every message
    }

    /// A command is in the slave's outputs, and the slave has not executed it in time: it must not execute it later.
    void on_not_accepted(const jaus::header& head, time_point now, jaus::message_sink out) {
        on_not_executed(head, {.why = refusal::not_accepted}, now, out);
        if (!stops_.stop_is_pending()) require_rest(stop_cause::not_accepted);
    }

  private:
    component(const jaus::address& self, slave_front& front, process_part* part, std::span<slave_front* const> group,
              const jaus::component_options& options) noexcept
        : front_{front},
          stops_{front.timing().stop_interval},
          core_{self,
                memory_,
                {.on_state = jaus::bound<&component::changed_state>(*this),
                 .on_controller = jaus::bound<&component::changed_controller>(*this),
                 .on_state_command = jaus::bound<&component::state_command>(*this)},
                options} {
        std::array<slave_front*, 1> one{&front};
        const auto fronts = group.empty() ? std::span<slave_front* const>{one} : group;
        if (part != nullptr) process_.emplace(*part, fronts);
        for (auto* const each : fronts) static_cast<void>(each->add(*this)); // has room: see above
        stops_.require_rest();                                               // what the actuator does is not known yet
    }

    // Queues a message that the core did not take. It is acknowledged when it is delivered.
    jaus::message_outcome accept(jaus::header head, bytes body, time_point now, jaus::message_sink out) {
        const auto refuse = [&](refusal why) {
            front_.watcher().refused(*this, head, {.why = why});
            return jaus::message_outcome::refused;
        };
        if (process_ && !process_->part().uses_mailbox() && !process_->takes(head))
            return jaus::message_outcome::unhandled;
        if (!is_up()) return refuse(refusal::slave_down);
        const order message{.header = head, .unit = this, .expires = deadline{now, front_.timing().order_timeout}};
        const auto superseded = [&](const jaus::header& older) {
            on_not_executed(older, {.why = refusal::superseded}, now, out);
        };
        switch (front_.orders().push(message, body, superseded, places_of_others())) {
        case queued::full: return refuse(refusal::queue_full);
        case queued::too_large: return refuse(refusal::too_large);
        default: front_.wake(); return jaus::message_outcome::deferred;
        }
    }

    // In the queue of the slave: one for each other component that has no message there. The first message of a
    // component takes the place that the others have left.
    [[nodiscard]] std::size_t places_of_others() const noexcept {
        const auto& orders = front_.orders();
        if (!orders.has_one_of(*this)) return 0;
        return static_cast<std::size_t>(std::ranges::count_if(front_.components(), [&](const component* each) {
            return &each->front_ == &front_ && !orders.has_one_of(*each);
        }));
    }

    // The core has obeyed a command that changes its state: acknowledged when the actuator has, too.
    jaus::message_outcome state_command(const jaus::header& head) {
        using enum jaus::message_outcome;
        if (head.command_code == jaus::command_code_of<jaus::reset> && process_) process_->reset();
        if (head.command_code == jaus::command_code_of<jaus::resume>) return handled;
        if (head.command_code == jaus::command_code_of<jaus::clear_emergency>) {
            if (core_.state() == jaus::primary_status_code::emergency) return handled; // others hold it
            stops_.require_clear();
            front_.wake();
        }
        if (stops_.settled()) return handled;
        // The core passes a repeated Set Emergency on; of other commands a message with a waiting one's header is new.
        const auto same = [&](const jaus::header& each) {
            return each.source == head.source && each.sequence_number == head.sequence_number &&
                   each.command_code == head.command_code &&
                   head.command_code == jaus::command_code_of<jaus::set_emergency>;
        };
        const auto known = std::span{waiting_}.first(waiting_count_);
        if (head.ack_nak != jaus::ack_nak::request || std::ranges::any_of(known, same)) return deferred;
        if (waiting_count_ == waiting_.size())
            return refused; // executed; a repeat finds a place when the others are confirmed
        waiting_[waiting_count_++] = head;
        return deferred;
    }
    void answer_waiting(bool clears, bool executed, time_point now, jaus::message_sink out) {
        std::size_t left = 0;
        for (const jaus::header& each : std::span{waiting_}.first(waiting_count_))
            if ((each.command_code == jaus::command_code_of<jaus::clear_emergency>) == clears)
                static_cast<void>(core_.finish(each, executed, now, out)); // not requested by every message
            else
                waiting_[left++] = each;
        waiting_count_ = left;
    }

    // In all other states the actuator is at rest already, or a stop order is pending.
    void changed_state(jaus::primary_status_code from, jaus::primary_status_code to) {
        front_.watcher().changed_state(*this, from, to);
        if (to == jaus::primary_status_code::emergency)
            require_emergency(stop_cause::state);
        else if (from == jaus::primary_status_code::ready && is_up())
            require_rest(ends_ ? stop_cause::program_ends : stop_cause::state);
    }
    void changed_controller(const std::optional<jaus::controller>&, jaus::control_change why) {
        front_.watcher().changed_controller(*this, why);
        if (why == jaus::control_change::lost) require_rest(stop_cause::controller_lost);
        // Queued motion commands of others than the new controller are dropped.
        if (why == jaus::control_change::lost || why == jaus::control_change::released) return;
        foreign_motion_is_dropped_ = true;
        front_.wake();
    }
    void fail(stop_cause why, jaus::message_sink out) {
        using enum jaus::primary_status_code;
        was_at_rest_ = was_at_rest_ || core_.state() == standby || core_.state() == emergency;
        require_stop_of_state(why);
        core_.change(jaus::state_event::failed);
        core_.reject_control(out);
    }
    void require_stop_of_state(stop_cause why) {
        if (core_.state() == jaus::primary_status_code::emergency)
            require_emergency(why);
        else
            require_rest(why);
    }
    void require_rest(stop_cause why) {
        stops_.require_rest();
        drops_motion();
        front_.watcher().stop_required(*this, stop_order::rest, why);
    }
    void require_emergency(stop_cause why) {
        stops_.require_emergency();
        drops_motion();
        front_.watcher().stop_required(*this, stop_order::emergency, why);
    }
    void show_pending_stops() noexcept {
        core_.set_secondary_status((is_up() ? 0 : secondary_status::slave_absent) |
                                   (fault_ ? secondary_status::drive_fault : 0) |
                                   (stops_.rest_is_pending() ? secondary_status::rest_unconfirmed : 0) |
                                   (stops_.emergency_is_pending() ? secondary_status::emergency_unconfirmed : 0) |
                                   (stops_.clear_is_pending() ? secondary_status::clear_unconfirmed : 0));
    }
    void drops_motion() {
        motion_is_dropped_ = true;
        front_.wake();
    }

    // Executes what the hooks of the core have requested and what needs `out`.
    void follow_up(time_point now, jaus::message_sink out) {
        if (std::exchange(foreign_motion_is_dropped_, false)) {
            const auto& controller = core_.control().controller();
            drop_motion(now, out, [&](const jaus::address& who) { return !controller || controller->address != who; });
        }
        if (std::exchange(motion_is_dropped_, false)) {
            drop_motion(now, out, [](const jaus::address&) { return true; });
            if (!stops_.clear_is_pending()) answer_waiting(true, false, now, out); // a new emergency arrived before
        }
        if (!is_up() || fault_ || !stops_.settled()) return;
        if (core_.state() == jaus::primary_status_code::failure) core_.change(jaus::state_event::reset);
        if (core_.state() != jaus::primary_status_code::initialize) return;
        core_.change(jaus::state_event::initialized);
        if (std::exchange(was_at_rest_, false)) core_.change(jaus::state_event::standby);
    }
    void drop_motion(time_point now, jaus::message_sink out, auto&& is_unwanted) {
        front_.orders().remove_if(
            [&](const order& each) {
                return each.unit == this && !is_query(each.header) && is_unwanted(each.header.source);
            },
            [&](const order& each) { on_not_executed(each.header, {.why = refusal::stopped}, now, out); });
    }

    slave_front& front_;
    std::optional<process_channel> process_{};
    std::optional<drive_fault> fault_{};
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
