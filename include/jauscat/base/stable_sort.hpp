// A sort of short lists that keeps the order of equal elements.
#pragma once
#include <algorithm>
#include <functional>
#include <iterator>

namespace jauscat {

/// Inserts each element behind those that are not greater; in linear time where they are in order. `std::stable_sort`
/// of libstdc++ 12 calls `std::get_temporary_buffer`, and clang 19 warns in each program that this is deprecated.
template <class Range, class Projection> constexpr void stable_sort(Range& range, Projection projection) {
    const auto less = [&](const auto& a, const auto& b) {
        return std::invoke(projection, a) < std::invoke(projection, b);
    };
    for (auto next = std::begin(range); next != std::end(range); ++next)
        std::rotate(std::upper_bound(std::begin(range), next, *next, less), next, std::next(next));
}

} // namespace jauscat
