// The functions of routing_table.
#pragma once
#include <jauscat/jaus/routing/routing_table.hpp>

namespace jauscat::jaus {

JAUSCAT_CONSTEXPR routing_table::routing_table(std::uint8_t subsystem, std::uint8_t node,
                                               std::span<address_place<route_entry>> routes, std::span<hop_state> hops,
                                               std::span<node_component> components) noexcept
    : subsystem_{subsystem}, node_{node}, routes_{routes}, hops_{hops}, components_{components} {
    std::ranges::fill(hops, hop_state{});
}

JAUSCAT_CONSTEXPR added routing_table::add_component(std::uint8_t component, std::uint8_t instance,
                                                     std::uint16_t number) noexcept {
    const address whole{instance, component, node_, subsystem_};
    return names_one_component(whole) ? add(whole, {number, true}) : added::invalid_address;
}

JAUSCAT_CONSTEXPR added routing_table::add_route(const address& to, hop by) noexcept {
    if (by >= hops_.size()) return added::invalid_hop;
    const added what = add(to, {by, false});
    if (what != added::ok) return what;
    const hop_kind kind = to.subsystem != subsystem_ ? hop_kind::subsystem
                          : to.node != node_         ? hop_kind::node
                          : to.component != 0        ? hop_kind::component
                                                     : hop_kind::manager;
    hops_[by].kind = std::max(hops_[by].kind, kind);
    if (kind == hop_kind::manager) manager_ = by;
    return what;
}

JAUSCAT_CONSTEXPR void routing_table::keep_outside_groups(hop which) noexcept {
    if (which < hops_.size()) hops_[which].outside_groups = true;
}

JAUSCAT_CONSTEXPR const route_entry* routing_table::find(const address& one) const noexcept {
    const auto* const found = routes_.find(one);
    return found == nullptr || (is_own_node(one) && !is_own_node(found->address)) ? nullptr : &found->value;
}

JAUSCAT_CONSTEXPR std::optional<hop> routing_table::next_hop(const address& one) const noexcept {
    const route_entry* const found = find(one);
    if (found == nullptr) return std::nullopt;
    return found->is_here ? here : found->number;
}

JAUSCAT_CONSTEXPR hop_kind routing_table::kind_of(hop which) const noexcept {
    const auto known = which < hops_.size() ? hops_[which].kind : hop_kind::unused;
    return known == hop_kind::unused ? hop_kind::subsystem : known;
}

JAUSCAT_CONSTEXPR std::span<const node_component> routing_table::components() const noexcept {
    return components_.first(component_count_);
}

JAUSCAT_CONSTEXPR bool routing_table::is_own_node(const address& a) const noexcept {
    return a.subsystem == subsystem_ && a.node == node_;
}

JAUSCAT_CONSTEXPR void routing_table::next_turn() noexcept {
    if (++turn_ != 0) return;
    for (auto& state : hops_) state.turn = 0; // all numbers have been used
    turn_ = 1;
}

JAUSCAT_CONSTEXPR bool routing_table::first_time(hop which) noexcept {
    return std::exchange(hops_[which].turn, turn_) != turn_;
}

JAUSCAT_CONSTEXPR const route_entry* routing_table::group(std::uint8_t subsystem, const address& to) const noexcept {
    const auto* const found = routes_.find({to.instance, to.component, 255, subsystem});
    const bool is_group =
        found != nullptr && found->address.subsystem == subsystem && (subsystem == 255 || found->address.node == 255);
    return is_group ? &found->value : nullptr;
}

JAUSCAT_CONSTEXPR bool routing_table::covers(std::uint8_t to, std::uint8_t entry) noexcept {
    return to == 255 || entry == 0 || to == entry;
}

JAUSCAT_CONSTEXPR added routing_table::add(const address& entry, const route_entry& where) noexcept {
    const bool of_own_node = is_own_node(entry);
    if (of_own_node && component_count_ == components_.size()) return added::full;
    const inserted what = routes_.insert(entry, where);
    if (what != inserted::ok) return what == inserted::full ? added::full : added::duplicate;
    if (of_own_node) components_[component_count_++] = {entry.component, entry.instance, where};
    return added::ok;
}

JAUSCAT_CONSTEXPR bool routing_table::is_within_another(const address& entry) const noexcept {
    if (entry.subsystem == 0) return false;
    for (unsigned open = 1; open != 8; ++open) {
        address wider = entry;
        if ((open & 1U) != 0) wider.instance = 0;
        if ((open & 2U) != 0) wider.component = 0;
        if ((open & 4U) != 0) wider.node = 0;
        if (wider != entry && routes_.exactly(wider) != nullptr) return true;
    }
    return false;
}

} // namespace jauscat::jaus
