// What the simulation reads of messages, and the command that each Set Wrench Effort carries.
#pragma once

#include "simulation/generator.hpp"
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/jaus/manipulator.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/wire/raw.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>

namespace simulation {

namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;
using bytes = std::span<const std::byte>;

/// What a motion command is known by, everywhere: two of its efforts hold it. 0: no effort at all.
using command_number = std::uint32_t;

inline constexpr std::uint32_t efforts_of_one = 32'000; ///< values that one effort is used for

/// The integers of a Set Wrench Effort or a report that say `command`; the rotational effort around z says whether it
/// turns something: 0 only for command 0.
template <class Message> [[nodiscard]] wire::raw<Message> efforts_of(command_number command) {
    using T = Message;
    wire::raw<T> made{};
    const auto low = static_cast<std::int16_t>(command % efforts_of_one);
    const auto high = static_cast<std::int16_t>(command / efforts_of_one % efforts_of_one);
    made.template set<&T::propulsive_linear_effort_x>(low);
    made.template set<&T::propulsive_linear_effort_y>(high);
    made.template set<&T::propulsive_rotational_effort_z>(static_cast<std::int16_t>(command == 0 ? 0 : 1));
    return made;
}
/// The inverse; nothing for a message without these efforts.
template <class Message> [[nodiscard]] std::optional<command_number> command_of(const wire::raw<Message>& efforts) {
    using T = Message;
    const auto& low = efforts.template get<&T::propulsive_linear_effort_x>();
    const auto& high = efforts.template get<&T::propulsive_linear_effort_y>();
    if (!low || !high || *low < 0 || *high < 0) return std::nullopt;
    return static_cast<std::uint32_t>(*high) * efforts_of_one + static_cast<std::uint32_t>(*low);
}
template <class Message> [[nodiscard]] std::optional<command_number> command_in(bytes body) {
    wire::raw<Message> efforts{};
    if (!wire::decode(efforts, body)) return std::nullopt;
    return command_of<Message>(efforts);
}
/// Whether the efforts that a report has are those of `command`.
[[nodiscard]] inline bool are_of(const wire::raw<jaus::report_wrench_effort>& told, command_number command) {
    using T = jaus::report_wrench_effort;
    const auto right = efforts_of<T>(command);
    const auto is_right = [](const auto& one, const auto& other) { return !one || one == other; };
    return is_right(told.get<&T::propulsive_linear_effort_x>(), right.get<&T::propulsive_linear_effort_x>()) &&
           is_right(told.get<&T::propulsive_linear_effort_y>(), right.get<&T::propulsive_linear_effort_y>()) &&
           is_right(told.get<&T::propulsive_rotational_effort_z>(), right.get<&T::propulsive_rotational_effort_z>());
}
/// A query for none, all or some efforts, or for more than there are.
[[nodiscard]] inline jaus::query_wrench_effort query_of_efforts(generator& random) {
    constexpr std::array<std::uint16_t, 3> vectors{0, 0x0FFF, 0xFFFF};
    const auto which = random.below(6);
    return {which < vectors.size() ? vectors[which] : static_cast<std::uint16_t>(random.below(0x1000))};
}
/// The same of efforts in percent.
template <class Message> [[nodiscard]] std::optional<command_number> command_of_percents(const Message& efforts) {
    const auto raw = [](const std::optional<double>& percent) {
        return static_cast<std::uint32_t>(std::lround(percent.value_or(0) * 32767 / 100));
    };
    return raw(efforts.propulsive_linear_effort_y) * efforts_of_one + raw(efforts.propulsive_linear_effort_x);
}

/// The joints of an arm: their drives' units of velocity, and how a velocity says which command it is.
inline constexpr std::size_t most_joints = 8;
inline constexpr double increments_per_radian = 10'000;
inline constexpr std::uint32_t numbers_of_commands = 4'000;
inline constexpr std::int32_t least_velocity = 200, velocity_step = 4; ///< increments/s
inline constexpr command_number no_command = 0xFFFF'FFFF;              ///< of a motion that is that of no command

/// Increments/s of a joint; joints have different ones, so that none is mistaken for another. A joint always turns the
/// same way: through rest, it would get a new velocity in two steps.
[[nodiscard]] constexpr std::int32_t velocity_of(command_number command, std::size_t joint) noexcept {
    if (command == 0) return 0;
    const auto number = (command + 1009 * static_cast<std::uint32_t>(joint)) % numbers_of_commands;
    const auto velocity = least_velocity + velocity_step * static_cast<std::int32_t>(number);
    return joint % 2 == 0 ? velocity : -velocity;
}
/// The inverse; nothing for a velocity that is that of no command.
[[nodiscard]] constexpr std::optional<command_number> command_of_velocity(std::int32_t velocity,
                                                                          std::size_t joint) noexcept {
    const std::int32_t above = (velocity < 0 ? -velocity : velocity) - least_velocity + 1;
    if (above < 0 || above % velocity_step > 2) return std::nullopt;
    const auto number = static_cast<std::uint32_t>(above / velocity_step);
    const auto shift = 1009 * static_cast<std::uint32_t>(joint) % numbers_of_commands;
    const auto command = (number + numbers_of_commands - shift) % numbers_of_commands;
    if (number >= numbers_of_commands || command == 0 || (joint % 2 == 0) != (velocity > 0)) return std::nullopt;
    return command;
}
[[nodiscard]] inline jaus::basic_set_joint_velocities<most_joints> velocities_of(command_number command,
                                                                                 std::size_t joints) {
    jaus::basic_set_joint_velocities<most_joints> made{};
    for (std::size_t i = 0; i != joints; ++i)
        static_cast<void>(made.joint_velocity.push_back(velocity_of(command, i) / increments_per_radian));
    return made;
}
/// The command of a Set Wrench Effort or Set Joint Velocities; nothing where it is malformed.
[[nodiscard]] inline std::optional<command_number> motion_in(std::uint16_t code, bytes body) {
    if (code == jaus::command_code_of<jaus::set_wrench_effort>) return command_in<jaus::set_wrench_effort>(body);
    jaus::basic_set_joint_velocities<most_joints> wanted{};
    if (!wire::decode(wanted, body) || wanted.joint_velocity.size() == 0) return std::nullopt;
    const auto first = static_cast<std::int32_t>(std::lround(wanted.joint_velocity[0] * increments_per_radian));
    return first == 0 ? std::optional<command_number>{0} : command_of_velocity(first, 0);
}

[[nodiscard]] inline std::string hex(std::uint16_t code) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "%04Xh", unsigned{code});
    return text.data();
}
[[nodiscard]] inline std::string text(jaus::primary_status_code state) {
    constexpr std::array names{"Initialize", "Ready", "Standby", "Shutdown", "Failure", "Emergency"};
    const auto i = static_cast<std::size_t>(state);
    return i < names.size() ? names[i] : "state " + std::to_string(i);
}

[[nodiscard]] constexpr std::uint64_t digest_of(bytes content) noexcept {
    std::uint64_t digest = 0xCBF29CE484222325;
    for (const std::byte b : content) digest = (digest ^ std::to_integer<std::uint64_t>(b)) * 0x100000001B3;
    return digest;
}

/// What moves something, of the codes that the simulation uses.
[[nodiscard]] constexpr bool moves(std::uint16_t code) noexcept {
    return code == jaus::command_code_of<jaus::set_wrench_effort> ||
           code == jaus::command_code_of<jaus::set_joint_velocities>;
}
/// What brings to rest.
[[nodiscard]] constexpr bool stops(std::uint16_t code) noexcept {
    return code == jaus::command_code_of<jaus::set_emergency> || code == jaus::command_code_of<jaus::standby> ||
           code == jaus::command_code_of<jaus::shutdown>;
}

} // namespace simulation
