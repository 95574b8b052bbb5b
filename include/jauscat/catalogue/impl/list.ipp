#pragma once
#include <jauscat/catalogue/list.hpp>
#include <jauscat/text/from_text.hpp>
#include <jauscat/text/jaus.hpp>

namespace jauscat::catalogue {

JAUSCAT_FUNCTION result<const entry*, text::error> list::find(std::string_view name) const {
    std::vector<text::named_message> names;
    for (const entry& one : entries_) names.push_back({one.command_code(), std::string{one.name()}});
    const auto code = text::find_message(name, names);
    if (!code) return code.error();
    return find(*code);
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
    return text::annotate_message(message, [this](std::uint16_t command_code, std::span<const std::byte> body) {
        const entry* const known = find(command_code);
        return known != nullptr ? known->annotate(body, jaus::header_size) : std::string{};
    });
}

} // namespace jauscat::catalogue
