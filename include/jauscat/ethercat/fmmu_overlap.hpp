// Which bits of a logical datagram an FMMU maps to which bits of a slave's memory. ETG.1000.4, clause 6.6.
#pragma once

#include <jauscat/schema/ethercat/esc_registers.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// The part of a datagram that an FMMU maps: `bits` bits, from `data_bit` of the datagram's data and from `memory_bit`
/// of the slave's memory on. Bit 0 is the lowest of the first byte.
struct fmmu_overlap {
    std::uint64_t data_bit{};
    std::uint64_t memory_bit{};
    std::uint64_t bits{}; ///< 0: the FMMU has nothing to do with the datagram

    /// Whole bytes on both sides.
    [[nodiscard]] constexpr bool is_bytes() const noexcept { return (data_bit | memory_bit | bits) % 8 == 0; }
    /// The bytes of memory that are touched.
    [[nodiscard]] constexpr std::size_t memory_start() const noexcept {
        return static_cast<std::size_t>(memory_bit / 8);
    }
    [[nodiscard]] constexpr std::size_t memory_size() const noexcept {
        return static_cast<std::size_t>((memory_bit + bits + 7) / 8) - memory_start();
    }
    /// Where the mapped bits begin in the first of these bytes.
    [[nodiscard]] constexpr std::uint64_t bit_in_memory() const noexcept { return memory_bit % 8; }
};

/// What `mapping` maps of a datagram with `size` bytes of data at the logical address `address`.
[[nodiscard]] constexpr fmmu_overlap overlap_of(const fmmu& mapping, std::uint32_t address, std::size_t size) noexcept {
    if (!mapping.enable || mapping.length == 0 || size == 0) return {};
    const auto begin = std::uint64_t{mapping.logical_start} * 8 + mapping.first_bit;
    const auto end = (std::uint64_t{mapping.logical_start} + mapping.length - 1) * 8 + mapping.last_bit + 1;
    const auto first = std::max(begin, std::uint64_t{address} * 8);
    const auto last = std::min(end, (std::uint64_t{address} + size) * 8);
    if (first >= last) return {};
    return {.data_bit = first - std::uint64_t{address} * 8,
            .memory_bit = std::uint64_t{mapping.physical_start} * 8 + mapping.physical_bit + (first - begin),
            .bits = last - first};
}

/// Copies `count` bits and leaves the others of `to` alone.
constexpr void copy_bits(std::span<const std::byte> from, std::uint64_t from_bit, std::span<std::byte> to,
                         std::uint64_t to_bit, std::uint64_t count) noexcept {
    for (std::uint64_t i = 0; i != count; ++i) {
        const auto in = from_bit + i, out = to_bit + i;
        const bool set = (from[in / 8] >> (in % 8) & std::byte{1}) != std::byte{};
        const auto mask = std::byte{1} << (out % 8);
        to[out / 8] = set ? to[out / 8] | mask : to[out / 8] & ~mask;
    }
}

} // namespace jauscat::ethercat
