// Which EtherCAT medium a node uses, and which translation table.
#pragma once
#include "support/program.hpp"
#include "support/robot_messages.hpp"
#include <jauscat/net/link/any_link.hpp>
#include <jauscat/net/link/drop_privileges.hpp>
#include <jauscat/net/link/udp_link.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>
#include <jauscat/translate/fixed_length.hpp>

#include <memory>

namespace example {

/// The options of `with_table`.
inline void add_table_options(boost::program_options::options_description& options) {
    namespace po = boost::program_options;
    // clang-format off
    options.add_options()
        ("table", po::value<std::string>()->default_value("seed"), "translation table: seed or self-contained")
        ("index-base", po::value<std::string>()->default_value("6900"),
         "object index of component 0: 6900, 0x2000 (manufacturer specific; for slaves that refuse writes to PDO "
         "mapping objects) or 0x6900; controller and arm must agree")
        ("fixed-length", po::bool_switch(),
         "pad every object to one size, for slaves that accept exact sizes only; controller and arm must agree");
    // clang-format on
}

/// The options of `with_link`.
inline void add_medium_options(boost::program_options::options_description& options) {
    namespace po = boost::program_options;
    // clang-format off
    options.add_options()
        ("link", po::value<std::string>()->default_value("udp"), "EtherCAT medium: udp or raw")
        ("interface", po::value<std::string>(), "network interface of --link raw, for example eth0")
        ("ethercat-host", po::value<std::string>()->default_value("127.0.0.1"), "host of the slave, for --link udp")
        ("ethercat-port", po::value<std::uint16_t>()->default_value(jauscat::net::udp_link::ethercat_port),
         "UDP port of the slave, for --link udp");
    // clang-format on
}

inline void add_link_options(boost::program_options::options_description& options) {
    add_medium_options(options);
    add_table_options(options);
}

enum class link_end { master, slave };
enum class privileges { dropped, kept };

/// A link, and what to say of it.
struct opened_link {
    std::unique_ptr<jauscat::net::any_link> link{};
    std::string where{};
    bool is_raw{}; ///< it took privileges to open it
};

/// A link as jauscat::bus has it: "udp:HOST:PORT", or the name of a network interface.
inline std::string udp_link_name(const std::string& host, std::uint16_t port) {
    return "udp:" + (host.find(':') == host.npos ? host : "[" + host + "]") + ":" + std::to_string(port);
}
/// The one that the options choose.
inline std::string link_name(const boost::program_options::variables_map& values) {
    const auto& kind = values["link"].as<std::string>();
    if (kind != "raw" && kind != "udp") throw usage_error{"--link must be udp or raw, not '" + kind + "'"};
    if (kind == "raw" && values.count("interface") == 0) throw usage_error{"--link raw needs --interface NAME"};
    if (kind == "raw") return values["interface"].as<std::string>();
    return udp_link_name(values["ethercat-host"].as<std::string>(), values["ethercat-port"].as<std::uint16_t>());
}
inline bool is_raw_link(const std::string& name) { return !name.starts_with("udp:"); }
/// The link for an operator.
inline std::string describe_link(const std::string& name) {
    return is_raw_link(name) ? "raw Ethernet on " + name : "EtherCAT in UDP, " + name.substr(name.find(':') + 1);
}

/// The link that the options choose.
inline opened_link open_link(const boost::program_options::variables_map& values, link_end end) {
    using jauscat::net::udp_link;
    const auto name = link_name(values);
    opened_link opened{.where = describe_link(name), .is_raw = is_raw_link(name)};
    if (opened.is_raw || end == link_end::master)
        opened.link = jauscat::net::open_link(name);
    else
        opened.link = std::make_unique<jauscat::net::held_link<udp_link>>(
            udp_link::serve(values["ethercat-port"].as<std::uint16_t>(), values["ethercat-host"].as<std::string>()));
    return opened;
}

/// Permanently drops the privileges for raw Ethernet. Call before threads are started.
inline void give_up_privileges() {
    if (const auto dropped = jauscat::net::drop_privileges(); !dropped)
        throw std::runtime_error{dropped.error().message};
}

/// Opens the link that the options choose and hands it to `use(any_link&, const std::string& where)`, after giving up
/// what raw Ethernet needs, unless something else needs it later.
int with_link(const boost::program_options::variables_map& values, link_end end, auto&& use,
              privileges after = privileges::dropped) {
    const auto opened = open_link(values, end);
    if (opened.is_raw && after == privileges::dropped) give_up_privileges();
    return use(*opened.link, opened.where);
}

/// Calls `use` with the translation table that the options choose.
int with_table(const boost::program_options::variables_map& values, auto&& use) {
    namespace t = jauscat::translation;
    const auto& base = values["index-base"].as<std::string>();
    const auto with_lengths = [&]<class Table>() -> int {
        if (!values["fixed-length"].as<bool>()) return use.template operator()<Table>();
        return use.template operator()<jauscat::translate::fixed_length<Table, robot_messages>>();
    };
    const auto with_base = [&]<class Seeds, class Manufacturers, class Profiles>() -> int {
        if (base == "6900") return with_lengths.template operator()<Seeds>();
        if (base == "0x2000") return with_lengths.template operator()<Manufacturers>();
        if (base == "0x6900") return with_lengths.template operator()<Profiles>();
        throw usage_error{"--index-base must be 6900, 0x2000 or 0x6900, not '" + base + "'"};
    };
    const auto& name = values["table"].as<std::string>();
    if (name == "seed")
        return with_base.template operator()<t::seed_table, t::seed_table_at_2000h, t::seed_table_at_6900h>();
    if (name == "self-contained")
        return with_base.template
        operator()<t::self_contained_table, t::self_contained_table_at_2000h, t::self_contained_table_at_6900h>();
    throw usage_error{"--table must be seed or self-contained, not '" + name + "'"};
}

} // namespace example
