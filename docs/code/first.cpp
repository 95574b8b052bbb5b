// The first program of getting-started.md: a JAUS message made, shown and read.
//     docs_first
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/text/jaus.hpp>

#include <array>
#include <iostream>

namespace jaus = jauscat::jaus;

int main() {
    // Half of the force forward; the other eleven efforts are not part of the message.
    const jaus::set_wrench_effort command{.propulsive_linear_effort_x = 50};
    const jaus::address arm{.instance = 1, .component = 33, .node = 2, .subsystem = 2};
    const jaus::address operator_unit{.instance = 1, .component = 32, .node = 1, .subsystem = 1};

    std::array<std::byte, 64> buffer{};
    const auto message = jaus::make_message({.destination = arm, .source = operator_unit}, command, buffer);
    if (!message) return std::cerr << describe(message.error()) << '\n', 1;
    std::cout << jauscat::text::annotate_message(*message, jaus::message_list<jaus::set_wrench_effort>{});

    // Decoding, as in the arm.
    const auto received = jaus::split(*message);
    jaus::set_wrench_effort effort{};
    if (!received || !jauscat::wire::decode(effort, received.body)) return std::cerr << "not understood\n", 1;
    std::cout << "forward: " << effort.propulsive_linear_effort_x.value_or(0) << " %\n";
}
