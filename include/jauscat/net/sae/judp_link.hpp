// SAE JAUS over UDP with Boost.Asio: unicast and a multicast group, at one socket.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/net/config/sae_entry.hpp>
#include <jauscat/net/detail/named_forms.hpp>
#include <jauscat/net/link/udp_transport.hpp>
#include <jauscat/net/rate_limit.hpp>
#include <jauscat/net/sae/transport_driver.hpp>

#include <boost/asio/ip/address_v4.hpp>
#include <boost/asio/ip/udp.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

struct judp_options {
    /// IPv4. Bound to an address of this machine, a second socket receives the group: any number of programs of a
    /// machine can have one.
    boost::asio::ip::udp::endpoint local{boost::asio::ip::udp::v4(), sae::jaus_port};
    udp_options socket{};
    /// Group for broadcasts and unknown destinations; nothing: unicast alone, with `has_group` of the transport false.
    std::optional<multicast_options> group{judp_multicast()};
    /// Hosts whose datagrams are processed; empty: all.
    std::vector<boost::asio::ip::address_v4> accepted{};
    /// Datagrams of one host.
    rate limit{.per_second = 50'000, .burst = 5'000};
};

/// Sends and receives the messages of a transport over UDP. Use it from the thread that runs the io_context.
///
/// Messages of the RA that arrive at the same port are passed to a handler, such as one of a node_machine, where there
/// is one; else they are named in the log, once for each form of a host, and counted.
class judp_link {
  public:
    using endpoint = boost::asio::ip::udp::endpoint;
    /// Called with each message of the RA at the port.
    using ra_handler = udp_transport::message_handler;

    /// Opens the socket and joins the group. `transport` must outlive it. Throws `open_error`.
    JAUSCAT_DECL judp_link(boost::asio::io_context& context, sae::transport& transport,
                           const judp_options& options = {});
    /// The same as one of several media of a driver, which has the handlers.
    JAUSCAT_DECL judp_link(boost::asio::io_context& context, transport_driver& driver,
                           const judp_options& options = {});
    judp_link(const judp_link&) = delete;
    judp_link& operator=(const judp_link&) = delete;

    /// Starts to receive while the io_context runs.
    JAUSCAT_DECL void start(sae_handlers handlers, ra_handler on_ra_message = {});
    /// Closes the socket. No handler is called afterwards.
    JAUSCAT_DECL void stop();

    /// See sae::transport::send.
    result<std::uint16_t, sae::transport_errc> send(const sae::outgoing_message& message,
                                                    std::span<const std::byte> payload) {
        return medium_.send(message, payload);
    }
    /// Sends a message of the RA from the same port.
    result<void, error> send_ra(std::span<const std::byte> message, const endpoint& to, jaus::framing framing) {
        return socket_.send(message, to, framing);
    }

    /// The number of an endpoint in the transport, and the other way round.
    [[nodiscard]] JAUSCAT_DECL static sae::endpoint_key key_of(const endpoint& from) noexcept;
    [[nodiscard]] JAUSCAT_DECL static endpoint endpoint_of(sae::endpoint_key key);

    endpoint local() const { return socket_.local(); }
    /// The transport's key of an endpoint.
    [[nodiscard]] sae::endpoint_key key_in_transport(const endpoint& to) const noexcept {
        return medium_.in_transport(key_of(to));
    }
    /// The number of the medium in its driver.
    [[nodiscard]] std::size_t medium() const noexcept { return medium_.number(); }
    /// Counters of its sockets: of hosts that are not accepted, `unknown_peer`.
    [[nodiscard]] JAUSCAT_DECL udp_counters counts() const noexcept;

  private:
    JAUSCAT_DECL static const endpoint& checked(const endpoint& local);
    [[nodiscard]] transport_driver::put_handler putter() {
        return [this](const sae::outgoing_datagram& datagram) { put(datagram); };
    }
    JAUSCAT_DECL void open(boost::asio::io_context& context, const judp_options& options);
    [[nodiscard]] JAUSCAT_DECL verdict check(const endpoint& from);
    JAUSCAT_DECL void received(std::span<const std::byte> message, const endpoint& from, jaus::framing framing);
    JAUSCAT_DECL void put(const sae::outgoing_datagram& datagram);
    JAUSCAT_DECL void name(jaus::datagram_form form, const endpoint& from);

    std::vector<boost::asio::ip::address_v4> accepted_;
    rate_limit<256> limit_;
    std::optional<endpoint> group_{};
    udp_transport socket_;
    std::optional<udp_transport> group_socket_{};
    transport_medium medium_;
    ra_handler on_ra_message_{};
    detail::named_forms<jaus::datagram_form> named_{};
};

} // namespace JAUSCAT_WAY
} // namespace jauscat::net

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/net/sae/impl/judp_link.ipp>
#endif
