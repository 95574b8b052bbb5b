// Codecs of single values of a fixed size: integers and floating point in either byte order, enumerations, octets. A
// codec has `value_type`, `size` in bytes, `store(bytes, value)` and `load(bytes, value)`; both return errc::ok or an
// error. One with `as_in_memory` stores the value's bytes unchanged, and accepts any bytes.
#pragma once
#include <jauscat/wire/errc.hpp>
#include <jauscat/wire/inlining.hpp>

#include <boost/endian/conversion.hpp>

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace jauscat::wire {

template <class C>
concept codec = requires(std::byte* out, const std::byte* in, typename C::value_type value) {
    { C::size } -> std::convertible_to<std::size_t>;
    { C::store(out, value) } -> std::same_as<errc>;
    { C::load(in, value) } -> std::same_as<errc>;
};

namespace detail {

template <class C> concept has_value_type = requires { typename C::value_type; };
template <class C>
concept has_codec_size = requires {
    { C::size } -> std::convertible_to<std::size_t>;
};
template <class C>
concept stores = requires(std::byte* out, typename C::value_type value) {
    { C::store(out, value) } -> std::same_as<errc>;
};
template <class C>
concept loads = requires(const std::byte* in, typename C::value_type value) {
    { C::load(in, value) } -> std::same_as<errc>;
};
/// Says which operation a codec lacks; nothing of a type that is no codec at all.
template <class C> struct missing_in_codec {
    static constexpr bool started = has_value_type<C>;
    static_assert(!started || has_codec_size<C>, "codec: it has no size, the bytes that it takes");
    static_assert(!started || stores<C>, "codec: it has no store(std::byte*, value_type) that returns errc");
    static_assert(!started || loads<C>, "codec: it has no load(const std::byte*, value_type&) that returns errc");
    static constexpr bool complete = false;
};
template <class C> inline constexpr bool checked_codec = true;
template <class C>
requires(!codec<C>)
inline constexpr bool checked_codec<C> = missing_in_codec<C>::complete;

} // namespace detail

/// An integer of 8 to 64 bits in the byte order `Order`.
template <std::integral T, boost::endian::order Order> struct integer {
    using value_type = T;
    static constexpr std::size_t size = sizeof(T);
    static constexpr bool as_in_memory = size == 1 || Order == boost::endian::order::native;

    // The loop serves constant evaluation; memcpy lets the optimiser merge neighbouring fields into one access.
    JAUSCAT_INLINE static constexpr errc store(std::byte* out, T value) noexcept {
        const T ordered = boost::endian::conditional_reverse<boost::endian::order::native, Order>(value);
        if (std::is_constant_evaluated()) {
            const auto bytes = std::bit_cast<std::array<std::byte, size>>(ordered);
            for (std::size_t i = 0; i != size; ++i) out[i] = bytes[i];
        } else {
            std::memcpy(out, &ordered, size);
        }
        return errc::ok;
    }

    JAUSCAT_INLINE static constexpr errc load(const std::byte* in, T& value) noexcept {
        T ordered{};
        if (std::is_constant_evaluated()) {
            std::array<std::byte, size> bytes{};
            for (std::size_t i = 0; i != size; ++i) bytes[i] = in[i];
            ordered = std::bit_cast<T>(bytes);
        } else {
            std::memcpy(&ordered, in, size);
        }
        value = boost::endian::conditional_reverse<Order, boost::endian::order::native>(ordered);
        return errc::ok;
    }
};

/// Integer type for shifting and masking the bits of a carrier. Unsigned and not narrower than int: promotions to int
/// and cuts back to 8 or 16 bits were measured to cost an instruction or two for each bit-field.
template <codec Carrier>
using word_for = std::conditional_t<(sizeof(typename Carrier::value_type) > 4), std::uint64_t, std::uint32_t>;

/// IEEE 754 single or double precision, carried by the integer codec of its size. Every bit pattern passes, NaN
/// included.
template <std::floating_point T, class Bits> struct floating {
    using value_type = T;
    static constexpr std::size_t size = Bits::size;
    static_assert(sizeof(T) == size, "floating: the value and its carrier differ in size");

    JAUSCAT_INLINE static constexpr errc store(std::byte* out, T value) noexcept {
        return Bits::store(out, std::bit_cast<typename Bits::value_type>(value));
    }
    JAUSCAT_INLINE static constexpr errc load(const std::byte* in, T& value) noexcept {
        typename Bits::value_type bits{};
        Bits::load(in, bits);
        value = std::bit_cast<T>(bits);
        return errc::ok;
    }
};

using u8 = integer<std::uint8_t, boost::endian::order::little>;
using i8 = integer<std::int8_t, boost::endian::order::little>;
using u16le = integer<std::uint16_t, boost::endian::order::little>;
using i16le = integer<std::int16_t, boost::endian::order::little>;
using u32le = integer<std::uint32_t, boost::endian::order::little>;
using i32le = integer<std::int32_t, boost::endian::order::little>;
using u64le = integer<std::uint64_t, boost::endian::order::little>;
using i64le = integer<std::int64_t, boost::endian::order::little>;
using u16be = integer<std::uint16_t, boost::endian::order::big>;
using i16be = integer<std::int16_t, boost::endian::order::big>;
using u32be = integer<std::uint32_t, boost::endian::order::big>;
using i32be = integer<std::int32_t, boost::endian::order::big>;
using u64be = integer<std::uint64_t, boost::endian::order::big>;
using i64be = integer<std::int64_t, boost::endian::order::big>;
using f32le = floating<float, u32le>;
using f64le = floating<double, u64le>;
using f32be = floating<float, u32be>;
using f64be = floating<double, u64be>;

/// An enumeration carried by an integer codec. Open: a value without a name passes through unchanged, because standards
/// reserve values for later editions.
template <class Enum, codec Carrier>
requires std::is_enum_v<Enum>
struct enumeration {
    using value_type = Enum;
    static constexpr std::size_t size = Carrier::size;
    static constexpr bool as_in_memory = Carrier::as_in_memory;
    static_assert(std::is_same_v<std::underlying_type_t<Enum>, typename Carrier::value_type>,
                  "enumeration: the enumeration's underlying type must be the carrier's integer type");

    JAUSCAT_INLINE static constexpr errc store(std::byte* out, Enum value) noexcept {
        return Carrier::store(out, static_cast<typename Carrier::value_type>(value));
    }
    JAUSCAT_INLINE static constexpr errc load(const std::byte* in, Enum& value) noexcept {
        typename Carrier::value_type raw{};
        Carrier::load(in, raw);
        value = static_cast<Enum>(raw);
        return errc::ok;
    }
};

/// N bytes as they are, for example a MAC address.
template <std::size_t N> struct octets {
    using value_type = std::array<std::byte, N>;
    static constexpr std::size_t size = N;
    static constexpr bool as_in_memory = true;

    JAUSCAT_INLINE static constexpr errc store(std::byte* out, const value_type& value) noexcept {
        for (std::size_t i = 0; i != N; ++i) out[i] = value[i];
        return errc::ok;
    }
    JAUSCAT_INLINE static constexpr errc load(const std::byte* in, value_type& value) noexcept {
        for (std::size_t i = 0; i != N; ++i) value[i] = in[i];
        return errc::ok;
    }
};

/// A value that travels as it is and has a unit: `static constexpr std::string_view unit`.
template <codec Codec, class Unit> struct in_units : Codec {
    using unit_type = Unit;
};

} // namespace jauscat::wire
