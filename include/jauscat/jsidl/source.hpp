// A text with its file's name, for errors with file and line.
#pragma once

#include <jauscat/base/result.hpp>
#include <jauscat/jsidl/error.hpp>

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>

namespace jauscat::jsidl::detail {

/// What `read()` returns, or the error of the `jsidl_error` that it throws.
template <class Read> result<std::invoke_result_t<Read>, error> caught(Read&& read) {
    try {
        return read();
    } catch (const jsidl_error& thrown) {
        return thrown.error();
    }
}

/// The file's text. Throws `jsidl_error`.
inline std::string text_of(const std::filesystem::path& path) {
    std::ifstream file{path, std::ios::binary};
    file.peek(); // a directory can be opened, and fails here
    if (!file && !file.eof())
        throw jsidl_error{{.code = errc::unreadable,
                           .message = path.string() + ": cannot be read: " + std::generic_category().message(errno)}};
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Throws `file:line: <element>: what`.
[[noreturn]] inline void fail(errc code, std::string_view source, std::size_t line, std::string_view element,
                              const std::string& what) {
    const std::string name{element};
    throw jsidl_error{{.code = code,
                       .element = name,
                       .line = line,
                       .message = std::string{source} + ':' + std::to_string(line) +
                                  (name.empty() ? ": " : ": <" + name + ">: ") + what}};
}

} // namespace jauscat::jsidl::detail
