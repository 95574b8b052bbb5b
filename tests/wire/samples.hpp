// Small messages that together use every item of a layout.
#pragma once
#include <jauscat/wire/schema.hpp>

namespace samples {

struct percent {
    static constexpr double min = 0, max = 100;
    static constexpr std::string_view unit = "%";
};
struct signed_percent {
    static constexpr double min = -100, max = 100;
    static constexpr std::string_view unit = "%";
};

enum class colour : std::uint8_t { red = 1, green = 2 };
enum class fault : std::uint16_t { none = 0, overheated = 0x1234 };

/// No fields at all.
struct empty {
    friend constexpr bool operator==(const empty&, const empty&) = default;
};

/// Plain codecs side by side, 20 bytes.
struct scalars {
    std::uint8_t small{};
    std::int16_t little{};
    std::uint32_t big{};
    float single_precision{};
    colour shade{};
    fault error{};
    std::array<std::byte, 6> station{};
    friend constexpr bool operator==(const scalars&, const scalars&) = default;
};

/// Bit-fields with reserved bits between them, 2 bytes.
struct flags {
    std::uint16_t length{}; ///< bits 0 to 10
    bool circulating{};     ///< bit 14
    colour shade{};         ///< bits 12 and 13
    friend constexpr bool operator==(const flags&, const flags&) = default;
};

/// A fixed structure with scaled values, 3 bytes.
struct point {
    double x{}; ///< -100 to 100
    double y{}; ///< 0 to 100
    friend constexpr bool operator==(const point&, const point&) = default;
};

/// Optional and required members in one presence vector, 4 to 12 bytes.
struct mixed {
    std::uint8_t number{};             ///< always there
    std::optional<double> level{};     ///< bit 0
    std::uint16_t required{};          ///< always there
    std::optional<point> place{};      ///< bit 1
    std::optional<std::uint32_t> id{}; ///< bit 2
    friend constexpr bool operator==(const mixed&, const mixed&) = default;
};

/// A variable structure between fixed fields, 7 to 15 bytes.
struct envelope {
    std::uint16_t kind{};
    mixed content{};
    std::uint8_t tail{};
    friend constexpr bool operator==(const envelope&, const envelope&) = default;
};

/// Tolerates bits 2 to 7.
struct open {
    std::optional<std::uint8_t> first{};
    std::optional<std::uint16_t> second{};
    friend constexpr bool operator==(const open&, const open&) = default;
};

/// Ignores bits 2 to 7.
struct with_spare_bits {
    std::optional<std::uint8_t> first{};
    std::optional<std::uint16_t> second{};
    std::uint8_t last{};
    friend constexpr bool operator==(const with_spare_bits&, const with_spare_bits&) = default;
};

/// Scaled integers of 64 bits, 16 bytes.
struct fine {
    double a{}; ///< 0 to 100
    double b{}; ///< -100 to 100
    friend constexpr bool operator==(const fine&, const fine&) = default;
};

} // namespace samples

// One line per field.
// clang-format off
namespace jauscat {

template <> struct wire::schema<samples::empty> { using type = layout<>; };

template <> struct wire::schema<samples::scalars> {
    using T = samples::scalars;
    using type = layout<
        field<&T::small, u8>,
        field<&T::little, i16le>,
        field<&T::big, u32be>,
        field<&T::single_precision, f32le>,
        field<&T::shade, enumeration<samples::colour, u8>>,
        field<&T::error, enumeration<samples::fault, u16le>>,
        field<&T::station, octets<6>>>;
};

template <> struct wire::schema<samples::flags> {
    using T = samples::flags;
    using type = layout<
        bit_fields<u16le,
            bit_field<&T::length, 11>,
            reserved<1>,
            bit_field<&T::shade, 2>,
            bit_field<&T::circulating, 1>,
            reserved<1>>>;
};

template <> struct wire::schema<samples::point> {
    using T = samples::point;
    using type = layout<
        field<&T::x, scaled<i16le, samples::signed_percent>>,
        field<&T::y, scaled<u8, samples::percent>>>;
};

template <> struct wire::schema<samples::mixed> {
    using T = samples::mixed;
    using type = layout<
        presence<u8,
            field<&T::number, u8>,
            field<&T::level, scaled<u8, samples::percent>>,
            field<&T::required, u16le>,
            nested<&T::place>,
            field<&T::id, u32le>>>;
};

template <> struct wire::schema<samples::envelope> {
    using T = samples::envelope;
    using type = layout<
        field<&T::kind, u16be>,
        nested<&T::content>,
        field<&T::tail, u8>>;
};

template <> struct wire::schema<samples::with_spare_bits> {
    using T = samples::with_spare_bits;
    using type = layout<
        lenient_presence<u8,
            field<&T::first, u8>,
            field<&T::second, u16le>>,
        field<&T::last, u8>>;
};

template <> struct wire::schema<samples::open> {
    using T = samples::open;
    using type = layout<
        open_presence<u8,
            field<&T::first, u8>,
            field<&T::second, u16le>>>;
};

template <> struct wire::schema<samples::fine> {
    using T = samples::fine;
    using type = layout<
        field<&T::a, scaled<u64le, samples::percent>>,
        field<&T::b, scaled<i64be, samples::signed_percent>>>;
};

} // namespace jauscat
