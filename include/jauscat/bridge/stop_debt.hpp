// What an actuator has to be told until it confirms: stop orders, and the end of an emergency.
#pragma once
#include <jauscat/jaus/message/saturating_add.hpp>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>

namespace jauscat::bridge {

/// What an actuator is told.
enum class stop_order : std::uint8_t {
    rest,            ///< efforts to zero
    emergency,       ///< Set Emergency
    clear_emergency, ///< Clear Emergency
};

/// Debts to one actuator and their order: an emergency, then rest, then the end of an emergency. An emergency that the
/// actuator confirms covers rest. What it refuses is tried again without end, except the end of an emergency. While an
/// emergency is refused, zeros are sent in between; while zeros are refused, an emergency is, for an actuator may be in
/// an emergency that nobody here knows of.
class stop_debt {
  public:
    using time = std::chrono::nanoseconds;

    /// `interval`: from the first refusal to the next attempt; after more of them up to ten times as long.
    constexpr explicit stop_debt(time interval) noexcept : interval_{interval} {}

    constexpr void owe_rest() noexcept {
        rest_ = true;
        begin();
    }
    /// An end of an emergency that is still owed is not owed any more. Whether the actuator knows emergencies is found
    /// out anew: another device may have taken its place, or its software was not complete yet.
    constexpr void owe_emergency() noexcept {
        emergency_ = rest_ = true;
        clear_ = emergency_is_unknown_ = false;
        begin();
    }
    constexpr void owe_clear() noexcept {
        clear_ = true;
        begin();
    }

    /// Whether the actuator has yet to confirm that it stops.
    [[nodiscard]] constexpr bool owes_stop() const noexcept { return rest_ || emergency_; }
    [[nodiscard]] constexpr bool owes_rest() const noexcept { return rest_; }
    [[nodiscard]] constexpr bool owes_emergency() const noexcept { return emergency_; }
    [[nodiscard]] constexpr bool owes_clear() const noexcept { return clear_; }
    [[nodiscard]] constexpr bool settled() const noexcept { return !owes_stop() && !clear_; }

    /// What is to be told next; nothing where all is confirmed.
    [[nodiscard]] constexpr std::optional<stop_order> next() const noexcept {
        if (emergency_) return rest_ && refusals_ % 2 != 0 ? stop_order::rest : stop_order::emergency;
        if (rest_)
            return refusals_ >= attempts_at_rest && refusals_ % 2 != 0 ? stop_order::emergency : stop_order::rest;
        if (clear_) return stop_order::clear_emergency;
        return std::nullopt;
    }
    /// Not before this.
    [[nodiscard]] constexpr time next_attempt() const noexcept { return next_attempt_; }
    /// How often the actuator has refused in a row.
    [[nodiscard]] constexpr unsigned refusals() const noexcept { return refusals_; }

    /// The actuator has confirmed `what`.
    constexpr void confirmed(stop_order what) noexcept {
        switch (what) {
        case stop_order::emergency: rest_ = emergency_ = false; break;
        case stop_order::rest: rest_ = false; break;
        case stop_order::clear_emergency: clear_ = false; break;
        }
        if (what == stop_order::rest && emergency_is_unknown_) emergency_ = false;
        begin();
    }
    /// The actuator has refused `what`. `unknown`: it has no object for it. An actuator that does not know emergencies
    /// owes rest alone. False where the end of an emergency is given up.
    constexpr bool refused(stop_order what, bool unknown, time now) noexcept {
        ++refusals_;
        next_attempt_ = jaus::saturating_add(now, interval_ * std::min(refusals_, slowest));
        if (what == stop_order::emergency && unknown) {
            emergency_is_unknown_ = true;
            if (!rest_) emergency_ = false;
        }
        if (what != stop_order::clear_emergency || (refusals_ < attempts_at_clear && !unknown)) return true;
        clear_ = false;
        return false;
    }
    /// The slave is away, or back: the next attempt is the first.
    constexpr void begin() noexcept {
        refusals_ = 0;
        next_attempt_ = time::min();
    }

  private:
    static constexpr unsigned slowest = 10;
    static constexpr unsigned attempts_at_rest = 3;
    static constexpr unsigned attempts_at_clear = 3;

    time interval_;
    bool rest_{}, emergency_{}, clear_{};
    bool emergency_is_unknown_{};
    unsigned refusals_{};
    time next_attempt_ = time::min();
};

} // namespace jauscat::bridge
