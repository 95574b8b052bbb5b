// Objects for fuzzing that describe themselves: entries of whole bytes and of bits, one that lies about its size, and a
// mapping object.
#pragma once
#include "objects.hpp"
#include <jauscat/ethercat/slave/object_dictionary.hpp>

#include <algorithm>
#include <array>
#include <optional>

namespace fuzz {

/// What is read and written is `objects`' business but for sizes: an entry has as many bytes as its description says,
/// and 2004h:2 more.
class described_objects : public objects {
  public:
    static constexpr std::array<std::uint16_t, 5> indices{0x1601, 0x2000, 0x2002, 0x2004, 0x7FFE};

    jauscat::ethercat::object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        using jauscat::ethercat::abort_code;
        const auto entry = describe(index, subindex);
        if (!entry) return {.error = abort_code::no_subindex};
        on_access();
        const std::size_t size = (entry->bits + 7u) / 8 + (index == 0x2004 && subindex == 2 ? 1 : 0);
        if (size > out.size()) return {.error = abort_code::exceeds_mailbox};
        std::ranges::fill(out.first(size), static_cast<std::byte>(subindex));
        return {.size = size};
    }

    [[nodiscard]] std::uint16_t next_index(std::uint16_t after) const noexcept {
        const auto next = std::ranges::upper_bound(indices, after);
        return next == indices.end() ? std::uint16_t{} : *next;
    }
    [[nodiscard]] std::optional<jauscat::ethercat::object_info> describe(std::uint16_t index) const noexcept {
        if (!std::ranges::binary_search(indices, index)) return {};
        return jauscat::ethercat::object_info{.highest_subindex = static_cast<std::uint8_t>(index & 0xFF),
                                              .code = jauscat::ethercat::object_code::record,
                                              .name = "a name that is longer than the smallest mailbox",
                                              .complete_access = index != 0x7FFE};
    }
    [[nodiscard]] std::optional<jauscat::ethercat::entry_info> describe(std::uint16_t index,
                                                                        std::uint8_t subindex) const noexcept {
        const auto object = describe(index);
        if (!object || subindex > object->highest_subindex) return {};
        auto access = jauscat::ethercat::accessible_always;
        access.write_op = subindex != 1;
        const auto bits = static_cast<std::uint16_t>(subindex == 0 ? 8 : subindex * 13 % 48 + 1);
        return jauscat::ethercat::entry_info{.data_type = 7, .bits = bits, .access = access, .name = "entry"};
    }
};

} // namespace fuzz
