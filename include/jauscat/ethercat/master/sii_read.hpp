// Reads words of a slave's SII, 4 or 8 bytes per access. The caller assigns the SII to the master before, and back
// afterwards: take_sii, give_sii.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// Adds the datagrams that assign the SII to the master: by force, then without.
JAUSCAT_FUNCTION void take_sii(frame_builder& frame, std::uint16_t station) noexcept;
/// Adds the datagram that assigns the SII to the slave's application.
JAUSCAT_FUNCTION void give_sii(frame_builder& frame, std::uint16_t station) noexcept;

/// State machine: `request` adds the datagram of the present step, `reply` takes its return. Two frames for each read.
class sii_read {
  public:
    sii_read() noexcept = default;
    /// `into.size()` bytes from the word `address` on. `into` stays in place until the read is done.
    sii_read(std::uint32_t address, std::span<std::byte> into) noexcept : word_{address}, rest_{into} {}

    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }

    JAUSCAT_FUNCTION void request(frame_builder& frame, std::uint16_t station) const noexcept;

    /// `datagram` was executed.
    JAUSCAT_FUNCTION progress reply(const datagram_view& datagram, time_point now,
                                    const master_config& config) noexcept;

  private:
    JAUSCAT_FUNCTION progress fail(const master_error& error) noexcept;

    std::uint32_t word_{}; // to be read next
    std::span<std::byte> rest_{};
    bool started_{};
    timeout timeout_{};
    master_result<> result_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/sii_read.ipp>
#endif
