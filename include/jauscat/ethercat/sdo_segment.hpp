// A segment of an SDO transfer. Downloads and uploads use the same format.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/schema/ethercat/coe.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// Data bytes of the shortest segment: fewer are filled up with zeros, and the header counts those.
inline constexpr std::size_t min_segment_data = 7;
/// Bytes of a segment besides its data.
inline constexpr std::size_t segment_overhead = wire::max_size<sdo_segment_header>;

/// Bytes of a segment with `size` bytes of data, header included: at least 8.
[[nodiscard]] constexpr std::size_t segment_size(std::size_t size) noexcept {
    return segment_overhead + std::max(size, min_segment_data);
}

/// Writes a segment (or, without data, the answer to one) to the front of `out`, which holds `segment_size` bytes, and
/// returns its size. The header's count of unused bytes is filled in where `data` are to be counted.
[[nodiscard]] JAUSCAT_FUNCTION std::size_t encode_segment(sdo_segment_header header, std::span<const std::byte> data,
                                                          std::span<std::byte> out) noexcept;

/// The data of the segment `segment` with the decoded header `header`. Segments that are not filled up, as some senders
/// leave them, are accepted.
[[nodiscard]] JAUSCAT_FUNCTION std::span<const std::byte> segment_data(const sdo_segment_header& header,
                                                                       std::span<const std::byte> segment) noexcept;

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/impl/sdo_segment.ipp>
#endif
