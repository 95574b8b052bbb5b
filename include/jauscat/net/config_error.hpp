// Exception for a configuration that cannot be used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace jauscat::net {

enum class config_errc : std::uint8_t {
    ok,
    unreadable,     ///< the file cannot be read
    not_xml,        ///< not well-formed XML
    wrong_root,     ///< the root element is not <jausconfig>
    unexpected,     ///< text or an element that has no place there
    unknown_name,   ///< an element or attribute that does not exist
    missing,        ///< a required element
    duplicate,      ///< an element is given twice, or a name, address or interface is taken
    too_many,       ///< more elements than a system may have
    invalid_value,  ///< a value of another form, or out of range
    no_such_system, ///< a name that no <system> has
    inconsistent,   ///< values that do not go together, or that this node cannot use
};

/// The error in one line. `what()` of the exception says more.
[[nodiscard]] constexpr std::string_view describe(config_errc code) noexcept {
    switch (code) {
    case config_errc::ok: return "ok";
    case config_errc::unreadable: return "the file cannot be read";
    case config_errc::not_xml: return "not well-formed XML";
    case config_errc::wrong_root: return "the root element is not <jausconfig>";
    case config_errc::unexpected: return "text or an element has no place there";
    case config_errc::unknown_name: return "an element or attribute does not exist";
    case config_errc::missing: return "a required element is missing";
    case config_errc::duplicate: return "an element is given twice, or a name, address or interface is taken";
    case config_errc::too_many: return "more elements than a system may have";
    case config_errc::invalid_value: return "a value is of another form, or out of range";
    case config_errc::no_such_system: return "no <system> has this name";
    case config_errc::inconsistent: return "values do not go together, or this node cannot use them";
    }
    return "unknown error";
}

/// A configuration that cannot be used. `what()` is `file:line: problem; what to do`.
class config_error : public std::runtime_error {
  public:
    /// `name`: of the element or attribute, may be empty. `line` of the file; 0: none.
    config_error(config_errc code, std::string name, std::size_t line, const std::string& text)
        : std::runtime_error{text}, name_{std::move(name)}, line_{line}, code_{code} {}

    [[nodiscard]] config_errc code() const noexcept { return code_; }
    /// The element or attribute concerned, such as "port"; empty for the whole file.
    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    /// Line in the file, from 1; 0 if the file could not be read or the problem is not in it.
    [[nodiscard]] std::size_t line() const noexcept { return line_; }

  private:
    std::string name_;
    std::size_t line_;
    config_errc code_;
};

} // namespace jauscat::net
