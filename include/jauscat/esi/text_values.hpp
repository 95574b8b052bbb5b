// Text form of numbers, bytes, data types and SyncManager uses in ESI files.
#pragma once

#include <jauscat/schema/ethercat/data_types.hpp>
#include <jauscat/schema/ethercat/sii.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace jauscat::esi {

/// `#x1A`: a number in the schema's type HexDecValue, with at least `digits` digits.
inline std::string hex_number(std::uint32_t value, std::size_t digits = 1) {
    std::string text;
    for (; value != 0 || text.size() < digits; value >>= 4) text.insert(text.begin(), "0123456789ABCDEF"[value & 15]);
    return "#x" + text;
}

/// The value of `#x1A` or `26`, if it is at most `max`.
[[nodiscard]] inline std::optional<std::uint32_t> parse_number(std::string_view text, std::uint32_t max = 0xFFFFFFFF) {
    const bool hex = text.starts_with("#x");
    if (hex) text.remove_prefix(2);
    std::uint32_t value{};
    const auto* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value, hex ? 16 : 10);
    if (error != std::errc{} || stop != end || value > max) return std::nullopt;
    return value;
}

/// The value of `-26` or `26`, if it is `min` to `max`.
[[nodiscard]] inline std::optional<std::int32_t> parse_integer(std::string_view text, std::int32_t min,
                                                               std::int32_t max) {
    std::int32_t value{};
    const auto* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end || value < min || value > max) return std::nullopt;
    return value;
}

/// `true`, `false`, `1` or `0`.
[[nodiscard]] inline std::optional<bool> parse_boolean(std::string_view text) {
    if (text == "true" || text == "1") return true;
    if (text == "false" || text == "0") return false;
    return std::nullopt;
}

/// Two digits for each byte, without separators.
inline std::string hex_bytes(std::span<const std::byte> bytes) {
    std::string text;
    for (const auto byte : bytes) {
        text += "0123456789ABCDEF"[std::to_integer<unsigned>(byte) >> 4];
        text += "0123456789ABCDEF"[std::to_integer<unsigned>(byte) & 15];
    }
    return text;
}

/// The reverse of `hex_bytes`; nothing for any other text.
[[nodiscard]] inline std::optional<std::vector<std::byte>> parse_bytes(std::string_view text) {
    std::vector<std::byte> bytes;
    if (text.size() % 2 != 0) return std::nullopt;
    for (; !text.empty(); text.remove_prefix(2)) {
        unsigned byte{};
        const auto [stop, error] = std::from_chars(text.data(), text.data() + 2, byte, 16);
        if (error != std::errc{} || stop != text.data() + 2) return std::nullopt;
        bytes.push_back(static_cast<std::byte>(byte));
    }
    return bytes;
}

/// Base types of ETG.1020 with a fixed size, in bits.
inline constexpr std::array<std::pair<std::string_view, std::uint32_t>, 22> sized_types{
    {{"BOOL", 1},   {"BIT1", 1},   {"BIT2", 2},  {"BIT3", 3},  {"BIT4", 4},   {"BIT5", 5},  {"BIT6", 6},  {"BIT7", 7},
     {"BIT8", 8},   {"BYTE", 8},   {"SINT", 8},  {"USINT", 8}, {"INT", 16},   {"UINT", 16}, {"WORD", 16}, {"DINT", 32},
     {"UDINT", 32}, {"DWORD", 32}, {"REAL", 32}, {"LINT", 64}, {"ULINT", 64}, {"LREAL", 64}}};

/// Names of the data types of PDO entries (ETG.1000.6).
inline constexpr std::array<std::pair<std::uint16_t, std::string_view>, 19> data_type_names{
    {{ethercat::data_types::boolean, "BOOL"},
     {ethercat::data_types::integer8, "SINT"},
     {ethercat::data_types::integer16, "INT"},
     {ethercat::data_types::integer32, "DINT"},
     {ethercat::data_types::integer64, "LINT"},
     {ethercat::data_types::unsigned8, "USINT"},
     {ethercat::data_types::unsigned16, "UINT"},
     {ethercat::data_types::unsigned32, "UDINT"},
     {ethercat::data_types::unsigned64, "ULINT"},
     {ethercat::data_types::real32, "REAL"},
     {ethercat::data_types::real64, "LREAL"},
     {ethercat::data_types::bit1, "BIT1"},
     {ethercat::data_types::bit1 + 1, "BIT2"},
     {ethercat::data_types::bit1 + 2, "BIT3"},
     {ethercat::data_types::bit1 + 3, "BIT4"},
     {ethercat::data_types::bit1 + 4, "BIT5"},
     {ethercat::data_types::bit1 + 5, "BIT6"},
     {ethercat::data_types::bit1 + 6, "BIT7"},
     {ethercat::data_types::bit1 + 7, "BIT8"}}};

/// The name of a data type, or empty.
inline std::string_view data_type_name(std::uint16_t type) {
    for (const auto& [number, name] : data_type_names)
        if (number == type) return name;
    return {};
}
/// The data type of that name, or 0.
inline std::uint16_t parse_data_type(std::string_view text) {
    for (const auto& [number, name] : data_type_names)
        if (name == text) return number;
    return 0;
}

/// The base type of this number of bytes.
inline std::string octet_string_type(std::size_t bytes) { return "OCTET_STRING(" + std::to_string(bytes) + ')'; }
/// The base type of this number of characters.
inline std::string string_type(std::size_t characters) { return "STRING(" + std::to_string(characters) + ')'; }

/// The value of a number as text (`#x1A`, `26`, `-26`, `0.5`) in a base type with a fixed size, little-endian; nothing
/// for another type, or for a value that does not fit.
[[nodiscard]] inline std::optional<std::vector<std::byte>> parse_value(std::string_view text, std::string_view type) {
    const auto* const found = std::ranges::find(sized_types, type, [](const auto& each) { return each.first; });
    if (found == sized_types.end()) return std::nullopt;
    const auto bits = found->second;
    std::uint64_t value{};
    const auto parsed = [&]<class T>(std::string_view digits, T& into, auto... base) {
        const auto* const end = digits.data() + digits.size();
        const auto [stop, error] = std::from_chars(digits.data(), end, into, base...);
        return error == std::errc{} && stop == end;
    };
    if (type == "REAL" || type == "LREAL") {
        double real{};
        if (!parsed(text, real)) return std::nullopt;
        value = type == "LREAL" ? std::bit_cast<std::uint64_t>(real)
                                : std::bit_cast<std::uint32_t>(static_cast<float>(real));
    } else if (text.starts_with('-')) {
        std::int64_t negative{};
        if (!parsed(text, negative) || negative >> (bits - 1) != -1) return std::nullopt;
        value = static_cast<std::uint64_t>(negative);
    } else {
        const bool hex = text.starts_with("#x");
        if (!parsed(text.substr(hex ? 2 : 0), value, hex ? 16 : 10)) return std::nullopt;
        if (bits < 64 && value >> bits != 0) return std::nullopt;
    }
    std::vector<std::byte> bytes((bits + 7) / 8);
    for (auto& each : bytes) {
        each = static_cast<std::byte>(value & 0xFF);
        value >>= 8;
    }
    return bytes;
}

/// Size in bits of a base type: one of `sized_types`, STRING(n), OCTET_STRING(n), ARRAY [0..n] OF BYTE.
[[nodiscard]] inline std::optional<std::uint32_t> bits_of(std::string_view type) {
    for (const auto& [name, bits] : sized_types)
        if (type == name) return bits;
    // The length, or the last index, is between `before` and `after`.
    const auto bytes = [&](std::string_view before, std::string_view after,
                           std::uint32_t more) -> std::optional<std::uint32_t> {
        if (!type.starts_with(before) || !type.ends_with(after) || type.size() <= before.size() + after.size())
            return std::nullopt;
        const auto length =
            parse_number(type.substr(before.size(), type.size() - before.size() - after.size()), 0xFFFFFF);
        if (!length) return std::nullopt;
        return (*length + more) * 8;
    };
    if (const auto bits = bytes("STRING(", ")", 0)) return bits;
    if (const auto bits = bytes("OCTET_STRING(", ")", 0)) return bits;
    return bytes("ARRAY [0..", "] OF BYTE", 1);
}

/// Content of an Sm element, by use.
inline constexpr std::array<std::pair<ethercat::sii_sync_manager_use, std::string_view>, 4> sync_manager_uses{
    {{ethercat::sii_sync_manager_use::mailbox_out, "MBoxOut"},
     {ethercat::sii_sync_manager_use::mailbox_in, "MBoxIn"},
     {ethercat::sii_sync_manager_use::outputs, "Outputs"},
     {ethercat::sii_sync_manager_use::inputs, "Inputs"}}};

/// The use in an element Sm.
[[nodiscard]] inline std::optional<ethercat::sii_sync_manager_use> parse_sync_manager_use(std::string_view text) {
    for (const auto& [use, name] : sync_manager_uses)
        if (text == name) return use;
    return std::nullopt;
}

} // namespace jauscat::esi
