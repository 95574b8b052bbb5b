// Counts what the whole test program takes from the heap.
#pragma once

#include <cstddef>

namespace test {

/// Calls of operator new since the program started.
std::size_t allocations() noexcept;

} // namespace test
