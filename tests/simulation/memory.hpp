// What the program holds of the heap.
#pragma once

#include <cstddef>

namespace simulation {

/// Bytes that this thread has taken from the heap and not given back.
[[nodiscard]] std::ptrdiff_t live_bytes() noexcept;

} // namespace simulation
