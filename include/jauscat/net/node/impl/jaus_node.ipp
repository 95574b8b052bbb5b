// The functions of jaus_node.
#pragma once
#include <jauscat/net/detail/wake_timer.hpp>
#include <jauscat/net/node/detail/node_socket.hpp>
#include <jauscat/net/node/jaus_node.hpp>

#include <optional>
#include <random>
#include <utility>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

struct jaus_node::parts {
    std::optional<detail::node_socket> socket{};
    detail::wake_timer timer;
};

JAUSCAT_DECL jaus_node::jaus_node(boost::asio::io_context& context, jaus_config config, jaus_node_options options)
    : context_{context},
      machine_{std::move(config), std::move(options),
               [this](bytes message, const endpoint& to, jaus::framing framing) {
                   parts_->socket->post(message, to, framing);
               },
               std::random_device{}()},
      parts_{new parts{.timer = {context, [this] {
                                     machine_.on_time(now());
                                     arm();
                                 }}}} {}
JAUSCAT_DECL jaus_node::~jaus_node() {
    try {
        stop();
    } catch (...) { // of the log; the sockets are closed in any case
    }
}

JAUSCAT_DECL void jaus_node::start() {
    machine_.start(now());
    try {
        const auto& options = machine_.options();
        parts_->socket.emplace(context_, config(), options.socket,
                               options.on_sae_datagram ? sae_group() : std::nullopt);
    } catch (...) {
        machine_.stop();
        throw;
    }
    parts_->socket->start(
        [this](bytes message, const endpoint& from, jaus::framing how) { return check(message, from, how); },
        [this](bytes message, const auto&... from) { received(message, from...); },
        [this](std::string_view problem) { machine_.log(problem, now()); });
    arm();
}
inline std::optional<multicast_options> jaus_node::sae_group() const {
    const auto& given = machine_.options().sae_group;
    const auto& sae = config().me().sae;
    return given || !sae || !sae->judp ? given : sae->judp->group;
}
JAUSCAT_DECL void jaus_node::stop() {
    if (!running()) return;
    parts_->timer.cancel();
    try {
        machine_.stop();
    } catch (...) { // of the log
        parts_->socket->stop();
        throw;
    }
    parts_->socket->stop();
}

JAUSCAT_DECL result<void, error> jaus_node::send(const jaus::header& head, bytes body) {
    auto what = machine_.send(head, body, now());
    arm();
    return what;
}
JAUSCAT_DECL result<void, error> jaus_node::send_datagram(bytes datagram, const endpoint& to) {
    if (!running()) return error{.code = errc::not_running, .reason = {}, .message = "the node is not running"};
    return parts_->socket->send(datagram, to);
}
JAUSCAT_DECL void jaus_node::wake() {
    machine_.wake(now());
    arm();
}
JAUSCAT_DECL void jaus_node::lose(const jaus::address& who) {
    machine_.lose(who, now());
    arm();
}
JAUSCAT_DECL udp_counters jaus_node::counts() const noexcept {
    return parts_->socket ? parts_->socket->counts() : udp_counters{};
}

inline verdict jaus_node::check(bytes message, const endpoint& from, jaus::framing how) {
    if (parts_->socket->is_own(from)) return verdict::accepted; // the echo of a multicast; ends in received()
    received_at_ = now();
    return machine_.check(message, from, how, received_at_);
}
inline void jaus_node::received(bytes message, const endpoint& from, jaus::framing how, bool by_group,
                                duration waited) {
    if (parts_->socket->is_own(from)) return;
    machine_.received(message, from, how, by_group, received_at_, waited);
    arm();
}
// Within a turn its time is used.
JAUSCAT_DECL void jaus_node::put(bytes message) {
    const bool in_turn = machine_.in_turn();
    machine_.put(message, in_turn ? received_at_ : now());
    if (!in_turn) arm();
}
// Within a turn what ends the turn arms the timer.
JAUSCAT_DECL void jaus_node::arm() {
    if (machine_.in_turn()) return;
    if (const auto next = machine_.next_event()) parts_->timer.arm(*next);
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::net
