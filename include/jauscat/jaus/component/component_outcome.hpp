// Outcome of a message to a component, for counters and logs.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace jauscat::jaus {

/// Outcome of a message; more detailed than message_outcome.
enum class component_outcome : std::uint8_t {
    handled,                      ///< done
    deferred,                     ///< executed later, see component::finish
    stopped_on_invalid_emergency, ///< handled or deferred: a Set Emergency with an unexpected code or body
    refused,                      ///< understood, but not done
    malformed,                    ///< the body does not decode
    unknown,
    not_controller,  ///< a command that only the controller may send, from another
    not_ready,       ///< a command that is obeyed in Ready only, in another state
    repeated,        ///< a repeat: acknowledged again, and dropped
    pending,         ///< a repeat of a message that is being executed: dropped, its sender is answered at the end
    no_capacity,     ///< requests acknowledgement, and cannot be remembered: dropped, its sender will retry
    acknowledgement, ///< the ACK or NAK that one of the component's own messages waited for
    experimental,    ///< marked as experimental, with a code of the standard: not the standard's message, and refused
    unmatched_acknowledgement, ///< an ACK or NAK that no message waits for: late, or strange
};
inline constexpr std::size_t component_outcome_count = 14;

/// The outcome in one line, for logs.
[[nodiscard]] constexpr std::string_view describe(component_outcome what) noexcept {
    constexpr std::array<std::string_view, component_outcome_count> lines{
        "handled",
        "deferred: executed and acknowledged later",
        "stopped, although the code of the Set Emergency does not say so",
        "refused",
        "malformed: the body does not decode",
        "unknown message",
        "refused: the sender does not control the component",
        "refused: the component is not ready",
        "repeated: acknowledged again and dropped",
        "repeated while it is executed: dropped",
        "dropped: no place left to remember what was acknowledged (option remembered)",
        "acknowledgement of an own message",
        "refused: experimental: the header says that it is not the standard's message of this code",
        "acknowledgement that no message waits for"};
    const auto place = static_cast<std::size_t>(what);
    return place < lines.size() ? lines[place] : "unknown";
}

} // namespace jauscat::jaus
