// The functions of sdo_segment.
#pragma once
#include <jauscat/ethercat/sdo_segment.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION std::size_t encode_segment(sdo_segment_header header, std::span<const std::byte> data,
                                            std::span<std::byte> out) noexcept {
    const std::size_t size = segment_size(data.size());
    const bool carries_data = header.specifier == sdo_specifier::download_segment_request;
    if (carries_data) header.unused = static_cast<std::uint8_t>(size - segment_overhead - data.size());
    const auto room = out.subspan(wire::encode(header, out)->size()).first(size - segment_overhead);
    std::ranges::fill(std::ranges::copy(data, room.begin()).out, room.end(), std::byte{});
    return size;
}

JAUSCAT_FUNCTION std::span<const std::byte> segment_data(const sdo_segment_header& header,
                                                         std::span<const std::byte> segment) noexcept {
    const auto data = segment.subspan(segment_overhead);
    if (data.size() > min_segment_data) return data;
    return data.first(std::min(data.size(), min_segment_data - header.unused));
}

} // namespace jauscat::ethercat
