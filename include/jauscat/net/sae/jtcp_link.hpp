// SAE JAUS over TCP with Boost.Asio: connections that are accepted, and connections that are made.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/net/open_error.hpp>
#include <jauscat/net/rate_limit.hpp>
#include <jauscat/net/sae/growing_pause.hpp>
#include <jauscat/net/sae/transport_driver.hpp>
#include <jauscat/sae/transport/judp.hpp>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

struct jtcp_options {
    /// Where connections are accepted; nothing: none.
    std::optional<boost::asio::ip::tcp::endpoint> listen{
        boost::asio::ip::tcp::endpoint{boost::asio::ip::tcp::v4(), sae::jaus_port}};
    std::size_t max_connections{16};     ///< others are closed at once
    std::size_t message_size{8192};      ///< largest received message, header included
    std::size_t max_waiting{256 * 1024}; ///< bytes that wait to be sent by a connection; what exceeds it is dropped
    /// Hosts whose connections are accepted; empty: all.
    std::vector<boost::asio::ip::address> accepted{};
    /// Messages of one connection.
    rate limit{.per_second = 50'000, .burst = 5'000};
    /// A connection that was silent for so long is probed, and ends if the peer's host does not answer; rounded down to
    /// seconds, at least 1 s. 0: no probes.
    duration keep_alive{std::chrono::seconds{10}};
    /// A connection from which no byte comes for so long is closed. 0: no limit.
    duration idle_limit{};
    /// The address of this machine from which connections are made; unspecified: the routing table chooses.
    boost::asio::ip::address from{};
    /// An attempt of `connect` ends after so long without an answer, such as of a host that is off; the system's limit,
    /// about 2 minutes on Linux, applies where it is shorter. 0: the system's alone.
    duration connect_timeout{std::chrono::seconds{5}};
    /// Pauses before a connection of `connect` is made again.
    pause_limits reconnect{};
};

/// Counts since construction.
struct jtcp_counters {
    std::uint64_t accepted{};     ///< connections
    std::uint64_t connected{};    ///< connections that were made
    std::uint64_t failed{};       ///< attempts to make one
    std::uint64_t idle{};         ///< connections closed because of the idle limit
    std::uint64_t unknown_peer{}; ///< connections of hosts that are not accepted
    std::uint64_t no_capacity{};  ///< connections above the limit
    std::uint64_t wrong{};        ///< connections closed because of a wrong version or size
    std::uint64_t rate_limited{}; ///< messages above the limit
    std::uint64_t dropped{};      ///< messages not sent because too many bytes waited
};

/// Sends and receives the messages of a transport over TCP; a broadcast goes to every connection. Use it from the
/// thread that runs the io_context.
class jtcp_link {
  public:
    using endpoint = boost::asio::ip::tcp::endpoint;

    /// Opens the port. `transport` must outlive it. Throws `open_error`.
    JAUSCAT_DECL jtcp_link(boost::asio::io_context& context, sae::transport& transport,
                           const jtcp_options& options = {});
    /// The same as one of several media of a driver, which has the handlers.
    JAUSCAT_DECL jtcp_link(boost::asio::io_context& context, transport_driver& driver,
                           const jtcp_options& options = {});
    JAUSCAT_DECL ~jtcp_link();
    jtcp_link(const jtcp_link&) = delete;
    jtcp_link& operator=(const jtcp_link&) = delete;

    /// Accepts connections while the io_context runs.
    JAUSCAT_DECL void start(sae_handlers handlers);
    /// Makes a connection and, where that fails or the connection ends, makes it again after a pause, until stop. The
    /// pauses grow until a message comes from the peer. Call after start. The error handler gets a line for the first
    /// failure, for another reason of failure, for the end of a connection, and for its return.
    JAUSCAT_DECL void connect(const endpoint& to);
    /// Closes all connections. No handler is called afterwards.
    JAUSCAT_DECL void stop();

    /// See sae::transport::send.
    result<std::uint16_t, sae::transport_errc> send(const sae::outgoing_message& message,
                                                    std::span<const std::byte> payload) {
        return medium_.send(message, payload);
    }

    /// Where connections are accepted.
    endpoint local() const { return acceptor_.local_endpoint(); }
    /// The number of the medium in its driver.
    [[nodiscard]] std::size_t medium() const noexcept { return medium_.number(); }
    /// The peer of a connection by its key in the transport; nothing once it is closed.
    [[nodiscard]] JAUSCAT_DECL std::optional<endpoint> peer_of(sae::endpoint_key key) const;
    /// The key in the transport of the open connection that `connect(to)` has made.
    [[nodiscard]] JAUSCAT_DECL std::optional<sae::endpoint_key> connection_to(const endpoint& to) const;
    /// Number of open connections.
    [[nodiscard]] std::size_t connections() const noexcept { return connections_.size(); }
    const jtcp_counters& counts() const noexcept { return counters_; }

  private:
    struct connection;
    struct target;

    [[nodiscard]] transport_driver::put_handler putter() {
        return [this](const sae::outgoing_datagram& datagram) { put(datagram); };
    }
    JAUSCAT_DECL void listen();
    JAUSCAT_DECL void accept();
    JAUSCAT_DECL void accepted(boost::asio::ip::tcp::socket socket);
    JAUSCAT_DECL void open(boost::asio::ip::tcp::socket socket, const endpoint& peer,
                           const std::shared_ptr<target>& wanted);
    JAUSCAT_DECL void try_to_connect(const std::shared_ptr<target>& to);
    JAUSCAT_DECL void give_up_later(const std::shared_ptr<target>& to);
    JAUSCAT_DECL void not_connected(const std::shared_ptr<target>& to, const std::string& why);
    JAUSCAT_DECL void try_again_later(const std::shared_ptr<target>& to);
    JAUSCAT_DECL void watch_idle(const std::shared_ptr<connection>& to);
    JAUSCAT_DECL void receive(const std::shared_ptr<connection>& from);
    JAUSCAT_DECL void received(connection& from, std::span<const std::byte> bytes);
    JAUSCAT_DECL void put(const sae::outgoing_datagram& datagram);
    JAUSCAT_DECL void write(const std::shared_ptr<connection>& to, std::span<const std::byte> message);
    JAUSCAT_DECL void close(std::uint64_t key, const std::string& why);

    boost::asio::io_context& context_;
    jtcp_options options_;
    boost::asio::ip::tcp::acceptor acceptor_;
    boost::asio::steady_timer pause_; ///< after a failure to accept
    transport_medium medium_;
    std::map<std::uint64_t, std::shared_ptr<connection>> connections_{}; ///< by their keys in the transport
    std::vector<std::shared_ptr<target>> targets_{};                     ///< of `connect`
    std::uint64_t last_key_{};
    jtcp_counters counters_{};
    std::shared_ptr<char> alive_{std::make_shared<char>()};
};

} // namespace JAUSCAT_WAY
} // namespace jauscat::net

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/net/sae/impl/jtcp_link.ipp>
#endif
