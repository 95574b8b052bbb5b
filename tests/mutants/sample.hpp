// Code with known mutants, for mutants_test.py.
#pragma once
#include <array>
#include <cstddef>
#include <optional>

namespace jauscat::sample {

enum class colour { red, green, blue };

struct point {
    int x{}, y{};
};

constexpr bool is_below(int value, int limit) { return value < limit; }

constexpr bool equals(const point& a, const point& b) { return a.x == b.x && a.y == b.y; }

constexpr int difference(int a, int b) { return a - b; }

constexpr int swapped(int a, int b) { return difference(a, b); }

constexpr colour next(colour given) {
    if (given == colour::red) return colour::green;
    return colour::blue;
}

constexpr int doubled(int value) {
    int result = value;
    result += value;
    return result;
}

constexpr std::optional<int> found(int value) {
    std::optional<int> result{value};
    if (const int* const at = &*result; *at > 2) return result;
    if (const bool is_odd = value % 2 != 0) return std::nullopt;
    return 7;
}

// Nothing of these can have a switch: constant expressions, types, defaults.
static_assert(is_below(1, 2) && !is_below(2, 1));
consteval int made_by_compiler(int value) { return value < 1 ? 2 : 3; }
template <std::size_t Size = 4> constexpr std::size_t size_of_array() {
    constexpr std::size_t more = 1;
    if constexpr (Size > 3) {
        std::array<int, 3 + more> values{};
        return values.size();
    } else {
        return sizeof(int[2]);
    }
}

} // namespace jauscat::sample
