// Bits that begin and end anywhere in a byte: FMMUs and complete access move them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// Copies `count` bits and leaves the others of `to` alone. Bit 0 is the lowest of the first byte.
constexpr void copy_bits(std::span<const std::byte> from, std::uint64_t from_bit, std::span<std::byte> to,
                         std::uint64_t to_bit, std::uint64_t count) noexcept {
    for (std::uint64_t i = 0; i != count; ++i) {
        const auto in = from_bit + i, out = to_bit + i;
        const bool set = (from[static_cast<std::size_t>(in / 8)] >> (in % 8) & std::byte{1}) != std::byte{};
        const auto mask = std::byte{1} << (out % 8);
        auto& byte = to[static_cast<std::size_t>(out / 8)];
        byte = set ? byte | mask : byte & ~mask;
    }
}

} // namespace jauscat::ethercat
