// expect: link: there is no receive(std::span<std::byte> buffer, std::chrono::nanoseconds timeout) that returns a
// std::size_t
#include <jauscat/net/link/cycle_runner.hpp>

struct cable {
    bool send(std::span<const std::byte>) { return true; }
    std::size_t receive(std::span<std::byte>) { return 0; }
};
void run(cable& link, jauscat::ethercat::process_data& data, jauscat::ethercat::master& master) {
    jauscat::net::cycle_runner cycles{link, data, master};
}
