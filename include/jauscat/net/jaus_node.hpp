// A JAUS node on a UDP socket: transport, gate, router, large data sets, node manager and the user's components.
#pragma once

#include <jauscat/net/datagram_gate.hpp>
#include <jauscat/net/detail/node_core.hpp>
#include <jauscat/net/detail/node_socket.hpp>
#include <jauscat/net/detail/own_manager.hpp>
#include <jauscat/net/detail/presence_changes.hpp>
#include <jauscat/net/detail/wake_timer.hpp>
#include <jauscat/net/limited_log.hpp>

#include <exception>
#include <stdexcept>
#include <utility>

namespace jauscat::net {

/// One node of this system of a configuration, or a few components of one. Its node is the one that the system's jausip
/// names, or 1; it has the node manager (component 1, instance 1) if the jausip covers that.
///
/// Messages go by the systems of the configuration, to each with its framing; what comes is taken only from where the
/// configuration says, put together if it is a large data set, and handed to the components or forwarded. Components
/// are driven when they want to be. Messages between them are handed on when the sender is done. Nothing is lost
/// silently: what is unroutable, refused or given up is told to the log. docs/jaus-node.md is the manual.
///
///     net::jaus_node node{context, config, {.log = log}};
///     node.add(arm, arm_messages); // a jaus::component and a dispatcher for its own messages
///     node.start();
///     context.run();
///
/// Use it from the thread that runs the io_context. It must outlive the handlers that call it; components must outlive
/// it. An exception that a component or a handler throws leaves `run`; then stop the node, and start it again.
class jaus_node {
  public:
    using time = std::chrono::nanoseconds;
    /// A message, or its body.
    using bytes = std::span<const std::byte>;
    using endpoint = detail::node_socket::endpoint;

    /// Throws `config_error` if this system's jausip has no subsystem.
    jaus_node(boost::asio::io_context& context, jaus_config config, jaus_node_options options = {})
        : context_{context},
          config_{std::move(config)},
          options_{std::move(options)},
          self_{detail::manager_of(config_, options_.node)},
          log_{options_.log, options_.log_limit},
          core_{options_, log_, [this](bytes message, const auto& to) { socket_->post(message, to.to, to.framing); }},
          timer_{context, [this] { on_time(); }} {
        if (!has_manager()) return;
        make_manager({});
        core_.components.add({manager_->core, *manager_});
    }
    ~jaus_node() {
        try {
            stop();
        } catch (...) { // a log that throws is not worth more than the sockets that go anyway
        }
    }
    jaus_node(const jaus_node&) = delete;
    jaus_node& operator=(const jaus_node&) = delete;

    /// A component of this node, and what takes its own messages, such as a dispatcher; see component::on_message.
    /// Before start. Throws `std::invalid_argument` for a component of another node and for a second node manager.
    template <class Component, class Application> void add(Component& component, Application& application) {
        const auto& id = component.self();
        if (running() || core_.in_turn()) throw std::logic_error{"components are added before the node is started"};
        if (id.subsystem != self_.subsystem || id.node != self_.node)
            throw std::invalid_argument{"the component " + to_jausip(id) + " is not one of the node " +
                                        std::to_string(self_.subsystem) + '.' + std::to_string(self_.node)};
        if (has_manager() && id == self_)
            throw std::invalid_argument{"the node has its node manager, " + to_jausip(id) + ", already"};
        core_.components.add({component, application, std::make_shared<detail::default_answers>(config_, id)});
    }

    /// Opens the sockets and begins, after `stop` from the start: who was there is forgotten. Not from within a
    /// handler of this node. Throws `open_error` and `config_error`.
    void start() {
        if (running() || core_.in_turn()) throw std::logic_error{"the node is running"};
        gate_.emplace(config_, options_.who);
        core_.start(config_, self_, options_.primary,
                    gate_->list().is_open() ? std::optional{options_.patience} : std::nullopt);
        if (has_manager()) {
            make_manager(core_.components.addresses());
            core_.components.replace(0, {manager_->core, *manager_});
        }
        core_.components.start(config_.me().limits.large_data_memory, has_manager());
        socket_.emplace(context_, config_, options_.socket);
        running_ = true;
        socket_->start([this](bytes message, const endpoint& from) { return check(message, from); },
                       [this](bytes message, const auto&... from) { received(message, from...); },
                       [this](std::string_view problem) { log([&] { return std::string{problem}; }); });
        arm(now());
    }

    /// What was sent goes out; what waits inside does not, and is logged. No handler is called afterwards. May be
    /// called from a handler.
    void stop() {
        if (!running()) return;
        running_ = false;
        core_.components.stop();
        timer_.cancel();
        socket_->stop();
        if (core_.large.size() != 0)
            log([&] { return std::to_string(core_.large.size()) + " large data sets were not sent to their end"; });
        core_.large.clear();
        changes_.clear();
        thrown_ = nullptr;
    }
    /// Whether it was started and not stopped.
    [[nodiscard]] bool running() const noexcept { return running_; }

    /// Sends a message of a component of this node; one of more than 4080 bytes of body as a large data set, bit by
    /// bit; where `ack_nak` asks for acknowledgement its packets are repeated until they have it. Of `head` all counts
    /// but `data_size` and `data_flag`, and for a large data set `sequence_number`.
    outcome send(jaus::header head, bytes body) {
        if (!running()) return outcome{"the node is not running"};
        head.data_flag = jaus::data_flag::only;
        if (body.size() > jaus::max_body_size) {
            const auto what = core_.large.push(head, body);
            if (what != jaus::errc::ok)
                return outcome{"a large data set is not sent: " + std::string{what == jaus::errc::no_space
                                                                                  ? "too many bytes wait to be sent"
                                                                                  : describe(what)}};
            arm(now());
            return {};
        }
        std::array<std::byte, jaus::header_size + jaus::max_body_size> message{};
        const auto size = jaus::join(head, body, message);
        if (!size) return outcome{std::string{describe(size.error())}};
        const auto what = core_.send(bytes{message}.first(size.size()), now());
        wake_after_sending();
        if (what.outcome >= jaus::routed::no_such_component)
            return outcome{std::string{describe(what.outcome)} + ": " + to_jausip(head.destination)};
        return {};
    }
    /// The same for a typed body. Throws nothing; a value that does not encode is a problem of the outcome.
    template <jaus::coded_message T> outcome send(jaus::header head, const T& body) {
        std::array<std::byte, wire::max_size<T>> encoded{};
        const auto size = wire::encode(body, encoded);
        if (!size) return outcome{std::string{wire::describe(size.error())}};
        head.command_code = jaus::command_code_of<T>;
        return send(head, bytes{encoded}.first(size.size()));
    }
    /// Where components put their messages when the application makes them send. Whole messages of at most 4096 bytes;
    /// what is unroutable is logged.
    [[nodiscard]] jaus::message_sink out() noexcept { return out_; }
    /// To be called when a component was changed so that it wants to be driven earlier, and has sent nothing.
    void wake() { arm(now()); }

    /// The time that components get: that of the steady clock.
    [[nodiscard]] static time now() noexcept { return std::chrono::steady_clock::now().time_since_epoch(); }
    /// The node manager's address, also where another program has it.
    [[nodiscard]] const jaus::address& manager() const noexcept { return self_; }
    /// Whom the node manager hears, or nullptr where this program has none or was never started.
    [[nodiscard]] const jaus::presence_table* present() const noexcept {
        return manager_ ? &manager_->present() : nullptr;
    }
    /// What it was made with.
    [[nodiscard]] const jaus_config& config() const noexcept { return config_; }
    /// Of the socket and the group's together, since the last start.
    [[nodiscard]] udp_counters counts() const noexcept { return socket_ ? socket_->counts() : udp_counters{}; }

  private:
    [[nodiscard]] bool has_manager() const noexcept { return detail::covers(config_.me().jausip, self_); }
    void make_manager(const std::vector<jaus::address>& components) {
        manager_.emplace(config_, self_, components, options_, changes_);
    }
    void log(auto&& text) { log_(now(), text); }

    verdict check(bytes message, const endpoint& from) {
        if (socket_->is_own(from)) return verdict::taken; // the echo of a multicast; ends in received()
        at_ = now();
        const auto what = (*gate_)(message, from, at_);
        if (what != verdict::taken)
            log([&] {
                return "a datagram from " + detail::text(from) + " is refused: " + std::string{describe(what)};
            });
        return what;
    }
    void received(bytes message, const endpoint& from, jaus::framing how, bool by_group) {
        if (socket_->is_own(from)) return;
        const auto m = jaus::split(message);
        if (!m)
            return log([&] {
                return "a datagram from " + detail::text(from) + " is dropped: " + std::string{describe(m.error)};
            });
        const auto origin = core_.routes().origin(m.header.source, from, how, by_group, gate_->list(), at_);
        const auto what = core_.received(message, m, origin, at_, out_);
        // Members of a group hear what is for others.
        const auto& to = m.header.destination;
        const bool is_for_others = by_group && to.subsystem != 255 && to.subsystem != self_.subsystem;
        if (!is_for_others) core_.tell(m.header, what, at_);
        end_turn();
    }
    void send_for_component(bytes message) {
        if (!running()) return;
        try {
            core_.send_or_tell(message, core_.in_turn() ? at_ : now());
        } catch (...) { // not through the component, whose functions are noexcept
            thrown_ = std::current_exception();
        }
        wake_after_sending();
    }
    // Outside of a turn: there may be something for a component here, or to be repeated.
    void wake_after_sending() {
        if (!core_.in_turn()) arm(now());
    }
    void on_time() {
        at_ = now();
        core_.turn(at_, out_, [&] {
            core_.components.on_time(at_, out_);
            if (running()) core_.large.on_time(at_, out_, options_.large_data_done);
        });
        end_turn();
    }
    void end_turn() {
        if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
        if (running())
            changes_.take([this](const jaus::address& who, bool is_there) {
                manager_->tell_change(who, now(), out_);
                if (!is_there) core_.components.on_lost(manager_->gone_with(who));
                const auto& hear = is_there ? options_.appeared : options_.disappeared;
                if (running() && hear) hear(who);
            });
        if (running()) arm_for_next();
    }
    void arm_for_next() {
        time next = core_.components.next_event().value_or(time::max());
        next = std::min(next, core_.large.next_event().value_or(next));
        if (core_.has_more()) next = at_;
        if (next != time::max()) arm(std::max(next, at_));
    }
    void arm(time at) {
        if (running()) timer_.arm(at);
    }

    struct component_output {
        jaus_node& node;
        void operator()(bytes message) const { node.send_for_component(message); }
    };

    boost::asio::io_context& context_;
    jaus_config config_;
    jaus_node_options options_;
    jaus::address self_; ///< of the node manager
    limited_log log_;
    detail::node_core core_; ///< of its components the node manager is the first
    detail::wake_timer timer_;
    component_output out_{*this};
    detail::presence_changes changes_{};
    std::optional<datagram_gate> gate_{};
    std::optional<detail::own_manager> manager_{};
    std::optional<detail::node_socket> socket_{};
    bool running_{};
    std::exception_ptr thrown_{}; ///< by a handler that was called while a component sent
    time at_{};                   ///< of the turn: a look at the clock costs as much as a component's work
};

} // namespace jauscat::net
