// Nodes of one process that talk over the loopback interface: what the sans-I/O parts do, done by sockets and a timer.
#include "net/node_program.hpp"
#include <jauscat/jaus/routing/routed.hpp>
#include <jauscat/net/node/detail/presence_changes.hpp>

#include <boost/asio/post.hpp>

#include <random>

using namespace net_test;

TEST_CASE("two nodes discover each other and identify themselves") {
    pair p;
    REQUIRE(p.until([&] { return has(p.ocu.appeared, make(2, 1)) && has(p.robot.appeared, make(1, 1)); }));
    REQUIRE(p.ocu.node.present()->find(make(2, 1)) != nullptr);

    REQUIRE(p.ocu.node.send({.destination = make(2, 1), .source = p.ocu.self},
                            jaus::query_identification{jaus::query_type::node_identification}));
    REQUIRE(p.until([&] { return p.ocu.find(0x4B00, make(2, 1)) != nullptr; }));
    jaus::report_identification report{};
    std::array<std::byte, 256> memory{};
    wire::arena texts{memory};
    REQUIRE(wire::decode(report, p.ocu.find(0x4B00, make(2, 1))->body, texts));
    REQUIRE(report.identification == "arm");

    // Its components: the program's own, and what the configuration has.
    REQUIRE(p.ocu.node.send({.destination = make(2, 1), .source = p.ocu.self},
                            jaus::query_configuration{jaus::query_field::node_configuration}));
    REQUIRE(p.until([&] { return p.ocu.find(0x4B01, make(2, 1)) != nullptr; }));
    REQUIRE(p.ocu.find(0x4B01, make(2, 1))->body.size() == 3 + 3 * 2);

    p.robot.node.stop();
    REQUIRE(p.until([&] { return has(p.ocu.disappeared, make(2, 1)); }));
    REQUIRE(p.until([&] { return p.ocu.logged("closed port"); }));
    p.ocu.appeared.clear();
    p.robot.node.start();
    REQUIRE(p.until([&] { return has(p.ocu.appeared, make(2, 1)); }));
}

TEST_CASE("control is requested, refused to others, lost to a higher authority, and released") {
    pair p;
    auto& driven = p.robot.core;
    p.ocu.other.ask(5, net::jaus_node::now(), p.ocu.node.out());
    REQUIRE(p.until([&] { return p.ocu.other.state() == jaus::control_state::held; }));
    REQUIRE(driven.control().controls(p.ocu.self));

    // Another component of the same program may not command.
    REQUIRE(p.ocu.node.send({.ack_nak = jaus::ack_nak::request, .destination = p.robot.self, .source = make(1, 1, 99)},
                            jaus::standby{}));
    REQUIRE(p.until([&] { return p.robot.logged("does not control the component"); }));
    REQUIRE(driven.state() == jaus::primary_status_code::ready);
    REQUIRE(p.until([&] { return p.ocu.logged("unroutable: this node has no such component"); })); // the NAK's way

    const jaus::address higher = make(1, 1, 99);
    REQUIRE(p.ocu.node.send({.destination = p.robot.self, .source = higher}, jaus::request_component_control{200}));
    REQUIRE(p.until([&] { return p.ocu.other.state() == jaus::control_state::lost; }));
    REQUIRE(driven.control().controls(higher));
    p.ocu.other.ask(5, net::jaus_node::now(), p.ocu.node.out());
    REQUIRE(p.until([&] { return p.ocu.other.state() == jaus::control_state::refused; }));
    p.ocu.other.ask(201, net::jaus_node::now(), p.ocu.node.out());
    REQUIRE(p.until([&] { return p.ocu.other.state() == jaus::control_state::held; }));

    p.ocu.other.release(p.ocu.node.out());
    REQUIRE(p.until([&] { return !driven.control().controller(); }));
}

TEST_CASE("a controller loses control when its node disappears") {
    pair p;
    p.ocu.other.ask(5, net::jaus_node::now(), p.ocu.node.out());
    REQUIRE(p.until([&] { return has(p.robot.appeared, make(1, 1)) && p.robot.core.control().controls(p.ocu.self); }));
    p.ocu.node.stop();
    REQUIRE(p.until([&] { return has(p.robot.disappeared, make(1, 1)); }));
    REQUIRE_FALSE(p.robot.core.control().controller());
}

TEST_CASE("a command is repeated by the timer until it is acknowledged or abandoned") {
    pair p;
    const jaus::header head{.destination = p.robot.self};
    REQUIRE(p.ocu.core.send(head, jaus::set_wrench_effort{}, net::jaus_node::now(), p.ocu.node.out()));
    REQUIRE(p.until([&] { return p.ocu.hooks.delivered.size() == 1; }));
    REQUIRE(p.ocu.hooks.delivered.front() == jaus::delivered::acknowledged);
    REQUIRE(p.ocu.core.send({.destination = make(2, 1, 88)}, jaus::standby{}, net::jaus_node::now(), p.ocu.node.out()));
    REQUIRE(p.until([&] { return p.ocu.hooks.delivered.size() == 2; }));
    REQUIRE(p.ocu.hooks.delivered.back() == jaus::delivered::timed_out);
    REQUIRE(p.robot.logged("unroutable: this node has no such component"));
    // To a component of the own node.
    REQUIRE(p.ocu.core.send({.destination = make(1, 1)},
                            jaus::query_identification{jaus::query_type::node_identification}, net::jaus_node::now(),
                            p.ocu.node.out()));
    REQUIRE(p.until([&] { return p.ocu.hooks.delivered.size() == 3; }));
    REQUIRE(p.ocu.hooks.delivered.back() == jaus::delivered::acknowledged);
    REQUIRE(p.ocu.find(0x4B00, make(1, 1)) != nullptr);
}

TEST_CASE("a complete message is sent with acknowledgement if the component is its source") {
    pair p;
    std::array<std::byte, 64> message{};
    const auto send = [&](const jaus::address& source) {
        const auto made = jaus::make_message({.destination = p.robot.self, .source = source}, jaus::standby{}, message);
        REQUIRE(made);
        return p.ocu.core.send(*made, net::jaus_node::now(), p.ocu.node.out());
    };
    REQUIRE(send(make(1, 1, 99)).error() ==
            jaus::send_error{.code = jaus::send_errc::invalid_message, .message = jaus::errc::invalid_source});
    REQUIRE(send(p.ocu.self));
    REQUIRE(p.until([&] { return p.ocu.hooks.delivered.size() == 1; }));
    REQUIRE(p.robot.core.state() == jaus::primary_status_code::standby);
}

TEST_CASE("a large data set is split, sent and reassembled") {
    pair p;
    std::mt19937 random{1};
    bytes image(200'000);
    for (auto& b : image) b = static_cast<std::byte>(random());
    const jaus::header head{.command_code = 0xD111, .destination = p.robot.self, .source = p.ocu.self};
    REQUIRE(p.ocu.node.send(head, std::span<const std::byte>{image}));
    std::ranges::reverse(image);
    REQUIRE(p.ocu.node.send(head, std::span<const std::byte>{image}));
    REQUIRE(p.until([&] { return p.robot.large.size() == 2; }));
    REQUIRE(p.robot.large.back() == image);
    std::ranges::reverse(image);
    REQUIRE(p.robot.large.front() == image);

    const bytes too_large(2'000'000);
    REQUIRE(p.ocu.node.send(head, std::span<const std::byte>{too_large}));
    REQUIRE(p.until([&] { return p.robot.logged("more bytes or packets than its memory holds"); }));
    const bytes unsendable((std::size_t{16} << 20U) + 1);
    REQUIRE_FALSE(p.ocu.node.send(head, std::span<const std::byte>{unsendable}));
}

TEST_CASE("a node that is destroyed while it sends says what was not sent") {
    boost::asio::io_context context;
    const auto ports = free_ports<2>();
    const auto systems = system("ocu", "1.0.0.0", ports[0]) + system("robot", "2.0.0.0", ports[1]);
    std::vector<std::string> log;
    {
        net::jaus_node node{
            context, config("ocu", systems), {.log = [&](std::string_view line) { log.emplace_back(line); }}};
        node.start();
        REQUIRE(
            node.send({.command_code = 0xD111, .destination = make(2, 1, 33), .source = make(1, 1)}, bytes(1'000'000)));
    }
    CHECK(std::ranges::any_of(
        log, [](const auto& line) { return line.find("1 large data sets were not sent to their end") != line.npos; }));
}

TEST_CASE("an acknowledged command and a large data set pass an intermediate node") {
    boost::asio::io_context context;
    const auto ports = free_ports<3>();
    // The subsystem 2 is entered by its node 1, behind which is node 2.
    program ocu{context, config("ocu", system("ocu", "1.1.0.0", ports[0]) + system("robot", "2.0.0.0", ports[1])),
                make(1, 1, 32)};
    program gateway{context,
                    config("gateway", system("ocu", "1.0.0.0", ports[0]) + system("gateway", "2.1.0.0", ports[1]) +
                                          system("arm", "2.2.0.0", ports[2], "<framing>JAUS01.0</framing>")),
                    make(2, 1, 40)};
    program arm{context,
                config("arm", system("others", "1.0.0.0", ports[1]) + system("gateway", "2.1.0.0", ports[1]) +
                                  system("arm", "2.2.0.0", ports[2])),
                make(2, 2, 33)};
    REQUIRE(ocu.core.send({.destination = arm.self}, jaus::set_wrench_effort{}, net::jaus_node::now(), ocu.node.out()));
    REQUIRE(support::until(context, [&] { return !ocu.hooks.delivered.empty(); }));
    REQUIRE(ocu.hooks.delivered.front() == jaus::delivered::acknowledged);
    REQUIRE(arm.find(0x0405, ocu.self) != nullptr);
    REQUIRE(gateway.find(0x0405, ocu.self) == nullptr);

    const bytes image(50'000, std::byte{7});
    REQUIRE(ocu.node.send({.command_code = 0xD111, .destination = arm.self, .source = ocu.self},
                          std::span<const std::byte>{image}));
    REQUIRE(support::until(context, [&] { return !arm.large.empty(); }));
    REQUIRE(arm.large.front() == image);
    REQUIRE(gateway.large.empty());

    // A node that nobody knows.
    REQUIRE(ocu.node.send({.destination = make(2, 9, 33), .source = ocu.self}, jaus::standby{}));
    REQUIRE(support::until(context, [&] { return gateway.logged("no route to the destination is known"); }));
    const auto here = ocu.node.send({.destination = make(3, 1, 33), .source = ocu.self}, jaus::standby{});
    REQUIRE(here.error().message.find("unroutable: no route") != std::string::npos);
}

TEST_CASE("a datagram with another system's source is refused, logged and counted") {
    pair p;
    udp::socket attacker{p.context, udp::endpoint{boost::asio::ip::address_v4::loopback(), 0}};
    std::array<std::byte, 64> message{};
    const auto send = [&](const jaus::address& source, const jaus::address& to) {
        const auto made = jaus::make_message({.destination = to, .source = source}, jaus::shutdown{}, message);
        REQUIRE(made);
        attacker.send_to(boost::asio::buffer(message.data(), made->size()),
                         {boost::asio::ip::address_v4::loopback(), p.ports[1]});
    };
    send(p.ocu.self, p.robot.self);
    send(make(7, 1), p.robot.self);
    REQUIRE(
        p.until([&] { return p.robot.node.counts().wrong_sender == 1 && p.robot.node.counts().unknown_peer == 1; }));
    REQUIRE(p.robot.logged("wrong sender"));
    REQUIRE(p.robot.logged("unknown peer"));
    REQUIRE(p.robot.core.state() == jaus::primary_status_code::ready);
    REQUIRE(p.robot.find(0x0002, p.ocu.self) == nullptr);
    // A flood is counted to the last datagram, and logged in part.
    const auto before = p.robot.log.size();
    for (int i = 0; i != 1000; ++i) {
        send(make(7, 1), p.robot.self);
        if (i % 50 == 0) p.run_for(1ms);
    }
    REQUIRE(p.until([&] { return p.robot.node.counts().unknown_peer == 1001; }));
    REQUIRE(p.robot.log.size() - before < 200);
}

TEST_CASE("a message that cannot be sent is reported to the sender") {
    pair p;
    const auto source = p.ocu.self;
    auto to = p.robot.self;
    to.instance = 0;
    REQUIRE(p.ocu.node.send({.destination = to, .source = source}, jaus::standby{}).error().message.find("is 0") !=
            std::string::npos);
    REQUIRE_FALSE(p.ocu.node.send({.destination = p.robot.self, .source = make(2, 1, 33)}, jaus::standby{}));
    REQUIRE_FALSE(p.ocu.node.send({.destination = make(9, 1), .source = source}, jaus::standby{}));
    p.ocu.node.stop();
    REQUIRE(p.ocu.node.send({.destination = p.robot.self, .source = source}, jaus::standby{}).error().message ==
            "the node is not running");
    REQUIRE_THROWS_AS(p.robot.node.start(), std::logic_error);
}

TEST_CASE("a caller can branch on why a message is not sent, and on the reason below") {
    pair p;
    const auto source = p.ocu.self;
    const auto why = [&](const jaus::address& to, const auto& body) {
        return p.ocu.node.send({.destination = to, .source = source}, body).error();
    };
    const auto beyond = why(p.robot.self, jaus::set_wrench_effort{.propulsive_linear_effort_x = 101});
    CHECK(beyond.code == net::errc::not_encodable);
    CHECK(beyond.reason == net::reason_of(wire::errc::out_of_range));
    CHECK(beyond.reason != net::reason_of(static_cast<jaus::errc>(wire::errc::out_of_range)));
    CHECK(beyond.reason.message() == wire::describe(wire::errc::out_of_range));
    const auto nowhere = why(make(9, 1), jaus::standby{});
    CHECK(nowhere.code == net::errc::unroutable);
    CHECK(nowhere.reason == net::reason_of(jaus::routed::no_route));
    p.ocu.node.stop();
    CHECK(why(p.robot.self, jaus::standby{}).code == net::errc::not_running);
}

TEST_CASE("nodes discover each other by multicast and ignore their own datagrams") {
    boost::asio::io_context context;
    const auto ports = free_ports<3>();
    const std::string group =
        "<multicast group='224.1.0.1' port='" + std::to_string(ports[2]) + "' interface='lo' ttl='0'/>";
    const auto systems = system("ocu", "1.0.0.0", ports[0], group) + system("robot", "2.0.0.0", ports[1], group);
    program ocu{context, config("ocu", systems), make(1, 1, 32)};
    program robot{context, config("robot", systems), make(2, 1, 33)};
    REQUIRE(support::until(context, [&] { return has(ocu.appeared, make(2, 1)) && has(robot.appeared, make(1, 1)); }));
    const auto beats = [](const program& p, const jaus::address& from) {
        return std::ranges::count_if(
            p.seen, [&](const seen_message& m) { return m.head.command_code == 0x4202 && m.head.source == from; });
    };
    REQUIRE(support::until(context, [&] { return beats(ocu, make(2, 1)) >= 3; }));
    REQUIRE(beats(ocu, make(1, 1)) == 0);
    REQUIRE(ocu.log.empty());
    REQUIRE(robot.log.empty());
}

TEST_CASE("a configuration without valid routes is refused with its line") {
    boost::asio::io_context context;
    const auto error = [&](const std::string& systems) -> std::string {
        try {
            net::jaus_node{context, config("a", systems)}.start();
            return "accepted";
        } catch (const net::config_error& e) {
            return e.what();
        }
    };
    const auto port = free_ports<1>()[0];
    REQUIRE(error(system("a", "0.0.0.0", port)).find("test.xml:3: ") == 0);
    REQUIRE(error(system("a", "1.0.0.0", port) + system("b", "2.0.0.0", port)).find("give each its own port") !=
            std::string::npos);
    REQUIRE(error(system("a", "1.0.0.0", port) + system("b", "2.0.0.0", 4000) +
                  system("c", "3.0.0.0", 4000, "<framing>JAUS01.0</framing>"))
                .find("another framing") != std::string::npos);
    REQUIRE(error("<system name='a' jausip='1.0.0.0' ip='0.0.0.0' port='" + std::to_string(port) +
                  "'><multicast/></system>")
                .find("test.xml:3: the system \"a\" has multicast and the ip 0.0.0.0") == 0);
    REQUIRE(error(system("a", "1.0.0.0", port)) == "accepted");
}

TEST_CASE("a component that its node cannot have is refused with the reason") {
    boost::asio::io_context context;
    net::jaus_node node{context, config("a", system("a", "1.2.0.0", free_ports<1>()[0]))};
    const auto refusal = [&](const jaus::address& id) -> std::string {
        jaus::component_memory<> memory{};
        jaus::component core{id, memory, {}, {}};
        const auto application = [](const jaus::header&, std::span<const std::byte>) {
            return jaus::message_outcome::handled;
        };
        try {
            node.add(core, application);
        } catch (const std::invalid_argument& e) {
            return e.what();
        }
        return "accepted";
    };
    REQUIRE(refusal(make(1, 3, 33)) == "the component 1.3.33.1 is not one of the node 1.2");
    REQUIRE(refusal(make(1, 2)) == "the node has its node manager, 1.2.1.1, already");
}

namespace {

/// Counts what it gets, and waits for nothing.
struct counting_component {
    unsigned messages{}, times{};

    static jaus::address self() { return make(2, 1, 33); }
    jaus::component_outcome on_message(const jaus::header&, std::span<const std::byte>, jauscat::time_point,
                                       jaus::message_sink, auto&&) {
        ++messages;
        return jaus::component_outcome::handled;
    }
    void on_time(jauscat::time_point, jaus::message_sink) { ++times; }
    static std::optional<jauscat::time_point> next_event() { return std::nullopt; }
    static void on_lost(const jaus::address&) {}
};

} // namespace

TEST_CASE("a node that waits for nothing works at once on what its program sends, and when it is woken") {
    boost::asio::io_context context;
    counting_component mine;
    constexpr auto soon = 5s; // the node manager asks others every ten seconds
    const auto nothing = [](const jaus::header&, std::span<const std::byte>) { return jaus::message_outcome::handled; };
    net::jaus_node node{
        context, config("robot", system("robot", "2.0.0.0", free_ports<1>()[0])), {.beat = {.period = 1h}}};
    node.add(mine, nothing);
    node.start();
    static_cast<void>(net::run_until(context, 50ms, [] { return false; }));

    const auto before = mine.times;
    node.wake();
    CHECK(net::run_until(context, soon, [&] { return mine.times != before; }));
    REQUIRE(node.send({.command_code = 0xD100, .destination = mine.self(), .source = make(2, 1)}, bytes{}));
    CHECK(net::run_until(context, soon, [&] { return mine.messages == 1; }));
    std::array<std::byte, jaus::header_size> message{};
    node.out()(*jaus::join({.command_code = 0xD100, .destination = mine.self(), .source = make(2, 1)}, {}, message));
    CHECK(net::run_until(context, soon, [&] { return mine.messages == 2; }));
}

TEST_CASE("an exception from the log handler during a component's send leaves the io_context") {
    boost::asio::io_context context;
    const auto ports = free_ports<3>(); // nobody listens at the second: sending to the third hears of it
    const auto systems =
        system("a", "1.0.0.0", ports[0]) + system("b", "2.0.0.0", ports[1]) + system("c", "3.0.0.0", ports[2]);
    bool throws = true;
    net::jaus_node node{context, config("a", systems), {.log = [&](std::string_view line) {
                            if (throws) throw std::runtime_error{std::string{line}};
                        }}};
    node.start();
    REQUIRE_THROWS_AS(support::until(context, [] { return false; }), std::runtime_error);
    node.stop();
    throws = false;
    node.start();
    REQUIRE_FALSE(net::run_until(context, 20ms, [] { return false; }));
}

TEST_CASE("a presence handler may stop the node, and is not called for further changes") {
    net::detail::presence_changes changes{};
    changes.disappeared(make(1, 1));
    changes.disappeared(make(2, 1));
    std::vector<jaus::address> heard{};
    changes.take([&](const jaus::address& who, bool) {
        changes.clear();
        changes.appeared(make(3, 1));
        heard.push_back(who);
    });
    REQUIRE(heard == std::vector{make(1, 1)});
    changes.take([&](const jaus::address& who, bool) { heard.push_back(who); });
    REQUIRE(heard == std::vector{make(1, 1), make(3, 1)});
}

TEST_CASE("a handler may stop the node, but not add components while it is called") {
    boost::asio::io_context context;
    const auto ports = free_ports<1>();
    jaus::component_memory<> memory{};
    jaus::component first{make(2, 1, 33), memory, {}, {}}, second{make(2, 1, 34), memory, {}, {}};
    const auto other = [](const jaus::header&, std::span<const std::byte>) { return jaus::message_outcome::handled; };
    bool heard = false, refused = false;
    net::jaus_node* node = nullptr;
    const auto application = [&](const jaus::header&, std::span<const std::byte>) {
        heard = true;
        node->stop();
        try {
            node->add(second, other);
        } catch (const std::logic_error&) {
            refused = true;
        }
        return jaus::message_outcome::handled;
    };
    net::jaus_node robot{context, config("robot", system("robot", "2.0.0.0", ports[0]))};
    node = &robot;
    robot.add(first, application);
    robot.start();
    first.change(jaus::state_event::initialized);
    REQUIRE(robot.send({.command_code = 0xD100, .destination = make(2, 1, 33), .source = make(2, 1)}, bytes{}));
    REQUIRE(support::until(context, [&] { return heard; }));
    REQUIRE(refused);
    robot.add(second, other);
    robot.start();
}
