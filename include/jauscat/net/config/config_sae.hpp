// <sae> of a configuration file: JAUS IDs and media of a system of SAE JAUS.
#pragma once

#include <jauscat/net/config/detail/config_values.hpp>
#include <jauscat/net/config/jaus_config.hpp>

#include <array>
#include <sstream>
#include <string>

namespace jauscat::net::detail {

/// Notes that a medium lacks a value of the <system> around.
inline void need_of_system(const config_source& source, pugi::xml_node medium, const config_value& value) {
    if (!value.given)
        source.note(config_errc::missing, value.name, source.line_of(medium),
                    '<' + std::string{medium.name()} + "> needs <" + std::string{value.name} + "> in its <system>");
}

inline sae::jaus_id config_jaus_id(const config_source& source, const config_value& value) {
    const auto id = sae::parse_jaus_id(value.text);
    if (id && id->subsystem != 0 && !sae::has_wildcard(*id) && (id->node != 0 || id->component == 0)) return *id;
    source.note(config_errc::invalid_value, value,
                "id " + quoted(value.text) +
                    " is not subsystem.node.component, such as 126.1.10, or 126.1.0 or 126.0.0 for all of that level:"
                    " subsystem 1 to 65534, the others to 254");
    return {};
}

inline jtcp_entry config_jtcp(const config_source& source, pugi::xml_node node) {
    std::array values{config_value{"listen"}, config_value{"connect"}};
    source.collect(node, values);
    const auto& [listen, connect] = values;
    jtcp_entry made;
    if (listen.given) made.listen = config_number<std::uint16_t>(source, listen, 1, 65535, "a TCP port");
    std::istringstream names{std::string{connect.text}};
    for (std::string name; names >> name;) {
        if (std::ranges::find(made.connect, name) != made.connect.end())
            source.note(config_errc::duplicate, connect,
                        "the system " + quoted(std::string_view{name}) + " is given twice in connect; keep one");
        made.connect.push_back(name);
    }
    if (!listen.given && made.connect.empty())
        source.note(config_errc::missing, node,
                    "<jtcp> has no use; give listen, the port at which it accepts connections, or connect, the names of"
                    " systems");
    return made;
}

inline jserial_entry config_jserial(const config_source& source, pugi::xml_node node) {
    std::array values{config_value{"device"}, config_value{"baud"}};
    source.collect(node, values);
    const auto& [device, baud] = values;
    source.need(node, {device});
    jserial_entry made{.device = std::string{device.text}};
    made.baud = config_number_or<std::uint32_t>(source, baud, made.baud, 50, 4'000'000, "a number of bits each second");
    return made;
}

/// Reads the entry of a system. `group` reads a <multicast> of <judp>; `ip` and `port` are those of the system.
inline sae_entry config_sae(const config_source& source, pugi::xml_node node, const config_value& ip,
                            const config_value& port, auto&& group) {
    std::array values{config_value{"id"}};
    source.collect(node, values, {"judp", "jtcp", "jserial"});
    const auto& id = values[0];
    source.need(node, {id});
    sae_entry made{.id = config_jaus_id(source, id), .line = source.line_of(node)};
    const auto medium = [&](const char* name, auto&& read) {
        source.attempt([&] {
            if (const auto child = source.only_child(node, name)) read(child);
        });
    };
    medium("judp", [&](pugi::xml_node child) {
        need_of_system(source, child, ip);
        need_of_system(source, child, port);
        source.collect(child, {}, {"multicast"});
        auto& judp = made.judp.emplace();
        if (const auto multicast = source.only_child(child, "multicast")) judp.group = group(multicast);
    });
    medium("jtcp", [&](pugi::xml_node child) {
        need_of_system(source, child, ip);
        made.jtcp = config_jtcp(source, child);
    });
    medium("jserial", [&](pugi::xml_node child) { made.jserial = config_jserial(source, child); });
    if (!node.child("judp") && !node.child("jtcp") && !node.child("jserial"))
        source.note(config_errc::missing, node, "<sae> has no medium; give <judp/>, <jtcp> or <jserial>");
    return made;
}

/// Checks that need all systems: connections lead to systems that accept them.
inline void check_sae(const config_source& source, const jaus_config& config) {
    for (const auto& system : config.systems) {
        if (!system.sae || !system.sae->jtcp) continue;
        const auto complain = [&](config_errc code, const std::string& text) {
            source.note(code, "connect", system.sae->line, text);
        };
        for (const auto& name : system.sae->jtcp->connect) {
            const auto* const to = config.find(name);
            if (!to)
                complain(config_errc::no_such_system, no_such_system(config, name));
            else if (to == &system)
                complain(config_errc::inconsistent, "the system " + quoted(std::string_view{name}) +
                                                        " connects to itself; remove it from connect");
            else if (!to->sae || !to->sae->jtcp || !to->sae->jtcp->listen)
                complain(config_errc::inconsistent,
                         "the system " + quoted(std::string_view{name}) +
                             " accepts no connections; give it <sae> with <jtcp listen=...>");
        }
    }
}

} // namespace jauscat::net::detail
