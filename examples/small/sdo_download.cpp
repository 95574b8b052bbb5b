// Writes an object of the first EtherCAT slave on a network interface, and reads it back. "udp" in place of the
// interface is EtherCAT in UDP on this machine, where emulated_slaves may be.
//     sdo_download eth0 2000 0 01 02 03 04
//     sdo_download udp 2000 0 01 02 03 04
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/net/link/raw_link.hpp>
#include <jauscat/net/link/run_master.hpp>
#include <jauscat/net/link/udp_link.hpp>
#include <jauscat/text/hex.hpp>
#include <jauscat/version.hpp>

#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace ethercat = jauscat::ethercat;
namespace net = jauscat::net;

constexpr const char* usage = "sdo_download INTERFACE INDEX SUBINDEX BYTE..., all numbers in hex\n";

struct object {
    std::uint16_t index{};
    std::uint8_t subindex{};
    std::vector<std::byte> value{};
};

// What did not work, and why: with the slave's abort or AL status code.
int fail(const char* job, const ethercat::master_error& error) {
    std::cout << job << ": " << describe(error);
    if (const auto reason = describe_reason(error); !reason.empty())
        std::cout << ", " << reason << " (" << jauscat::text::hex_number(reason_code(error), 8) << ')';
    std::cout << '\n';
    return 1;
}

template <ethercat::link Link> int write_and_read(Link& link, const object& what) {
    ethercat::master_for<16> master;
    // Each job is run to its end: frames are sent and received until its result is there.
    const auto slaves = net::run(link, master, ethercat::scan{});
    if (!slaves) return fail("scan", slaves.error());
    std::cout << "scan: ok\n" << *slaves << " slaves\n";

    constexpr std::uint16_t station = 1;
    // The first of the ring; from here on it is known by its station address.
    // [bring_up]
    const auto slave = net::run(link, master, ethercat::bring_up{.position = 0, .station = station});
    if (!slave) return fail("to PRE-OP", slave.error()); // a master_error
    // [bring_up end]
    std::cout << "to PRE-OP: ok\n";

    const auto written = net::run(
        link, master,
        ethercat::download{.station = station, .index = what.index, .subindex = what.subindex, .data = what.value});
    if (!written) return fail("download to station address 1", written.error());
    std::cout << "download to station address 1: ok\n";

    std::array<std::byte, 1024> buffer{};
    const auto read =
        net::run(link, master,
                 ethercat::upload{.station = station, .index = what.index, .subindex = what.subindex, .into = buffer});
    if (!read) return fail("upload from station address 1", read.error());
    std::cout << "upload from station address 1: ok\nthe slave has " << jauscat::text::hex(*read) << '\n';
    if (!std::cout.flush()) return std::cerr << "sdo_download: standard output cannot be written\n", 1;
    return std::ranges::equal(*read, what.value) ? 0 : 1;
}

int main(int argc, char** argv) try {
    if (argc == 2 && std::string_view{argv[1]} == "--version")
        return std::cout << "sdo_download (JausCat) " << JAUSCAT_VERSION_TEXT << '\n', 0;
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
