// The functions of liveness_table.
#pragma once
#include <jauscat/jaus/message/peer_share.hpp>
#include <jauscat/jaus/routing/liveness_table.hpp>

namespace jauscat::jaus {

JAUSCAT_CONSTEXPR heard liveness_table::on_heard(const address& who, time_point now, duration timeout) noexcept {
    const time_point gone_at = saturating_add(now, timeout);
    if (place* const found = map_.exactly(who)) {
        found->value.last_heard_at = now;
        found->value.gone_at = std::max(found->value.gone_at, gone_at);
        return heard::known;
    }
    if (of_subsystem_[who.subsystem] >= peer_share(capacity())) return heard::no_capacity;
    if (map_.insert(who, {now, gone_at}) != inserted::ok) return heard::no_capacity;
    ++of_subsystem_[who.subsystem];
    next_check_ = std::min(next_check_, gone_at);
    return heard::appeared;
}

JAUSCAT_CONSTEXPR bool liveness_table::keep(const address& who) noexcept {
    if (place* const found = map_.exactly(who)) {
        found->value.gone_at = time_point::max();
        return true;
    }
    return on_heard(who, time_point{}, duration::max()) != heard::no_capacity;
}

JAUSCAT_CONSTEXPR std::optional<time_point> liveness_table::next_event() const noexcept {
    if (next_check_ == time_point::max()) return std::nullopt;
    return next_check_;
}

JAUSCAT_CONSTEXPR const sign_of_life* liveness_table::find(const address& who) const noexcept {
    const place* const found = map_.exactly(who);
    return found == nullptr ? nullptr : &found->value;
}

} // namespace jauscat::jaus
