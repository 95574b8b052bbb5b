// The functions of fmmu_overlap.
#pragma once
#include <jauscat/ethercat/slave/fmmu_overlap.hpp>

namespace jauscat::ethercat {

JAUSCAT_CONSTEXPR std::size_t fmmu_overlap::memory_start() const noexcept {
    return static_cast<std::size_t>(memory_bit / 8);
}

JAUSCAT_CONSTEXPR std::size_t fmmu_overlap::memory_size() const noexcept {
    return static_cast<std::size_t>((memory_bit + bits + 7) / 8) - memory_start();
}

JAUSCAT_CONSTEXPR fmmu_overlap overlap_of(const fmmu& mapping, std::uint32_t address, std::size_t size) noexcept {
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
