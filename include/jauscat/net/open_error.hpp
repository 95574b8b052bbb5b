// Exception for a socket or an interface that cannot be opened.
#pragma once

#include <stdexcept>

namespace jauscat::net {

/// `what()` states the reason and what to do.
class open_error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

} // namespace jauscat::net
