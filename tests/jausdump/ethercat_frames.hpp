// EtherCAT frames with mailbox messages, in hex, for captures.
#pragma once
#include "program.hpp"

#include <cstdint>
#include <string>

namespace dump_test {

/// `1b15` is written `151b`.
inline std::string little(std::size_t number) {
    return jauscat::test::to_hex(std::array{static_cast<std::byte>(number), static_cast<std::byte>(number >> 8)});
}

enum : std::uint8_t { aprd = 1, apwr = 2, fprd = 4, fpwr = 5, bwr = 8 };

/// One datagram, from its header on, as it passes the tap.
struct datagram {
    std::uint8_t cmd{};
    std::uint16_t adp{}, ado{};
    std::string data{};
    unsigned working_counter{};
    std::uint8_t index{};

    [[nodiscard]] std::string bytes() const {
        return jauscat::test::to_hex(std::array{static_cast<std::byte>(cmd), static_cast<std::byte>(index)}) +
               little(adp) + little(ado) + little(from_hex(data).size()) + "0000" + data + little(working_counter);
    }
};

/// What stands behind the EtherType: one datagram.
inline std::string ring_frame(const datagram& one) {
    const auto bytes = one.bytes();
    return little(from_hex(bytes).size() | 0x1000U) + bytes;
}
inline std::string ethernet_ring_frame(const datagram& one) {
    return "ffffffffffff 020000000001 88a4" + ring_frame(one);
}

/// A CoE message in a mailbox of 64 bytes.
inline std::string mailbox(unsigned counter, const std::string& coe) {
    auto bytes = from_hex(little(from_hex(coe).size()) + "0000 00" +
                          jauscat::test::to_hex(std::array{static_cast<std::byte>(counter << 4 | 3)}) + coe);
    bytes.resize(64);
    return jauscat::test::to_hex(bytes);
}

/// To the mailbox of a station and from it, once the slave has executed it.
inline datagram write_to(std::uint16_t station, unsigned counter, const std::string& coe) {
    return {.cmd = fpwr, .adp = station, .ado = 0x1000, .data = mailbox(counter, coe), .working_counter = 1};
}
inline datagram read_from(std::uint16_t station, unsigned counter, const std::string& coe) {
    return {.cmd = fprd, .adp = station, .ado = 0x1100, .data = mailbox(counter, coe), .working_counter = 1};
}

/// Runs jausdump with --ethercat over a capture of these datagrams, each in an Ethernet frame of its own.
inline outcome run_ring(const std::string& arguments, const std::vector<datagram>& datagrams) {
    const scratch files;
    std::vector<std::string> frames;
    for (const auto& each : datagrams) frames.push_back(ethernet_ring_frame(each));
    write_capture(files / "ring", link_ethernet, frames);
    return run("--ethercat " + arguments + " " + (files / "ring"));
}

} // namespace dump_test
