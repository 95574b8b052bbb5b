// expect: ring_runner: the link has no native_handle() that returns an int
#include <jauscat/net/link/ring_runner.hpp>

struct cable {
    bool send(std::span<const std::byte>) { return true; }
    std::size_t receive(std::span<std::byte>, std::chrono::nanoseconds) { return 0; }
};
void run(boost::asio::io_context& context, cable& link, jauscat::bridging::ring& ring,
         jauscat::jaus::message_sink out) {
    jauscat::net::ring_runner runner{context, link, ring, out};
}
