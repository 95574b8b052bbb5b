// Routing table of a node: components, hops, routes.
#pragma once
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/jaus/routing/address_map.hpp>
#include <jauscat/jaus/routing/routed.hpp>

#include <optional>
#include <utility>

namespace jauscat::jaus {

/// A route.
struct route_entry {
    std::uint16_t number{}; ///< a hop, or the number that the program gave to its component
    bool is_here{};         ///< a component of this program
};
/// A place for one hop.
struct hop_state {
    hop_kind kind{};       ///< kind of neighbour
    bool outside_groups{}; ///< see routing_table::keep_outside_groups
    std::uint32_t turn{};  ///< of the last broadcast that went there
};
/// A place for one component of the own node, in this program or in others. 0: every ID of that level.
struct node_component {
    std::uint8_t component{}; ///< its ID
    std::uint8_t instance{};
    route_entry where{}; ///< in which program
};

/// The addresses that one node knows. An address's level of 0 matches every ID of that level, and the most specific
/// entry counts, as in an address_map. The kind of a hop follows from the addresses that lead to it: see hop_kind. An
/// entry 255.255.0.0 is a multicast group between subsystems, <own>.255.0.0 one between the nodes of the own subsystem.
/// A message to a group comes from the hop of its sender, if that is known; otherwise from the group's.
class routing_table {
  public:
    /// The memory must outlive this: `routes` for routes (three quarters of a power of two can be used), `hops` with a
    /// place for each hop number from 0, `components` for those of the own node.
    constexpr routing_table(std::uint8_t subsystem, std::uint8_t node, std::span<address_place<route_entry>> routes,
                            std::span<hop_state> hops, std::span<node_component> components) noexcept
        : subsystem_{subsystem}, node_{node}, routes_{routes}, hops_{hops}, components_{components} {
        std::ranges::fill(hops, hop_state{});
    }
    [[nodiscard]] constexpr std::uint8_t subsystem() const noexcept { return subsystem_; }
    /// The own node.
    [[nodiscard]] constexpr std::uint8_t node() const noexcept { return node_; }

    /// A component of this program. `number` is what the router calls it.
    [[nodiscard]] constexpr added add_component(std::uint8_t component, std::uint8_t instance,
                                                std::uint16_t number) noexcept {
        const address whole{instance, component, node_, subsystem_};
        return names_one_component(whole) ? add(whole, {number, true}) : added::invalid_address;
    }
    /// Messages to `to` go to `by`. An address of the own node is that of a component in another program; that of the
    /// own node as a whole leads to the program that has its node manager.
    [[nodiscard]] constexpr added add_route(const address& to, hop by) noexcept {
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
    /// The hop does not receive multicast groups: it gets its own copy of each message to a group.
    constexpr void keep_outside_groups(hop which) noexcept {
        if (which < hops_.size()) hops_[which].outside_groups = true;
    }

    /// The route to this component, or nullptr. What leads to the subsystem does not lead to a component that the own
    /// node does not have.
    [[nodiscard]] constexpr const route_entry* find(const address& one) const noexcept {
        const auto* const found = routes_.find(one);
        return found == nullptr || (is_own_node(one) && !is_own_node(found->address)) ? nullptr : &found->value;
    }
    /// The hop for messages to this one component: a hop, `here`, or nothing without a route. Also the hop from which
    /// messages of this source are expected.
    [[nodiscard]] constexpr std::optional<hop> next_hop(const address& one) const noexcept {
        const route_entry* const found = find(one);
        if (found == nullptr) return std::nullopt;
        return found->is_here ? here : found->number;
    }
    /// Of a hop without an address: subsystem.
    [[nodiscard]] constexpr hop_kind kind_of(hop which) const noexcept {
        const auto known = which < hops_.size() ? hops_[which].kind : hop_kind::unused;
        return known == hop_kind::unused ? hop_kind::subsystem : known;
    }
    /// The hop to the program with the own node's node manager, if that is another one.
    [[nodiscard]] constexpr std::optional<hop> manager() const noexcept { return manager_; }
    /// Those of the own node.
    [[nodiscard]] constexpr std::span<const node_component> components() const noexcept {
        return components_.first(component_count_);
    }
    [[nodiscard]] constexpr bool is_own_node(const address& a) const noexcept {
        return a.subsystem == subsystem_ && a.node == node_;
    }

    /// From here on every hop is new to first_time() again.
    constexpr void next_turn() noexcept {
        if (++turn_ != 0) return;
        for (auto& state : hops_) state.turn = 0; // all numbers have been used
        turn_ = 1;
    }
    /// Whether this is the first call for this hop in this turn.
    [[nodiscard]] constexpr bool first_time(hop which) noexcept {
        return std::exchange(hops_[which].turn, turn_) != turn_;
    }

    /// The route of the multicast group between subsystems (255) or between the nodes of the own subsystem, or nullptr.
    [[nodiscard]] constexpr const route_entry* group(std::uint8_t subsystem, const address& to) const noexcept {
        const auto* const found = routes_.find({to.instance, to.component, 255, subsystem});
        const bool is_group = found != nullptr && found->address.subsystem == subsystem &&
                              (subsystem == 255 || found->address.node == 255);
        return is_group ? &found->value : nullptr;
    }
    /// Calls `send(hop)` for each route to other nodes of the own subsystem that the destination covers.
    constexpr void to_nodes(const address& to, auto&& send) const {
        const route_entry* const all = group(subsystem_, to);
        if (all != nullptr) send(all->number);
        along_routes(to, hop_kind::node, all != nullptr, send, [this](const address& entry) {
            return entry.subsystem == subsystem_ && entry.node != node_ && entry.node != 255;
        });
    }
    /// Calls `send(hop)` for each route to other subsystems that the destination covers.
    constexpr void to_subsystems(const address& to, auto&& send) const {
        const route_entry* const all = to.subsystem == 255 ? group(255, to) : nullptr;
        if (all != nullptr) send(all->number);
        const bool named = along_routes(to, hop_kind::subsystem, all != nullptr, send, [this](const address& entry) {
            return entry.subsystem != subsystem_ && entry.subsystem != 255 && entry.subsystem != 0;
        });
        if (to.subsystem == 255 || !named) // the route to all other subsystems
            along_routes(to, hop_kind::subsystem, all != nullptr, send,
                         [](const address& entry) { return entry.subsystem == 0; });
    }

    /// Whether an ID of a destination covers one of an entry: all, anyone, or the same.
    [[nodiscard]] static constexpr bool covers(std::uint8_t to, std::uint8_t entry) noexcept {
        return to == 255 || entry == 0 || to == entry;
    }

  private:
    [[nodiscard]] constexpr added add(const address& entry, const route_entry& where) noexcept {
        const bool of_own_node = is_own_node(entry);
        if (of_own_node && component_count_ == components_.size()) return added::full;
        const inserted what = routes_.insert(entry, where);
        if (what != inserted::ok) return what == inserted::full ? added::full : added::duplicate;
        if (of_own_node) components_[component_count_++] = {entry.component, entry.instance, where};
        return added::ok;
    }
    // Of entries that cover each other the widest counts. Whether there are any.
    constexpr bool along_routes(const address& to, hop_kind kind, bool by_group, auto& send, auto&& wanted) const {
        bool any = false;
        for (const auto& [entry, taken, where] : routes_.places()) {
            if (!taken || where.is_here || !wanted(entry) || !covers(to.subsystem, entry.subsystem) ||
                !covers(to.node, entry.node) || !covers(to.component, entry.component) ||
                !covers(to.instance, entry.instance) || is_within_another(entry))
                continue;
            any = true;
            const bool heard = by_group && !hops_[where.number].outside_groups;
            if (kind_of(where.number) == kind && !heard) send(where.number);
        }
        return any;
    }
    // Whether a wider entry names the same subsystem.
    [[nodiscard]] constexpr bool is_within_another(const address& entry) const noexcept {
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

    std::uint8_t subsystem_;
    std::uint8_t node_;
    std::optional<hop> manager_{};
    std::uint32_t turn_{};
    address_map<route_entry> routes_;
    std::span<hop_state> hops_;
    std::span<node_component> components_;
    std::size_t component_count_{};
};

} // namespace jauscat::jaus
