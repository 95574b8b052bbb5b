// A presence vector and the fields it announces (JAUS RA 3.3 part 3; SAE AS5684).
#pragma once
#include <jauscat/wire/item.hpp>
#include <jauscat/wire/scalar.hpp>

#include <array>
#include <optional>
#include <tuple>

namespace jauscat::wire {

/// What a presence vector does with bits that its layout does not define.
enum class unknown_bits {
    refused,  ///< errc::unknown_presence_bit
    tolerated ///< dropped, with all bytes to the end of the body, where later editions append their fields
};

namespace detail {
template <std::size_t Count>
inline constexpr std::uint64_t low_bits = Count == 0 ? 0 : ~std::uint64_t{} >> ((64 - Count) & 63);

inline constexpr std::size_t always_there = ~std::size_t{};

// What each four bits of a presence vector add to a message's size; `Sizes` are those of its items, or always_there.
// Tables, because a population count is a call where the target has no instruction for it, as on x86-64 by default.
// Keyed by sizes, so that messages of the same shape share them.
template <std::size_t... Sizes>
inline constexpr auto sizes_by_nibble = [] {
    using entry =
        std::conditional_t<((Sizes == always_there ? 0 : Sizes) + ... + 0) < 256, std::uint8_t, std::uint16_t>;
    constexpr std::size_t bits = ((Sizes != always_there) + ... + 0);
    std::array<std::array<entry, 16>, (bits + 3) / 4> table{};
    std::size_t bit = 0;
    const auto add = [&](std::size_t size) {
        if (size == always_there) return;
        for (std::size_t nibble = 0; nibble != 16; ++nibble)
            if ((nibble >> bit % 4 & 1u) != 0)
                table[bit / 4][nibble] = static_cast<entry>(table[bit / 4][nibble] + size);
        ++bit;
    };
    (add(Sizes), ...);
    return table;
}();
} // namespace detail

/// A presence vector in `Carrier`, then its items. Each item with a std::optional member takes the next bit, from the
/// least significant up, and is there when its bit is set; an item without one is always there.
template <unknown_bits Unknown, codec Carrier, class... Items> struct presence_group {
    using carrier_codec = Carrier;
    using mask_type = word_for<Carrier>;
    using keys = joined_keys<typename Items::keys...>;
    static constexpr bool optional = false;
    static constexpr std::size_t optional_count = (static_cast<std::size_t>(Items::optional) + ... + 0);
    static_assert((fixed_item<Items> && ... && true), "presence: each item must have a fixed size");
    static_assert(optional_count <= Carrier::size * 8,
                  "presence: more optional fields than bits in the presence vector");
    static constexpr std::size_t required_size = ((Items::optional ? 0 : Items::max_size) + ... + 0);
    static constexpr std::size_t min_size = Carrier::size + required_size;
    static constexpr std::size_t max_size = Carrier::size + (Items::max_size + ... + 0);
    static_assert(max_size > min_size, "presence: no item is optional, so the vector has nothing to announce");
    static constexpr mask_type known_bits = static_cast<mask_type>(detail::low_bits<optional_count>);

    /// The presence vector that `object` encodes with.
    [[gnu::always_inline]] static constexpr mask_type mask(const auto& object) noexcept {
        mask_type m{};
        std::size_t at = 0;
        ((m |= present<Items>(object, at)), ...);
        return m;
    }

    [[gnu::always_inline]] static constexpr std::size_t size(const auto& object) noexcept {
        return min_size + announced(mask(object));
    }
    [[gnu::always_inline]] static constexpr out_cursor put(const auto& object, out_cursor c) noexcept {
        std::byte* const vector = c.at;
        c.at += Carrier::size;
        mask_type m{};
        std::size_t at = 0;
        static_cast<void>((put_item<Items>(object, m, at, c) && ...));
        Carrier::store(vector, static_cast<typename Carrier::value_type>(m));
        return c;
    }
    [[gnu::always_inline]] static constexpr in_cursor get(auto& object, in_cursor c) noexcept {
        const mask_type m = loaded(c.at);
        const in_cursor end = end_of(c, m);
        if (end.at == nullptr) return end;
        const std::byte* in = c.at + Carrier::size;
        std::size_t at = 0;
        errc error = errc::ok;
        static_cast<void>((get_item<Items>(object, m, at, in, error) && ...));
        return error == errc::ok ? end : in_cursor::failed(error);
    }
    [[gnu::always_inline]] static constexpr in_cursor measure(in_cursor c) noexcept {
        const mask_type m = loaded(c.at);
        return end_of(c, m);
    }
    [[gnu::always_inline]] static constexpr std::size_t extent(const std::byte* in) noexcept {
        const mask_type m = loaded(in);
        return min_size + announced(m);
    }
    /// A member of a presence vector is read as a std::optional.
    template <auto Member, reading Mode>
    [[gnu::always_inline]] static constexpr auto read(const std::byte* in) noexcept {
        using item = std::tuple_element_t<index_of<Member>, std::tuple<Items...>>;
        using value = decltype(item::template read<Member, Mode>(in));
        const mask_type m = loaded(in);
        const std::byte* const at = in + Carrier::size + required_before<Member> + announced(m & bits_before<Member>);
        if constexpr (!item::optional)
            return item::template read<Member, Mode>(at);
        else if constexpr (detail::optional_value<value>::is_optional)
            return (m & bit_of<Member>) ? item::template read<Member, Mode>(at) : value{};
        else
            return (m & bit_of<Member>) ? std::optional<value>{item::template read<Member, Mode>(at)}
                                        : std::optional<value>{};
    }
    [[gnu::always_inline]] static constexpr void visit(auto& object, auto&& visitor) {
        (Items::visit(object, visitor), ...);
    }
    static constexpr bool all_items(auto&& f) { return (f.template operator()<Items>() && ...); }

    [[gnu::always_inline]] static constexpr mask_type loaded(const std::byte* in) noexcept {
        typename Carrier::value_type carrier{};
        Carrier::load(in, carrier);
        return carrier;
    }

  private:
    template <class Item>
    [[gnu::always_inline]] static constexpr mask_type present(const auto& object, std::size_t& at) noexcept {
        if constexpr (Item::optional)
            return mask_type{member_of<Item::key>(object).has_value()} << at++;
        else
            return 0;
    }

    // Bytes that the set bits stand for.
    [[gnu::always_inline]] static constexpr std::size_t announced(mask_type m) noexcept {
        constexpr auto& sizes = detail::sizes_by_nibble<(Items::optional ? Items::max_size : detail::always_there)...>;
        return [&]<std::size_t... Nibble>(std::index_sequence<Nibble...>) {
            return (std::size_t{} + ... + sizes[Nibble][static_cast<std::size_t>(m >> (Nibble * 4) & 15u)]);
        }
        (std::make_index_sequence<sizes.size()>{});
    }

    [[gnu::always_inline]] static constexpr in_cursor end_of(in_cursor c, mask_type m) noexcept {
        const std::size_t extra = announced(m);
        if (extra > c.slack) return in_cursor::failed(errc::truncated);
        if ((m & ~known_bits) != 0) {
            if constexpr (Unknown == unknown_bits::refused)
                return in_cursor::failed(errc::unknown_presence_bit);
            else
                return {c.at + min_size + c.slack, 0};
        }
        return {c.at + min_size + extra, c.slack - extra};
    }

    template <class Item>
    [[gnu::always_inline]] static constexpr bool put_item(const auto& object, mask_type& m, std::size_t& at,
                                                          out_cursor& c) noexcept {
        if constexpr (Item::optional) {
            const auto bit = mask_type{1} << at++;
            if (!member_of<Item::key>(object)) return true;
            m |= bit;
        }
        c.error = Item::put(object, c.at);
        if (c.error != errc::ok) return false;
        c.at += Item::max_size;
        return true;
    }
    template <class Item>
    [[gnu::always_inline]] static constexpr bool get_item(auto& object, mask_type m, std::size_t& at,
                                                          const std::byte*& in, errc& error) noexcept {
        if constexpr (Item::optional) {
            if ((m >> at++ & 1u) == 0) {
                member_of<Item::key>(object).reset();
                return true;
            }
        }
        error = Item::get(object, in);
        if (error != errc::ok) return false;
        in += Item::max_size;
        return true;
    }

    template <auto Member>
    static constexpr std::size_t index_of = [] {
        std::size_t index = 0;
        static_cast<void>((... || (Items::keys::template holds<Member> || (++index, false))));
        return index;
    }();
    template <auto Member>
    static constexpr std::size_t optionals_before = [] {
        std::size_t count = 0, index = 0;
        ((count += Items::optional && index < index_of<Member>, ++index), ...);
        return count;
    }();
    template <auto Member>
    static constexpr std::size_t required_before = [] {
        std::size_t bytes = 0, index = 0;
        ((bytes += !Items::optional && index < index_of<Member> ? Items::max_size : 0, ++index), ...);
        return bytes;
    }();
    template <auto Member>
    static constexpr auto bit_of = static_cast<mask_type>(std::uint64_t{1} << (optionals_before<Member> & 63));
    template <auto Member>
    static constexpr mask_type bits_before = static_cast<mask_type>(detail::low_bits<optionals_before<Member>>);
};

/// A presence vector that refuses bits it does not define.
template <codec Carrier, class... Items> using presence = presence_group<unknown_bits::refused, Carrier, Items...>;

/// A presence vector that tolerates bits it does not define, and drops the bytes they stand for. Use it only as the
/// last item, and only where peers are known to send more than the standard.
template <codec Carrier, class... Items>
using open_presence = presence_group<unknown_bits::tolerated, Carrier, Items...>;

} // namespace jauscat::wire
