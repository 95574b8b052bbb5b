// A JAUS node as a state machine: gate, router, large data sets, node manager and the user's components, without
// sockets.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/net/error.hpp>
#include <jauscat/net/limited_log.hpp>
#include <jauscat/net/node/datagram_gate.hpp>
#include <jauscat/net/node/detail/node_core.hpp>
#include <jauscat/net/node/detail/own_manager.hpp>
#include <jauscat/net/node/detail/presence_changes.hpp>
#include <jauscat/net/node/node_component.hpp>

#include <exception>
#include <stdexcept>
#include <utility>

namespace jauscat::net {

/// The part of jaus_node between its sockets and its timer: datagrams and time in, datagrams out. It reads no clock,
/// opens no socket and starts no thread, so that it also runs in simulated time. The times must be of one monotonic
/// clock.
///
///     net::node_machine node{config, {.log = log}, [&](auto message, const auto& to, auto framing) { ... }, seed};
///     node.add(arm, arm_messages); // a jaus::component and a dispatcher for its own messages
///     node.start(now);
///     node.on_datagram(message, from, framing, by_group, now);
///     if (node.next_event() <= now) node.on_time(now);
///
/// Call next_event() again after every other call. Components must outlive it. An exception of a component, a handler
/// or `send` leaves the call that caused it, or the next one; then stop it, and start it again.
class node_machine {
  public:
    /// A message, or its body.
    using bytes = std::span<const std::byte>;
    using endpoint = access_list::endpoint;
    /// Sends a message to a peer or to the multicast group with the given framing. The bytes are valid during the call.
    using send_handler = detail::node_core::send_handler;

    /// `seed` is a random number. `options.socket` is ignored. Throws `config_error` if this system's jausip has no
    /// subsystem.
    node_machine(jaus_config config, jaus_node_options options, send_handler send, std::uint64_t seed)
        : config_{std::move(config)},
          options_{std::move(options)},
          self_{detail::manager_of(config_, options_.node)},
          seed_{seed},
          log_{options_.log, options_.log_limit},
          core_{options_, log_, std::move(send)} {
        if (!has_manager()) return;
        make_manager({});
        core_.components.add({manager_->core, *manager_});
    }
    node_machine(const node_machine&) = delete;
    node_machine& operator=(const node_machine&) = delete;

    /// Adds a component and its application: see node_component and jaus::component_application. Call before start.
    /// Throws `std::invalid_argument` for a component of another node and for a second node manager.
    template <class Component, class Application> void add(Component& component, Application& application) {
        require_component<Component>();
        require_application<Application>();
        const auto& id = component.self();
        if (running() || in_turn()) throw std::logic_error{"components are added before the node is started"};
        if (id.subsystem != self_.subsystem || id.node != self_.node)
            throw std::invalid_argument{"the component " + to_jausip(id) + " is not one of the node " +
                                        std::to_string(self_.subsystem) + '.' + std::to_string(self_.node)};
        if (has_manager() && id == self_)
            throw std::invalid_argument{"the node has its node manager, " + to_jausip(id) + ", already"};
        core_.components.add(
            {component, application,
             std::make_shared<detail::default_answers>(config_, id, detail::offered_messages{component, application})});
    }

    /// A start after `stop` begins without known peers. Must not be called from a handler of this node. Throws
    /// `config_error`.
    void start(time_point now) {
        if (running() || in_turn()) throw std::logic_error{"the node is running"};
        at_ = now;
        gate_.emplace(config_, options_.accept, seed_);
        core_.start(config_, self_, options_.primary,
                    gate_->list().is_open() ? std::optional{options_.timeout} : std::nullopt);
        if (has_manager()) {
            make_manager(core_.components.addresses());
            core_.components.replace(0, {manager_->core, *manager_});
        }
        core_.components.start(config_.me().limits.large_data_memory, present());
        core_.large.start(now);
        running_ = true;
        wake(now);
    }

    /// Queued messages are dropped and logged. No handler is called afterwards. May be called from a handler.
    void stop() {
        if (!running()) return;
        running_ = false;
        core_.components.stop();
        const auto unsent = core_.large.size();
        core_.large.clear();
        changes_.clear();
        thrown_ = nullptr;
        wake_at_.reset();
        if (unsent != 0)
            log_(at_, [&] { return std::to_string(unsent) + " large data sets were not sent to their end"; });
    }
    /// Between start and stop.
    [[nodiscard]] bool running() const noexcept { return running_; }
    /// Whether a handler or a component may be active: within a call of received, on_datagram or on_time.
    [[nodiscard]] bool in_turn() const noexcept { return core_.in_turn(); }

    /// The gate's decision on a datagram's content without the framing. Pass accepted messages to `received`.
    verdict check(bytes message, const endpoint& from, time_point now) {
        at_ = now;
        const auto what = (*gate_)(message, from, now);
        if (what != verdict::accepted)
            log_(now, [&] {
                return "a datagram from " + detail::text(from) + " is refused: " + std::string{describe(what)} +
                       (what == verdict::malformed ? ": " + std::string{describe(jaus::split(message).error)} : "");
            });
        return what;
    }
    /// Processes a message that has passed `check`. `by_group`: it was sent to the multicast group. `waited`: time in
    /// the socket before this call, if known; it separates a packet of an old large data set from those of the next.
    void received(bytes message, const endpoint& from, jaus::framing how, bool by_group, time_point now,
                  duration waited = {}) {
        if (!running()) return;
        at_ = now;
        const auto m = jaus::split(message);
        if (!m)
            return log_(now, [&] {
                return "a datagram from " + detail::text(from) + " is dropped: " + std::string{describe(m.error)};
            });
        const auto origin = core_.routes().origin(m.header.source, from, how, by_group, gate_->list(), now);
        const auto what = core_.received(message, m, origin, {now, waited}, own_out_);
        // Members of a group receive messages for others.
        const auto& to = m.header.destination;
        const bool is_for_others = by_group && to.subsystem != 255 && to.subsystem != self_.subsystem;
        if (!is_for_others) core_.tell(m.header, what, now);
        end_turn();
    }
    /// `check` and `received` for a datagram without framing. Not for datagrams that this node has sent to the group.
    verdict on_datagram(bytes message, const endpoint& from, jaus::framing how, bool by_group, time_point now,
                        duration waited = {}) {
        if (!running()) return verdict::accepted;
        const auto what = check(message, from, now);
        if (what == verdict::accepted) received(message, from, how, by_group, now, waited);
        return what;
    }

    /// Does what is due at `now`. A call before next_event has no effect.
    void on_time(time_point now) {
        if (!running()) return;
        at_ = now;
        wake_at_.reset();
        core_.turn(now, own_out_, [&] {
            core_.components.on_time(now, own_out_);
            if (running()) core_.large.on_time(now, own_out_, options_.large_data_done);
        });
        end_turn();
    }
    /// When on_time is due, unless another call comes before. Not within a turn.
    [[nodiscard]] std::optional<time_point> next_event() {
        if (!running()) return std::nullopt;
        if (wake_at_) return wake_at_;
        time_point next = core_.components.next_event().value_or(time_point::max());
        next = std::min(next, core_.large.next_event().value_or(next));
        if (core_.has_more()) next = at_;
        if (next == time_point::max()) return std::nullopt;
        return std::max(next, at_);
    }

    /// Sends a message of a component of this node. A body of more than 4080 bytes is sent as a large data set, paced;
    /// if `ack_nak` requests acknowledgement, its packets are repeated until they are acknowledged. `data_size` and
    /// `data_flag` of `head` are ignored, for a large data set also `sequence_number`.
    result<void, error> send(jaus::header head, bytes body, time_point now) {
        if (!running()) return error{.code = errc::not_running, .reason = {}, .message = "the node is not running"};
        head.data_flag = jaus::data_flag::only;
        if (body.size() > jaus::max_body_size) {
            const auto what = core_.large.push(head, body);
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
        const auto what = core_.send(*made, now);
        wake_after_sending(now);
        if (what.outcome >= jaus::routed::no_such_component)
            return error{.code = errc::unroutable,
                         .reason = reason_of(what.outcome),
                         .message = std::string{describe(what.outcome)} + ": " + to_jausip(head.destination)};
        return {};
    }
    /// The same for a typed body. A value that does not encode gives errc::not_encodable, not an exception.
    template <jaus::coded_message T> result<void, error> send(jaus::header head, const T& body, time_point now) {
        std::array<std::byte, jaus::max_body_size> packet{};
        std::vector<std::byte> larger{};
        if (wire::encoded_size(body) > packet.size()) larger.resize(wire::encoded_size(body));
        const std::span<std::byte> encoded = larger.empty() ? std::span<std::byte>{packet} : larger;
        const auto written = wire::encode(body, encoded);
        if (!written)
            return error{.code = errc::not_encodable,
                         .reason = reason_of(written.error()),
                         .message = std::string{wire::describe(written.error())}};
        head.command_code = jaus::command_code_of<T>;
        return send(head, *written, now);
    }
    template <jaus::uncoded_type T>
    requires(!std::convertible_to<const T&, bytes>)
    result<void, error> send(const jaus::header&, const T&, time_point) {
        jaus::refuse_uncoded_type<T>();
        return {};
    }
    /// Sends a whole message of a component, of at most 4096 bytes; an unroutable one is logged.
    void put(bytes message, time_point now) noexcept {
        if (!running()) return;
        if (in_turn()) now = at_;
        try {
            core_.send_or_tell(message, now);
        } catch (...) { // not through the component, whose functions are noexcept
            thrown_ = std::current_exception();
        }
        wake_after_sending(now);
    }
    /// Sink for messages that components send on behalf of the application, until the next call with a time.
    [[nodiscard]] jaus::message_sink out(time_point now) noexcept {
        if (!in_turn()) at_ = now;
        return own_out_;
    }
    /// Call after changing a component without sending: its next event may be earlier.
    void wake(time_point now) noexcept {
        if (running()) wake_at_ = now;
    }
    /// Logs a line, such as an error of its sockets.
    void log(std::string_view line, time_point now) {
        log_(now, [&] { return std::string{line}; });
    }

    /// The node manager's address, also if it is in another program.
    [[nodiscard]] const jaus::address& manager() const noexcept { return self_; }
    /// The components alive, as the node manager has them; nullptr without a node manager or before the first start.
    [[nodiscard]] const jaus::liveness_table* present() const noexcept {
        return manager_ ? &manager_->present() : nullptr;
    }
    [[nodiscard]] const jaus_config& config() const noexcept { return config_; }
    [[nodiscard]] const jaus_node_options& options() const noexcept { return options_; }

  private:
    [[nodiscard]] bool has_manager() const noexcept { return detail::covers(config_.me().jausip, self_); }
    void make_manager(const std::vector<jaus::address>& components) {
        manager_.emplace(config_, self_, components, options_, changes_);
    }
    // Outside of a turn: a local component may have a message, or a message may have to be repeated.
    void wake_after_sending(time_point now) noexcept {
        if (!in_turn()) wake(now);
    }
    void end_turn() {
        if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
        if (!running()) return;
        changes_.take([this](const jaus::address& who, bool is_there) {
            manager_->tell_change(who, at_, own_out_);
            if (!is_there) core_.components.on_lost(manager_->gone_with(who));
            const auto& hear = is_there ? options_.appeared : options_.disappeared;
            if (running() && hear) hear(who);
        });
    }

    struct component_output {
        node_machine& node;
        void operator()(bytes message) const noexcept { node.put(message, node.at_); }
    };

    jaus_config config_;
    jaus_node_options options_;
    jaus::address self_; ///< of the node manager
    std::uint64_t seed_;
    limited_log log_;
    detail::node_core core_; ///< its first component is the node manager
    component_output own_out_{*this};
    detail::presence_changes changes_{};
    std::optional<datagram_gate> gate_{};
    std::optional<detail::own_manager> manager_{};
    bool running_{};
    std::exception_ptr thrown_{};         ///< by a handler that was called while a component sent
    std::optional<time_point> wake_at_{}; ///< after a call outside of a turn
    time_point at_{};                     ///< time of the last call
};

} // namespace jauscat::net
