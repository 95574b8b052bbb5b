// <ethercat> of a configuration file: the EtherCAT master of a system.
#pragma once

#include <jauscat/net/config/config_slaves.hpp>
#include <jauscat/net/config/detail/config_values.hpp>
#include <jauscat/net/config/jaus_config.hpp>

#include <array>

namespace jauscat::net::detail {

/// Parses `interface`: the name of a network interface, or `udp:HOST:PORT`.
inline void config_interface(const config_source& source, const config_value& value, ethercat_entry& made) {
    constexpr std::size_t longest_name = 15; // IFNAMSIZ without its end
    constexpr std::string_view udp = "udp:";
    if (value.text.starts_with(udp)) {
        const auto colon = value.text.rfind(':');
        const auto port = value.text.substr(colon + 1);
        if (colon > udp.size()) {
            made.udp_host = value.text.substr(udp.size(), colon - udp.size());
            made.udp_port = config_number<std::uint16_t>(source, {"port of the interface", port, value.line, true}, 1,
                                                         65535, "a UDP port");
            return;
        }
    } else if (value.text.size() <= longest_name && value.text.find_first_of(" \t\r\n/:") == value.text.npos) {
        made.interface_name = value.text;
        return;
    }
    source.fail(config_errc::invalid_value, value,
                "interface " + quoted(value.text) + " is neither a network interface, such as eth0, nor udp:HOST:PORT");
}

/// Reads the entry of `system`. Its other values must have been read.
inline ethercat_entry config_ethercat(const config_source& source, pugi::xml_node node, const system_entry& system) {
    std::array values{config_value{"controller"}, config_value{"interface"}};
    source.collect(node, values, {"slave"});
    const auto& [controller, interface_name] = values;
    source.need(node, {interface_name});
    const auto line = source.line_of(node);
    if (system.jausip.subsystem == 0 || system.jausip.node == 0)
        source.note(config_errc::inconsistent, node,
                    "the jausip " + to_jausip(system.jausip) +
                        " of a <system> with <ethercat> must name its node, such as 2.2.0.0: the slave has its "
                        "number as station address");
    ethercat_entry made{.controller = controller.given ? std::string{controller.text} : system.name, .line = line};
    source.attempt([&, &name = interface_name] { config_interface(source, name, made); });
    made.slaves = config_slaves(source, node);
    return made;
}

/// Checks that need all systems: each controller exists, and has a different interface for each master.
inline void check_ethercat(const config_source& source, const jaus_config& config) {
    for (const auto& system : config.systems) {
        if (!system.ethercat) continue;
        const auto& mine = *system.ethercat;
        if (!config.find(mine.controller))
            source.note(config_errc::no_such_system, "controller", mine.line, no_such_system(config, mine.controller));
        for (const auto& other : config.systems) {
            if (&other == &system) break;
            if (other.ethercat && other.ethercat->controller == mine.controller && other.ethercat->same_wire(mine))
                source.note(config_errc::duplicate, "interface", mine.line,
                            "the interface is that of the <ethercat> in line " + std::to_string(other.ethercat->line) +
                                "; give each master its own");
        }
    }
}

} // namespace jauscat::net::detail
