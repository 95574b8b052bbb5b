// Literal bytes for expectations, in constant expressions too.
#pragma once
#include <array>
#include <cstddef>
#include <span>

namespace support {

/// `bytes(0x05, 0x04)`: an array of std::byte.
constexpr auto bytes(auto... values) noexcept {
    return std::array<std::byte, sizeof...(values)>{static_cast<std::byte>(values)...};
}

constexpr bool equal(std::span<const std::byte> a, std::span<const std::byte> b) noexcept {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i != a.size(); ++i)
        if (a[i] != b[i]) return false;
    return true;
}

} // namespace support
