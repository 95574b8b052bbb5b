// Which EtherCAT medium a node uses, and which translation table.
#pragma once
#include "support/program.hpp"
#include <jauscat/schema/translation/self_contained_table.hpp>

namespace example {

inline void add_link_options(boost::program_options::options_description& options) {
    namespace po = boost::program_options;
    // clang-format off
    options.add_options()
        ("link", po::value<std::string>()->default_value("udp"), "EtherCAT medium: udp or raw")
        ("interface", po::value<std::string>(), "network interface of --link raw, for example eth0")
        ("ethercat-host", po::value<std::string>()->default_value("127.0.0.1"), "where the slave is, for --link udp")
        ("ethercat-port", po::value<std::uint16_t>()->default_value(jauscat::net::udp_link::ethercat_port),
         "UDP port of the slave, for --link udp")
        ("table", po::value<std::string>()->default_value("seed"), "translation table: seed or self-contained");
    // clang-format on
}

enum class link_end { master, slave };

/// Opens the link that the options choose and hands it to `use`.
int with_link(const boost::program_options::variables_map& values, link_end end, auto&& use) {
    const auto& kind = values["link"].as<std::string>();
    if (kind == "raw") {
        if (values.count("interface") == 0) throw usage_error{"--link raw needs --interface NAME"};
        jauscat::net::raw_link link{values["interface"].as<std::string>()};
        return use(link, "raw Ethernet on " + values["interface"].as<std::string>());
    }
    if (kind != "udp") throw usage_error{"--link must be udp or raw, not '" + kind + "'"};
    const auto port = values["ethercat-port"].as<std::uint16_t>();
    const auto& host = values["ethercat-host"].as<std::string>();
    auto link = end == link_end::slave ? jauscat::net::udp_link::serve(port, host)
                                       : jauscat::net::udp_link::connect(host, port);
    return use(link, "EtherCAT in UDP, " + host + ":" + std::to_string(port));
}

/// Calls `use` with the translation table that the options choose.
int with_table(const boost::program_options::variables_map& values, auto&& use) {
    const auto& name = values["table"].as<std::string>();
    if (name == "seed") return use.template operator()<jauscat::translation::seed_table>();
    if (name == "self-contained") return use.template operator()<jauscat::translation::self_contained_table>();
    throw usage_error{"--table must be seed or self-contained, not '" + name + "'"};
}

} // namespace example
