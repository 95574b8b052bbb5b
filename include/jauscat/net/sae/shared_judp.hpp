// SAE JAUS over UDP at the port of another socket, such as that of a node of the RA.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/jaus/message/framing.hpp>
#include <jauscat/net/detail/named_forms.hpp>
#include <jauscat/net/error.hpp>
#include <jauscat/net/sae/judp_link.hpp>
#include <jauscat/net/sae/transport_driver.hpp>
#include <jauscat/sae/transport/judp.hpp>

#include <boost/asio/ip/udp.hpp>

#include <functional>
#include <optional>
#include <span>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

/// Passes datagrams of another socket to a transport, and the transport's datagrams to that socket, so that the RA and
/// SAE JAUS share a port. The other socket has the access list, the rate limits and the group.
///
///     net::jaus_node node{context, config, {.on_sae_datagram = [&](auto datagram, const auto& from) {
///                                               link.on_datagram(datagram, from);
///                                           }}};
///     net::shared_judp link{context, transport,
///                           [&](auto datagram, const auto& to) { return node.send_datagram(datagram, to); }};
///
/// Use it from the thread that runs the io_context.
class shared_judp {
  public:
    using endpoint = boost::asio::ip::udp::endpoint;
    using bytes = std::span<const std::byte>;
    /// Sends a datagram from the shared port.
    using send_handler = std::function<result<void, error>(bytes datagram, const endpoint& to)>;

    /// `transport` must outlive it; without `group` it has none: `has_group` is false.
    JAUSCAT_DECL shared_judp(boost::asio::io_context& context, sae::transport& transport, send_handler send,
                             std::optional<endpoint> group = {});
    /// The same as one of several media of a driver, which has the handlers.
    JAUSCAT_DECL shared_judp(transport_driver& driver, send_handler send, std::optional<endpoint> group = {});
    shared_judp(const shared_judp&) = delete;
    shared_judp& operator=(const shared_judp&) = delete;

    /// The socket must be open.
    void start(sae_handlers handlers) { medium_.start(std::move(handlers)); }
    /// No handler is called afterwards, and nothing is sent.
    void stop() { medium_.stop(); }

    /// A datagram that the socket has received. Those of IPv6 are dropped, and the log names each host once:
    /// AS5669A has none.
    JAUSCAT_DECL void on_datagram(bytes datagram, const endpoint& from);
    /// The transport's key of an endpoint.
    [[nodiscard]] sae::endpoint_key key_in_transport(const endpoint& to) const noexcept {
        return medium_.in_transport(judp_link::key_of(to));
    }
    /// The number of the medium in its driver.
    [[nodiscard]] std::size_t medium() const noexcept { return medium_.number(); }
    /// See sae::transport::send.
    result<std::uint16_t, sae::transport_errc> send(const sae::outgoing_message& message, bytes payload) {
        return medium_.send(message, payload);
    }

  private:
    [[nodiscard]] transport_driver::put_handler putter() {
        return [this](const sae::outgoing_datagram& datagram) { put(datagram); };
    }
    JAUSCAT_DECL void put(const sae::outgoing_datagram& datagram);

    send_handler send_;
    std::optional<endpoint> group_;
    transport_medium medium_;
    detail::named_forms<jaus::datagram_form> named_{};
};

} // namespace JAUSCAT_WAY
} // namespace jauscat::net

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/net/sae/impl/shared_judp.ipp>
#endif
