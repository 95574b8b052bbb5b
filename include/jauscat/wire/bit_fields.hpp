// Several members packed into one integer, from its least significant bit up.
#pragma once
#include <jauscat/wire/layout_item.hpp>
#include <jauscat/wire/scalar.hpp>

#include <tuple>

namespace jauscat::wire {

namespace detail {
template <auto Member, class Is> inline constexpr bool has_bits = std::is_enum_v<Is> || std::integral<Is>;
template <auto Member, class Is, std::size_t Width>
inline constexpr bool holds_bits = Width >= 1 && Width <= (std::is_same_v<Is, bool> ? 1 : sizeof(Is) * 8);
} // namespace detail

/// A bit-field of `Width` bits: the member is bool, an integer (a signed one in two's complement) or an enumeration,
/// whose values are not negative. A value wider than its bits does not encode (`out_of_range`).
template <auto Member, std::size_t Width> struct bit_field {
    static constexpr auto key = Member;
    using keys = key_list<Member>;
    static constexpr std::size_t width = Width;
    using value_type = member_t<Member>;
    using raw_type = value_type;
    static constexpr bool optional = false;
    static constexpr bool is_signed = std::signed_integral<value_type>;
    static_assert(detail::has_bits<Member, value_type>,
                  "bit_field: the member must be bool, an integer or an enumeration");
    static_assert(detail::holds_bits<Member, value_type, Width>, "bit_field: the member is narrower than its bits");

    static consteval std::string_view name() { return name_of<Member>(); }

    /// The member's bits: an unsigned value that does not fit has more than `Width`.
    JAUSCAT_INLINE static constexpr std::uint64_t value(const auto& object) noexcept {
        const auto bits = static_cast<std::uint64_t>(member_of<Member>(object));
        if constexpr (is_signed)
            return bits & low_bits;
        else
            return bits;
    }
    /// The value of `Width` bits.
    JAUSCAT_INLINE static constexpr value_type from_bits(std::uint64_t bits) noexcept {
        if constexpr (is_signed)
            return static_cast<value_type>((bits ^ sign_bit) - sign_bit);
        else
            return static_cast<value_type>(bits);
    }
    JAUSCAT_INLINE static constexpr bool fits(const auto& object) noexcept {
        if constexpr (std::is_same_v<value_type, bool> || Width >= sizeof(value_type) * 8)
            return true;
        else if constexpr (is_signed)
            return from_bits(value(object)) == member_of<Member>(object);
        else
            return value(object) >> Width == 0;
    }
    JAUSCAT_INLINE static constexpr void assign(auto& object, std::uint64_t bits) noexcept {
        member_of<Member>(object) = from_bits(bits);
    }
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) {
        visitor(bit_field{}, member_of<Member>(object));
    }

  private:
    static constexpr std::uint64_t low_bits = ~std::uint64_t{} >> (64 - Width);
    static constexpr std::uint64_t sign_bit = std::uint64_t{1} << (Width - 1);
};

/// `Width` bits that the standard reserves: sent as zero, ignored on receipt.
template <std::size_t Width> struct reserved {
    using keys = key_list<>;
    static constexpr std::size_t width = Width;
    JAUSCAT_INLINE static constexpr std::uint64_t value(const auto&) noexcept { return 0; }
    JAUSCAT_INLINE static constexpr bool fits(const auto&) noexcept { return true; }
    JAUSCAT_INLINE static constexpr void assign(auto&, std::uint64_t) noexcept {}
    JAUSCAT_INLINE static constexpr void visit(auto&, auto&&) {}
};

/// What `bit_fields` consists of. A part with a member also has `from_bits(std::uint64_t)`, which returns its value.
template <class Part>
concept bit_field_part = detail::has_keys<Part> && detail::has_visit<Part> &&
                         requires(const detail::structure_around<Part>& object, detail::structure_around<Part>& decoded,
                                  std::uint64_t bits) {
                             { Part::width } -> std::convertible_to<std::size_t>;
                             { Part::value(object) } -> std::same_as<std::uint64_t>;
                             { Part::fits(object) } -> std::same_as<bool>;
                             Part::assign(decoded, bits);
                         };

namespace detail {
/// Says which operation a part of an integer lacks.
template <class Part, class T = structure_around<Part>> struct missing_in_part {
    static_assert(
        requires {
            { Part::width } -> std::convertible_to<std::size_t>;
        }, "bit_fields: a part has no width, how many bits it takes");
    static_assert(has_visit<Part>, "bit_fields: a part has no visit(object, visitor)");
    static_assert(
        requires(const T& object) {
            { Part::value(object) } -> std::same_as<std::uint64_t>;
        }, "bit_fields: a part has no value(object) that returns std::uint64_t");
    static_assert(
        requires(const T& object) {
            { Part::fits(object) } -> std::same_as<bool>;
        }, "bit_fields: a part has no fits(object) that returns bool");
    static_assert(
        requires(T& object, std::uint64_t bits) { Part::assign(object, bits); },
        "bit_fields: a part has no assign(object, std::uint64_t)");
    static constexpr bool complete = false;
};
template <class Part> inline constexpr bool checked_part = true;
template <class Part>
requires(!bit_field_part<Part>)
inline constexpr bool checked_part<Part> = missing_in_part<Part>::complete;
} // namespace detail

/// Bit-fields of one integer, least significant first; their widths fill it exactly.
template <class Carrier, class... Fields> struct bit_fields {
    static_assert(detail::checked_codec<Carrier>,
                  "bit_fields: the carrier is not a codec (it needs value_type, size, store and load)");
    static_assert((detail::checked_part<Fields> && ... && true),
                  "bit_fields: a part is neither a bit_field nor reserved (it needs keys, width, value, fits, assign "
                  "and visit)");
    using carrier_type = typename Carrier::value_type;
    using word_type = word_for<Carrier>;
    using fields = std::tuple<Fields...>;
    using keys = joined_keys<typename Fields::keys...>;
    static constexpr bool optional = false;
    static constexpr bool checks_values = (requires { typename Fields::value_set; } || ... || false);
    static constexpr std::size_t min_size = Carrier::size, max_size = Carrier::size;
    static_assert((Fields::width + ... + 0) == Carrier::size * 8,
                  "bit_fields: the widths must fill the carrier exactly (add reserved<n> for unused bits)");

    JAUSCAT_INLINE static constexpr errc put(const auto& object, std::byte* out) noexcept {
        if (!(Fields::fits(object) && ...)) return errc::out_of_range;
        std::size_t at = 0;
        word_type word{};
        ((word |= static_cast<word_type>(Fields::value(object)) << at, at += Fields::width), ...);
        return Carrier::store(out, static_cast<carrier_type>(word));
    }
    JAUSCAT_INLINE static constexpr errc get(auto& object, const std::byte* in) noexcept {
        const word_type word = loaded(in);
        std::size_t at = 0;
        ((Fields::assign(object, (word >> at) & mask<Fields::width>), at += Fields::width), ...);
        return errc::ok;
    }

    template <auto Member, reading>
    JAUSCAT_INLINE static constexpr auto read(const std::byte* in, const auto&) noexcept {
        using found = std::tuple_element_t<index_of<Member>, fields>;
        return found::from_bits((loaded(in) >> first_bit<Member>)&mask<found::width>);
    }

    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) { (Fields::visit(object, visitor), ...); }

    /// Position of a member: its first bit, counted from the least significant.
    template <auto Member>
    static constexpr std::size_t first_bit = [] {
        std::size_t at = 0;
        bool found = false;
        ((found = found || Fields::keys::template holds<Member>, at += found ? 0 : Fields::width), ...);
        return at;
    }();

  private:
    template <auto Member>
    static constexpr std::size_t index_of = [] {
        std::size_t index = 0;
        static_cast<void>((... || (Fields::keys::template holds<Member> || (++index, false))));
        return index;
    }();
    JAUSCAT_INLINE static constexpr word_type loaded(const std::byte* in) noexcept {
        carrier_type carrier{};
        Carrier::load(in, carrier);
        return carrier;
    }
    template <std::size_t Width>
    static constexpr word_type mask = static_cast<word_type>(~std::uint64_t{} >> (64 - Width));
};

} // namespace jauscat::wire
