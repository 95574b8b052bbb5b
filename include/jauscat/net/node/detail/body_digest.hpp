// A digest of a body, by which two of them are told apart.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace jauscat::net::detail {

/// FNV-1a of 64 bits, eight bytes at a time, and the size. Two bodies that differ have equal digests with a chance of
/// 2^-64; it protects against no one who wants that.
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
