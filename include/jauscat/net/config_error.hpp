// Exception for a configuration that cannot be used.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace jauscat::net {

/// A configuration that cannot be used. `what()` is `file:line: problem; what to do`.
class config_error : public std::runtime_error {
  public:
    /// `line` of the file; 0: none.
    config_error(const std::string& text, std::size_t at_line) : std::runtime_error{text}, line_{at_line} {}

    /// Line in the file, from 1; 0 if the file could not be read or the problem is not in it.
    std::size_t line() const noexcept { return line_; }

  private:
    std::size_t line_;
};

} // namespace jauscat::net
