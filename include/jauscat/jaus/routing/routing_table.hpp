// Routing table of a node: components, hops, routes.
#pragma once
#include <jauscat/base/compilation.hpp>
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
    JAUSCAT_CONSTEXPR routing_table(std::uint8_t subsystem, std::uint8_t node,
                                    std::span<address_place<route_entry>> routes, std::span<hop_state> hops,
                                    std::span<node_component> components) noexcept;
    [[nodiscard]] constexpr std::uint8_t subsystem() const noexcept { return subsystem_; }
    /// The own node.
    [[nodiscard]] constexpr std::uint8_t node() const noexcept { return node_; }

    /// A component of this program. `number` is what the router calls it.
    [[nodiscard]] JAUSCAT_CONSTEXPR added add_component(std::uint8_t component, std::uint8_t instance,
                                                        std::uint16_t number) noexcept;
    /// Messages to `to` go to `by`. An address of the own node is that of a component in another program; that of the
    /// own node as a whole leads to the program that has its node manager.
    [[nodiscard]] JAUSCAT_CONSTEXPR added add_route(const address& to, hop by) noexcept;
    /// The hop does not receive multicast groups: it gets its own copy of each message to a group.
    JAUSCAT_CONSTEXPR void keep_outside_groups(hop which) noexcept;

    /// The route to this component, or nullptr. What leads to the subsystem does not lead to a component that the own
    /// node does not have.
    [[nodiscard]] JAUSCAT_CONSTEXPR const route_entry* find(const address& one) const noexcept;
    /// The hop for messages to this one component: a hop, `here`, or nothing without a route. Also the hop from which
    /// messages of this source are expected.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::optional<hop> next_hop(const address& one) const noexcept;
    /// Of a hop without an address: subsystem.
    [[nodiscard]] JAUSCAT_CONSTEXPR hop_kind kind_of(hop which) const noexcept;
    /// The hop to the program with the own node's node manager, if that is another one.
    [[nodiscard]] constexpr std::optional<hop> manager() const noexcept { return manager_; }
    /// Those of the own node.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::span<const node_component> components() const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR bool is_own_node(const address& a) const noexcept;

    /// From here on every hop is new to first_time() again.
    JAUSCAT_CONSTEXPR void next_turn() noexcept;
    /// Whether this is the first call for this hop in this turn.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool first_time(hop which) noexcept;

    /// The route of the multicast group between subsystems (255) or between the nodes of the own subsystem, or nullptr.
    [[nodiscard]] JAUSCAT_CONSTEXPR const route_entry* group(std::uint8_t subsystem, const address& to) const noexcept;
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
    [[nodiscard]] JAUSCAT_CONSTEXPR static bool covers(std::uint8_t to, std::uint8_t entry) noexcept;

  private:
    [[nodiscard]] JAUSCAT_CONSTEXPR added add(const address& entry, const route_entry& where) noexcept;
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
    [[nodiscard]] JAUSCAT_CONSTEXPR bool is_within_another(const address& entry) const noexcept;

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

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jaus/routing/impl/routing_table.ipp>
#endif
