// Motion commands that supersede older ones of their kind, and how a queued one is merged.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/schema/jaus/environment_sensor.hpp>
#include <jauscat/schema/jaus/manipulator.hpp>
#include <jauscat/schema/jaus/payload.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>
#include <jauscat/wire/raw.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::bridging {

/// Commands that set what an actuator does from now on, so that a newer one of the same sender replaces one that has
/// not been executed. Waypoints, path segments and motions with a number are not among them: each of those counts.
inline constexpr std::array<std::uint16_t, 10> superseding_commands{
    jaus::command_code_of<jaus::set_wrench_effort>,
    jaus::command_code_of<jaus::set_global_vector>,
    jaus::command_code_of<jaus::set_local_vector>,
    jaus::command_code_of<jaus::set_travel_speed>,
    jaus::command_code_of<jaus::set_joint_efforts>,
    jaus::command_code_of<jaus::set_joint_positions>,
    jaus::command_code_of<jaus::set_joint_velocities>,
    jaus::command_code_of<jaus::set_end_effector_pose>,
    jaus::command_code_of<jaus::set_end_effector_velocity_state>,
    jaus::command_code_of<jaus::set_camera_pose>,
};

[[nodiscard]] JAUSCAT_CONSTEXPR bool is_superseding(std::uint16_t command_code) noexcept;

namespace detail {

// Integers as on the wire: a field that both carry or only the older one carries keeps its exact value.
template <class Message>
[[nodiscard]] constexpr std::optional<std::size_t>
merge_fields(std::span<const std::byte> older, std::span<const std::byte> newer, std::span<std::byte> out) noexcept {
    wire::raw<Message> merged{}, latest{};
    if (!wire::decode(merged, older) || !wire::decode(latest, newer)) return std::nullopt;
    [&]<auto... Members>(wire::key_list<Members...>) {
        const auto copy = [](const auto& from, auto& to) {
            if constexpr (requires { from.has_value(); }) {
                if (from) to = from;
            } else {
                to = from;
            }
        };
        (copy(latest.template slot<Members>(), merged.template slot<Members>()), ...);
    }(typename wire::layout_of<Message>::keys{});
    const auto encoded = wire::encode(merged, out);
    return encoded ? std::optional<std::size_t>{encoded->size()} : std::nullopt;
}

} // namespace detail

/// Merges two commands into `out`, which may be the memory of `older`; returns the size. Fields under a presence vector
/// that `newer` omits are those of `older`. Empty if a body does not decode or `out` is too small; `out` is then
/// unchanged.
[[nodiscard]] JAUSCAT_CONSTEXPR std::optional<std::size_t> merge(std::uint16_t command_code,
                                                                 std::span<const std::byte> older,
                                                                 std::span<const std::byte> newer,
                                                                 std::span<std::byte> out) noexcept;

} // namespace jauscat::bridging

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/bridge/impl/supersede.ipp>
#endif
