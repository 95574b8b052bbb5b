// Nodes of one host as a network: IPv6, other source ports, relays within a subsystem and between subsystems, and
// several programs at one port.
#include "net/foreign_node.hpp"
#include "net/node_program.hpp"

using namespace net_test;

namespace {

std::string system_at(const std::string& ip, const std::string& name, const std::string& jausip, unsigned port,
                      const std::string& inside = "") {
    return "<system name='" + name + "' jausip='" + jausip + "' ip='" + ip + "' port='" + std::to_string(port) + "'>" +
           inside + "</system>\n";
}

/// How many heartbeats of `from` a node manager got.
auto beats(const program& p, const jaus::address& from) {
    return std::ranges::count_if(
        p.seen, [&](const seen_message& m) { return m.head.command_code == 0x4202 && m.head.source == from; });
}

/// Sends an acknowledged command and says what became of it.
jaus::delivered command(program& from, const jaus::address& to, boost::asio::io_context& context) {
    const auto before = from.hooks.delivered.size();
    REQUIRE(from.core.send({.destination = to}, jaus::set_wrench_effort{}, net::jaus_node::now(), from.node.out()));
    REQUIRE(support::until(context, [&] { return from.hooks.delivered.size() != before; }));
    return from.hooks.delivered.back();
}

} // namespace

TEST_CASE("IPv6 nodes discover each other, exchange commands, and refuse senders at other addresses") {
    boost::asio::io_context context;
    const auto loopback = boost::asio::ip::address_v6::loopback();
    const auto ports = free_ports<2>(loopback);
    const auto systems = system_at("::1", "ocu", "1.0.0.0", ports[0]) +
                         system_at("::1", "robot", "2.0.0.0", ports[1], "<framing>JAUS01.0</framing>");
    program ocu{context, config("ocu", systems), make(1, 1, 32)};
    program robot{context, config("robot", systems), make(2, 1, 33)};
    REQUIRE(support::until(context, [&] { return has(ocu.appeared, make(2, 1)) && has(robot.appeared, make(1, 1)); }));
    REQUIRE(command(ocu, robot.self, context) == jaus::delivered::acknowledged);
    REQUIRE(ocu.node.send({.command_code = 0xD111, .destination = robot.self, .source = ocu.self},
                          std::span<const std::byte>{bytes(20'000)}));
    REQUIRE(support::until(context, [&] { return robot.large.size() == 1; }));

    udp::socket stranger{context, udp::endpoint{loopback, 0}};
    const auto forged = datagram_of({.code = 0x0002, .source = {1, 1, 32, 1}, .destination = {2, 1, 33, 1}});
    stranger.send_to(boost::asio::buffer(forged), {loopback, ports[1]});
    REQUIRE(support::until(context, [&] { return robot.node.counts().wrong_sender == 1; }));
    REQUIRE(robot.logged("[::1]"));
    REQUIRE(robot.core.state() == jaus::primary_status_code::ready);
}

TEST_CASE("a system with any source port is accepted from each port of its address, and answered at its own port") {
    boost::asio::io_context context;
    foreign_node listener{context}, sender{context};
    const auto port = free_ports<1>()[0];
    const raw_message query{.code = 0x2002, .source = {7, 1, 32, 1}, .destination = {2, 1, 33, 1}};
    for (const bool any : {false, true}) {
        const std::string inside = std::string{"<framing>JAUS01.0</framing>"} +
                                   (any ? "<sourceport>any</sourceport>" : "<sourceport>same</sourceport>");
        program robot{
            context,
            config("robot", system("robot", "2.1.0.0", port) + system("other", "7.0.0.0", listener.port(), inside)),
            make(2, 1, 33)};
        sender.send(port, query);
        REQUIRE(listener.wait_for(0x4002, any ? 5000ms : 200ms).has_value() == any);
        REQUIRE(robot.node.counts().wrong_sender == (any ? 0 : 1));
        // Not from another address, whatever the port.
        udp::socket elsewhere{context, udp::endpoint{boost::asio::ip::make_address("127.0.0.77"), 0}};
        elsewhere.send_to(boost::asio::buffer(datagram_of(query)), {boost::asio::ip::address_v4::loopback(), port});
        REQUIRE(support::until(context, [&] { return robot.node.counts().wrong_sender == (any ? 1 : 2); }));
    }
}

TEST_CASE("only the primary relays between the nodes of its subsystem") {
    boost::asio::io_context context;
    const auto ports = free_ports<3>();
    // Nodes 2 and 3 know each other by the way through node 1 only.
    const auto first = system("first", "5.1.0.0", ports[0]), second = system("second", "5.2.0.0", ports[1]),
               third = system("third", "5.3.0.0", ports[2]);
    const auto behind = [&](const std::string& self, const std::string& entry) {
        return config(self, entry + system("first", "5.0.0.0", ports[0]));
    };
    for (const std::uint8_t primary : {std::uint8_t{1}, std::uint8_t{0}}) {
        const net::jaus_node_options options{.primary = primary};
        program one{context, config("first", first + second + third), make(5, 1, 40), options};
        program two{context, behind("second", second), make(5, 2, 33), options};
        program three{context, behind("third", third), make(5, 3, 33), options};
        if (primary != 0) {
            REQUIRE(command(two, three.self, context) == jaus::delivered::acknowledged);
            REQUIRE(command(three, two.self, context) == jaus::delivered::acknowledged);
            REQUIRE(support::until(context, [&] {
                return has(two.appeared, make(5, 3)) && has(three.appeared, make(5, 2)) &&
                       has(one.appeared, make(5, 2));
            }));
            // A heartbeat goes to everybody once: 50 ms apart, as it was sent.
            const auto before = beats(two, make(5, 3)), own = beats(one, make(5, 3));
            REQUIRE(support::until(context, [&] { return beats(two, make(5, 3)) - before >= 5; }));
            REQUIRE(beats(two, make(5, 3)) - before <= beats(one, make(5, 3)) - own + 1);
            REQUIRE(beats(two, make(5, 2)) == 0); // never its own
        } else {
            REQUIRE(command(two, three.self, context) == jaus::delivered::timed_out);
            REQUIRE(one.logged("only the primary node forwards from node to node"));
            REQUIRE_FALSE(has(two.appeared, make(5, 3)));
        }
    }
}

TEST_CASE("messages between subsystems pass the nodes between them, both ways") {
    boost::asio::io_context context;
    const auto ports = free_ports<4>();
    // 1.2 has its primary 1.1 only; that knows the gateway 2.1 of subsystem 2, behind which is 2.2.
    program operator_node{context,
                          config("panel", system("panel", "1.2.0.0", ports[0]) + system("base", "1.1.0.0", ports[1]) +
                                              system("all", "2.0.0.0", ports[1])),
                          make(1, 2, 32),
                          {.primary = 1}};
    program base{context,
                 config("base", system("base", "1.1.0.0", ports[1]) + system("panel", "1.2.0.0", ports[0]) +
                                    system("robot", "2.0.0.0", ports[2], "<framing>JAUS01.0</framing>")),
                 make(1, 1, 40),
                 {.primary = 1}};
    program gateway{context,
                    config("robot", system("robot", "2.1.0.0", ports[2]) + system("ocu", "1.0.0.0", ports[1]) +
                                        system("arm", "2.2.0.0", ports[3])),
                    make(2, 1, 40),
                    {.primary = 1}};
    program arm{context,
                config("arm", system("arm", "2.2.0.0", ports[3]) + system("robot", "2.1.0.0", ports[2]) +
                                  system("others", "1.0.0.0", ports[2])),
                make(2, 2, 33),
                {.primary = 1}};
    REQUIRE(command(operator_node, arm.self, context) == jaus::delivered::acknowledged);
    REQUIRE(command(arm, operator_node.self, context) == jaus::delivered::acknowledged);
    REQUIRE(arm.find(0x0405, operator_node.self) != nullptr);
    // Everybody hears of everybody, through three nodes.
    REQUIRE(support::until(context,
                           [&] { return has(operator_node.appeared, make(2, 2)) && has(arm.appeared, make(1, 2)); }));
    // Nobody knows subsystem 3.
    REQUIRE(command(operator_node, make(3, 1, 33), context) == jaus::delivered::timed_out);
    REQUIRE(operator_node.logged("no route to the destination is known"));
}

TEST_CASE("several programs of one host use the same port, each at its own address, or by an option") {
    boost::asio::io_context context;
    const auto port = free_ports<1>()[0];
    const auto first = system_at("127.0.0.2", "ocu", "1.0.0.0", port),
               second = system_at("127.0.0.3", "robot", "2.0.0.0", port);
    program ocu{context, config("ocu", first + second), make(1, 1, 32)};
    // A node of another maker that listens at all addresses of the host.
    udp::socket everywhere{context, udp::v4()};
    everywhere.set_option(udp::socket::reuse_address{true});
    REQUIRE_THROWS(everywhere.bind({boost::asio::ip::address_v4::any(), port}));
    ocu.node.stop();
    everywhere.bind({boost::asio::ip::address_v4::any(), port});
    REQUIRE_THROWS_AS(ocu.node.start(), net::open_error);

    net::jaus_node_options options;
    options.socket.reuse_address = true;
    program shared{context, config("ocu", first + second), make(1, 1, 33), options};
    program robot{context, config("robot", first + second), make(2, 1, 33), options};
    REQUIRE(support::until(context, [&] { return has(shared.appeared, make(2, 1)); }));
    REQUIRE(command(shared, robot.self, context) == jaus::delivered::acknowledged);
    REQUIRE(everywhere.available() == 0); // what is to an address goes to who has that address
}
