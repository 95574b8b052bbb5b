// expect: no error
#include <jauscat/net/link/run_master.hpp>

struct cable {
    bool send(std::span<const std::byte>) { return true; }
    std::size_t receive(std::span<std::byte>, std::chrono::nanoseconds) { return 0; }
};
static_assert(jauscat::ethercat::link<cable>);
void run(cable& link, jauscat::ethercat::master& master) { static_cast<void>(jauscat::net::run(link, master)); }
