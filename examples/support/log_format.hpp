// How a program writes its log.
#pragma once
#include <cstdint>
#include <string>

namespace example {

enum class log_format : std::uint8_t {
    text, ///< lines for an operator
    json, ///< one object a line: docs/log-events.md
};

/// Set before the program starts threads.
inline log_format& chosen_log_format() {
    static log_format chosen{};
    return chosen;
}
/// The member `program` of each event. Set before the program starts threads.
inline std::string& program_name() {
    static std::string name;
    return name;
}

} // namespace example
