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

/// `0405h`.
std::string code_text(std::uint16_t code);
/// File name of a message's diagram, in the pages' folder; empty for a message without a body.
std::string diagram_file(const message& one);

/// The page of a subgroup, named by its header. Throws std::runtime_error where a comment is missing.
std::string page(const std::string& header, const std::vector<message>& messages, const remarks& from,
                 const translation& table);
/// README.md: how to read the pages, and every message.
std::string index_page(const std::vector<message>& messages, const remarks& from, const translation& table);

} // namespace jauscat::reference
