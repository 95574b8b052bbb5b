// A presence vector and the fields it announces (JAUS RA 3.3 part 3; SAE AS5684).
#pragma once
#include <jauscat/wire/layout.hpp>

#include <array>
#include <optional>
#include <tuple>

namespace jauscat::wire {

/// Handling of presence bits that the layout does not define.
enum class unknown_bits {
    refused,  ///< errc::unknown_presence_bit
    ignored,  ///< dropped; the bytes are those of the fields that the layout defines
    tolerated ///< dropped, with all bytes to the end of the body, where later editions append their fields
};

namespace detail {
template <std::size_t Count>
inline constexpr std::uint64_t low_bits = Count == 0 ? 0 : ~std::uint64_t{} >> ((64 - Count) & 63);

inline constexpr std::size_t always_present = ~std::size_t{};

// Size that each four bits of a presence vector add to a message; `Sizes` are those of its items, or always_present.
// Tables, because a population count is a call where the target has no instruction for it, as on x86-64 by default.
// Keyed by sizes, so that messages of the same shape share them.
template <std::size_t... Sizes>
inline constexpr auto sizes_by_nibble = [] {
    using entry =
        std::conditional_t<((Sizes == always_present ? 0 : Sizes) + ... + 0) < 256, std::uint8_t, std::uint16_t>;
    constexpr std::size_t bits = ((Sizes != always_present) + ... + 0);
    std::array<std::array<entry, 16>, (bits + 3) / 4> sums{};
    std::size_t bit = 0;
    const auto add = [&](std::size_t size) {
        if (size == always_present) return;
        for (std::size_t nibble = 0; nibble != 16; ++nibble)
            if ((nibble >> bit % 4 & 1u) != 0) sums[bit / 4][nibble] = static_cast<entry>(sums[bit / 4][nibble] + size);
        ++bit;
    };
    (add(Sizes), ...);
    return sums;
}();
} // namespace detail

/// A bit of the presence vector as a bool member: it announces a field elsewhere (see gated_by) and has no bytes
/// itself.
template <auto Member> struct presence_flag {
    static constexpr auto key = Member;
    using keys = key_list<Member>;
    using value_type = bool;
    using raw_type = bool;
    static constexpr bool optional = false;
    static constexpr bool takes_bit = true;
    static constexpr std::size_t min_size = 0, max_size = 0;
    static_assert(detail::has_type<Member, member_t<Member>, bool>, "presence_flag: the member must be a bool");

    static consteval std::string_view name() { return name_of<Member>(); }
    JAUSCAT_INLINE static constexpr errc put(const auto&, std::byte*) noexcept { return errc::ok; }
    // Not called for a bit that is clear: presence_group clears the member.
    JAUSCAT_INLINE static constexpr errc get(auto& object, const std::byte*) noexcept {
        member_of<Member>(object) = true;
        return errc::ok;
    }
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) {
        visitor(presence_flag{}, member_of<Member>(object));
    }
};

/// Whether the item has a bit in the presence vector that it stands in.
template <class Item> inline constexpr bool takes_bit = Item::optional;
template <class Item>
requires requires { Item::takes_bit; }
inline constexpr bool takes_bit<Item> = true;

/// A presence vector in `Carrier`, then its items. Each item with a std::optional member uses the next bit, from the
/// least significant up, and is present if its bit is set; so does a `presence_flag`. Any other item is always present.
/// If all items have a fixed size, the vector alone determines the total size, and the length is checked once.
template <unknown_bits Unknown, codec Carrier, class... Items> struct presence_group {
    static_assert((detail::checked_item<Items> && ... && true), "presence: an item lacks an operation");
    using carrier_codec = Carrier;
    static constexpr bool tolerant = Unknown == unknown_bits::tolerated; ///< bits that it does not know
    using mask_type = word_for<Carrier>;
    using keys = joined_keys<typename Items::keys...>;
    using refers = joined_keys<references_of<Items>...>;
    static_assert(detail::check_references<Items...>());
    static constexpr bool optional = false;
    static constexpr std::size_t optional_count = (static_cast<std::size_t>(takes_bit<Items>) + ... + 0);
    static constexpr bool all_fixed = (fixed_item<Items> && ... && true);
    static constexpr bool contextual = (is_contextual<Items> || ... || false);
    static constexpr bool needs_memory = (item_needs_memory<Items> || ... || false);
    static constexpr bool checks_values = (item_checks_values<Items> || ... || false);
    static constexpr bool to_the_end = Unknown == unknown_bits::tolerated || (takes_rest<Items> || ... || false);
    static_assert(optional_count <= Carrier::size * 8,
                  "presence: more optional fields than bits in the presence vector");
    static constexpr std::size_t min_size = total_size(Carrier::size, (Items::optional ? 0 : Items::min_size)...);
    static constexpr std::size_t max_size = total_size(Carrier::size, Items::max_size...);
    static_assert(optional_count != 0, "presence: no item is optional, so the vector has nothing to announce");
    static constexpr mask_type known_bits = static_cast<mask_type>(detail::low_bits<optional_count>);

    /// The presence vector that `object` encodes with.
    JAUSCAT_INLINE static constexpr mask_type mask(const auto& object) noexcept {
        mask_type m{};
        std::size_t at = 0;
        if constexpr ((Items::optional && ...) && !raw_object<decltype(object)>)
            ((m |= static_cast<mask_type>((object.*Items::key).has_value()) << at++), ...);
        else
            ((m |= present<Items>(object, at)), ...);
        return m;
    }

    JAUSCAT_INLINE static constexpr std::size_t size(const auto& object, const auto& here) noexcept {
        if constexpr (all_fixed)
            return min_size + announced(mask(object));
        else
            return Carrier::size + (size_if_present<Items>(object, here) + ... + 0);
    }
    JAUSCAT_INLINE static constexpr out_cursor put(const auto& object, out_cursor c, const auto& here) noexcept {
        std::byte* const vector = c.at;
        c.at += Carrier::size;
        mask_type m{};
        std::size_t at = 0;
        static_cast<void>((put_if_present<Items>(object, m, at, c, here) && ...));
        Carrier::store(vector, static_cast<typename Carrier::value_type>(m));
        return c;
    }
    JAUSCAT_INLINE static constexpr in_cursor get(auto& object, in_cursor c, const auto& here) noexcept {
        const mask_type m = loaded(c.at);
        if constexpr (all_fixed) {
            const in_cursor end = end_of(c, m);
            if (end.at == nullptr) return end;
            const std::byte* in = c.at + Carrier::size;
            std::size_t at = 0;
            errc error = errc::ok;
            static_cast<void>((get_fixed<Items>(object, m, at, in, error) && ...));
            return error == errc::ok ? end : in_cursor::failed(error);
        } else {
            set_flags(object, m); // first, because an item before a flag may be gated by it
            std::size_t at = 0;
            static_cast<void>(step_over_vector(c, m) && (get_if_present<Items>(object, m, at, c, here) && ...));
            return behind_items(c, m);
        }
    }
    JAUSCAT_INLINE static constexpr in_cursor measure(in_cursor c, const auto& here) noexcept {
        const mask_type m = loaded(c.at);
        if constexpr (all_fixed) {
            return end_of(c, m);
        } else {
            std::size_t at = 0;
            static_cast<void>(step_over_vector(c, m) && (measure_if_present<Items>(m, at, c, here) && ...));
            return behind_items(c, m);
        }
    }
    JAUSCAT_INLINE static constexpr std::size_t extent(const std::byte* in, const auto& here) noexcept {
        const mask_type m = loaded(in);
        if constexpr (all_fixed)
            return min_size + announced(m);
        else
            return extent_of_first<sizeof...(Items)>(in, m, here);
    }
    /// A member of a presence vector is read as a std::optional.
    template <auto Member, reading Mode>
    JAUSCAT_INLINE static constexpr auto read(const std::byte* in, const auto& here) noexcept {
        using item = std::tuple_element_t<index_of<Member>, std::tuple<Items...>>;
        const mask_type m = loaded(in);
        if constexpr (requires { item::takes_bit; }) {
            return (m & bit_of<Member>) != 0;
        } else {
            using value = decltype(item::template read<Member, Mode>(in, here));
            const std::byte* at = in;
            if constexpr (all_fixed)
                at += Carrier::size + required_before<Member> + announced(m & bits_before<Member>);
            else
                at += extent_of_first<index_of<Member>>(in, m, here);
            if constexpr (!item::optional)
                return item::template read<Member, Mode>(at, here);
            else if constexpr (detail::optional_value<value>::is_optional)
                return (m & bit_of<Member>) ? item::template read<Member, Mode>(at, here) : value{};
            else
                return (m & bit_of<Member>) ? std::optional<value>{item::template read<Member, Mode>(at, here)}
                                            : std::optional<value>{};
        }
    }
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) { (Items::visit(object, visitor), ...); }
    static constexpr bool all_items(auto&& f) { return (f.template operator()<Items>() && ...); }

    JAUSCAT_INLINE static constexpr mask_type loaded(const std::byte* in) noexcept {
        typename Carrier::value_type carrier{};
        Carrier::load(in, carrier);
        return carrier;
    }

    /// Whether `Item` travels with `object`.
    template <class Item> JAUSCAT_INLINE static constexpr bool is_present(const auto& object) noexcept {
        if constexpr (Item::optional)
            return member_of<Item::key>(object).has_value();
        else if constexpr (takes_bit<Item>)
            return member_of<Item::key>(object);
        else
            return true;
    }

    /// Sets the members that are bits of the vector.
    JAUSCAT_INLINE static constexpr void set_flags([[maybe_unused]] auto& object,
                                                   [[maybe_unused]] mask_type m) noexcept {
        if constexpr ((requires { Items::takes_bit; } || ...)) {
            std::size_t at = 0;
            (set_flag<Items>(object, m, at), ...);
        }
    }

  private:
    template <class Item>
    JAUSCAT_INLINE static constexpr mask_type present(const auto& object, std::size_t& at) noexcept {
        if constexpr (!takes_bit<Item>)
            return 0;
        else
            return static_cast<mask_type>(static_cast<bool>(member_of<Item::key>(object))) << at++;
    }

    // Bytes that the set bits stand for.
    JAUSCAT_INLINE static constexpr std::size_t announced(mask_type m) noexcept {
        constexpr auto& sizes =
            detail::sizes_by_nibble<(takes_bit<Items> ? Items::max_size : detail::always_present)...>;
        return [&]<std::size_t... Nibble>(std::index_sequence<Nibble...>) {
            return (std::size_t{} + ... + sizes[Nibble][static_cast<std::size_t>(m >> (Nibble * 4) & 15u)]);
        }(std::make_index_sequence<sizes.size()>{});
    }

    JAUSCAT_INLINE static constexpr in_cursor end_of(in_cursor c, mask_type m) noexcept {
        const std::size_t extra = announced(m);
        if (extra > c.slack) return in_cursor::failed(errc::truncated);
        if ((m & ~known_bits) != 0) {
            if constexpr (Unknown == unknown_bits::refused)
                return in_cursor::failed(errc::unknown_presence_bit);
            else if constexpr (Unknown == unknown_bits::tolerated)
                return {c.at + min_size + c.slack, 0};
        }
        return {c.at + min_size + extra, c.slack - extra};
    }

    template <class Item>
    JAUSCAT_INLINE static constexpr std::size_t size_if_present(const auto& object, const auto& here) noexcept {
        if constexpr (takes_bit<Item>) {
            if (!member_of<Item::key>(object)) return 0;
        }
        return detail::sized<Item>::size(object, here);
    }
    // Members of messages are named without member_of: a function for each of them costs the compiler a tenth of its
    // time.
    template <class Item>
    JAUSCAT_INLINE static constexpr bool put_if_present(const auto& object, mask_type& m, std::size_t& at,
                                                        out_cursor& c, const auto& here) noexcept {
        if constexpr (takes_bit<Item>) {
            const auto bit = mask_type{1} << at++;
            if constexpr (raw_object<decltype(object)>) {
                if (!member_of<Item::key>(object)) return true;
            } else {
                if (!(object.*Item::key)) return true;
            }
            m |= bit;
        }
        if constexpr (fixed_item<Item>) {
            c.error = Item::put(object, c.at);
            if (c.error != errc::ok) return false;
            c.at += Item::max_size;
            return true;
        } else {
            return detail::put_item<Item>(object, c, here);
        }
    }
    template <class Item>
    JAUSCAT_INLINE static constexpr bool get_fixed(auto& object, mask_type m, std::size_t& at, const std::byte*& in,
                                                   errc& error) noexcept {
        if constexpr (takes_bit<Item>) {
            if ((m >> at++ & 1u) == 0) {
                if constexpr (!Item::optional)
                    member_of<Item::key>(object) = false;
                else if constexpr (raw_object<decltype(object)>)
                    member_of<Item::key>(object).reset();
                else
                    (object.*Item::key).reset();
                return true;
            }
        }
        error = Item::get(object, in);
        if (error != errc::ok) return false;
        in += Item::max_size;
        return true;
    }

    template <class Item>
    JAUSCAT_INLINE static constexpr void set_flag([[maybe_unused]] auto& object, [[maybe_unused]] mask_type m,
                                                  [[maybe_unused]] std::size_t& at) noexcept {
        if constexpr (requires { Item::takes_bit; }) member_of<Item::key>(object) = (m >> at & 1u) != 0;
        if constexpr (takes_bit<Item>) ++at;
    }

    // False for a vector that is refused.
    JAUSCAT_INLINE static constexpr bool step_over_vector(in_cursor& c, [[maybe_unused]] mask_type m) noexcept {
        if constexpr (Unknown == unknown_bits::refused) {
            if ((m & ~known_bits) != 0) {
                c = in_cursor::failed(errc::unknown_presence_bit);
                return false;
            }
        }
        c.at += Carrier::size;
        return true;
    }
    JAUSCAT_INLINE static constexpr in_cursor behind_items(in_cursor c, [[maybe_unused]] mask_type m) noexcept {
        if constexpr (Unknown == unknown_bits::tolerated) {
            if (c.at != nullptr && (m & ~known_bits) != 0) return {c.at + c.slack, 0};
        }
        return c;
    }
    template <class Item>
    JAUSCAT_INLINE static constexpr bool get_if_present(auto& object, mask_type m, [[maybe_unused]] std::size_t& at,
                                                        in_cursor& c, const auto& here) noexcept {
        if constexpr (takes_bit<Item>) {
            if ((m >> at++ & 1u) == 0) {
                if constexpr (Item::optional) member_of<Item::key>(object).reset(); // a flag is clear already
                return true;
            }
            if (!detail::spend(c, Item::min_size)) return false;
        }
        return detail::get_item<Item>(object, c, here);
    }
    template <class Item>
    JAUSCAT_INLINE static constexpr bool measure_if_present(mask_type m, [[maybe_unused]] std::size_t& at, in_cursor& c,
                                                            const auto& here) noexcept {
        if constexpr (takes_bit<Item>) {
            if ((m >> at++ & 1u) == 0) return true;
            if (!detail::spend(c, Item::min_size)) return false;
        }
        return detail::measure_item<Item>(c, here);
    }
    // Bytes of the vector and of the first `Count` items.
    template <std::size_t Count>
    JAUSCAT_INLINE static constexpr std::size_t extent_of_first(const std::byte* in, mask_type m,
                                                                const auto& here) noexcept {
        std::size_t total = Carrier::size, at = 0, index = 0;
        const auto add = [&]<class Item>() {
            bool present = true;
            if constexpr (takes_bit<Item>) present = (m >> at++ & 1u) != 0;
            if (index++ < Count && present) total += detail::extent_of_item<Item>(in + total, here);
        };
        (add.template operator()<Items>(), ...);
        return total;
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
        ((count += takes_bit<Items> && index < index_of<Member>, ++index), ...);
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

/// A presence vector that ignores bits it does not define, for peers that set all bits and send the fields of the
/// standard.
template <codec Carrier, class... Items>
using lenient_presence = presence_group<unknown_bits::ignored, Carrier, Items...>;

/// A presence vector that tolerates bits it does not define, and drops the bytes they stand for. Use it only as the
/// last item, and only where peers are known to send more than the standard.
template <codec Carrier, class... Items>
using open_presence = presence_group<unknown_bits::tolerated, Carrier, Items...>;

} // namespace jauscat::wire
