// Quotes a text for messages.
#pragma once

#include <string>
#include <string_view>

namespace jauscat::net::detail {

inline std::string quoted(std::string_view text) { return '"' + std::string{text} + '"'; }

} // namespace jauscat::net::detail
