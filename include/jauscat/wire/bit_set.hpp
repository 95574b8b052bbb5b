// A set of bits with names, and its codec.
#pragma once
#include <jauscat/wire/scalar.hpp>

#include <initializer_list>

namespace jauscat::wire {

/// Bits named by the enumeration `Bit`, whose values are bit numbers and whose underlying type is as wide as the set.
/// Bits without a name pass through unchanged, because standards assign them later.
template <class Bit>
requires std::is_enum_v<Bit>
class bit_set {
  public:
    /// The enumeration of bit numbers.
    using bit_type = Bit;
    /// The unsigned integer that holds them.
    using bits_type = std::underlying_type_t<Bit>;
    static_assert(std::unsigned_integral<bits_type>, "bit_set: the enumeration's underlying type must be unsigned");

    constexpr bit_set() noexcept = default;
    /// With these bits set.
    constexpr bit_set(std::initializer_list<Bit> set_bits) noexcept {
        for (const Bit bit : set_bits) set(bit);
    }
    /// With all bits as in `bits`, also those without a name.
    [[nodiscard]] static constexpr bit_set from_bits(bits_type bits) noexcept {
        bit_set made;
        made.bits_ = bits;
        return made;
    }

    /// Whether the bit is set.
    [[nodiscard]] constexpr bool test(Bit bit) const noexcept {
        return (bits_ >> static_cast<unsigned>(bit) & 1u) != 0;
    }
    /// Sets or clears a bit.
    constexpr bit_set& set(Bit bit, bool value = true) noexcept {
        const auto mask = static_cast<bits_type>(bits_type{1} << static_cast<unsigned>(bit));
        bits_ = static_cast<bits_type>(value ? bits_ | mask : bits_ & ~mask);
        return *this;
    }
    /// All bits, bit 0 in the lowest place.
    [[nodiscard]] constexpr bits_type bits() const noexcept { return bits_; }

    friend constexpr bool operator==(const bit_set&, const bit_set&) = default;

  private:
    bits_type bits_{};
};

/// A set of bit_set carried by the integer codec `Carrier`.
template <class Bit, codec Carrier> struct bit_set_codec {
    using value_type = bit_set<Bit>;
    static constexpr std::size_t size = Carrier::size;
    static constexpr bool as_in_memory = Carrier::as_in_memory;
    static_assert(std::is_same_v<typename value_type::bits_type, typename Carrier::value_type>,
                  "bit_set_codec: the enumeration's underlying type must be the carrier's integer type");

    JAUSCAT_INLINE static constexpr errc store(std::byte* out, value_type value) noexcept {
        return Carrier::store(out, value.bits());
    }
    JAUSCAT_INLINE static constexpr errc load(const std::byte* in, value_type& value) noexcept {
        typename Carrier::value_type raw{};
        Carrier::load(in, raw);
        value = value_type::from_bits(raw);
        return errc::ok;
    }
};

} // namespace jauscat::wire
