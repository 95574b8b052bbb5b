// What may continue a line that is being typed.
#pragma once
#include <string>
#include <string_view>
#include <vector>

/// The words that begin as the last word of `line` does: commands, `destinations` behind `send`, messages, fields that
/// the line does not have yet, and values that have names. A complete word has a space at its end.
std::vector<std::string> completions(std::string_view line, const std::vector<std::string>& destinations);
