// The messages that a program knows by name: those of RA 3.3, and the private ones that are compiled in.
#pragma once
#include <jauscat/catalogue/list.hpp>
#include <jauscat/schema/jaus/header.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace example {

/// With the `private_messages` of the header that the CMake option JAUSCAT_PRIVATE_MESSAGES names.
const jauscat::catalogue::list& known_messages();

/// `Set Wrench Effort`, by the standard or by the name of its type; else `command code 0xD1FF`.
std::string message_name(std::uint16_t command_code);
/// text::summary with that name.
std::string summary(const jauscat::jaus::header& head);
/// A line for each field of the body, in hex where its message is not known. Offsets are counted from `first_offset`.
std::string body_lines(std::uint16_t command_code, std::span<const std::byte> body, std::size_t first_offset);

/// A message as a user writes it.
struct written_message {
    std::uint16_t command_code{};
    std::vector<std::byte> body{};
};
/// `name`: of a known message, or a command code in hex. `words`: FIELD=VALUE, or hex=DIGITS for a body byte for byte,
/// which a message that is not known needs.
jauscat::result<written_message, jauscat::text::error> read_message(std::string_view name,
                                                                    std::span<const std::string> words);

} // namespace example
