// All messages of the standard behind functions that are the same for each: filled from words, shown as lines.
#pragma once

#include <jauscat/base/result.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

struct message_kind {
    std::uint16_t command_code{};
    /// The body with the fields that `words` name, `authority_code=5`, or what is wrong with them.
    jauscat::result<std::vector<std::byte>, std::string> (*from_words)(std::span<const std::string> words){};
    /// A line for each field of a body, with offsets counted from `first_offset`.
    std::string (*to_text)(std::span<const std::byte> body, std::size_t first_offset){};
    /// The field and byte of a body that does not decode; empty where it does.
    std::string (*why_malformed)(std::span<const std::byte> body){};
};

// The classes by which the standard orders its codes, a source file each: all at once would take the compiler long.
std::vector<message_kind> command_kinds();
std::vector<message_kind> query_kinds();
std::vector<message_kind> inform_kinds();

/// That of a command code, or nullptr for a message that the standard does not have.
const message_kind* find_kind(std::uint16_t command_code);
/// Its `why_malformed`, for the log of a node.
std::string why_malformed(std::uint16_t command_code, std::span<const std::byte> body);
