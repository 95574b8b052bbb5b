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
// in it a run of low bytes. About 600 bytes for the 158 codes of RA 3.3, two loads and one comparison for a lookup.
template <const auto& Codes> class code_index {
  public:
    static constexpr std::size_t npos = static_cast<std::size_t>(-1);

    /// The place of `code` counted from 0, or npos.
    [[nodiscard]] static constexpr std::size_t find(std::uint16_t code) noexcept {
        const page& p = pages[page_of[code >> 8]];
        const unsigned low = (code & 0xFFu) - p.first;
        return low < p.count && places[p.start + low] != 0 ? places[p.start + low] - 1u : npos;
    }

  private:
    static_assert(Codes.size() < 0xFFFF, "code_index: too many codes");
    struct page {
        std::uint16_t first{}, count{}, start{};
    };
    static constexpr std::size_t page_count = [] { // page 0 is empty: the high bytes that no code has
        std::array<bool, 256> used{};
        std::size_t count = 1;
        for (const std::uint16_t code : Codes) {
            count += !used[code >> 8];
            used[code >> 8] = true;
        }
        return count;
    }();
    static constexpr std::array<std::uint8_t, 256> page_of = [] {
        std::array<std::uint8_t, 256> of{};
        std::uint8_t next = 1;
        for (const std::uint16_t code : Codes)
            if (of[code >> 8] == 0) of[code >> 8] = next++;
        return of;
    }();
    static_assert(page_count <= 256, "code_index: codes with all 256 high bytes are not supported");
    static constexpr std::array<page, page_count> pages = [] {
        std::array<std::uint16_t, page_count> least{}, most{};
        least.fill(0x100);
        for (const std::uint16_t code : Codes) {
            const auto low = static_cast<std::uint16_t>(code & 0xFF);
            auto& l = least[page_of[code >> 8]];
            auto& m = most[page_of[code >> 8]];
            l = low < l ? low : l;
            m = low > m ? low : m;
        }
        std::array<page, page_count> made{};
        std::uint16_t start = 0;
        for (std::size_t i = 1; i != page_count; ++i) {
            const auto count = static_cast<std::uint16_t>(most[i] - least[i] + 1);
            made[i] = {least[i], count, start};
            start = static_cast<std::uint16_t>(start + count);
        }
        return made;
    }();
    static constexpr std::size_t place_count = pages.back().start + std::size_t{pages.back().count};
    using place = std::conditional_t<(Codes.size() < 255), std::uint8_t, std::uint16_t>;
    static constexpr std::array<place, place_count + 1> places = [] { // the place plus 1; 0 for none
        std::array<place, place_count + 1> made{};
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
