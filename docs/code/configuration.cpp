// configuration.md: what a program gets of a JausConfig.xml.
// [includes]
#include <jauscat/net/config/read_jaus_config.hpp>
#include <jauscat/text/jaus.hpp>

#include <iostream>

namespace net = jauscat::net;
// [includes end]

int main() try {
    // [use]
    const auto config = net::read_jaus_config("two_systems.xml");
    std::cout << "this is " << config.me().name << ", at " << config.me().endpoint() << '\n';
    const auto* const way = config.next_hop({.instance = 1, .component = 32, .node = 1, .subsystem = 1});
    if (way != nullptr) std::cout << "messages to 1.1.32.1 go to " << way->name << ", at " << way->endpoint() << '\n';

    const auto as_ocu = config.with_this("ocu"); // the same file, for another program
    std::cout << "this is " << as_ocu.me().name << ", subsystem " << int{as_ocu.me().jausip.subsystem} << '\n';
    // [use end]
    for (const auto* master : net::read_jaus_config("several_masters.xml").masters_of("arm"))
        std::cerr << master->name << ": " << master->ethercat->interface_name << '\n';
} catch (const net::config_error& error) {
    return std::cerr << error.what() << '\n', 1;
}
