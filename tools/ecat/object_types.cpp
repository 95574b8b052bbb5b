#include "ecat/object_types.hpp"

#include <jauscat/schema/ethercat/data_types.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace ecat {

namespace {

namespace codes = ethercat::data_types;
using enum value_kind;

constexpr std::array types{
    object_type{codes::boolean, "BOOLEAN", "bool", boolean, 8},
    object_type{codes::integer8, "INTEGER8", "i8", signed_number, 8},
    object_type{codes::integer16, "INTEGER16", "i16", signed_number, 16},
    object_type{codes::integer32, "INTEGER32", "i32", signed_number, 32},
    object_type{codes::integer64, "INTEGER64", "i64", signed_number, 64},
    object_type{codes::unsigned8, "UNSIGNED8", "u8", unsigned_number, 8},
    object_type{codes::unsigned16, "UNSIGNED16", "u16", unsigned_number, 16},
    object_type{codes::unsigned32, "UNSIGNED32", "u32", unsigned_number, 32},
    object_type{codes::unsigned64, "UNSIGNED64", "u64", unsigned_number, 64},
    object_type{codes::real32, "REAL32", "f32", real, 32},
    object_type{codes::real64, "REAL64", "f64", real, 64},
    object_type{codes::visible_string, "VISIBLE_STRING", "string", characters, 0},
    object_type{0x000A, "OCTET_STRING", "bytes", octets, 0},
    object_type{0x0010, "INTEGER24", "i24", signed_number, 24},
    object_type{0x0012, "INTEGER40", "i40", signed_number, 40},
    object_type{0x0013, "INTEGER48", "i48", signed_number, 48},
    object_type{0x0014, "INTEGER56", "i56", signed_number, 56},
    object_type{0x0016, "UNSIGNED24", "u24", unsigned_number, 24},
    object_type{0x0018, "UNSIGNED40", "u40", unsigned_number, 40},
    object_type{0x0019, "UNSIGNED48", "u48", unsigned_number, 48},
    object_type{0x001A, "UNSIGNED56", "u56", unsigned_number, 56},
    object_type{0x001E, "BYTE", "byte", unsigned_number, 8},
    object_type{0x001F, "WORD", "word", unsigned_number, 16},
    object_type{0x0020, "DWORD", "dword", unsigned_number, 32},
    object_type{codes::bit1, "BIT1", "bit1", unsigned_number, 8},
    object_type{codes::bit1 + 1, "BIT2", "bit2", unsigned_number, 8},
    object_type{codes::bit1 + 2, "BIT3", "bit3", unsigned_number, 8},
    object_type{codes::bit1 + 3, "BIT4", "bit4", unsigned_number, 8},
    object_type{codes::bit1 + 4, "BIT5", "bit5", unsigned_number, 8},
    object_type{codes::bit1 + 5, "BIT6", "bit6", unsigned_number, 8},
    object_type{codes::bit1 + 6, "BIT7", "bit7", unsigned_number, 8},
    object_type{codes::bit1 + 7, "BIT8", "bit8", unsigned_number, 8},
};

std::uint64_t unsigned_of(const bytes& data) {
    std::uint64_t made = 0;
    for (std::size_t i = std::min<std::size_t>(data.size(), 8); i-- != 0;)
        made = made << 8 | std::to_integer<std::uint64_t>(data[i]);
    return made;
}
std::int64_t signed_of(const bytes& data) {
    const auto shift = 64 - 8 * std::min<std::size_t>(data.size(), 8);
    return data.empty() ? 0 : static_cast<std::int64_t>(unsigned_of(data) << shift) >> shift;
}
double real_of(const bytes& data) {
    return data.size() == 4 ? double{std::bit_cast<float>(static_cast<std::uint32_t>(unsigned_of(data)))}
                            : std::bit_cast<double>(unsigned_of(data));
}
bytes bytes_of(std::uint64_t number, unsigned bits) {
    bytes made;
    for (unsigned i = 0; i < bits; i += 8) made.push_back(static_cast<std::byte>(number >> i & 0xFF));
    return made;
}

[[noreturn]] void refuse(const object_type& type, const std::string& text, const std::string& expected) {
    throw usage_error{"'" + text + "' is no value of type " + std::string{type.name} + ": expected " + expected};
}

/// Bits of the value itself.
unsigned width(const object_type& type) {
    if (type.code >= codes::bit1 && type.code < codes::bit1 + 8) return type.code - codes::bit1 + 1u;
    return type.bits;
}

} // namespace

const object_type* type_of(std::uint16_t code) {
    const auto* const found = std::ranges::find(types, code, &object_type::code);
    return found == types.end() ? nullptr : found;
}

const object_type& type_named(std::string_view name) {
    const auto* found = std::ranges::find(types, name, &object_type::word);
    if (found == types.end()) found = std::ranges::find(types, name, &object_type::name);
    if (found != types.end()) return *found;
    throw usage_error{"--type '" + std::string{name} +
                      "' is unknown: expected bool, i8 to i64, u8 to u64, f32, f64, string or bytes"};
}

const object_type& guessed_type(std::size_t bits) {
    switch (bits) {
    case 8: return type_named("u8");
    case 16: return type_named("u16");
    case 32: return type_named("u32");
    case 64: return type_named("u64");
    default: return type_named("bytes");
    }
}

std::string type_text(std::uint16_t code) {
    const auto* const found = type_of(code);
    return found != nullptr ? std::string{found->name} : hex(code, 4);
}

value to_value(const object_type& type, const bytes& data) {
    const bool fits = type.bits == 0 || data.size() * 8 == type.bits;
    const auto kind = fits ? type.kind : octets;
    switch (kind) {
    case boolean: return unsigned_of(data) != 0;
    case signed_number: return signed_of(data);
    case unsigned_number: {
        const auto number = unsigned_of(data);
        return {number, std::to_string(number) + " (" + hex(number, static_cast<int>(type.bits / 4)) + ")"};
    }
    case real: {
        const auto number = real_of(data);
        if (std::isfinite(number)) return number;
        return std::to_string(number); // JSON has no such number
    }
    case characters: {
        std::string made;
        for (const auto each : data) made += static_cast<char>(each);
        return printable(made);
    }
    case octets: return hex_bytes(data);
    }
    return {};
}

std::optional<std::uint64_t> parse_number(std::string_view text, std::uint64_t most) {
    const bool is_hex = text.starts_with("0x") || text.starts_with("0X");
    if (is_hex) text.remove_prefix(2);
    std::uint64_t made{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), made, is_hex ? 16 : 10);
    if (error != std::errc{} || end != text.data() + text.size() || made > most) return {};
    return made;
}

bytes to_bytes(const object_type& type, const std::string& text) {
    const auto bits = width(type);
    switch (type.kind) {
    case boolean:
        if (text == "true" || text == "1") return bytes_of(1, 8);
        if (text == "false" || text == "0") return bytes_of(0, 8);
        refuse(type, text, "true or false");
    case unsigned_number: {
        const auto most = bits == 64 ? ~std::uint64_t{} : (std::uint64_t{1} << bits) - 1;
        const auto number = parse_number(text, most);
        if (!number) refuse(type, text, "0 to " + std::to_string(most));
        return bytes_of(*number, type.bits);
    }
    case signed_number: {
        const bool is_negative = text.starts_with('-');
        const auto most = (std::uint64_t{1} << (bits - 1)) - 1;
        const auto number =
            parse_number(std::string_view{text}.substr(is_negative ? 1 : 0), is_negative ? most + 1 : most);
        if (!number) refuse(type, text, "-" + std::to_string(most + 1) + " to " + std::to_string(most));
        return bytes_of(is_negative ? ~*number + 1 : *number, type.bits);
    }
    case real: {
        char* end = nullptr;
        const double number = std::strtod(text.c_str(), &end);
        const bool is_float = type.bits == 32;
        if (text.empty() || *end != '\0' ||
            (is_float && std::isfinite(number) && !std::isfinite(static_cast<float>(number))))
            refuse(type, text, "a number such as 1.5");
        return is_float ? bytes_of(std::bit_cast<std::uint32_t>(static_cast<float>(number)), 32)
                        : bytes_of(std::bit_cast<std::uint64_t>(number), 64);
    }
    case characters: {
        bytes made;
        for (const char c : text) made.push_back(static_cast<std::byte>(c));
        return made;
    }
    case octets: break;
    }
    bytes made;
    for (std::size_t i = 0; i < text.size(); i += 2) {
        const auto digits = std::string_view{text}.substr(i, 2);
        unsigned octet{};
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), octet, 16);
        if (digits.size() != 2 || error != std::errc{} || end != digits.data() + 2)
            refuse(type, text, "hexadecimal digits, two for each byte, such as 00ff1a");
        made.push_back(static_cast<std::byte>(octet));
    }
    return made;
}

void check_limits(const object_type& type, const bytes& data, const bytes& minimum, const bytes& maximum) {
    const auto is_below = [&](const bytes& a, const bytes& b) {
        switch (type.kind) {
        case signed_number: return signed_of(a) < signed_of(b);
        case unsigned_number: return unsigned_of(a) < unsigned_of(b);
        case real: return real_of(a) < real_of(b);
        default: return false;
        }
    };
    const auto is_limit = [&](const bytes& limit) { return !limit.empty() && limit.size() == data.size(); };
    // Some slaves send zeros for limits that they do not have.
    const bool are_equal = is_limit(minimum) && minimum == maximum;
    if (are_equal) return;
    if (is_limit(minimum) && is_below(data, minimum))
        throw usage_error{"the value is below the minimum of the object, " + to_value(type, minimum).text()};
    if (is_limit(maximum) && is_below(maximum, data))
        throw usage_error{"the value is above the maximum of the object, " + to_value(type, maximum).text()};
}

object_range parse_range(const std::string& text) {
    const auto fail = [&]() -> usage_error {
        return usage_error{"'" + text +
                           "' is no object: expected INDEX, INDEX:SUB or INDEX:SUB-SUB, such as 0x1018:0-4"};
    };
    const auto colon = text.find(':');
    const auto index = parse_number(std::string_view{text}.substr(0, colon), 0xFFFF);
    if (!index) throw fail();
    object_range made{.index = static_cast<std::uint16_t>(*index)};
    if (colon == text.npos) return made;
    const auto rest = std::string_view{text}.substr(colon + 1);
    const auto dash = rest.find('-');
    const auto first = parse_number(rest.substr(0, dash), 0xFF);
    const auto last = dash == rest.npos ? first : parse_number(rest.substr(dash + 1), 0xFF);
    if (!first || !last || *last < *first) throw fail();
    made.first = static_cast<std::uint8_t>(*first);
    made.last = static_cast<std::uint8_t>(*last);
    return made;
}

std::string place_text(std::uint16_t index, std::uint8_t subindex) {
    return hex(index, 4) + ":" + hex(subindex, 2).substr(2);
}

} // namespace ecat
