// Six emulated CiA 402 drives, for masters to be tried against: in UDP, or on a network interface as on a cable.
//     emulated_drives
//     emulated_drives udp:127.0.0.1:34981
//     emulated_drives eth1
#include <jauscat/ethercat/cia402/emulated_drive.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/net/limited_log.hpp>
#include <jauscat/net/link/any_link.hpp>
#include <jauscat/net/now.hpp>
#include <jauscat/version.hpp>

#include <array>
#include <chrono>
#include <cstdint>
#include <iostream>
#include <string>

namespace cia402 = jauscat::cia402;
namespace ethercat = jauscat::ethercat;
namespace net = jauscat::net;

/// The parts of one slave: a drive with one axis, the objects that every slave has, and PDOs that a master may map.
struct device {
    device() = default;
    device(const device&) = delete; // its parts refer to one another

    cia402::emulated_drive<> drive{};
    ethercat::standard_objects objects{cia402::drive_description<>, drive};
    ethercat::assignable_pdos pdos{cia402::drive_description<>, objects};
    ethercat::slave slave{cia402::drive_description<>, pdos};
};

void serve(net::any_link& link) {
    std::array<device, 6> ring{};
    for (auto& each : ring) each.slave.set_downstream(&each != &ring.back());
    net::limited_log limited{[](std::string_view line) { std::cout << line << std::endl; }};
    std::cout << "six drives (Ctrl-C ends)" << std::endl;
    std::array<std::byte, ethercat::max_frame_size> frame{};
    for (;;) {
        const auto size = link.receive(frame, std::chrono::milliseconds{1});
        const auto received = std::span{frame}.first(size);
        const auto now = net::now();
        if (size != 0) {
            for (auto& each : ring) each.slave.process(received); // the frame passes all of them
            if (!link.send(received)) limited(now, [&] { return link.problem(); });
        }
        for (auto& each : ring) {
            each.slave.on_time(now);
            each.drive.work(each.slave, each.pdos, now); // the motor turns
        }
    }
}

int main(int argc, char** argv) try {
    const std::string where = argc < 2 ? "udp:127.0.0.1" : argv[1];
    if (where == "--version") return std::cout << "emulated_drives (JausCat) " << JAUSCAT_VERSION_TEXT << '\n', 0;
    if (argc > 2 || where.starts_with('-')) return std::cerr << "emulated_drives [udp:HOST[:PORT]|INTERFACE]\n", 2;
    const auto link = net::open_slaves_link(where);
    serve(*link);
} catch (const std::exception& problem) {
    return std::cerr << "emulated_drives: " << problem.what() << '\n', 1;
}
