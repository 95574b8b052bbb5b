// The slaves of an EtherCAT master, as the configuration names them.
#pragma once

#include <chrono>
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

/// SYNC signals of a slave's distributed clock (ESI: Dc/OpMode), as in ethercat::sync_settings.
struct sync_entry {
    std::uint16_t assign_activate{0x0300}; ///< registers 0980h and 0981h: SYNC0
    std::uint32_t cycle{};                 ///< of SYNC0, in ns; 0: the period of the process data
    std::uint32_t sync1_delay{};           ///< of SYNC1 after SYNC0, in ns
    std::int32_t shift{};                  ///< of SYNC0 from the multiples of its cycle, in ns; positive: later
    friend bool operator==(const sync_entry&, const sync_entry&) = default;
};

/// How long a slave may take, 1 ms or more, as ethercat::slave_timeouts. Nothing: what the ESI file says, else the
/// times of the master.
struct timeout_entry {
    using milliseconds = std::chrono::duration<std::uint16_t, std::milli>;

    std::optional<milliseconds> pre_op{};          ///< from INIT to PRE-OP
    std::optional<milliseconds> safe_op_op{};      ///< from PRE-OP to SAFE-OP, and from there to OP
    std::optional<milliseconds> back_to_init{};    ///< to INIT or PRE-OP
    std::optional<milliseconds> back_to_safe_op{}; ///< from OP to SAFE-OP
    std::optional<milliseconds> mailbox{};         ///< one request and its answer
    friend bool operator==(const timeout_entry&, const timeout_entry&) = default;
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
    /// While its process data are exchanged.
    std::optional<sync_entry> sync{};
    std::string sync_mode{}; ///< the same by the name of an OpMode of the ESI file; empty: `sync` has them
    timeout_entry timeouts{};
    std::size_t line{};
    friend bool operator==(const slave_entry&, const slave_entry&) = default;
};

} // namespace jauscat::net
