// The functions of text_values.hpp.
#pragma once
#include <jauscat/esi/text_values.hpp>

#include <algorithm>
#include <bit>
#include <charconv>

namespace jauscat::esi {

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL std::string hex_number(std::uint32_t value, std::size_t digits) {
    std::string text;
    for (; value != 0 || text.size() < digits; value >>= 4) text.insert(text.begin(), "0123456789ABCDEF"[value & 15]);
    return "#x" + text;
}

JAUSCAT_DECL std::optional<std::uint32_t> parse_number(std::string_view text, std::uint32_t max) {
    const bool hex = text.starts_with("#x");
    if (hex) text.remove_prefix(2);
    std::uint32_t value{};
    const auto* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value, hex ? 16 : 10);
    if (error != std::errc{} || stop != end || value > max) return std::nullopt;
    return value;
}

JAUSCAT_DECL std::string_view trimmed(std::string_view text) {
    constexpr std::string_view space = " \t\r\n";
    const auto first = text.find_first_not_of(space);
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(space) + 1 - first);
}

JAUSCAT_DECL std::string without_space(std::string_view text) {
    std::string made{text};
    std::erase_if(made, [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; });
    return made;
}

JAUSCAT_DECL std::optional<std::uint32_t> parse_number_liberally(std::string_view text, std::uint32_t max) {
    auto digits = without_space(text);
    if (digits.size() > 2 && (digits[0] == '#' || digits[0] == '0') && (digits[1] == 'x' || digits[1] == 'X'))
        digits.replace(0, 2, "#x");
    return parse_number(digits, max);
}

JAUSCAT_DECL std::optional<std::int32_t> parse_integer(std::string_view text, std::int32_t min, std::int32_t max) {
    std::int32_t value{};
    const auto* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end || value < min || value > max) return std::nullopt;
    return value;
}

JAUSCAT_DECL std::optional<bool> parse_boolean(std::string_view text) {
    if (text == "true" || text == "1") return true;
    if (text == "false" || text == "0") return false;
    return std::nullopt;
}

JAUSCAT_DECL std::string hex_bytes(std::span<const std::byte> bytes) {
    std::string text;
    for (const auto byte : bytes) {
        text += "0123456789ABCDEF"[std::to_integer<unsigned>(byte) >> 4];
        text += "0123456789ABCDEF"[std::to_integer<unsigned>(byte) & 15];
    }
    return text;
}

JAUSCAT_DECL std::optional<std::vector<std::byte>> parse_bytes(std::string_view text) {
    std::vector<std::byte> bytes;
    const auto digits = without_space(text);
    if (digits.size() % 2 != 0) return std::nullopt;
    for (std::string_view rest{digits}; !rest.empty(); rest.remove_prefix(2)) {
        unsigned byte{};
        const auto [stop, error] = std::from_chars(rest.data(), rest.data() + 2, byte, 16);
        if (error != std::errc{} || stop != rest.data() + 2) return std::nullopt;
        bytes.push_back(static_cast<std::byte>(byte));
    }
    return bytes;
}

JAUSCAT_DECL std::string_view data_type_name(std::uint16_t type) {
    for (const auto& [number, name] : data_type_names)
        if (number == type) return name;
    return {};
}

JAUSCAT_DECL std::uint16_t parse_data_type(std::string_view text) {
    for (const auto& [number, name] : data_type_names)
        if (name == text) return number;
    return 0;
}

JAUSCAT_DECL std::string octet_string_type(std::size_t bytes) { return "OCTET_STRING(" + std::to_string(bytes) + ')'; }

JAUSCAT_DECL std::string string_type(std::size_t characters) { return "STRING(" + std::to_string(characters) + ')'; }

JAUSCAT_DECL std::optional<std::vector<std::byte>> parse_value(std::string_view text, std::string_view type) {
    const auto* const found = std::ranges::find(sized_types, type, [](const auto& each) { return each.first; });
    if (found == sized_types.end()) return std::nullopt;
    const auto bits = found->second;
    if (bits > 64) return std::nullopt;
    std::uint64_t value{};
    const auto parsed = [&]<class T>(std::string_view digits, T& into, auto... base) {
        const auto* const end = digits.data() + digits.size();
        const auto [stop, error] = std::from_chars(digits.data(), end, into, base...);
        return error == std::errc{} && stop == end;
    };
    const auto number = without_space(text);
    if (type == "REAL" || type == "LREAL") {
        double real{};
        if (!parsed(number, real)) return std::nullopt;
        value = type == "LREAL" ? std::bit_cast<std::uint64_t>(real)
                                : std::bit_cast<std::uint32_t>(static_cast<float>(real));
    } else if (number.starts_with('-')) {
        std::int64_t negative{};
        if (!parsed(number, negative) || negative >> (bits - 1) != -1) return std::nullopt;
        value = static_cast<std::uint64_t>(negative);
    } else {
        const bool hex = number.starts_with("#x");
        if (!parsed(std::string_view{number}.substr(hex ? 2 : 0), value, hex ? 16 : 10)) return std::nullopt;
        if (bits < 64 && value >> bits != 0) return std::nullopt;
    }
    return little_endian(value, (bits + 7) / 8);
}

JAUSCAT_DECL bool is_string_type(std::string_view type) {
    return type.starts_with("STRING(") || type.starts_with("VISIBLE_STRING(");
}

JAUSCAT_DECL std::vector<std::byte> little_endian(std::uint64_t value, std::size_t size) {
    std::vector<std::byte> bytes(size);
    for (auto& each : bytes) {
        each = static_cast<std::byte>(value & 0xFF);
        value >>= 8;
    }
    return bytes;
}

JAUSCAT_DECL std::optional<std::uint32_t> bits_of(std::string_view type) {
    for (const auto& [name, bits] : sized_types)
        if (type == name) return bits;
    // The length, or the last index, is between `before` and `after`.
    const auto between = [&](std::string_view before, std::string_view after) -> std::optional<std::uint32_t> {
        if (!type.starts_with(before) || !type.ends_with(after) || type.size() <= before.size() + after.size())
            return std::nullopt;
        return parse_number_liberally(type.substr(before.size(), type.size() - before.size() - after.size()), 0xFFFFFF);
    };
    for (const auto& [name, size] :
         {std::pair{"STRING(", 8u}, {"VISIBLE_STRING(", 8u}, {"OCTET_STRING(", 8u}, {"UNICODE_STRING(", 16u}})
        if (const auto length = between(name, ")")) return *length * size;
    for (const auto& [name, bits] : sized_types)
        if (const auto last = between("ARRAY [0..", "] OF " + std::string{name})) return (*last + 1) * bits;
    return std::nullopt;
}

JAUSCAT_DECL std::optional<ethercat::sii_sync_manager_use> parse_sync_manager_use(std::string_view text) {
    for (const auto& [use, name] : sync_manager_uses)
        if (text == name) return use;
    return std::nullopt;
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi
