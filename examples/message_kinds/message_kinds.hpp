// All messages of the standard, handled alike by their command codes.
#pragma once
#include <jauscat/base/result.hpp>
#include <jauscat/text/structure.hpp>
#include <jauscat/wire/diagnosis.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

/// A message of the standard without its type. `value` points to an object of the type.
struct message_kind {
    using object = std::unique_ptr<void, void (*)(void*)>;

    std::uint16_t command_code{};
    const jauscat::text::structure* fields{};
    /// A value-initialised object.
    object (*make)(){};
    /// The number of bytes, or the error, of `wire::decode`.
    jauscat::result<std::size_t, jauscat::wire::errc> (*decode)(void* value, std::span<const std::byte> body,
                                                                jauscat::wire::arena& memory){};
    /// The body, or the error, of `wire::encode`.
    jauscat::result<std::vector<std::byte>, jauscat::wire::errc> (*encode)(const void* value){};
    /// Explains the error of decoding the body.
    jauscat::wire::diagnosis (*diagnose)(std::span<const std::byte> body){};
    /// A line for each field of a body, with offsets counted from `first_offset`.
    std::string (*annotate)(std::span<const std::byte> body, std::size_t first_offset){};
};

// The classes by which the standard orders its codes, a source file each: all at once would take the compiler long.
std::vector<message_kind> command_kinds();
std::vector<message_kind> query_kinds();
std::vector<message_kind> inform_kinds();

/// That of a command code, or nullptr for a message that the standard does not have.
const message_kind* find_kind(std::uint16_t command_code);
/// The body with the fields that `words` name, `authority_code=5`, or what is wrong with them.
jauscat::result<std::vector<std::byte>, std::string> body_from_words(const message_kind& kind,
                                                                     std::span<const std::string> words);
/// The field and byte of a body that does not decode, for the log of a node; empty where it does.
std::string why_malformed(std::uint16_t command_code, std::span<const std::byte> body);
