// The result of an operation on the network that may fail while a program runs: nothing to say, or a line of text.
#pragma once

#include <string>
#include <utility>

namespace jauscat::net {

/// True when the operation was done. Otherwise `problem()` says what happened and, where it helps, what to do.
class [[nodiscard]] outcome {
  public:
    outcome() = default;
    /// A failure; `problem` is the line that says what happened.
    explicit outcome(std::string problem) : problem_{std::move(problem)} {}

    explicit operator bool() const noexcept { return problem_.empty(); }

    /// One line of text; empty when the operation was done.
    const std::string& problem() const noexcept { return problem_; }

  private:
    std::string problem_;
};

} // namespace jauscat::net
