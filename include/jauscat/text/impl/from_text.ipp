// Fills any structure from text.
#pragma once
#include <jauscat/schema/jaus/catalog.hpp>
#include <jauscat/text/filler.hpp>
#include <jauscat/text/from_text.hpp>
#include <jauscat/text/hex.hpp>
#include <jauscat/text/suggestion.hpp>

#include <algorithm>
#include <charconv>
#include <system_error>
#include <vector>

namespace jauscat::text {
inline namespace JAUSCAT_WAY {

JAUSCAT_DECL result<void, error> from_input(const input& in, const structure& type, void* object, wire::arena& memory) {
    return detail::filler{memory}.fill(type, object, in);
}

JAUSCAT_DECL result<void, error> from_words(std::span<const std::string> words, const structure& type, void* object,
                                            wire::arena& memory) {
    input tree{.what = input::kind::object};
    for (const std::string& word : words)
        if (auto assigned = assign(word, tree); !assigned) return assigned;
    return from_input(tree, type, object, memory);
}

JAUSCAT_DECL std::string snake_case(std::string_view standard_name) {
    std::string made;
    for (const char c : standard_name) {
        const bool upper = c >= 'A' && c <= 'Z';
        const bool kept = upper || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        if (kept)
            made += upper ? static_cast<char>(c - 'A' + 'a') : c;
        else if (!made.empty() && made.back() != '_')
            made += '_';
    }
    while (made.ends_with('_')) made.pop_back();
    return made;
}

JAUSCAT_DECL std::optional<std::uint16_t> command_code_from(std::string_view digits) {
    if (digits.starts_with("0x") || digits.starts_with("0X")) digits.remove_prefix(2);
    if (digits.ends_with('h') || digits.ends_with('H')) digits.remove_suffix(1);
    std::uint16_t code{};
    const auto [stop, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    return failed == std::errc{} && stop == digits.data() + digits.size() ? std::optional{code} : std::nullopt;
}

JAUSCAT_DECL result<std::uint16_t, error> find_message(std::string_view name, std::span<const named_message> among) {
    const auto unknown = [&](const std::string& message) {
        return error{.code = errc::unknown_message, .value = std::string{name}, .message = message};
    };
    if (const auto code = command_code_from(name)) {
        if (std::ranges::find(among, *code, &named_message::command_code) != among.end()) return *code;
        return unknown("there is no message with the code " + hex_number(*code, 4));
    }
    const std::string wanted = snake_case(name);
    std::vector<std::string_view> names;
    for (const named_message& message : among) {
        if (message.name == wanted) return message.command_code;
        names.push_back(message.name);
    }
    return unknown("there is no message '" + std::string{name} + "'" + suggestion(wanted, names));
}

JAUSCAT_DECL result<std::uint16_t, error> find_message(std::string_view name) {
    std::vector<named_message> all;
    for (const jaus::catalog_entry& entry : jaus::catalog) all.push_back({entry.command_code, snake_case(entry.name)});
    return find_message(name, all);
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::text
