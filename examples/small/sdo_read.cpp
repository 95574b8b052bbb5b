// Reads an object of the first EtherCAT slave on a network interface, and writes none; the slave goes to PRE-OP. "udp"
// in place of the interface is EtherCAT in UDP on this machine, where emulated_slaves may be. A slave with SDO
// information says how many bytes the object has: data of another size are not used.
//     sdo_read eth0 1018 1
//     sdo_read udp 1018 1
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/net/link/raw_link.hpp>
#include <jauscat/net/link/run_master.hpp>
#include <jauscat/net/link/udp_link.hpp>
#include <jauscat/text/hex.hpp>

#include <array>
#include <iostream>
#include <optional>
#include <string>

namespace ethercat = jauscat::ethercat;
namespace net = jauscat::net;

constexpr const char* usage = "sdo_read INTERFACE INDEX SUBINDEX, both numbers in hex\n";

/// Bytes of the object by the slave's SDO information; none where it has no answer, or where the size may change.
template <ethercat::link Link>
std::optional<std::size_t> described_size(Link& link, ethercat::master& master, std::uint16_t station,
                                          std::uint16_t index, std::uint8_t subindex) {
    std::array<std::byte, 1024> answer{};
    ethercat::entry_answer entry{};
    const auto asked = net::run(link, master, master.describe_entry(station, index, subindex, 0, answer));
    if (!asked || !jauscat::wire::decode_prefix(entry, std::span{answer}.first(asked.size))) return {};
    const bool may_be_shorter = entry.data_type >= 0x0009 && entry.data_type <= 0x000F; // strings and domains
    if (entry.bits == 0 || may_be_shorter) return {};
    return (entry.bits + 7u) / 8;
}

template <ethercat::link Link> int read(Link& link, std::uint16_t index, std::uint8_t subindex) {
    ethercat::master master;
    // Each call of the master starts a job; run() sends and receives until it is done.
    const auto done = [&](bool started, const char* job) {
        const auto result = net::run(link, master, started);
        if (result) return true;
        std::cout << job << ": " << describe(result.error);
        if (const auto detail = describe_detail(result); !detail.empty()) // of the slave's abort or AL status code
            std::cout << ", " << detail << " (" << jauscat::text::hex_number(result.detail, 8) << ')';
        std::cout << '\n';
        return false;
    };

    constexpr std::uint16_t station = 1;
    std::array<std::byte, 1024> buffer{};
    if (!done(master.scan(), "scan") || !done(master.bring_up(0, station), "to PRE-OP")) return 1;
    const auto size = described_size(link, master, station, index, subindex);
    if (!done(master.upload(station, index, subindex, buffer, {.size = size}), "upload from station address 1")) {
        if (master.result().error == ethercat::master_errc::size_mismatch && size)
            std::cout << "the slave's SDO information says " << *size << " bytes\n";
        return 1;
    }
    std::cout << jauscat::text::hex(std::span{buffer}.first(master.result().size)) << '\n';
    return 0;
}

int main(int argc, char** argv) try {
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
