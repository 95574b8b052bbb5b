// A JAUS component on the machinery below the application API: what examples/primitive_driver.cpp does, with its parts.
//     jaus_node JausConfig.xml b
#include <jauscat/jauscat.hpp>
#include <jauscat/net.hpp>
#include <jauscat/text/jaus.hpp>
#include <jauscat/version.hpp>

#include <boost/asio/signal_set.hpp>

#include <csignal>
#include <iostream>
#include <string_view>

namespace jaus = jauscat::jaus;
namespace net = jauscat::net;
using state = jaus::primary_status_code;

int main(int argc, char** argv) try {
    if (argc == 2 && std::string_view{argv[1]} == "--version")
        return std::cout << "jaus_node (JausCat) " << JAUSCAT_VERSION_TEXT << '\n', 0;
    if (argc != 3) return std::cerr << "jaus_node CONFIGURATION SYSTEM, such as JausConfig.xml b\n", 2;
    boost::asio::io_context context;
    using orders = jaus::message_list<jaus::set_wrench_effort, jaus::query_wrench_effort>;
    net::jaus_node node{context,
                        net::read_jaus_config(argv[1]).with_this(argv[2]),
                        {.log = [](std::string_view line) { std::cout << line << std::endl; },
                         .explain_malformed =
                             [](std::uint16_t code, std::span<const std::byte> body) {
                                 return jauscat::text::why_malformed(code, body, orders{});
                             }}};
    auto self = node.manager();
    self.component = 33; // Primitive Driver

    constexpr auto at_rest = jaus::all_zero<jaus::report_wrench_effort>();
    auto effort = at_rest;
    jaus::dispatcher own{
        jaus::on<jaus::set_wrench_effort>([&](const jaus::header&, const jaus::set_wrench_effort& commanded) {
            jaus::copy_present(commanded, effort); // and set the motors
        }),
        jaus::on<jaus::query_wrench_effort>([&](const jaus::header& head, const jaus::query_wrench_effort& query) {
            auto answer = effort;
            jaus::keep_requested(answer, query.presence_vector);
            const auto sent = node.send({.destination = head.source, .source = self}, answer);
            if (!sent) std::cout << sent.error().message << std::endl;
        })};
    const auto rest = [&](state, state now) {
        if (now != state::ready) effort = at_rest; // standby, emergency, shutdown: motors at rest
    };
    jaus::component_memory<> memory{};
    jaus::component driver{self, memory, {.on_state = rest}, {}};
    node.add(driver, own);
    node.start();
    driver.change(jaus::state_event::initialized); // Ready: obeys from now on

    boost::asio::signal_set signals{context, SIGINT, SIGTERM};
    signals.async_wait([&](auto, int) { node.stop(); });
    context.run();
} catch (const std::exception& e) {
    return std::cerr << "jaus_node: " << e.what() << '\n', 1;
}
