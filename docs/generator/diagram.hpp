// A message's bytes and bits as a picture.
#pragma once
#include "part.hpp"

namespace jauscat::reference {

/// An SVG document; readable on light and dark pages.
std::string diagram(const std::vector<part>& parts, std::string_view title);

} // namespace jauscat::reference
