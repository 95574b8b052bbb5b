// Result of a network operation: success, or a line of text.
#pragma once

#include <string>
#include <utility>

namespace jauscat::net {

/// True on success. Otherwise `problem()` is a line with what happened and, where it helps, what to do.
class [[nodiscard]] outcome {
  public:
    outcome() = default;
    /// A failure.
    explicit outcome(std::string problem) : problem_{std::move(problem)} {}

    explicit operator bool() const noexcept { return problem_.empty(); }

    /// Empty on success.
    const std::string& problem() const noexcept { return problem_; }

  private:
    std::string problem_;
};

} // namespace jauscat::net
