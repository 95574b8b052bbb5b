// The slaves of an EtherCAT master, as the configuration names them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace jauscat::net {

/// An object that is written to a slave each time it is brought up, in PRE-OP (a start-up SDO, an init command).
struct start_up_sdo {
    std::uint16_t index{};
    std::uint8_t subindex{};
    std::vector<std::byte> data{}; ///< as on the wire, little-endian
    std::size_t line{};            ///< where the file declares it
    friend bool operator==(const start_up_sdo&, const start_up_sdo&) = default;
};

/// A slave by name, and how it is known. Another slave in its place is refused. At least one of the values that
/// identify it is given; what is not given is not compared.
struct slave_entry {
    std::string name{}; ///< unique on its bus, without blanks

    std::optional<std::uint16_t> position{};       ///< in the ring, from 0
    std::optional<std::uint16_t> alias{};          ///< configured station alias, 1 to 65535
    std::optional<std::uint16_t> identification{}; ///< explicit device identification, 1 to 65535
    std::optional<std::uint32_t> vendor{};         ///< object 1018h
    std::optional<std::uint32_t> product{};
    std::optional<std::uint32_t> revision{};
    std::optional<std::uint32_t> serial{};
    std::string esi{}; ///< ESI file with the vendor, the product and the revision; empty: none

    bool is_optional{}; ///< it may be absent, and come later (hot connect)
    std::vector<start_up_sdo> start_up{};
    std::size_t line{};
    friend bool operator==(const slave_entry&, const slave_entry&) = default;
};

} // namespace jauscat::net
