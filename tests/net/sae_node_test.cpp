// A node of SAE JAUS over UDP, TCP and a serial line at once, as the configuration has them.
#include "support/catch.hpp"
#include "support/free_ports.hpp"
#include "support/hex.hpp"
#include "support/pseudo_terminal.hpp"
#include "support/until.hpp"
#include <jauscat/net/config/read_jaus_config.hpp>
#include <jauscat/net/node/jaus_node.hpp>
#include <jauscat/net/sae/sae_node.hpp>
#include <jauscat/schema/sae/core/access_control.hpp>

#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/write.hpp>

#include <unistd.h>

using namespace jauscat;
using namespace std::chrono_literals;
using tcp = boost::asio::ip::tcp;
using udp = boost::asio::ip::udp;

namespace {

using test::from_hex;
using test::to_hex;

const auto host = [](const char* ip) { return boost::asio::ip::make_address(ip); };

/// A configuration of the systems between the lines, for the system `name`.
net::jaus_config config_of(const std::string& name, const std::string& systems) {
    return net::parse_jaus_config("<jausconfig thissystem='" + name + "'>\n" + systems + "</jausconfig>\n", "test.xml");
}

/// A node, and what it was given.
struct station {
    station(boost::asio::io_context& context, const net::jaus_config& config, net::sae_node_options options = {})
        : node{context, config, std::move(options)} {}

    void start() {
        node.start({[this](const sae::received_message& m) {
                        received.push_back(to_hex(m.payload) + " by " + node.place_of(m.from));
                        if (on_message) on_message(m);
                    },
                    [this](const sae::finished_message& m) { outcomes.push_back(m.outcome); },
                    [this](std::string_view line) { log.emplace_back(line); }});
    }
    /// Sends with acknowledgement.
    auto send(const sae::jaus_id& to, std::string_view payload) {
        return node.send({.destination = to, .is_acknowledged = true}, from_hex(payload));
    }

    std::vector<std::string> received{};
    std::vector<sae::sent_outcome> outcomes{};
    std::vector<std::string> log{};
    std::function<void(const sae::received_message&)> on_message{};
    net::sae_node node;
};

constexpr sae::jaus_id by_udp{10, 1, 126}, by_tcp{10, 1, 127}, by_line{10, 1, 128}, robot_id{20, 1, 1};

std::string complaint(const net::jaus_config& config, const net::sae_node_options& options = {}) {
    boost::asio::io_context context;
    try {
        const net::sae_node node{context, config, options};
        return "accepted";
    } catch (const net::config_error& error) {
        return error.what();
    }
}

} // namespace

TEST_CASE("one node talks to peers over UDP, TCP and a serial line, each by the medium of its system") {
    boost::asio::io_context context;
    const support::pseudo_terminal one, two; // their other ends are joined here
    boost::asio::posix::stream_descriptor a{context, ::dup(one.master)}, b{context, ::dup(two.master)};
    support::join(a, b);
    const auto ports = support::free_ports<3>();
    const auto port = [&](std::size_t i) { return " port='" + std::to_string(ports[i]) + "'"; };
    const auto systems = "<system name='robot' ip='127.0.0.2'" + port(0) +
                         "><sae id='1.1.20'><judp/><jtcp connect='arm'/><jserial device='" + one.device() +
                         "'/></sae></system>\n"
                         "<system name='ocu' ip='127.0.0.3'" +
                         port(1) + "><sae id='126.1.0'><judp/></sae></system>\n" +
                         "<system name='arm' ip='127.0.0.4'><sae id='127.1.10'><jtcp listen='" +
                         std::to_string(ports[2]) +
                         "'/></sae></system>\n"
                         "<system name='tool'><sae id='128.0.0'><jserial device='" +
                         two.device() + "'/></sae></system>\n";
    station robot{context, config_of("robot", systems)};
    station ocu{context, config_of("ocu", systems), {.components = {10, 11}}};
    station arm{context, config_of("arm", systems)};
    auto of_tool = config_of("tool", systems);
    of_tool.systems[3].sae->id.node = 1; // its file is another one
    station tool{context, of_tool, {.components = {10}}};
    CHECK(robot.send(by_udp, "0d00 c8").error().code == net::errc::not_running);
    for (auto* const each : {&robot, &ocu, &arm, &tool}) each->start();
    REQUIRE(support::until(context, [&] { return robot.node.counts().jtcp.connected == 1; }));

    for (const auto& peer : {by_udp, by_tcp, by_line}) REQUIRE(robot.send(peer, "0d00 c8"));
    REQUIRE(support::until(context, [&] { return robot.outcomes.size() == 3; }));
    CHECK(robot.outcomes == std::vector(3, sae::sent_outcome::acknowledged));
    CHECK(ocu.received == std::vector{"0d 00 c8 by UDP 127.0.0.2:" + std::to_string(ports[0])});
    REQUIRE(arm.received.size() == 1);
    CHECK(arm.received[0].starts_with("0d 00 c8 by TCP 127.0.0.2:"));
    CHECK(tool.received == std::vector{"0d 00 c8 by the serial line " + two.device()});

    // Each answers where it was asked.
    const sae::core::confirm_control confirm{};
    for (auto* const each : {&ocu, &arm, &tool}) REQUIRE(each->node.send({.destination = robot_id}, confirm));
    REQUIRE(support::until(context, [&] { return robot.received.size() == 3; }));
    std::ranges::sort(robot.received);
    CHECK(robot.received == std::vector<std::string>{"0f 00 00 by TCP 127.0.0.4:" + std::to_string(ports[2]),
                                                     "0f 00 00 by UDP 127.0.0.3:" + std::to_string(ports[1]),
                                                     "0f 00 00 by the serial line " + one.device()});

    // A broadcast has no group of UDP here; connections and lines have it.
    REQUIRE(robot.node.send({.destination = sae::everybody, .broadcast = sae::broadcast::global}, from_hex("002b 02")));
    REQUIRE(support::until(context, [&] { return arm.received.size() == 2 && tool.received.size() == 2; }));
    CHECK(ocu.received.size() == 1);

    // A connection that has ended is made again, and used again.
    arm.node.stop();
    REQUIRE(support::until(context, [&] { return robot.node.peers().find(by_tcp) == nullptr; }));
    arm.start();
    REQUIRE(support::until(context, [&] { return robot.node.counts().jtcp.connected == 2; }));
    REQUIRE(robot.send(by_tcp, "0220"));
    REQUIRE(support::until(context, [&] { return robot.outcomes.size() == 4; }));
    CHECK(robot.outcomes.back() == sae::sent_outcome::acknowledged);
    CHECK(arm.received.size() == 3);

    const auto unroutable = ocu.send({1, 1, 9}, "0220"); // no system, and no group
    REQUIRE(!unroutable);
    CHECK(unroutable.error().code == net::errc::unroutable);
    CHECK(unroutable.error().message.starts_with("a message of 126.1.10 to 9.1.1 is not sent: "));
    for (auto* const each : {&robot, &ocu, &arm, &tool}) each->node.stop();
    CHECK_FALSE(robot.node.running());
    CHECK(ocu.log.empty());
    CHECK(tool.log.empty());
}

TEST_CASE("a message of several packets arrives, and one that is too large is refused by name") {
    boost::asio::io_context context;
    const auto ports = support::free_ports<2>();
    const auto systems = "<system name='robot' ip='127.0.0.2' port='" + std::to_string(ports[0]) +
                         "'><sae id='1.1.20'><judp/></sae></system>\n<system name='ocu' ip='127.0.0.3' port='" +
                         std::to_string(ports[1]) + "'><sae id='126.1.10'><judp/></sae></system>\n";
    auto ocu_options = net::sae_node_options{};
    ocu_options.memory.message_size = std::size_t{16} << 10U;
    station robot{context, config_of("robot", systems)}, ocu{context, config_of("ocu", systems), ocu_options};
    robot.start();
    ocu.start();
    std::vector<std::byte> image(100'000, std::byte{0xD0});
    REQUIRE(ocu.node.send({.destination = robot_id, .is_acknowledged = true}, image));
    REQUIRE(support::until(context, [&] { return robot.received.size() == 1; }));
    CHECK(robot.received[0].starts_with(to_hex(image)));

    REQUIRE(robot.node.send({.destination = by_udp}, image));
    REQUIRE(support::until(context, [&] { return !ocu.log.empty(); }));
    CHECK(ocu.log[0].starts_with("a packet of 1.1.20 is refused: too large: "));
    CHECK(ocu.received.empty());
    CHECK(robot.log.empty());
}

TEST_CASE("a message is processed from the addresses and media of its system alone, within its rate") {
    boost::asio::io_context context;
    const auto ports = support::free_ports<3>();
    const auto text = [&](std::size_t i) { return std::to_string(ports[i]); };
    const auto systems =
        "<system name='robot' ip='127.0.0.2' port='" + text(0) + "'><sae id='1.1.20'><judp/>" + "<jtcp listen='" +
        text(2) + "'/></sae></system>\n<system name='ocu' ip='127.0.0.3' port='" + text(1) +
        "'><sae id='126.1.10'><judp/></sae><limits rate='1' burst='2'/></system>\n" +
        "<system name='other' ip='127.0.0.4' port='9' sourceport='any'><sae id='126.1.0'><judp/><jtcp" +
        " connect='robot'/></sae></system>\n";
    station robot{context, config_of("robot", systems)};
    robot.start();
    const udp::endpoint to{host("127.0.0.2"), ports[0]};
    const auto from = [&](const char* ip, std::uint16_t port) {
        return udp::socket{context, udp::endpoint{host(ip), port}};
    };
    std::uint8_t number = 0;
    const auto query = [&](udp::socket& socket, const std::string& source) {
        auto bytes = from_hex("02 00 1000 01 14010100 " + source + " 0220 0000");
        bytes[15] = std::byte{++number};
        socket.send_to(boost::asio::buffer(bytes), to);
    };
    auto ocu = from("127.0.0.3", ports[1]), ocu_elsewhere = from("127.0.0.3", 0), other = from("127.0.0.4", 0);
    query(ocu, "0A017E00");           // accepted
    query(ocu_elsewhere, "0A017E00"); // another port
    query(other, "0A017E00");         // the id of the ocu
    query(other, "0B017E00");         // any component of node 126.1 but 10
    query(other, "0B017F00");         // of no system
    for (int i = 0; i != 2; ++i) query(ocu, "0A017E00");
    REQUIRE(support::until(context, [&] { return robot.node.counts().rate_limited == 1; }));
    CHECK(robot.node.counts().wrong_sender == 2);
    CHECK(robot.node.counts().unknown_peer == 1);
    CHECK(robot.received.size() == 3);
    REQUIRE(robot.log.size() == 4);
    CHECK(robot.log[0] ==
          "a message of 126.1.10 from UDP 127.0.0.3:" + std::to_string(ocu_elsewhere.local_endpoint().port()) +
              " is refused: wrong sender: the message's JAUS source belongs to another system");
    CHECK(robot.log[2] == "a message of 127.1.11 from UDP 127.0.0.4:" + std::to_string(other.local_endpoint().port()) +
                              " is refused: unknown peer: no <sae> of test.xml has its source in the id");
    CHECK(robot.log[3].ends_with(" is refused: rate-limited: the peer sends too much"));

    // A system without <jtcp> has no connection.
    tcp::socket refused{context, tcp::endpoint{host("127.0.0.3"), 0}},
        accepted{context, tcp::endpoint{host("127.0.0.4"), 0}};
    refused.connect({host("127.0.0.2"), ports[2]});
    REQUIRE(support::until(context, [&] { return robot.node.counts().jtcp.unknown_peer == 1; }));
    CHECK(robot.log.back().find("is refused: its host is not accepted") != std::string::npos);
    accepted.connect({host("127.0.0.2"), ports[2]});
    boost::asio::write(accepted, boost::asio::buffer(from_hex("02 00 1000 01 14010100 0B017E00 0220 4000"
                                                              "00 1000 01 14010100 0A017E00 0220 4100")));
    REQUIRE(support::until(context, [&] { return robot.node.counts().wrong_sender == 3; }));
    CHECK(robot.received.size() == 4);

    // An open node takes all of them.
    robot.node.stop();
    station open{context, config_of("robot", systems), {.accept = net::access::open}};
    open.start();
    for (const std::string_view source : {"0A017E00", "0B017E00", "0B017F00"})
        query(ocu_elsewhere, std::string{source});
    REQUIRE(support::until(context, [&] { return open.received.size() == 3; }));
    CHECK(open.log.empty());
}

TEST_CASE("strangers are found by the group, and a node receives it at an address of its own") {
    boost::asio::io_context context;
    const auto ports = support::free_ports<3>(boost::asio::ip::address_v4::any());
    const auto group = "<judp><multicast interface='lo' ttl='0' port='" + std::to_string(ports[0]) + "'/></judp>";
    const auto system = [&](const char* name, const char* ip, std::size_t port, const char* id) {
        return "<system name='" + std::string{name} + "' ip='" + ip + "' port='" + std::to_string(ports[port]) +
               "'><sae id='" + id + "'>" + group + "</sae></system>\n";
    };
    station robot{
        context, config_of("robot", system("robot", "127.0.0.1", 1, "1.1.20")), {.accept = net::access::open}};
    station ocu{context, config_of("ocu", system("ocu", "127.0.0.1", 2, "126.1.10")), {.accept = net::access::open}};
    robot.start();
    ocu.start();
    REQUIRE(robot.send(by_udp, "0d00 c8"));
    REQUIRE(support::until(context, [&] { return robot.outcomes.size() == 1; }));
    CHECK(robot.outcomes[0] == sae::sent_outcome::acknowledged);
    CHECK(ocu.received.size() == 1);
    REQUIRE(robot.node.peers().find(by_udp) != nullptr);
    CHECK(robot.node.place_of(robot.node.peers().find(by_udp)->endpoint) ==
          "UDP 127.0.0.1:" + std::to_string(ports[2]));
    REQUIRE(support::until(context, [&] { return robot.node.counts().transport.own != 0; })); // the group's loopback
    CHECK(robot.log.empty());
    CHECK(ocu.node.counts().judp.received >= 1);
}

TEST_CASE("a system of both generations has one port, of the node of the RA") {
    boost::asio::io_context context;
    const auto ports = support::free_ports<2>();
    const auto systems = "<system name='robot' jausip='2.0.0.0' ip='127.0.0.2' port='" + std::to_string(ports[0]) +
                         "'><sae id='1.1.20'><judp/></sae></system>\n<system name='ocu' ip='127.0.0.3' port='" +
                         std::to_string(ports[1]) + "'><sae id='126.1.10'><judp/></sae></system>\n" +
                         "<system name='old' jausip='7.0.0.0' ip='127.0.0.4' port='9' sourceport='any'/>\n";
    std::optional<station> robot;
    std::vector<std::string> log;
    net::jaus_node ra{context,
                      config_of("robot", systems),
                      {.log = [&](std::string_view line) { log.emplace_back(line); },
                       .on_sae_datagram = [&](std::span<const std::byte> datagram,
                                              const udp::endpoint& from) { robot->node.on_datagram(datagram, from); }}};
    robot.emplace(
        context, config_of("robot", systems),
        net::sae_node_options{.send_datagram = [&](std::span<const std::byte> datagram, const udp::endpoint& to) {
            return ra.send_datagram(datagram, to);
        }});
    station ocu{context, config_of("ocu", systems)};
    ra.start();
    robot->start();
    ocu.start();
    REQUIRE(ocu.send(robot_id, "0d00 c8"));
    REQUIRE(support::until(context, [&] { return ocu.outcomes.size() == 1; }));
    CHECK(ocu.outcomes[0] == sae::sent_outcome::acknowledged);
    CHECK(robot->received == std::vector{"0d 00 c8 by UDP 127.0.0.3:" + std::to_string(ports[1])});
    REQUIRE(robot->send(by_udp, "0f00 00"));
    REQUIRE(support::until(context, [&] { return ocu.received.size() == 1; }));
    CHECK(ocu.received[0] == "0f 00 00 by UDP 127.0.0.2:" + std::to_string(ports[0]));
    // The RA: a system without jausip has no messages of it, and is none of its peers.
    udp::socket stranger{context, udp::endpoint{host("127.0.0.5"), 0}},
        old{context, udp::endpoint{host("127.0.0.4"), 0}};
    const auto query = from_hex("0602 002b 01010102 01200107 0100 0000 02"); // Query Identification of 7.1.32.1
    for (auto* const socket : {&stranger, &old})
        socket->send_to(boost::asio::buffer(query), udp::endpoint{host("127.0.0.2"), ports[0]});
    REQUIRE(support::until(context, [&] { return ra.counts().wrong_sender == 1 && ra.counts().received >= 3; }));
    CHECK(config_of("robot", systems).next_hop({1, 10, 1, 126}) == nullptr);
    CHECK_THROWS_WITH((net::jaus_node{context, config_of("ocu", systems)}),
                      Catch::Contains("this system has no jausip; a node of the RA needs one"));
    CHECK(robot->log.empty());
    ra.stop();
    robot->node.stop();
}

TEST_CASE("a node may be stopped by its handler and started again") {
    boost::asio::io_context context;
    const auto ports = support::free_ports<2>();
    const auto systems = "<system name='robot' ip='127.0.0.2' port='" + std::to_string(ports[0]) +
                         "'><sae id='1.1.20'><judp/></sae></system>\n<system name='ocu' ip='127.0.0.3' port='" +
                         std::to_string(ports[1]) + "'><sae id='126.1.10'><judp/></sae></system>\n";
    station robot{context, config_of("robot", systems)}, ocu{context, config_of("ocu", systems)};
    ocu.on_message = [&](const sae::received_message&) { ocu.node.stop(); };
    robot.start();
    ocu.start();
    REQUIRE(robot.node.send({.destination = by_udp}, from_hex("0d00 c8")));
    REQUIRE(support::until(context, [&] { return ocu.received.size() == 1; }));
    CHECK_FALSE(ocu.node.running());
    ocu.on_message = {};
    ocu.start();
    CHECK(ocu.node.peers().find(robot_id) == nullptr);
    REQUIRE(robot.send(by_udp, "0220"));
    REQUIRE(support::until(context, [&] { return robot.outcomes.size() == 1; }));
    CHECK(ocu.received.size() == 2);
}

TEST_CASE("a configuration that has no components for a node of SAE JAUS is refused with its line") {
    const auto of = [](const std::string& more) {
        return config_of("a", "<system name='a' jausip='1.0.0.0' ip='127.0.0.1' port='3794'>\n" + more + "</system>\n");
    };
    CHECK(complaint(of("")) ==
          "test.xml:2: this system has no <sae>; a node of SAE JAUS needs one, such as <sae id=\"126.1.10\">");
    CHECK(complaint(of("<sae id='1.0.0'><judp/></sae>")) ==
          "test.xml:3: the id 1.0.0 of this system names no node; give one, such as 1.1.0");
    CHECK(complaint(of("<sae id='1.1.0'><judp/></sae>")) ==
          "test.xml:3: the id 1.1.0 of this system names no component; name it there or in the option components");
    CHECK(complaint(of("<sae id='1.1.0'><judp/></sae>"), {.components = {5, 6}}) == "accepted");
    CHECK(complaint(of("<sae id='1.1.4'><judp/></sae>")) == "accepted");
    CHECK(complaint(of("<sae id='1.1.4'><judp/></sae>"), {.components = {5}}) ==
          "test.xml:3: the component 1.1.5 is outside of the id 1.1.4 of this system");
}
