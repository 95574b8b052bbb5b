// The node manager of a node, with its configuration and memory.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/jaus/routing/node_manager.hpp>
#include <jauscat/net/config/jaus_node_options.hpp>
#include <jauscat/net/node/detail/configuration_events.hpp>
#include <jauscat/net/node/detail/configured_identity.hpp>
#include <jauscat/net/node/detail/presence_changes.hpp>

#include <span>
#include <vector>

namespace jauscat::net::detail {

/// Starts with the components of this program and those that the configuration lists for the node.
class own_manager {
  public:
    /// Places for detected components; three quarters of them can be used.
    static constexpr std::size_t places = 4096;

    own_manager(const jaus_config& config, const jaus::address& self, std::span<const jaus::address> components,
                const jaus_node_options& options, presence_changes& changes)
        : components_{listed(config, self, components)},
          description_{described(config, self, components_)},
          presences_(places),
          lists_(8 * (places + components_.size() + 1) + 32 * 256), // see node_manager_memory
          report_(3 * 4096 + 4 * (places + components_.size())),    // packet, answer and 4 bytes for each listed one
          manager_{self,
                   description_,
                   {presences_, lists_, report_},
                   {.beat = options.beat,
                    .timeout = options.timeout,
                    .appeared = changes.appeared,
                    .disappeared = changes.disappeared}},
          events_{self, manager_},
          core{self, memory_, {}, {}, manager_, events_.part} {
        core.change(jaus::state_event::initialized);
    }
    own_manager(const own_manager&) = delete;
    own_manager& operator=(const own_manager&) = delete;

    [[nodiscard]] const jaus::liveness_table& present() const noexcept { return manager_.present(); }
    /// Sends the events for the appearance or disappearance of `who`.
    void tell_change(const jaus::address& who, time_point now, jaus::message_sink out) {
        if (who.subsystem == core.self().subsystem) events_.changed(now, out);
    }
    /// The address range that is lost with `who`; 255 is all of a level: a node with its node manager, and another
    /// subsystem with its last node. Its heartbeats come from one component, often the communicator, and its other
    /// components are not detected.
    [[nodiscard]] jaus::address gone_with(const jaus::address& who) const noexcept {
        const bool is_own = who.subsystem == core.self().subsystem;
        bool of_subsystem = is_own, of_node = is_own;
        present().for_each([&](const jaus::address& other) {
            of_subsystem = of_subsystem || other.subsystem == who.subsystem;
            of_node = of_node || (other.subsystem == who.subsystem && other.node == who.node);
        });
        if (!of_subsystem) return {255, 255, 255, who.subsystem};
        return jaus::is_node_manager(who) || !of_node ? jaus::address{255, 255, who.node, who.subsystem} : who;
    }
    jaus::message_outcome operator()(const jaus::header&, std::span<const std::byte>) const noexcept {
        return jaus::message_outcome::unhandled;
    }

  private:
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
                                            std::span<const jaus::configured_component> components) {
        jaus::node_description made{.components = components};
        const auto& me = config.me();
        made.system.identification = made.subsystem.identification = made.node.identification = in_report(me.name);
        made.manager.identification = "node manager";
        for (const auto& node : me.nodes)
            if (node.id == self.node && !node.name.empty()) made.node.identification = in_report(node.name);
        made.manager = identity_of(config, self, made.manager);
        return made;
    }

    std::vector<jaus::configured_component> components_;
    jaus::node_description description_;
    std::vector<jaus::liveness_table::place> presences_;
    std::vector<std::byte> lists_, report_;
    jaus::node_manager manager_;
    configuration_events events_;
    jaus::component_memory<> memory_{};

  public:
    jaus::component<jaus::node_manager, jaus::events<configuration_events::most>> core;
};

} // namespace jauscat::net::detail
