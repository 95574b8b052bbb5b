// SAE JAUS of a system, as the configuration has it.
#pragma once

#include <jauscat/net/config/udp_options.hpp>
#include <jauscat/sae/transport/jaus_id.hpp>
#include <jauscat/sae/transport/judp.hpp>

#include <boost/asio/ip/address_v4.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace jauscat::net {

/// The group of JUDP, 239.255.0.1, with the TTL of AS5669A.
[[nodiscard]] inline multicast_options judp_multicast() {
    return {.group = boost::asio::ip::address_v4{sae::judp_group}, .port = sae::jaus_port, .ttl = sae::judp_ttl};
}

/// SAE JAUS at the UDP port of the system.
struct judp_entry {
    std::optional<multicast_options> group{}; ///< the group that it joins
    friend bool operator==(const judp_entry&, const judp_entry&) = default;
};

/// SAE JAUS over TCP.
struct jtcp_entry {
    std::optional<std::uint16_t> listen{}; ///< port at which it accepts connections; nothing: none
    std::vector<std::string> connect{};    ///< names of the systems to which it makes connections
    friend bool operator==(const jtcp_entry&, const jtcp_entry&) = default;
};

/// SAE JAUS at a serial line.
struct jserial_entry {
    std::string device{}; ///< of the system's machine, such as /dev/ttyS0
    std::uint32_t baud{115200};
    friend bool operator==(const jserial_entry&, const jserial_entry&) = default;
};

/// SAE JAUS of a system. It has at least one of the media.
struct sae_entry {
    sae::jaus_id id{}; ///< a part of 0 covers every number: 126.1.0 has all components of node 126.1
    std::optional<judp_entry> judp{};
    std::optional<jtcp_entry> jtcp{};
    std::optional<jserial_entry> jserial{};
    std::size_t line{}; ///< where the file declares it
    friend bool operator==(const sae_entry&, const sae_entry&) = default;
};

} // namespace jauscat::net
