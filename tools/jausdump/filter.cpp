#include "filter.hpp"

#include <jauscat/catalogue/sae.hpp>
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
    const auto code = message.code();
    const bool is_wanted = none_or_any(codes, [&](std::uint16_t wanted) { return code == wanted; }) &&
                           (names.empty() || (code && none_or_any(names, [&](const std::string& part) {
                                                  return contains(snake_case(message.name), part);
                                              })));
    const auto is_between = [&](const auto& head) {
        return none_or_any(from, [&](const address_pattern& pattern) { return pattern.matches(head.source); }) &&
               none_or_any(to, [&](const address_pattern& pattern) { return pattern.matches(head.destination); });
    };
    if (message.head) return is_wanted && is_between(*message.head);
    if (message.sae && message.sae->header) return is_wanted && is_between(*message.sae->header);
    return is_wanted && from.empty() && to.empty();
}

std::string snake_case(std::string_view standard_name) {
    const auto is_upper = [&](std::size_t i) {
        return i < standard_name.size() && std::isupper(static_cast<unsigned char>(standard_name[i])) != 0;
    };
    const auto is_lower = [&](std::size_t i) {
        return i < standard_name.size() && std::islower(static_cast<unsigned char>(standard_name[i])) != 0;
    };
    std::string name;
    for (std::size_t i = 0; i != standard_name.size(); ++i) {
        const auto c = static_cast<unsigned char>(standard_name[i]);
        // A word begins: "rC" of RequestControl, "SF" of GPSFix.
        if (i != 0 && is_upper(i) && (is_lower(i - 1) || (is_upper(i - 1) && is_lower(i + 1)))) name += '_';
        name += std::isalnum(c) != 0 ? static_cast<char>(std::tolower(c)) : '_';
    }
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
    const auto sae_has_it = [&](const jauscat::catalogue::entry& entry) {
        return contains(std::string{entry.name()}, name);
    };
    if (name != "unknown" && std::ranges::none_of(jaus::catalog, has_it) &&
        std::ranges::none_of(jauscat::catalogue::sae(), sae_has_it))
        throw std::invalid_argument{"no message has '" + text + "' in its name"};
    return name;
}

address_pattern parse_pattern(const std::string& text) {
    address_pattern pattern;
    const auto wrong = [&] {
        return std::invalid_argument{
            "'" + text +
            "' is no JAUS ID: write subsystem.node.component.instance, each 1 to 255 or * (the "
            "subsystem of SAE JAUS, which has no instance, 1 to 65535), and leave off what "
            "does not matter at the end"};
    };
    std::string_view rest{text};
    for (std::size_t i = 0;; ++i) {
        const auto part = rest.substr(0, rest.find('.'));
        if (i == pattern.part.size()) throw wrong();
        if (part != "*") {
            std::uint16_t number{};
            const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
            if (part.empty() || error != std::errc{} || end != part.data() + part.size() || number == 0) throw wrong();
            if (i != 0 && number > 255) throw wrong();
            pattern.part[i] = number;
        }
        if (part.size() == rest.size()) return pattern;
        rest.remove_prefix(part.size() + 1);
    }
}

} // namespace jausdump
