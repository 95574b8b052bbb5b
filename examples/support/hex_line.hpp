// Bytes as pasted text: hex digits with any usual separators.
#pragma once
#include <cctype>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace example {

/// A line read as bytes, or why it cannot be.
struct hex_line {
    std::vector<std::byte> bytes{};
    std::string error{};  ///< "not_hex" or "odd_digits"; empty: read
    std::size_t column{}; ///< of the error, from 1
    std::string what{};   ///< the error message
};

/// Reads hex digits, two a byte. White space, `:`, `-` and `,` may stand anywhere, `0x` in front of any byte.
inline hex_line read_hex_line(std::string_view text) {
    hex_line line;
    std::optional<unsigned> high;
    for (std::size_t i = 0; i != text.size(); ++i) {
        const char c = text[i];
        if (std::isspace(static_cast<unsigned char>(c)) != 0 || c == ':' || c == '-' || c == ',') continue;
        const bool prefix = c == '0' && i + 1 != text.size() && (text[i + 1] == 'x' || text[i + 1] == 'X');
        if (prefix && !high) {
            ++i;
            continue;
        }
        constexpr std::string_view digits = "0123456789abcdef";
        const auto digit = digits.find(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
        if (digit == std::string_view::npos) {
            line.error = "not_hex";
            line.column = i + 1;
            line.what = "not a hex digit at column " + std::to_string(i + 1);
            return line;
        }
        if (high) {
            line.bytes.push_back(static_cast<std::byte>(*high * 16 + digit));
            high.reset();
        } else {
            high = static_cast<unsigned>(digit);
            line.column = i + 1;
        }
    }
    if (high) {
        line.error = "odd_digits";
        line.what =
            "an odd number of hex digits: the last, at column " + std::to_string(line.column) + ", is half a byte";
    }
    return line;
}

} // namespace example
