// Owner of a file descriptor, for sockets that are used without Boost.Asio.
#pragma once

#include <unistd.h>
#include <utility>

namespace jauscat::net::detail {

/// -1: none.
class file_descriptor {
  public:
    explicit file_descriptor(int number) noexcept : number_{number} {}
    file_descriptor(file_descriptor&& other) noexcept : number_{std::exchange(other.number_, -1)} {}
    file_descriptor& operator=(file_descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    ~file_descriptor() {
        if (number_ >= 0) ::close(number_);
    }

    [[nodiscard]] int get() const noexcept { return number_; }

  private:
    int number_;
};

} // namespace jauscat::net::detail
