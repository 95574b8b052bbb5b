// Rules for commands: required sender and state, for each command of RA 3.3 and for all others.
#pragma once
#include <jauscat/wire/code_index.hpp>

#include <array>
#include <cstdint>

namespace jauscat::jaus {

/// When a message is obeyed. docs/safety.md has the reason for each command.
enum class command_rule : std::uint8_t {
    open,       ///< from any sender, in every state
    controlled, ///< in every state; if there is a controller, only from it
    moving,     ///< in Ready only; if there is a controller, only from it
};

/// A command and its rule.
struct ruled_command {
    std::uint16_t command_code{}; ///< of command class
    command_rule rule{};          ///< when it is obeyed
};

/// All commands of RA 3.3, and 0404h. The RA's list of those that only the controller may send has Set Emergency
/// (0006h) as well; here it is never refused: who sees the danger must be able to stop the machine.
// clang-format off
inline constexpr std::array<ruled_command, 59> command_rules = [] {
    using enum command_rule;
    return std::array<ruled_command, 59>{{
        {0x0001, controlled}, // Set Component Authority
        {0x0002, controlled}, // Shutdown
        {0x0003, controlled}, // Standby
        {0x0004, controlled}, // Resume
        {0x0005, controlled}, // Reset
        {0x0006, open},       // Set Emergency
        {0x0007, controlled}, // Clear Emergency
        {0x0008, open},       // Create Service Connection
        {0x0009, open},       // Confirm Service Connection
        {0x000A, open},       // Activate Service Connection
        {0x000B, open},       // Suspend Service Connection
        {0x000C, open},       // Terminate Service Connection
        {0x000D, open},       // Request Component Control
        {0x000E, controlled}, // Release Component Control
        {0x000F, open},       // Confirm Component Control
        {0x0010, open},       // Reject Component Control
        {0x0011, controlled}, // Set Time
        {0x01F0, open},       // Create Event
        {0x01F1, open},       // Update Event
        {0x01F2, open},       // Cancel Event
        {0x01F3, open},       // Confirm Event Request
        {0x01F4, open},       // Reject Event Request
        {0x0200, controlled}, // Set Data Link State
        {0x0201, controlled}, // Set Data Link Select
        {0x0202, controlled}, // Set Selected Data Link State
        {0x0404, moving},     // Set Velocity State
        {0x0405, moving},     // Set Wrench Effort
        {0x0406, moving},     // Set Discrete Devices
        {0x0407, moving},     // Set Global Vector
        {0x0408, moving},     // Set Local Vector
        {0x040A, moving},     // Set Travel Speed
        {0x040C, moving},     // Set Global Waypoint
        {0x040D, moving},     // Set Local Waypoint
        {0x040F, moving},     // Set Global Path Segment
        {0x0410, moving},     // Set Local Path Segment
        {0x0601, moving},     // Set Joint Efforts
        {0x0602, moving},     // Set Joint Positions
        {0x0603, moving},     // Set Joint Velocities
        {0x0604, moving},     // Set Tool Point
        {0x0605, moving},     // Set End-Effector Pose
        {0x0606, moving},     // Set End-Effector Velocity State
        {0x0607, moving},     // Set Joint Motion
        {0x0608, moving},     // Set End-Effector Path Motion
        {0x0801, moving},     // Set Camera Pose
        {0x0802, moving},     // Select Camera
        {0x0805, moving},     // Set Camera Capabilities
        {0x0806, moving},     // Set Camera Format Options
        {0x0A20, moving},     // Create Vector Knowledge Store Objects
        {0x0A21, moving},     // Set Vector Knowledge Store Feature Class Metadata
        {0x0A24, open},       // Terminate Vector Knowledge Store Data Transfer
        {0x0A25, moving},     // Delete Vector Knowledge Store Objects
        {0x0D01, moving},     // Set Payload Data Element
        {0x0E00, moving},     // Spool Mission
        {0x0E01, moving},     // Run Mission
        {0x0E02, controlled}, // Abort Mission
        {0x0E03, controlled}, // Pause Mission
        {0x0E04, moving},     // Resume Mission
        {0x0E05, moving},     // Remove Messages
        {0x0E06, moving},     // Replace Messages
    }};
}();
// clang-format on

namespace detail {
inline constexpr auto ruled_codes = [] {
    std::array<std::uint16_t, command_rules.size()> codes{};
    for (std::size_t i = 0; i != codes.size(); ++i) codes[i] = command_rules[i].command_code;
    return codes;
}();
} // namespace detail

/// The rule for a message. Queries and reports are open. A command that is not known here counts as one that moves
/// something, and so does a private message (D000h to FFFFh), see control_options::harmless.
[[nodiscard]] constexpr command_rule rule_of(std::uint16_t command_code) noexcept {
    constexpr std::uint16_t first_query = 0x2000, after_reports = 0x6000;
    if (command_code >= first_query && command_code < after_reports) return command_rule::open;
    using codes = wire::code_index<detail::ruled_codes>;
    const std::size_t place = codes::find(command_code);
    return place == codes::npos ? command_rule::moving : command_rules[place].rule;
}

} // namespace jauscat::jaus
