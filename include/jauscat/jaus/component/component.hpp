// A component's core: state, control, acknowledgement and time, combined in the order in which they process a message.
// With a dispatcher for its own messages it is a JAUS component.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/component_clock.hpp>
#include <jauscat/jaus/component/component_hooks.hpp>
#include <jauscat/jaus/component/component_options.hpp>
#include <jauscat/jaus/component/component_outcome.hpp>
#include <jauscat/jaus/component/component_part.hpp>
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/jaus/message/stands_for.hpp>

#include <tuple>
#include <utility>

namespace jauscat::jaus {

/// The core of the component `self`. A message goes through it in this order: an acknowledgement ends here; a repeat is
/// acknowledged again and ends; what the header marks as experimental is refused if its code is the standard's, because
/// it is another message; a command from a sender without control is refused, and one that moves something unless
/// the state is Ready (see command_rules); then state, control, clock, the parts and the application get it in turn
/// until one handles it. ACK or NAK follow.
///
/// A Clear Emergency passes the control check if its sender holds the emergency: otherwise a sender that has stopped a
/// machine under control of another component could not release it, and neither could the controller.
///
/// `component_hooks` notify the application, and can defer commands of the state. `Parts` are further state machines,
/// such as service_connections, events and held_control: see component_part.
///
/// Messages must be complete (large data sets reassembled) and addressed to this component; the node ensures both.
///
///     jaus::component_memory<> memory{};
///     jaus::component core{self, memory, {.on_state = rest}, {}, connections, events};
///     jaus::dispatcher own{jaus::on<jaus::set_wrench_effort>([&](const jaus::header&, const auto& efforts) { ... })};
///     core.on_message(head, body, now, out, own);
template <class... Parts> class component {
  public:
    /// The memory, the parts and the objects of the hooks must outlive the component.
    template <std::size_t Waiting, std::size_t Size, std::size_t Remembered>
    constexpr component(const address& self, component_memory<Waiting, Size, Remembered>& memory,
                        const component_hooks& hooks, const component_options& options, Parts&... parts) noexcept
        : component{self, component_places{memory.waiting, memory.copies, memory.remembered}, hooks, options,
                    parts...} {}
    constexpr component(const address& self, const component_places& memory, const component_hooks& hooks,
                        const component_options& options, Parts&... parts) noexcept
        : self_{self},
          hooks_{hooks},
          obeys_only_when_ready_{options.obeys_only_when_ready},
          state_{self, options.after},
          control_{self, options.control},
          clock_{self},
          sender_{memory.waiting, memory.copies, options.acknowledgement},
          receiver_{self, memory.remembered, options.memory},
          parts_{parts...} {
        (require_part<Parts>(), ...);
    }

    /// `application` gets what is not the core's: see component_application.
    constexpr component_outcome on_message(const header& head, std::span<const std::byte> body, time_point now,
                                           message_sink out, auto&& application) {
        require_application<std::remove_reference_t<decltype(application)>>();
        const component_outcome what = take(head, body, now, out, application);
        ++counts_[static_cast<std::size_t>(what)];
        return what;
    }
    constexpr void on_time(time_point now, message_sink out) {
        sender_.on_time(now, out, delivered_hook());
        control_.on_time(now, out);
        tell_own_changes();
        each_part([&](auto& part) { part.on_time(now, out); });
    }
    [[nodiscard]] constexpr std::optional<time_point> next_event() const noexcept {
        std::optional<time_point> first;
        const auto consider = [&](std::optional<time_point> next) {
            if (next && (!first || *next < *first)) first = next;
        };
        consider(sender_.next_event());
        consider(control_.next_event());
        each_part([&](const auto& part) { consider(part.next_event()); });
        return first;
    }

    /// Acknowledges a deferred message: `request` is its header; ACK if `executed`, else NAK. False: no such message is
    /// pending, or no acknowledgement was requested. Call it for every deferred motion command: its sender is watched,
    /// and others no longer when it was executed.
    [[nodiscard]] constexpr bool finish(const header& request, bool executed, time_point now,
                                        message_sink out) noexcept {
        control_.finished(request, executed, now);
        return receiver_.finish(request, executed, now, out);
    }
    /// The application brings its actuators to rest by itself: no motion command is in force, and no sender is watched.
    /// Not needed after a change of the state to another one than Ready, and after control_change::lost.
    constexpr void at_rest() noexcept { control_.at_rest(); }
    /// Sends a message of the component and repeats it until it is acknowledged; the hook on_delivered gets the
    /// outcome.
    template <coded_message T>
    [[nodiscard]] constexpr send_result send(header head, const T& body, time_point now, message_sink out) noexcept {
        head.source = self_;
        return sender_.send(head, body, now, out);
    }
    template <uncoded_type T> constexpr send_result send(const header&, const T&, auto&&...) noexcept {
        refuse_uncoded_type<T>();
        return send_error{send_errc::invalid_message};
    }
    /// The same for a complete message with this component as source.
    [[nodiscard]] constexpr send_result send(std::span<const std::byte> message, time_point now,
                                             message_sink out) noexcept {
        header head{};
        if (wire::decode_prefix(head, message) && head.source != self_)
            return send_error{.code = send_errc::invalid_message, .message = errc::invalid_source};
        return sender_.send(message, now, out);
    }
    /// Sends a waiting message no more, see acknowledged_sender::forget.
    constexpr bool forget(const header& sent) noexcept { return sender_.forget(sent); }
    /// An event of the application's; see component_state::change.
    constexpr bool change(state_event event) {
        const bool changed = state_.change(event);
        tell_own_changes();
        return changed;
    }
    /// Ends an emergency of any sender.
    constexpr void end_emergency() {
        state_.end_emergency();
        tell_own_changes();
    }
    /// Takes control back; the controller gets Reject Component Control.
    constexpr void reject_control(message_sink out) {
        control_.reject(out);
        tell_own_changes();
    }
    /// A component has disappeared, or all of a level for which an octet is 255.
    constexpr void on_lost(const address& who) {
        const auto gone = [&](const address& one) { return stands_for(who, one); };
        state_.on_lost(gone);
        control_.on_lost(gone);
        tell_own_changes();
        each_part([&](auto& part) { part.on_lost(who); });
    }

    /// Answers a query of the core service, or of a part, as it would one that is received, without further effect: for
    /// connections to core_reports and events of them.
    constexpr message_outcome answer_query(const header& query, std::span<const std::byte> body, time_point now,
                                           message_sink out) {
        return ask_behind_state(state_.on_message(query, body, now, out), query, body, now, out);
    }

    /// Collects from the parts that have such a function the messages that they handle and send.
    constexpr void list_messages(auto&& takes, auto&& sends) const {
        each_part([&](const auto& part) {
            if constexpr (requires { part.list_messages(takes, sends); }) part.list_messages(takes, sends);
        });
    }

    [[nodiscard]] constexpr const address& self() const noexcept { return self_; }
    /// Initialize, Ready, Standby, Shutdown, Failure or Emergency.
    [[nodiscard]] constexpr primary_status_code state() const noexcept { return state_.state(); }
    /// Sets the secondary status code of Report Component Status.
    constexpr void set_secondary_status(std::uint32_t code) noexcept { state_.secondary_status = code; }
    [[nodiscard]] constexpr const component_control& control() const noexcept { return control_; }
    /// The component's time of day.
    [[nodiscard]] constexpr component_clock& clock() noexcept { return clock_; }
    /// Number of messages that await an acknowledgement.
    [[nodiscard]] constexpr std::size_t waiting() const noexcept { return sender_.waiting(); }
    /// Number of messages with this outcome.
    [[nodiscard]] constexpr std::uint64_t count(component_outcome what) const noexcept {
        return counts_[static_cast<std::size_t>(what)];
    }

  private:
    constexpr component_outcome take(const header& head, std::span<const std::byte> body, time_point now,
                                     message_sink out, auto& application) {
        // A large data set may have waited in the node of its sender: it is no sign of the component's life.
        if (body.size() <= max_body_size) control_.heard(head, now);
        if (is_acknowledgement(head)) {
            return sender_.on_message(head, delivered_hook()) ? component_outcome::acknowledgement
                                                              : component_outcome::unmatched_acknowledgement;
        }
        if (head.command_code == command_code_of<reject_component_control>)
            sender_.on_control_lost(head.source, delivered_hook());
        const auto refused = refused_by_rule(head);
        component_outcome what{};
        const auto handle = [&] {
            const message_outcome outcome =
                refused ? refuse(head, *refused, what) : decide(head, body, now, out, application, what);
            tell_changes();
            return outcome;
        };
        const auto& by = control_.controller();
        const receiver_context known{.is_refused = refused.has_value(),
                                     .is_of_controller = control_.controls(head.source),
                                     .controller = by ? &by->address : nullptr};
        switch (receiver_.on_message(head, body, now, out, handle, known)) {
        case received::handed_on: break;
        case received::repeated: what = component_outcome::repeated; break;
        case received::pending: what = component_outcome::pending; break;
        case received::no_capacity: what = component_outcome::no_capacity; break;
        }
        return what;
    }
    [[nodiscard]] constexpr std::optional<component_outcome> refused_by_rule(const header& head) const noexcept {
        if (head.experimental && is_standard(head.command_code)) return component_outcome::experimental;
        const bool clears_own = head.command_code == command_code_of<clear_emergency> &&
                                state_.holds_emergency(head.source) && !control_.controls(head.source);
        if (!clears_own && !control_.would_admit(head)) return component_outcome::not_controller;
        if (obeys_only_when_ready_ && state_.state() != primary_status_code::ready &&
            control_.rule(head.command_code) == command_rule::moving)
            return component_outcome::not_ready;
        return std::nullopt;
    }
    constexpr message_outcome refuse(const header& head, component_outcome why, component_outcome& what) noexcept {
        if (why == component_outcome::not_controller) static_cast<void>(control_.admits(head)); // counts it
        what = why;
        return message_outcome::refused;
    }
    // What the state has left goes to control, clock and the parts, until one handles it.
    constexpr message_outcome ask_behind_state(message_outcome outcome, const header& head,
                                               std::span<const std::byte> body, time_point now, message_sink out) {
        const auto ask = [&](auto& next) {
            if (outcome == message_outcome::unhandled) outcome = next.on_message(head, body, now, out);
        };
        ask(control_);
        ask(clock_);
        each_part(ask);
        return outcome;
    }
    // Sets `what` to the detailed outcome.
    constexpr message_outcome decide(const header& head, std::span<const std::byte> body, time_point now,
                                     message_sink out, auto& application, component_outcome& what) {
        message_outcome outcome = state_.on_message(head, body, now, out);
        if (outcome == message_outcome::handled && is_state_command(head.command_code)) outcome = tell_command(head);
        outcome = ask_behind_state(outcome, head, body, now, out);
        if (outcome == message_outcome::unhandled && control_.takes_pulse(head)) outcome = message_outcome::handled;
        if (outcome == message_outcome::unhandled) outcome = outcome_of(application(head, body));
        switch (outcome) {
        case message_outcome::handled: what = component_outcome::handled; break;
        case message_outcome::refused: what = component_outcome::refused; break;
        case message_outcome::malformed: what = component_outcome::malformed; break;
        case message_outcome::deferred: what = component_outcome::deferred; break;
        case message_outcome::unhandled: what = component_outcome::unknown; break;
        }
        control_.obeyed(head, outcome, now);
        const bool is_obeyed = outcome == message_outcome::handled || outcome == message_outcome::deferred;
        if (is_obeyed && head.command_code == command_code_of<set_emergency> && !says_emergency(body))
            what = component_outcome::stopped_on_invalid_emergency;
        return outcome;
    }

    constexpr void tell_changes() {
        if (const auto from = std::exchange(told_state_, state_.state()); from != told_state_) {
            if (told_state_ != primary_status_code::ready) control_.at_rest();
            if (hooks_.on_state) hooks_.on_state(from, told_state_);
        }
        bool tells_loss = control_.lost_mover().has_value();
        if (const auto before = std::exchange(told_controller_, control_.controller()); before != told_controller_) {
            tells_loss = tells_loss && control_.last_change() != control_change::lost;
            if (hooks_.on_controller) hooks_.on_controller(control_.controller(), control_.last_change());
        }
        if (tells_loss && hooks_.on_controller) hooks_.on_controller(control_.controller(), control_change::lost);
        if (control_.lost_mover()) control_.at_rest();
    }
    // Reports changes that no message has caused.
    constexpr void tell_own_changes() {
        if (told_state_ != state_.state() || told_controller_ != control_.controller() || control_.lost_mover())
            receiver_.on_change();
        tell_changes();
    }
    constexpr message_outcome tell_command(const header& head) {
        tell_changes();
        return hooks_.on_state_command ? hooks_.on_state_command(head) : message_outcome::handled;
    }
    constexpr auto delivered_hook() noexcept {
        return [&hooks = hooks_](const awaited_message& m, delivered what) {
            if (hooks.on_delivered) hooks.on_delivered(m, what);
        };
    }
    constexpr void each_part(auto&& use) const {
        std::apply([&](auto&... part) { (use(part), ...); }, parts_);
    }

    address self_;
    component_hooks hooks_;
    bool obeys_only_when_ready_;
    component_state<> state_;
    component_control control_;
    component_clock clock_;
    acknowledged_sender sender_;
    acknowledged_receiver receiver_;
    std::tuple<Parts&...> parts_;
    primary_status_code told_state_{};
    std::optional<controller> told_controller_{};
    std::array<std::uint64_t, component_outcome_count> counts_{};
};

/// The arguments of the template follow from those of the constructor.
template <std::size_t Waiting, std::size_t Size, std::size_t Remembered, class... Parts>
component(const address&, component_memory<Waiting, Size, Remembered>&, const component_hooks&,
          const component_options&, Parts&...) -> component<Parts...>;

} // namespace jauscat::jaus
