// Which component a program is, or talks to, when only a system of the configuration is named.
#pragma once
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/net/config/jaus_config.hpp>

#include <algorithm>

namespace example {

/// The first component that the configuration gives the system, or else its Subsystem Commander (component 32).
inline jauscat::jaus::address component_of(const jauscat::net::system_entry& system) {
    const auto found =
        std::ranges::find_if_not(system.components, jauscat::jaus::is_node_manager, &jauscat::net::component_entry::id);
    if (found != system.components.end()) return found->id;
    auto id = system.jausip;
    if (id.node == 0) id.node = system.nodes.empty() ? std::uint8_t{1} : system.nodes.front().id;
    if (id.component == 0) id.component = 32;
    if (id.instance == 0) id.instance = 1;
    return id;
}

} // namespace example
