// Descriptions of objects and entries, as SDO information reports them.
#pragma once

#include <jauscat/schema/ethercat/data_types.hpp>
#include <jauscat/schema/ethercat/sdo_information.hpp>

#include <cstdint>
#include <string_view>

namespace jauscat::ethercat {

/// One object. A variable has one entry, subindex 0; in arrays and records subindex 0 is the highest subindex.
struct object_info {
    std::uint16_t data_type{}; ///< of `data_types`; of an array, that of its entries
    std::uint8_t highest_subindex{};
    object_code code{};
    std::string_view name{};
    /// An array or a record that has all entries from 0 to the highest subindex, each of a size that does not change:
    /// they can be read and written together.
    bool complete_access{};
};

/// One entry of an object.
struct entry_info {
    std::uint16_t data_type{}; ///< of `data_types`
    std::uint16_t bits{};      ///< the most it can hold
    entry_access access{};
    std::string_view name{};
};

/// Access in every state that has a mailbox.
inline constexpr entry_access readable_always{.read_pre_op = true, .read_safe_op = true, .read_op = true};
/// Written in PRE-OP, SAFE-OP and OP.
inline constexpr entry_access writable_always{.write_pre_op = true, .write_safe_op = true, .write_op = true};
/// Read and written in PRE-OP, SAFE-OP and OP.
inline constexpr entry_access accessible_always{.read_pre_op = true,
                                                .read_safe_op = true,
                                                .read_op = true,
                                                .write_pre_op = true,
                                                .write_safe_op = true,
                                                .write_op = true};

/// Whether it may be written in any state.
[[nodiscard]] constexpr bool is_writable(const entry_access& access) noexcept {
    return access.write_pre_op || access.write_safe_op || access.write_op;
}
/// Whether it may be read in any state.
[[nodiscard]] constexpr bool is_readable(const entry_access& access) noexcept {
    return access.read_pre_op || access.read_safe_op || access.read_op;
}

/// Subindex 0 of an array or a record that cannot change.
inline constexpr entry_info highest_subindex_info{
    .data_type = data_types::unsigned8, .bits = 8, .access = readable_always, .name = "Highest subindex"};

} // namespace jauscat::ethercat
