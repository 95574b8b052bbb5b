// Where the systems of the simulated network are.
#pragma once

#include <jauscat/net/node/node_machine.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace simulation {

namespace net = jauscat::net;

/// A system of the configuration; its place in the list is its port.
struct place {
    std::string name{};
    jauscat::jaus::address jausip{}; ///< with 0 for what it has all of
    std::size_t large_data_memory{std::size_t{256} << 10U};
};

inline constexpr std::uint32_t first_ip = 0x0A000001;
inline constexpr std::uint16_t udp_port = 3794;

[[nodiscard]] inline net::node_machine::endpoint endpoint_of(std::uint8_t port) {
    return {boost::asio::ip::address_v4{first_ip + port}, udp_port};
}
[[nodiscard]] inline std::uint8_t port_of(const net::node_machine::endpoint& at) {
    return static_cast<std::uint8_t>(at.address().to_v4().to_uint() - first_ip);
}
/// All of them as the system `which` sees them.
[[nodiscard]] inline net::jaus_config configuration_of(const std::vector<place>& places, std::size_t which) {
    net::jaus_config made{.this_system = places[which].name, .source = "simulation"};
    for (std::size_t i = 0; i != places.size(); ++i)
        made.systems.push_back({.name = places[i].name,
                                .jausip = places[i].jausip,
                                .ip = endpoint_of(static_cast<std::uint8_t>(i)).address(),
                                .port = udp_port,
                                .limits = {.large_data_memory = places[i].large_data_memory}});
    return made;
}

} // namespace simulation
