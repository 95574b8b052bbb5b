// A JAUS node as a state machine: gate, router, large data sets, node manager and the user's components, without
// sockets.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/routing/liveness_table.hpp>
#include <jauscat/net/config/jaus_config.hpp>
#include <jauscat/net/config/jaus_node_options.hpp>
#include <jauscat/net/error.hpp>
#include <jauscat/net/node/detail/attached_component.hpp>
#include <jauscat/net/node/detail/offered_messages.hpp>
#include <jauscat/net/node/node_component.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

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
    using send_handler = std::function<void(bytes message, const endpoint& to, jaus::framing framing)>;

    /// `seed` is a random number. `options.socket` is ignored. Throws `config_error` if this system's jausip has no
    /// subsystem.
    JAUSCAT_DECL node_machine(jaus_config config, jaus_node_options options, send_handler send, std::uint64_t seed);
    JAUSCAT_DECL ~node_machine();
    node_machine(const node_machine&) = delete;
    node_machine& operator=(const node_machine&) = delete;

    /// Adds a component and its application: see node_component and jaus::component_application. Call before start.
    /// Throws `std::invalid_argument` for a component of another node and for a second node manager.
    template <class Component, class Application> void add(Component& component, Application& application) {
        require_component<Component>();
        require_application<Application>();
        add({component, application}, detail::offered_messages{component, application});
    }

    /// Takes a component away. Call before start.
    JAUSCAT_DECL void remove(const jaus::address& self);

    /// A start after `stop` begins without known peers. Must not be called from a handler of this node. Throws
    /// `config_error`.
    JAUSCAT_DECL void start(time_point now);
    /// Queued messages are dropped and logged. No handler is called afterwards. May be called from a handler.
    JAUSCAT_DECL void stop();
    /// Between start and stop.
    [[nodiscard]] bool running() const noexcept { return running_; }
    /// Whether a handler or a component may be active: within a call of received, on_datagram or on_time.
    [[nodiscard]] JAUSCAT_DECL bool in_turn() const noexcept;

    /// The gate's decision on a datagram's content without the framing. Pass accepted messages to `received`.
    JAUSCAT_DECL verdict check(bytes message, const endpoint& from, jaus::framing how, time_point now);
    /// Processes a message that has passed `check`. `by_group`: it was sent to the multicast group. `waited`: time in
    /// the socket before this call, if known; it separates a packet of an old large data set from those of the next.
    JAUSCAT_DECL void received(bytes message, const endpoint& from, jaus::framing how, bool by_group, time_point now,
                               duration waited = {});
    /// `check` and `received` for a datagram without framing. Not for datagrams that this node has sent to the group.
    JAUSCAT_DECL verdict on_datagram(bytes message, const endpoint& from, jaus::framing how, bool by_group,
                                     time_point now, duration waited = {});

    /// Does what is due at `now`. A call before next_event has no effect.
    JAUSCAT_DECL void on_time(time_point now);
    /// When on_time is due, unless another call comes before. Not within a turn.
    [[nodiscard]] JAUSCAT_DECL std::optional<time_point> next_event();

    /// Sends a message of a component of this node. A body of more than 4080 bytes is sent as a large data set, paced;
    /// if `ack_nak` requests acknowledgement, its packets are repeated until they are acknowledged. `data_size` and
    /// `data_flag` of `head` are ignored. The `sequence_number` of a large data set is not sent: it is what
    /// `large_data_done` returns, for the sender to know which one has ended.
    JAUSCAT_DECL result<void, error> send(jaus::header head, bytes body, time_point now);
    /// The same for a typed body. A value that does not encode gives errc::not_encodable, not an exception.
    template <jaus::coded_message T> result<void, error> send(jaus::header head, const T& body, time_point now) {
        std::array<std::byte, jaus::max_body_size> packet{};
        std::vector<std::byte> larger{};
        if (wire::encoded_size(body) > packet.size()) larger.resize(wire::encoded_size(body));
        const std::span<std::byte> encoded = larger.empty() ? std::span<std::byte>{packet} : larger;
        const auto written = wire::encode(body, encoded);
        if (!written) return not_encodable(written.error());
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
    JAUSCAT_DECL void put(bytes message, time_point now) noexcept;
    /// Sink for messages that components send on behalf of the application, until the next call with a time.
    [[nodiscard]] JAUSCAT_DECL jaus::message_sink out(time_point now) noexcept;
    /// Call after changing a component without sending: its next event may be earlier.
    void wake(time_point now) noexcept {
        if (running()) wake_at_ = now;
    }
    /// The node manager of another node has lost a component. Ignored by a node that has a node manager.
    JAUSCAT_DECL void lose(const jaus::address& who, time_point now);
    /// Logs a line, such as an error of its sockets.
    JAUSCAT_DECL void log(std::string_view line, time_point now);

    /// The node manager's address, also if it is in another program.
    [[nodiscard]] const jaus::address& manager() const noexcept { return self_; }
    /// The components alive, as the node manager has them; nullptr without a node manager or before the first start.
    [[nodiscard]] JAUSCAT_DECL const jaus::liveness_table* present() const noexcept;
    [[nodiscard]] const jaus_config& config() const noexcept { return config_; }
    [[nodiscard]] const jaus_node_options& options() const noexcept { return options_; }

  private:
    struct parts; ///< gate, router, queues, node manager

    JAUSCAT_DECL void add(detail::attached_component component, detail::offered_messages messages);
    [[nodiscard]] verdict check_sae(const endpoint& from, time_point now);
    [[nodiscard]] bool has_manager() const noexcept;
    void make_manager(const std::vector<jaus::address>& components);
    void wake_after_sending(time_point now) noexcept;
    void end_turn();

    jaus_config config_;
    jaus_node_options options_;
    jaus::address self_; ///< of the node manager
    std::uint64_t seed_;
    std::unique_ptr<parts> parts_;
    bool running_{};
    std::optional<time_point> wake_at_{}; ///< after a call outside of a turn
    time_point at_{};                     ///< time of the last call
};

} // namespace JAUSCAT_WAY
} // namespace jauscat::net

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/net/node/impl/node_machine.ipp>
#    include <jauscat/net/node/impl/own_manager.ipp>
#endif
