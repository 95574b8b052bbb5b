// Pauses between attempts that grow from one failure to the next.
#pragma once

#include <jauscat/base/time.hpp>

#include <algorithm>
#include <chrono>
#include <optional>

namespace jauscat::net {

/// Limits of the pauses between attempts to open a connection or a device again.
struct pause_limits {
    duration first{std::chrono::milliseconds{250}}; ///< after the first failure; each further pause is twice as long
    duration longest{std::chrono::seconds{30}};
    friend constexpr bool operator==(const pause_limits&, const pause_limits&) = default;
};

class growing_pause {
  public:
    constexpr explicit growing_pause(const pause_limits& limits) noexcept : limits_{limits} {}

    /// The pause after a failure.
    [[nodiscard]] constexpr duration next() noexcept {
        const duration pause = std::min(next_.value_or(limits_.first), limits_.longest);
        next_ = saturating_add(pause, pause);
        return pause;
    }
    /// The next failure is the first one again.
    constexpr void reset() noexcept { next_.reset(); }

  private:
    pause_limits limits_;
    std::optional<duration> next_{};
};

} // namespace jauscat::net
