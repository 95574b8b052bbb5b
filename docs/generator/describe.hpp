// From the run-time description of a message to what the reference tells about it.
#pragma once
#include "part.hpp"
#include <jauscat/catalogue/entry.hpp>

namespace jauscat::reference {

/// A number for people, with so many digits, or with pi where it is a multiple of it.
std::string number(double value, int digits = 9);

/// A message of RA 3.3.
message described(const catalogue::entry& entry);
/// A message of SAE JAUS, with its message ID as the first part.
message described_sae(const catalogue::entry& entry, std::string name, std::string_view diagram_prefix);

} // namespace jauscat::reference
