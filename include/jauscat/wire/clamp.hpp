// Limits a message's scaled values before it is encoded.
#pragma once
#include <jauscat/wire/nested.hpp>
#include <jauscat/wire/visit.hpp>

namespace jauscat::wire {

namespace detail {
template <class Item> concept holds_elements = requires { requires !Item::traits::elsewhere; };
} // namespace detail

/// Moves every scaled value of `object` into its field's range. NaN stays NaN, and so still does not encode. The
/// elements of a `list` lie elsewhere and are not its to change: clamp them before.
template <message T>
requires(!raw_object<T>)
constexpr void clamp(T& object) noexcept {
    visit(object, []<class Item>(Item, auto& member) {
        const auto into = []<class Codec>(Codec*, auto& value) {
            if constexpr (requires { typename Codec::range_type; }) {
                using range = typename Codec::range_type;
                if (value < range::min) value = range::min;
                if (value > range::max) value = range::max;
            }
        };
        const auto each = [&](auto& value) {
            if constexpr (requires { typename Item::codec_type; })
                into(static_cast<typename Item::codec_type*>(nullptr), value);
            else if constexpr (requires { typename Item::element_type::codec_type; }) {
                if constexpr (!std::is_const_v<std::remove_reference_t<decltype(value[0])>>)
                    for (auto& element : value)
                        into(static_cast<typename Item::element_type::codec_type*>(nullptr), element);
            } else if constexpr (detail::holds_elements<Item>)
                for (auto& element : value) clamp(element);
            else if constexpr (message<std::remove_cvref_t<decltype(value)>>)
                clamp(value);
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

} // namespace jauscat::wire
