// Where an object is in a slave's process data.
#pragma once

#include <jauscat/schema/ethercat/pdo.hpp>

#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// An object that is looked for in a slave's process data, and its place there.
struct process_object {
    std::uint16_t index{};
    std::uint8_t subindex{};
    bool is_output{};
    std::uint8_t bits{};       ///< 0: the process data do not have it
    std::uint32_t first_bit{}; ///< in the slave's outputs or inputs
    std::uint8_t manager{};    ///< number of the SyncManager that carries it

    /// None is found.
    static constexpr void forget(std::span<process_object> all) noexcept {
        for (auto& each : all) each.bits = 0;
    }
    /// The entry begins at this bit of its SyncManager. Where several have an object, the first counts.
    static constexpr void note(std::span<process_object> all, const pdo_mapping& entry, bool is_output,
                               std::uint8_t manager, std::uint32_t first_bit) noexcept {
        for (auto& each : all) {
            if (each.bits != 0 || each.is_output != is_output || each.index != entry.index ||
                each.subindex != entry.subindex)
                continue;
            each.bits = entry.bits;
            each.first_bit = first_bit;
            each.manager = manager;
        }
    }
};

} // namespace jauscat::ethercat
