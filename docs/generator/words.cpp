#include "words.hpp"

#include <jauscat/wire/item.hpp>

#include <algorithm>
#include <cctype>

namespace jauscat::reference {

std::string escaped(std::string_view text) {
    std::string made;
    for (const char c : text) {
        switch (c) {
        case '<': made += "&lt;"; break;
        case '>': made += "&gt;"; break;
        case '&': made += "&amp;"; break;
        case '"': made += "&quot;"; break;
        default: made += c;
        }
    }
    return made;
}

std::string code_digits(std::uint16_t code) {
    static constexpr std::string_view digits = "0123456789ABCDEF";
    std::string made;
    for (int shift = 12; shift >= 0; shift -= 4) made += digits[static_cast<unsigned>(code) >> shift & 15U];
    return made;
}

std::string capitalised(std::string text) {
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

std::size_t characters_of(std::string_view text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string counted(std::size_t count, std::string_view what) {
    return std::to_string(count) + " " + std::string{what} + (count == 1 ? "" : "s");
}

std::string amount(std::size_t least, std::size_t most) {
    return std::to_string(least) + (most == wire::unbounded ? " or more"
                                    : most == least         ? ""
                                                            : " to " + std::to_string(most));
}

std::string span_of(std::string_view prefix, std::optional<std::size_t> at, const part& one) {
    if (!at || !condition_of(one).empty()) return {};
    const std::string first = std::string{prefix} + std::to_string(*at);
    if (one.least != one.most) return first + " …";
    return one.most < 2 ? first : first + "–" + std::to_string(*at + one.most - 1);
}

std::string bits_of(const part& field) {
    const std::string first = std::to_string(field.first_bit);
    return field.width == 1 ? "bit " + first
                            : "bits " + first + "–" + std::to_string(field.first_bit + field.width - 1);
}

void advance(std::optional<std::size_t>& at, const part& one) {
    if (one.what == part::kind::flag) return;
    if (at && condition_of(one).empty() && one.what != part::kind::list && one.least == one.most)
        *at += one.most;
    else
        at.reset();
}

std::string condition_of(const part& one) {
    if (one.presence) return "bit " + std::to_string(*one.presence);
    return one.gate.empty() ? "" : "if " + one.gate;
}

std::string numbers_of(const enumeration& tags) {
    std::string made;
    for (std::size_t first = 0; first != tags.entries.size();) {
        std::size_t last = first;
        while (last + 1 != tags.entries.size() && tags.entries[last + 1].number == tags.entries[last].number + 1)
            ++last;
        made += (made.empty() ? "" : ", ") + std::to_string(tags.entries[first].number);
        if (last != first) made += (last == first + 1 ? ", " : "–") + std::to_string(tags.entries[last].number);
        first = last + 1;
    }
    return made;
}

} // namespace jauscat::reference
