// Lines of a node's log that keep coming, such as one for each heartbeat to a peer that is not running.
#pragma once
#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace example {

/// Remembers lines, so that one that keeps coming is shown once, and again as the 100th, the 1000th and so on.
class repeated_lines {
  public:
    /// How often the line has come, if it is to be shown; nothing where it has come within the last three seconds:
    /// heartbeats go each second.
    std::optional<std::uint64_t> shown(std::string_view line) {
        constexpr auto patience = std::chrono::seconds{3};
        const auto now = std::chrono::steady_clock::now();
        std::erase_if(known_, [&](const auto& one) { return now - one.second.last > patience; });
        auto& it = known_[std::string{line}];
        it.last = now;
        if (++it.count == 1) return 1;
        if (it.count != it.told) return std::nullopt;
        it.told *= 10;
        return it.count;
    }
    /// The line as it is shown.
    static std::string text(std::string_view line, std::uint64_t times) {
        return std::string{line} + (times == 1 ? "" : " (" + std::to_string(times) + " times)");
    }

  private:
    struct entry {
        std::chrono::steady_clock::time_point last{}; ///< time of the line
        std::uint64_t count{};                        ///< how often
        std::uint64_t told{100};                      ///< it is shown again when it has come so often
    };
    std::map<std::string, entry> known_{};
};

} // namespace example
