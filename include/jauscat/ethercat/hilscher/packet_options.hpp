// Options for the execution of packets that the packets do not carry.
#pragma once

#include <jauscat/ethercat/master/sdo_options.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>

#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// A slave that belongs to the bus.
struct bus_slave {
    std::uint16_t position{};  ///< in the ring, from 0
    std::uint16_t station{};   ///< its station address, ulNodeId of the packets
    identity_check identity{}; ///< the required identity
};

/// Options for the execution of packets.
struct packet_options {
    download_options download{};
    /// The slaves of the bus, at most 16, as in a card's configuration. Without it the bus consists of the slaves that
    /// the master has brought up, or that a bus scan has found: they are then stations 1, 2, 3 in the order of the
    /// ring. Must not be moved while a packet is executed.
    std::span<const bus_slave> slaves{};
    /// Refuses headers that a card would not take: an ulDest other than 20h or a channel, 1 to 4 (unknown_destination),
    /// an ulDestId (unknown_destination_id), a place in a sequence in ulExt (invalid_extension). Not for packets of the
    /// seed table, which has parts of the JAUS header there.
    bool check_header{};
};

} // namespace jauscat::ethercat
