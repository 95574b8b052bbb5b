// Constant-time lookup of a 16-bit code in a list that is known at compile time.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace jauscat::wire {

/// The place of a code in `Codes` (a constexpr array of std::uint16_t, in any order, without repeats), in constant
/// time.
// Command codes come in runs that share their high byte, so two small tables do: a page for each high byte in use, and
// in it a run of low bytes. About 400 bytes for the 158 codes of RA 3.3, two loads and two comparisons for a lookup. A
// list of a few codes is searched one by one, which is as fast and needs no tables.
template <const auto& Codes> class code_index {
  public:
    static constexpr std::size_t npos = static_cast<std::size_t>(-1);

    /// The place of `code` counted from 0, or npos.
    [[nodiscard]] static constexpr std::size_t find(std::uint16_t code) noexcept {
        if constexpr (Codes.size() <= 8) {
            for (std::size_t i = 0; i != Codes.size(); ++i)
                if (Codes[i] == code) return i;
            return npos;
        } else {
            const std::size_t high = code >> 8;
            if (high >= page_of.size()) return npos;
            const page& p = pages[page_of[high]];
            const unsigned low = code & 0xFFu;
            if (low < p.first || low > p.last) return npos;
            return std::size_t{places[p.start + low - p.first]} - 1u; // 0 becomes npos
        }
    }

  private:
    static_assert(Codes.size() < 0xFFFF, "code_index: too many codes");
    struct page {
        std::uint8_t first{1}, last{}; // low bytes; none
        std::uint16_t start{};         // where they begin in `places`
    };
    static constexpr std::size_t high_count = [] { // one more than the highest high byte
        std::size_t count = 1;
        for (const std::uint16_t code : Codes)
            if (code >> 8 >= static_cast<int>(count)) count = (code >> 8) + 1u;
        return count;
    }();
    static constexpr std::array<std::uint8_t, high_count> page_of = [] { // page 0 is empty: high bytes that no code has
        std::array<std::uint8_t, high_count> of{};
        std::uint8_t next = 1;
        for (const std::uint16_t code : Codes)
            if (of[code >> 8] == 0) of[code >> 8] = next++;
        return of;
    }();
    static constexpr std::size_t page_count = [] {
        std::size_t count = 1;
        for (const std::uint8_t number : page_of) count += number != 0;
        return count;
    }();
    static_assert(page_count <= 256, "code_index: codes with all 256 high bytes are not supported");
    static constexpr std::array<page, page_count> pages = [] {
        std::array<page, page_count> made{};
        for (std::size_t i = 1; i != page_count; ++i) made[i] = {255, 0, 0};
        for (const std::uint16_t code : Codes) {
            const auto low = static_cast<std::uint8_t>(code & 0xFF);
            page& p = made[page_of[code >> 8]];
            p.first = low < p.first ? low : p.first;
            p.last = low > p.last ? low : p.last;
        }
        for (std::size_t i = 2; i < page_count; ++i) {
            const page& before = made[i - 1];
            made[i].start = static_cast<std::uint16_t>(before.start + before.last - before.first + 1);
        }
        return made;
    }();
    static constexpr std::size_t place_count =
        pages.back().start + std::size_t{pages.back().last} - pages.back().first + 1u;
    using place = std::conditional_t<(Codes.size() < 255), std::uint8_t, std::uint16_t>;
    static constexpr std::array<place, place_count> places = [] { // the place plus 1; 0 for none
        std::array<place, place_count> made{};
        for (std::size_t i = 0; i != Codes.size(); ++i) {
            const page& p = pages[page_of[Codes[i] >> 8]];
            made[p.start + (Codes[i] & 0xFFu) - p.first] = static_cast<place>(i + 1);
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
