// Counts what the whole test program takes from the heap.
#pragma once

#include <cstddef>

namespace support {

/// Calls of operator new since the program started.
std::size_t allocations() noexcept;

} // namespace support
