// Which bits of a logical datagram an FMMU maps to which bits of a slave's memory. ETG.1000.4, clause 6.6.
#pragma once

#include <jauscat/base/compilation.hpp>
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
    [[nodiscard]] JAUSCAT_CONSTEXPR std::size_t memory_start() const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR std::size_t memory_size() const noexcept;
    /// Where the mapped bits begin in the first of these bytes.
    [[nodiscard]] constexpr std::uint64_t bit_in_memory() const noexcept { return memory_bit % 8; }
};

/// What `mapping` maps of a datagram with `size` bytes of data at the logical address `address`.
[[nodiscard]] JAUSCAT_CONSTEXPR fmmu_overlap overlap_of(const fmmu& mapping, std::uint32_t address,
                                                        std::size_t size) noexcept;

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/slave/impl/fmmu_overlap.ipp>
#endif
