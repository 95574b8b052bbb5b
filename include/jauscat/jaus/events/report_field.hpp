// A field of a report by its number in the standard's table, for the limits of events. RA 3.3 part 3, Limit Data Field.
#pragma once
#include <jauscat/wire/bit_fields.hpp>
#include <jauscat/wire/bit_set.hpp>
#include <jauscat/wire/field.hpp>
#include <jauscat/wire/gated_by.hpp>
#include <jauscat/wire/nested.hpp>
#include <jauscat/wire/presence.hpp>
#include <jauscat/wire/view.hpp>

#include <limits>
#include <variant>

namespace jauscat::jaus {

/// A number as it is on the wire.
using wire_number = std::variant<std::uint64_t, std::int64_t, double>;

/// How a scaled field makes integers of real values.
struct field_scale {
    double lowest{}, highest{};           ///< real values it can carry
    wire_number (*to_raw)(double real){}; ///< of a value from `lowest` to `highest`, to the nearest step
};
/// The value of a field: an integer, an enumeration, a set of bits, a floating-point number.
struct field_value {
    wire_number number{};       ///< as it travels
    const field_scale* scale{}; ///< of a scaled field
    friend constexpr bool operator==(const field_value& a, const field_value& b) noexcept {
        return a.number == b.number;
    }
};
/// What a report has under a field number.
struct field_reading {
    bool exists{};                      ///< the report has a number there, at least in some of its bodies
    std::optional<field_value> value{}; ///< where this body has it
};
/// Reads field `number` of a body; see read_field.
using field_reader = field_reading (*)(std::span<const std::byte> body, std::uint8_t number) noexcept;

namespace detail {

template <class Codec> inline constexpr field_scale scale_of{};
template <class Codec>
requires requires { typename Codec::raw_codec; }
inline constexpr field_scale scale_of<Codec>{
    .lowest = Codec::lowest, .highest = Codec::highest, .to_raw = [](double real) {
        using wide = std::conditional_t<std::is_signed_v<typename Codec::raw_type>, std::int64_t, std::uint64_t>;
        return wire_number{wide{Codec::to_raw(real)}};
    }};

template <class T> inline constexpr bool is_bit_set = false;
template <class Bit> inline constexpr bool is_bit_set<wire::bit_set<Bit>> = true;
template <class T> inline constexpr bool is_number = std::is_arithmetic_v<T> || std::is_enum_v<T> || is_bit_set<T>;

template <class T> constexpr wire_number number_of(const T& value) noexcept {
    if constexpr (is_bit_set<T>)
        return std::uint64_t{value.bits()};
    else if constexpr (std::is_enum_v<T>)
        return number_of(static_cast<std::underlying_type_t<T>>(value));
    else if constexpr (std::is_floating_point_v<T>)
        return double{value};
    else if constexpr (std::is_signed_v<T>)
        return std::int64_t{value};
    else
        return static_cast<std::uint64_t>(value);
}

/// Counts fields down to the wanted one. Each overload handles the fields of an item; a null view means an absent one.
class field_search {
  public:
    explicit constexpr field_search(std::uint8_t number) noexcept : left_{number}, over_{number == 0} {}
    field_reading found{};

    template <class View, class... Items>
    constexpr void in(const View* view, std::type_identity<wire::layout<Items...>>) noexcept {
        (in(view, std::type_identity<Items>{}), ...);
    }

  private:
    template <class View, wire::unknown_bits Unknown, class Carrier, class... Items>
    constexpr void in(const View* view, std::type_identity<wire::presence_group<Unknown, Carrier, Items...>>) noexcept {
        static_cast<void>(reached()); // the vector itself has a number, but no value to be limited
        (in(view, std::type_identity<Items>{}), ...);
    }
    template <class View, auto Member, class Codec>
    constexpr void in(const View* view, std::type_identity<wire::field<Member, Codec>>) noexcept {
        if (!reached()) return;
        using raw_value = typename wire::field<Member, Codec>::raw_value;
        if constexpr (is_number<raw_value>) {
            found.exists = true;
            if (view == nullptr) return;
            const std::optional<raw_value> value = view->template get_raw<Member>();
            if (!value) return;
            found.value = field_value{.number = number_of(*value)};
            if constexpr (requires { typename Codec::raw_codec; }) {
                found.value->scale = &scale_of<Codec>;
                if (std::is_signed_v<raw_value> && *value == std::numeric_limits<raw_value>::min())
                    found.value.reset(); // no valid value
            }
        }
    }
    // All members of the integer together, as it is on the wire.
    template <class View, class Carrier, class... Fields>
    constexpr void in(const View* view, std::type_identity<wire::bit_fields<Carrier, Fields...>>) noexcept {
        if (!reached()) return;
        found.exists = true;
        if (view == nullptr) return;
        std::uint64_t word = 0;
        std::size_t at = 0;
        const auto add = [&]<class Field>(std::type_identity<Field>) {
            if constexpr (requires { Field::key; })
                word |= (static_cast<std::uint64_t>(view->template get_raw<Field::key>()) &
                         ~std::uint64_t{} >> (64 - Field::width))
                        << at;
            at += Field::width;
        };
        (add(std::type_identity<Fields>{}), ...);
        found.value = field_value{.number = word};
    }
    template <class View, auto Member>
    constexpr void in(const View* view, std::type_identity<wire::nested<Member>>) noexcept {
        using got = decltype(view->template get<Member>());
        const std::type_identity<typename wire::nested<Member>::inner> inside{};
        if constexpr (wire::is_optional<got>) {
            const got inner = view != nullptr ? view->template get<Member>() : got{};
            in(inner ? &*inner : nullptr, inside);
        } else if (view != nullptr) {
            const got inner = view->template get<Member>();
            in(&inner, inside);
        } else {
            in(static_cast<const got*>(nullptr), inside);
        }
    }
    // Text, bytes, lists, values of a type that varies: how many numbers those take, and what is behind them, is left
    // out.
    template <class View, class Item> constexpr void in(const View*, std::type_identity<Item>) noexcept {
        over_ = true;
    }

    [[nodiscard]] constexpr bool reached() noexcept {
        if (over_ || --left_ != 0) return false;
        return over_ = true;
    }

    unsigned left_;
    bool over_;
};

} // namespace detail

/// Field `number` of the report `Report`, counted as the standard's table does: from 1, the presence vector being a
/// field, and so an integer that is divided into bits. A presence vector, a text, a list and all that follows a text or
/// a list cannot be read.
template <wire::message Report>
field_reading read_field(std::span<const std::byte> body, std::uint8_t number) noexcept {
    const wire::view<Report> view{body};
    detail::field_search search{number};
    search.in(view ? &view : nullptr, std::type_identity<wire::layout_of<Report>>{});
    return search.found;
}

} // namespace jauscat::jaus
