// A number in a line of text.
#pragma once
#include <jauscat/base/compilation.hpp>

#include <cstdio>
#include <string>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

/// A number with its text around it.
template <class Code> std::string numbered(const char* format, Code code) {
    char text[48]{};
    std::snprintf(text, sizeof text, format, static_cast<unsigned>(code));
    return text;
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
