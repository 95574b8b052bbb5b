// JausConfig.xml: any text is a configuration or one error with its place, and a configuration can be written again.
#include "support/target.hpp"
#include <jauscat/net/read_jaus_config.hpp>

#include <optional>
#include <sstream>
#include <string>

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

std::string written(const net::jaus_config& config) {
    pugi::xml_document document;
    auto root = document.append_child("jausconfig");
    root.append_attribute("thissystem") = config.this_system.c_str();
    for (const auto& entry : config.systems) {
        auto node = root.append_child("system");
        node.append_attribute("name") = entry.name.c_str();
        node.append_attribute("jausip") = net::to_jausip(entry.jausip).c_str();
        node.append_attribute("ip") = entry.ip.to_string().c_str();
        node.append_attribute("port") = std::to_string(entry.port).c_str();
        node.append_attribute("framing") = std::string{jaus::name(entry.framing)}.c_str();
    }
    std::ostringstream text;
    document.print(text);
    return text.str();
}

void check_usable(const net::jaus_config& config) {
    check(config.find(config.this_system) == &config.me(), "a configuration knows who it is");
    for (const auto& entry : config.systems) {
        check(!entry.name.empty() && entry.port != 0, "a system has a name and a port");
        check(config.find(entry.name) == &entry, "a system's name is its own");
        check(config.with_this(entry.name).me().jausip == entry.jausip, "any system can be this one");
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
        const auto &ours = config->systems[i], &theirs = again->systems[i];
        check(ours.name == theirs.name && ours.jausip == theirs.jausip && ours.endpoint() == theirs.endpoint() &&
                  ours.framing == theirs.framing,
              "a system can be written and read again");
    }
}
