// What the process takes of the machine's memory, over time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <malloc.h>
#include <unistd.h>
#include <vector>

namespace soak {

/// Blocks of 128 KiB and more go back to the system when they are freed. By default glibc keeps what it has seen freed
/// once, so that the process would show its largest need ever, not what it holds.
inline void large_blocks_go_back() { ::mallopt(M_MMAP_THRESHOLD, 128 << 10); }

/// The resident set, looked at often. It goes up and down with the data sets that are under way; so the lowest of each
/// window is what counts: a leak raises it.
class resident_memory {
  public:
    /// Bytes now.
    static std::size_t peek() {
        auto* const file = std::fopen("/proc/self/statm", "r");
        if (file == nullptr) return 0;
        unsigned long all{}, resident{};
        const int got = std::fscanf(file, "%lu %lu", &all, &resident);
        std::fclose(file);
        return got == 2 ? resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) : 0;
    }
    void look() { lowest_ = std::min(lowest_, peek()); }
    void next_window() {
        windows_.push_back(lowest_);
        lowest_ = std::numeric_limits<std::size_t>::max();
        look();
    }
    /// Of the window that is not over.
    [[nodiscard]] std::size_t lowest() const { return lowest_; }
    /// After the warm-up: of the second window, or the only one.
    [[nodiscard]] std::size_t first() const {
        return windows_.empty() ? lowest_ : windows_[std::min<std::size_t>(1, windows_.size() - 1)];
    }

  private:
    std::size_t lowest_{std::numeric_limits<std::size_t>::max()};
    std::vector<std::size_t> windows_{};
};

} // namespace soak
