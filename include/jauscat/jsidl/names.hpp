// Identifiers for the names in service definitions.
#pragma once

#include <jauscat/base/compilation.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat::jsidl {

struct named_value;

inline namespace JAUSCAT_WAY {

/// The name in snake_case: `GPSFixTimeSeconds` is gps_fix_time_seconds, `Periodic (SC)` periodic_sc. Characters that no
/// identifier has separate words. Empty if no letter or digit is left; may begin with a digit or be a keyword.
[[nodiscard]] JAUSCAT_DECL std::string snake_case(std::string_view name);

/// The name as an identifier. A name that begins with a digit has `prefix` before it, a keyword `_` and `prefix` behind
/// it: with the prefix "value", `128x96 (sqcif)` is value_128x96_sqcif and `False` false_value. With the prefix "field"
/// a keyword has `_` alone, which text output drops. Empty without letters and digits.
[[nodiscard]] JAUSCAT_DECL std::string identifier(std::string_view name, std::string_view prefix);

/// The enumerators of a value set, in its order. Names that several values have end with their value: reserved_0,
/// reserved_5. A value whose name has no letters and digits is value_ and its number.
[[nodiscard]] JAUSCAT_DECL std::vector<std::string> enumerators(const std::vector<named_value>& values);

} // namespace JAUSCAT_WAY
} // namespace jauscat::jsidl

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jsidl/impl/names.ipp>
#endif
