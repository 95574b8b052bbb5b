// Numbers as text of a fixed form.
#pragma once
#include <array>
#include <charconv>
#include <string>

namespace jausdump {

/// "12.35", in any locale.
inline std::string fixed_text(double number, int digits) {
    std::array<char, 400> text{};
    const auto made = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed, digits);
    return {text.data(), made.ptr};
}

} // namespace jausdump
