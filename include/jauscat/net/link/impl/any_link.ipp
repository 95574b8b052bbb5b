// Opens a link by its name.
#pragma once
#include <jauscat/net/link/any_link.hpp>
#include <jauscat/net/link/raw_link.hpp>
#include <jauscat/net/link/udp_link.hpp>
#include <jauscat/net/open_error.hpp>

#include <cstdint>
#include <optional>

namespace jauscat::net {
namespace detail {

struct udp_place {
    std::string host{};
    std::uint16_t port{};
};
/// The place that "udp:HOST" or "udp:HOST:PORT" names; nothing for the name of an interface. Throws `open_error`.
inline std::optional<udp_place> udp_place_of(std::string_view where) {
    constexpr std::string_view udp = "udp:";
    if (where.substr(0, udp.size()) != udp) return {};
    const auto refuse = [&](const char* what) -> open_error {
        return open_error{
            error{.code = errc::invalid_address,
                  .reason = {},
                  .message = '"' + std::string{where} + "\": " + what + "; an example is udp:127.0.0.1:34980"}};
    };
    auto host = where.substr(udp.size());
    std::string_view port;
    const auto end = host.substr(0, 1) == "[" ? host.find(']') : 0;
    if (end == host.npos) throw refuse("the bracket of the address is not closed");
    if (const auto colon = host.find(':', end); colon != host.npos) {
        port = host.substr(colon + 1);
        host = host.substr(0, colon);
        if (port.empty()) throw refuse("the port is missing");
    }
    if (end != 0) host = host.substr(1, end - 1);
    if (host.empty()) throw refuse("the host is missing");
    unsigned number = port.empty() ? udp_link::ethercat_port : 0u;
    for (const char digit : port) {
        if (digit < '0' || digit > '9' || number > 6553) throw refuse("the port is not 1 to 65535");
        number = 10 * number + static_cast<unsigned>(digit - '0');
    }
    if (number < 1 || number > 65535) throw refuse("the port is not 1 to 65535");
    return udp_place{std::string{host}, static_cast<std::uint16_t>(number)};
}

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL std::unique_ptr<any_link> open_link(std::string_view where) {
    const auto udp = detail::udp_place_of(where);
    if (!udp) return std::make_unique<held_link<raw_link>>(raw_link{std::string{where}});
    return std::make_unique<held_link<udp_link>>(udp_link::connect(udp->host, udp->port));
}

JAUSCAT_DECL std::unique_ptr<any_link> open_slaves_link(std::string_view where) {
    const auto udp = detail::udp_place_of(where);
    if (!udp) return std::make_unique<held_link<raw_link>>(raw_link{std::string{where}});
    return std::make_unique<held_link<udp_link>>(udp_link::serve(udp->port, udp->host));
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::net
