// The boundaries of events: a field of a report compared with limits. RA 3.3 part 3, Create Event.
#pragma once
#include <jauscat/jaus/events/report_field.hpp>
#include <jauscat/schema/jaus/event.hpp>

#include <compare>
#include <limits>
#include <optional>

namespace jauscat::jaus {

namespace detail {
template <std::floating_point Real> constexpr bool is_nan(Real value) noexcept {
    return !(value <= std::numeric_limits<Real>::infinity());
}
template <std::integral Integer>
constexpr std::partial_ordering compare_exactly(Integer integer, double real) noexcept {
    // 2^63 or 2^64, which a double holds; the largest integer it may not.
    constexpr Integer half = std::numeric_limits<Integer>::max() / 2 + 1;
    constexpr double above = 2.0 * static_cast<double>(half);
    constexpr double lowest = static_cast<double>(std::numeric_limits<Integer>::min());
    if (is_nan(real)) return std::partial_ordering::unordered;
    if (real >= above) return std::partial_ordering::less;
    if (real < lowest) return std::partial_ordering::greater;
    const auto whole = static_cast<Integer>(real);
    if (integer != whole) return integer <=> whole;
    return 0.0 <=> real - static_cast<double>(whole);
}
constexpr std::partial_ordering reversed(std::partial_ordering order) noexcept {
    if (std::is_lt(order)) return std::partial_ordering::greater;
    return std::is_gt(order) ? std::partial_ordering::less : order;
}
template <class A, class B> constexpr std::partial_ordering compare_numbers(A a, B b) noexcept {
    if constexpr (std::floating_point<A> && std::floating_point<B>)
        return a <=> b;
    else if constexpr (std::floating_point<B>)
        return compare_exactly(a, b);
    else if constexpr (std::floating_point<A>)
        return reversed(compare_exactly(b, a));
    else
        return std::cmp_less(a, b)    ? std::partial_ordering::less
               : std::cmp_equal(a, b) ? std::partial_ordering::equivalent
                                      : std::partial_ordering::greater;
}
// The number of a limit; none for a colour.
constexpr std::optional<wire_number> number_in(const typed_value& limit) noexcept {
    return std::visit(
        [](const auto& value) -> std::optional<wire_number> {
            if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>)
                return number_of(value);
            else
                return std::nullopt;
        },
        limit.value);
}
} // namespace detail

/// Whether a limit is a number: colours have no order.
[[nodiscard]] constexpr bool is_number(const typed_value& limit) noexcept {
    return limit.data_type <= data_type::long_float;
}
/// Whether it is the floating-point value "not a number", which no value is above, below or equal to.
[[nodiscard]] constexpr bool is_nan(const typed_value& limit) noexcept {
    const auto number = detail::number_in(limit);
    const auto* const real = number ? std::get_if<double>(&*number) : nullptr;
    return real != nullptr && detail::is_nan(*real);
}

/// Compares a field with a limit of any type by value, not by bits. A scaled field is compared with an integer as it is
/// on the wire, and with a Float or Long Float as its real value: the limit is first rounded to the steps of the field,
/// so that `equal` can be met. Unordered if the limit is NaN.
[[nodiscard]] constexpr std::partial_ordering compare(const field_value& field, const typed_value& limit) noexcept {
    auto number = detail::number_in(limit);
    if (!number) return std::partial_ordering::unordered;
    const auto* const real = std::get_if<double>(&*number);
    if (real != nullptr && field.scale != nullptr) {
        if (detail::is_nan(*real)) return std::partial_ordering::unordered;
        if (*real < field.scale->lowest) return std::partial_ordering::greater;
        if (*real > field.scale->highest) return std::partial_ordering::less;
        number = field.scale->to_raw(*real);
    }
    return std::visit([](auto a, auto b) { return detail::compare_numbers(a, b); }, field.number, *number);
}

/// The condition of an event's setup.
struct event_condition {
    std::optional<event_boundary> boundary{};             ///< none: any value
    std::optional<std::uint8_t> field{};                  ///< number in the report; none: the whole report
    std::optional<typed_value> lower{}, upper{}, state{}; ///< limits of the event, those that its boundary needs

    friend constexpr bool operator==(const event_condition&, const event_condition&) = default;
};

/// The limit of a boundary with one limit. Equal and not equal: the state limit, else the lower, else the upper.
/// Greater: the lower, else the upper. Less: the upper, else the lower. Null if there is none, or the boundary has two.
[[nodiscard]] constexpr const typed_value* single_limit(const event_condition& c) noexcept {
    const auto first = [](const auto&... limits) {
        const typed_value* found = nullptr;
        ((found = found == nullptr && limits ? &*limits : found), ...);
        return found;
    };
    switch (*c.boundary) {
    case event_boundary::equal:
    case event_boundary::not_equal: return first(c.state, c.lower, c.upper);
    case event_boundary::greater_than_or_equal:
    case event_boundary::strictly_greater_than: return first(c.lower, c.upper);
    case event_boundary::less_than_or_equal:
    case event_boundary::strictly_less_than: return first(c.upper, c.lower);
    default: return nullptr;
    }
}

/// Whether the condition can be decided: a boundary that exists, its field and its limits, all numbers.
[[nodiscard]] constexpr bool is_complete(const event_condition& c) noexcept {
    if (!c.boundary) return true;
    if (!c.field || *c.boundary > event_boundary::strictly_less_than) return false;
    if (*c.boundary >= event_boundary::inside_inclusive && *c.boundary <= event_boundary::outside_exclusive)
        return c.lower && c.upper && is_number(*c.lower) && is_number(*c.upper);
    const typed_value* const limit = single_limit(c);
    return limit != nullptr && is_number(*limit);
}

/// Whether a value meets a complete condition; a condition without boundary is met by all.
[[nodiscard]] constexpr bool holds(const event_condition& c, const field_value& value) noexcept {
    if (!c.boundary) return true;
    const auto with = [&](const typed_value* limit) { return compare(value, *limit); };
    switch (*c.boundary) {
    case event_boundary::equal: return std::is_eq(with(single_limit(c)));
    case event_boundary::not_equal: return std::is_neq(with(single_limit(c)));
    case event_boundary::inside_inclusive: return std::is_gteq(with(&*c.lower)) && std::is_lteq(with(&*c.upper));
    case event_boundary::inside_exclusive: return std::is_gt(with(&*c.lower)) && std::is_lt(with(&*c.upper));
    case event_boundary::outside_inclusive: return std::is_lteq(with(&*c.lower)) || std::is_gteq(with(&*c.upper));
    case event_boundary::outside_exclusive: return std::is_lt(with(&*c.lower)) || std::is_gt(with(&*c.upper));
    case event_boundary::greater_than_or_equal: return std::is_gteq(with(single_limit(c)));
    case event_boundary::strictly_greater_than: return std::is_gt(with(single_limit(c)));
    case event_boundary::less_than_or_equal: return std::is_lteq(with(single_limit(c)));
    case event_boundary::strictly_less_than: return std::is_lt(with(single_limit(c)));
    }
    return false;
}

} // namespace jauscat::jaus
