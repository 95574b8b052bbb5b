// Small messages with arrays and signed bit-fields.
#pragma once
#include "list_samples.hpp"

namespace samples {

/// Values and records, 15 bytes.
struct arm {
    std::array<std::uint16_t, 3> counts{};
    std::array<double, 2> effort{}; ///< 0 to 100
    std::array<point, 2> corner{};
    std::uint8_t tail{};
    friend constexpr bool operator==(const arm&, const arm&) = default;
};

/// Arrays in a presence vector, one of them of structures of variable size, 1 to 30 bytes.
struct hand {
    std::optional<std::array<std::int8_t, 4>> offsets{};
    std::optional<std::array<double, 2>> grip{}; ///< -100 to 100
    std::optional<std::array<mixed, 2>> finger{};
    friend constexpr bool operator==(const hand&, const hand&) = default;
};

/// Arrays of structures with lists, 3 bytes or more.
struct piles {
    std::array<polygon, 1> pile{};
    friend constexpr bool operator==(const piles&, const piles&) = default;
};

/// An array whose structures count their elements in the structure around it, 3 bytes or more.
struct cell_row {
    wire::list<std::uint8_t> cell{}; ///< as many as the board has columns
    friend constexpr bool operator==(const cell_row&, const cell_row&) = default;
};
struct board {
    std::uint8_t columns{};
    std::array<cell_row, 2> row{};
    friend constexpr bool operator==(const board&, const board&) = default;
};

/// Signed bit-fields, 2 bytes.
struct trims {
    std::int8_t pitch{};    ///< 5 bits
    bool locked{};          ///< 1 bit
    std::int32_t heading{}; ///< 9 bits
    friend constexpr bool operator==(const trims&, const trims&) = default;
};

} // namespace samples

// One line per field.
// clang-format off
namespace jauscat {

template <> struct wire::schema<samples::arm> {
    using T = samples::arm;
    using type = layout<
        array<&T::counts, u16be>,
        array<&T::effort, scaled<u8, samples::percent>>,
        array<&T::corner>,
        field<&T::tail, u8>>;
};

template <> struct wire::schema<samples::hand> {
    using T = samples::hand;
    using type = layout<
        presence<u8,
            array<&T::offsets, i8>,
            array<&T::grip, scaled<i16le, samples::signed_percent>>,
            array<&T::finger>>>;
};

template <> struct wire::schema<samples::piles> {
    using type = layout<array<&samples::piles::pile>>;
};

template <> struct wire::schema<samples::cell_row> {
    using type = layout<repeated<&samples::cell_row::cell, counted_by<&samples::board::columns>, element<"cell", u8>>>;
};

template <> struct wire::schema<samples::board> {
    using T = samples::board;
    using type = layout<
        field<&T::columns, u8>,
        array<&T::row>>;
};

template <> struct wire::schema<samples::trims> {
    using T = samples::trims;
    using type = layout<
        bit_fields<u16le,
            bit_field<&T::pitch, 5>,
            bit_field<&T::locked, 1>,
            reserved<1>,
            bit_field<&T::heading, 9>>>;
};

} // namespace jauscat
