// The sockets of a node: its own, and one that receives its multicast group.
#pragma once

#include <jauscat/net/config/jaus_config.hpp>
#include <jauscat/net/link/udp_transport.hpp>

#include <optional>

namespace jauscat::net::detail {

/// All messages are sent from the node's own socket, also to a group, so that others see the address for answers. A
/// second socket, bound to the group's address, receives the group: any number of programs on a host can have one. So
/// does a third one for the group of SAE JAUS.
class node_socket {
  public:
    using endpoint = udp_transport::endpoint;
    using bytes = std::span<const std::byte>;

    /// Throws `open_error` and `config_error`.
    node_socket(boost::asio::io_context& context, const jaus_config& config, const udp_options& options,
                const std::optional<multicast_options>& sae_group = {})
        : own_{context, config.me().endpoint(), options}, local_{own_.local()} {
        const auto& me = config.me();
        auto shared = options;
        shared.reuse_address = true;
        if (sae_group) {
            sae_group_.emplace(context, endpoint{sae_group->group, sae_group->port}, shared);
            sae_group_->join(*sae_group);
            if (!me.multicast) own_.send_multicast_by(*sae_group);
        }
        if (!me.multicast) return;
        if (me.ip.is_unspecified())
            throw complaint(config, config_errc::inconsistent, "multicast", me.line,
                            "the system " + detail::quoted(me.name) + " has multicast and the ip " + me.ip.to_string() +
                                "; give the address by which others know it");
        group_.emplace(context, endpoint{me.multicast->group, me.multicast->port}, shared);
        group_->join(*me.multicast);
        own_.send_multicast_by(*me.multicast);
    }

    void start(const udp_transport::filter& accept, auto on_message, const udp_transport::error_handler& on_error) {
        own_.set_filter(accept);
        own_.start([this, on_message](bytes message, const endpoint& from,
                                      jaus::framing how) { on_message(message, from, how, false, own_.waited()); },
                   on_error);
        for (auto* const group : {&group_, &sae_group_}) {
            if (!*group) continue;
            (*group)->set_filter(accept);
            (*group)->start(
                [group, on_message](bytes message, const endpoint& from, jaus::framing how) {
                    on_message(message, from, how, true, (*group)->waited());
                },
                on_error);
        }
    }
    void post(bytes message, const endpoint& to, jaus::framing framing) { own_.post(message, to, framing); }
    result<void, error> send(bytes datagram, const endpoint& to) { return own_.send(datagram, to); }
    void stop() {
        own_.stop();
        if (group_) group_->stop();
        if (sae_group_) sae_group_->stop();
    }
    [[nodiscard]] bool is_own(const endpoint& from) const noexcept { return from == local_; }
    [[nodiscard]] udp_counters counts() const noexcept {
        auto all = own_.counts();
        for (const auto* const group : {&group_, &sae_group_})
            if (*group)
                for (const auto& counter : udp_counter_list) all.*counter.value += (*group)->counts().*counter.value;
        return all;
    }

  private:
    udp_transport own_;
    endpoint local_;
    std::optional<udp_transport> group_{}, sae_group_{};
};

} // namespace jauscat::net::detail
