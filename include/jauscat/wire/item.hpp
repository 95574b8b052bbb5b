// Base of all items: cursors, keys, sizes.
//
// An item describes some consecutive bytes and the members they carry. It offers
//   keys                      the member pointers it carries, in wire order
//   min_size, max_size        bytes
//   put, get                  write and read; fixed items take a pointer, variable ones a cursor
//   size(object)              variable items: bytes that `object` needs
//   measure(cursor)           variable items: steps over it and checks that it is complete
//   extent(bytes)             where that is faster than measure: bytes it takes in a message that was measured before
//   visit(object, f)          calls f(leaf item, member) for each member
//   read<Member, Mode>(bytes) one member out of measured bytes
//   refers                    the members that it looks at to be decoded; left out where there are none
// Variable items take the scope they stand in as their last argument (see scope.hpp).
// All of it is forced inline: only whole messages are worth a call, and offsets fold to constants.
#pragma once
#include <jauscat/wire/errc.hpp>
#include <jauscat/wire/member.hpp>

#include <array>
#include <cstddef>
#include <type_traits>

namespace jauscat::wire {

/// Position and error of encoding.
struct out_cursor {
    std::byte* at;
    errc error;
};

/// Position of decoding. `slack` counts the bytes beyond the layout's minimum: only variable items use it, so a fixed
/// field is never checked twice. A null pointer means that decoding has failed; `slack` then holds the errc.
struct in_cursor {
    const std::byte* at;
    std::size_t slack;

    /// The cursor of a decoding that failed.
    [[nodiscard]] static constexpr in_cursor failed(errc error) noexcept {
        return {nullptr, static_cast<std::size_t>(error)};
    }
    [[nodiscard]] constexpr errc error() const noexcept { return at ? errc::ok : static_cast<errc>(slack); }
};

/// Pointers to members, in wire order.
template <auto... Members> struct key_list {
    static constexpr std::size_t count = sizeof...(Members); ///< how many
    /// Whether the member is one of them.
    template <auto Member> static constexpr bool holds = (std::is_same_v<key_list<Member>, key_list<Members>> || ...);
};

namespace detail {
template <class... Lists> struct joined {
    using type = key_list<>;
};
template <auto... Members> struct joined<key_list<Members...>> {
    using type = key_list<Members...>;
};
template <auto... A, auto... B, class... More>
struct joined<key_list<A...>, key_list<B...>, More...> : joined<key_list<A..., B...>, More...> {};
} // namespace detail
template <class... Lists> using joined_keys = typename detail::joined<Lists...>::type;

/// The size of what has no upper limit.
inline constexpr std::size_t unbounded = ~std::size_t{};
[[nodiscard]] constexpr std::size_t add_sizes(std::size_t a, std::size_t b) noexcept {
    return a > unbounded - b ? unbounded : a + b;
}
template <class... Sizes> [[nodiscard]] constexpr std::size_t total_size(Sizes... sizes) noexcept {
    std::size_t total = 0;
    ((total = add_sizes(total, sizes)), ...);
    return total;
}

/// An item is `contextual` if it reads members of enclosing structures.
template <class Item> inline constexpr bool is_contextual = false;
template <class Item>
requires requires { Item::contextual; }
inline constexpr bool is_contextual<Item> = Item::contextual;
/// An item has `needs_memory` if it decodes into an arena.
template <class Item> inline constexpr bool item_needs_memory = false;
template <class Item>
requires requires { Item::needs_memory; }
inline constexpr bool item_needs_memory<Item> = Item::needs_memory;
/// An item has `checks_values` if a codec or a count in it has a value set.
template <class Item> inline constexpr bool item_checks_values = false;
template <class Item>
requires requires { Item::checks_values; }
inline constexpr bool item_checks_values<Item> = Item::checks_values;
/// An item has `takes_rest` if it contains all remaining bytes.
template <class Item> inline constexpr bool takes_rest = false;
template <class Item>
requires requires { Item::to_the_end; }
inline constexpr bool takes_rest<Item> = Item::to_the_end;

/// Members that an item, a count or a tag refers to, of the structure that it stands in or of one around it.
template <class Item> inline constexpr key_list<> references{};
template <class Item>
requires requires { typename Item::refers; }
inline constexpr typename Item::refers references<Item>{};
template <class Item> using references_of = std::remove_const_t<decltype(references<Item>)>;

template <class Item> concept fixed_item = Item::min_size == Item::max_size && !is_contextual<Item>;

/// Marks an object with raw integers as scaled fields.
template <class Object> concept raw_object = requires { typename std::remove_cvref_t<Object>::raw_of; };

/// The member `Member` of a value, or its slot in a `raw`.
template <auto Member, class Object> JAUSCAT_INLINE constexpr auto& member_of(Object& object) noexcept {
    if constexpr (raw_object<Object>)
        return object.*Object::template place<Member>;
    else
        return object.*Member;
}
/// The value in a std::optional member, or the member itself.
template <auto Member> JAUSCAT_INLINE constexpr auto& value_of(auto& object) noexcept {
    if constexpr (is_optional_member<Member>)
        return *member_of<Member>(object);
    else if constexpr (raw_object<decltype(object)>)
        return member_of<Member>(object);
    else
        return object.*Member;
}
/// The same for a member that is about to be decoded.
template <auto Member> JAUSCAT_INLINE constexpr auto& emplace_in(auto& object) noexcept {
    if constexpr (is_optional_member<Member>)
        return member_of<Member>(object).emplace();
    else if constexpr (raw_object<decltype(object)>)
        return member_of<Member>(object);
    else
        return object.*Member;
}

/// Mode of a view: real values, or the integers on the wire.
enum class reading { real, raw };

namespace detail {
template <class Codec, bool Raw> struct codec_in_mode {
    using type = Codec;
};
template <class Codec>
requires requires { typename Codec::raw_codec; }
struct codec_in_mode<Codec, true> {
    using type = typename Codec::raw_codec;
};
} // namespace detail
/// The codec itself, or the carrier of a scaled one where raw values are wanted.
template <class Codec, bool Raw> using codec_in_mode = typename detail::codec_in_mode<Codec, Raw>::type;

} // namespace jauscat::wire
