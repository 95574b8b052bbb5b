// Lines of a node's log that keep coming, such as one for each heartbeat to a peer that is not running.
#pragma once
#include <chrono>
#include <map>
#include <string>
#include <string_view>

namespace example {

/// Remembers lines, so that one that keeps coming is shown once.
class repeated_lines {
  public:
    /// Whether the line has not come within the last three seconds: heartbeats go each second.
    bool is_new(std::string_view line) {
        constexpr auto patience = std::chrono::seconds{3};
        const auto now = std::chrono::steady_clock::now();
        std::erase_if(last_, [&](const auto& known) { return now - known.second > patience; });
        return last_.insert_or_assign(std::string{line}, now).second;
    }

  private:
    std::map<std::string, std::chrono::steady_clock::time_point> last_{}; ///< when each came
};

} // namespace example
