// The reader of JausConfig.xml, see read_jaus_config.hpp.
#pragma once
#include <jauscat/net/config/config_ethercat.hpp>
#include <jauscat/net/config/config_sae.hpp>
#include <jauscat/net/config/detail/config_values.hpp>
#include <jauscat/net/config/read_jaus_config.hpp>

#include <array>
#include <bit>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <unordered_map>

namespace jauscat::net {

namespace detail {

class config_reader {
  public:
    explicit config_reader(const config_source& source) : source_{source}, config_{.source = source.name()} {}

    jaus_config read() {
        const auto root = source_.root();
        if (!is_root_name(root.name()))
            source_.fail(config_errc::wrong_root, root,
                         "the root element is <" + std::string{root.name()} + ">; it must be <jausconfig>");
        if (root.next_sibling())
            source_.fail(config_errc::unexpected, root.next_sibling(), "something follows </jausconfig>; remove it");

        std::array values{config_value{"thissystem"}};
        source_.collect(root, values, {"system"});
        for (const auto node : root.children("system"))
            source_.attempt([&] { config_.systems.push_back(system(node)); });
        if (!root.child("system"))
            source_.note(config_errc::missing, "system", source_.line_of(root),
                         "no <system>; give at least one, with <name>, <jausip>, <ip> and <port>");

        if (!source_.has_problems()) {
            check_ethercat(source_, config_);
            check_sae(source_, config_);
        }
        const auto& this_system = values[0];
        if (!this_system.given)
            source_.note(config_errc::missing, "thissystem", source_.line_of(root),
                         "no <thissystem>; name there the <system> that this program is");
        else if (!source_.has_problems() && !config_.find(this_system.text))
            source_.note(config_errc::no_such_system, this_system, no_such_system(config_, this_system.text));
        source_.finish();
        config_.this_system = this_system.text;
        return std::move(config_);
    }

  private:
    static bool is_root_name(std::string_view name) {
        const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
        return std::ranges::equal(name, std::string_view{"jausconfig"}, {}, lower);
    }

    system_entry system(pugi::xml_node node) {
        std::array values{config_value{"name"}, config_value{"jausip"},  config_value{"ip"},
                          config_value{"port"}, config_value{"framing"}, config_value{"sourceport"},
                          config_value{"type"}};
        auto& [name, jausip, ip, port, framing, source_port, type] = values;
        std::vector<config_value> ips;
        source_.collect(node, values, {"multicast", "limits", "ethercat", "node", "component", "sae"}, "ip", &ips);
        if (!ips.empty()) ip = ips.front();
        source_.need(node, {name});
        const bool has_ra = jausip.given || !node.child("sae");
        if (has_ra) source_.need(node, {jausip, ip, port});
        constexpr std::array framings{jaus::framing::bare, jaus::framing::jaus01, jaus::framing::judp1};
        using enum jaus::subsystem_type;
        constexpr std::array types{other, vehicle, operator_control_unit};
        system_entry made{.name = unique_name(name),
                          .jausip = has_ra ? unique_jausip(jausip) : jaus::address{},
                          .ip = config_ip(source_, ip),
                          .port = port_of(port),
                          .framing = framings[config_one_of(source_, framing, {"bare", "JAUS01.0", "judp1"})],
                          .type = types[config_one_of(source_, type, {"other", "vehicle", "operator"})],
                          .line = source_.line_of(node),
                          .has_ra = has_ra};
        for (const auto& more : std::span{ips}.subspan(ips.empty() ? 0 : 1)) add_ip(made, more);
        made.any_source_port = config_choice(source_, source_port, "same", "any");
        source_.attempt([&] {
            if (const auto child = source_.only_child(node, "multicast")) made.multicast = multicast(child, made, {});
        });
        source_.attempt([&, &host = ip, &at_port = port] { // clang 14 captures no structured binding
            if (const auto child = source_.only_child(node, "sae"))
                made.sae = config_sae(source_, child, host, at_port,
                                      [&](pugi::xml_node group) { return multicast(group, made, judp_multicast()); });
        });
        if (made.sae) check_sae_of(made, node);
        source_.attempt([&] {
            if (const auto child = source_.only_child(node, "limits")) made.limits = limits(child);
        });
        if (has_ra && made.jausip == jaus::address{} && jausip.text != "0.0.0.0")
            return made; // what follows is relative to it
        source_.attempt([&] {
            if (const auto child = source_.only_child(node, "ethercat"))
                made.ethercat = config_ethercat(source_, child, made);
        });
        for (const auto child : node.children("node")) source_.attempt([&] { add_node(made, child); });
        const std::uint8_t own_node = made.jausip.node == 0 ? std::uint8_t{1} : made.jausip.node;
        for (const auto child : node.children("component"))
            source_.attempt([&] { add_component(made, child, own_node); });
        return made;
    }

    std::string unique_name(const config_value& value) const {
        if (const auto* taken = config_.find(value.text))
            source_.note(config_errc::duplicate, value,
                         "the name " + quoted(value.text) + " is taken by the <system> in line " +
                             std::to_string(taken->line) + "; give each its own");
        return std::string{value.text};
    }

    jaus::address unique_jausip(const config_value& value) const {
        const auto id = parse_jausip(value.text);
        if (!id || std::max({id->subsystem, id->node, id->component, id->instance}) > 254) {
            source_.note(config_errc::invalid_value, value,
                         "jausip " + quoted(value.text) +
                             " is not subsystem.node.component.instance, each 0 (all) to 254, such as 1.0.0.0");
            return {};
        }
        const auto taken = std::ranges::find_if(
            config_.systems, [&](const system_entry& other) { return other.has_ra && other.jausip == *id; });
        if (taken != config_.systems.end())
            source_.note(config_errc::duplicate, value,
                         "the jausip " + to_jausip(*id) + " is taken by the <system> in line " +
                             std::to_string(taken->line) + "; give each its own");
        return *id;
    }

    std::uint16_t port_of(const config_value& value) const {
        return config_number<std::uint16_t>(source_, value, 1, 65535, "a UDP port");
    }
    std::uint8_t id_of(const config_value& value, std::string_view what) const {
        return config_number<std::uint8_t>(source_, value, 1, 254, what);
    }

    void add_ip(system_entry& entry, const config_value& value) const {
        auto address = config_ip(source_, value);
        if (address == entry.ip || std::ranges::find(entry.more_ips, address) != entry.more_ips.end())
            source_.note(config_errc::duplicate, value,
                         "ip " + address.to_string() + " is given twice in <system>; keep one");
        if (entry.more_ips.size() + 1 == system_entry::max_ips)
            return source_.note(config_errc::too_many, value,
                                "a <system> has at most " + std::to_string(system_entry::max_ips) + " <ip>");
        entry.more_ips.push_back(std::move(address));
    }

    multicast_options multicast(pugi::xml_node node, const system_entry& entry, multicast_options made) const {
        std::array values{config_value{"group"}, config_value{"port"}, config_value{"ttl"}, config_value{"interface"},
                          config_value{"loop"}};
        source_.collect(node, values);
        const auto& [group, port, ttl, interface_name, loop] = values;
        const auto example = made.group.to_string();
        if (group.given) made.group = config_ip(source_, group, example);
        if (!made.group.is_multicast())
            source_.note(config_errc::invalid_value, group,
                         "group " + quoted(group.text) + " is no multicast group, such as " + example);
        if (made.group.is_v6() != entry.ip.is_v6())
            source_.note(config_errc::inconsistent, group.name, group.given ? group.line : source_.line_of(node),
                         "the group " + made.group.to_string() + " and the ip " + entry.ip.to_string() +
                             " are of different IP versions; give a group of the other, such as " +
                             (entry.ip.is_v6() ? "ff15::e001:1" : example));
        made.port = config_number_or<std::uint16_t>(source_, port, made.port, 1, 65535, "a UDP port");
        made.ttl = config_number_or<std::uint8_t>(source_, ttl, made.ttl, 0, 255, "a number of hops");
        made.interface_name = interface_name.text;
        made.loop = !loop.given || config_choice(source_, loop, "no", "yes");
        return made;
    }

    // What is of the RA, and what another system has.
    void check_sae_of(const system_entry& entry, pugi::xml_node node) const {
        const auto& mine = *entry.sae;
        if (mine.judp && entry.ip.is_v6())
            source_.note(config_errc::inconsistent, "judp", mine.line,
                         "<judp> needs an IPv4 address, and the ip " + entry.ip.to_string() + " is of IPv6");
        if (!entry.has_ra)
            for (const char* const name : {"multicast", "ethercat", "node", "component"})
                if (const auto child = node.child(name))
                    source_.note(config_errc::inconsistent, child,
                                 '<' + std::string{name} + "> of a <system> without jausip has no use" +
                                     (child == node.child("multicast") ? "; put it into <judp>, or give a jausip"
                                                                       : "; give a jausip"));
        if (mine.id == sae::jaus_id{}) return; // noted before
        for (const auto& other : config_.systems)
            if (other.sae && other.sae->id == mine.id)
                source_.note(config_errc::duplicate, "id", mine.line,
                             "the id " + std::string{sae::jaus_id_text{mine.id}.view()} +
                                 " is taken by the <sae> in line " + std::to_string(other.sae->line) +
                                 "; give each its own");
    }

    system_limits limits(pugi::xml_node node) const {
        std::array values{config_value{"rate"}, config_value{"burst"}, config_value{"largedata"}};
        source_.collect(node, values);
        const auto& [per_second, burst, large_data] = values;
        system_limits made;
        auto& [messages, memory] = made;
        messages.per_second =
            config_number_or<std::uint32_t>(source_, per_second, messages.per_second, 0, 1'000'000'000,
                                            "a number of messages each second (0: no limit)");
        messages.burst = config_number_or<std::uint32_t>(source_, burst, messages.burst, 1, 1'000'000'000,
                                                         "a number of messages at once");
        memory =
            config_number_or<std::size_t>(source_, large_data, memory, 0, std::size_t{1} << 30U, "a number of bytes");
        return made;
    }

    void add_node(system_entry& entry, pugi::xml_node node) {
        std::array values{config_value{"id"}, config_value{"name"}};
        source_.collect(node, values, {"component"});
        const auto& [id, name] = values;
        source_.need(node, {id});
        const node_entry made{
            .id = id_of(id, "a node's ID"), .name = std::string{name.text}, .line = source_.line_of(node)};
        const auto taken = std::ranges::find(entry.nodes, made.id, &node_entry::id);
        if (taken != entry.nodes.end())
            source_.note(config_errc::duplicate, id,
                         "the node " + std::to_string(made.id) + " is taken by the <node> in line " +
                             std::to_string(taken->line) + "; put all its components there");
        if (entry.jausip.node != 0 && entry.jausip.node != made.id)
            source_.note(config_errc::inconsistent, id,
                         "the node " + std::to_string(made.id) + " is outside of its system's jausip " +
                             to_jausip(entry.jausip));
        entry.nodes.push_back(made);
        for (const auto child : node.children("component")) add_component(entry, child, made.id);
    }

    void add_component(system_entry& entry, pugi::xml_node node, std::uint8_t of_node) {
        std::array values{config_value{"id"}, config_value{"instance"}, config_value{"name"}, config_value{"authority"},
                          config_value{"slaves"}};
        source_.collect(node, values);
        const auto& [id, instance, name, authority, slaves] = values;
        const auto line = source_.line_of(node);
        source_.need(node, {id});
        component_entry made{.id = {.instance = instance.given ? id_of(instance, "an instance's ID") : std::uint8_t{1},
                                    .component = id_of(id, "a component's ID"),
                                    .node = of_node,
                                    .subsystem = entry.jausip.subsystem},
                             .name = std::string{name.text},
                             .line = line};
        made.authority = config_number_or<std::uint8_t>(source_, authority, 0, 0, 255, "an authority code");
        made.slaves = slaves_of(entry, slaves);
        if (entry.jausip.subsystem == 0)
            source_.note(config_errc::inconsistent, node,
                         "a <system> with components needs a jausip that names its subsystem, such as 1.0.0.0");
        if (!covers(entry.jausip, made.id))
            source_.note(config_errc::inconsistent, node,
                         "the component " + to_jausip(made.id) + " is outside of its system's jausip " +
                             to_jausip(entry.jausip));
        const auto [taken, is_new] = component_lines_.emplace(std::bit_cast<std::uint32_t>(made.id), line);
        if (!is_new)
            source_.note(config_errc::duplicate, node,
                         "the component " + to_jausip(made.id) + " is taken by the <component> in line " +
                             std::to_string(taken->second) + "; give each its own id or instance");
        entry.components.push_back(std::move(made));
    }

    // Names of slaves of the system, separated by blanks.
    std::vector<std::string> slaves_of(const system_entry& entry, const config_value& value) const {
        std::vector<std::string> made;
        std::istringstream names{std::string{value.text}};
        for (std::string name; names >> name;) {
            if (!entry.ethercat || entry.ethercat->find(name) == nullptr)
                source_.note(config_errc::inconsistent, value,
                             "there is no <slave> " + quoted(std::string_view{name}) +
                                 " in the <ethercat> of this <system>");
            if (std::ranges::find(made, name) != made.end())
                source_.note(config_errc::duplicate, value,
                             "the slave " + quoted(std::string_view{name}) + " is given twice; keep one");
            made.push_back(name);
        }
        if (value.given && made.empty())
            source_.note(config_errc::missing, value, "slaves names no <slave>; name one, or remove it");
        return made;
    }

    const config_source& source_;
    jaus_config config_;
    std::unordered_map<std::uint32_t, std::size_t> component_lines_{}; ///< by the address
};

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL jaus_config parse_jaus_config(std::string_view text, std::string source) {
    const detail::config_source parsed{text, std::move(source)};
    return detail::config_reader{parsed}.read();
}

JAUSCAT_DECL jaus_config read_jaus_config(const std::filesystem::path& path) {
    std::ifstream file{path, std::ios::binary};
    file.peek(); // a directory can be opened, and fails here
    if (!file && !file.eof())
        throw config_error{config_errc::unreadable,
                           {},
                           0,
                           path.string() + ": cannot be read: " + std::generic_category().message(errno) +
                               "; give the path of a JausConfig.xml, such as examples/JausConfig.xml"};
    std::ostringstream text;
    text << file.rdbuf();
    return parse_jaus_config(text.str(), path.string());
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::net
