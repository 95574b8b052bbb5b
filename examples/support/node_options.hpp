// The options of programs that are JAUS nodes.
#pragma once
#include "support/program.hpp"
#include <jauscat/net/config/read_jaus_config.hpp>

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>

namespace example {

/// The configuration that --config and --this choose.
inline jauscat::net::jaus_config load_config(const boost::program_options::variables_map& values) {
    const auto config = jauscat::net::read_jaus_config(values["config"].as<std::string>());
    return values.count("this") != 0 ? config.with_this(values["this"].as<std::string>()) : config;
}

/// --type: what the subsystem calls itself in Report Identification.
inline void add_type_option(boost::program_options::options_description& options) {
    options.add_options()("type", boost::program_options::value<std::string>(),
                          "what the subsystem is, in its identification: vehicle, operator or other; without, as the "
                          "configuration says");
}
inline std::optional<jauscat::jaus::subsystem_type>
subsystem_type(const boost::program_options::variables_map& values) {
    using enum jauscat::jaus::subsystem_type;
    if (values.count("type") == 0) return {};
    const auto& name = values["type"].as<std::string>();
    if (name == "vehicle") return vehicle;
    if (name == "operator") return operator_control_unit;
    if (name == "other") return other;
    throw usage_error{"--type must be vehicle, operator or other"};
}

/// `2.2.33.1` as an address with all octets given.
inline jauscat::jaus::address parse_address(const std::string& text) {
    unsigned s = 0, n = 0, c = 0, i = 0;
    int used = 0;
    if (std::sscanf(text.c_str(), "%u.%u.%u.%u%n", &s, &n, &c, &i, &used) != 4 ||
        used != static_cast<int>(text.size()) || s < 1 || s > 255 || n < 1 || n > 255 || c < 1 || c > 255 || i < 1 ||
        i > 255)
        throw usage_error{"'" + text + "' is no JAUS ID: write subsystem.node.component.instance, each 1 to 255"};
    return {.instance = static_cast<std::uint8_t>(i),
            .component = static_cast<std::uint8_t>(c),
            .node = static_cast<std::uint8_t>(n),
            .subsystem = static_cast<std::uint8_t>(s)};
}

} // namespace example
