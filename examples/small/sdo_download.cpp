// Writes an object of the first EtherCAT slave on a network interface, and reads it back. "udp" in place of the
// interface is EtherCAT in UDP on this machine, where emulated_slaves may be.
//     sdo_download eth0 2000 0 01 02 03 04
//     sdo_download udp 2000 0 01 02 03 04
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/net/link/raw_link.hpp>
#include <jauscat/net/link/run_master.hpp>
#include <jauscat/net/link/udp_link.hpp>
#include <jauscat/text/hex.hpp>

#include <iostream>
#include <string>
#include <vector>

namespace ethercat = jauscat::ethercat;
namespace net = jauscat::net;

constexpr const char* usage = "sdo_download INTERFACE INDEX SUBINDEX BYTE..., all numbers in hex\n";

struct object {
    std::uint16_t index{};
    std::uint8_t subindex{};
    std::vector<std::byte> value{};
};

template <ethercat::link Link> int write_and_read(Link& link, const object& what) {
    ethercat::master master;
    // Each call of the master starts a job; run() sends and receives until it is done.
    const auto done = [&](bool started, const char* job) {
        const auto result = net::run(link, master, started);
        std::cout << job << ": " << describe(result.error);
        if (const auto detail = describe_detail(result); !detail.empty()) // of the slave's abort or AL status code
            std::cout << ", " << detail << " (" << jauscat::text::hex_number(result.detail, 8) << ')';
        std::cout << '\n';
        return static_cast<bool>(result);
    };

    if (!done(master.scan(), "scan")) return 1;
    std::cout << master.result().size << " slaves\n";

    constexpr std::uint16_t station = 1;
    // The first of the ring; from here on it is known by its station address.
    if (!done(master.bring_up(0, station), "to PRE-OP")) return 1;
    if (!done(master.download(station, what.index, what.subindex, what.value), "download to station address 1"))
        return 1;

    std::array<std::byte, 1024> buffer{};
    if (!done(master.upload(station, what.index, what.subindex, buffer), "upload from station address 1")) return 1;
    const auto read = std::span{buffer}.first(master.result().size);
    std::cout << "the slave has " << jauscat::text::hex(read) << '\n';
    return std::ranges::equal(read, what.value) ? 0 : 1;
}

int main(int argc, char** argv) try {
    if (argc < 5) return std::cerr << usage, 2;
    const std::string interface = argv[1];
    const auto number = [&](int i, unsigned long most) {
        std::size_t used = 0;
        const auto value = std::stoul(argv[i], &used, 16);
        if (argv[i][used] != '\0' || value > most) throw std::out_of_range{argv[i]};
        return value;
    };
    object what{static_cast<std::uint16_t>(number(2, 0xFFFF)), static_cast<std::uint8_t>(number(3, 0xFF))};
    for (int i = 4; i != argc; ++i) what.value.push_back(static_cast<std::byte>(number(i, 0xFF)));

    if (interface == "udp") {
        auto link = net::udp_link::connect("127.0.0.1");
        return write_and_read(link, what);
    }
    net::raw_link link{interface}; // needs CAP_NET_RAW
    return write_and_read(link, what);
} catch (const std::logic_error&) { // no number, or too large
    return std::cerr << usage, 2;
} catch (const std::exception& problem) {
    return std::cerr << "sdo_download: " << problem.what() << '\n', 1;
}
