// The messages of RA 3.3, compiled once: link jauscat::catalogue.
#pragma once
#include <jauscat/catalogue/list.hpp>

namespace jauscat::catalogue {

/// All messages of RA 3.3 and the experimental 0404h.
[[nodiscard]] const list& ra_3_3();

} // namespace jauscat::catalogue
