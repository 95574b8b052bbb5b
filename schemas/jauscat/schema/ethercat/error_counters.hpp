// Counters of errors that an EtherCAT slave controller keeps. ET1100 data sheet, section II, 0300h to 0313h.
#pragma once

#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::ethercat {

/// Of one port.
struct port_error_counters {
    std::uint8_t invalid_frames{}; ///< with a wrong check sequence, too long or too short
    std::uint8_t receive_errors{}; ///< of the physical layer
    friend constexpr bool operator==(const port_error_counters&, const port_error_counters&) = default;

    struct schema : wire::items {
        using T = port_error_counters;
        using type = layout<
            field<&T::invalid_frames, u8>,
            field<&T::receive_errors, u8>>;
    };
};

/// Each counts up to 255 and stays there. A write to the registers of one kind sets them to 0.
struct error_counters {
    std::array<port_error_counters, 4> ports{};
    std::array<std::uint8_t, 4> forwarded_errors{}; ///< of each port: frames that a slave before had marked as invalid
    std::uint8_t processing_errors{};               ///< of the EtherCAT processing unit
    std::uint8_t pdi_errors{};                      ///< of the interface to the slave's application
    std::array<std::uint8_t, 4> lost_links{};       ///< of each port
    friend constexpr bool operator==(const error_counters&, const error_counters&) = default;

    struct schema : wire::items {
        using T = error_counters;
        using type = layout<
            array<&T::ports>,
            array<&T::forwarded_errors, u8>,
            field<&T::processing_errors, u8>,
            field<&T::pdi_errors, u8>,
            bit_fields<u16le, reserved<16>>,
            array<&T::lost_links, u8>>;
    };
};

} // namespace jauscat::ethercat
