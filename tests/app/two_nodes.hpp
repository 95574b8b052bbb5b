// Two nodes of one program, which talk over the loopback interface.
#pragma once
#include "support/catch.hpp"
#include "support/free_ports.hpp"
#include "support/until.hpp"
#include <jauscat/app.hpp>

#include <boost/asio/io_context.hpp>

#include <array>
#include <string>
#include <vector>

namespace app_test {

namespace jaus = jauscat::jaus;
using boost::system::error_code;

inline std::string two_systems(const std::array<std::uint16_t, 2>& ports) {
    const auto system = [&](const std::string& name, int subsystem, std::uint16_t port) {
        return "<system><name>" + name + "</name><jausip>" + std::to_string(subsystem) +
               ".0.0.0</jausip><ip>127.0.0.1</ip><port>" + std::to_string(port) + "</port></system>\n";
    };
    return "<jausconfig thissystem='operator'>\n" + system("operator", 1, ports[0]) + system("robot", 2, ports[1]) +
           "</jausconfig>\n";
}

/// Operator 1.1.32.1 and robot 2.1.33.1.
struct two_nodes {
    std::array<std::uint16_t, 2> ports = support::free_ports<2>();
    boost::asio::io_context context{};
    std::vector<std::string> log{};

    jauscat::node_options options(const std::string& name) {
        return {.config_text = two_systems(ports),
                .this_system = name,
                .name = name,
                .log = [this](std::string_view line) { log.emplace_back(line); }};
    }
    bool has_logged(std::string_view part) const {
        for (const auto& line : log)
            if (line.find(part) != std::string::npos) return true;
        return false;
    }
    bool until(auto done) { return support::until(context, done); }
};

struct operator_and_robot : two_nodes {
    jauscat::node mine{context, options("operator")}, robots{context, options("robot")};
    jauscat::component unit{mine, {.id = 32, .name = "operator"}};
    jauscat::component driver{robots, {.id = 33, .name = "Primitive Driver"}};
    jaus::address arm = driver.address();

    void start() {
        robots.start();
        mine.start();
        unit.ready();
    }
};

} // namespace app_test
