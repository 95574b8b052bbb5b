// Makes the run-time structure of a schema. The only part of text/ that is compiled for each message.
#pragma once
#include <jauscat/text/structure_forms.hpp>

#include <algorithm>
#include <array>

namespace jauscat::text {

namespace detail {

/// `header.data_size`
template <auto First, auto... Rest>
inline constexpr auto path = [] {
    std::array<char, (wire::member_name<First>.size() + ... + (wire::member_name<Rest>.size() + 1))> text{};
    char* at = std::ranges::copy(wire::member_name<First>, text.data()).out;
    ((*at++ = '.', at = std::ranges::copy(wire::member_name<Rest>, at).out), ...);
    return text;
}();

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
    // In a structure that is written as its bytes.
    static constexpr other_member at{.name = {path<A, B, More...>.data(), path<A, B, More...>.size()}};
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
template <class Codec, auto Value> constexpr member constant_of(std::string_view name) {
    return {.what = member::role::constant,
            .name = name,
            .how = &number_form<Codec>,
            .number = [](const void*) { return static_cast<std::uint64_t>(Value); },
            .least = Codec::size,
            .most = Codec::size};
}
template <wire::label Name, class Codec, auto Value> constexpr member constant_of(wire::constant<Name, Codec, Value>) {
    return constant_of<Codec, Value>(Name.view());
}
template <class T, class Carrier, class... Fields>
constexpr void append_bits(member*& out, wire::bit_fields<Carrier, Fields...>) {
    unsigned at = 0;
    member* const first = out;
    const auto append_one = [&]<class Field>() {
        member* const before = out;
        append<T, Field>(out);
        if (out != before) {
            before->first_bit = at;
            before->carrier_bits = static_cast<unsigned>(Carrier::size * 8);
        }
        at += static_cast<unsigned>(Field::width);
    };
    (append_one.template operator()<Fields>(), ...);
    if (out != first)
        out[-1].ends_carrier = true;
    else
        *out++ = constant_of<Carrier, 0>("reserved");
}

/// Bytes of an item that has a member, where it is present.
template <class Item> constexpr void set_size(member& made) {
    if constexpr (requires { typename Item::inner; }) {
        using value_type = typename access_of<Item>::value_type;
        made.least = wire::min_size<value_type>;
        made.most = wire::max_size<value_type>;
    } else if constexpr (requires { typename Item::codec_type; }) {
        made.least = made.most = Item::codec_type::size;
    } else if constexpr (!requires { Item::width; } && !requires { Item::takes_bit; }) {
        made.least = Item::min_size;
        made.most = Item::max_size;
        if constexpr (requires { Item::count_type::prefix_size; }) { // which is a member of its own
            made.least -= Item::count_type::prefix_size;
            if (made.most != wire::unbounded) made.most -= Item::count_type::prefix_size;
        }
    }
}

/// Adds the members of an item, in wire order.
template <class T, class Item> constexpr void append(member*& out) {
    if constexpr (requires { Item::fixed_value; }) {
        *out++ = constant_of(Item{});
    } else if constexpr (requires { typename Item::fields; }) {
        append_bits<T>(out, Item{});
    } else if constexpr (requires { typename Item::carrier_codec; }) {
        *out++ = member{.what = member::role::presence_vector,
                        .name = "presence_vector",
                        .how = &number_form<typename Item::carrier_codec>,
                        .number = &mask_of<T, Item>,
                        .least = Item::carrier_codec::size,
                        .most = Item::carrier_codec::size,
                        .tolerant = Item::tolerant};
        member& vector = out[-1];
        Item::all_items([&]<class Inner>() {
            member* made = out;
            append<T, Inner>(out);
            if (!wire::takes_bit<Inner>) return true;
            for (; made != out; ++made) made->presence_bit = vector.used_bits;
            ++vector.used_bits;
            return true;
        });
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
            if constexpr (requires { typename Item::value_set; })
                made.how = &bit_form<value_type, Item::width, Item>;
            else
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
        } else if constexpr (requires { typename Item::alternatives; }) {
            made.how = &variant_form_of<Item>;
        } else if constexpr (std::is_same_v<value_type, wire::embedded_message>) {
            made.how = &embedded_form;
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
                                .how = &count_form<typename Item::count_type>,
                                .number = &access_of<Item>::size,
                                .least = Item::count_type::prefix_size,
                                .most = Item::count_type::prefix_size};
            } else {
                made.counter = counter::at;
                made.counter_excess = counter::excess;
            }
        }
        if (made.what != member::role::not_on_wire) set_size<Item>(made);
        *out++ = made;
    }
}

/// Members of a layout beside its items: presence vectors, counts before their lists, and constants.
template <class Item> inline constexpr std::size_t added = 0;
template <wire::label Name, class Codec, auto Value>
inline constexpr std::size_t added<wire::constant<Name, Codec, Value>> = 1;
template <class Carrier, std::size_t... Widths>
inline constexpr std::size_t added<wire::bit_fields<Carrier, wire::reserved<Widths>...>> = 1;
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
inline constexpr structure structure_of{.id = &type_id<T>,
                                        .name = wire::type_name<T>(),
                                        .members = members_of<T>,
                                        .least = wire::min_size<T>,
                                        .most = wire::max_size<T>};

} // namespace detail

/// The structure of `T`, made at compile time.
template <wire::message T> constexpr const structure& describe() noexcept { return detail::structure_of<T>; }

} // namespace jauscat::text
