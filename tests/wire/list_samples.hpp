// Small messages of any length that together use every item for lists, text, variants and trees.
#pragma once
#include "samples.hpp"

#include <variant>

namespace samples {

namespace wire = jauscat::wire;

enum class kind : std::uint8_t { byte = 0, real = 7, colour = 9, none = 255 };

struct rgb {
    std::uint8_t red{}, green{}, blue{};
    friend constexpr bool operator==(const rgb&, const rgb&) = default;
};

/// A value that says its type, 1 to 5 bytes.
struct typed {
    samples::kind kind{};
    std::variant<std::uint8_t, float, rgb, std::monostate> value{};
    friend constexpr bool operator==(const typed&, const typed&) = default;
};

/// Single values inside the message, records elsewhere, 3 bytes or more.
struct polygon {
    wire::inline_list<double, 3> level{}; ///< 0 to 100
    wire::list<point> corner{};
    friend constexpr bool operator==(const polygon&, const polygon&) = default;
};

/// A list in a list, 2 bytes or more.
struct polygons {
    wire::list<polygon> shape{};
    friend constexpr bool operator==(const polygons&, const polygons&) = default;
};

/// A count that stands in the structure around the list.
struct row {
    std::uint8_t number{};
    wire::list<std::uint16_t> cell{}; ///< as many as the grid has columns
    friend constexpr bool operator==(const row&, const row&) = default;
};
struct grid {
    std::uint8_t columns{};
    wire::list<samples::row> row{};
    friend constexpr bool operator==(const grid&, const grid&) = default;
};

/// A count of one more than there are elements, 2 bytes or more.
struct chain {
    std::uint8_t joints{};
    std::uint8_t base{};
    wire::list<point> link{};
    friend constexpr bool operator==(const chain&, const chain&) = default;
};

/// A count inside a structure beside the bytes, 3 bytes or more.
struct parcel_header {
    std::uint16_t size{};  ///< 12 bits
    std::uint8_t colour{}; ///< 4 bits
    friend constexpr bool operator==(const parcel_header&, const parcel_header&) = default;
};
struct parcel {
    parcel_header header{};
    wire::blob body{};
    std::uint8_t tail{};
    friend constexpr bool operator==(const parcel&, const parcel&) = default;
};

/// Text of every length, 6 bytes or more.
struct labels {
    std::string_view fixed{}; ///< 4 characters
    std::string_view terminated{};
    std::string_view counted{};
    std::string_view rest{};
    friend constexpr bool operator==(const labels&, const labels&) = default;
};

/// Sent with 6 characters, received with any number.
struct lenient {
    std::uint8_t id{};
    std::string_view text{};
    friend constexpr bool operator==(const lenient&, const lenient&) = default;
};

/// Optional members of any length, and a flag for what stands in the elements of a list.
struct spot {
    std::optional<std::uint16_t> buffer{};
    std::uint8_t id{};
    friend constexpr bool operator==(const spot&, const spot&) = default;
};
struct survey {
    std::optional<wire::blob> extra{};
    bool buffer_present{};
    std::optional<wire::list<spot>> spots{};
    std::optional<typed> limit{};
    friend constexpr bool operator==(const survey&, const survey&) = default;
};

/// A number whose scale another member selects, 2 or 3 bytes.
struct measure {
    std::uint8_t range{};
    double value{}; ///< 0 to 100; in range 1 -100 to 100
    friend constexpr bool operator==(const measure&, const measure&) = default;
};

/// A value whose type the receiver knows.
struct agreed {
    samples::kind kind{};
    std::variant<std::uint8_t, float, rgb, std::monostate> value{};
    friend constexpr bool operator==(const agreed&, const agreed&) = default;
};

/// A tree of at most 3 levels.
struct node {
    std::uint8_t id{};
    std::uint8_t children{};
    friend constexpr bool operator==(const node&, const node&) = default;
};
struct forest {
    wire::list<node> tree{};
    std::uint8_t tail{};
    friend constexpr bool operator==(const forest&, const forest&) = default;
};

enum class lamp : std::uint16_t { left = 0, right = 1, top = 15 };
struct lamps {
    wire::bit_set<lamp> lit{};
    friend constexpr bool operator==(const lamps&, const lamps&) = default;
};

} // namespace samples

// One line per field.
// clang-format off
namespace jauscat {

template <> struct wire::schema<samples::rgb> {
    using T = samples::rgb;
    using type = layout<field<&T::red, u8>, field<&T::green, u8>, field<&T::blue, u8>>;
};

template <> struct wire::schema<samples::typed> {
    using T = samples::typed;
    using type = layout<
        field<&T::kind, enumeration<samples::kind, u8>>,
        selected<&T::value, by<&T::kind>,
            when<samples::kind::byte, u8>,
            when<samples::kind::real, f32le>,
            when<samples::kind::colour, samples::rgb>,
            when<samples::kind::none>>>;
};

template <> struct wire::schema<samples::polygon> {
    using T = samples::polygon;
    using type = layout<
        repeated<&T::level, count<"number_of_levels", u8>, element<"level", scaled<u8, samples::percent>>>,
        repeated<&T::corner, count<"number_of_corners", u16le>>>;
};

template <> struct wire::schema<samples::polygons> {
    using T = samples::polygons;
    using type = layout<repeated<&T::shape, count<"number_of_shapes", u16be>>>;
};

template <> struct wire::schema<samples::row> {
    using T = samples::row;
    using type = layout<
        field<&T::number, u8>,
        repeated<&T::cell, counted_by<&samples::grid::columns>, element<"cell", u16be>>>;
};

template <> struct wire::schema<samples::grid> {
    using T = samples::grid;
    using type = layout<
        field<&T::columns, u8>,
        repeated<&T::row, count<"number_of_rows", u8>>>;
};

template <> struct wire::schema<samples::chain> {
    using T = samples::chain;
    using type = layout<
        field<&T::joints, u8>,
        field<&T::base, u8>,
        repeated<&T::link, one_less_than<&T::joints>>>;
};

template <> struct wire::schema<samples::parcel_header> {
    using T = samples::parcel_header;
    using type = layout<bit_fields<u16le, bit_field<&T::size, 12>, bit_field<&T::colour, 4>>>;
};

template <> struct wire::schema<samples::parcel> {
    using T = samples::parcel;
    using type = layout<
        nested<&T::header>,
        bytes<&T::body, counted_by<&T::header, &samples::parcel_header::size>>,
        field<&T::tail, u8>>;
};

template <> struct wire::schema<samples::labels> {
    using T = samples::labels;
    using type = layout<
        string<&T::fixed, wire::fixed<4>>,
        string<&T::terminated, zero_terminated>,
        string<&T::counted, count<"number_of_characters", u8>>,
        string<&T::rest, wire::rest>>;
};

template <> struct wire::schema<samples::lenient> {
    using T = samples::lenient;
    using type = layout<
        field<&T::id, u8>,
        string<&T::text, fixed_or_rest<6>>>;
};

template <> struct wire::schema<samples::spot> {
    using T = samples::spot;
    using type = layout<
        gated_by<&samples::survey::buffer_present, field<&T::buffer, u16le>>,
        field<&T::id, u8>>;
};

template <> struct wire::schema<samples::survey> {
    using T = samples::survey;
    using type = layout<
        presence<u8,
            bytes<&T::extra, count<"extra_size", u16le>>,
            presence_flag<&T::buffer_present>,
            repeated<&T::spots, count<"number_of_spots", u8>>,
            nested<&T::limit>>>;
};

template <> struct wire::schema<samples::measure> {
    using T = samples::measure;
    using type = layout<
        field<&T::range, u8>,
        selected<&T::value, by<&T::range>,
            when<0, scaled<u8, samples::percent>>,
            when<1, scaled<i16le, samples::signed_percent>>>>;
};

template <> struct wire::schema<samples::agreed> {
    using T = samples::agreed;
    using type = layout<
        not_on_wire<&T::kind>,
        selected<&T::value, by<&T::kind>,
            when<samples::kind::byte, u8>,
            when<samples::kind::real, f32le>,
            when<samples::kind::colour, samples::rgb>,
            when<samples::kind::none>>>;
};

template <> struct wire::schema<samples::node> {
    using T = samples::node;
    using type = layout<field<&T::id, u8>, field<&T::children, u8>>;
};

template <> struct wire::schema<samples::forest> {
    using T = samples::forest;
    using type = layout<
        tree<&T::tree, &samples::node::children, 3>,
        field<&T::tail, u8>>;
};

template <> struct wire::schema<samples::lamps> {
    using T = samples::lamps;
    using type = layout<field<&T::lit, bit_set_codec<samples::lamp, u16be>>>;
};

} // namespace jauscat
