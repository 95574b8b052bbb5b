// A JAUS node on a UDP socket: node_machine with sockets, a timer and the steady clock.
#pragma once

#include <jauscat/net/detail/wake_timer.hpp>
#include <jauscat/net/node/detail/node_socket.hpp>
#include <jauscat/net/node/node_machine.hpp>
#include <jauscat/net/now.hpp>

#include <random>
#include <utility>

namespace jauscat::net {

/// One node of the configuration's own system, or some components of a node. Its node ID is that of the system's
/// jausip, or 1; it has the node manager (component 1, instance 1) if the jausip covers that.
///
/// Messages are sent to the systems of the configuration, each with its framing. Received messages are accepted only
/// from the configured addresses, reassembled if they are large data sets, and delivered to the components or
/// forwarded. Messages between local components are delivered when the sender has returned. Unroutable, refused and
/// timed-out messages are logged. docs/jaus-node.md is the manual.
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
        } catch (...) { // of the log; the sockets are closed in any case
        }
    }
    jaus_node(const jaus_node&) = delete;
    jaus_node& operator=(const jaus_node&) = delete;

    /// Adds a component and its application: see node_component and jaus::component_application. Call before start.
    /// Throws `std::invalid_argument` for a component of another node and for a second node manager.
    template <class Component, class Application> void add(Component& component, Application& application) {
        machine_.add(component, application);
    }

    /// Opens the sockets and starts. A start after `stop` begins without known peers. Must not be called from a handler
    /// of this node. Throws `open_error` and `config_error`.
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

    /// Sent messages go out; queued ones are dropped and logged. No handler is called afterwards. May be called from a
    /// handler.
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
    /// Between start and stop.
    [[nodiscard]] bool running() const noexcept { return machine_.running(); }

    /// Sends a message of a component of this node. A body of more than 4080 bytes is sent as a large data set, paced;
    /// if `ack_nak` requests acknowledgement, its packets are repeated until they are acknowledged. `data_size` and
    /// `data_flag` of `head` are ignored, for a large data set also `sequence_number`.
    result<void, error> send(const jaus::header& head, bytes body) {
        auto what = machine_.send(head, body, now());
        arm();
        return what;
    }
    /// The same for a typed body. A value that does not encode gives errc::not_encodable, not an exception.
    template <jaus::coded_message T> result<void, error> send(const jaus::header& head, const T& body) {
        auto what = machine_.send(head, body, now());
        arm();
        return what;
    }
    template <jaus::uncoded_type T>
    requires(!std::convertible_to<const T&, bytes>)
    result<void, error> send(const jaus::header&, const T&) {
        jaus::refuse_uncoded_type<T>();
        return {};
    }
    /// Sink for messages that components send on behalf of the application. Whole messages of at most 4096 bytes;
    /// unroutable ones are logged.
    [[nodiscard]] jaus::message_sink out() noexcept { return out_; }
    /// Call after changing a component without sending: its next event may be earlier.
    void wake() {
        machine_.wake(now());
        arm();
    }

    /// The time of the steady clock, as components get it.
    [[nodiscard]] static time_point now() noexcept { return net::now(); }
    /// The node manager's address, also if it is in another program.
    [[nodiscard]] const jaus::address& manager() const noexcept { return machine_.manager(); }
    /// The components alive, as the node manager has them; nullptr without a node manager or before the first start.
    [[nodiscard]] const jaus::liveness_table* present() const noexcept { return machine_.present(); }
    [[nodiscard]] const jaus_config& config() const noexcept { return machine_.config(); }
    /// Sum of both sockets, since the last start.
    [[nodiscard]] udp_counters counts() const noexcept { return socket_ ? socket_->counts() : udp_counters{}; }

  private:
    verdict check(bytes message, const endpoint& from) {
        if (socket_->is_own(from)) return verdict::accepted; // the echo of a multicast; ends in received()
        received_at_ = now();
        return machine_.check(message, from, received_at_);
    }
    void received(bytes message, const endpoint& from, jaus::framing how, bool by_group, duration waited) {
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
            node.machine_.put(message, in_turn ? node.received_at_ : now()); // within a turn its time is used
            if (!in_turn) node.arm();
        }
    };

    boost::asio::io_context& context_;
    node_machine machine_;
    detail::wake_timer timer_;
    component_output out_{*this};
    std::optional<detail::node_socket> socket_{};
    time_point received_at_{}; ///< reading the clock costs as much as a component's work
};

} // namespace jauscat::net
