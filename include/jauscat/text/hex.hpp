// Hex dumps of bytes.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace jauscat::text {

/// `06 02 05 04`: two digits a byte, spaces between.
[[nodiscard]] inline std::string hex(std::span<const std::byte> bytes) {
    constexpr const char* digits = "0123456789abcdef";
    std::string text;
    text.reserve(bytes.size() * 3);
    for (const std::byte b : bytes) {
        if (!text.empty()) text += ' ';
        text += digits[std::to_integer<unsigned>(b) >> 4];
        text += digits[std::to_integer<unsigned>(b) & 0xF];
    }
    return text;
}

/// `0x1AF4`: at least `digits` digits.
[[nodiscard]] inline std::string hex_number(std::uint64_t value, std::size_t digits) {
    std::string text;
    for (; value != 0 || text.size() < digits; value >>= 4) text.insert(text.begin(), "0123456789ABCDEF"[value & 0xF]);
    return "0x" + text;
}

/// `1AF4h`: four digits, as the standards write codes, indices and addresses.
[[nodiscard]] inline std::string hex_word(std::uint16_t value) { return hex_number(value, 4).substr(2) + "h"; }

/// Where bytes stand in a dump: at least four digits.
[[nodiscard]] inline std::string hex_offset(std::size_t offset) {
    std::string text;
    for (; offset != 0 || text.size() < 4; offset >>= 4) text.insert(text.begin(), "0123456789abcdef"[offset & 0xF]);
    return text;
}

/// Lines of 16 bytes, each with its offset, counted from `first_offset`, behind `indent`.
[[nodiscard]] inline std::string hex_dump(std::span<const std::byte> bytes, const std::string& indent = "  ",
                                          std::size_t first_offset = 0) {
    std::string text;
    for (std::size_t at = 0; at < bytes.size(); at += 16) {
        text += indent + hex_offset(first_offset + at);
        text += "  " + hex(bytes.subspan(at, std::min<std::size_t>(16, bytes.size() - at))) + "\n";
    }
    return text;
}

} // namespace jauscat::text
