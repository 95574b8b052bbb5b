// A layout lists the parts of a message in wire order; a schema gives a struct its layout, and the pair is checked
// here.
#pragma once
#include <jauscat/wire/item.hpp>

#include <array>
#include <concepts>
#include <tuple>

namespace jauscat::wire {

/// Specialise for a message: `template <> struct schema<T> { using type = layout<...>; };`
template <class T> struct schema;

/// Items in wire order.
template <class... Items> struct layout {
    using keys = joined_keys<typename Items::keys...>;
    static_assert((!Items::optional && ... && true), "layout: a std::optional member needs a presence vector");
    static constexpr std::size_t min_size = (Items::min_size + ... + 0);
    static constexpr std::size_t max_size = (Items::max_size + ... + 0);

    [[gnu::always_inline]] static constexpr std::size_t size([[maybe_unused]] const auto& object) noexcept {
        return (item_size<Items>(object) + ... + 0);
    }
    [[gnu::always_inline]] static constexpr out_cursor put([[maybe_unused]] const auto& object, out_cursor c) noexcept {
        static_cast<void>((put_item<Items>(object, c) && ...));
        return c;
    }
    [[gnu::always_inline]] static constexpr in_cursor get([[maybe_unused]] auto& object, in_cursor c) noexcept {
        static_cast<void>((get_item<Items>(object, c) && ...));
        return c;
    }
    [[gnu::always_inline]] static constexpr in_cursor measure(in_cursor c) noexcept {
        static_cast<void>((measure_item<Items>(c) && ...));
        return c;
    }
    [[gnu::always_inline]] static constexpr std::size_t extent([[maybe_unused]] const std::byte* in) noexcept {
        std::size_t total = 0;
        ((total += item_extent<Items>(in + total)), ...);
        return total;
    }
    template <auto Member, reading Mode>
    [[gnu::always_inline]] static constexpr auto read(const std::byte* in) noexcept {
        static_assert(keys::template holds<Member>, "view: the message has no such member in its layout");
        constexpr std::size_t index = index_of<Member>;
        [&]<std::size_t... Before>(std::index_sequence<Before...>) {
            ((in += item_extent<std::tuple_element_t<Before, std::tuple<Items...>>>(in)), ...);
        }
        (std::make_index_sequence<index>{});
        return std::tuple_element_t<index, std::tuple<Items...>>::template read<Member, Mode>(in);
    }
    [[gnu::always_inline]] static constexpr void visit([[maybe_unused]] auto& object, [[maybe_unused]] auto&& visitor) {
        (Items::visit(object, visitor), ...);
    }
    /// Calls f.template operator()<Item>() for each item in wire order; stops when it returns false.
    static constexpr bool all_items([[maybe_unused]] auto&& f) { return (f.template operator()<Items>() && ...); }

  private:
    template <auto Member>
    static constexpr std::size_t index_of = [] {
        std::size_t index = 0;
        static_cast<void>((... || (Items::keys::template holds<Member> || (++index, false))));
        return index;
    }();

    template <class Item> [[gnu::always_inline]] static constexpr std::size_t item_size(const auto& object) noexcept {
        if constexpr (fixed_item<Item>)
            return Item::max_size;
        else
            return Item::size(object);
    }
    template <class Item>
    [[gnu::always_inline]] static constexpr bool put_item(const auto& object, out_cursor& c) noexcept {
        if constexpr (fixed_item<Item>) {
            c.error = Item::put(object, c.at);
            if (c.error == errc::ok) c.at += Item::max_size;
        } else {
            c = Item::put(object, c);
        }
        return c.error == errc::ok;
    }
    template <class Item> [[gnu::always_inline]] static constexpr bool get_item(auto& object, in_cursor& c) noexcept {
        if constexpr (fixed_item<Item>) {
            const errc error = Item::get(object, c.at);
            c = error == errc::ok ? in_cursor{c.at + Item::max_size, c.slack} : in_cursor::failed(error);
        } else {
            c = Item::get(object, c);
        }
        return c.at != nullptr;
    }
    template <class Item> [[gnu::always_inline]] static constexpr bool measure_item(in_cursor& c) noexcept {
        if constexpr (fixed_item<Item>)
            c.at += Item::max_size;
        else
            c = Item::measure(c);
        return c.at != nullptr;
    }
    template <class Item>
    [[gnu::always_inline]] static constexpr std::size_t item_extent([[maybe_unused]] const std::byte* in) noexcept {
        if constexpr (fixed_item<Item>)
            return Item::max_size;
        else
            return Item::extent(in);
    }
};

namespace detail {

template <auto... Members> consteval bool listed_once(key_list<Members...>) {
    const std::array<std::string_view, sizeof...(Members) + 1> names{member_name<Members>..., std::string_view{}};
    for (std::size_t i = 0; i != sizeof...(Members); ++i)
        for (std::size_t j = 0; j != i; ++j)
            if (names[i] == names[j]) return false;
    return true;
}
template <class T, auto... Members> consteval bool owned_by(key_list<Members...>) {
    return (std::is_same_v<owner_t<Members>, T> && ... && true);
}

} // namespace detail

/// The layout of `T`, after the checks that need both the struct and its schema.
template <class T> struct checked_schema {
    using type = typename schema<T>::type;
    using keys = typename type::keys;
    static_assert(std::is_aggregate_v<T>, "layout: a message must be a plain aggregate");
    static_assert(detail::owned_by<T>(keys{}), "layout: a field names a member of another struct");
    static_assert(detail::listed_once(keys{}), "layout: a member is listed twice");
    static_assert(!detail::listed_once(keys{}) || keys::count >= member_count<T>(),
                  "layout: a member of the message is missing from its layout");
};
template <class T> using layout_of = typename checked_schema<T>::type;

/// A struct with a schema, or the `raw` of one.
template <class T> concept message = requires { typename schema<T>::type; };

/// Fewest and most bytes that a `T` takes.
template <message T> inline constexpr std::size_t min_size = layout_of<T>::min_size;
template <message T> inline constexpr std::size_t max_size = layout_of<T>::max_size;

/// Always the same number of bytes.
template <class T> concept fixed_message = message<T> && fixed_item<layout_of<T>>;

} // namespace jauscat::wire
