// A slave in EtherCAT in UDP whose SDO information says 8 bytes of 2000h:0 and 4 of 2001h:0; it sends 4 of both.
#include "ethercat/described_objects.hpp"
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/net/link/udp_link.hpp>
#include <jauscat/net/now.hpp>

#include <array>
#include <chrono>
#include <iostream>

namespace ethercat = jauscat::ethercat;
namespace net = jauscat::net;

namespace {

struct wrong_size_objects : jauscat::test::described_objects {
    using described_objects::describe;
    [[nodiscard]] std::optional<ethercat::entry_info> describe(std::uint16_t index,
                                                               std::uint8_t subindex) const noexcept {
        auto entry = described_objects::describe(index, subindex);
        if (entry && index == 0x2000) entry->bits = 64;
        return entry;
    }
};

} // namespace

int main() try {
    wrong_size_objects objects;
    const ethercat::slave_description description{};
    ethercat::standard_objects dictionary{description, objects};
    ethercat::slave slave{description, dictionary};
    auto link = net::udp_link::serve(net::udp_link::ethercat_port, "127.0.0.1");
    std::cout << "one slave" << std::endl;
    std::array<std::byte, ethercat::max_frame_size> frame{};
    for (;;) {
        const auto size = link.receive(frame, std::chrono::milliseconds{20});
        const auto received = std::span{frame}.first(size);
        if (size != 0) {
            slave.process(received);
            if (!link.send(received)) std::cout << link.problem() << std::endl;
        }
        slave.on_time(jauscat::net::now());
    }
} catch (const std::exception& problem) {
    return std::cerr << "wrong_size_slave: " << problem.what() << '\n', 1;
}
