// The drives of an arm as the actuator of a component, for bridge::serve.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/bridge/joints/joint_part.hpp>
#include <jauscat/bridge/process_part.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {

inline constexpr std::size_t max_joints = 8;

/// Set Joint Positions, Velocities and Efforts and the three reports, for 1 to 8 joints, one axis of a CiA 402 drive
/// each: see bridging::joint_part. Throws `std::invalid_argument` for another number.
///
///     bridge.serve({.component = 54}, {shoulder, elbow}, jauscat::joint_drives(joints));
[[nodiscard]] inline std::unique_ptr<bridging::process_part>
joint_drives(std::span<const bridging::joint_options> joints) {
    std::unique_ptr<bridging::process_part> made;
    const auto make = [&]<std::size_t Joints>() {
        if (joints.size() != Joints) return;
        std::array<bridging::joint_options, Joints> all{};
        std::ranges::copy(joints, all.begin());
        made = std::make_unique<bridging::joint_part<Joints>>(all);
    };
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (make.template operator()<I + 1>(), ...);
    }(std::make_index_sequence<max_joints>{});
    if (!made) throw std::invalid_argument{"joint_drives: a component has 1 to 8 joints"};
    return made;
}

} // namespace JAUSCAT_WAY
} // namespace jauscat
