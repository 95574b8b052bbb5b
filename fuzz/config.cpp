// JausConfig.xml: any text is a configuration or one error with its place, and a configuration can be written again.
#include "support/target.hpp"
#include <jauscat/net/config/read_jaus_config.hpp>

#include <iomanip>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>

using namespace fuzz;
using namespace jauscat;

namespace {

std::optional<net::jaus_config> parsed(const std::string& text) {
    try {
        return net::parse_jaus_config(text, "fuzz.xml");
    } catch (const net::config_error& error) {
        const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
        check(error.line() >= 1 && error.line() <= lines, "an error names a line of the file");
        check(std::string{error.what()}.starts_with("fuzz.xml:" + std::to_string(error.line()) + ": "),
              "an error starts with file and line");
        return {};
    }
}

void set(pugi::xml_node node, const char* name, const auto& value) { node.append_attribute(name) = value; }

void write_component(pugi::xml_node into, const net::component_entry& component) {
    auto node = into.append_child("component");
    set(node, "id", static_cast<unsigned>(component.id.component));
    set(node, "instance", static_cast<unsigned>(component.id.instance));
    set(node, "name", component.name.c_str());
    set(node, "authority", static_cast<unsigned>(component.authority));
    std::string slaves;
    for (const auto& name : component.slaves) slaves += name + ' ';
    if (!slaves.empty()) set(node, "slaves", slaves.c_str());
}

void write_slave(pugi::xml_node node, const net::slave_entry& slave) {
    set(node, "name", slave.name.c_str());
    const auto set_number = [&](const char* name, const auto& value) {
        if (value) set(node, name, static_cast<unsigned>(*value));
    };
    set_number("position", slave.position);
    set_number("alias", slave.alias);
    set_number("identification", slave.identification);
    set_number("vendor", slave.vendor);
    set_number("product", slave.product);
    set_number("revision", slave.revision);
    set_number("serial", slave.serial);
    if (!slave.esi.empty()) set(node, "esi", slave.esi.c_str());
    set(node, "optional", slave.is_optional ? "yes" : "no");
    for (const auto& sdo : slave.start_up) {
        std::ostringstream octets;
        octets << std::hex << std::setfill('0');
        for (const auto octet : sdo.data) octets << std::setw(2) << std::to_integer<unsigned>(octet);
        auto child = node.append_child("sdo");
        set(child, "index", static_cast<unsigned>(sdo.index));
        set(child, "subindex", static_cast<unsigned>(sdo.subindex));
        set(child, "type", "OCTET_STRING");
        set(child, "value", octets.str().c_str());
    }
}

void write_group(pugi::xml_node into, const std::optional<net::multicast_options>& group) {
    if (!group) return;
    auto child = into.append_child("multicast");
    set(child, "group", group->group.to_string().c_str());
    set(child, "port", static_cast<unsigned>(group->port));
    set(child, "ttl", static_cast<unsigned>(group->ttl));
    set(child, "interface", group->interface_name.c_str());
    set(child, "loop", group->loop ? "yes" : "no");
}

void write_sae(pugi::xml_node node, const net::sae_entry& sae) {
    std::ostringstream id;
    id << sae.id.subsystem << '.' << int{sae.id.node} << '.' << int{sae.id.component};
    set(node, "id", id.str().c_str());
    if (sae.judp) write_group(node.append_child("judp"), sae.judp->group);
    if (sae.jtcp) {
        auto child = node.append_child("jtcp");
        if (sae.jtcp->listen) set(child, "listen", static_cast<unsigned>(*sae.jtcp->listen));
        std::string names;
        for (const auto& name : sae.jtcp->connect) names += name + ' ';
        if (!names.empty()) set(child, "connect", names.c_str());
    }
    if (sae.jserial) {
        auto child = node.append_child("jserial");
        set(child, "device", sae.jserial->device.c_str());
        set(child, "baud", sae.jserial->baud);
    }
}

void write_system(pugi::xml_node node, const net::system_entry& entry) {
    set(node, "name", entry.name.c_str());
    if (entry.has_ra) set(node, "jausip", net::to_jausip(entry.jausip).c_str());
    if (entry.has_ra || !entry.ip.is_unspecified()) set(node, "ip", entry.ip.to_string().c_str());
    if (entry.port != 0) set(node, "port", static_cast<unsigned>(entry.port));
    set(node, "framing", std::string{jaus::name(entry.framing)}.c_str());
    set(node, "sourceport", entry.any_source_port ? "any" : "same");
    for (const auto& ip : entry.more_ips) node.append_child("ip").text() = ip.to_string().c_str();
    write_group(node, entry.multicast);
    if (entry.sae) write_sae(node.append_child("sae"), *entry.sae);
    auto limits = node.append_child("limits");
    set(limits, "rate", entry.limits.messages.per_second);
    set(limits, "burst", entry.limits.messages.burst);
    set(limits, "largedata", std::to_string(entry.limits.large_data_memory).c_str());
    if (const auto& master = entry.ethercat) {
        auto child = node.append_child("ethercat");
        set(child, "controller", master->controller.c_str());
        const auto udp = "udp:" + master->udp_host + ':' + std::to_string(master->udp_port);
        set(child, "interface", master->interface_name.empty() ? udp.c_str() : master->interface_name.c_str());
        for (const auto& slave : master->slaves) write_slave(child.append_child("slave"), slave);
    }
    for (const auto& named : entry.nodes) {
        auto child = node.append_child("node");
        set(child, "id", static_cast<unsigned>(named.id));
        set(child, "name", named.name.c_str());
        for (const auto& component : entry.components)
            if (component.id.node == named.id) write_component(child, component);
    }
    for (const auto& component : entry.components)
        if (std::ranges::find(entry.nodes, component.id.node, &net::node_entry::id) == entry.nodes.end())
            write_component(node, component);
}

std::string written(const net::jaus_config& config) {
    pugi::xml_document document;
    auto root = document.append_child("jausconfig");
    set(root, "thissystem", config.this_system.c_str());
    for (const auto& entry : config.systems) write_system(root.append_child("system"), entry);
    std::ostringstream text;
    document.print(text);
    return text.str();
}

/// Without the lines, and the components in the order of their addresses.
net::system_entry content_of(net::system_entry entry) {
    entry.line = 0;
    if (entry.sae) entry.sae->line = 0;
    if (auto& master = entry.ethercat) {
        master->line = 0;
        for (auto& slave : master->slaves) {
            slave.line = 0;
            for (auto& sdo : slave.start_up) sdo.line = 0;
        }
    }
    for (auto& node : entry.nodes) node.line = 0;
    for (auto& component : entry.components) component.line = 0;
    std::ranges::sort(entry.components, {}, [](const net::component_entry& c) {
        return std::tuple{c.id.node, c.id.component, c.id.instance};
    });
    return entry;
}

void check_usable(const net::jaus_config& config) {
    check(config.find(config.this_system) == &config.me(), "a configuration knows who it is");
    for (const auto& entry : config.systems) {
        check(!entry.name.empty() && (entry.port != 0 || !entry.has_ra), "a system has a name and a port");
        check(entry.has_ra || entry.sae, "a system speaks the RA or SAE JAUS");
        check(config.find(entry.name) == &entry, "a system's name is its own");
        check(config.with_this(entry.name).me().jausip == entry.jausip, "any system can be this one");
        if (!entry.has_ra) continue;
        const auto* hop = config.next_hop(entry.jausip);
        check(hop != nullptr, "a system's own address leads somewhere");
        const auto id = entry.jausip;
        const bool exact = id.subsystem != 0 && id.node != 0 && id.component != 0 && id.instance != 0;
        check(!exact || hop == &entry, "an exact address leads to its system");
    }
}

} // namespace

void fuzz::run(std::span<const std::byte> input) {
    std::string text;
    std::ranges::transform(input, std::back_inserter(text), [](std::byte b) { return static_cast<char>(b); });
    const auto config = parsed(text);
    if (!config) return;
    check_usable(*config);
    const auto again = parsed(written(*config));
    check(again && again->this_system == config->this_system && again->systems.size() == config->systems.size(),
          "a configuration can be written and read again");
    for (std::size_t i = 0; i != config->systems.size(); ++i) {
        check(content_of(config->systems[i]) == content_of(again->systems[i]),
              "a system can be written and read again");
    }
}
