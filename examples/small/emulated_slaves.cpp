// Three emulated EtherCAT slaves, for masters to be tried against: in UDP, or on a network interface as on a cable.
//     emulated_slaves
//     emulated_slaves udp:127.0.0.1:34981
//     emulated_slaves eth1
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/net/limited_log.hpp>
#include <jauscat/net/link/any_link.hpp>
#include <jauscat/net/now.hpp>
#include <jauscat/text/hex.hpp>
#include <jauscat/text/value.hpp>
#include <jauscat/version.hpp>

#include <array>
#include <chrono>
#include <iostream>
#include <string>

namespace ethercat = jauscat::ethercat;
namespace net = jauscat::net;
namespace text = jauscat::text;

/// A master may write often: at most 20 lines a second of each cause.
net::limited_log limited{[](std::string_view line) { std::cout << line << std::endl; }};

/// What is special to such a slave: one object, 2000h:0, that holds four bytes.
class setpoint {
  public:
    ethercat::object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        if (index != 0x2000) return {.error = ethercat::abort_code::no_object};
        if (subindex != 0) return {.error = ethercat::abort_code::no_subindex};
        std::ranges::copy(value_, out.begin());
        return {.size = value_.size()};
    }
    ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) noexcept {
        if (index != 0x2000) return ethercat::abort_code::no_object;
        if (subindex != 0) return ethercat::abort_code::no_subindex;
        if (data.size() != value_.size()) return ethercat::abort_code::length_mismatch;
        std::ranges::copy(data, value_.begin());
        limited(jauscat::net::now(), [&] { return "2000h = " + text::hex(data); });
        return ethercat::abort_code::none;
    }

  private:
    std::array<std::byte, 4> value_{};
};

/// The parts of one slave: its description, the objects that every slave has, and its own.
struct device {
    explicit device(std::uint32_t serial) : description{.vendor = 0x4A430000, .product = 1, .serial = serial} {}
    device(const device&) = delete; // its parts refer to one another

    ethercat::slave_description description;
    setpoint own{};
    ethercat::standard_objects objects{description, own};
    ethercat::slave slave{description, objects};
};

void serve(net::any_link& link) {
    std::array<device, 3> ring{device{1}, device{2}, device{3}};
    for (auto& each : ring) each.slave.set_downstream(&each != &ring.back());
    std::cout << "three slaves (Ctrl-C ends)" << std::endl;
    std::array<std::byte, ethercat::max_frame_size> frame{};
    for (;;) {
        const auto size = link.receive(frame, std::chrono::milliseconds{20});
        const auto received = std::span{frame}.first(size);
        const auto now = jauscat::net::now();
        if (size != 0) {
            for (auto& each : ring) each.slave.process(received); // the frame passes all of them
            if (!link.send(received)) limited(now, [&] { return link.problem(); });
        }
        for (auto& each : ring) each.slave.on_time(now);
    }
}

int main(int argc, char** argv) try {
    const std::string where = argc < 2 ? "udp:127.0.0.1" : argv[1];
    if (where == "--version") return std::cout << "emulated_slaves (JausCat) " << JAUSCAT_VERSION_TEXT << '\n', 0;
    if (argc > 2 || where.starts_with('-')) return std::cerr << "emulated_slaves [udp:HOST[:PORT]|INTERFACE]\n", 2;
    const auto link = net::open_slaves_link(where);
    serve(*link);
} catch (const std::exception& problem) {
    return std::cerr << "emulated_slaves: " << problem.what() << '\n', 1;
}
