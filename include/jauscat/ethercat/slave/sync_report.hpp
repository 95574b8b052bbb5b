// How an emulated slave is synchronized: what its objects 1C32h and 1C33h say.
#pragma once

#include <cstdint>

namespace jauscat::ethercat {

/// The synchronization type of objects 1C32h and 1C33h, subindex 1.
enum class sync_type : std::uint16_t {
    free_run = 0,
    sync_manager = 1, ///< by the event of its own SyncManager
    sync0 = 2,
    sync1 = 3,
};

/// See slave::synchronization.
struct sync_report {
    sync_type type{};
    std::uint32_t sync0_cycle{}; ///< ns; subindices 2 and 10
    std::uint16_t missed{};      ///< SYNC0 in OP that found no new outputs, at most 65535; subindex 11
    bool error{};                ///< the last SYNC0 in OP was one of these; subindex 32
};

} // namespace jauscat::ethercat
