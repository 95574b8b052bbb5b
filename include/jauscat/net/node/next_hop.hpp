// Sends a JAUS message to the system that the configuration has for its destination.
#pragma once

#include <jauscat/net/config/jaus_config.hpp>
#include <jauscat/net/link/udp_transport.hpp>
#include <jauscat/schema/jaus/header.hpp>
#include <jauscat/wire/decode.hpp>

#include <cstddef>
#include <span>
#include <string>

namespace jauscat::net {

/// Sends a whole message, header first, to the system whose jausip covers its destination, with that system's framing.
/// Fails if the header is incomplete, if no system covers the destination, and if `udp_transport::send` fails.
[[nodiscard]] inline result<void, error> send_to_next_hop(udp_transport& transport, const jaus_config& config,
                                                          std::span<const std::byte> message) {
    jaus::header header;
    if (const auto read = wire::decode_prefix(header, message); !read)
        return error{.code = errc::invalid_message,
                     .reason = reason_of(read.error()),
                     .message = "no JAUS header in " + std::to_string(message.size()) +
                                " bytes: " + std::string{wire::describe(read.error())}};
    const auto* hop = config.next_hop(header.destination);
    if (!hop)
        return error{.code = errc::unroutable,
                     .reason = {},
                     .message = "no route to " + to_jausip(header.destination) + ": no <system> of " + config.source +
                                " has a jausip that covers it"};
    return transport.send(message, hop->endpoint(), hop->framing);
}

} // namespace jauscat::net
