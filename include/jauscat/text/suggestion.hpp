// Suggests the nearest name for an unknown one.
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat::text {

/// Fewest characters to insert, delete or replace to turn one text into the other.
[[nodiscard]] inline std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j != row.size(); ++j) row[j] = j;
    for (std::size_t i = 0; i != a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j != b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
        }
    }
    return row.back();
}

/// `; did you mean speed?`, or where no name is close `; there are x, y and z`, or nothing where there are many.
[[nodiscard]] inline std::string suggestion(std::string_view wrong, std::span<const std::string_view> names) {
    std::string_view nearest;
    std::size_t least = wrong.size() / 3 + 2; // more changes than that make another word
    for (const std::string_view name : names) {
        const std::size_t distance = edit_distance(wrong, name);
        // A part of a long name is as good as a typing error: `linear_effort_x`.
        const bool part = wrong.size() >= 4 && name.find(wrong) != std::string_view::npos;
        if (name.empty() || std::min(distance, part ? std::size_t{1} : distance) >= least) continue;
        least = part ? 1 : distance;
        nearest = name;
    }
    if (!nearest.empty()) return "; did you mean " + std::string{nearest} + "?";
    std::string all;
    std::size_t left = 0, many = 0;
    for (const std::string_view name : names) many += name.empty() ? 0 : 1;
    if (many == 0 || many > 16) return {};
    left = many;
    for (const std::string_view name : names) {
        if (name.empty()) continue;
        all += all.empty() ? (many == 1 ? "; there is " : "; there are ") : left == 1 ? " and " : ", ";
        all += name;
        --left;
    }
    return all;
}

} // namespace jauscat::text
