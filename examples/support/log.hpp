// Lines of a log: as text, or as JSON objects.
#pragma once
#include "support/event.hpp"
#include "support/log_format.hpp"

#include <cstdint>
#include <string>

namespace example {

/// What to write for an event. `text`: lines for an operator, each with its end; with log_format::text this is all.
/// `left_out`: events of the same cause that were not written before this one.
std::string log_lines(event_kind kind, const event_members& members, const std::string& text,
                      std::uint64_t left_out = 0);

} // namespace example
