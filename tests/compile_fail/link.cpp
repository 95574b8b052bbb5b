#include <jauscat/net/link/cycle_runner.hpp>
#include <jauscat/net/link/ring_runner.hpp>
#include <jauscat/net/link/run_master.hpp>

#ifdef GOOD
// expect: no error
struct cable {
    bool send(std::span<const std::byte>) { return true; }
    std::size_t receive(std::span<std::byte>, std::chrono::nanoseconds) { return 0; }
};
static_assert(jauscat::ethercat::link<cable>);
void run(cable& link, jauscat::ethercat::master& master) { static_cast<void>(jauscat::net::run(link, master)); }
#endif

#ifdef RECEIVE_OF_CYCLES
// expect: link: there is no receive(std::span<std::byte> buffer, std::chrono::nanoseconds timeout) that returns a
// std::size_t
struct cable {
    bool send(std::span<const std::byte>) { return true; }
    std::size_t receive(std::span<std::byte>) { return 0; }
};
void run(cable& link, jauscat::ethercat::process_data& data, jauscat::ethercat::master& master) {
    jauscat::net::cycle_runner cycles{link, data, master};
}
#endif

#ifdef SEND_PARAMETERS
// expect: link: there is no send(std::span<const std::byte> frame) that returns a bool
struct cable {
    bool send(std::span<std::byte>) { return true; }
    std::size_t receive(std::span<std::byte>, std::chrono::nanoseconds) { return 0; }
};
void run(cable& link, jauscat::ethercat::master& master) { static_cast<void>(jauscat::net::run(link, master)); }
#endif

#ifdef SEND_RESULT
// expect: link: there is no send(std::span<const std::byte> frame) that returns a bool
struct cable {
    std::size_t send(std::span<const std::byte> frame) { return frame.size(); }
    std::size_t receive(std::span<std::byte>, std::chrono::nanoseconds) { return 0; }
};
void run(cable& link, jauscat::ethercat::master& master) { static_cast<void>(jauscat::net::run(link, master)); }
#endif

#ifdef WITHOUT_DESCRIPTOR
// expect: ring_runner: the link has no native_handle() that returns an int
struct cable {
    bool send(std::span<const std::byte>) { return true; }
    std::size_t receive(std::span<std::byte>, std::chrono::nanoseconds) { return 0; }
};
void run(boost::asio::io_context& context, cable& link, jauscat::bridging::ring& ring,
         jauscat::jaus::message_sink out) {
    jauscat::net::ring_runner runner{context, link, ring, out};
}
#endif

#ifdef WITHOUT_RECEIVE
// expect: link: there is no receive(std::span<std::byte> buffer, std::chrono::nanoseconds timeout) that returns a
// std::size_t
struct cable {
    bool send(std::span<const std::byte>) { return true; }
};
void run(cable& link, jauscat::ethercat::master& master) { static_cast<void>(jauscat::net::run(link, master)); }
#endif
