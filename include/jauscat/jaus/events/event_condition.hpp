// The boundaries of events: a field of a report compared with limits. RA 3.3 part 3, Create Event.
#pragma once
#include <jauscat/base/compilation.hpp>
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
JAUSCAT_CONSTEXPR std::partial_ordering reversed(std::partial_ordering order) noexcept;
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
JAUSCAT_CONSTEXPR std::optional<wire_number> number_in(const typed_value& limit) noexcept;
} // namespace detail

/// Whether a limit is a number: colours have no order.
[[nodiscard]] JAUSCAT_CONSTEXPR bool is_number(const typed_value& limit) noexcept;
/// Whether it is the floating-point value "not a number", which no value is above, below or equal to.
[[nodiscard]] JAUSCAT_CONSTEXPR bool is_nan(const typed_value& limit) noexcept;

/// Compares a field with a limit of any type by value, not by bits. A scaled field is compared with an integer as it is
/// on the wire, and with a Float or Long Float as its real value: the limit is first rounded to the steps of the field,
/// so that `equal` can be met. Unordered if the limit is NaN.
[[nodiscard]] JAUSCAT_CONSTEXPR std::partial_ordering compare(const field_value& field,
                                                              const typed_value& limit) noexcept;

/// The condition of an event's setup.
struct event_condition {
    std::optional<event_boundary> boundary{};             ///< none: any value
    std::optional<std::uint8_t> field{};                  ///< number in the report; none: the whole report
    std::optional<typed_value> lower{}, upper{}, state{}; ///< limits of the event, those that its boundary needs

    friend constexpr bool operator==(const event_condition&, const event_condition&) = default;
};

/// The limit of a boundary with one limit. Equal and not equal: the state limit, else the lower, else the upper.
/// Greater: the lower, else the upper. Less: the upper, else the lower. Null if there is none, or the boundary has two.
[[nodiscard]] JAUSCAT_CONSTEXPR const typed_value* single_limit(const event_condition& c) noexcept;

/// Whether the condition can be decided: a boundary that exists, its field and its limits, all numbers.
[[nodiscard]] JAUSCAT_CONSTEXPR bool is_complete(const event_condition& c) noexcept;

/// Whether a value meets a complete condition; a condition without boundary is met by all.
[[nodiscard]] JAUSCAT_CONSTEXPR bool holds(const event_condition& c, const field_value& value) noexcept;

} // namespace jauscat::jaus

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jaus/events/impl/event_condition.ipp>
#endif
