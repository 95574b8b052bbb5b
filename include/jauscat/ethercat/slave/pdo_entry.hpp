// The process data of an emulated slave: entries, PDOs, and the places where these stand in its memory.
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

/// The PDOs of an emulated slave, unless its description divides its entries: one of each direction.
namespace pdo_indices {
inline constexpr std::uint16_t outputs = 0x1600;
inline constexpr std::uint16_t inputs = 0x1A00;
} // namespace pdo_indices

/// One of several PDOs of a direction.
struct pdo_part {
    std::uint16_t index{};   ///< of its mapping object: 1600h to 17FFh outputs, 1A00h to 1BFFh inputs
    std::uint16_t entries{}; ///< number of the direction's entries in it; the last PDO has all that are left
    std::string_view name{};
};

/// A PDO with its entries.
struct described_pdo {
    std::uint16_t index{};
    std::string_view name{};
    std::span<const pdo_entry> entries{};
};

/// The PDOs of one direction: its entries, divided. Fixed, and all assigned.
class pdo_list {
  public:
    static constexpr std::size_t max_size = 16;

    /// Without `parts`, `whole` is the only one. Both and `entries` must outlive this.
    constexpr pdo_list(std::span<const pdo_entry> entries, std::span<const pdo_part> parts,
                       const pdo_part& whole) noexcept
        : entries_{pdo_contents(entries)},
          parts_{parts.empty() ? std::span{&whole, 1} : parts.first(std::min(parts.size(), max_size))} {}

    /// 0 for a direction without entries.
    [[nodiscard]] constexpr std::size_t size() const noexcept { return entries_.empty() ? 0 : parts_.size(); }
    /// `n` is below `size()`.
    [[nodiscard]] constexpr described_pdo operator[](std::size_t n) const noexcept {
        auto rest = entries_;
        for (const auto& each : parts_.first(n)) rest = rest.subspan(std::min<std::size_t>(each.entries, rest.size()));
        const auto count = n + 1 == parts_.size() ? rest.size() : std::min<std::size_t>(parts_[n].entries, rest.size());
        return {parts_[n].index, parts_[n].name, rest.first(count)};
    }

  private:
    std::span<const pdo_entry> entries_;
    std::span<const pdo_part> parts_;
};

/// SyncManagers of an emulated slave with a mailbox.
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
