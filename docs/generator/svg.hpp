// Pieces of pictures.
#pragma once
#include <string>

namespace jauscat::reference {

/// ` width="880"`.
inline std::string attribute(const char* name, int value) {
    return " " + std::string{name} + "=\"" + std::to_string(value) + "\"";
}
/// Text of a class of the style sheet; `content` is SVG.
inline std::string text_element(const std::string& style, int x, int y, const std::string& content) {
    return "<text class=\"" + style + "\"" + attribute("x", x) + attribute("y", y) + ">" + content + "</text>\n";
}

} // namespace jauscat::reference
