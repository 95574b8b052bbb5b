// EtherCAT in UDP: a link that needs no privileges and works on the loopback interface. A UDP datagram contains the
// EtherCAT header and datagrams, without Ethernet header. ETG.1000.4, clause 5.3; port 34980 = 88A4h.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/net/link/detail/bind_udp.hpp>
#include <jauscat/net/link/detail/frame_wait.hpp>
#include <jauscat/net/open_error.hpp>
#include <jauscat/schema/ethercat/frame.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <sys/socket.h>

namespace jauscat::net {

/// One end of an EtherCAT link in UDP. It removes the Ethernet header and the padding and adds them again, so that
/// master and slave process Ethernet frames.
class udp_link {
  public:
    /// UDP port of EtherCAT.
    static constexpr std::uint16_t ethercat_port = 34980;

    udp_link(udp_link&&) = default; ///< no assignment: a socket must be destroyed before its io_context

    /// The slave's end: receives at a port (0: selected by the system) and answers to the last sender.
    /// `address` is the IP address to receive at; the default is all of this machine's. Throws `open_error`.
    [[nodiscard]] static udp_link serve(std::uint16_t port = ethercat_port, const std::string& address = "0.0.0.0") {
        boost::system::error_code error;
        const auto ip = boost::asio::ip::make_address(address, error);
        if (error)
            throw open_error{{.code = errc::invalid_address,
                              .message = '"' + address + "\" is not an IP address, such as 127.0.0.1"}};
        udp_link link;
        detail::bind_udp(link.socket_, {ip, port});
        detail::limit_blocking(link.socket_.native_handle());
        return link;
    }

    /// The master's end: sends to a slave's host (a name or an address) and port, and receives only from there.
    /// Throws `open_error` without a route to the host. A missing slave is detected at the first exchange.
    [[nodiscard]] static udp_link connect(const std::string& host, std::uint16_t port = ethercat_port) {
        udp_link link;
        boost::system::error_code error;
        boost::asio::ip::udp::resolver resolver{*link.context_};
        const auto found = resolver.resolve(host, std::to_string(port), error);
        if (!error) {
            link.peer_ = found.begin()->endpoint();
            link.socket_.connect(link.peer_, error);
        }
        if (error)
            throw open_error{
                {.code = errc::unreachable,
                 .reason = error,
                 .message = "cannot reach a slave at " + host + ':' + std::to_string(port) + ": " + error.message()}};
        detail::limit_blocking(link.socket_.native_handle());
        return link;
    }

    /// Sends as many bytes as the frame's EtherCAT header announces. False if the frame is shorter, if a serving end
    /// has received no frame yet, and if the network refuses it; `problem()` has the reason.
    [[nodiscard]] bool send(std::span<const std::byte> frame) {
        problem_.clear();
        ethercat::frame_header header;
        const auto payload = frame.subspan(std::min(frame.size(), header_size));
        const auto read = wire::decode_prefix(header, payload);
        if (!read || payload.size() < *read + header.length) {
            problem_ = "a frame of " + std::to_string(frame.size()) + " bytes is shorter than its header announces";
            return false;
        }
        if (peer_.port() == 0) {
            problem_ = "no master has sent a frame yet, so there is no address to answer";
            return false;
        }
        const auto sent = ::sendto(socket_.native_handle(), payload.data(), *read + header.length, MSG_DONTWAIT,
                                   peer_.data(), static_cast<socklen_t>(peer_.size()));
        if (sent < 0) explain(errno);
        return sent >= 0;
    }

    /// The next frame, padded to 60 bytes. `buffer` must have 60 bytes, or nothing is received; 1514 hold every frame.
    [[nodiscard]] std::size_t receive(std::span<std::byte> buffer, duration timeout) {
        problem_.clear();
        return wait_.receive(socket_.native_handle(), buffer, timeout, [&](int flags) { return take(buffer, flags); });
    }

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

    std::optional<std::size_t> take(std::span<std::byte> buffer, int flags) {
        const auto payload = buffer.subspan(header_size);
        boost::asio::ip::udp::endpoint from;
        auto address_size = static_cast<socklen_t>(from.capacity());
        const auto result = ::recvfrom(socket_.native_handle(), payload.data(), payload.size(), flags | MSG_TRUNC,
                                       from.data(), &address_size); // MSG_TRUNC: the true size of a larger datagram
        if (result < 0 && (errno == EAGAIN || errno == EINTR)) return {};
        if (result < 0) {
            explain(errno);
            return 0;
        }
        const auto size = static_cast<std::size_t>(result);
        if (size < wire::max_size<ethercat::frame_header> || size > payload.size()) return {};

        from.resize(address_size);
        peer_ = from;
        ethercat::ethernet_header header{.ether_type = ethercat::ether_type_ethercat};
        header.destination.fill(std::byte{0xFF});
        (void)wire::encode(header, buffer.first(header_size));
        return header_size + size;
    }

    void explain(int error) {
        problem_ = error == ECONNREFUSED ? "no slave receives at UDP " + detail::text(peer_)
                                         : "EtherCAT in UDP with " + detail::text(peer_) + ": " + std::strerror(error);
    }

    std::unique_ptr<boost::asio::io_context> context_{std::make_unique<boost::asio::io_context>()};
    boost::asio::ip::udp::socket socket_{*context_};
    boost::asio::ip::udp::endpoint peer_{}; ///< of a serving end: port 0 until the first frame
    detail::frame_wait wait_{duration{}};
    std::string problem_{};
};

} // namespace jauscat::net
