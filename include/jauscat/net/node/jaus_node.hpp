// A JAUS node on a UDP socket: node_machine with sockets, a timer and the steady clock.
#pragma once

#include <jauscat/net/detail/wake_timer.hpp>
#include <jauscat/net/node/detail/node_socket.hpp>
#include <jauscat/net/node/node_machine.hpp>

#include <random>
#include <utility>

namespace jauscat::net {

/// One node of this system of a configuration, or a few components of one. Its node is the one that the system's jausip
/// names, or 1; it has the node manager (component 1, instance 1) if the jausip covers that.
///
/// Messages go by the systems of the configuration, to each with its framing; what comes is taken only from where the
/// configuration says, put together if it is a large data set, and handed to the components or forwarded. Components
/// are driven when they want to be. Messages between them are handed on when the sender is done. Unroutable, refused
/// and timed-out messages are logged. docs/jaus-node.md is the manual.
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
    using time = node_machine::time;
    /// A message, or its body.
    using bytes = node_machine::bytes;
    using endpoint = node_machine::endpoint;

    /// Throws `config_error` if this system's jausip has no subsystem.
    jaus_node(boost::asio::io_context& context, jaus_config config, jaus_node_options options = {})
        : context_{context},
          machine_{
              std::move(config), std::move(options),
              [this](bytes message, const endpoint& to, jaus::framing framing) { socket_->post(message, to, framing); },
              std::random_device{}()},
          timer_{context, [this] {
                     machine_.on_time(now());
                     arm();
                 }} {}
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
        machine_.add(component, application);
    }

    /// Opens the sockets and begins, after `stop` from the start: who was there is forgotten. Not from within a
    /// handler of this node. Throws `open_error` and `config_error`.
    void start() {
        machine_.start(now());
        try {
            socket_.emplace(context_, config(), machine_.options().socket);
        } catch (...) {
            machine_.stop();
            throw;
        }
        socket_->start([this](bytes message, const endpoint& from) { return check(message, from); },
                       [this](bytes message, const auto&... from) { received(message, from...); },
                       [this](std::string_view problem) { machine_.log(problem, now()); });
        arm();
    }

    /// What was sent goes out; what waits inside does not, and is logged. No handler is called afterwards. May be
    /// called from a handler.
    void stop() {
        if (!running()) return;
        timer_.cancel();
        try {
            machine_.stop();
        } catch (...) { // of the log
            socket_->stop();
            throw;
        }
        socket_->stop();
    }
    /// Whether it was started and not stopped.
    [[nodiscard]] bool running() const noexcept { return machine_.running(); }

    /// Sends a message of a component of this node; one of more than 4080 bytes of body as a large data set, bit by
    /// bit; where `ack_nak` asks for acknowledgement its packets are repeated until they have it. Of `head` all counts
    /// but `data_size` and `data_flag`, and for a large data set `sequence_number`.
    outcome send(const jaus::header& head, bytes body) {
        auto what = machine_.send(head, body, now());
        arm();
        return what;
    }
    /// The same for a typed body. Throws nothing; a value that does not encode is a problem of the outcome.
    template <jaus::coded_message T> outcome send(const jaus::header& head, const T& body) {
        auto what = machine_.send(head, body, now());
        arm();
        return what;
    }
    /// Where components put their messages when the application makes them send. Whole messages of at most 4096 bytes;
    /// what is unroutable is logged.
    [[nodiscard]] jaus::message_sink out() noexcept { return out_; }
    /// Call after changing a component without sending: its next event may be earlier.
    void wake() {
        machine_.wake(now());
        arm();
    }

    /// The time that components get: that of the steady clock.
    [[nodiscard]] static time now() noexcept { return std::chrono::steady_clock::now().time_since_epoch(); }
    /// The node manager's address, also where another program has it.
    [[nodiscard]] const jaus::address& manager() const noexcept { return machine_.manager(); }
    /// The components alive at the node manager; nullptr without a node manager or before the first start.
    [[nodiscard]] const jaus::liveness_table* present() const noexcept { return machine_.present(); }
    [[nodiscard]] const jaus_config& config() const noexcept { return machine_.config(); }
    /// Of the socket and the group's together, since the last start.
    [[nodiscard]] udp_counters counts() const noexcept { return socket_ ? socket_->counts() : udp_counters{}; }

  private:
    verdict check(bytes message, const endpoint& from) {
        if (socket_->is_own(from)) return verdict::taken; // the echo of a multicast; ends in received()
        received_at_ = now();
        return machine_.check(message, from, received_at_);
    }
    void received(bytes message, const endpoint& from, jaus::framing how, bool by_group, time waited) {
        if (socket_->is_own(from)) return;
        machine_.received(message, from, how, by_group, received_at_, waited);
        arm();
    }
    // Within a turn what ends the turn arms the timer.
    void arm() {
        if (machine_.in_turn()) return;
        if (const auto next = machine_.next_event()) timer_.arm(*next);
    }

    struct component_output {
        jaus_node& node;
        void operator()(bytes message) const {
            const bool in_turn = node.machine_.in_turn();
            node.machine_.put(message, in_turn ? node.received_at_ : now()); // within a turn its own time counts
            if (!in_turn) node.arm();
        }
    };

    boost::asio::io_context& context_;
    node_machine machine_;
    detail::wake_timer timer_;
    component_output out_{*this};
    std::optional<detail::node_socket> socket_{};
    time received_at_{}; ///< a look at the clock costs as much as a component's work
};

} // namespace jauscat::net
