// Wordings that diagrams and tables share.
#pragma once
#include "part.hpp"

namespace jauscat::reference {

/// `0405`.
std::string code_digits(std::uint16_t code);
/// For HTML and SVG.
std::string escaped(std::string_view text);
/// With a capital letter first.
std::string capitalised(std::string text);
/// Characters of UTF-8 text.
std::size_t characters_of(std::string_view text);
/// `1 byte`, `2 bytes`.
std::string counted(std::size_t count, std::string_view what);
/// `2`, `1 to 5`, `3 or more`.
std::string amount(std::size_t least, std::size_t most);
/// The bytes that a part takes: `0`, `2–3`, `+4` after a prefix; empty where they lie elsewhere from message to
/// message.
std::string span_of(std::string_view prefix, std::optional<std::size_t> at, const part& one);
/// The bits of a bit-field: `bit 6`, `bits 0–3`.
std::string bits_of(const part& field);
/// Steps over a part; where it does not always have the same size, nobody knows what lies behind it.
void advance(std::optional<std::size_t>& at, const part& one);
/// What announces a part: `bit 3`, `if object_buffer_present`; empty for one that is always there.
std::string condition_of(const part& one);
/// `1, 4–6`.
std::string numbers_of(const enumeration& tags);

} // namespace jauscat::reference
