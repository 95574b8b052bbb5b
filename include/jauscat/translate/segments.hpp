// Rows of a table with more codes than an object has subindices: several lists of codes, each in an object of its own.
#pragma once
#include <jauscat/translate/errc.hpp>
#include <jauscat/translate/rows.hpp>
#include <jauscat/wire/code_index.hpp>

#include <array>
#include <limits>

namespace jauscat::translate {

/// Lists of codes. The segment of a code is its list, counted from 0; its rank is the position in it, counted from 1.
template <const auto&... Lists> struct code_segments {
    static_assert(((Lists.size() <= 254) && ...),
                  "code_segments: more than 254 codes do not fit the subindices of a segment (255 is reserved)");
    static constexpr std::size_t count = sizeof...(Lists);

    struct place {
        std::uint8_t segment{}, rank{}; ///< rank 0: none
    };
    /// All lists, one behind the other.
    static constexpr auto codes = [] {
        std::array<std::uint16_t, (Lists.size() + ... + 0)> all{};
        std::size_t i = 0;
        const auto append = [&](const auto& list) {
            for (const std::uint16_t code : list) all[i++] = code;
        };
        (append(Lists), ...);
        return all;
    }();

    [[nodiscard, gnu::always_inline]] static constexpr place find(std::uint16_t code) noexcept {
        return by_slot[index::slot(code)];
    }
    /// The code at this place; false if there is none.
    [[nodiscard, gnu::always_inline]] static constexpr bool find(std::uint32_t segment, std::uint32_t rank,
                                                                 auto& code) noexcept {
        if (segment >= count || rank == 0 || rank > ends[segment + 1] - ends[segment]) return false;
        code = codes[ends[segment] + rank - 1];
        return true;
    }

  private:
    using index = wire::code_index<codes>;
    // Where each list begins in `codes`, and the end of the last one.
    static constexpr auto ends = [] {
        std::array<std::uint32_t, count + 1> made{};
        const std::array<std::size_t, count> sizes{Lists.size()...};
        for (std::size_t i = 0; i != count; ++i) made[i + 1] = made[i] + static_cast<std::uint32_t>(sizes[i]);
        return made;
    }();
    static constexpr auto by_slot = [] {
        std::array<place, codes.size()> made{};
        for (std::size_t s = 0; s != count; ++s)
            for (std::uint32_t i = ends[s]; i != ends[s + 1]; ++i)
                made[i] = {static_cast<std::uint8_t>(s), static_cast<std::uint8_t>(i - ends[s] + 1)};
        return index::by_slot(made, place{});
    }();
};

namespace detail {
/// Objects between a component's objects of two segments.
inline constexpr std::uint32_t segment_step = 256;
} // namespace detail

/// The packet's value is `Base`, 256 for each segment before that of the code, and the JAUS value: the index of a
/// component's object for the messages of one segment. An unknown code is refused by `segmented_rank`.
template <class From, class To, std::uint32_t Base, class Code, class Segments> struct segmented_offset {
    using uses = path_list<From>;
    using writes = path_list<To>;
    using from = From;
    using to = To;
    static constexpr bool gives_index = true;
    static_assert(std::numeric_limits<typename From::type>::max() < detail::segment_step,
                  "segmented_offset: the message's value has more than 8 bits");
    static_assert(Base + detail::segment_step * Segments::count <= 0x10000,
                  "segmented_offset: the index of the last segment does not fit 16 bits");

    [[gnu::always_inline]] static constexpr errc to_packet(const auto& header, auto& packet, sizes) noexcept {
        const std::uint32_t segment = Segments::find(Code::of(header)).segment;
        To::of(packet) =
            static_cast<typename To::type>(Base + detail::segment_step * segment + detail::to_word(From::of(header)));
        return errc::ok;
    }
    [[gnu::always_inline]] static constexpr errc from_packet(const auto& packet, auto& header, sizes) noexcept {
        const std::uint32_t index = To::of(packet);
        if (index < Base || index - Base >= detail::segment_step * Segments::count) return errc::unknown_index;
        return detail::from_word((index - Base) % detail::segment_step, From::of(header));
    }
};

/// The packet's value is the rank of the code in its segment; `Index` is the packet's field of `segmented_offset`.
template <class From, class To, std::uint32_t Base, class Index, class Segments> struct segmented_rank {
    using uses = path_list<From>;
    using writes = path_list<To>;
    using from = From;
    using to = To;
    static constexpr bool gives_subindex = true;

    [[gnu::always_inline]] static constexpr errc to_packet(const auto& header, auto& packet, sizes) noexcept {
        const auto place = Segments::find(From::of(header));
        if (place.rank == 0) return errc::unknown_command_code;
        To::of(packet) = place.rank;
        return errc::ok;
    }
    [[gnu::always_inline]] static constexpr errc from_packet(const auto& packet, auto& header, sizes) noexcept {
        const std::uint32_t index = Index::of(packet);
        if (index < Base) return errc::unknown_index;
        const bool is_known = Segments::find((index - Base) / detail::segment_step, To::of(packet), From::of(header));
        return is_known ? errc::ok : errc::unknown_subindex;
    }
};

} // namespace jauscat::translate
