#pragma once
#include <jauscat/catalogue/list.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/text/annotate.hpp>
#include <jauscat/text/from_text.hpp>
#include <jauscat/text/hex.hpp>
#include <jauscat/text/suggestion.hpp>

#include <charconv>

namespace jauscat::catalogue {

JAUSCAT_FUNCTION result<const entry*, text::error> list::find(std::string_view name) const {
    const auto unknown = [&](const std::string& message) {
        return text::error{.code = text::errc::unknown_message, .value = std::string{name}, .message = message};
    };
    std::string_view digits = name;
    if (digits.starts_with("0x") || digits.starts_with("0X")) digits.remove_prefix(2);
    if (digits.ends_with('h') || digits.ends_with('H')) digits.remove_suffix(1);
    std::uint16_t code{};
    const auto [stop, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (failed == std::errc{} && stop == digits.data() + digits.size()) {
        if (const entry* const found = find(code)) return found;
        return unknown("there is no message with the code " + text::hex_number(code, 4));
    }
    const std::string wanted = text::snake_case(name);
    std::vector<std::string_view> names;
    for (const entry& one : entries_) {
        if (one.name() == wanted) return &one;
        names.push_back(one.name());
    }
    return unknown("there is no message '" + std::string{name} + "'" + text::suggestion(wanted, names));
}

JAUSCAT_FUNCTION result<any_message, text::error> list::from_text(std::string_view line) const {
    const auto words = text::split(line);
    if (!words) return words.error();
    if (words->empty())
        return text::error{.code = text::errc::missing_name, .message = "the name of a message is missing"};
    const auto found = find(std::string_view{words->front()});
    if (!found) return found.error();
    return (*found)->from_words(std::span{*words}.subspan(1));
}

JAUSCAT_FUNCTION std::string list::why_malformed(std::uint16_t command_code, std::span<const std::byte> body) const {
    const entry* const known = find(command_code);
    if (known == nullptr) return {};
    const wire::diagnosis why = known->diagnose(body);
    return why ? std::string{} : text::to_text(why);
}

JAUSCAT_FUNCTION std::string list::annotate(std::span<const std::byte> message) const {
    jaus::header head{};
    std::string lines = text::annotate<jaus::header>(message);
    if (!wire::decode_prefix(head, message)) return lines;
    const auto body = message.subspan(jaus::header_size);
    if (body.empty() && jaus::is_acknowledgement(head)) return lines;
    const entry* const known = find(head.command_code);
    return lines + (known != nullptr ? known->annotate(body, jaus::header_size)
                                     : text::hex_dump(body, "  ", jaus::header_size));
}

} // namespace jauscat::catalogue
