// Places that one peer may take of those of all.
#pragma once
#include <jauscat/schema/jaus/header.hpp>

#include <cstddef>

namespace jauscat::jaus {

/// Three quarters, so that none takes the places of all others; all where there are fewer than 4.
[[nodiscard]] constexpr std::size_t peer_share(std::size_t places) noexcept {
    return places < 4 ? places : places - places / 4;
}

[[nodiscard]] constexpr bool are_of_one_node(const address& one, const address& other) noexcept {
    return one.subsystem == other.subsystem && one.node == other.node;
}

} // namespace jauscat::jaus
