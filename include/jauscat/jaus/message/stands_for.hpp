// Addresses with wildcards (255).
#pragma once
#include <jauscat/jaus/message/message.hpp>

namespace jauscat::jaus {

/// Whether the address `levels`, in which 255 matches every ID, matches the component `one`.
[[nodiscard]] constexpr bool stands_for(const address& levels, const address& one) noexcept {
    const auto same = [](std::uint8_t all, std::uint8_t octet) { return all == 255 || all == octet; };
    return same(levels.subsystem, one.subsystem) && same(levels.node, one.node) &&
           same(levels.component, one.component) && same(levels.instance, one.instance);
}

} // namespace jauscat::jaus
