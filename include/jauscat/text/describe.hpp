// From a schema to its structure at run time: the only part of the text floor that is compiled for each message.
#pragma once
#include <jauscat/text/stamps.hpp>
#include <jauscat/text/structure.hpp>
#include <jauscat/text/value.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

namespace jauscat::text {

template <wire::message T> [[nodiscard]] constexpr const structure& describe() noexcept;

namespace detail {

template <class T> inline constexpr char type_id{};

/// A member that is found in the structure alone.
template <auto Member> struct access {
    using owner = wire::owner_t<Member>;
    using value_type = wire::member_value_t<Member>;

    static const void* find(const void* object) {
        const auto& value = static_cast<const owner*>(object)->*Member;
        if constexpr (wire::is_optional_member<Member>)
            return value ? &*value : nullptr;
        else
            return &value;
    }
    static void* make(void* object) {
        auto& value = static_cast<owner*>(object)->*Member;
        if constexpr (wire::is_optional_member<Member>)
            return value ? &*value : &value.emplace();
        else
            return &value;
    }
    static std::uint64_t get(const void* object) {
        return static_cast<std::uint64_t>(static_cast<const owner*>(object)->*Member);
    }
    static void set(void* object, std::uint64_t number) {
        static_cast<owner*>(object)->*Member = static_cast<value_type>(number);
    }
    static constexpr other_member other() { return {&type_id<owner>, wire::member_name<Member>, &get, &set}; }
    static std::uint64_t size(const void* object) {
        const auto* const value = static_cast<const value_type*>(find(object));
        return value == nullptr ? 0 : value->size();
    }
};
/// The same for an item. By its list of keys: g++ 12 takes `Item::key` for a pointer of another type here and there.
template <class Keys> struct access_by_keys;
template <auto Member> struct access_by_keys<wire::key_list<Member>> { using type = access<Member>; };
template <class Item> using access_of = typename access_by_keys<typename Item::keys>::type;

/// A value by its type alone, so that members of the same type share the code.
template <class Value> struct simple {
    static std::uint64_t get(const void* value) {
        if constexpr (requires { typename Value::bit_type; })
            return static_cast<const Value*>(value)->bits();
        else
            return static_cast<std::uint64_t>(*static_cast<const Value*>(value));
    }
    static void set(void* value, std::uint64_t number) {
        if constexpr (requires { typename Value::bit_type; })
            *static_cast<Value*>(value) = Value::from_bits(static_cast<typename Value::bits_type>(number));
        else
            *static_cast<Value*>(value) = static_cast<Value>(number);
    }
    static double get_real(const void* value) { return static_cast<double>(*static_cast<const Value*>(value)); }
    static void set_real(void* value, double real) { *static_cast<Value*>(value) = static_cast<Value>(real); }
};

template <class Codec> constexpr std::string_view unit_of() {
    if constexpr (requires { typename Codec::unit_type; })
        return Codec::unit_type::unit;
    else
        return {};
}

template <class Value> constexpr integer_form integer_of(unsigned bits, std::string_view unit = {}) {
    integer_form made{.bits = bits, .unit = unit, .get = &simple<Value>::get, .set = &simple<Value>::set};
    if constexpr (requires { typename Value::bit_type; }) {
        made.what = integer_form::meaning::flags;
        made.names = std::span{enumerator_names<typename Value::bit_type>}.first(bits);
    } else if constexpr (std::is_enum_v<Value>) {
        made.what = integer_form::meaning::enumeration;
        made.names = enumerator_names<Value>;
    } else if constexpr (std::is_same_v<Value, bool>) {
        made.what = integer_form::meaning::boolean;
    } else {
        made.is_signed = std::is_signed_v<Value>;
    }
    return made;
}

template <class Value, class Codec> constexpr form form_by_codec() {
    if constexpr (requires { typename Codec::range_type; }) {
        using range = typename Codec::range_type;
        using raw = typename Codec::raw_type;
        return {scaled_form{.unit = range::unit,
                            .min = range::min,
                            .max = range::max,
                            .lowest = Codec::lowest,
                            .highest = Codec::highest,
                            .is_signed = std::is_signed_v<raw>,
                            .bits = static_cast<unsigned>(Codec::size * 8),
                            .get = &simple<Value>::get_real,
                            .set = &simple<Value>::set_real,
                            .to_raw = [](double real) { return static_cast<std::uint64_t>(Codec::to_raw(real)); },
                            .to_real = [](std::uint64_t n) { return Codec::to_real(static_cast<raw>(n)); }}};
    } else if constexpr (std::floating_point<Value>) {
        return {real_form{.unit = unit_of<Codec>(),
                          .most = static_cast<double>(std::numeric_limits<typename Codec::value_type>::max()),
                          .get = &simple<Value>::get_real,
                          .set = &simple<Value>::set_real}};
    } else if constexpr (requires { std::tuple_size<Value>::value; }) {
        return {octets_form{
            .least = Codec::size,
            .most = Codec::size,
            .get = [](const void* value) { return std::span<const std::byte>{*static_cast<const Value*>(value)}; },
            .set =
                [](void* value, std::span<const std::byte> bytes) {
                    std::ranges::copy(bytes, static_cast<Value*>(value)->begin());
                }}};
    } else {
        return {integer_of<Value>(static_cast<unsigned>(Codec::size * 8), unit_of<Codec>())};
    }
}
template <class Value, class Codec> inline constexpr form codec_form = form_by_codec<Value, Codec>();
template <class Value, std::size_t Width> inline constexpr form bit_form{integer_of<Value>(Width)};
/// A count or a presence vector.
template <class Codec> inline constexpr form number_form{integer_form{.bits = static_cast<unsigned>(Codec::size * 8)}};

template <class Value> std::span<const std::byte> octets_of(const void* value) {
    const auto& held = *static_cast<const Value*>(value);
    return std::as_bytes(std::span{held.data(), held.size()});
}
template <class Value> void point_at(void* value, std::span<const std::byte> bytes) {
    if constexpr (std::is_same_v<Value, std::string_view>)
        *static_cast<Value*>(value) = {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    else
        *static_cast<Value*>(value) = Value{bytes};
}
template <class Item> inline constexpr bool zero_filled = false;
template <auto M, std::size_t N> inline constexpr bool zero_filled<wire::detail::fixed_run<M, N>> = true;
template <auto M, std::size_t N> inline constexpr bool zero_filled<wire::detail::lenient_run<M, N>> = true;
template <class Item> inline constexpr bool zero_terminated = false;
template <auto M> inline constexpr bool zero_terminated<wire::detail::terminated_run<M>> = true;

template <class Item> constexpr std::size_t most_of() {
    if constexpr (requires { Item::count_type::limit; })
        return Item::count_type::limit;
    else
        return Item::max_size;
}
template <class Item>
inline constexpr form octets_run_form{
    octets_form{.characters = std::is_same_v<typename Item::value_type, std::string_view>,
                .most = most_of<Item>(),
                .zero_filled = zero_filled<Item>,
                .zero_terminated = zero_terminated<Item>,
                .get = &octets_of<typename Item::value_type>,
                .set = &point_at<typename Item::value_type>}};

// A structure whose length is counted inside another of its structures is a message in a message: told as its bytes.
template <class Count> inline constexpr bool counted_deep = false;
template <auto A, auto B, auto... More> inline constexpr bool counted_deep<wire::counted_by<A, B, More...>> = true;
template <class T> consteval bool told_as_bytes() {
    return !wire::layout_of<T>::all_items([]<class Item>() {
        if constexpr (requires { typename Item::count_type; })
            return !counted_deep<typename Item::count_type>;
        else
            return true;
    });
}
template <class T> std::vector<std::byte> encoded(const void* value) {
    const T& object = *static_cast<const T*>(value);
    std::vector<std::byte> bytes(wire::encoded_size(object));
    const wire::result written = wire::encode(object, bytes);
    bytes.resize(written ? written.size() : 0);
    return bytes;
}
template <class T> bool decoded(void* value, std::span<const std::byte> bytes) {
    return static_cast<bool>(wire::decode(*static_cast<T*>(value), bytes));
}

/// Bit-fields as the one integer they fill.
template <class Layout> struct packing { static constexpr bool whole = false; };
template <class Carrier, class... Fields> struct packing<wire::layout<wire::bits<Carrier, Fields...>>> {
    static constexpr bool whole = true;
    static constexpr unsigned bits = static_cast<unsigned>(Carrier::size * 8);
    template <class T> static std::uint64_t get(const void* value) {
        std::uint64_t word = 0;
        std::size_t at = 0;
        ((word |= Fields::value(*static_cast<const T*>(value)) << at, at += Fields::width), ...);
        return word;
    }
    template <class T> static void set(void* value, std::uint64_t word) {
        std::size_t at = 0;
        ((Fields::assign(*static_cast<T*>(value), word >> at & (~std::uint64_t{} >> (64 - Fields::width))),
          at += Fields::width),
         ...);
    }
};

template <class T> constexpr form form_by_structure() {
    using packed = packing<wire::layout_of<T>>;
    if constexpr (told_as_bytes<T>()) {
        return {encoded_form{&encoded<T>, &decoded<T>}};
    } else if constexpr (packed::whole) {
        packed_form made{.of = &describe<T>(),
                         .bits = packed::bits,
                         .get = &packed::template get<T>,
                         .set = &packed::template set<T>};
        if constexpr (requires(T & value) { from_text(value, std::string_view{}); }) {
            made.show = [](const void* value) { return to_text(*static_cast<const T*>(value)); };
            made.read = [](void* value, std::string_view text) { return from_text(*static_cast<T*>(value), text); };
        }
        return {made};
    } else {
        return {structure_form{&describe<T>()}};
    }
}
template <class T> inline constexpr form structure_form_of = form_by_structure<T>();

template <class List> struct list_access {
    using value_type = typename wire::detail::list_traits<List>::value_type;
    static std::size_t size(const void* list) { return static_cast<const List*>(list)->size(); }
    static const void* first(const void* list) { return std::to_address(static_cast<const List*>(list)->begin()); }
    static void* resize(void* list, std::size_t size, wire::arena& memory) {
        auto& held = *static_cast<List*>(list);
        if constexpr (wire::detail::list_traits<List>::elsewhere) {
            value_type* const first = memory.allocate<value_type>(size);
            if (first != nullptr) held = std::span<const value_type>{first, size};
            return first;
        } else {
            return held.resize(size) ? held.begin() : nullptr;
        }
    }
};
template <class List> constexpr list_form list_of(const form& element, std::string_view field, std::size_t most) {
    return {.element = &element,
            .field = field,
            .stride = sizeof(typename list_access<List>::value_type),
            .most = most,
            .size = &list_access<List>::size,
            .first = &list_access<List>::first,
            .resize = &list_access<List>::resize};
}
template <class Item> constexpr form form_by_list() {
    using list = typename Item::member_type;
    using value_type = typename Item::value_type;
    std::size_t most = wire::unbounded;
    if constexpr (requires { Item::count_type::limit; }) most = Item::count_type::limit;
    if constexpr (!Item::traits::elsewhere) most = std::min(most, Item::traits::capacity);
    if constexpr (!Item::of_records) {
        return {list_of<list>(codec_form<value_type, typename Item::element_type::codec_type>, Item::name(), most)};
    } else {
        std::string_view field;
        if constexpr (requires { wire::schema<value_type>::field_name; }) field = wire::schema<value_type>::field_name;
        return {list_of<list>(structure_form_of<value_type>, field, most)};
    }
}
template <class Item> inline constexpr form list_form_of = form_by_list<Item>();

template <class Item> struct tree_of;
template <auto Member, auto Children, std::size_t MaxDepth> struct tree_of<wire::tree<Member, Children, MaxDepth>> {
    using node = wire::owner_t<Children>;
    static constexpr form value{
        tree_form{.nodes = list_of<wire::list<node>>(structure_form_of<node>, {}, wire::unbounded),
                  .max_depth = MaxDepth,
                  .children = access<Children>::other()}};
};

template <class Value, class Case> constexpr choice_case case_of() {
    using form_type = typename Case::form;
    using held = typename wire::detail::case_form<form_type>::value_type;
    choice_case made{.tag = static_cast<std::uint64_t>(Case::tag)};
    if constexpr (std::is_same_v<form_type, std::monostate>)
        made.how = nullptr;
    else if constexpr (wire::message<form_type>)
        made.how = &structure_form_of<form_type>;
    else if constexpr (wire::detail::is_variant<Value>)
        made.how = &codec_form<held, form_type>;
    else
        made.how = &codec_form<Value, form_type>;
    if constexpr (wire::detail::is_variant<Value>) {
        made.get = [](const void* value) -> const void* { return std::get_if<held>(static_cast<const Value*>(value)); };
        made.make = [](void* value) -> void* { return &static_cast<Value*>(value)->template emplace<held>(); };
    } else {
        made.get = [](const void* value) { return value; };
        made.make = [](void* value) { return value; };
    }
    return made;
}
template <class Value, class... Cases> inline constexpr std::array cases_of{case_of<Value, Cases>()...};
template <class Value, class Cases> struct choice_of;
template <class Value, class... Cases> struct choice_of<Value, std::tuple<Cases...>> {
    static constexpr form value{choice_form{cases_of<Value, Cases...>}};
};

template <class Count> struct counter_of { // stands before what it counts
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
    static constexpr other_member at{}; // a structure that is told as its bytes
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

template <class Item> struct flag_of { static constexpr other_member at{}; };
template <auto Flag, class Item> struct flag_of<wire::gated_by<Flag, Item>> {
    static constexpr other_member at = access<Flag>::other();
};

template <class T, class Item> constexpr void append(member*& out);
template <class T, class... Items> constexpr void append_all(member*& out, std::tuple<Items...>*) {
    (append<T, Items>(out), ...);
}

/// Adds what an item tells, in wire order.
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
            made.what = member::role::unsent;
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

/// Members that a layout tells beside those it carries: presence vectors, and counts that stand before what they count.
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
