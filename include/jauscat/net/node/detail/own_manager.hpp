// The node manager of a node, with its configuration and memory.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/routing/liveness_table.hpp>
#include <jauscat/net/config/jaus_config.hpp>
#include <jauscat/net/config/jaus_node_options.hpp>
#include <jauscat/net/node/detail/attached_component.hpp>
#include <jauscat/net/node/detail/presence_changes.hpp>

#include <memory>
#include <span>

namespace jauscat::net::detail {
inline namespace JAUSCAT_WAY {

/// Starts with the components of this program and those that the configuration lists for the node.
class own_manager {
  public:
    JAUSCAT_DECL own_manager(const jaus_config& config, const jaus::address& self,
                             std::span<const jaus::address> components, const jaus_node_options& options,
                             presence_changes& changes);
    JAUSCAT_DECL ~own_manager();
    own_manager(const own_manager&) = delete;
    own_manager& operator=(const own_manager&) = delete;

    /// Refers to this.
    [[nodiscard]] JAUSCAT_DECL attached_component component() noexcept;
    [[nodiscard]] JAUSCAT_DECL const jaus::liveness_table& present() const noexcept;
    /// Sends the events for the appearance or disappearance of `who`.
    JAUSCAT_DECL void tell_change(const jaus::address& who, time_point now, jaus::message_sink out);
    /// The address range that is lost with `who`; 255 is all of a level: a node with its node manager, and another
    /// subsystem with its last node. Its heartbeats come from one component, often the communicator, and its other
    /// components are not detected.
    [[nodiscard]] JAUSCAT_DECL jaus::address gone_with(const jaus::address& who) const noexcept;

  private:
    struct parts;
    std::unique_ptr<parts> parts_;
};

} // namespace JAUSCAT_WAY
} // namespace jauscat::net::detail
