// Emulated EtherCAT slave controller: processes passing frames. esc_memory.hpp has its memory, slave.hpp the
// application behind it.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/ethercat/slave/copy_bits.hpp>
#include <jauscat/ethercat/slave/esc_memory.hpp>
#include <jauscat/ethercat/slave/fmmu_overlap.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// A slave controller: its memory, and the commands that reach it.
class esc : public esc_memory {
  public:
    /// Does to a frame what the controller does while it passes: executes the datagrams that address this slave, counts
    /// positions, and marks the source address as locally administered. Leaves anything but EtherCAT untouched.
    JAUSCAT_CONSTEXPR void pass(std::span<std::byte> frame) noexcept;
    /// The same where the slave has a clock: the frame begins to pass it `now`.
    JAUSCAT_CONSTEXPR void pass(std::span<std::byte> frame, time_point now) noexcept;

  private:
    JAUSCAT_CONSTEXPR void execute(const basic_datagram<std::byte>& d) noexcept;

    JAUSCAT_CONSTEXPR static void count(const basic_datagram<std::byte>& d, unsigned counter) noexcept;

    // However many FMMUs take part, the slave counts once for each direction.
    JAUSCAT_CONSTEXPR void execute_logical(const basic_datagram<std::byte>& d, bool reads, bool writes) noexcept;

    [[nodiscard]] JAUSCAT_CONSTEXPR bool read_mapped(const fmmu_overlap& overlap, std::span<std::byte> data) noexcept;

    [[nodiscard]] JAUSCAT_CONSTEXPR bool write_mapped(const fmmu_overlap& overlap,
                                                      std::span<const std::byte> data) noexcept;

    JAUSCAT_CONSTEXPR static std::uint32_t logical_address(const datagram_header& header) noexcept;

    [[nodiscard]] JAUSCAT_CONSTEXPR bool is_station(std::uint16_t address) const noexcept;
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/slave/impl/esc.ipp>
#endif
