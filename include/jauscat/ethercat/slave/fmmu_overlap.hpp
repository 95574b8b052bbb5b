// Which bits of a logical datagram an FMMU maps to which bits of a slave's memory. ETG.1000.4, clause 6.6.
#pragma once

#include <jauscat/schema/ethercat/esc_registers.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace jauscat::ethercat {

/// The part of a datagram that an FMMU maps: `bits` bits, from `data_bit` of the datagram's data and from `memory_bit`
/// of the slave's memory on. Bit 0 is the lowest of the first byte.
struct fmmu_overlap {
    std::uint64_t data_bit{};
    std::uint64_t memory_bit{};
    std::uint64_t bits{}; ///< 0: the FMMU has nothing to do with the datagram

    /// Whole bytes on both sides.
    [[nodiscard]] constexpr bool is_bytes() const noexcept { return (data_bit | memory_bit | bits) % 8 == 0; }
    /// The byte of the datagram's data in which the mapped bits begin.
    [[nodiscard]] constexpr std::size_t data_start() const noexcept { return static_cast<std::size_t>(data_bit / 8); }
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

} // namespace jauscat::ethercat
