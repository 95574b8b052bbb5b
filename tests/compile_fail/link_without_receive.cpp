// expect: link: there is no receive(std::span<std::byte> buffer, std::chrono::nanoseconds timeout) that returns a
// std::size_t
#include <jauscat/net/link/run_master.hpp>

struct cable {
    bool send(std::span<const std::byte>) { return true; }
};
void run(cable& link, jauscat::ethercat::master& master) { static_cast<void>(jauscat::net::run(link, master)); }
