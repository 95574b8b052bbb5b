// The reference's pages, in GitHub's Markdown.
#pragma once
#include "part.hpp"
#include "remarks.hpp"

namespace jauscat::reference {

/// The numbers of the seed table, for every message the same.
struct translation {
    unsigned index_base{};      ///< object index of component 0
    std::size_t packet{};       ///< bytes of a packet without body
    std::size_t largest_body{}; ///< that one packet carries
};

inline constexpr std::string_view made_by =
    "<!-- Generated from the schemas by scripts/message-reference: do not edit. -->\n\n";

/// `0405h`.
std::string code_text(std::uint16_t code);

/// `4 to 12 bytes`.
std::string body_size(const message& one);
/// A row for each field, and below it what names and types stand for.
std::string field_table(const message& one, const remarks& from);

/// The page of a subgroup, named by its header. Throws std::runtime_error where a comment is missing.
std::string page(const std::string& header, const std::vector<message>& messages, const remarks& from,
                 const translation& table);
/// README.md: how to read the pages, and every message.
std::string index_page(const std::vector<message>& messages, const remarks& from, const translation& table);

} // namespace jauscat::reference
