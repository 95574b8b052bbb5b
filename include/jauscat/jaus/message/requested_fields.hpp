// Applies the presence vector of a query to its report.
#pragma once
#include <jauscat/wire/visit.hpp>

#include <concepts>
#include <cstdint>

namespace jauscat::jaus {

/// Removes from `report` every optional field with a clear bit in `presence_vector`, that of the query.
template <wire::message Report>
constexpr void keep_requested(Report& report, std::unsigned_integral auto presence_vector) noexcept {
    std::size_t bit = 0;
    wire::visit(report, [&]<class Item>(Item, auto& member) {
        if constexpr (Item::optional) {
            if ((presence_vector >> bit++ & 1u) == 0) member.reset();
        }
    });
}

/// The presence vector that `message` encodes with: what a query must carry to ask for just its fields.
template <wire::message Message>
[[nodiscard]] constexpr std::uint64_t presence_vector_of(const Message& message) noexcept {
    std::uint64_t vector = 0, bit = 1;
    wire::visit(message, [&]<class Item>(Item, const auto& member) {
        if constexpr (Item::optional) {
            if (member) vector |= bit;
            bit <<= 1;
        }
    });
    return vector;
}

} // namespace jauscat::jaus
