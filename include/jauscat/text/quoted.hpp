// Text of messages between quotes, safe for a terminal. Messages contain octets: UTF-8 text remains readable, any other
// octet is escaped.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace jauscat::text {

/// Whether `text` is UTF-8 throughout (RFC 3629: no overlong forms, no surrogates, nothing above U+10FFFF).
[[nodiscard]] constexpr bool is_utf8(std::string_view text) noexcept {
    for (std::size_t i = 0; i != text.size();) {
        const auto octet = [&](std::size_t at) { return static_cast<std::uint8_t>(text[at]); };
        const std::uint8_t lead = octet(i++);
        if (lead < 0x80) continue;
        const std::size_t more = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : 1;
        if (lead < 0xC2 || lead > 0xF4 || text.size() - i < more) return false;
        const std::uint8_t next = octet(i);
        if ((lead == 0xE0 && next < 0xA0) || (lead == 0xED && next > 0x9F) || (lead == 0xF0 && next < 0x90) ||
            (lead == 0xF4 && next > 0x8F))
            return false;
        for (const std::size_t end = i + more; i != end; ++i)
            if ((octet(i) & 0xC0) != 0x80) return false;
    }
    return true;
}

/// Text of devices as UTF-8: what is not UTF-8 is taken for Latin-1 (ISO 8859-1).
[[nodiscard]] inline std::string as_utf8(std::string_view text) {
    if (is_utf8(text)) return std::string{text};
    std::string made;
    for (const char c : text) {
        const auto octet = static_cast<unsigned char>(c);
        if (octet < 0x80) {
            made += c;
        } else {
            made += static_cast<char>(0xC0 | octet >> 6U);
            made += static_cast<char>(0x80 | (octet & 0x3FU));
        }
    }
    return made;
}

/// `"text"`: quotes and backslashes behind a backslash, control characters and octets that are no UTF-8 as \xHH.
[[nodiscard]] inline std::string quoted(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    const bool readable = is_utf8(text);
    std::string made = "\"";
    for (const char c : text) {
        const auto octet = static_cast<std::uint8_t>(c);
        if (c == '"' || c == '\\')
            (made += '\\') += c;
        else if (octet < 0x20 || octet == 0x7F || (octet >= 0x80 && !readable))
            ((made += "\\x") += digits[octet >> 4]) += digits[octet & 0xF];
        else
            made += c;
    }
    return made + '"';
}

} // namespace jauscat::text
