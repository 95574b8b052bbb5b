// Limits a message's scaled values before it is encoded.
#pragma once
#include <jauscat/wire/nested.hpp>
#include <jauscat/wire/selected.hpp>
#include <jauscat/wire/visit.hpp>

#include <variant>

namespace jauscat::wire {

namespace detail {
template <class Item> concept holds_elements = requires { requires !Item::traits::elsewhere; };

/// Whether the structure `T` is the scope's, or around it.
template <class T, class Scope> inline constexpr bool is_within = false;
template <class T, class Object, class Outer>
inline constexpr bool is_within<T, object_scope<Object, Outer>> =
    std::is_same_v<T, structure_of_scope<object_scope<Object, Outer>>> || is_within<T, Outer>;
/// Whether the tag of a selected value can be read in a scope: it may be of a structure around.
template <class Selector, class Scope> inline constexpr bool reads_tag = true; // one of the user's own
template <auto First, auto... Rest, class Scope>
inline constexpr bool reads_tag<by<First, Rest...>, Scope> = is_within<owner_t<First>, Scope>;

template <class Codec> constexpr void clamp_value(auto& value) noexcept {
    if constexpr (requires { typename Codec::range_type; }) {
        using range = typename Codec::range_type;
        if (value < range::min) value = range::min;
        if (value > range::max) value = range::max;
    }
}

template <class Item, class Tag> constexpr void clamp_case(auto& value, const Tag& tag) noexcept {
    static_cast<void>(
        Item::with_case(tag, [&]<class Case>() { clamp_value<typename Case::form>(value); })); // none: does not encode
}

template <class T> constexpr void clamp_in(T& object, const auto& outer) noexcept {
    const object_scope here{object, outer};
    visit(object, [&]<class Item>(Item, auto& member) {
        const auto each = [&]<class Value>(Value& value) {
            if constexpr (requires { typename Item::codec_type; })
                clamp_value<typename Item::codec_type>(value);
            else if constexpr (requires { typename Item::element_type::codec_type; }) {
                if constexpr (!std::is_const_v<std::remove_reference_t<decltype(value[0])>>)
                    for (auto& element : value) clamp_value<typename Item::element_type::codec_type>(element);
            } else if constexpr (holds_elements<Item>)
                for (auto& element : value) clamp_in(element, here);
            else if constexpr (is_variant<Value>)
                std::visit(
                    []<class Form>(Form& form) {
                        if constexpr (message<Form>) clamp_in(form, plain_root{}); // it reads no enclosing members
                    },
                    value);
            else if constexpr (requires { Item::has_scaled; }) {
                using selector = typename Item::selector;
                if constexpr (Item::has_scaled && reads_tag<selector, std::remove_cvref_t<decltype(here)>>)
                    clamp_case<Item>(value, selector::value(here));
                else if constexpr (message<Value>)
                    clamp_in(value, plain_root{});
            } else if constexpr (message<Value>)
                clamp_in(value, here);
        };
        if constexpr (requires {
                          Item::optional;
                          member.has_value();
                      }) {
            if (member) each(*member);
        } else {
            each(member);
        }
    });
}
} // namespace detail

/// Moves every scaled value of `object` into its field's range. NaN stays NaN, and so still does not encode. A selected
/// value is moved into the range of the form that its tag selects. The elements of a `list` lie elsewhere and are not
/// its to change: clamp them before; so is a selected value in a structure alone, if a structure around has its tag.
template <message T>
requires(!raw_object<T>)
constexpr void clamp(T& object) noexcept {
    detail::clamp_in(object, plain_root{});
}

} // namespace jauscat::wire
