// A sort of short lists that keeps the order of equal elements.
#pragma once
#include <algorithm>
#include <functional>
#include <ranges>

namespace jauscat {

/// Inserts each element behind those that are not greater; in time linear where they are in order. `std::stable_sort`
/// of libstdc++ 12 calls `std::get_temporary_buffer`, and clang 19 warns in each program that this is deprecated.
template <std::ranges::random_access_range Range, class Projection>
constexpr void stable_sort(Range& range, Projection projection) {
    const auto begin = std::ranges::begin(range);
    for (auto next = begin; next != std::ranges::end(range); ++next)
        std::rotate(std::ranges::upper_bound(begin, next, std::invoke(projection, *next), {}, projection), next,
                    next + 1);
}

} // namespace jauscat
