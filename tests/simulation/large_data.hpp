// Large data sets whose bytes all follow from one number, so that the receiver can tell whether it has them all.
#pragma once

#include "simulation/generator.hpp"

#include <cstddef>
#include <cstring>
#include <optional>
#include <span>
#include <vector>

namespace simulation {

inline constexpr std::uint16_t large_code = 0xD117;

/// What is in front of the filling.
struct large_head {
    std::uint64_t identity{};
    std::uint32_t size{};
};

inline void fill_large(std::span<std::byte> body, std::uint64_t identity) {
    const large_head head{identity, static_cast<std::uint32_t>(body.size())};
    std::memcpy(body.data(), &head.identity, 8);
    std::memcpy(body.data() + 8, &head.size, 4);
    generator filling{identity};
    for (std::size_t i = 12; i < body.size(); i += 8) {
        const auto word = filling.next();
        std::memcpy(body.data() + i, &word, std::min<std::size_t>(8, body.size() - i));
    }
}
/// The identity; nothing where a byte is not that of the data set.
[[nodiscard]] inline std::optional<std::uint64_t> identity_of_large(std::span<const std::byte> body) {
    if (body.size() < 12) return std::nullopt;
    large_head head{};
    std::memcpy(&head.identity, body.data(), 8);
    std::memcpy(&head.size, body.data() + 8, 4);
    if (head.size != body.size()) return std::nullopt;
    generator filling{head.identity};
    for (std::size_t i = 12; i < body.size(); i += 8) {
        const auto word = filling.next();
        if (std::memcmp(body.data() + i, &word, std::min<std::size_t>(8, body.size() - i)) != 0) return std::nullopt;
    }
    return head.identity;
}

} // namespace simulation
