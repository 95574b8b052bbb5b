// What an item of a layout must offer, and a sentence for each operation that one lacks.
#pragma once
#include <jauscat/wire/scope.hpp>

#include <concepts>

namespace jauscat::wire {

namespace detail {

struct no_structure {};
/// A structure that an item with these members can stand in.
template <class Keys> struct structure_with {
    using type = no_structure;
};
template <auto First, auto... Rest> struct structure_with<key_list<First, Rest...>> {
    using type = owner_t<First>;
};
template <class Item> using structure_around = typename structure_with<typename Item::keys>::type;

/// Takes whatever an item visits.
struct any_visitor {
    template <class Item, class Value> void operator()(Item, Value&) const noexcept;
};

// `T` is the structure that the item stands in; scopes as in encode, decode and view.
template <class T> using encoding_scope = object_scope<const T, plain_root>;
template <class T> using decoding_scope = object_scope<T, plain_root>;
template <class T> using viewing_scope = byte_scope<T, plain_root>;

template <class Item>
concept has_keys = requires {
    typename Item::keys;
    { Item::keys::count } -> std::convertible_to<std::size_t>;
};
template <class Item>
concept has_sizes = requires {
    { Item::min_size } -> std::convertible_to<std::size_t>;
    { Item::max_size } -> std::convertible_to<std::size_t>;
};
template <class Item>
concept says_optional = requires {
    { Item::optional } -> std::convertible_to<bool>;
};
template <class Item, class T = structure_around<Item>>
concept has_visit = requires(T& object, any_visitor visitor) { Item::visit(object, visitor); };
template <class Item, class T = structure_around<Item>>
concept puts_fixed = requires(const T& object, std::byte* out) {
    { Item::put(object, out) } -> std::same_as<errc>;
};
template <class Item, class T = structure_around<Item>>
concept gets_fixed = requires(T& object, const std::byte* in) {
    { Item::get(object, in) } -> std::same_as<errc>;
};
template <class Item, class T = structure_around<Item>>
concept tells_size = requires(const T& object, const encoding_scope<T>& here) {
    { Item::size(object, here) } -> std::same_as<std::size_t>;
};
template <class Item, class T = structure_around<Item>>
concept puts = requires(const T& object, out_cursor c, const encoding_scope<T>& here) {
    { Item::put(object, c, here) } -> std::same_as<out_cursor>;
};
template <class Item, class T = structure_around<Item>>
concept gets = requires(T& object, in_cursor c, const decoding_scope<T>& here) {
    { Item::get(object, c, here) } -> std::same_as<in_cursor>;
};
template <class Item, class T = structure_around<Item>>
concept measures = requires(in_cursor c, const viewing_scope<T>& here) {
    { Item::measure(c, here) } -> std::same_as<in_cursor>;
};
// No item has to have an extent.
template <class Item, class T = structure_around<Item>>
concept no_wrong_extent = !requires(const std::byte* in, const viewing_scope<T>& here) { Item::extent(in, here); } ||
                          requires(const std::byte* in, const viewing_scope<T>& here) {
                              { Item::extent(in, here) } -> std::same_as<std::size_t>;
                          };

} // namespace detail

/// An item that always takes the same bytes, whatever stands around it.
template <class Item>
concept fixed_layout_item = fixed_item<Item> && detail::puts_fixed<Item> && detail::gets_fixed<Item>;
/// An item whose size varies, or that looks at what stands around it.
template <class Item>
concept variable_layout_item = !fixed_item<Item> && detail::tells_size<Item> && detail::puts<Item> &&
                               detail::gets<Item> && detail::measures<Item> && detail::no_wrong_extent<Item>;
/// What a `layout` consists of; item.hpp lists the operations. An item that a view reads also has
/// `read<Member, Mode>(bytes, scope)`, which returns the value.
template <class Item>
concept layout_item = detail::has_keys<Item> && detail::has_sizes<Item> && detail::says_optional<Item> &&
                      detail::has_visit<Item> && (fixed_layout_item<Item> || variable_layout_item<Item>);

namespace detail {

/// Says which operation an item lacks.
template <class Item> struct missing_operation {
    static_assert(has_keys<Item>, "layout: an item has no keys, the key_list of its members in wire order");
    static_assert(has_sizes<Item>, "layout: an item has no min_size and max_size, the bytes it takes");
    static_assert(says_optional<Item>,
                  "layout: an item has no optional, which says whether its member is a std::optional");
    static_assert(has_visit<Item>, "layout: an item has no visit(object, visitor)");
    static constexpr bool fixed = fixed_item<Item>;
    static_assert(!fixed || puts_fixed<Item>, "layout: a fixed item has no put(object, std::byte*) that returns errc");
    static_assert(!fixed || gets_fixed<Item>,
                  "layout: a fixed item has no get(object, const std::byte*) that returns errc");
    static_assert(fixed || tells_size<Item>,
                  "layout: a variable item has no size(object, scope) that returns std::size_t");
    static_assert(fixed || puts<Item>,
                  "layout: a variable item has no put(object, out_cursor, scope) that returns out_cursor");
    static_assert(fixed || gets<Item>,
                  "layout: a variable item has no get(object, in_cursor, scope) that returns in_cursor");
    static_assert(fixed || measures<Item>,
                  "layout: a variable item has no measure(in_cursor, scope) that returns in_cursor");
    static_assert(fixed || no_wrong_extent<Item>,
                  "layout: the extent(const std::byte*, scope) of a variable item does not return std::size_t");
    static constexpr bool named = true;
};
template <class Item> inline constexpr bool checked_item = true;
template <class Item>
requires(!layout_item<Item>)
inline constexpr bool checked_item<Item> = missing_operation<Item>::named;

} // namespace detail

} // namespace jauscat::wire
