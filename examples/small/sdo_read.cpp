// Reads an object of the first EtherCAT slave on a network interface, and writes none; the slave goes to PRE-OP. "udp"
// in place of the interface is EtherCAT in UDP on this machine, where emulated_slaves may be. SDO information of a
// slave has the size of the object: data of another size are not used.
//     sdo_read eth0 1018 1
//     sdo_read udp 1018 1
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/net/link/raw_link.hpp>
#include <jauscat/net/link/run_master.hpp>
#include <jauscat/net/link/udp_link.hpp>
#include <jauscat/text/hex.hpp>
#include <jauscat/version.hpp>

#include <array>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>

namespace ethercat = jauscat::ethercat;
namespace net = jauscat::net;

constexpr const char* usage = "sdo_read INTERFACE INDEX SUBINDEX, both numbers in hex\n";

// What did not work, and why: with the slave's abort or AL status code.
int fail(const char* job, const ethercat::master_error& error) {
    std::cout << job << ": " << describe(error);
    if (const auto reason = describe_reason(error); !reason.empty())
        std::cout << ", " << reason << " (" << jauscat::text::hex_number(reason_code(error), 8) << ')';
    std::cout << '\n';
    return 1;
}

/// Bytes of the object by the slave's SDO information; none where it has no answer, or where the size may change.
template <ethercat::link Link>
std::optional<std::size_t> described_size(Link& link, ethercat::master& master, std::uint16_t station,
                                          std::uint16_t index, std::uint8_t subindex) {
    std::array<std::byte, 1024> answer{};
    const auto described =
        net::run(link, master,
                 ethercat::describe_entry{.station = station, .index = index, .subindex = subindex, .into = answer});
    if (!described) return {};
    const auto& entry = described->entry;
    const bool may_be_shorter = entry.data_type >= 0x0009 && entry.data_type <= 0x000F; // strings and domains
    if (entry.bits == 0 || may_be_shorter) return {};
    return (entry.bits + 7u) / 8;
}

template <ethercat::link Link> int read(Link& link, std::uint16_t index, std::uint8_t subindex) {
    ethercat::master_for<16> master;
    constexpr std::uint16_t station = 1;
    // Each job is run to its end: frames are sent and received until its result is there.
    if (const auto slaves = net::run(link, master, ethercat::scan{}); !slaves) return fail("scan", slaves.error());
    const auto slave = net::run(link, master, ethercat::bring_up{.position = 0, .station = station});
    if (!slave) return fail("to PRE-OP", slave.error());

    const auto size = described_size(link, master, station, index, subindex);
    std::array<std::byte, 1024> buffer{};
    const auto data = net::run(
        link, master,
        ethercat::upload{
            .station = station, .index = index, .subindex = subindex, .into = buffer, .options = {.size = size}});
    if (data) {
        std::cout << jauscat::text::hex(*data) << '\n';
        if (!std::cout.flush()) return std::cerr << "sdo_read: standard output cannot be written\n", 1;
        return 0;
    }
    fail("upload from station address 1", data.error());
    if (data.error().code == ethercat::master_errc::size_mismatch && size)
        std::cout << "the slave's SDO information says " << *size << " bytes\n";
    return 1;
}

int main(int argc, char** argv) try {
    if (argc == 2 && std::string_view{argv[1]} == "--version")
        return std::cout << "sdo_read (JausCat) " << JAUSCAT_VERSION_TEXT << '\n', 0;
    if (argc != 4) return std::cerr << usage, 2;
    const std::string interface = argv[1];
    const auto number = [&](int i, unsigned long most) {
        std::size_t used = 0;
        const auto value = std::stoul(argv[i], &used, 16);
        if (argv[i][used] != '\0' || value > most) throw std::out_of_range{argv[i]};
        return value;
    };
    const auto index = static_cast<std::uint16_t>(number(2, 0xFFFF));
    const auto subindex = static_cast<std::uint8_t>(number(3, 0xFF));

    if (interface == "udp") {
        auto link = net::udp_link::connect("127.0.0.1");
        return read(link, index, subindex);
    }
    net::raw_link link{interface}; // needs CAP_NET_RAW
    return read(link, index, subindex);
} catch (const std::logic_error&) { // no number, or too large
    return std::cerr << usage, 2;
} catch (const std::exception& problem) {
    return std::cerr << "sdo_read: " << problem.what() << '\n', 1;
}
