// Digest of a body, to compare bodies.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace jauscat::net::detail {

/// FNV-1a of 64 bits, eight bytes at a time, and the size. Two different bodies have equal digests with a probability
/// of 2^-64. It is not a cryptographic digest.
inline std::uint64_t digest_of(std::span<const std::byte> body) noexcept {
    constexpr std::uint64_t prime = 0x100000001B3;
    std::uint64_t digest = 0xCBF29CE484222325 ^ body.size();
    while (!body.empty()) {
        std::uint64_t word{};
        const auto part = body.first(std::min(body.size(), sizeof word));
        std::memcpy(&word, part.data(), part.size());
        digest = (digest ^ word) * prime;
        digest ^= digest >> 32U;
        body = body.subspan(part.size());
    }
    return digest;
}

} // namespace jauscat::net::detail
