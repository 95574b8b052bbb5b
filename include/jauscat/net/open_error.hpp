// Exception for a socket or an interface that cannot be opened.
#pragma once

#include <jauscat/net/error.hpp>

#include <stdexcept>
#include <utility>

namespace jauscat::net {

/// `what()` states the reason and what to do.
class open_error : public std::runtime_error {
  public:
    explicit open_error(net::error why) : std::runtime_error{why.message}, error_{std::move(why)} {}

    [[nodiscard]] const net::error& error() const noexcept { return error_; }
    [[nodiscard]] errc code() const noexcept { return error_.code; }

  private:
    net::error error_;
};

} // namespace jauscat::net
