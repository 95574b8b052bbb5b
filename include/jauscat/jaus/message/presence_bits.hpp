// The presence vector that a message can have.
#pragma once
#include <jauscat/schema/jaus/command_code.hpp>
#include <jauscat/wire/schema.hpp>

namespace jauscat::jaus {

/// The presence bits that a message's layout defines; 0 where it has no presence vector.
template <wire::message T>
inline constexpr std::uint32_t presence_bits_of = [] {
    std::uint32_t bits = 0;
    wire::layout_of<T>::all_items([&]<class Item>() {
        if constexpr (requires { Item::known_bits; }) bits = static_cast<std::uint32_t>(Item::known_bits);
        return bits == 0;
    });
    return bits;
}();

} // namespace jauscat::jaus
