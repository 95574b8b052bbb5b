// The functions of component_state.
#pragma once
#include <jauscat/app/detail/explained.hpp>
#include <jauscat/app/impl/clients.hpp>
#include <jauscat/app/impl/component_state.hpp>
#include <jauscat/app/impl/node_state.hpp>
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/jaus/events/core_reports.hpp>
#include <jauscat/jaus/events/events.hpp>
#include <jauscat/jaus/events/service_connections.hpp>
#include <jauscat/net/node/detail/offered_messages.hpp>
#include <jauscat/text/diagnosis_text.hpp>
#include <jauscat/text/message_name.hpp>

#include <algorithm>
#include <array>
#include <exception>
#include <random>
#include <stdexcept>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

/// What `start` builds: it refers to itself.
struct component_state::core {
    static constexpr std::size_t capacity = 64; ///< connections, and events

    using connections_type = jaus::service_connections<capacity>;
    using events_type = jaus::events<capacity>;
    using component_type = jaus::component<clients, connections_type, events_type, jaus::described_component>;

    struct connection_filler {
        component_state& of;
        std::optional<std::size_t> operator()(std::uint16_t code, std::uint32_t presence,
                                              std::span<std::byte> body) const {
            return of.core_->fill(of, code, {nullptr, presence}, body);
        }
    };
    struct event_filler {
        component_state& of;
        std::optional<std::size_t> operator()(std::uint16_t code, bytes query, std::span<std::byte> body) const {
            return of.core_->fill(of, code, query.empty() ? report_request{} : report_request{&query}, body);
        }
    };
    struct hooks {
        component_state& of;
        void state(jaus::primary_status_code from, jaus::primary_status_code to) const { of.note_state(from, to); }
        void controller(const std::optional<jaus::controller>& by, jaus::control_change why) const {
            of.note_controller(by, why);
        }
        void delivered(const jaus::awaited_message& message, jaus::delivered what) const {
            of.core_->others.on_delivered(message.header, what, false);
        }
    };

    core(component_state& of, const jaus::identity& identity, bool beats);
    static const std::vector<given_report>& given_core_reports();
    jaus::message_outcome write_core(const jaus::core_report& report, const report_request& request,
                                     std::vector<std::byte>& body);

    static std::optional<std::size_t> fill(component_state& of, std::uint16_t code, const report_request& request,
                                           std::span<std::byte> body) {
        const auto& gives = of.core_->gives;
        const auto found = std::ranges::find(gives, code, &given_report::command_code);
        const auto* const report = found == gives.end() ? nullptr : *found;
        if (report == nullptr || of.write(*report, request) != jaus::message_outcome::handled) return std::nullopt;
        if (of.body_.size() <= body.size()) std::ranges::copy(of.body_, body.begin());
        return of.body_.size();
    }

    std::vector<const given_report*> gives; ///< of the application, and of the core service
    std::vector<jaus::connectable_report> connectable{};
    std::vector<jaus::eventful_report> eventful{};
    connection_filler fill_connection;
    event_filler fill_event;
    hooks hook;
    std::vector<std::byte> connection_memory, event_memory, services_memory;
    std::vector<std::vector<std::byte>> last{}; ///< body of each report while there are events of it
    connections_type connections;
    events_type events;
    net::detail::offered_messages offered;
    std::vector<std::uint16_t> harmless; ///< also the queries of reports
    std::array<jaus::offered_service, 2> services{jaus::core_messages::service};
    jaus::described_component described;
    clients others;
    std::array<jaus::awaited_message, 64> waiting{};
    std::vector<std::byte> copies;
    std::vector<jaus::acknowledged_message> remembered;
    component_type machine;
};

/// The reports that every component has, written as it answers the queries for them.
inline const std::vector<given_report>& component_state::core::given_core_reports() {
    static const auto all = [] {
        std::vector<given_report> made;
        for (const auto& one : jaus::core_reports)
            made.push_back({.command_code = one.command_code,
                            .query_code = one.query_code,
                            .presence_bits = one.presence_bits(),
                            .max_rate = jaus::max_core_report_rate,
                            .read_field = one.read_field,
                            .on_change = one.on_change,
                            .write = [&one](const report_request& request, std::vector<std::byte>& body,
                                            component_state& of) { return of.core_->write_core(one, request, body); }});
        return made;
    }();
    return all;
}

inline jaus::message_outcome component_state::core::write_core(const jaus::core_report& report,
                                                               const report_request& request,
                                                               std::vector<std::byte>& body) {
    body.resize(jaus::max_body_size);
    const jaus::query_answer answer{jaus::bound<&component_type::answer_query>(machine)};
    const auto& self = machine.self();
    const auto size = request.query != nullptr
                          ? jaus::write_core_report(report, self, *request.query, body, net::now(), answer)
                          : jaus::write_core_report(report, self, request.presence_bits, body, net::now(), answer);
    body.resize(size.value_or(0));
    return size ? jaus::message_outcome::handled : jaus::message_outcome::refused;
}

inline component_state::core::core(component_state& of, const jaus::identity& identity, bool beats)
    : gives{[&] {
          std::vector<const given_report*> all;
          for (const auto& one : of.gives_) all.push_back(&one);
          for (const auto& one : given_core_reports())
              if (of.report_of(one.command_code) == nullptr) all.push_back(&one);
          return all;
      }()},
      connectable{[&] {
          std::vector<jaus::connectable_report> all;
          for (const auto* const one : gives)
              all.push_back({.command_code = one->command_code,
                             .max_rate = one->max_rate,
                             .presence_vector = one->presence_bits});
          return all;
      }()},
      eventful{[&] {
          std::vector<jaus::eventful_report> all;
          for (const auto* const one : gives)
              all.push_back({.command_code = one->command_code,
                             .read_field = one->read_field,
                             .max_rate = one->max_rate,
                             .on_change = one->on_change});
          return all;
      }()},
      fill_connection{of},
      fill_event{of},
      hook{of},
      connection_memory(4096),
      event_memory(3 * 4096),
      services_memory(2 * 4096),
      last(gives.size()),
      connections{of.self_, connectable, fill_connection, connection_memory},
      events{of.self_, eventful, fill_event, event_memory},
      offered{of, connections, events},
      harmless{[&] {
          auto all = of.options_.harmless;
          for (const auto& one : of.gives_) all.push_back(one.query_code);
          return all;
      }()},
      described{of.self_,
                {identity,
                 [&]() -> std::span<const jaus::offered_service> {
                     services[1] = {of.self_.component, std::span<const jaus::supported_message>{offered.input},
                                    std::span<const jaus::supported_message>{offered.output}};
                     const bool has_more = !offered.input.empty() || !offered.output.empty();
                     return std::span{services}.first(has_more ? 2 : 1);
                 }()},
                beats ? jaus::heartbeat_to_node_manager(of.self_) : jaus::heartbeat{.period = {}},
                services_memory},
      others{of, of.self_, of.options_.retry},
      copies(waiting.size() * 4096),
      remembered(std::max<std::size_t>(of.options_.remembered, 4)),
      machine{of.self_,
              jaus::component_places{waiting, copies, remembered},
              {.on_state = jaus::bound<&hooks::state>(hook),
               .on_controller = jaus::bound<&hooks::controller>(hook),
               .on_delivered = jaus::bound<&hooks::delivered>(hook)},
              {.control = {.authority_code = identity.authority_code,
                           .harmless = harmless,
                           .timeout = of.options_.controller_timeout,
                           .without_control = of.options_.without_control},
               .acknowledgement = {.retry = of.options_.retry,
                                   .first_number = static_cast<std::uint16_t>(std::random_device{}())},
               .obeys_only_when_ready = of.options_.obeys_only_when_ready},
              others,
              connections,
              events,
              described} {}

JAUSCAT_DECL component_state::component_state(node_state& node, const jaus::address& self, component_options options)
    : own_context_{node.own_context()},
      node_{&node},
      context_{node.shared_context()},
      self_{self},
      options_{std::move(options)} {}
JAUSCAT_DECL component_state::~component_state() = default;

JAUSCAT_DECL clients& component_state::others() noexcept { return core_->others; }
JAUSCAT_DECL void component_state::on_appeared(const jaus::address& who) { core_->others.appeared(who); }
JAUSCAT_DECL void component_state::on_large_delivered(const jaus::header& head, jaus::delivered what) {
    core_->others.on_delivered(head, what, true);
}
JAUSCAT_DECL result<std::uint16_t, jaus::send_error> component_state::send_acknowledged(bytes message) {
    return core_->machine.send(message, net::now(), node_->net().out());
}
JAUSCAT_DECL void component_state::forget(const jaus::header& sent) noexcept { core_->machine.forget(sent); }
JAUSCAT_DECL bool component_state::is_routable(const jaus::address& to) const {
    return node_->is_open() || node_->net().config().next_hop(to) != nullptr;
}

JAUSCAT_DECL void component_state::take(taken_message message) {
    if (is_running()) throw std::logic_error{"handlers are given before the node starts"};
    const auto code = message.command_code;
    const auto is_same = [&](const auto& one) { return one.command_code == code; };
    if (std::ranges::any_of(takes_, is_same) ||
        std::ranges::any_of(gives_, [&](const auto& one) { return one.query_code == code; }))
        throw std::logic_error{"a second handler of " + text::message_name(code)};
    takes_.push_back(std::move(message));
}

JAUSCAT_DECL void component_state::give(given_report report) {
    if (is_running()) throw std::logic_error{"reports are given before the node starts"};
    if (std::ranges::any_of(gives_, [&](const auto& one) { return one.query_code == report.query_code; }) ||
        std::ranges::any_of(takes_, [&](const auto& one) { return one.command_code == report.query_code; }))
        throw std::logic_error{"a second source of " + text::message_name(report.command_code)};
    gives_.push_back(std::move(report));
}

JAUSCAT_DECL bool component_state::guard(std::string_view what, std::uint16_t command_code,
                                         jaus::hook<void()> call) noexcept {
    std::string why;
    try {
        try {
            call();
            return true;
        } catch (const std::exception& e) {
            why = e.what();
        } catch (...) {
            why = "of an unknown type";
        }
        has_failed_ = true;
        is_ready_ = false;
        node_->log(net::to_jausip(self_) + ": exception of " + std::string{what} +
                   (command_code != 0 ? text::message_name(command_code) : "") + ": " + why +
                   "; the component is stopped");
    } catch (...) { // of the application's log, and for want of memory
        has_failed_ = true;
        is_ready_ = false;
    }
    return false;
}
JAUSCAT_DECL bool component_state::guard(std::string_view what, const std::function<void()>& call) noexcept {
    return guard(what, 0, call);
}

/// `work()` may call functions of the application: what those ask for waits until it has returned.
auto component_state::in_turn(auto&& work) {
    struct turn {
        bool& flag;
        bool before;
        explicit turn(bool& f) : flag{f}, before{std::exchange(f, true)} {}
        ~turn() { flag = before; }
    } const now{in_turn_};
    return work();
}

JAUSCAT_DECL void component_state::tell_stopped() noexcept {
    core_->machine.at_rest();
    if (!on_stopped || closed_) return;
    has_changed_ = true;
    const auto call = on_stopped; // which may replace it
    guard("when_stopped", call);
}

JAUSCAT_DECL void component_state::note_state(jaus::primary_status_code from, jaus::primary_status_code to) {
    using enum jaus::primary_status_code;
    has_changed_ = true;
    if (to != jaus::primary_status_code::ready) tell_stopped();
    if (const auto tell = on_ready; to == jaus::primary_status_code::ready && tell) guard("when_ready", tell);
    const auto tell = on_emergency;
    if (!tell || (from != emergency && to != emergency)) return;
    const auto call = [&] { tell(to == emergency); };
    guard("when_emergency", 0, call);
}

JAUSCAT_DECL void component_state::note_controller(const std::optional<jaus::controller>& by,
                                                   jaus::control_change why) {
    if (const auto lost = core_->machine.control().lost_mover(); lost && why == jaus::control_change::lost) {
        node_->log(net::to_jausip(self_) + ": " + net::to_jausip(*lost) +
                   ", the sender of its last motion command, is lost: it is stopped");
        tell_stopped();
    }
    const auto now_it_is = by ? std::optional{by->address} : std::nullopt;
    const auto before = std::exchange(controller_, now_it_is);
    if (before == now_it_is) return;
    has_changed_ = true;
    if (before) tell_stopped();
    const auto tell = on_controlled;
    if (!tell) return;
    const auto call = [&] { tell(now_it_is); };
    guard("when_controlled", 0, call);
}

JAUSCAT_DECL void component_state::settle() {
    using enum jaus::primary_status_code;
    // What is called here may fail in its turn. It is told once, and Ready is tried once, so that this ends.
    in_turn([&] {
        bool was_told = false;
        bool was_ready = false;
        while (is_running_ && !is_stopping_) {
            auto& machine = core_->machine;
            if (std::exchange(has_failed_, false)) {
                static_cast<void>(machine.change(jaus::state_event::failed));
                if (machine.state() != failure && !std::exchange(was_told, true)) tell_stopped(); // emergencies stay
            } else if (is_ready_ && machine.state() == failure && !was_ready) {
                if (!machine.change(jaus::state_event::reset)) return;
            } else if (is_ready_ && machine.state() == initialize && !std::exchange(was_ready, true)) {
                if (!machine.change(jaus::state_event::initialized)) return;
            } else {
                return;
            }
        }
    });
}

JAUSCAT_DECL void component_state::end_turn(time_point now, jaus::message_sink out) {
    settle();
    // Twice: where the function of a report fails, when_stopped is called and may change another one.
    for (int i = 0; i != 2 && is_running_ && std::exchange(has_changed_, false); ++i) {
        in_turn([&] { send_changes(now, out); });
        settle();
    }
}

JAUSCAT_DECL void component_state::ready() {
    is_ready_ = true;
    if (in_turn_ || !is_running_) return;
    end_turn(net::now(), node_->net().out());
    node_->wake();
}

JAUSCAT_DECL void component_state::fail(std::string_view why) {
    if (node_ == nullptr) return;
    node_->log(net::to_jausip(self_) + ": fails: " + std::string{why});
    has_failed_ = true;
    is_ready_ = false;
    if (!is_running_ || in_turn_) return;
    end_turn(net::now(), node_->net().out());
    node_->wake();
}

JAUSCAT_DECL void component_state::reject_control() {
    if (!is_running_) return;
    const bool is_turn = in_turn_;
    in_turn([&] { core_->machine.reject_control(node_->net().out()); });
    if (!is_turn) end_turn(net::now(), node_->net().out());
    node_->wake();
}

JAUSCAT_DECL void component_state::start(const jaus::identity& identity, bool beats, time_point now) {
    controller_.reset();
    has_failed_ = false;
    core_ = std::make_unique<core>(*this, identity, beats);
    is_running_ = true;
    for (auto& one : periodic) one.due = now;
}

JAUSCAT_DECL void component_state::begin() {
    if (!is_running_) return; // another one has stopped the node
    settle();
    node_->wake();
}

JAUSCAT_DECL void component_state::stop() noexcept {
    if (!is_running_ || std::exchange(is_stopping_, true)) return;
    in_turn([&] { tell_stopped(); });
    core_->others.end_all(boost::asio::error::operation_aborted, net::now(), node_->net().out());
    is_running_ = false;
    is_stopping_ = false;
}

JAUSCAT_DECL void component_state::close() noexcept {
    stop();
    closed_ = true;
    if (in_turn_) return; // by one of its functions, which stays until it has returned
    on_stopped = on_ready = nullptr;
    on_emergency = nullptr;
    on_controlled = nullptr;
    on_others = nullptr;
    takes_.clear();
    gives_.clear();
    periodic.clear();
}

JAUSCAT_DECL jaus::primary_status_code component_state::state() const noexcept {
    return !is_running_ ? jaus::primary_status_code::initialize : core_->machine.state();
}
JAUSCAT_DECL std::optional<jaus::address> component_state::controller() const noexcept { return controller_; }

JAUSCAT_DECL const given_report* component_state::report_of(std::uint16_t command_code) const {
    const auto found = std::ranges::find(gives_, command_code, &given_report::command_code);
    return found == gives_.end() ? nullptr : &*found;
}

JAUSCAT_DECL jaus::message_outcome component_state::write(const given_report& report, const report_request& request) {
    auto outcome = jaus::message_outcome::refused;
    const auto call = [&] { outcome = report.write(request, body_, *this); };
    guard("the function of ", report.command_code, call);
    return outcome;
}

JAUSCAT_DECL jaus::message_outcome component_state::handle(const jaus::header& head, bytes body) {
    const auto handler = std::ranges::find(takes_, head.command_code, &taken_message::command_code);
    const auto report = std::ranges::find(gives_, head.command_code, &given_report::query_code);
    if (handler != takes_.end() || (report == gives_.end() && on_others)) {
        auto outcome = jaus::message_outcome::refused;
        const auto others = handler != takes_.end() ? nullptr : on_others;
        const auto call = [&] {
            outcome = handler != takes_.end() ? handler->handle({head, body, *this}) : others(head, body);
        };
        guard("the handler of ", head.command_code, call);
        return outcome;
    }
    if (report == gives_.end()) return jaus::message_outcome::unhandled;
    const auto outcome = write(*report, {&body});
    if (outcome != jaus::message_outcome::handled) return outcome;
    return answer(*this, head, report->command_code, body_) ? outcome : jaus::message_outcome::refused;
}

/// Finds the reports with events that have changed.
JAUSCAT_DECL void component_state::send_changes(time_point now, jaus::message_sink out) {
    const auto records = core_->events.records();
    for (std::size_t i = 0; i != core_->gives.size(); ++i) {
        const auto& report = *core_->gives[i];
        auto& last = core_->last[i];
        const auto code = report.command_code;
        if (!report.on_change || std::ranges::none_of(records, [&](const auto& e) { return e.message_code == code; })) {
            last.clear();
            continue;
        }
        if (write(report, {}) != jaus::message_outcome::handled || last == body_) continue;
        const bool is_first = last.empty();
        last = body_;
        if (!is_first) core_->events.changed(code, last, now, out);
    }
}

JAUSCAT_DECL void component_state::changed() {
    has_changed_ = true;
    if (!is_running_ || in_turn_) return; // within a turn it is looked for at its end
    end_turn(net::now(), node_->net().out());
    node_->wake();
}

JAUSCAT_DECL jaus::component_outcome
component_state::on_message(const jaus::header& head, bytes body, time_point now, jaus::message_sink out,
                            jaus::hook<jaus::message_outcome(const jaus::header&, bytes)> unhandled) {
    if (!is_running_) return jaus::component_outcome::unknown;
    const auto outcome = in_turn([&] {
        // A private report may be a command, for all that the state machines know.
        if (jaus::is_private(head.command_code) && core_->others.awaits(head) &&
            core_->others.on_message(head, body, now, out) == jaus::message_outcome::handled)
            return jaus::component_outcome::handled;
        return core_->machine.on_message(head, body, now, out, [&](const jaus::header& h, bytes b) {
            const auto what = handle(h, b);
            return what == jaus::message_outcome::unhandled ? unhandled(h, b) : what;
        });
    });
    has_changed_ = true; // a handler was called, or there is a new event
    end_turn(now, out);
    return outcome;
}

JAUSCAT_DECL void component_state::on_time(time_point now, jaus::message_sink out) {
    if (!is_running_) return;
    in_turn([&] {
        for (auto& one : periodic) {
            if (one.due > now || !is_running_) continue;
            one.due = saturating_add(one.due, ((now - one.due) / one.period + 1) * one.period);
            guard("a periodic function", one.call);
            has_changed_ = true;
        }
        if (is_running_) core_->machine.on_time(now, out);
    });
    end_turn(now, out);
}

JAUSCAT_DECL std::optional<time_point> component_state::next_event() const {
    if (!is_running_) return std::nullopt;
    auto first = core_->machine.next_event();
    for (const auto& one : periodic)
        if (!first || one.due < *first) first = one.due;
    return first;
}

JAUSCAT_DECL void component_state::on_lost(const jaus::address& who) {
    if (!is_running_) return;
    in_turn([&] { core_->machine.on_lost(who); });
    end_turn(net::now(), node_->net().out());
}

JAUSCAT_DECL void component_state::list_messages(listing takes, listing sends) const {
    for (const auto& one : takes_) {
        takes(jaus::supported_message{one.command_code, one.presence_bits});
        const auto report = one.answer_code != 0 ? one.answer_code : jaus::report_code_of(one.command_code);
        if (report != 0) sends(jaus::supported_message{report});
    }
    for (const auto& one : gives_) {
        takes(jaus::supported_message{one.query_code, one.presence_bits});
        sends(jaus::supported_message{one.command_code, one.presence_bits});
    }
}

JAUSCAT_DECL bool answer(component_state& from, const jaus::header& request, std::uint16_t command_code, bytes body) {
    auto head = jaus::answer_to(request, from.self());
    head.command_code = command_code;
    head.experimental = jaus::is_private(command_code);
    const auto sent = from.node().net().send(head, body);
    if (!sent)
        from.node().log(net::to_jausip(from.self()) + ": " + text::message_name(command_code) +
                        " is not sent: " + sent.error().message);
    return sent.has_value();
}
JAUSCAT_DECL std::span<std::byte> list_memory(component_state& of, std::size_t at_least) {
    if (of.lists.size() < at_least) of.lists.resize(at_least);
    return of.lists;
}
JAUSCAT_DECL jaus::message_outcome malformed(component_state& at, wire::errc why) {
    at.malformed_because = wire::describe(why);
    return jaus::message_outcome::malformed;
}
inline std::string text_of(const wire::diagnosis& why) {
    const auto field = text::field_path(why);
    return (field.empty() ? "" : field + ": ") + std::string{wire::describe(why.error)};
}
JAUSCAT_DECL void log_not_encodable(component_state& from, std::uint16_t command_code, const wire::diagnosis& why) {
    from.node().log(net::to_jausip(from.self()) + ": " + text::message_name(command_code) +
                    " is not sent: " + text_of(why));
}
JAUSCAT_DECL boost::system::error_code not_encodable(std::uint16_t command_code, const wire::diagnosis& why) {
    if (why) return {};
    return explained(node_errc::not_encodable, text::message_name(command_code) + ": " + text_of(why));
}
JAUSCAT_DECL net::error not_sent(std::uint16_t command_code, const wire::diagnosis& why) {
    auto error = net::not_encodable(why.error);
    error.message = text::message_name(command_code) + ": " + text_of(why);
    return error;
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
