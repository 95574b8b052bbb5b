// Saturating addition of times.
#pragma once
#include <chrono>

namespace jauscat::jaus {

/// `now + by`; the last instant that there is where that lies beyond it, so a time of nanoseconds::max() is never over.
/// `by`: 0 or more.
[[nodiscard]] constexpr std::chrono::nanoseconds saturating_add(std::chrono::nanoseconds now,
                                                                std::chrono::nanoseconds by) noexcept {
    using std::chrono::nanoseconds;
    return now > nanoseconds::max() - by ? nanoseconds::max() : now + by;
}

} // namespace jauscat::jaus
