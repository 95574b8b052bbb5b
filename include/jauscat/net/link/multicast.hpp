// Multicast at a UDP socket: membership in a group, and reach of sent datagrams. IPv4 and IPv6.
#pragma once

#include <jauscat/net/config/udp_options.hpp>
#include <jauscat/net/open_error.hpp>

#include <boost/asio/ip/udp.hpp>

#include <cerrno>
#include <cstring>
#include <net/if.h>
#include <netinet/in.h>
#include <string>
#include <sys/socket.h>

namespace jauscat::net {

namespace detail {

/// Throws `open_error` with what to do.
[[noreturn]] inline void fail_multicast(const multicast_options& options, const char* what, int error) {
    net::error why{.code = errc::not_opened,
                   .reason = {error, std::generic_category()},
                   .message = std::string{what} + ' ' + options.group.to_string()};
    if (!options.interface_name.empty()) why.message += " on " + options.interface_name;
    why.message += std::string{": "} + std::strerror(error);
    if (error == ENODEV || error == EADDRNOTAVAIL) {
        const bool named = !options.interface_name.empty();
        why.code = named ? errc::no_interface : errc::unreachable;
        why.message += named ? "; see ip -brief address" : "; no route leads there: name an interface";
    }
    if (error == ENOBUFS) why.message += "; see sysctl net.ipv4.igmp_max_memberships";
    throw open_error{why};
}

/// The interface's index; 0 without a name: the routing table selects the interface. Throws `open_error`.
inline unsigned multicast_interface(const multicast_options& options) {
    if (options.interface_name.empty()) return 0;
    const auto index = ::if_nametoindex(options.interface_name.c_str());
    if (index == 0) fail_multicast(options, "cannot use the multicast group", ENODEV);
    return index;
}

template <class T> bool set_option(int socket, int level, int name, const T& value) noexcept {
    return ::setsockopt(socket, level, name, &value, sizeof value) == 0;
}

inline void need_multicast_group(const multicast_options& options) {
    if (!options.group.is_multicast())
        throw open_error{{.code = errc::invalid_address,
                          .message = options.group.to_string() + " is no multicast group; use 224.1.0.1"}};
}

} // namespace detail

/// Joins the group with `socket`, which is bound to the group's port. It receives the group's datagrams if it is bound
/// to the group's address or to none (0.0.0.0, ::), not if it is bound to an address of this host. Throws `open_error`.
inline void join_group(boost::asio::ip::udp::socket& socket, const multicast_options& options) {
    detail::need_multicast_group(options);
    group_req request{};
    request.gr_interface = detail::multicast_interface(options);
    const boost::asio::ip::udp::endpoint group{options.group, 0};
    std::memcpy(&request.gr_group, group.data(), group.size());
    const bool v6 = options.group.is_v6();
    if (!detail::set_option(socket.native_handle(), v6 ? IPPROTO_IPV6 : IPPROTO_IP, MCAST_JOIN_GROUP, request))
        detail::fail_multicast(options, "cannot join the multicast group", errno);
    // Without this a socket bound to no address also receives the groups that other programs have joined.
    detail::set_option(socket.native_handle(), v6 ? IPPROTO_IPV6 : IPPROTO_IP,
                       v6 ? IPV6_MULTICAST_ALL : IP_MULTICAST_ALL, int{0});
}

/// Sets the interface, the reach and the loopback of datagrams that `socket` sends to a group. Throws `open_error`.
inline void set_multicast_sending(boost::asio::ip::udp::socket& socket, const multicast_options& options) {
    detail::need_multicast_group(options);
    const int handle = socket.native_handle(), ttl = options.ttl, loop = options.loop ? 1 : 0;
    const auto index = detail::multicast_interface(options);
    bool done = false;
    if (options.group.is_v6()) {
        done = detail::set_option(handle, IPPROTO_IPV6, IPV6_MULTICAST_HOPS, ttl) &&
               detail::set_option(handle, IPPROTO_IPV6, IPV6_MULTICAST_LOOP, loop) &&
               (index == 0 || detail::set_option(handle, IPPROTO_IPV6, IPV6_MULTICAST_IF, static_cast<int>(index)));
    } else {
        ip_mreqn request{};
        request.imr_ifindex = static_cast<int>(index);
        done = detail::set_option(handle, IPPROTO_IP, IP_MULTICAST_TTL, ttl) &&
               detail::set_option(handle, IPPROTO_IP, IP_MULTICAST_LOOP, loop) &&
               (index == 0 || detail::set_option(handle, IPPROTO_IP, IP_MULTICAST_IF, request));
    }
    if (!done) detail::fail_multicast(options, "cannot send to the multicast group", errno);
}

} // namespace jauscat::net
