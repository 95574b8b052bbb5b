// What the sources use of C++20 and libc++ 13, that of Debian's emscripten, does not have. Included before each source.
#pragma once
#include <algorithm>
#include <bit>
#include <charconv>
#include <chrono>
#include <compare>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <ranges>
#include <string>

#if _LIBCPP_VERSION < 14000
// NOLINTBEGIN(cert-dcl58-cpp)
namespace std {
inline namespace _LIBCPP_ABI_NAMESPACE {

template <class To, class From> constexpr To bit_cast(const From& from) noexcept {
    return __builtin_bit_cast(To, from);
}

inline from_chars_result from_chars(const char* first, const char* last, double& value) {
    // strtod also takes spaces, signs, hexadecimal numbers.
    const bool is_number = first != last && (*first == '-' || *first == '.' || (*first >= '0' && *first <= '9') ||
                                             *first == 'i' || *first == 'n');
    const string text(first, last);
    char* end{};
    const double read = strtod(text.c_str(), &end);
    if (!is_number || end == text.c_str() || text.find_first_of("xX") != string::npos)
        return {first, errc::invalid_argument};
    value = read;
    return {first + (end - text.c_str()), errc{}};
}

inline to_chars_result to_chars(char* first, char* last, double value, chars_format, int digits) {
    return {first + snprintf(first, static_cast<size_t>(last - first), "%.*g", digits, value), errc{}};
}

constexpr bool is_eq(partial_ordering order) noexcept { return order == 0; }
constexpr bool is_neq(partial_ordering order) noexcept { return order != 0; }

namespace ranges {

template <class Range, class Value, class Projection = identity>
constexpr auto find(Range&& range, const Value& value, Projection project = {}) {
    auto i = std::begin(range);
    while (i != std::end(range) && !(std::invoke(project, *i) == value)) ++i;
    return i;
}
template <class Iterator, class Value, class Projection = identity>
constexpr auto find(Iterator i, Iterator last, const Value& value, Projection project = {}) {
    while (i != last && !(std::invoke(project, *i) == value)) ++i;
    return i;
}
template <class Range, class Predicate, class Projection = identity>
constexpr auto find_if(Range&& range, Predicate is, Projection project = {}) {
    auto i = std::begin(range);
    while (i != std::end(range) && !std::invoke(is, std::invoke(project, *i))) ++i;
    return i;
}
template <class Range, class Predicate, class Projection = identity>
constexpr bool any_of(Range&& range, Predicate is, Projection project = {}) {
    return ranges::find_if(range, is, project) != std::end(range);
}
template <class Range, class Predicate, class Projection = identity>
constexpr bool all_of(Range&& range, Predicate is, Projection project = {}) {
    for (auto&& one : range)
        if (!std::invoke(is, std::invoke(project, one))) return false;
    return true;
}
template <class Range, class Predicate, class Projection = identity>
constexpr bool none_of(Range&& range, Predicate is, Projection project = {}) {
    return !ranges::any_of(range, is, project);
}
template <class Range, class Predicate, class Projection = identity>
constexpr auto count_if(Range&& range, Predicate is, Projection project = {}) {
    ptrdiff_t count = 0;
    for (auto&& one : range) count += std::invoke(is, std::invoke(project, one)) ? 1 : 0;
    return count;
}
template <class Range, class Value> constexpr auto count(const Range& range, const Value& value) {
    return std::count(std::begin(range), std::end(range), value);
}
template <class Iterator> struct copy_result {
    Iterator out;
};
template <class Range, class Iterator> constexpr copy_result<Iterator> copy(Range&& range, Iterator out) {
    return {std::copy(std::begin(range), std::end(range), out)};
}
template <class From, class Iterator> constexpr copy_result<Iterator> copy(From first, From last, Iterator out) {
    return {std::copy(first, last, out)};
}
template <class Iterator> constexpr copy_result<Iterator> copy_n(auto first, auto count, Iterator out) {
    return {std::copy_n(first, count, out)};
}
template <class Range, class Value> constexpr void fill(Range&& range, const Value& value) {
    std::fill(std::begin(range), std::end(range), value);
}
template <class Range, class Iterator, class Function>
constexpr copy_result<Iterator> transform(Range&& range, Iterator out, Function function) {
    for (auto&& one : range) *out++ = std::invoke(function, one);
    return {out};
}
template <class From, class Iterator, class Function, class Projection>
constexpr copy_result<Iterator> transform(From first, From last, Iterator out, Function function, Projection project) {
    for (; first != last; ++first) *out++ = std::invoke(function, std::invoke(project, *first));
    return {out};
}
template <class From, class Iterator, class Function>
requires(!requires(From range) { std::begin(range); })
constexpr copy_result<Iterator> transform(From first, From last, Iterator out, Function function) {
    for (; first != last; ++first) *out++ = std::invoke(function, *first);
    return {out};
}
template <class Iterator, class Value> constexpr void fill(Iterator first, Iterator last, const Value& value) {
    std::fill(first, last, value);
}
template <class Range, class Function> constexpr void for_each(Range&& range, Function function) {
    for (auto&& one : range) std::invoke(function, one);
}
template <class A, class B> constexpr void swap_ranges(A&& a, B&& b) {
    std::swap_ranges(std::begin(a), std::end(a), std::begin(b));
}
template <class Range, class Less = std::less<>, class Projection = identity>
constexpr auto max_element(Range&& range, Less is_less = {}, Projection project = {}) {
    return std::max_element(std::begin(range), std::end(range), [&](const auto& a, const auto& b) {
        return std::invoke(is_less, std::invoke(project, a), std::invoke(project, b));
    });
}
template <class A, class B> constexpr bool equal(const A& a, const B& b) {
    return std::equal(std::begin(a), std::end(a), std::begin(b), std::end(b));
}
template <class Range, class Less = std::less<>, class Projection = identity>
constexpr void sort(Range&& range, Less is_less = {}, Projection project = {}) {
    std::sort(std::begin(range), std::end(range), [&](const auto& a, const auto& b) {
        return std::invoke(is_less, std::invoke(project, a), std::invoke(project, b));
    });
}
template <class Range, class Value, class Less = std::less<>, class Projection = identity>
constexpr auto lower_bound(Range&& range, const Value& value, Less is_less = {}, Projection project = {}) {
    return std::lower_bound(std::begin(range), std::end(range), value, [&](const auto& one, const auto& wanted) {
        return std::invoke(is_less, std::invoke(project, one), wanted);
    });
}
template <class Range, class Value, class Less = std::less<>, class Projection = identity>
constexpr bool binary_search(Range&& range, const Value& value, Less is_less = {}, Projection project = {}) {
    const auto found = ranges::lower_bound(range, value, is_less, project);
    return found != std::end(range) && !std::invoke(is_less, value, std::invoke(project, *found));
}
template <class Range, class Equal = std::equal_to<>, class Projection = identity>
constexpr auto adjacent_find(Range&& range, Equal is_equal = {}, Projection project = {}) {
    return std::adjacent_find(std::begin(range), std::end(range), [&](const auto& a, const auto& b) {
        return std::invoke(is_equal, std::invoke(project, a), std::invoke(project, b));
    });
}

} // namespace ranges

namespace chrono {
template <class Rep, class Period>
constexpr auto operator<=>(const duration<Rep, Period>& a, const duration<Rep, Period>& b) {
    return a.count() <=> b.count();
}
template <class Clock, class Duration>
constexpr auto operator<=>(const time_point<Clock, Duration>& a, const time_point<Clock, Duration>& b) {
    return a.time_since_epoch() <=> b.time_since_epoch();
}
} // namespace chrono
} // namespace _LIBCPP_ABI_NAMESPACE
} // namespace std
// NOLINTEND(cert-dcl58-cpp)
#endif
