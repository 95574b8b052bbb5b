// Limits a message's scaled values before it is encoded, where that is what the caller wants.
#pragma once
#include <jauscat/wire/nested.hpp>
#include <jauscat/wire/visit.hpp>

namespace jauscat::wire {

/// Moves every scaled value of `object` into its field's range. NaN stays NaN, and so still does not encode.
template <message T>
requires(!raw_object<T>) constexpr void clamp(T& object) noexcept {
    visit(object, []<class Item>(Item, auto& member) {
        const auto each = [](auto& value) {
            if constexpr (requires { typename Item::codec_type::range_type; }) {
                using range = typename Item::codec_type::range_type;
                if (value < range::min) value = range::min;
                if (value > range::max) value = range::max;
            } else if constexpr (message<std::remove_cvref_t<decltype(value)>>) {
                clamp(value);
            }
        };
        if constexpr (requires {
                          Item::optional;
                          *member;
                      }) {
            if (member) each(*member);
        } else {
            each(member);
        }
    });
}

} // namespace jauscat::wire
