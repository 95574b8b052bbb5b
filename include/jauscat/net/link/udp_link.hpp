// EtherCAT in UDP: a link that needs no privileges and works on the loopback interface. A UDP datagram contains the
// EtherCAT header and datagrams, without Ethernet header. ETG.1000.4, clause 5.3; port 34980 = 88A4h.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/net/link/detail/frame_wait.hpp>
#include <jauscat/net/open_error.hpp>
#include <jauscat/schema/ethercat/frame.hpp>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

/// One end of an EtherCAT link in UDP. It removes the Ethernet header and the padding and adds them again, so that
/// master and slave process Ethernet frames.
class udp_link {
  public:
    /// UDP port of EtherCAT.
    static constexpr std::uint16_t ethercat_port = 34980;

    udp_link(udp_link&&) = default; ///< no assignment: a socket must be destroyed before its io_context

    /// The slave's end: receives at a port (0: selected by the system) and answers to the last sender.
    /// `address` is the IP address to receive at; the default is all of this machine's. Throws `open_error`.
    [[nodiscard]] JAUSCAT_DECL static udp_link serve(std::uint16_t port = ethercat_port,
                                                     const std::string& address = "0.0.0.0");

    /// The master's end: sends to a slave's host (a name or an address) and port, and receives only from there.
    /// Throws `open_error` without a route to the host. A missing slave is detected at the first exchange.
    [[nodiscard]] JAUSCAT_DECL static udp_link connect(const std::string& host, std::uint16_t port = ethercat_port);

    /// Sends as many bytes as the frame's EtherCAT header announces. False if the frame is shorter, if a serving end
    /// has received no frame yet, and if the network refuses it; `problem()` has the reason.
    [[nodiscard]] JAUSCAT_DECL bool send(std::span<const std::byte> frame);

    /// The next frame, padded to 60 bytes. `buffer` must have 60 bytes, or nothing is received; 1514 hold every frame.
    [[nodiscard]] JAUSCAT_DECL std::size_t receive(std::span<std::byte> buffer, duration timeout);

    /// The reason for the failure of the last `send` or `receive`, in one line; empty without a failure, and for a
    /// timeout.
    const std::string& problem() const noexcept { return problem_; }

    /// The socket, for select or poll: when it is readable, `receive` does not wait.
    [[nodiscard]] int native_handle() { return socket_.native_handle(); }
    /// The UDP port of this end.
    std::uint16_t port() const { return socket_.local_endpoint().port(); }

    /// Time for which `receive` polls before it sleeps; default 0, because both ends often share a processor.
    void busy_poll(duration time) noexcept { wait_.busy_poll(time); }

  private:
    static constexpr std::size_t header_size = wire::max_size<ethercat::ethernet_header>;

    udp_link() = default;

    JAUSCAT_DECL std::optional<std::size_t> take(std::span<std::byte> buffer, int flags);

    JAUSCAT_DECL void explain(int error);

    std::unique_ptr<boost::asio::io_context> context_{std::make_unique<boost::asio::io_context>()};
    boost::asio::ip::udp::socket socket_{*context_};
    boost::asio::ip::udp::endpoint peer_{}; ///< of a serving end: port 0 until the first frame
    detail::frame_wait wait_{duration{}};
    std::string problem_{};
};

} // namespace JAUSCAT_WAY
} // namespace jauscat::net

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/net/link/impl/udp_link.ipp>
#endif
