// Text forms of structures, lists, trees and selected values.
#pragma once
#include <jauscat/text/stamps.hpp>
#include <jauscat/text/value_forms.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

namespace jauscat::text {

template <wire::message T> [[nodiscard]] constexpr const structure& describe() noexcept; // describe.hpp

namespace detail {

// A structure with its length in another of its structures is an embedded message: written as its bytes.
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
    const auto written = wire::encode(object, bytes);
    bytes.resize(written ? written->size() : 0);
    return bytes;
}
template <class T> [[nodiscard]] bool decoded(void* value, std::span<const std::byte> bytes) {
    return static_cast<bool>(wire::decode(*static_cast<T*>(value), bytes));
}

/// Bit-fields as the one integer they fill.
template <class Layout> struct packing {
    static constexpr bool whole = false;
};
template <class Carrier, class... Fields> struct packing<wire::layout<wire::bit_fields<Carrier, Fields...>>> {
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
        return {encoded_form{&describe<T>(), &encoded<T>, &decoded<T>}};
    } else if constexpr (packed::whole) {
        packed_form made{.of = &describe<T>(),
                         .bits = packed::bits,
                         .get = &packed::template get<T>,
                         .set = &packed::template set<T>};
        if constexpr (requires(T& value) { from_text(value, std::string_view{}); }) {
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
    using traits = wire::list_traits<List>;
    using value_type = typename traits::value_type;
    static std::size_t size(const void* list) { return static_cast<const List*>(list)->size(); }
    static const void* first(const void* list) { return std::to_address(static_cast<const List*>(list)->begin()); }
    static void* resize(void* list, std::size_t size, wire::arena& memory) {
        auto& held = *static_cast<List*>(list);
        if constexpr (traits::elsewhere) {
            value_type* const first = memory.allocate<value_type>(size);
            if (first != nullptr) held = std::span<const value_type>{first, size};
            return first;
        } else if constexpr (traits::counted) {
            return held.resize(size) ? held.begin() : nullptr;
        } else {
            return held.data();
        }
    }
};
template <class List>
constexpr list_form list_of(const form& element, std::string_view field, std::size_t most, std::size_t least = 0) {
    return {.element = &element,
            .field = field,
            .stride = sizeof(typename list_access<List>::value_type),
            .least = least,
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
    const std::size_t least = Item::traits::counted ? 0 : most;
    std::string_view field;
    if constexpr (!Item::of_records) {
        if (Item::traits::counted) field = Item::name();
        return {list_of<list>(codec_form<value_type, typename Item::element_type::codec_type>, field, most, least)};
    } else {
        if constexpr (requires { wire::schema<value_type>::field_name; }) field = wire::schema<value_type>::field_name;
        return {list_of<list>(structure_form_of<value_type>, field, most, least)};
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

template <class Held> constexpr alternative alternative_of() {
    if constexpr (wire::message<Held>)
        return {wire::type_name<Held>(), &structure_form_of<Held>};
    else
        return {"none", nullptr};
}
template <class Variant> struct variant_access;
template <class... Alternatives> struct variant_access<std::variant<Alternatives...>> {
    using value_type = std::variant<Alternatives...>;
    static constexpr std::array alternatives{alternative_of<Alternatives>()...};
    static std::size_t index(const void* value) { return static_cast<const value_type*>(value)->index(); }
    static const void* get(const void* value) {
        return std::visit([](const auto& held) -> const void* { return &held; },
                          *static_cast<const value_type*>(value));
    }
    static void* make(void* value, std::size_t index) {
        void* made = nullptr;
        wire::detail::alternatives_of<value_type>::with(
            index, [&]<std::size_t I, class>() { made = &static_cast<value_type*>(value)->template emplace<I>(); });
        return made;
    }
};
template <class Item>
inline constexpr form variant_form_of{
    variant_form{.alternatives = variant_access<typename Item::value_type>::alternatives,
                 .bits = static_cast<unsigned>(Item::tag_codec::size * 8),
                 .index = &variant_access<typename Item::value_type>::index,
                 .get = &variant_access<typename Item::value_type>::get,
                 .make = &variant_access<typename Item::value_type>::make}};

inline constexpr form embedded_form{encoded_form{.encode =
                                                     [](const void* value) {
                                                         const auto& inner =
                                                             *static_cast<const wire::embedded_message*>(value);
                                                         std::vector<std::byte> bytes(inner.size());
                                                         if (inner.put(bytes.data()).error != wire::errc::ok)
                                                             bytes.clear();
                                                         return bytes;
                                                     },
                                                 .decode =
                                                     [](void* value, std::span<const std::byte> bytes) {
                                                         *static_cast<wire::embedded_message*>(value) =
                                                             wire::embedded_message{bytes};
                                                         return true;
                                                     }}};

template <class Value, class Case> constexpr choice_case case_of() {
    using form_type = typename Case::form;
    using held = typename wire::case_form<form_type>::value_type;
    choice_case made{.tag = static_cast<std::uint64_t>(Case::tag)};
    if constexpr (std::is_same_v<form_type, std::monostate>)
        made.how = nullptr;
    else if constexpr (wire::message<form_type>)
        made.how = &structure_form_of<form_type>;
    else if constexpr (wire::is_variant<Value>)
        made.how = &codec_form<held, form_type>;
    else
        made.how = &codec_form<Value, form_type>;
    if constexpr (wire::is_variant<Value>) {
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

} // namespace detail

} // namespace jauscat::text
