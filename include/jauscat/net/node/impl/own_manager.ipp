// The functions of detail::own_manager.
#pragma once
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/jaus/routing/node_manager.hpp>
#include <jauscat/net/node/detail/configuration_events.hpp>
#include <jauscat/net/node/detail/configured_identity.hpp>
#include <jauscat/net/node/detail/own_manager.hpp>

#include <vector>

namespace jauscat::net::detail {
inline namespace JAUSCAT_WAY {

struct own_manager::parts {
    /// Places for detected components; three quarters of them can be used.
    static constexpr std::size_t places = 4096;

    parts(const jaus_config& config, const jaus::address& self, std::span<const jaus::address> components,
          const jaus_node_options& options, presence_changes& changes)
        : listed_components{listed(config, self, components)},
          description{described(config, self, listed_components, options)},
          presences(places),
          lists(8 * (places + listed_components.size() + 1) + 32 * 256), // see node_manager_memory
          report(3 * 4096 + 4 * (places + listed_components.size())), // packet, answer and 4 bytes for each listed one
          manager{self,
                  description,
                  {presences, lists, report},
                  {.beat = options.beat,
                   .timeout = options.timeout,
                   .appeared = changes.appeared,
                   .disappeared = changes.disappeared}},
          events{self, manager, jaus::bound<&parts::answer_query>(*this)},
          core{self, memory, {}, {}, manager, events.part} {
        core.change(jaus::state_event::initialized);
    }
    parts(const parts&) = delete;
    parts& operator=(const parts&) = delete;

    jaus::message_outcome operator()(const jaus::header&, std::span<const std::byte>) const noexcept {
        return jaus::message_outcome::unhandled;
    }
    jaus::message_outcome answer_query(const jaus::header& query, std::span<const std::byte> body, time_point now,
                                       jaus::message_sink out) {
        return core.answer_query(query, body, now, out);
    }
    // As a component: the core, and the events of its changes.
    [[nodiscard]] const jaus::address& self() const noexcept { return core.self(); }
    jaus::component_outcome on_message(const jaus::header& head, std::span<const std::byte> body, time_point now,
                                       jaus::message_sink out, attached_component::unhandled rest) {
        const auto outcome = core.on_message(head, body, now, out, rest);
        events.part.look(now, out);
        return outcome;
    }
    void on_time(time_point now, jaus::message_sink out) {
        core.on_time(now, out);
        events.part.look(now, out);
    }
    [[nodiscard]] std::optional<time_point> next_event() const noexcept { return core.next_event(); }
    void on_lost(const jaus::address& who) { core.on_lost(who); }
    static std::vector<jaus::configured_component> listed(const jaus_config& config, const jaus::address& self,
                                                          std::span<const jaus::address> components) {
        std::vector<jaus::configured_component> all;
        const auto add = [&](const jaus::address& id) {
            if (id.subsystem == self.subsystem && id.node == self.node && id != self)
                all.push_back({id.component, id.instance});
        };
        for (const auto& id : components) add(id);
        for (const auto& system : config.systems)
            for (const auto& entry : system.components) add(entry.id);
        return all;
    }
    static jaus::node_description described(const jaus_config& config, const jaus::address& self,
                                            std::span<const jaus::configured_component> components,
                                            const jaus_node_options& options) {
        jaus::node_description made{.components = components};
        const auto& me = config.me();
        made.subsystem.type = static_cast<std::uint16_t>(options.type.value_or(me.type));
        made.system.identification = made.subsystem.identification = made.node.identification = in_report(me.name);
        made.manager.identification = "node manager";
        for (const auto& node : me.nodes)
            if (node.id == self.node && !node.name.empty()) made.node.identification = in_report(node.name);
        made.manager = identity_of(config, self, made.manager);
        return made;
    }

    std::vector<jaus::configured_component> listed_components;
    jaus::node_description description;
    std::vector<jaus::liveness_table::place> presences;
    std::vector<std::byte> lists, report;
    jaus::node_manager manager;
    configuration_events events;
    jaus::component_memory<> memory{};

    jaus::component<jaus::node_manager, core_subscriptions> core;
};

JAUSCAT_DECL own_manager::own_manager(const jaus_config& config, const jaus::address& self,
                                      std::span<const jaus::address> components, const jaus_node_options& options,
                                      presence_changes& changes)
    : parts_{std::make_unique<parts>(config, self, components, options, changes)} {}
JAUSCAT_DECL own_manager::~own_manager() = default;

JAUSCAT_DECL attached_component own_manager::component() noexcept { return {*parts_, *parts_}; }
JAUSCAT_DECL const jaus::liveness_table& own_manager::present() const noexcept { return parts_->manager.present(); }
JAUSCAT_DECL void own_manager::tell_change(const jaus::address& who, time_point now, jaus::message_sink out) {
    if (who.subsystem == parts_->core.self().subsystem) parts_->events.changed(now, out);
}
JAUSCAT_DECL jaus::address own_manager::gone_with(const jaus::address& who) const noexcept {
    const bool is_own = who.subsystem == parts_->core.self().subsystem;
    bool of_subsystem = is_own, of_node = is_own;
    present().for_each([&](const jaus::address& other) {
        of_subsystem = of_subsystem || other.subsystem == who.subsystem;
        of_node = of_node || (other.subsystem == who.subsystem && other.node == who.node);
    });
    if (!of_subsystem) return {255, 255, 255, who.subsystem};
    return jaus::is_node_manager(who) || !of_node ? jaus::address{255, 255, who.node, who.subsystem} : who;
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::net::detail
