#include "message_kinds.hpp"

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

std::string why_malformed(std::uint16_t command_code, std::span<const std::byte> body) {
    const auto* const kind = find_kind(command_code);
    return kind != nullptr ? kind->why_malformed(body) : std::string{};
}
