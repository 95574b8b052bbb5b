// Single values from text: numbers, hex, names of enumerators and bits. Each returns what is wrong, or nothing.
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
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), made.bits, base);
    if (error != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
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
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), made);
    if (error != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
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

inline std::string limits(const std::string& lowest, const std::string& highest, std::string_view unit) {
    return "must be " + lowest + " to " + highest + (unit.empty() ? "" : " " + std::string{unit});
}
inline std::string says(std::string_view text, const std::string& wrong) {
    return "is '" + std::string{text} + "', " + wrong;
}

/// An integer on the wire, within its bits.
inline std::string scan_bits(std::string_view text, bool is_signed, unsigned bits, std::string_view unit,
                             std::uint64_t& number) {
    const std::uint64_t most = ~std::uint64_t{} >> (64 - bits + (is_signed ? 1 : 0));
    const auto found = scan_whole(text);
    const bool fits = found && (found->negative ? is_signed && ~found->bits <= most : found->bits <= most);
    if (!fits) {
        const std::string lowest = is_signed ? std::to_string(-static_cast<std::int64_t>(most) - 1) : "0";
        return says(text, limits(lowest, std::to_string(most), unit));
    }
    number = found->bits;
    return {};
}

inline std::string scan_flags(std::string_view text, const integer_form& is, std::uint64_t& number) {
    number = 0;
    if (text == "none") return {};
    if (scan_whole(text)) return scan_bits(text, false, is.bits, {}, number);
    while (true) {
        const std::size_t bar = std::min(text.find('|'), text.size());
        const std::string_view name = trimmed(text.substr(0, bar));
        const auto found = std::ranges::find(is.names, name);
        std::uint64_t bit = static_cast<std::uint64_t>(found - is.names.begin());
        if (name.empty() || found == is.names.end()) {
            if (!name.starts_with("bit ") || !scan_bits(name.substr(4), false, 6, {}, bit).empty() || bit >= is.bits)
                return says(name, "which is no flag" + suggestion(name, is.names));
        }
        number |= std::uint64_t{1} << bit;
        if (bar == text.size()) return {};
        text.remove_prefix(bar + 1);
    }
}

inline std::string scan(std::string_view text, const integer_form& is, std::uint64_t& number) {
    text = without_unit(text, is.unit);
    if (is_raw(text)) return scan_bits(text, is.is_signed, is.bits, {}, number);
    switch (is.what) {
    case integer_form::meaning::boolean:
        if (text != "true" && text != "false" && text != "1" && text != "0") return says(text, "must be true or false");
        number = text == "true" || text == "1" ? 1 : 0;
        return {};
    case integer_form::meaning::flags: return scan_flags(text, is, number);
    case integer_form::meaning::enumeration:
        if (const auto found = std::ranges::find(is.names, text); !text.empty() && found != is.names.end()) {
            number = static_cast<std::uint64_t>(found - is.names.begin());
            return {};
        }
        if (!scan_whole(text)) return says(text, "which is no value of it" + suggestion(text, is.names));
        break;
    case integer_form::meaning::number: break;
    }
    return scan_bits(text, is.is_signed, is.bits, is.unit, number);
}

inline std::string scan(std::string_view text, const real_form& is, double& real) {
    const auto found = scan_real(without_unit(text, is.unit));
    if (!found) return says(text, "which is no number");
    if (std::isfinite(*found) && std::abs(*found) > is.most)
        return says(text, limits(real_text(-is.most), real_text(is.most), is.unit));
    real = *found;
    return {};
}

inline std::string scan_raw(std::string_view text, const scaled_form& is, double& real) {
    std::uint64_t raw{};
    if (std::string wrong = scan_bits(text, is.is_signed, is.bits, {}, raw); !wrong.empty()) return wrong;
    if (is.is_signed && raw == ~std::uint64_t{} << (is.bits - 1))
        return says(text, "a raw value that stands for nothing");
    real = is.to_real(raw);
    return {};
}
inline std::string scan(std::string_view text, const scaled_form& is, double& real) {
    text = without_unit(text, is.unit);
    if (is_raw(text)) return scan_raw(text, is, real);
    const auto found = scan_real(text);
    if (!found) return says(text, "which is no number");
    if (!(*found >= is.lowest && *found <= is.highest))
        return says(text, limits(real_text(is.min), real_text(is.max), is.unit));
    real = *found;
    return {};
}

} // namespace jauscat::text::detail
