// sae-transport.md: a robot and its operator exchange messages of SAE JAUS. Both nodes run in this program.
// [includes]
#include <jauscat/net.hpp>
#include <jauscat/schema/sae/core/access_control.hpp>
#include <jauscat/wire/wire.hpp>

#include <iostream>

namespace core = jauscat::sae::core;
namespace net = jauscat::net;
namespace sae = jauscat::sae;
// [includes end]

// [main]
int main() try {
    boost::asio::io_context context;
    const auto config = net::read_jaus_config("sae_systems.xml");
    net::sae_node robot{context, config}, ocu{context, config.with_this("operator")};
    robot.start({.on_message = [&](const sae::received_message& m) {
        core::request_control request;
        if (!jauscat::wire::decode(request, m.payload)) return;
        std::cout << "robot: " << sae::jaus_id_text{m.header.source}.view() << " requests control with authority "
                  << int{request.authority_code} << ", by " << robot.place_of(m.from) << '\n';
        static_cast<void>(robot.send({.destination = m.header.source}, core::confirm_control{}));
    }});
    ocu.start({.on_message =
                   [&](const sae::received_message& m) {
                       core::confirm_control reply;
                       if (!jauscat::wire::decode(reply, m.payload)) return;
                       std::cout << "operator: control is granted\n";
                       context.stop();
                   },
               .on_error = [](std::string_view line) { std::cerr << line << '\n'; }});
    const core::request_control request{.authority_code = 200};
    if (const auto sent = ocu.send({.destination = robot.self()}, request); !sent)
        return std::cerr << sent.error().message << '\n', 1;
    context.run_for(std::chrono::seconds{10});
} catch (const std::exception& error) {
    return std::cerr << error.what() << '\n', 1;
}
// [main end]
