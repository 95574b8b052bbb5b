// Constant-time lookup of a 16-bit code in a list that is known at compile time.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace jauscat::wire {

/// The place of a code in `Codes` (a constexpr array of std::uint16_t, in any order, without repeats), in constant
/// time.
// Command codes come in runs that share their high byte: a row for each high byte, and in it a run of low bytes. About
// 500 bytes for the 158 codes of RA 3.3, two loads and three comparisons for a lookup. A list of a few codes is
// searched one by one, which is as fast and needs no tables.
template <const auto& Codes> class code_index {
  public:
    /// The place of a code that is not in the list.
    static constexpr std::size_t npos = static_cast<std::size_t>(-1);

    /// The place of `code` counted from 0, or npos.
    [[nodiscard]] static constexpr std::size_t find(std::uint16_t code) noexcept {
        if constexpr (searches)
            return slot(code) - 1;
        else
            return std::size_t{places[slot(code)]} - 1u; // 0 becomes npos
    }

    /// The place of `code` in a table that `by_slot` has made: one step less than `find` and a table in its order.
    [[nodiscard]] static constexpr std::size_t slot(std::uint16_t code) noexcept {
        if constexpr (searches) {
            for (std::size_t i = 0; i != Codes.size(); ++i)
                if (Codes[i] == code) return i + 1;
            return 0;
        } else {
            const std::size_t all = code, high = all >> 8; // not narrower: each conversion is an instruction
            if (high >= rows.size()) return 0;
            const row& r = rows[high];
            const std::size_t at = (all & 0xFFu) - r.first;
            return at > r.span ? 0 : r.start + at;
        }
    }
    /// The values of all codes by their slots, and `none` in the slots that no code of the list has.
    template <class T>
    [[nodiscard]] static constexpr auto by_slot(const std::array<T, Codes.size()>& values, T none) noexcept {
        std::array<T, slot_count> made{};
        made.fill(none);
        for (std::size_t i = 0; i != Codes.size(); ++i) made[slot(Codes[i])] = values[i];
        return made;
    }

  private:
    static_assert(Codes.size() < 0xFFFF, "code_index: too many codes");
    static constexpr bool searches = Codes.size() <= 8;
    struct row {
        std::uint16_t start{}; // where the run begins in `places`
        std::uint8_t first{};  // its lowest low byte
        std::uint8_t span{};   // its highest, less the lowest
    };
    static constexpr std::size_t high_count = [] { // one more than the highest high byte
        std::size_t count = 1;
        for (const std::uint16_t code : Codes)
            if (code >> 8 >= static_cast<int>(count)) count = (code >> 8) + 1u;
        return count;
    }();
    static constexpr std::array<row, high_count> rows = [] { // one that no code has begins at place 0, which is none
        std::array<row, high_count> made{};
        for (const std::uint16_t code : Codes) {
            const auto low = static_cast<std::uint8_t>(code & 0xFF);
            row& r = made[code >> 8];
            const bool empty = r.start == 0;
            const auto last = empty || low > r.first + r.span ? low : static_cast<std::uint8_t>(r.first + r.span);
            r.first = empty || low < r.first ? low : r.first;
            r.span = static_cast<std::uint8_t>(last - r.first);
            r.start = 1;
        }
        std::uint16_t start = 1;
        for (row& r : made)
            if (r.start != 0) {
                r.start = start;
                start = static_cast<std::uint16_t>(start + r.span + 1);
            }
        return made;
    }();
    static constexpr std::size_t slot_count = [] { // the first is that of all unknown codes
        std::size_t count = 1;
        if (searches) return Codes.size() + 1;
        for (const row& r : rows) count += r.start != 0 ? r.span + std::size_t{1} : 0;
        return count;
    }();
    using place = std::conditional_t<(Codes.size() < 255), std::uint8_t, std::uint16_t>;
    static constexpr std::array<place, slot_count> places = [] { // the place plus 1; 0 for none
        std::array<place, slot_count> made{};
        for (std::size_t i = 0; i != Codes.size(); ++i) {
            const row& r = rows[Codes[i] >> 8];
            made[r.start + (Codes[i] & 0xFFu) - r.first] = static_cast<place>(i + 1);
        }
        return made;
    }();
    static constexpr bool distinct = [] {
        for (std::size_t i = 0; i != Codes.size(); ++i)
            if (find(Codes[i]) != i) return false;
        return true;
    }();
    static_assert(distinct, "code_index: a code is listed twice");
};

} // namespace jauscat::wire
