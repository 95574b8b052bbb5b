// expect: link: there is no send(std::span<const std::byte> frame) that returns a bool
#include <jauscat/net/link/run_master.hpp>

struct cable {
    std::size_t send(std::span<const std::byte> frame) { return frame.size(); }
    std::size_t receive(std::span<std::byte>, std::chrono::nanoseconds) { return 0; }
};
void run(cable& link, jauscat::ethercat::master& master) { static_cast<void>(jauscat::net::run(link, master)); }
