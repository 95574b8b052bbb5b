// All messages of the standard behind functions that are the same for each: filled from words, shown as lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

struct message_kind {
    std::uint16_t command_code{};
    /// The body with the fields that `words` name, `authority_code=5`; else what is wrong.
    std::string (*from_words)(std::span<const std::string> words, std::vector<std::byte>& body){};
    /// A line for each field of a body.
    std::string (*to_text)(std::span<const std::byte> body){};
};

// The classes by which the standard orders its codes, a source file each: all at once would take the compiler long.
std::vector<message_kind> command_kinds();
std::vector<message_kind> query_kinds();
std::vector<message_kind> inform_kinds();
