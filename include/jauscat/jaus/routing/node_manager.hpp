// The node manager, component 1 instance 1 of a node: heartbeats, liveness of other components, lists of subsystems,
// nodes and components.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/routing/node_description.hpp>

#include <bitset>
#include <tuple>

namespace jauscat::jaus {

/// A part of the component <subsystem>.<node>.1.1 that
/// - sends heartbeats to all node managers and stores the senders of received ones: node managers, components of the
///   own node;
/// - queries the other nodes of the subsystem for their components, when they appear and periodically;
/// - answers Query Identification (2B00h) for system, subsystem, node and component, Query Configuration (2B01h) for
///   subsystem and node, Query Subsystem List (2B02h), and what every described_component answers. Reports contain the
///   description and the components alive. Reserved query types are refused, as are reports that exceed the memory. A
///   heartbeat beyond the capacity is refused and counted.
class node_manager {
  public:
    /// `description` and the memory must outlive this. `self`: with component 1 and instance 1.
    JAUSCAT_FUNCTION node_manager(const address& self, const node_description& description,
                                  const node_manager_memory& memory, const node_manager_options& options = {}) noexcept;

    JAUSCAT_FUNCTION message_outcome on_message(const header& head, std::span<const std::byte> body, time_point now,
                                                message_sink out) noexcept;

    JAUSCAT_FUNCTION void on_time(time_point now, message_sink out) noexcept;
    /// Never later than that on_time has something to do.
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<time_point> next_event() const noexcept;
    /// No effect: liveness comes from heartbeats alone.
    void on_lost(const address&) noexcept {}

    /// The components that are present.
    [[nodiscard]] const liveness_table& present() const noexcept { return present_; }
    /// `who` counts as alive permanently, also without heartbeats; false if the table is full.
    [[nodiscard]] bool keep(const address& who) noexcept { return present_.keep(who); }
    /// Writes the body of Report Configuration of the subsystem or the node to the front of `body`; returns its size,
    /// or nothing if `what` is neither or the memory is too small. For events of this report.
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<std::size_t> configuration(query_field what,
                                                                            std::span<std::byte> body) const noexcept;
    /// Components that were not stored because the table is full, counted at each heartbeat and report.
    [[nodiscard]] std::uint64_t not_remembered() const noexcept { return not_remembered_; }

  private:
    JAUSCAT_FUNCTION static void tell(const hook<void(const address&)>& whom, const address& who) noexcept;
    JAUSCAT_FUNCTION static message_outcome done(bool sent) noexcept;
    JAUSCAT_FUNCTION heard remember(const address& who, time_point now, duration timeout) noexcept;

    JAUSCAT_FUNCTION message_outcome on_heartbeat(const header& head, time_point now, message_sink out) noexcept;
    // The components of another node of the subsystem.
    JAUSCAT_FUNCTION void ask(const address& who, message_sink out) const noexcept;
    // From the reports of the queried components, about themselves.
    JAUSCAT_FUNCTION message_outcome on_configuration(const header& head, std::span<const std::byte> body,
                                                      time_point now) noexcept;

    JAUSCAT_FUNCTION message_outcome identify(query_type whose, const header& head, std::span<const std::byte> body,
                                              message_sink out) noexcept;

    // The selected ones and this one, in memory from `lists`, sorted by `key`, each once; empty if the memory is too
    // small.
    std::span<address> collect(wire::arena& lists, auto&& wanted, auto&& key) const noexcept {
        const std::size_t most = 1 + description_.components.size() + present_.size();
        address* const first = lists.allocate<address>(most);
        if (first == nullptr) return {};
        std::size_t count = 0;
        first[count++] = self_;
        for (const auto& [component, instance] : description_.components)
            first[count++] = {instance, component, self_.node, self_.subsystem};
        present_.for_each([&](const address& who) {
            if (wanted(who)) first[count++] = who;
        });
        const std::span all{first, count};
        std::ranges::sort(all, {}, key);
        return all.first(static_cast<std::size_t>(std::unique(all.begin(), all.end()) - all.begin()));
    }
    // The message counts a node's components in one byte. Those of the description stay in before others.
    JAUSCAT_FUNCTION std::span<const configured_component>
    most_of_node(std::span<configured_component> of_node) const noexcept;
    // False, and no report, for another field and without memory; else the result of `use(report)`.
    bool with_components(query_field what, auto&& use) const noexcept {
        const bool of_node = what == query_field::node_configuration;
        if (!of_node && what != query_field::subsystem_configuration) return false;
        wire::arena lists{memory_.lists};
        const auto all = collect(
            lists,
            [&](const address& who) {
                return who.subsystem == self_.subsystem && (!of_node || who.node == self_.node);
            },
            [](const address& who) { return std::tuple{who.node, who.component, who.instance}; });
        auto* const components = lists.allocate<configured_component>(all.size());
        std::size_t node_count = 0;
        for (std::size_t i = 0; i != all.size(); ++i) node_count += i == 0 || all[i].node != all[i - 1].node ? 1 : 0;
        auto* const nodes = lists.allocate<configured_node>(node_count);
        if (all.empty() || components == nullptr || nodes == nullptr) return false;
        for (std::size_t i = 0, begin = 0, node = 0; i != all.size(); ++i) {
            components[i] = {all[i].component, all[i].instance};
            if (i + 1 != all.size() && all[i + 1].node == all[i].node) continue;
            nodes[node++] = {all[i].node, most_of_node(std::span{components + begin, i + 1 - begin})};
            begin = i + 1;
        }
        return use(report_configuration{std::span<const configured_node>{nodes, node_count}});
    }
    // Each subsystem once, by its first node manager if it has one.
    JAUSCAT_FUNCTION message_outcome report_subsystems(const header& head, message_sink out) noexcept;

    address self_;
    const node_description& description_;
    node_manager_memory memory_;
    node_manager_options options_;
    described_component own_;
    liveness_table present_;
    time_point next_survey_{time_point::min()};
    std::uint64_t not_remembered_{};
};

} // namespace jauscat::jaus

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jaus/routing/impl/node_manager.ipp>
#endif
