// A JAUS node on a UDP socket: node_machine with sockets, a timer and the steady clock.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/net/config/udp_options.hpp>
#include <jauscat/net/link/udp_counters.hpp>
#include <jauscat/net/node/node_machine.hpp>
#include <jauscat/net/now.hpp>

#include <boost/asio/io_context.hpp>

#include <memory>
#include <optional>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

/// One node of the configuration's own system, or some components of a node. Its node ID is that of the system's
/// jausip, or 1; it has the node manager (component 1, instance 1) if the jausip covers that.
///
/// Messages are sent to the systems of the configuration, each with its framing. Received messages are accepted only
/// from the configured addresses, reassembled if they are large data sets, and delivered to the components or
/// forwarded. Messages between local components are delivered when the sender has returned. Unroutable, refused and
/// timed-out messages are logged. docs/machinery-node.md is the manual.
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
    JAUSCAT_DECL jaus_node(boost::asio::io_context& context, jaus_config config, jaus_node_options options = {});
    JAUSCAT_DECL ~jaus_node();
    jaus_node(const jaus_node&) = delete;
    jaus_node& operator=(const jaus_node&) = delete;

    /// Adds a component and its application: see node_component and jaus::component_application. Call before start.
    /// Throws `std::invalid_argument` for a component of another node and for a second node manager.
    template <class Component, class Application> void add(Component& component, Application& application) {
        machine_.add(component, application);
    }

    /// See node_machine::remove.
    void remove(const jaus::address& self) { machine_.remove(self); }

    /// Opens the sockets and starts. A start after `stop` begins without known peers. Must not be called from a handler
    /// of this node. Throws `open_error` and `config_error`.
    JAUSCAT_DECL void start();
    /// Sent messages go out; queued ones are dropped and logged. No handler is called afterwards. May be called from a
    /// handler.
    JAUSCAT_DECL void stop();
    /// Between start and stop.
    [[nodiscard]] bool running() const noexcept { return machine_.running(); }
    /// See node_machine::in_turn.
    [[nodiscard]] bool in_turn() const noexcept { return machine_.in_turn(); }

    /// Sends a message of a component of this node. A body of more than 4080 bytes is sent as a large data set, paced;
    /// if `ack_nak` requests acknowledgement, its packets are repeated until they are acknowledged. `data_size` and
    /// `data_flag` of `head` are ignored. The `sequence_number` of a large data set is not sent: it is what
    /// `large_data_done` returns, for the sender to know which one has ended.
    JAUSCAT_DECL result<void, error> send(const jaus::header& head, bytes body);
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
    /// Sends a datagram of another form, such as SAE JAUS, from the node's port. Errors: not_running, and those of
    /// udp_transport::send.
    JAUSCAT_DECL result<void, error> send_datagram(bytes datagram, const endpoint& to);
    /// Sink for messages that components send on behalf of the application. Whole messages of at most 4096 bytes;
    /// unroutable ones are logged.
    [[nodiscard]] jaus::message_sink out() noexcept { return out_; }
    /// Call after changing a component without sending: its next event may be earlier.
    JAUSCAT_DECL void wake();

    /// The node manager of another node has lost a component. Ignored by a node that has a node manager.
    JAUSCAT_DECL void lose(const jaus::address& who);

    /// The time of the steady clock, as components get it.
    [[nodiscard]] static time_point now() noexcept { return net::now(); }
    /// The node manager's address, also if it is in another program.
    [[nodiscard]] const jaus::address& manager() const noexcept { return machine_.manager(); }
    /// The components alive, as the node manager has them; nullptr without a node manager or before the first start.
    [[nodiscard]] const jaus::liveness_table* present() const noexcept { return machine_.present(); }
    [[nodiscard]] const jaus_config& config() const noexcept { return machine_.config(); }
    /// Sum of all its sockets, since the last start.
    [[nodiscard]] JAUSCAT_DECL udp_counters counts() const noexcept;

  private:
    struct parts; ///< sockets and timer
    struct component_output {
        jaus_node& node;
        void operator()(bytes message) const { node.put(message); }
    };

    [[nodiscard]] std::optional<multicast_options> sae_group() const;
    verdict check(bytes message, const endpoint& from, jaus::framing how);
    void received(bytes message, const endpoint& from, jaus::framing how, bool by_group, duration waited);
    JAUSCAT_DECL void put(bytes message);
    JAUSCAT_DECL void arm();

    boost::asio::io_context& context_;
    node_machine machine_;
    std::unique_ptr<parts> parts_;
    component_output out_{*this};
    time_point received_at_{}; ///< reading the clock costs as much as a component's work
};

} // namespace JAUSCAT_WAY
} // namespace jauscat::net

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/net/node/impl/jaus_node.ipp>
#endif
