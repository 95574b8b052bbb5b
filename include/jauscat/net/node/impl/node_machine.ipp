// The functions of node_machine.
#pragma once
#include <jauscat/net/detail/named_forms.hpp>
#include <jauscat/net/limited_log.hpp>
#include <jauscat/net/node/datagram_gate.hpp>
#include <jauscat/net/node/detail/default_answers.hpp>
#include <jauscat/net/node/detail/node_core.hpp>
#include <jauscat/net/node/detail/own_manager.hpp>
#include <jauscat/net/node/detail/presence_changes.hpp>
#include <jauscat/net/node/node_machine.hpp>

#include <array>
#include <exception>
#include <memory>
#include <stdexcept>
#include <utility>

namespace jauscat::net {

namespace detail {
// The form of a datagram's content without the framing.
inline jaus::datagram_form form_of(std::span<const std::byte> message, jaus::framing how) noexcept {
    if (how == jaus::framing::jaus01) return jaus::datagram_form::jaus01;
    if (how == jaus::framing::judp1) return jaus::datagram_form::judp1;
    return jaus::form_of(message);
}
// A message of the RA may begin with 2, too, so the form counts; it is not looked at for others.
inline bool is_sae(std::span<const std::byte> message, jaus::framing how) noexcept {
    return how == jaus::framing::bare && !message.empty() && message[0] == std::byte{2} &&
           jaus::form_of(message) == jaus::datagram_form::judp2;
}
} // namespace detail

inline namespace JAUSCAT_WAY {

struct node_machine::parts {
    parts(node_machine& node, send_handler send)
        : own_out{node}, log{node.options_.log, node.options_.log_limit}, core{node.options_, log, std::move(send)} {}

    struct component_output {
        node_machine& node;
        void operator()(bytes message) const noexcept { node.put(message, node.at_); }
    };

    component_output own_out;
    limited_log log;
    detail::node_core core; ///< its first component is the node manager
    detail::presence_changes changes{};
    std::optional<datagram_gate> gate{};
    detail::named_forms<jaus::datagram_form> named{};
    std::optional<detail::own_manager> manager{};
    std::exception_ptr thrown{}; ///< by a handler that was called while a component sent
};

JAUSCAT_DECL node_machine::node_machine(jaus_config config, jaus_node_options options, send_handler send,
                                        std::uint64_t seed)
    : config_{std::move(config)},
      options_{std::move(options)},
      self_{detail::manager_of(config_, options_.node)},
      seed_{seed},
      parts_{std::make_unique<parts>(*this, std::move(send))} {
    if (!has_manager()) return;
    make_manager({});
    parts_->core.components.add(parts_->manager->component());
}
JAUSCAT_DECL node_machine::~node_machine() = default;

JAUSCAT_DECL void node_machine::add(detail::attached_component component, detail::offered_messages messages) {
    const auto id = component.self;
    if (running() || in_turn()) throw std::logic_error{"components are added before the node is started"};
    if (id.subsystem != self_.subsystem || id.node != self_.node)
        throw std::invalid_argument{"the component " + to_jausip(id) + " is not one of the node " +
                                    std::to_string(self_.subsystem) + '.' + std::to_string(self_.node)};
    if (has_manager() && id == self_)
        throw std::invalid_argument{"the node has its node manager, " + to_jausip(id) + ", already"};
    auto answers = std::make_unique<detail::default_answers>(config_, component, std::move(messages));
    parts_->core.components.add(component, std::move(answers));
}

JAUSCAT_DECL void node_machine::remove(const jaus::address& self) {
    if (running() || in_turn()) throw std::logic_error{"components are taken away before the node is started"};
    if (!has_manager() || self != self_) parts_->core.components.remove(self);
}

JAUSCAT_DECL void node_machine::start(time_point now) {
    if (running() || in_turn()) throw std::logic_error{"the node is running"};
    at_ = now;
    parts_->gate.emplace(config_, options_.accept, seed_);
    parts_->core.start(config_, self_, options_.primary,
                       parts_->gate->list().is_open() ? std::optional{options_.timeout} : std::nullopt);
    if (has_manager()) {
        make_manager(parts_->core.components.addresses());
        parts_->core.components.replace(0, parts_->manager->component());
    }
    parts_->core.components.start(config_.me().limits.large_data_memory, present());
    parts_->core.large.start(now);
    running_ = true;
    wake(now);
}

JAUSCAT_DECL void node_machine::stop() {
    if (!running()) return;
    running_ = false;
    parts_->core.components.stop();
    const auto unsent = parts_->core.large.size();
    parts_->core.large.clear();
    parts_->changes.clear();
    parts_->thrown = nullptr;
    if (unsent != 0)
        parts_->log(at_, [&] { return std::to_string(unsent) + " large data sets were not sent to their end"; });
}
JAUSCAT_DECL bool node_machine::in_turn() const noexcept { return parts_->core.in_turn(); }
inline bool node_machine::has_manager() const noexcept { return detail::covers(config_.me().jausip, self_); }

JAUSCAT_DECL verdict node_machine::check(bytes message, const endpoint& from, jaus::framing how, time_point now) {
    at_ = now;
    if (detail::is_sae(message, how)) return check_sae(from, now);
    const auto what = (*parts_->gate)(message, from, now, how);
    if (what == verdict::accepted) return what;
    const auto form = detail::form_of(message, how);
    if (what == verdict::other_framing || form == jaus::datagram_form::judp1_compressed) {
        if (parts_->named.is_new(from.address(), form))
            parts_->log(now, [&] {
                return "a datagram from " + detail::text(from) + " is refused: " +
                       (what == verdict::other_framing ? std::string{describe(what)}
                                                       : "it is " + std::string{jaus::foreign_form(message)}) +
                       "; the next ones of this host are only counted";
            });
        return what;
    }
    parts_->log(now, [&] {
        const auto why = what != verdict::malformed
                             ? std::string{describe(what)}
                             : std::string{describe(what)} + ": " + std::string{describe(jaus::split(message).error)};
        return "a datagram from " + detail::text(from) + " is refused: " + why;
    });
    return what;
}

inline verdict node_machine::check_sae(const endpoint& from, time_point now) {
    if (!options_.on_sae_datagram) {
        if (parts_->named.is_new(from.address(), jaus::datagram_form::judp2))
            parts_->log(now, [&] {
                return "a datagram from " + detail::text(from) + " is refused: it is " +
                       std::string{describe(jaus::datagram_form::judp2)} +
                       ", which this node does not take: set the option on_sae_datagram"
                       " (docs/sae-transport.md); the next ones of this host are only counted";
            });
        return verdict::other_generation;
    }
    const auto what = parts_->gate->check_sae(from, now);
    if (what != verdict::accepted)
        parts_->log(now, [&] {
            return "a datagram of SAE JAUS from " + detail::text(from) + " is refused: " +
                   (what == verdict::unknown_peer ? "no system of the configuration has this host; give it as ip of one"
                                                  : std::string{describe(what)});
        });
    return what;
}

JAUSCAT_DECL void node_machine::received(bytes message, const endpoint& from, jaus::framing how, bool by_group,
                                         time_point now, duration waited) {
    if (!running()) return;
    at_ = now;
    if (detail::is_sae(message, how)) {
        if (options_.on_sae_datagram) options_.on_sae_datagram(message, from);
        return;
    }
    const auto m = jaus::split(message);
    if (!m)
        return parts_->log(now, [&] {
            const auto foreign = jaus::foreign_form(message);
            return "a datagram from " + detail::text(from) + " is dropped: " +
                   (foreign.empty() ? std::string{describe(m.error)} : "it is " + std::string{foreign});
        });
    const auto origin = parts_->core.routes().origin(m.header.source, from, how, by_group, parts_->gate->list(), now);
    const auto what = parts_->core.received(message, m, origin, {now, waited}, parts_->own_out);
    // Members of a group receive messages for others.
    const auto& to = m.header.destination;
    const bool is_for_others = by_group && to.subsystem != 255 && to.subsystem != self_.subsystem;
    if (!is_for_others) parts_->core.tell(m.header, what, now);
    end_turn();
}

JAUSCAT_DECL verdict node_machine::on_datagram(bytes message, const endpoint& from, jaus::framing how, bool by_group,
                                               time_point now, duration waited) {
    if (!running()) return verdict::accepted;
    const auto what = check(message, from, how, now);
    if (what == verdict::accepted) received(message, from, how, by_group, now, waited);
    return what;
}

JAUSCAT_DECL void node_machine::on_time(time_point now) {
    if (!running()) return;
    at_ = now;
    wake_at_.reset();
    const auto work = [&] {
        parts_->core.components.on_time(now, parts_->own_out);
        const auto done = [&](const jaus::header& head, jaus::delivered what) {
            if (what != jaus::delivered::acknowledged)
                parts_->log(now, [&] {
                    return detail::in_text(head) + ": a large data set is given up: " + std::string{describe(what)};
                });
            if (options_.large_data_done) options_.large_data_done(head, what);
        };
        if (running()) parts_->core.large.on_time(now, parts_->own_out, done);
    };
    parts_->core.turn(now, parts_->own_out, work);
    end_turn();
}

JAUSCAT_DECL std::optional<time_point> node_machine::next_event() {
    if (!running()) return std::nullopt;
    if (wake_at_) return wake_at_;
    time_point next = parts_->core.components.next_event().value_or(time_point::max());
    next = std::min(next, parts_->core.large.next_event().value_or(next));
    if (parts_->core.has_more()) next = at_;
    if (next == time_point::max()) return std::nullopt;
    return std::max(next, at_);
}

JAUSCAT_DECL result<void, error> node_machine::send(jaus::header head, bytes body, time_point now) {
    if (!running()) return error{.code = errc::not_running, .reason = {}, .message = "the node is not running"};
    head.data_flag = jaus::data_flag::only;
    const auto unroutable = [&head](jaus::routed outcome) {
        return error{.code = errc::unroutable,
                     .reason = reason_of(outcome),
                     .message = std::string{describe(outcome)} + ": " + to_jausip(head.destination)};
    };
    if (body.size() > jaus::max_body_size) {
        if (const auto to = parts_->core.route_of(head); to.outcome >= jaus::routed::no_such_component)
            return unroutable(to.outcome);
        const auto what = parts_->core.large.push(head, body);
        if (what != jaus::errc::ok)
            return error{.code = what == jaus::errc::no_space ? errc::queue_full : errc::invalid_message,
                         .reason = reason_of(what),
                         .message = "a large data set is not sent: " +
                                    std::string{what == jaus::errc::no_space ? "too many bytes wait to be sent"
                                                                             : describe(what)}};
        wake(now);
        return {};
    }
    std::array<std::byte, jaus::header_size + jaus::max_body_size> message{};
    const auto made = jaus::join(head, body, message);
    if (!made)
        return error{.code = errc::invalid_message,
                     .reason = reason_of(made.error()),
                     .message = std::string{describe(made.error())}};
    const auto what = parts_->core.send(*made, now);
    wake_after_sending(now);
    if (what.outcome >= jaus::routed::no_such_component) return unroutable(what.outcome);
    return {};
}

JAUSCAT_DECL void node_machine::put(bytes message, time_point now) noexcept {
    if (!running()) return;
    if (in_turn()) now = at_;
    try {
        parts_->core.send_or_tell(message, now);
    } catch (...) { // not through the component, whose functions are noexcept
        parts_->thrown = std::current_exception();
    }
    wake_after_sending(now);
}

JAUSCAT_DECL jaus::message_sink node_machine::out(time_point now) noexcept {
    if (!in_turn()) at_ = now;
    return parts_->own_out;
}

JAUSCAT_DECL void node_machine::lose(const jaus::address& who, time_point now) {
    if (!running() || has_manager()) return;
    parts_->core.components.on_lost(is_node_manager(who) ? jaus::address{255, 255, who.node, who.subsystem} : who);
    wake(now);
}

JAUSCAT_DECL void node_machine::log(std::string_view line, time_point now) {
    parts_->log(now, [&] { return std::string{line}; });
}

JAUSCAT_DECL const jaus::liveness_table* node_machine::present() const noexcept {
    return parts_->manager ? &parts_->manager->present() : nullptr;
}

inline void node_machine::make_manager(const std::vector<jaus::address>& components) {
    parts_->manager.emplace(config_, self_, components, options_, parts_->changes);
}

inline void node_machine::wake_after_sending(time_point now) noexcept {
    if (!in_turn()) wake(now);
}

inline void node_machine::end_turn() {
    if (parts_->thrown) std::rethrow_exception(std::exchange(parts_->thrown, nullptr));
    if (!running()) return;
    parts_->changes.take([this](const jaus::address& who, bool is_there) {
        parts_->manager->tell_change(who, at_, parts_->own_out);
        if (!is_there) parts_->core.components.on_lost(parts_->manager->gone_with(who));
        const auto& hear = is_there ? options_.appeared : options_.disappeared;
        if (running() && hear) hear(who);
    });
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::net
