// The functions of pending_stops.
#pragma once
#include <jauscat/bridge/pending_stops.hpp>

namespace jauscat::bridging {

JAUSCAT_CONSTEXPR void pending_stops::require_rest() noexcept {
    rest_ = true;
    begin();
}

JAUSCAT_CONSTEXPR void pending_stops::require_emergency() noexcept {
    emergency_ = rest_ = true;
    clear_ = emergency_is_unknown_ = false;
    begin();
}

JAUSCAT_CONSTEXPR void pending_stops::require_clear() noexcept {
    clear_ = true;
    begin();
}

JAUSCAT_CONSTEXPR std::optional<stop_order> pending_stops::next() const noexcept {
    if (emergency_) return rest_ && refusals_ % 2 != 0 ? stop_order::rest : stop_order::emergency;
    if (rest_) return refusals_ >= attempts_at_rest && refusals_ % 2 != 0 ? stop_order::emergency : stop_order::rest;
    if (clear_) return stop_order::clear_emergency;
    return std::nullopt;
}

JAUSCAT_CONSTEXPR void pending_stops::confirmed(stop_order what) noexcept {
    switch (what) {
    case stop_order::emergency: rest_ = emergency_ = false; break;
    case stop_order::rest: rest_ = false; break;
    case stop_order::clear_emergency: clear_ = false; break;
    }
    if (what == stop_order::rest && emergency_is_unknown_) emergency_ = false;
    begin();
}

JAUSCAT_CONSTEXPR bool pending_stops::refused(stop_order what, bool unknown, time_point now) noexcept {
    ++refusals_;
    next_attempt_ = saturating_add(now, interval_ * std::min(refusals_, slowest));
    if (what == stop_order::emergency && unknown) {
        emergency_is_unknown_ = true;
        if (!rest_) emergency_ = false;
    }
    if (what != stop_order::clear_emergency || (refusals_ < attempts_at_clear && !unknown)) return true;
    clear_ = false;
    return false;
}

JAUSCAT_CONSTEXPR void pending_stops::begin() noexcept {
    refusals_ = 0;
    next_attempt_ = time_point::min();
}

} // namespace jauscat::bridging
