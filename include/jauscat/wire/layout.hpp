// A layout lists the parts of a message in wire order; a schema gives a struct its layout, and the pair is checked
// here.
#pragma once
#include <jauscat/wire/layout_item.hpp>
#include <jauscat/wire/missing_member.hpp>
#include <jauscat/wire/packed_size.hpp>
#include <jauscat/wire/scalar.hpp>
#include <jauscat/wire/scope.hpp>

#include <array>
#include <concepts>
#include <tuple>

namespace jauscat::wire {

/// The schema of a message: its layout as `type`, and what else belongs to it, such as its command code. It stands in
/// the message, as `struct schema { using type = layout<...>; };`. For a type that cannot have it: `template <> struct
/// wire::schema<T> { using type = layout<...>; };`.
template <class T> struct schema;
template <class T>
requires requires { typename T::schema::type; }
struct schema<T> : T::schema {};

/// Name of an item: its own, or that of its first member.
template <class Item> consteval std::string_view item_label() {
    if constexpr (requires { Item::name(); }) {
        return Item::name();
    } else {
        return []<auto... Members>(key_list<Members...>) {
            const std::array<std::string_view, sizeof...(Members) + 1> names{name_of<Members>()..., "reserved"};
            return names[0];
        }(typename Item::keys{});
    }
}

namespace detail {
/// Takes `size` bytes from those beyond the layout's minimum; false where there are not so many.
JAUSCAT_INLINE constexpr bool spend(in_cursor& c, std::size_t size) noexcept {
    if (size > c.slack) {
        c = in_cursor::failed(errc::truncated);
        return false;
    }
    c.slack -= size;
    return true;
}

/// What tells the size of an item: one function for all items that take `Size` bytes.
template <std::size_t Size> struct always_sized {
    JAUSCAT_INLINE static constexpr std::size_t size(const auto&, const auto&) noexcept { return Size; }
};
template <class Item>
using sized = std::conditional_t<Item::min_size == Item::max_size, always_sized<Item::max_size>, Item>;
// Few layers: each is a function for each field, and the compiler's time goes by their number.
template <class Item>
JAUSCAT_INLINE constexpr bool put_item(const auto& object, out_cursor& c, [[maybe_unused]] const auto& here) noexcept {
    if constexpr (fixed_item<Item>) {
        c.error = Item::put(object, c.at);
        if (c.error == errc::ok) c.at += Item::max_size;
    } else {
        c = Item::put(object, c, here);
    }
    return c.error == errc::ok;
}
template <class Item>
JAUSCAT_INLINE constexpr bool get_item(auto& object, in_cursor& c, [[maybe_unused]] const auto& here) noexcept {
    if constexpr (fixed_item<Item>) {
        const errc error = Item::get(object, c.at);
        c = error == errc::ok ? in_cursor{c.at + Item::max_size, c.slack} : in_cursor::failed(error);
    } else {
        c = Item::get(object, c, here);
    }
    return c.at != nullptr;
}
template <class Item> JAUSCAT_INLINE constexpr bool measure_item(in_cursor& c, const auto& here) noexcept {
    if constexpr (fixed_item<Item>)
        c.at += Item::max_size;
    else
        c = Item::measure(c, here);
    return c.at != nullptr;
}
template <class Item>
JAUSCAT_INLINE constexpr std::size_t extent_of_item([[maybe_unused]] const std::byte* in,
                                                    [[maybe_unused]] const auto& here) noexcept {
    if constexpr (fixed_item<Item>)
        return Item::max_size;
    else if constexpr (requires { Item::extent(in, here); })
        return Item::extent(in, here);
    else
        return static_cast<std::size_t>(
            Item::measure({in, static_cast<std::size_t>(here.end - in) - Item::min_size}, here).at - in);
}
// Past an item of `Size` bytes; for all items of that size, so that layouts of fixed items need no function for each.
template <std::size_t Size> JAUSCAT_INLINE constexpr bool put_next(errc error, out_cursor& c) noexcept {
    c.error = error;
    if (error == errc::ok) c.at += Size;
    return error == errc::ok;
}
template <std::size_t Size> JAUSCAT_INLINE constexpr bool get_next(errc error, in_cursor& c) noexcept {
    c = error == errc::ok ? in_cursor{c.at + Size, c.slack} : in_cursor::failed(error);
    return error == errc::ok;
}
} // namespace detail

namespace detail {

/// Which of the items has the member; their number: none. The flags of a presence vector are known before all items.
template <auto Member, class... Items> consteval std::size_t place_of() {
    std::size_t place = 0;
    static_cast<void>((... || (Items::keys::template holds<Member> || (++place, false))));
    const bool is_flag = ((Items::keys::template holds<Member> && requires { Items::takes_bit; }) || ... || false);
    return is_flag ? 0 : place;
}
template <class Item, class... Items> consteval bool refers_back(std::size_t place) {
    return [place]<auto... Members>(key_list<Members...>) {
        return (... && (place_of<Members, Items...>() <= place || place_of<Members, Items...>() == sizeof...(Items)));
    }(references_of<Item>{});
}
/// No item refers to a member that comes behind it: it is decoded before.
template <class... Items> consteval bool all_refer_back() {
    if constexpr ((references_of<Items>::count + ... + 0) != 0) {
        std::size_t place = 0;
        return (... && refers_back<Items, Items...>(place++));
    } else {
        return true;
    }
}
/// Says which of the items refers to one behind it.
template <class Item, std::size_t Place, class... Items> struct item_behind {
    static_assert(refers_back<Item, Items...>(Place),
                  "layout: a count, tag or flag stands behind what it is for; it must come before");
};
template <class... Items> consteval bool check_references() {
    if constexpr (!all_refer_back<Items...>())
        [&]<std::size_t... I>(std::index_sequence<I...>) {
            static_cast<void>((sizeof(item_behind<Items, I, Items...>) + ...));
        }(std::index_sequence_for<Items...>{});
    return true;
}
/// Says which of the items has a member that may be absent.
template <class Item> struct item_always_there {
    static_assert(!Item::optional, "layout: a std::optional member needs a presence vector");
};
template <class... Items> consteval bool check_optional() {
    if constexpr ((Items::optional || ... || false)) static_cast<void>((sizeof(item_always_there<Items>) + ...));
    return true;
}

/// The members that items refer to and do not have themselves.
template <class Keys, auto... Members> consteval auto outside(key_list<Members...>) {
    return joined_keys<std::conditional_t<Keys::template holds<Members>, key_list<>, key_list<Members>>...>{};
}
template <class Keys, class... Items> consteval auto outer_references() {
    if constexpr ((references_of<Items>::count + ... + 0) != 0)
        return outside<Keys>(joined_keys<references_of<Items>...>{});
    else
        return key_list<>{};
}

} // namespace detail

/// Items in wire order.
template <class... Items> struct layout {
    static_assert((detail::checked_item<Items> && ... && true), "layout: an item lacks an operation");
    using keys = joined_keys<typename Items::keys...>;
    using refers = decltype(detail::outer_references<keys, Items...>());
    static_assert(detail::check_references<Items...>() && detail::check_optional<Items...>());
    static constexpr std::size_t min_size = total_size(Items::min_size...);
    static constexpr std::size_t max_size = total_size(Items::max_size...);
    static constexpr bool contextual = (is_contextual<Items> || ... || false);
    static constexpr bool needs_memory = (item_needs_memory<Items> || ... || false);
    static constexpr bool checks_values = (item_checks_values<Items> || ... || false);
    static constexpr bool to_the_end = (takes_rest<Items> || ... || false);
    static_assert(
        [] {
            std::size_t index = 0, after = 0;
            ((after += takes_rest<Items> && index + 1 != sizeof...(Items), ++index), ...);
            return after == 0;
        }(),
        "layout: an item that takes the rest of the body must be the last one");

    JAUSCAT_INLINE static constexpr std::size_t size([[maybe_unused]] const auto& object,
                                                     [[maybe_unused]] const auto& here) noexcept {
        return (detail::sized<Items>::size(object, here) + ... + 0);
    }
    JAUSCAT_INLINE static constexpr out_cursor put([[maybe_unused]] const auto& object, out_cursor c,
                                                   [[maybe_unused]] const auto& here) noexcept {
        if constexpr (all_fixed)
            static_cast<void>((detail::put_next<Items::max_size>(Items::put(object, c.at), c) && ...));
        else if constexpr (sizeof...(Items) == 1)
            ((c = Items::put(object, c, here)), ...);
        else
            static_cast<void>((detail::put_item<Items>(object, c, here) && ...));
        return c;
    }
    JAUSCAT_INLINE static constexpr in_cursor get([[maybe_unused]] auto& object, in_cursor c,
                                                  [[maybe_unused]] const auto& here) noexcept {
        if constexpr (all_fixed)
            static_cast<void>((detail::get_next<Items::max_size>(Items::get(object, c.at), c) && ...));
        else if constexpr (sizeof...(Items) == 1)
            ((c = Items::get(object, c, here)), ...);
        else
            static_cast<void>((detail::get_item<Items>(object, c, here) && ...));
        return c;
    }
    JAUSCAT_INLINE static constexpr in_cursor measure(in_cursor c, [[maybe_unused]] const auto& here) noexcept {
        static_cast<void>((detail::measure_item<Items>(c, here) && ...));
        return c;
    }
    JAUSCAT_INLINE static constexpr std::size_t extent([[maybe_unused]] const std::byte* in,
                                                       [[maybe_unused]] const auto& here) noexcept {
        std::size_t total = 0;
        ((total += detail::extent_of_item<Items>(in + total, here)), ...);
        return total;
    }
    template <auto Member, reading Mode>
    JAUSCAT_INLINE static constexpr auto read(const std::byte* in, const auto& here) noexcept {
        static_assert(keys::template holds<Member>, "view: the message has no such member in its layout");
        constexpr std::size_t index = index_of<Member>;
        [&]<std::size_t... Before>(std::index_sequence<Before...>) {
            ((in += detail::extent_of_item<std::tuple_element_t<Before, std::tuple<Items...>>>(in, here)), ...);
        }(std::make_index_sequence<index>{});
        using item = std::tuple_element_t<index, std::tuple<Items...>>;
        static_assert(
            requires { item::template read<Member, Mode>(in, here); },
            "view: the item of this member has no read<Member, reading>(const std::byte*, scope)");
        return item::template read<Member, Mode>(in, here);
    }
    JAUSCAT_INLINE static constexpr void visit([[maybe_unused]] auto& object, [[maybe_unused]] auto&& visitor) {
        (Items::visit(object, visitor), ...);
    }
    /// Calls f.template operator()<Item>() for each item in wire order; stops when it returns false.
    static constexpr bool all_items([[maybe_unused]] auto&& f) { return (f.template operator()<Items>() && ...); }

  private:
    static constexpr bool all_fixed = (fixed_item<Items> && ... && true);

    template <auto Member>
    static constexpr std::size_t index_of = [] {
        std::size_t index = 0;
        static_cast<void>((... || (Items::keys::template holds<Member> || (++index, false))));
        return index;
    }();
};

namespace detail {

// By their spelling: to compare the pointers themselves would take a template for each pair, and addresses of variables
// made from them are no constants for g++ with -fsanitize=undefined.
template <auto Member> inline constexpr std::string_view spelling = spelling_of<Member>();
template <auto... Members> consteval bool listed_once(key_list<Members...>) {
    const std::array<std::string_view, sizeof...(Members) + 1> spellings{spelling<Members>..., std::string_view{}};
    for (std::size_t i = 0; i != sizeof...(Members); ++i)
        for (std::size_t j = 0; j != i; ++j) {
            const auto a = spellings[i], b = spellings[j];
            if (a.size() == b.size() && __builtin_memcmp(a.data(), b.data(), a.size()) == 0) return false;
        }
    return true;
}
template <auto Member, auto... Members> consteval std::size_t times_in(key_list<Members...>) {
    return (std::size_t{listed_once(key_list<Member, Members>{}) ? 0U : 1U} + ... + 0);
}
template <class T, auto... Members> consteval bool owned_by(key_list<Members...>) {
    return (std::is_same_v<owner_t<Members>, T> && ... && true);
}
/// Say which of the members it is.
template <class T, auto Member> struct own_member {
    static_assert(has_type<Member, owner_t<Member>, T>, "layout: a field names a member of another struct");
};
template <auto Member, std::size_t Times> struct member_once {
    static_assert(Times == 1, "layout: a member is listed twice");
};
template <class T, auto... Members> consteval bool check_members(key_list<Members...>) {
    if constexpr (!owned_by<T>(key_list<Members...>{})) {
        static_cast<void>((sizeof(own_member<T, Members>) + ...));
    } else if constexpr (!listed_once(key_list<Members...>{})) {
        static_cast<void>((sizeof(member_once<Members, times_in<Members>(key_list<Members...>{})>) + ...));
    }
    return true;
}

} // namespace detail

/// The layout of `T`, after the checks that need both the struct and its schema.
template <class T> struct checked_schema {
    static_assert(
        requires { typename schema<T>::type; }, "the type has no schema: give it a struct schema with its "
                                                "layout as type, or specialise jauscat::wire::schema for it");
    using type = typename schema<T>::type;
    using keys = typename type::keys;
    static_assert(std::is_aggregate_v<T>, "layout: a message must be a plain aggregate");
    static_assert(detail::check_members<T>(keys{}));
    static constexpr bool too_few =
        detail::owned_by<T>(keys{}) && detail::listed_once(keys{}) && has_more_members_than<T, keys::count>;
    using missing = detail::missing_member<T, keys, too_few>;
    static_assert(!missing::unnamed, "layout: a member of the message is missing from its layout");
};
/// The layout of a structure, checked against its members.
template <class T> using layout_of = typename checked_schema<T>::type;

/// A struct with a schema, or the `raw` of one.
template <class T> concept message = requires { typename schema<T>::type; };

/// Fewest and most bytes that a `T` takes; `unbounded` where there is no most.
template <message T> inline constexpr std::size_t min_size = layout_of<T>::min_size;
template <message T> inline constexpr std::size_t max_size = layout_of<T>::max_size;

/// No `T` is longer than a packed_size can say.
template <message T> inline constexpr bool never_too_long = max_size<T> <= packed_size<errc>::max_size;

/// Always the same number of bytes.
template <class T> concept fixed_message = message<T> && fixed_item<layout_of<T>>;

/// Decoding a `T` takes an arena for its lists.
template <message T> inline constexpr bool needs_memory = layout_of<T>::needs_memory;

} // namespace jauscat::wire
