// Single values from text: numbers, hex, names of enumerators and bits. Their errors name no field.
#pragma once
#include <jauscat/text/input.hpp>
#include <jauscat/text/structure.hpp>
#include <jauscat/text/suggestion.hpp>
#include <jauscat/text/value.hpp>

#include <cmath>

namespace jauscat::text::detail {

/// A number as wide as 64 bits of either sign; a negative one in two's complement.
struct whole_number {
    std::uint64_t bits{};
    bool negative{};
};
/// Decimal, or hexadecimal behind 0x.
[[nodiscard]] inline std::optional<whole_number> scan_whole(std::string_view text) {
    whole_number made{.negative = text.starts_with('-')};
    if (made.negative || text.starts_with('+')) text.remove_prefix(1);
    const int base = text.starts_with("0x") || text.starts_with("0X") ? 16 : 10;
    if (base == 16) text.remove_prefix(2);
    const auto [stop, failed] = std::from_chars(text.data(), text.data() + text.size(), made.bits, base);
    if (failed != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
    if (made.negative) {
        if (made.bits > std::uint64_t{1} << 63) return std::nullopt;
        made.negative = made.bits != 0;
        made.bits = ~made.bits + 1;
    }
    return made;
}
[[nodiscard]] inline std::optional<double> scan_real(std::string_view text) {
    if (text == "NaN") return std::numeric_limits<double>::quiet_NaN();
    if (text == "Infinity") return std::numeric_limits<double>::infinity();
    if (text == "-Infinity") return -std::numeric_limits<double>::infinity();
    if (text.starts_with('+')) text.remove_prefix(1);
    double made{};
    const auto [stop, failed] = std::from_chars(text.data(), text.data() + text.size(), made);
    if (failed != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
    return made;
}
/// Pairs of hex digits; spaces between pairs.
[[nodiscard]] inline std::optional<std::vector<std::byte>> scan_hex(std::string_view text) {
    std::vector<std::byte> bytes;
    for (std::size_t at = 0; at != text.size();) {
        if (is_space(text[at])) {
            ++at;
            continue;
        }
        if (at + 1 == text.size()) return std::nullopt;
        const auto high = hex_digit(text[at]), low = hex_digit(text[at + 1]);
        if (!high || !low) return std::nullopt;
        bytes.push_back(static_cast<std::byte>(*high * 16 + *low));
        at += 2;
    }
    return bytes;
}

inline std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
    return text;
}
/// `50 %` and `50%` where the unit is %.
inline std::string_view without_unit(std::string_view text, std::string_view unit) {
    text = trimmed(text);
    if (!unit.empty() && text.size() > unit.size() && text.ends_with(unit))
        text = trimmed(text.substr(0, text.size() - unit.size()));
    return text;
}
/// Removes `raw:`.
inline bool is_raw(std::string_view& text) {
    if (!text.starts_with("raw:")) return false;
    text.remove_prefix(4);
    return true;
}

/// An error whose message is about `text`: "is '150', must be -100 to 100 %".
inline error says(errc code, std::string_view text, const std::string& wrong) {
    return {.code = code, .value = std::string{text}, .message = "is '" + std::string{text} + "', " + wrong};
}
inline error beyond(std::string_view text, const std::string& lowest, const std::string& highest,
                    std::string_view unit) {
    return says(errc::out_of_range, text,
                "must be " + lowest + " to " + highest + (unit.empty() ? "" : " " + std::string{unit}));
}

/// An integer on the wire, within its bits.
[[nodiscard]] inline result<std::uint64_t, error> scan_bits(std::string_view text, bool is_signed, unsigned bits,
                                                            std::string_view unit) {
    const std::uint64_t most = ~std::uint64_t{} >> (64 - bits + (is_signed ? 1 : 0));
    const auto found = scan_whole(text);
    const bool fits = found && (found->negative ? is_signed && ~found->bits <= most : found->bits <= most);
    if (fits) return found->bits;
    const std::string lowest = is_signed ? std::to_string(-static_cast<std::int64_t>(most) - 1) : "0";
    return beyond(text, lowest, std::to_string(most), unit);
}

[[nodiscard]] inline result<std::uint64_t, error> scan_flags(std::string_view text, const integer_form& is) {
    std::uint64_t number = 0;
    if (text == "none") return number;
    if (scan_whole(text)) return scan_bits(text, false, is.bits, {});
    while (true) {
        const std::size_t bar = std::min(text.find('|'), text.size());
        const std::string_view name = trimmed(text.substr(0, bar));
        const auto found = std::ranges::find(is.names, name);
        std::uint64_t bit = static_cast<std::uint64_t>(found - is.names.begin());
        if (name.empty() || found == is.names.end()) {
            bit = name.starts_with("bit ") ? scan_bits(name.substr(4), false, 6, {}).value_or(is.bits) : is.bits;
            if (bit >= is.bits) return says(errc::invalid_value, name, "which is no flag" + suggestion(name, is.names));
        }
        number |= std::uint64_t{1} << bit;
        if (bar == text.size()) return number;
        text.remove_prefix(bar + 1);
    }
}

[[nodiscard]] inline result<std::uint64_t, error> scan(std::string_view text, const integer_form& is) {
    text = without_unit(text, is.unit);
    if (is_raw(text)) return scan_bits(text, is.is_signed, is.bits, {});
    switch (is.what) {
    case integer_form::meaning::boolean:
        if (text != "true" && text != "false" && text != "1" && text != "0")
            return says(errc::invalid_value, text, "must be true or false");
        return std::uint64_t{text == "true" || text == "1"};
    case integer_form::meaning::flags: return scan_flags(text, is);
    case integer_form::meaning::enumeration:
        if (const auto found = std::ranges::find(is.names, text); !text.empty() && found != is.names.end())
            return static_cast<std::uint64_t>(found - is.names.begin());
        if (!scan_whole(text))
            return says(errc::invalid_value, text, "which is no value of it" + suggestion(text, is.names));
        break;
    case integer_form::meaning::number: break;
    }
    return scan_bits(text, is.is_signed, is.bits, is.unit);
}

[[nodiscard]] inline result<double, error> scan(std::string_view text, const real_form& is) {
    const auto found = scan_real(without_unit(text, is.unit));
    if (!found) return says(errc::invalid_value, text, "which is no number");
    if (std::isfinite(*found) && std::abs(*found) > is.most)
        return beyond(text, real_text(-is.most), real_text(is.most), is.unit);
    return *found;
}

[[nodiscard]] inline result<double, error> scan_raw(std::string_view text, const scaled_form& is) {
    const auto raw = scan_bits(text, is.is_signed, is.bits, {});
    if (!raw) return raw.error();
    if (is.is_signed && *raw == ~std::uint64_t{} << (is.bits - 1))
        return says(errc::out_of_range, text, "a raw value that stands for nothing");
    return is.to_real(*raw);
}
[[nodiscard]] inline result<double, error> scan(std::string_view text, const scaled_form& is) {
    text = without_unit(text, is.unit);
    if (is_raw(text)) return scan_raw(text, is);
    const auto found = scan_real(text);
    if (!found) return says(errc::invalid_value, text, "which is no number");
    if (!(*found >= is.lowest && *found <= is.highest))
        return beyond(text, real_text(is.min), real_text(is.max), is.unit);
    return *found;
}

} // namespace jauscat::text::detail
