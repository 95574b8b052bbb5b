// From the run-time description of a message to what the reference tells about it.
#pragma once
#include "part.hpp"
#include <jauscat/catalogue/entry.hpp>

namespace jauscat::reference {

/// A number for people, with so many digits, or with pi where it is a multiple of it.
std::string number(double value, int digits = 9);

message described(const catalogue::entry& entry);

} // namespace jauscat::reference
