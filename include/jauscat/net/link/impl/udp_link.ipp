// The functions of udp_link.
#pragma once
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/net/link/detail/bind_udp.hpp>
#include <jauscat/net/link/udp_link.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <sys/socket.h>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

JAUSCAT_DECL udp_link udp_link::serve(std::uint16_t port, const std::string& address) {
    boost::system::error_code error;
    const auto ip = boost::asio::ip::make_address(address, error);
    if (error)
        throw open_error{
            {.code = errc::invalid_address, .message = '"' + address + "\" is not an IP address, such as 127.0.0.1"}};
    udp_link link;
    detail::bind_udp(link.socket_, {ip, port});
    detail::limit_blocking(link.socket_.native_handle());
    return link;
}

JAUSCAT_DECL udp_link udp_link::connect(const std::string& host, std::uint16_t port) {
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

JAUSCAT_DECL bool udp_link::send(std::span<const std::byte> frame) {
    problem_.clear();
    ethercat::frame_header header;
    const auto payload = frame.subspan(std::min(frame.size(), header_size));
    const auto read = wire::decode_prefix(header, payload);
    // The length of a frame of another master may not be that of its datagrams, which have come back as they were sent.
    ethercat::frame_view view;
    std::size_t datagrams = 0;
    if (view.parse_datagrams(frame))
        for (const auto datagram : view) datagrams += datagram.bytes.size();
    if (!read || (datagrams == 0 && payload.size() < *read + header.length)) {
        problem_ = "a frame of " + std::to_string(frame.size()) + " bytes is shorter than its header announces";
        return false;
    }
    if (peer_.port() == 0) {
        problem_ = "no master has sent a frame yet, so there is no address to answer";
        return false;
    }
    const auto size = std::min(payload.size(), *read + std::max<std::size_t>(header.length, datagrams));
    const auto sent = ::sendto(socket_.native_handle(), payload.data(), size, MSG_DONTWAIT, peer_.data(),
                               static_cast<socklen_t>(peer_.size()));
    if (sent < 0) explain(errno);
    return sent >= 0;
}

JAUSCAT_DECL std::size_t udp_link::receive(std::span<std::byte> buffer, duration timeout) {
    problem_.clear();
    return wait_.receive(socket_.native_handle(), buffer, timeout, [&](int flags) { return take(buffer, flags); });
}

JAUSCAT_DECL std::optional<std::size_t> udp_link::take(std::span<std::byte> buffer, int flags) {
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

JAUSCAT_DECL void udp_link::explain(int error) {
    problem_ = error == ECONNREFUSED ? "no slave receives at UDP " + detail::text(peer_)
                                     : "EtherCAT in UDP with " + detail::text(peer_) + ": " + std::strerror(error);
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::net
