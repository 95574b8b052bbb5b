// Identifiers for the names in service definitions.
#pragma once
#include <jauscat/jsidl/names.hpp>
#include <jauscat/jsidl/service.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace jauscat::jsidl {

namespace detail {

inline constexpr std::array keywords = std::to_array<std::string_view>(
    {"alignas",     "alignof",  "and",        "and_eq",    "asm",       "auto",         "bitand",
     "bitor",       "bool",     "break",      "case",      "catch",     "char",         "char16_t",
     "char32_t",    "char8_t",  "class",      "co_await",  "co_return", "co_yield",     "compl",
     "concept",     "const",    "const_cast", "consteval", "constexpr", "constinit",    "continue",
     "decltype",    "default",  "delete",     "do",        "double",    "dynamic_cast", "else",
     "enum",        "explicit", "export",     "extern",    "false",     "float",        "for",
     "friend",      "goto",     "if",         "inline",    "int",       "long",         "mutable",
     "namespace",   "new",      "noexcept",   "not",       "not_eq",    "nullptr",      "operator",
     "or",          "or_eq",    "private",    "protected", "public",    "register",     "reinterpret_cast",
     "requires",    "return",   "short",      "signed",    "sizeof",    "static",       "static_assert",
     "static_cast", "struct",   "switch",     "template",  "this",      "thread_local", "throw",
     "true",        "try",      "typedef",    "typeid",    "typename",  "union",        "unsigned",
     "using",       "virtual",  "void",       "volatile",  "wchar_t",   "while",        "xor",
     "xor_eq"});

// Of the character set that JSIDL files have for names, whatever the locale.
[[nodiscard]] constexpr bool is_upper(char c) noexcept { return c >= 'A' && c <= 'Z'; }
[[nodiscard]] constexpr bool is_lower(char c) noexcept { return c >= 'a' && c <= 'z'; }
[[nodiscard]] constexpr bool is_number(char c) noexcept { return c >= '0' && c <= '9'; }
[[nodiscard]] constexpr char as_lower(char c) noexcept { return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c; }

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL std::string snake_case(std::string_view name) {
    using namespace detail;
    std::string made;
    bool gap = false;
    for (std::size_t i = 0; i != name.size(); ++i) {
        const char c = name[i];
        if (!is_upper(c) && !is_lower(c) && !is_number(c)) {
            gap = !made.empty();
            continue;
        }
        // A word begins at a capital behind a small letter, and at one before a small letter: the F of GPSFix, but not
        // the D of 2D.
        const char last = i == 0 ? ' ' : name[i - 1], next = i + 1 == name.size() ? ' ' : name[i + 1];
        if (is_upper(c) && (is_lower(last) || ((is_number(last) || is_upper(last)) && is_lower(next))))
            gap = !made.empty();
        if (gap) made += '_';
        gap = false;
        made += as_lower(c);
    }
    return made;
}

JAUSCAT_DECL std::string identifier(std::string_view name, std::string_view prefix) {
    auto made = snake_case(name);
    if (made.empty()) return made;
    if (detail::is_number(made.front())) return std::string{prefix} + '_' + made;
    if (std::ranges::find(detail::keywords, made) != detail::keywords.end())
        return made + '_' + std::string{prefix == "field" ? "" : prefix};
    return made;
}

JAUSCAT_DECL std::vector<std::string> enumerators(const std::vector<named_value>& values) {
    std::vector<std::string> made;
    for (const auto& each : values) {
        auto name = identifier(each.name, "value");
        made.push_back(name.empty() ? "value" : std::move(name));
    }
    const auto plain = made;
    for (std::size_t i = 0; i != made.size(); ++i)
        if (plain[i] == "value" || std::ranges::count(plain, plain[i]) != 1)
            made[i] += '_' + std::string{values[i].value < 0 ? "minus_" : ""} +
                       std::to_string(values[i].value < 0 ? -values[i].value : values[i].value);
    return made;
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::jsidl
