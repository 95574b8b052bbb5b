// The process data of a slave: its PDOs and the objects in them.
#pragma once
#include "ecat/ring.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace ecat {

struct mapped_entry {
    std::uint16_t index{}; ///< 0: a gap
    std::uint8_t subindex{};
    std::uint8_t bits{};
    std::uint16_t type{}; ///< code of ETG.1000.6, table 64; 0: not known
    std::string name{};
    std::size_t bit_offset{}; ///< in the SyncManager
};

struct assigned_pdo {
    std::uint16_t index{};
    std::string name{};
    bool is_output{};
    std::uint8_t sync_manager{}; ///< 255: not assigned
    std::vector<mapped_entry> entries{};
    std::string error{}; ///< it is assigned, and the slave does not have it
};

struct process_objects {
    const char* source{}; ///< "coe": objects 1C10h and up, for all SyncManagers that have one; "sii"
    std::vector<assigned_pdo> pdos{};
};

/// From the slave's objects where it `may_use_mailbox` and has CoE, else from the SII. A slave in INIT is in PRE-OP
/// meanwhile.
[[nodiscard]] process_objects read_process_objects(ring& on, std::uint16_t position, bool may_use_mailbox);

} // namespace ecat
