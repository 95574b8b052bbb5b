// Several members packed into one integer, from its least significant bit up.
#pragma once
#include <jauscat/wire/item.hpp>
#include <jauscat/wire/scalar.hpp>

#include <tuple>

namespace jauscat::wire {

/// A bit-field of `Width` bits: the member is bool, an unsigned integer or an enumeration of one.
/// A value wider than its bits does not encode (`out_of_range`).
template <auto Member, std::size_t Width> struct bit_field {
    static constexpr auto key = Member;
    using keys = key_list<Member>;
    static constexpr std::size_t width = Width;
    using value_type = member_t<Member>;
    using raw_type = value_type;
    static constexpr bool optional = false;
    static_assert(std::is_enum_v<value_type> || std::unsigned_integral<value_type>,
                  "bit_field: the member must be bool, an unsigned integer or an enumeration");
    static_assert(Width >= 1 && Width <= (std::is_same_v<value_type, bool> ? 1 : sizeof(value_type) * 8),
                  "bit_field: the member is narrower than its bits");

    static consteval std::string_view name() { return name_of<Member>(); }

    JAUSCAT_INLINE static constexpr std::uint64_t value(const auto& object) noexcept {
        return static_cast<std::uint64_t>(object.*place_in<decltype(object), Member>);
    }
    JAUSCAT_INLINE static constexpr bool fits(const auto& object) noexcept {
        if constexpr (std::is_same_v<value_type, bool> || Width >= sizeof(value_type) * 8)
            return true;
        else
            return value(object) >> Width == 0;
    }
    JAUSCAT_INLINE static constexpr void assign(auto& object, std::uint64_t raw) noexcept {
        object.*place_in<decltype(object), Member> = static_cast<value_type>(raw);
    }
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) {
        visitor(bit_field{}, object.*place_in<decltype(object), Member>);
    }
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

/// Bit-fields of one integer, least significant first; their widths fill it exactly.
template <codec Carrier, class... Fields> struct bit_fields {
    using carrier_type = typename Carrier::value_type;
    using word_type = word_for<Carrier>;
    using fields = std::tuple<Fields...>;
    using keys = joined_keys<typename Fields::keys...>;
    static constexpr bool optional = false;
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
        const word_type word = loaded(in);
        std::size_t at = 0;
        word_type raw = 0;
        ((raw = Fields::keys::template holds<Member> ? (word >> at) & mask<Fields::width> : raw, at += Fields::width),
         ...);
        return static_cast<member_t<Member>>(raw);
    }

    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) { (Fields::visit(object, visitor), ...); }

    /// Where a member lies: its first bit, counted from the least significant.
    template <auto Member>
    static constexpr std::size_t first_bit = [] {
        std::size_t at = 0;
        bool found = false;
        ((found = found || Fields::keys::template holds<Member>, at += found ? 0 : Fields::width), ...);
        return at;
    }();

  private:
    JAUSCAT_INLINE static constexpr word_type loaded(const std::byte* in) noexcept {
        carrier_type carrier{};
        Carrier::load(in, carrier);
        return carrier;
    }
    template <std::size_t Width>
    static constexpr word_type mask = static_cast<word_type>(~std::uint64_t{} >> (64 - Width));
};

} // namespace jauscat::wire
