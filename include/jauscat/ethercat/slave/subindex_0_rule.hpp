// The rule of PDO mapping and assignment objects in an emulated slave: their entries can be written only while subindex
// 0, the number of entries in force, is 0. ETG.1000.6; real slaves enforce it for any entries.
#pragma once

#include <jauscat/schema/ethercat/coe.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace jauscat::ethercat {

/// Keeps subindex 0 of the objects 1600h to 17FFh, 1A00h to 1BFFh and 1C10h to 1C2Fh: one byte each, 1 at power-on.
class subindex_0_rule {
  public:
    subindex_0_rule() noexcept { entries_.fill(1); }

    /// Whether the rule is about the object `index`.
    [[nodiscard]] static constexpr bool covers(std::uint16_t index) noexcept { return place_of(index) != none; }
    /// Its subindex 0. Only for an object that the rule covers, as the functions below.
    [[nodiscard]] std::uint8_t entries(std::uint16_t index) const noexcept { return entries_[place_of(index)]; }
    void set_entries(std::uint16_t index, std::uint8_t count) noexcept { entries_[place_of(index)] = count; }

    /// `subindex_0_not_zero` if the object must not be written now, else `none`. For any index and subindex.
    [[nodiscard]] abort_code refusal(std::uint16_t index, std::uint8_t subindex) const noexcept {
        const bool fixed = covers(index) && subindex != 0 && entries(index) != 0;
        return fixed ? abort_code::subindex_0_not_zero : abort_code::none;
    }

  private:
    struct range {
        std::uint16_t first{}, last{};
    };
    static constexpr std::array ranges{range{0x1600, 0x17FF}, range{0x1A00, 0x1BFF}, range{0x1C10, 0x1C2F}};
    static constexpr std::size_t none = 0x200 + 0x200 + 0x20; // objects covered

    static constexpr std::size_t place_of(std::uint16_t index) noexcept {
        std::size_t before = 0;
        for (const auto& [first, last] : ranges) {
            if (index >= first && index <= last) return before + index - first;
            before += std::size_t{last} - first + 1;
        }
        return none;
    }

    std::array<std::uint8_t, none> entries_{};
};

} // namespace jauscat::ethercat
