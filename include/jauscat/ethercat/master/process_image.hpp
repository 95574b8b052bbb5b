// Layout of all process data in the logical address space, and the expected working counter.
#pragma once

#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>
#include <jauscat/schema/ethercat/frame.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// Bytes of process data of one slave, outputs and inputs together: they travel in one datagram.
inline constexpr std::size_t max_slave_process_data = max_datagram_data;
/// The same for a slave that cannot do LRW: its data travel twice in a frame, in an LWR and an LRD. 737.
inline constexpr std::size_t max_slave_process_data_without_lrw = max_datagrams_size / 2 - datagram_overhead;

/// The addresses in it are those behind master_config::logical_base. Each slave has a place of its own: its outputs,
/// then its inputs.
struct process_image {
    std::size_t size{};         ///< bytes
    std::uint16_t read_write{}; ///< working counter of a complete cycle: 1 for inputs, 2 for outputs of each slave
    std::uint16_t write{};      ///< slaves with outputs
    std::uint16_t read{};       ///< slaves with inputs
    bool no_lrw{};              ///< one slave or more cannot do LRW

    /// Of all slaves that have process data.
    [[nodiscard]] static constexpr process_image of(std::span<const slave_record> slaves) noexcept {
        process_image image{};
        for (const auto& slave : slaves) image.add(slave.process_data);
        return image;
    }
    /// With another slave.
    constexpr void add(const process_place& place) noexcept {
        if (place.size() == 0) return;
        size = std::max<std::size_t>(size, place.end());
        write = static_cast<std::uint16_t>(write + (place.output_size != 0));
        read = static_cast<std::uint16_t>(read + (place.input_size != 0));
        read_write = static_cast<std::uint16_t>(read + 2 * write);
        no_lrw = no_lrw || place.no_lrw;
    }
};

} // namespace jauscat::ethercat
