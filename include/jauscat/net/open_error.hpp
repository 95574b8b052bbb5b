// What is thrown when a socket or an interface cannot be opened.
#pragma once

#include <stdexcept>

namespace jauscat::net {

/// A transport or link could not be opened. `what()` says why and what to do.
class open_error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

} // namespace jauscat::net
