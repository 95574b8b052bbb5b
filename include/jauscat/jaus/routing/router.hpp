// Routes messages to local components and to hops without loops, although the header has no hop count.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/jaus/routing/routing_table.hpp>

namespace jauscat::jaus {

/// Routes the messages of one node by its table. The kind of hop that a message comes from decides where it may go:
///
/// | comes from                 | with a source in            | to one goes on to  | to all goes on to          |
/// | -------------------------- | --------------------------- | ------------------ | -------------------------- |
/// | here, a component          | the own node                | C, N, S            | C; and N, S, or `up` alone |
/// | a node                     | the own subsystem, not node | C, S; N if primary | C; if primary N and S      |
/// | a node                     | another subsystem           | C; N if primary    | C                          |
/// | another subsystem, unknown | another subsystem           | C, N               | C; N if primary            |
/// | the node manager's program | any but those here          | C of this program  | C of this program          |
///
/// C: components of the own node, N: nodes of the own subsystem, S: other subsystems.
///
/// No message is sent back to its hop; a message from another hop than the table has for its source is refused. The
/// primary is the one node that relays within its subsystem; there may be none if every node has a route to every
/// other. A primary relays a broadcast only if it comes from the node of its source, or from a group: otherwise several
/// nodes configured as primary would forward it to each other without end.
///
/// `up` is the node manager's program, or else the primary where that is another node: it sends the broadcasts for this
/// one. So a message passes at most its node, the primary, a gateway, the gateway of another subsystem, its primary and
/// the destination, and no step can be repeated.
///
/// A broadcast goes once to each hop that it concerns; of entries that cover each other only to the widest that names
/// the subsystem (2.0.0.0, not 2.1.0.0). So another subsystem with a primary has one route, to the primary; one without
/// has a route for each of its nodes; and a primary's routes to other subsystems do not lead through its own. A
/// multicast group between subsystems replaces single routes for subsystem 255; one between the nodes of the own
/// subsystem replaces the routes to them, and all of them must have it. The sender of a broadcast does not get it.
///
/// A message is never changed. One to one node costs at most two look-ups in an address_map; a broadcast beyond the
/// node iterates once over all routes.
class router {
  public:
    /// `routes` must outlive this. `primary`: the node that relays within the own subsystem; 0 for none.
    constexpr explicit router(routing_table& routes, std::uint8_t primary = 0) noexcept
        : table_{routes}, primary_{primary} {}

    /// A message received from `from`. `to_component(number, address)` is called for each receiving component of this
    /// program, with the component's own address, where the header may have 255; `to_hop(hop)` for each hop.
    constexpr routing route(const header& head, hop from, auto&& to_component, auto&& to_hop) {
        const auto& to = head.destination;
        routing all{.outcome = check(head, from)};
        if (!all) return all;
        const auto give = [&](const route_entry& where, const address& whole) {
            to_component(where.number, whole);
            ++all.components;
        };
        const auto send = [&](hop which) {
            to_hop(which);
            ++all.hops;
        };
        const bool to_all_here = table_.is_own_node(to) && (to.component == 255 || to.instance == 255);
        if (to.subsystem != 255 && to.node != 255 && !to_all_here) {
            all.outcome = pass_on(head, from, give, send);
            return all;
        }
        table_.next_turn();
        const auto send_once = [&](hop which) {
            if (which != from && table_.first_time(which)) send(which);
        };
        all.outcome = spread(head, from, give, send_once);
        if (all && all.components + all.hops == 0)
            all.outcome = covers_subsystem(to) ? routed::no_receiver : routed::no_route;
        return all;
    }

  private:
    [[nodiscard]] JAUSCAT_CONSTEXPR bool from_own_node(hop from) const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR bool of_own_subsystem(const address& a) const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR bool covers_subsystem(const address& to) const noexcept;

    [[nodiscard]] constexpr routed check(const header& head, hop from) const noexcept {
        const auto& [instance, component, node, subsystem] = head.destination;
        if (instance == 0 || component == 0 || node == 0 || subsystem == 0) return routed::invalid_destination;
        if (!names_one_component(head.source)) return routed::invalid_source;
        if (from != here) return check_sender(head, from);
        return table_.is_own_node(head.source) ? routed::ok : routed::source_is_elsewhere;
    }
    [[nodiscard]] JAUSCAT_CONSTEXPR routed check_sender(const header& head, hop from) const noexcept;

    // To one subsystem and node, and if that is the own to one component.
    constexpr routed pass_on(const header& head, hop from, auto& give, auto& send) const {
        const auto& to = head.destination;
        const route_entry* const found = table_.find(to);
        if (found != nullptr && found->is_here) {
            give(*found, to);
            return routed::ok;
        }
        if (!from_own_node(from) && !of_own_subsystem(to) && !of_own_subsystem(head.source))
            return routed::between_subsystems;
        if (found == nullptr) return table_.is_own_node(to) ? routed::no_such_component : routed::no_route;
        const hop by = found->number;
        if (by == from) return routed::would_return;
        const routed what = from == here ? routed::ok : may_go(from, table_.kind_of(by), of_own_subsystem(to));
        if (what == routed::ok) send(by);
        return what;
    }
    // The table above, for what is to one node. What is between other subsystems is excluded already.
    [[nodiscard]] JAUSCAT_CONSTEXPR routed may_go(hop from, hop_kind by, bool stays) const noexcept;

    // To all of a level.
    constexpr routed spread(const header& head, hop from, auto& give, auto& send) const {
        const auto& to = head.destination;
        const bool to_own = covers_subsystem(to), to_others = !of_own_subsystem(to);
        const bool to_nodes = to_own && to.node != table_.node();
        if (to_own && (to.node == 255 || to.node == table_.node())) spread_in_node(head, from, give, send);
        if (from != here && table_.manager()) return to_own ? routed::ok : routed::not_the_relay;
        if (from_own_node(from)) return to_nodes || to_others ? send_out(to, to_nodes, to_others, send) : routed::ok;

        const bool within = of_own_subsystem(head.source), enters = table_.kind_of(from) == hop_kind::subsystem;
        // Nodes that share a group have received it from the same sender already.
        const bool heard = within && table_.group(table_.subsystem(), to) != nullptr;
        const bool is_relayed = within && !heard && table_.next_hop(head.source) != from;
        const bool relays = primary_ == table_.node() && !is_relayed;
        if (relays && to_nodes && (within || enters) && !heard) table_.to_nodes(to, send);
        if (relays && to_others && within) table_.to_subsystems(to, send);
        if (to_own || (within && relays)) return routed::ok;
        return within ? routed::not_the_relay : routed::between_subsystems;
    }
    constexpr void spread_in_node(const header& head, hop from, auto& give, auto& send) const {
        const auto& to = head.destination;
        for (const auto& [component, instance, where] : table_.components()) {
            if (!table_.covers(to.component, component) || !table_.covers(to.instance, instance)) continue;
            const address whole{instance, component, table_.node(), table_.subsystem()};
            if (where.is_here && whole != head.source) give(where, whole);
            if (!where.is_here && (!table_.manager() || (from == here && where.number == *table_.manager())))
                send(where.number);
        }
    }
    // Routes a message from this node to others, directly or through the program or node that relays for it.
    constexpr routed send_out(const address& to, bool to_nodes, bool to_others, auto& send) const {
        if (const auto manager = table_.manager()) {
            send(*manager);
            return routed::ok;
        }
        if (primary_ != 0 && primary_ != table_.node()) {
            const route_entry* const all = to_nodes ? table_.group(table_.subsystem(), to) : nullptr;
            const auto up = all != nullptr ? all->number : table_.next_hop({1, 1, primary_, table_.subsystem()});
            if (!up) return routed::no_route;
            send(*up);
            return routed::ok;
        }
        if (to_nodes) table_.to_nodes(to, send);
        if (to_others) table_.to_subsystems(to, send);
        return routed::ok;
    }

    routing_table& table_;
    std::uint8_t primary_;
};

} // namespace jauscat::jaus

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jaus/routing/impl/router.ipp>
#endif
