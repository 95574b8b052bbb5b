// The functions of router.
#pragma once
#include <jauscat/jaus/routing/router.hpp>

namespace jauscat::jaus {

JAUSCAT_CONSTEXPR bool router::from_own_node(hop from) const noexcept {
    return from == here || table_.kind_of(from) == hop_kind::component;
}

JAUSCAT_CONSTEXPR bool router::of_own_subsystem(const address& a) const noexcept {
    return a.subsystem == table_.subsystem();
}

JAUSCAT_CONSTEXPR bool router::covers_subsystem(const address& to) const noexcept {
    return to.subsystem == 255 || of_own_subsystem(to);
}

JAUSCAT_CONSTEXPR routed router::check_sender(const header& head, hop from) const noexcept {
    const bool is_own = table_.is_own_node(head.source);
    const route_entry* const known = is_own ? table_.find(head.source) : nullptr;
    const bool is_here = known != nullptr && known->is_here;
    switch (table_.kind_of(from)) {
    case hop_kind::manager: return is_here ? routed::source_is_local : routed::ok;
    case hop_kind::component:
        if (is_here) return routed::source_is_local;
        return known != nullptr && known->number == from ? routed::ok : routed::source_is_elsewhere;
    case hop_kind::node: return is_own ? routed::source_is_local : routed::ok;
    default: return of_own_subsystem(head.source) ? routed::source_is_local : routed::ok;
    }
}

JAUSCAT_CONSTEXPR routed router::may_go(hop from, hop_kind by, bool stays) const noexcept {
    if (table_.manager()) return routed::not_the_relay;
    if (from_own_node(from) || by == hop_kind::component) return routed::ok;
    if (by == hop_kind::subsystem) return stays ? routed::no_route : routed::ok;
    const bool enters = table_.kind_of(from) == hop_kind::subsystem;
    return enters || primary_ == table_.node() ? routed::ok : routed::not_the_relay;
}

} // namespace jauscat::jaus
