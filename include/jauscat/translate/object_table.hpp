// Tables between the lists of a message and objects of several axes: element n of a list is an object of axis n, in
// other units.
#pragma once
#include <jauscat/base/result.hpp>
#include <jauscat/translate/errc.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>
#include <jauscat/wire/repeated.hpp>
#include <jauscat/wire/schema.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>

namespace jauscat::translate {

/// How a value of a message becomes that of an object, by the parameters `Scale` of an axis. All static and noexcept:
/// - `from`: the unit of the message's range, a std::string_view;
/// - `to`: the unit of the object;
/// - `zero_within_step`: whether a value of at most one step of the message's integer is 0, because the integer has no
///   exact 0;
/// - `to_object(double, const Scale&)`, `limited(double, const Scale&)`, `from_object(double, const Scale&)`: double.
template <class T, class Scale>
concept unit_conversion = requires(double value, const Scale& scale) {
    { T::from } -> std::convertible_to<std::string_view>;
    T::to;
    { T::zero_within_step } -> std::convertible_to<bool>;
    { T::to_object(value, scale) } noexcept -> std::same_as<double>;
    { T::limited(value, scale) } noexcept -> std::same_as<double>;
    { T::from_object(value, scale) } noexcept -> std::same_as<double>;
};

namespace detail {

template <class Item, auto Member> inline constexpr bool is_item_of = false;
template <class Item, auto Member>
requires std::same_as<std::remove_cvref_t<decltype(Item::key)>, std::remove_cvref_t<decltype(Member)>>
inline constexpr bool is_item_of<Item, Member> = Item::key == Member;

template <auto Member, class Layout> struct item_of_member;
template <auto Member, class First, class... Rest> struct item_of_member<Member, wire::layout<First, Rest...>> {
    static auto pick() {
        if constexpr (is_item_of<First, Member>)
            return std::type_identity<First>{};
        else
            return typename item_of_member<Member, wire::layout<Rest...>>::found{};
    }
    using found = decltype(pick());
};
template <auto Member> struct item_of_member<Member, wire::layout<>> {
    using found = std::type_identity<void>;
};

template <class Item> concept list_of_real = requires { typename Item::element_type::codec_type::range_type; };
template <class Item> inline constexpr std::string_view unit_of = Item::element_type::codec_type::range_type::unit;

} // namespace detail

/// Element n of the list `Member` and `Object` of axis n, converted by `Conversion`. `Object` has `value_type`, an
/// integer, and `unit`.
template <auto Member, const auto& Object, class Conversion> struct axis_row {
    static constexpr auto member = Member;
    static constexpr const auto& object = Object;
    using conversion = Conversion;
    using value_type = typename std::remove_cvref_t<decltype(Object)>::value_type;
    static_assert(std::integral<value_type>, "axis_row: the object is not an integer");
    static_assert(Object.unit == Conversion::to, "axis_row: the object has another unit than the conversion gives");
};

/// A table between `Message` and objects of the axes, each with its parameters `Scale`. The message consists of lists
/// of scaled values; each list is used by one row.
template <wire::message Message, class Scale, class... Rows> struct object_table {
    using message_type = Message;
    using scale_type = Scale;
    using layout = wire::layout_of<Message>;
    template <class Row> using item_of = typename detail::item_of_member<Row::member, layout>::found::type;

    template <auto Member>
    static constexpr bool is_used_once =
        (std::size_t{std::is_same_v<wire::key_list<Member>, wire::key_list<Rows::member>>} + ... + 0) == 1;

    static_assert((unit_conversion<typename Rows::conversion, Scale> && ...),
                  "object_table: a row has no unit_conversion for the parameters of an axis");
    static_assert((layout::keys::template holds<Rows::member> && ...),
                  "object_table: a row names a member that the message does not have");
    static_assert((detail::list_of_real<item_of<Rows>> && ...),
                  "object_table: a row names a member that is no list of scaled values");
    static_assert(sizeof...(Rows) == layout::keys::count && (is_used_once<Rows::member> && ...),
                  "object_table: each list of the message needs one row");
    static_assert(((detail::unit_of<item_of<Rows>> == Rows::conversion::from) && ...),
                  "object_table: a list has another unit than the conversion takes");

    /// Calls `visit(Row{})` for each row.
    static constexpr void for_rows(auto&& visit) noexcept { (visit(Rows{}), ...); }
};

namespace detail {

/// The integer nearest to `value`; the end of its range where it is beyond.
template <class Value> [[nodiscard]] constexpr Value nearest(double value) noexcept {
    constexpr auto lowest = static_cast<double>(std::numeric_limits<Value>::min());
    constexpr auto highest = static_cast<double>(std::numeric_limits<Value>::max());
    const double rounded = value + (value < 0 ? -0.5 : 0.5);
    if (rounded <= lowest) return std::numeric_limits<Value>::min();
    if (rounded >= highest) return std::numeric_limits<Value>::max();
    return static_cast<Value>(rounded);
}

} // namespace detail

/// One bit for each axis, from axis 1 in bit 0.
using axis_bits = std::uint64_t;

/// Translates by the rows of `Table`, an object_table. Up to 64 axes.
template <class Table> struct object_translator {
    using message_type = typename Table::message_type;
    using scale_type = typename Table::scale_type;

    /// Calls `sink(axis, object, value)` for each axis and row, with the value in the object's type; returns the axes
    /// for which a limit is used in place of the message's value. Errors, without a call: wrong_size (another number of
    /// elements than `axes`), truncated, out_of_range (also of a conversion that gives NaN).
    [[nodiscard]] static constexpr result<axis_bits, errc>
    to_objects(std::span<const std::byte> body, std::span<const scale_type> axes, auto&& sink) noexcept {
        message_type message{};
        if (const auto taken = wire::decode(message, body); !taken)
            return taken.error() == wire::errc::truncated      ? errc::truncated
                   : taken.error() == wire::errc::out_of_range ? errc::out_of_range
                                                               : errc::wrong_size;
        bool fits = axes.size() <= 64;
        Table::for_rows(
            [&]<class Row>(Row) { fits = fits && wire::member_of<Row::member>(message).size() == axes.size(); });
        if (!fits) return errc::wrong_size;
        bool are_numbers = true;
        Table::for_rows([&]<class Row>(Row) {
            const auto& list = wire::member_of<Row::member>(message);
            for (std::size_t i = 0; i != axes.size(); ++i) {
                const double wanted = Row::conversion::limited(Row::conversion::to_object(list[i], axes[i]), axes[i]);
                are_numbers = are_numbers && wanted == wanted; // NaN is equal to nothing
            }
        });
        if (!are_numbers) return errc::out_of_range;
        axis_bits limited = 0;
        Table::for_rows([&]<class Row>(Row) {
            using conversion = typename Row::conversion;
            using codec = typename Table::template item_of<Row>::element_type::codec_type;
            constexpr double step = codec::to_real(1) - codec::to_real(0);
            const auto& list = wire::member_of<Row::member>(message);
            for (std::size_t i = 0; i != axes.size(); ++i) {
                const bool is_zero = conversion::zero_within_step && list[i] <= step && list[i] >= -step;
                const double wanted = is_zero ? 0 : conversion::to_object(list[i], axes[i]);
                const double allowed = conversion::limited(wanted, axes[i]);
                const auto value = nearest_of<Row>(allowed);
                if (allowed != wanted || nearest_of<Row>(wanted) != value) limited |= axis_bits{1} << i;
                sink(i, Row::object, value);
            }
        });
        return limited;
    }
    /// Writes the message with the values that `source(axis, object)` returns to `body`, and returns it. Values beyond
    /// the message's range become its limit. Errors: wrong_size (more axes than the message's capacity), no_space.
    [[nodiscard]] static constexpr result<std::span<std::byte>, errc>
    from_objects(auto&& source, std::span<const scale_type> axes, std::span<std::byte> body) noexcept {
        message_type message{};
        bool fits = true;
        Table::for_rows([&]<class Row>(Row) {
            using range = typename Table::template item_of<Row>::element_type::codec_type::range_type;
            auto& list = wire::member_of<Row::member>(message);
            for (std::size_t i = 0; i != axes.size(); ++i) {
                const auto value = static_cast<double>(source(i, Row::object));
                const double real = Row::conversion::from_object(value, axes[i]);
                fits = list.push_back(real < range::min ? range::min : real > range::max ? range::max : real) && fits;
            }
        });
        if (!fits) return errc::wrong_size;
        const auto written = wire::encode(message, body);
        if (!written) return written.error() == wire::errc::no_space ? errc::no_space : errc::out_of_range;
        return *written;
    }

  private:
    template <class Row> [[nodiscard]] static constexpr auto nearest_of(double value) noexcept {
        return detail::nearest<typename Row::value_type>(value);
    }
};

} // namespace jauscat::translate
