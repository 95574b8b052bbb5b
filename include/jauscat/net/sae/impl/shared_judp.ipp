// The functions of shared_judp.
#pragma once
#include <jauscat/net/detail/endpoint_text.hpp>
#include <jauscat/net/sae/shared_judp.hpp>

#include <utility>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

JAUSCAT_DECL shared_judp::shared_judp(boost::asio::io_context& context, sae::transport& transport, send_handler send,
                                      std::optional<endpoint> group)
    : send_{std::move(send)}, group_{std::move(group)}, medium_{context, transport, putter()} {}
JAUSCAT_DECL shared_judp::shared_judp(transport_driver& driver, send_handler send, std::optional<endpoint> group)
    : send_{std::move(send)}, group_{std::move(group)}, medium_{driver, putter()} {}

JAUSCAT_DECL void shared_judp::on_datagram(bytes datagram, const endpoint& from) {
    if (!from.address().is_v4()) {
        if (named_.is_new(from.address(), jaus::datagram_form::judp2))
            medium_.report("a datagram from " + detail::text(from) +
                           " is dropped: JUDP needs IPv4; the next ones of this host are only dropped");
        return;
    }
    medium_.on_datagram(judp_link::key_of(from), datagram);
}

JAUSCAT_DECL void shared_judp::put(const sae::outgoing_datagram& datagram) {
    if (!datagram.to && !group_) return; // the transport sends nothing to a group that it does not have
    const auto to = datagram.to ? judp_link::endpoint_of(*datagram.to) : *group_;
    if (const auto sent = send_(datagram.bytes, to); !sent) medium_.report(sent.error().message);
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::net
