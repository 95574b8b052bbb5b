// Bytes written as hexadecimal text, for expectations that can be read.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat::test {

/// "01 02ff" to bytes; anything that is not a hexadecimal digit separates.
inline std::vector<std::byte> from_hex(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::vector<std::byte> bytes;
    unsigned pending = 0, count = 0;
    for (const char c : text) {
        const auto digit = digits.find(c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c);
        if (digit == std::string_view::npos) continue;
        pending = pending * 16 + static_cast<unsigned>(digit);
        if (++count % 2 == 0) {
            bytes.push_back(static_cast<std::byte>(pending));
            pending = 0;
        }
    }
    return bytes;
}

/// The same in a constant expression. Text that is not exactly `Size` bytes does not compile.
template <std::size_t Size> consteval std::array<std::byte, Size> hex_literal(std::string_view text) {
    std::array<std::byte, Size> bytes{};
    std::size_t digits = 0;
    for (const char c : text) {
        if (c == ' ') continue;
        const auto digit = std::string_view{"0123456789abcdef"}.find(c);
        if (digit > 15) throw "not a hexadecimal digit";
        bytes.at(digits / 2) = bytes.at(digits / 2) << 4 | static_cast<std::byte>(digit);
        ++digits;
    }
    if (digits != 2 * Size) throw "not as many digits as the bytes need";
    return bytes;
}

/// Bytes to "01 02 ff".
inline std::string to_hex(std::span<const std::byte> bytes) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const std::byte byte : bytes) {
        if (!text.empty()) text += ' ';
        text += digits[std::to_integer<unsigned>(byte) >> 4];
        text += digits[std::to_integer<unsigned>(byte) & 15];
    }
    return text;
}

/// The bytes of a text that groups its digits otherwise, as `to_hex` spells them.
inline std::string hex_of(std::string_view text) { return to_hex(from_hex(text)); }

} // namespace jauscat::test
