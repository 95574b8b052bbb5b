#include "message_kinds.hpp"

#include <jauscat/text/annotate.hpp>
#include <jauscat/text/from_text.hpp>

#include <algorithm>

const message_kind* find_kind(std::uint16_t command_code) {
    static const auto all = [] {
        std::vector<message_kind> kinds;
        for (const auto& some : {command_kinds(), query_kinds(), inform_kinds()})
            kinds.insert(kinds.end(), some.begin(), some.end());
        return kinds;
    }();
    const auto found = std::ranges::find(all, command_code, &message_kind::command_code);
    return found == all.end() ? nullptr : &*found;
}

jauscat::result<std::vector<std::byte>, std::string> body_from_words(const message_kind& kind,
                                                                     std::span<const std::string> words) {
    std::vector<std::byte> lists(std::size_t{1} << 16U);
    jauscat::wire::arena memory{lists};
    const auto message = kind.make();
    if (const auto filled = jauscat::text::from_words(words, *kind.fields, message.get(), memory); !filled)
        return filled.error().message;
    auto body = kind.encode(message.get());
    if (!body) return std::string{jauscat::wire::describe(body.error())};
    return *std::move(body);
}

std::string why_malformed(std::uint16_t command_code, std::span<const std::byte> body) {
    const auto* const kind = find_kind(command_code);
    if (kind == nullptr) return {};
    const auto why = kind->diagnose(body);
    return why.error == jauscat::wire::errc::ok ? std::string{} : jauscat::text::to_text(why);
}
