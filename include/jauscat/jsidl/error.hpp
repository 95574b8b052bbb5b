// Errors of JSIDL files and service definitions: a code to branch on, the element concerned, and a line for the
// operator.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace jauscat::jsidl {

enum class errc : std::uint8_t {
    ok,
    unreadable,        ///< the file cannot be read or written
    not_xml,           ///< not well-formed XML
    not_jsidl,         ///< the root element or its namespace is another one
    missing,           ///< an element or attribute that is required
    unexpected,        ///< an element that has no place there, or one too many
    invalid_value,     ///< a value of another form, or out of range
    duplicate,         ///< a file, definition or name that is there twice
    unknown_reference, ///< a type set, type or constant that no file defines
    cycle,             ///< services, types or constants that refer to themselves
    inconsistent,      ///< parts of a definition that do not agree, or two definitions of one message
    unsupported,       ///< a valid definition that has no equivalent in a schema
};

/// The error in one line. `describe(const error&)` says more.
[[nodiscard]] constexpr std::string_view describe(errc code) noexcept {
    switch (code) {
    case errc::ok: return "ok";
    case errc::unreadable: return "the file cannot be read or written";
    case errc::not_xml: return "not well-formed XML";
    case errc::not_jsidl: return "not a JSIDL document";
    case errc::missing: return "an element or attribute is missing";
    case errc::unexpected: return "an element has no place there";
    case errc::invalid_value: return "a value is of another form, or out of range";
    case errc::duplicate: return "a definition is there twice";
    case errc::unknown_reference: return "no file defines a type or constant that is referred to";
    case errc::cycle: return "definitions refer to themselves";
    case errc::inconsistent: return "definitions do not agree";
    case errc::unsupported: return "a schema cannot express the definition";
    }
    return "unknown error";
}

/// Why service definitions cannot be used.
struct error {
    errc code{};
    std::string element{}; ///< its name, without brackets; empty for a whole file
    std::size_t line{};    ///< of the file, from 1; 0 for a file that cannot be read
    std::string message{}; ///< `file:line: <element>: problem and expectation`

    friend bool operator==(const error&, const error&) = default;
};

/// What is wrong, and where.
[[nodiscard]] inline std::string_view describe(const error& why) noexcept { return why.message; }

/// The error as an exception. `what()` is its message.
class jsidl_error : public std::runtime_error {
  public:
    explicit jsidl_error(jsidl::error why) : std::runtime_error{why.message}, error_{std::move(why)} {}

    [[nodiscard]] const jsidl::error& error() const noexcept { return error_; }
    [[nodiscard]] errc code() const noexcept { return error_.code; }

  private:
    jsidl::error error_;
};

} // namespace jauscat::jsidl
