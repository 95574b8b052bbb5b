// Names of EtherCAT slaves.
#pragma once
#include <jauscat/text/hex.hpp>

#include <cstdint>
#include <string>

namespace jausdump {

/// A slave as datagrams address it.
struct slave_address {
    bool by_position{};     ///< its station address is not known: `number` is its place in the ring, from 0
    std::uint16_t number{}; ///< station address

    /// The station address; 0 where it is not known.
    [[nodiscard]] std::uint16_t station() const { return by_position ? std::uint16_t{} : number; }
    friend bool operator<(const slave_address& a, const slave_address& b) {
        return a.by_position != b.by_position ? b.by_position : a.number < b.number;
    }
};

/// "station 2", "station 4097 (0x1001)", "slave at position 0".
inline std::string to_text(const slave_address& slave) {
    if (slave.by_position) return "slave at position " + std::to_string(slave.number);
    const auto station = "station " + std::to_string(slave.number);
    return slave.number < 255 ? station : station + " (" + jauscat::text::hex_number(slave.number, 4) + ")";
}

} // namespace jausdump
