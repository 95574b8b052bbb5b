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

/// Bytes of process data that one datagram carries, and so a cycle: outputs and inputs of all slaves together.
inline constexpr std::size_t max_process_image = max_datagram_data;
/// The same where a frame carries them in two datagrams, LWR and LRD, because a slave cannot do LRW: 737.
inline constexpr std::size_t max_process_image_without_lrw = max_datagrams_size / 2 - datagram_overhead;

/// The addresses in it are those behind master_config::logical_base. Each slave has a place of its own: its outputs,
/// then its inputs.
struct process_image {
    std::size_t size{};         ///< bytes
    std::uint16_t read_write{}; ///< working counter of a complete LRW: 1 for inputs, 2 for outputs of each slave
    std::uint16_t write{};      ///< of a complete LWR
    std::uint16_t read{};       ///< of a complete LRD
    bool no_lrw{};              ///< one slave cannot do LRW: the image goes by LWR and LRD

    /// Of all slaves that have process data.
    [[nodiscard]] static constexpr process_image of(std::span<const slave_record> slaves) noexcept {
        process_image image{};
        for (const auto& slave : slaves) {
            const auto& place = slave.process_data;
            if (place.size() == 0) continue;
            image.size = std::max<std::size_t>(image.size, place.output_address + place.size());
            const bool outputs = place.output_size != 0, inputs = place.input_size != 0;
            image.write = static_cast<std::uint16_t>(image.write + outputs);
            image.read = static_cast<std::uint16_t>(image.read + inputs);
            image.no_lrw = image.no_lrw || place.no_lrw;
        }
        image.read_write = static_cast<std::uint16_t>(image.read + 2 * image.write);
        return image;
    }
};

} // namespace jauscat::ethercat
