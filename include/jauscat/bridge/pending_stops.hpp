// Orders that are repeated until the actuator confirms them: stop orders, and the end of an emergency.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace jauscat::bridging {

/// Orders to an actuator.
enum class stop_order : std::uint8_t {
    rest,      ///< efforts to zero
    emergency, ///< Set Emergency
    clear_emergency,
};

/// Pending orders to one actuator, by priority: emergency, rest, end of an emergency. An emergency that the actuator
/// confirms covers rest. Refused orders are repeated without limit, except the end of an emergency. While an emergency
/// is refused, zeros are sent in between; while zeros are refused, an emergency is, because the actuator may be in an
/// emergency that was not set here.
class pending_stops {
  public:
    /// `interval`: from the first refusal to the next attempt; after more of them up to ten times as long.
    constexpr explicit pending_stops(duration interval) noexcept : interval_{interval} {}

    JAUSCAT_CONSTEXPR void require_rest() noexcept;
    /// Cancels a pending end of an emergency. Whether the actuator supports emergencies is determined again, because
    /// the device may have been replaced or restarted.
    JAUSCAT_CONSTEXPR void require_emergency() noexcept;
    JAUSCAT_CONSTEXPR void require_clear() noexcept;

    /// Whether the actuator has yet to confirm that it stops.
    [[nodiscard]] constexpr bool stop_is_pending() const noexcept { return rest_ || emergency_; }
    [[nodiscard]] constexpr bool rest_is_pending() const noexcept { return rest_; }
    [[nodiscard]] constexpr bool emergency_is_pending() const noexcept { return emergency_; }
    [[nodiscard]] constexpr bool clear_is_pending() const noexcept { return clear_; }
    [[nodiscard]] constexpr bool settled() const noexcept { return !stop_is_pending() && !clear_; }

    /// Next order; empty when all are confirmed.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::optional<stop_order> next() const noexcept;
    /// Not before this.
    [[nodiscard]] constexpr time_point next_attempt() const noexcept { return next_attempt_; }
    /// Number of consecutive refusals.
    [[nodiscard]] constexpr unsigned refusals() const noexcept { return refusals_; }

    /// The actuator has confirmed `what`.
    JAUSCAT_CONSTEXPR void confirmed(stop_order what) noexcept;
    /// The actuator has refused `what`. `unknown`: it has no object for it. An actuator without emergencies only needs
    /// rest. False if the end of an emergency is dropped.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool refused(stop_order what, bool unknown, time_point now) noexcept;
    /// The slave is lost, or has returned: the next attempt is the first.
    JAUSCAT_CONSTEXPR void begin() noexcept;

  private:
    static constexpr unsigned slowest = 10;
    static constexpr unsigned attempts_at_rest = 3;
    static constexpr unsigned attempts_at_clear = 3;

    duration interval_;
    bool rest_{}, emergency_{}, clear_{};
    bool emergency_is_unknown_{};
    unsigned refusals_{};
    time_point next_attempt_ = time_point::min();
};

} // namespace jauscat::bridging

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/bridge/impl/pending_stops.ipp>
#endif
