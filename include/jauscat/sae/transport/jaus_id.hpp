// JAUS IDs of SAE: validity, wildcards, text.
#pragma once
#include <jauscat/schema/sae/transport/header.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace jauscat::sae {

/// The wildcards: every component, every node, every subsystem.
inline constexpr std::uint8_t all_components = 0xFF, all_nodes = 0xFF;
inline constexpr std::uint16_t all_subsystems = 0xFFFF;
inline constexpr jaus_id everybody{all_components, all_nodes, all_subsystems};

[[nodiscard]] constexpr bool has_wildcard(const jaus_id& a) noexcept {
    return a.component == all_components || a.node == all_nodes || a.subsystem == all_subsystems;
}
/// Whether a part is 0, which is not assignable.
[[nodiscard]] constexpr bool has_zero(const jaus_id& a) noexcept {
    return a.component == 0 || a.node == 0 || a.subsystem == 0;
}
[[nodiscard]] constexpr bool names_one_component(const jaus_id& a) noexcept { return !has_wildcard(a) && !has_zero(a); }

/// Whether a received message to `destination` is for `component`. A part that is a wildcard matches every number, and
/// so does a part of 0: peers send it where they do not know the number. 0.0.0 matches none.
[[nodiscard]] constexpr bool covers(const jaus_id& destination, const jaus_id& component) noexcept {
    const auto part = [](unsigned pattern, unsigned all, unsigned number) {
        return pattern == number || pattern == all || pattern == 0;
    };
    return destination != jaus_id{} && part(destination.subsystem, all_subsystems, component.subsystem) &&
           part(destination.node, all_nodes, component.node) &&
           part(destination.component, all_components, component.component);
}

/// A JAUS ID as text, "126.1.10"; wildcards as the numbers that they are.
class jaus_id_text {
  public:
    constexpr explicit jaus_id_text(const jaus_id& a) noexcept {
        put(a.subsystem);
        text_[size_++] = '.';
        put(a.node);
        text_[size_++] = '.';
        put(a.component);
    }
    [[nodiscard]] constexpr std::string_view view() const noexcept { return {text_.data(), size_}; }

  private:
    constexpr void put(unsigned number) noexcept {
        unsigned divisor = 1;
        while (number / divisor > 9) divisor *= 10;
        for (; divisor != 0; divisor /= 10) text_[size_++] = static_cast<char>('0' + number / divisor % 10);
    }

    std::array<char, 13> text_{}; // 65535.255.255
    std::size_t size_{};
};

/// The JAUS ID of a text such as "126.1.10": three decimal numbers. Nothing for other text, and for numbers that are
/// too large. Zeros and wildcards are accepted.
[[nodiscard]] constexpr std::optional<jaus_id> parse_jaus_id(std::string_view text) noexcept {
    constexpr std::array<unsigned, 3> most{0xFFFF, 0xFF, 0xFF};
    std::array<unsigned, 3> parts{};
    std::size_t part = 0, digits = 0;
    for (const char c : text) {
        if (c == '.') {
            if (digits == 0 || ++part == parts.size()) return {};
            digits = 0;
            continue;
        }
        if (c < '0' || c > '9' || (digits != 0 && parts[part] == 0)) return {};
        parts[part] = parts[part] * 10 + static_cast<unsigned>(c - '0');
        if (parts[part] > most[part]) return {};
        ++digits;
    }
    if (part + 1 != parts.size() || digits == 0) return {};
    return jaus_id{static_cast<std::uint8_t>(parts[2]), static_cast<std::uint8_t>(parts[1]),
                   static_cast<std::uint16_t>(parts[0])};
}

} // namespace jauscat::sae
