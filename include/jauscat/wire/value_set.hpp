// Value sets: the values of a number that a standard defines. A value outside is no error of the bytes: `decode` and
// `encode` tell it apart (`outside_value_set`), and accept it on request (`tolerate_values`).
#pragma once
#include <jauscat/wire/bit_fields.hpp>
#include <jauscat/wire/count.hpp>
#include <jauscat/wire/presence.hpp>

#include <type_traits>
#include <utility>
#include <variant>

namespace jauscat::wire {

namespace detail {
constexpr auto integer_in(auto value) noexcept {
    using type = decltype(value);
    if constexpr (std::is_enum_v<type>)
        return integer_in(static_cast<std::underlying_type_t<type>>(value));
    else if constexpr (std::is_same_v<type, bool> || std::is_same_v<type, char>)
        return static_cast<unsigned>(value);
    else
        return value;
}
} // namespace detail

/// The numbers from `Least` to `Most`, both included.
template <auto Least, auto Most> struct between {
    static_assert(!std::cmp_less(detail::integer_in(Most), detail::integer_in(Least)),
                  "between: the first number is larger than the second");
    static constexpr bool contains(auto value) noexcept {
        const auto number = detail::integer_in(value);
        return !std::cmp_less(number, detail::integer_in(Least)) && !std::cmp_less(detail::integer_in(Most), number);
    }
};
/// These numbers or enumerators.
template <auto... Values> struct one_of {
    static constexpr bool contains(auto value) noexcept {
        return (std::cmp_equal(detail::integer_in(value), detail::integer_in(Values)) || ... || false);
    }
};

namespace detail {
template <class Part>
concept value_set_part = requires(std::uint8_t value) {
    { Part::contains(value) } -> std::same_as<bool>;
};
/// The union of its parts.
template <class... Parts> struct joined_values {
    static_assert(sizeof...(Parts) != 0, "in_value_set: the value set is empty (add between or one_of)");
    static_assert((value_set_part<Parts> && ... && true),
                  "in_value_set: a part of the value set is neither between nor one_of (it needs contains)");
    static constexpr bool contains(auto value) noexcept { return (Parts::contains(value) || ... || false); }
};
} // namespace detail

/// A codec of an integer or an enumeration with a value set: the union of `Parts`.
template <class Codec, class... Parts> struct in_value_set : Codec {
    static_assert(detail::checked_codec<Codec>,
                  "in_value_set: the first argument is not a codec (it needs value_type, size, store and load)");
    static_assert(std::is_integral_v<typename Codec::value_type> || std::is_enum_v<typename Codec::value_type>,
                  "in_value_set: the codec must carry an integer or an enumeration");
    using value_set = detail::joined_values<Parts...>;
    static_assert(sizeof(value_set) != 0);
};

/// A bit-field with a value set.
template <auto Member, std::size_t Width, class... Parts> struct bit_field_in_set : bit_field<Member, Width> {
    using value_set = detail::joined_values<Parts...>;
    static constexpr bool checks_values = true;
    static_assert(sizeof(value_set) != 0);
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) {
        visitor(bit_field_in_set{}, member_of<Member>(object));
    }
};

/// A count with limits.
template <label Name, class Codec, std::size_t Least, std::size_t Most> struct count_between : count<Name, Codec> {
    static_assert(Least <= Most, "count_between: the first number is larger than the second");
    static_assert(Most <= count<Name, Codec>::limit, "count_between: the limit exceeds what the count can say");
    using value_set = between<Least, Most>;
};

/// Accepts values outside their value sets: the last argument of decode and encode.
struct tolerate_values_tag {};
inline constexpr tolerate_values_tag tolerate_values{};

namespace detail {

/// Values outside their value sets.
enum class outside_values { refused, tolerated };

template <class T> constexpr errc check_values_in(const T& object) noexcept;

template <class Codec> constexpr bool holds_value(const auto& value) noexcept {
    if constexpr (requires { typename Codec::value_set; })
        return Codec::value_set::contains(value);
    else
        return true;
}
template <class Element> constexpr bool holds_values(const auto& elements) noexcept {
    if constexpr (requires { typename Element::codec_type; }) {
        if constexpr (requires { typename Element::codec_type::value_set; })
            for (std::size_t i = 0; i != elements.size(); ++i)
                if (!holds_value<typename Element::codec_type>(elements[i])) return false;
    } else {
        for (std::size_t i = 0; i != elements.size(); ++i)
            if (check_values_in(elements[i]) != errc::ok) return false;
    }
    return true;
}
template <class Item> constexpr bool size_in_its_set(const auto& value) noexcept {
    if constexpr (requires { typename Item::count_type::value_set; })
        return Item::count_type::value_set::contains(value.size());
    else
        return true;
}
/// Not std::visit: its call through a table costs more than most checks.
template <class... Forms> constexpr bool alternative_in_its_set(const std::variant<Forms...>& value) noexcept {
    const auto inside = [&]<class Form>(std::type_identity<Form>) {
        if constexpr (message<Form>) {
            const auto* const form = std::get_if<Form>(&value);
            return form == nullptr || check_values_in(*form) == errc::ok;
        } else {
            return true;
        }
    };
    return (inside(std::type_identity<Forms>{}) && ... && true);
}
/// A member that is present.
template <class Item, class Value> constexpr bool in_its_set(const Value& value) noexcept {
    if constexpr (requires { typename Item::value_set; }) {
        return Item::value_set::contains(value);
    } else if constexpr (requires { typename Item::codec_type; }) {
        return holds_value<typename Item::codec_type>(value);
    } else if constexpr (requires { Item::max_depth; }) {
        return holds_values<Item>(value);
    } else if constexpr (requires { typename Item::element_type; }) {
        return size_in_its_set<Item>(value) && holds_values<typename Item::element_type>(value);
    } else if constexpr (requires { value.check_values(); }) {
        return size_in_its_set<Item>(value) && value.check_values() == errc::ok;
    } else if constexpr (requires { typename Item::count_type; }) {
        return size_in_its_set<Item>(value);
    } else if constexpr (requires { value.valueless_by_exception(); }) {
        return alternative_in_its_set(value);
    } else if constexpr (message<Value>) {
        return check_values_in(value) == errc::ok;
    } else {
        return true;
    }
}
/// A member of `Item`, or an optional one.
template <class Item> constexpr bool member_in_its_set(const auto& member) noexcept {
    if constexpr (!item_checks_values<Item>)
        return true;
    else if constexpr (requires {
                           requires Item::optional;
                           member.has_value();
                       })
        return !member.has_value() || in_its_set<Item>(*member);
    else
        return in_its_set<Item>(member);
}
/// The values of an item in `object`. Only items that check values are asked: a function for each of the others would
/// cost compile time.
template <class Item> struct values_of {
    static constexpr bool are_inside(const auto& object) noexcept {
        if constexpr (requires { Item::key; } && !requires { typename Item::gated_item; }) {
            return member_in_its_set<Item>(member_of<Item::key>(object));
        } else {
            bool inside = true;
            Item::visit(object, [&]<class Leaf>(Leaf, const auto& member) {
                inside = inside && member_in_its_set<Leaf>(member);
            });
            return inside;
        }
    }
};
struct no_values {
    static constexpr bool are_inside(const auto&) noexcept { return true; }
};
template <class Item> using checked_values = std::conditional_t<item_checks_values<Item>, values_of<Item>, no_values>;
template <class... Items> struct values_of<layout<Items...>> {
    static constexpr bool are_inside(const auto& object) noexcept {
        return (checked_values<Items>::are_inside(object) && ... && true);
    }
};
template <unknown_bits Unknown, class Carrier, class... Items>
struct values_of<presence_group<Unknown, Carrier, Items...>> : values_of<layout<Items...>> {};

template <class T> constexpr errc check_values_in(const T& object) noexcept {
    if constexpr (!raw_object<T> && layout_of<T>::checks_values)
        return values_of<layout_of<T>>::are_inside(object) ? errc::ok : errc::outside_value_set;
    else
        return errc::ok;
}

/// Whether nothing in `T` has value sets but variants, so that these can be checked where they are written.
template <class T>
inline constexpr bool only_variants_check = layout_of<T>::all_items(
    []<class Item>() { return !item_checks_values<Item> || requires { typename Item::alternatives; }; });
} // namespace detail

/// `outside_value_set` if a value of `object`, or the size of a list, is not among those that its layout defines. All
/// integers of a `raw` are.
template <message T> [[nodiscard]] constexpr errc check_values(const T& object) noexcept {
    return detail::check_values_in(object);
}

} // namespace jauscat::wire
