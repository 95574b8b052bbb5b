// The functions of event_condition.
#pragma once
#include <jauscat/jaus/events/event_condition.hpp>

namespace jauscat::jaus::detail {

JAUSCAT_CONSTEXPR std::partial_ordering reversed(std::partial_ordering order) noexcept {
    if (std::is_lt(order)) return std::partial_ordering::greater;
    return std::is_gt(order) ? std::partial_ordering::less : order;
}

JAUSCAT_CONSTEXPR std::optional<wire_number> number_in(const typed_value& limit) noexcept {
    return std::visit(
        [](const auto& value) -> std::optional<wire_number> {
            if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>)
                return number_of(value);
            else
                return std::nullopt;
        },
        limit.value);
}

} // namespace jauscat::jaus::detail

namespace jauscat::jaus {

JAUSCAT_CONSTEXPR bool is_number(const typed_value& limit) noexcept { return limit.data_type <= data_type::long_float; }

JAUSCAT_CONSTEXPR bool is_nan(const typed_value& limit) noexcept {
    const auto number = detail::number_in(limit);
    const auto* const real = number ? std::get_if<double>(&*number) : nullptr;
    return real != nullptr && detail::is_nan(*real);
}

JAUSCAT_CONSTEXPR std::partial_ordering compare(const field_value& field, const typed_value& limit) noexcept {
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

JAUSCAT_CONSTEXPR const typed_value* single_limit(const event_condition& c) noexcept {
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

JAUSCAT_CONSTEXPR bool is_complete(const event_condition& c) noexcept {
    if (!c.boundary) return true;
    if (!c.field || *c.boundary > event_boundary::strictly_less_than) return false;
    if (*c.boundary >= event_boundary::inside_inclusive && *c.boundary <= event_boundary::outside_exclusive)
        return c.lower && c.upper && is_number(*c.lower) && is_number(*c.upper);
    const typed_value* const limit = single_limit(c);
    return limit != nullptr && is_number(*limit);
}

JAUSCAT_CONSTEXPR bool holds(const event_condition& c, const field_value& value) noexcept {
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
