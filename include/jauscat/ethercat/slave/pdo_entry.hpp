// One entry of an emulated slave's process data, and the places where these stand in its memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace jauscat::ethercat {

/// A mapped object. Entries follow each other without gaps, bit by bit, the lowest bit first.
struct pdo_entry {
    std::uint16_t index{}; ///< of the object; 0: a gap
    std::uint8_t subindex{};
    std::uint8_t bits{};      ///< 1 to 255
    std::uint8_t data_type{}; ///< of `data_types`
    std::string_view name{};
};

/// Bytes of process data.
[[nodiscard]] constexpr std::size_t process_data_size(std::span<const pdo_entry> entries) noexcept {
    std::size_t bits = 0;
    for (const auto& each : entries) bits += each.bits;
    return (bits + 7) / 8;
}

/// Areas of an emulated slave's process data, each with three buffers, as in a slave controller.
namespace process_memory {
inline constexpr std::uint16_t outputs = 0x1C00;
inline constexpr std::uint16_t inputs = 0x2400;
inline constexpr std::size_t max_outputs = (0x2400 - 0x1C00) / 3; ///< bytes
inline constexpr std::size_t max_inputs = (0x3000 - 0x2400) / 3;  ///< bytes
inline constexpr std::size_t max_entries = 128;                   ///< of one direction
} // namespace process_memory

/// The entries that an emulated slave can have: all, unless there are too many.
[[nodiscard]] constexpr std::span<const pdo_entry> pdo_contents(std::span<const pdo_entry> entries) noexcept {
    return entries.first(std::min(entries.size(), process_memory::max_entries));
}

/// The PDOs of an emulated slave: one of each direction, fixed.
namespace pdo_indices {
inline constexpr std::uint16_t outputs = 0x1600;
inline constexpr std::uint16_t inputs = 0x1A00;
} // namespace pdo_indices

/// SyncManagers of an emulated slave.
namespace manager_numbers {
inline constexpr std::size_t mailbox_out = 0;
inline constexpr std::size_t mailbox_in = 1;
inline constexpr std::size_t outputs = 2;
inline constexpr std::size_t inputs = 3;
} // namespace manager_numbers

/// Control bytes of these SyncManagers.
namespace manager_controls {
inline constexpr std::uint8_t mailbox_out = 0x26; ///< mailbox, written by the master, interrupt for the slave
inline constexpr std::uint8_t mailbox_in = 0x22;  ///< mailbox, read by the master, interrupt for the slave
inline constexpr std::uint8_t outputs = 0x64;     ///< buffers, written by the master, interrupt for the slave, watchdog
inline constexpr std::uint8_t inputs = 0x20;      ///< buffers, read by the master, interrupt for the slave
} // namespace manager_controls

} // namespace jauscat::ethercat
