// Makes the run-time structure of a schema. The only part of text/ that is compiled for each message.
#pragma once
#include <jauscat/text/structure_forms.hpp>

namespace jauscat::text {

namespace detail {

template <class Count> struct counter_of { // precedes the elements that it counts
    static constexpr bool before = true;
};
template <auto Member> struct counter_of<wire::counted_by<Member>> {
    static constexpr bool before = false;
    static constexpr other_member at = access<Member>::other();
    static constexpr std::size_t excess = 0;
};
template <auto Member> struct counter_of<wire::one_less_than<Member>> : counter_of<wire::counted_by<Member>> {
    static constexpr std::size_t excess = 1;
};
template <auto A, auto B, auto... More> struct counter_of<wire::counted_by<A, B, More...>> {
    static constexpr bool before = false;
    static constexpr other_member at{}; // a structure that is written as its bytes
    static constexpr std::size_t excess = 0;
};
template <class Selector> struct selector_of;
template <auto Member> struct selector_of<wire::by<Member>> {
    static constexpr other_member at = access<Member>::other();
};
template <auto Member, class Selector, class... Cases>
constexpr other_member tag_of(wire::selected<Member, Selector, Cases...>) {
    return selector_of<Selector>::at;
}

template <class T, class Group> std::uint64_t mask_of(const void* object) {
    return Group::mask(*static_cast<const T*>(object));
}

template <class Item> struct flag_of {
    static constexpr other_member at{};
};
template <auto Flag, class Item> struct flag_of<wire::gated_by<Flag, Item>> {
    static constexpr other_member at = access<Flag>::other();
};

template <class T, class Item> constexpr void append(member*& out);
template <class T, class... Items> constexpr void append_all(member*& out, std::tuple<Items...>*) {
    (append<T, Items>(out), ...);
}

/// Adds the members of an item, in wire order.
template <class T, class Item> constexpr void append(member*& out) {
    if constexpr (requires { typename Item::fields; }) {
        append_all<T>(out, static_cast<typename Item::fields*>(nullptr));
    } else if constexpr (requires { typename Item::carrier_codec; }) {
        *out++ = member{.what = member::role::presence_vector,
                        .name = "presence_vector",
                        .how = &number_form<typename Item::carrier_codec>,
                        .number = &mask_of<T, Item>};
        Item::all_items([&]<class Inner>() { return append<T, Inner>(out), true; });
    } else if constexpr (requires { typename Item::gated_item; }) {
        append<T, typename Item::gated_item>(out);
        out[-1].gate = flag_of<Item>::at;
    } else if constexpr (requires { Item::key; }) {
        using value_type = typename access_of<Item>::value_type;
        member made{.name = Item::name(),
                    .optional = Item::optional,
                    .find = &access_of<Item>::find,
                    .make = &access_of<Item>::make};
        if constexpr (requires { Item::width; }) {
            made.how = &bit_form<value_type, Item::width>;
        } else if constexpr (requires { Item::takes_bit; }) {
            made.what = member::role::flag;
            made.how = &bit_form<bool, 1>;
        } else if constexpr (requires { typename Item::inner; }) {
            made.how = &structure_form_of<value_type>;
        } else if constexpr (requires { typename Item::codec_type; }) {
            made.how = &codec_form<value_type, typename Item::codec_type>;
        } else if constexpr (requires { Item::max_depth; }) {
            made.how = &tree_of<Item>::value;
        } else if constexpr (requires { typename Item::cases; }) {
            made.how = &choice_of<value_type, typename Item::cases>::value;
            made.tag = tag_of(Item{});
        } else if constexpr (requires { typename Item::element_type; }) {
            made.how = &list_form_of<Item>;
            if constexpr (!Item::of_records) made.name = Item::element_type::name();
        } else if constexpr (std::is_enum_v<value_type> || std::integral<value_type>) {
            made.what = member::role::not_on_wire;
            made.how = &bit_form<value_type, sizeof(value_type) * 8>;
        } else {
            made.how = &octets_run_form<Item>;
        }
        if constexpr (requires { typename Item::count_type; }) {
            using counter = counter_of<typename Item::count_type>;
            if constexpr (counter::before) {
                *out++ = member{.what = member::role::count,
                                .name = Item::count_type::name(),
                                .how = &number_form<typename Item::count_type::codec_type>,
                                .number = &access_of<Item>::size};
            } else {
                made.counter = counter::at;
                made.counter_excess = counter::excess;
            }
        }
        *out++ = made;
    }
}

/// Members of a layout beside its items: presence vectors, and counts before their lists.
template <class Item> inline constexpr std::size_t added = 0;
template <class Item>
requires requires { typename Item::count_type; }
inline constexpr std::size_t added<Item> = counter_of<typename Item::count_type>::before ? 1 : 0;
template <auto Flag, class Item> inline constexpr std::size_t added<wire::gated_by<Flag, Item>> = added<Item>;
template <wire::unknown_bits Unknown, class Carrier, class... Items>
inline constexpr std::size_t added<wire::presence_group<Unknown, Carrier, Items...>> = (1 + ... + added<Items>);
template <class... Items> inline constexpr std::size_t added<wire::layout<Items...>> = (0 + ... + added<Items>);

template <class T>
inline constexpr auto members_of = [] {
    using layout = wire::layout_of<T>;
    std::array<member, layout::keys::count + added<layout>> made{};
    [[maybe_unused]] member* next = made.data();
    layout::all_items([&]<class Item>() { return append<T, Item>(next), true; });
    return made;
}();
template <class T>
inline constexpr structure structure_of{.id = &type_id<T>, .name = wire::type_name<T>(), .members = members_of<T>};

} // namespace detail

/// The structure of `T`, made at compile time.
template <wire::message T> constexpr const structure& describe() noexcept { return detail::structure_of<T>; }

} // namespace jauscat::text
