// The points of the contract of docs/safety.md, and what breaks one.
#pragma once

#include "simulation/generator.hpp"

#include <array>
#include <string>
#include <string_view>

namespace simulation {

/// docs/safety.md has their words.
enum class contract : std::uint8_t { s1, s2, s3, s4, s5, s6, s7, s8, memory, limits };

[[nodiscard]] constexpr std::string_view name_of(contract point) noexcept {
    constexpr std::array<std::string_view, 10> names{
        "S1: what is acknowledged was executed, once",
        "S2: stop orders come first, and are repeated until they are confirmed",
        "S3: at rest in time when who commands is lost",
        "S4: no old value is given as current",
        "S5: moved only when Ready, and only by the controller",
        "S6: every wait is bounded",
        "S7: what is delivered is what was sent",
        "S8: what cannot be known is not running",
        "memory does not grow",
        "motors keep the limits of their joints, and are not switched off while they turn"};
    return names[static_cast<std::size_t>(point)];
}

/// The first breach of the contract in a run.
struct violation {
    contract point{};
    time at{};
    std::uint8_t who{};      ///< the actor
    std::uint8_t whom{};     ///< the other actor concerned, or 0
    std::uint32_t message{}; ///< the number of the message concerned, or 0
    std::string expected{};
    std::string found{};
};

} // namespace simulation
