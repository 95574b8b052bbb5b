#include "filter.hpp"

#include <jauscat/schema/jaus/catalog.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace jausdump {

namespace {

template <class Range> bool none_or_any(const Range& conditions, auto&& met) {
    return conditions.empty() || std::ranges::any_of(conditions, met);
}

bool contains(const std::string& name, const std::string& part) { return name.find(part) != std::string::npos; }

} // namespace

bool filter::passes(const record& message) const {
    if (!message.head) return codes.empty() && names.empty() && from.empty() && to.empty();
    const auto& head = *message.head;
    return none_or_any(codes, [&](std::uint16_t code) { return code == head.command_code; }) &&
           none_or_any(names, [&](const std::string& part) { return contains(snake_case(message.name), part); }) &&
           none_or_any(from, [&](const address_pattern& pattern) { return pattern.matches(head.source); }) &&
           none_or_any(to, [&](const address_pattern& pattern) { return pattern.matches(head.destination); });
}

std::string snake_case(std::string_view standard_name) {
    std::string name;
    for (const char c : standard_name)
        name += std::isalnum(static_cast<unsigned char>(c)) != 0
                    ? static_cast<char>(std::tolower(static_cast<unsigned char>(c)))
                    : '_';
    return name;
}

std::uint16_t parse_code(const std::string& text) {
    std::string_view digits{text};
    if (digits.starts_with("0x") || digits.starts_with("0X")) digits.remove_prefix(2);
    if (digits.ends_with('h')) digits.remove_suffix(1);
    std::uint16_t code{};
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (digits.empty() || error != std::errc{} || end != digits.data() + digits.size())
        throw std::invalid_argument{"'" + text + "' is no command code: four hex digits, such as 0x0405 or 0405h"};
    return code;
}

std::string parse_name(const std::string& text) {
    auto name = snake_case(text);
    const auto has_it = [&](const jaus::catalog_entry& entry) { return contains(snake_case(entry.name), name); };
    if (name != "unknown" && std::ranges::none_of(jaus::catalog, has_it))
        throw std::invalid_argument{"no message has '" + text + "' in its name"};
    return name;
}

address_pattern parse_pattern(const std::string& text) {
    address_pattern pattern;
    const auto wrong = [&] {
        return std::invalid_argument{"'" + text +
                                     "' is no JAUS ID: write subsystem.node.component.instance, each 1 to 255 or *, "
                                     "and leave off what does not matter at the end"};
    };
    std::string_view rest{text};
    for (std::size_t i = 0;; ++i) {
        const auto part = rest.substr(0, rest.find('.'));
        if (i == pattern.octet.size()) throw wrong();
        if (part != "*") {
            std::uint8_t octet{};
            const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), octet);
            if (part.empty() || error != std::errc{} || end != part.data() + part.size() || octet == 0) throw wrong();
            pattern.octet[i] = octet;
        }
        if (part.size() == rest.size()) return pattern;
        rest.remove_prefix(part.size() + 1);
    }
}

} // namespace jausdump
