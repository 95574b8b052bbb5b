// write-a-slave.md: an EtherCAT slave whose objects are JAUS messages, and a master that writes one of them.
// [includes]
#include "driver.hpp"
#include <jauscat/bridge/listed_objects.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/slave/loopback_link.hpp>
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/net/link/run_master.hpp>

#include <iostream>
// [includes end]

int main() {
    // [slave]
    driver application{};
    bridging::listed_objects objects{std::span{&driver_objects::description, 1}, application};
    const ethercat::slave_description description{.vendor = 1, .product = 33, .name = "driver"};
    ethercat::standard_objects dictionary{description, objects}; // 1000h, 1018h, ... in front of it
    ethercat::slave device{description, dictionary};
    // [slave end]

    for (const auto& entry : driver_objects::entries)
        std::cout << std::hex << driver_objects::index << "h:" << std::dec << int{entry.subindex} << "  " << entry.name
                  << ", up to " << entry.max_size << " bytes\n";

    // [master]
    ethercat::loopback_link link{std::span{&device, 1}}; // or net::raw_link{"eth0"}
    ethercat::master_for<16> master;
    const auto slave = jauscat::net::run(link, master, ethercat::bring_up{.position = 0, .station = 2});
    if (!slave) return std::cerr << describe(slave.error()) << '\n', 1;

    // Half of the force forward, as an object: 12 bytes of header, 4 of body.
    constexpr std::array<unsigned char, 16> octets{0x06, 0x02, 1,    2,    1,    32,   1,    1,
                                                   0x04, 0x00, 0x22, 0x00, 0x01, 0x00, 0x00, 0x40};
    const auto half = std::as_bytes(std::span{octets});
    const auto written = jauscat::net::run(
        link, master, ethercat::download{.station = 2, .index = driver_objects::index, .subindex = 26, .data = half});
    std::cout << "download: " << describe(written.error()) << ", forward "
              << application.effort.propulsive_linear_effort_x.value_or(0) << " %\n";
    // [master end]
    return written ? 0 : 1;
}
