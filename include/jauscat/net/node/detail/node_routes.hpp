// Peers and routes of a configuration, numbered for the router.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/jaus/routing/router.hpp>
#include <jauscat/net/config/access_list.hpp>
#include <jauscat/net/config/jaus_config.hpp>
#include <jauscat/net/detail/endpoint_text.hpp>

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace jauscat::net::detail {

/// Address of a program's node manager. The node is `node`, or if that is 0 that of its jausip, or else the first of
/// its <node> entries, or 1. Throws `config_error`.
inline jaus::address manager_of(const jaus_config& config, std::uint8_t node) {
    const auto& me = config.me();
    if (!me.has_ra)
        throw complaint(config, config_errc::inconsistent, "jausip", me.line,
                        "this system has no jausip; a node of the RA needs one, such as 1.0.0.0");
    if (me.jausip.subsystem == 0)
        throw complaint(config, config_errc::inconsistent, "jausip", me.line,
                        "this system's jausip " + to_jausip(me.jausip) +
                            " has no subsystem; a node needs one, such as 1.0.0.0");
    if (node == 0) node = me.jausip.node;
    if (node == 0) node = me.nodes.empty() ? std::uint8_t{1} : me.nodes.front().id;
    return {.instance = 1, .component = 1, .node = node, .subsystem = me.jausip.subsystem};
}

/// A hop is an endpoint: systems of the configuration with the same endpoint share a hop. The multicast group of this
/// system, if it has one, is also a hop. Systems outside the group get copies of their own.
///
/// With an open access list, a subsystem that the configuration does not cover is answered at its last endpoint: one
/// hop for each subsystem, so that the memory is bounded. Heartbeats, reports of service connections and events are
/// sent to such a hop only while messages arrive from it, so that one forged datagram does not cause an endless flow.
class node_routes {
  public:
    using endpoint = boost::asio::ip::udp::endpoint;

    struct neighbour {
        endpoint to{};
        jaus::framing framing{};
        time_point quiet_after{time_point::max()}; ///< afterwards it gets answers only
    };

    /// `components` are those of this program, all of one node; the router identifies them by position. `strangers`:
    /// how long a learned route to a subsystem outside of the configuration is kept. Throws `config_error`.
    node_routes(const jaus_config& config, std::span<const jaus::address> components, std::uint8_t subsystem,
                std::uint8_t node, std::optional<duration> strangers)
        : config_{config},
          strangers_{strangers},
          routes_(std::bit_ceil((config.systems.size() + components.size() + max_unknown_peers() + 2) * 3 / 2 + 2)),
          states_(config.systems.size() + max_unknown_peers() + 1),
          places_(config.systems.size() + components.size()),
          table_{subsystem, node, routes_, states_, places_} {
        for (std::size_t i = 0; i != components.size(); ++i)
            if (const auto what = table_.add_component(components[i].component, components[i].instance,
                                                       static_cast<std::uint16_t>(i));
                what != jaus::added::ok)
                throw config_error{config_errc::inconsistent, "component", 0,
                                   config.source + ": component " + to_jausip(components[i]) + ": " +
                                       std::string{describe(what)}};
        for (const auto& system : config.systems)
            hop_of_system_.push_back(&system == &config.me() || !system.has_ra ? jaus::unknown_hop : add(system));
        if (config.me().multicast) add_group(*config.me().multicast);
    }
    node_routes(const node_routes&) = delete;
    node_routes& operator=(const node_routes&) = delete;

    [[nodiscard]] jaus::routing_table& table() noexcept { return table_; }
    [[nodiscard]] const neighbour& operator[](jaus::hop hop) const noexcept { return neighbours_[hop]; }
    /// The hop from which a message comes: the peer with this endpoint, or one with any source port that has the JAUS
    /// source; else the multicast group that has received it, or none.
    [[nodiscard]] jaus::hop origin(const jaus::address& source, const endpoint& from, jaus::framing framing,
                                   bool by_group, const access_list& list, time_point now) {
        if (strangers_) learn(source, {from, framing, saturating_add(now, *strangers_)}, by_group);
        if (const auto found = by_endpoint_.find(from); found != by_endpoint_.end()) return found->second;
        if (const auto peer = list.check(source, from).peer) return hop_of_system_[*peer];
        return by_group ? group_.value_or(jaus::unknown_hop) : jaus::unknown_hop;
    }

  private:
    [[noreturn]] void fail(config_errc code, const std::string& name, const system_entry& system,
                           const std::string& why) const {
        throw complaint(config_, code, name, system.line, why);
    }

    [[nodiscard]] std::size_t max_unknown_peers() const noexcept { return strangers_ ? 254 : 0; } // subsystems
    void learn(const jaus::address& source, const neighbour& heard, bool by_group) {
        if (source.subsystem == table_.subsystem()) return;
        const auto known = learned_.find(source.subsystem);
        if (known == learned_.end()) {
            if (table_.next_hop(source)) return; // in the configuration
            const auto hop = static_cast<jaus::hop>(neighbours_.size());
            if (table_.add_route({.subsystem = source.subsystem}, hop) != jaus::added::ok) return;
            if (!by_group) table_.keep_outside_groups(hop);
            neighbours_.push_back(heard);
            by_endpoint_.emplace(heard.to, hop);
            learned_.emplace(source.subsystem, hop);
            return;
        }
        auto& last = neighbours_[known->second];
        if (last.to != heard.to) {
            const auto old = by_endpoint_.find(last.to);
            if (old != by_endpoint_.end() && old->second == known->second) by_endpoint_.erase(old);
            by_endpoint_.emplace(heard.to, known->second);
        }
        last = heard;
    }

    jaus::hop add(const system_entry& system) {
        const auto to = system.endpoint();
        if (to == config_.me().endpoint())
            fail(config_errc::duplicate, "port", system,
                 "the system " + detail::quoted(system.name) + " listens where this system does, at " + text(to) +
                     "; give each its own port");
        const auto [at, is_new] = by_endpoint_.emplace(to, static_cast<jaus::hop>(neighbours_.size()));
        if (is_new)
            neighbours_.push_back({to, system.framing});
        else if (neighbours_[at->second].framing != system.framing)
            fail(config_errc::inconsistent, "framing", system,
                 "another system at " + text(to) + " has another framing; give them the same");
        const jaus::hop hop = at->second;
        if (const auto what = table_.add_route(system.jausip, hop); what != jaus::added::ok)
            fail(config_errc::inconsistent, "jausip", system,
                 "the jausip " + to_jausip(system.jausip) + " of " + detail::quoted(system.name) +
                     " cannot be used by this system: " + std::string{describe(what)});
        if (!shares_group(system)) table_.keep_outside_groups(hop);
        return hop;
    }
    [[nodiscard]] bool shares_group(const system_entry& system) const {
        const auto &mine = config_.me().multicast, &its = system.multicast;
        return mine && its && mine->group == its->group && mine->port == its->port;
    }
    void add_group(const multicast_options& options) {
        group_ = static_cast<jaus::hop>(neighbours_.size());
        neighbours_.push_back({{options.group, options.port}, config_.me().framing});
        static_cast<void>(table_.add_route({.node = 255, .subsystem = 255}, *group_));
        // It replaces single routes only if every node of the subsystem is a member.
        const bool by_all = std::ranges::all_of(config_.systems, [&](const system_entry& system) {
            return !system.has_ra || system.jausip.subsystem != table_.subsystem() || shares_group(system);
        });
        if (by_all) static_cast<void>(table_.add_route({.node = 255, .subsystem = table_.subsystem()}, *group_));
    }

    const jaus_config& config_;
    std::optional<duration> strangers_;
    std::vector<jaus::address_place<jaus::route_entry>> routes_;
    std::vector<jaus::hop_state> states_;
    std::vector<jaus::node_component> places_;
    jaus::routing_table table_;
    std::vector<neighbour> neighbours_{};
    std::map<endpoint, jaus::hop> by_endpoint_{};
    std::vector<jaus::hop> hop_of_system_{};
    std::optional<jaus::hop> group_{};
    std::map<std::uint8_t, jaus::hop> learned_{}; ///< of subsystems
};

} // namespace jauscat::net::detail
