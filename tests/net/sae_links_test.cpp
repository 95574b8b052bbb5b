// SAE JAUS over UDP and TCP on the loopback interface, and over a pseudo-terminal.
#include "support/catch.hpp"
#include "support/free_ports.hpp"
#include "support/hex.hpp"
#include "support/pseudo_terminal.hpp"
#include "support/until.hpp"
#include <jauscat/net/node/jaus_node.hpp>
#include <jauscat/net/sae/detail/keep_alive.hpp>
#include <jauscat/net/sae/jserial_link.hpp>
#include <jauscat/net/sae/jtcp_link.hpp>
#include <jauscat/net/sae/judp_link.hpp>
#include <jauscat/net/sae/shared_judp.hpp>

#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>

#include <filesystem>
#include <memory>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

using namespace jauscat;
using namespace std::chrono_literals;
using tcp = boost::asio::ip::tcp;
using udp = boost::asio::ip::udp;

namespace {

using byte_vector = std::vector<std::byte>;
using support::pseudo_terminal;
using test::from_hex;
using test::to_hex;

const auto loopback = boost::asio::ip::address_v4::loopback();
constexpr sae::jaus_id controller{20, 1, 126}, component{10, 1, 126};
constexpr sae::transport_sizes sizes{
    .peers = 8, .seen = 64, .fragments = 16, .queue = 16, .replies = 16, .payload_size = 500, .message_size = 4096};

/// A component with its transport, and what it was given.
struct station {
    explicit station(sae::jaus_id id, const sae::transport_options& options = {})
        : components{sae::local_component{id}}, transport{components, storage->memory(), options} {}

    net::sae_handlers handlers() {
        return {[this](const sae::received_message& m) {
                    received.emplace_back(m.payload.begin(), m.payload.end());
                    if (on_message) on_message(m);
                },
                [this](const sae::finished_message& m) { outcomes.push_back(m.outcome); },
                [this](std::string_view line) { log.emplace_back(line); }};
    }

    std::array<sae::local_component, 1> components;
    std::unique_ptr<sae::transport_storage<sizes>> storage{std::make_unique<sae::transport_storage<sizes>>()};
    sae::transport transport;
    std::vector<byte_vector> received{};
    std::vector<sae::sent_outcome> outcomes{};
    std::vector<std::string> log{};
    std::function<void(const sae::received_message&)> on_message{};
};

net::judp_options unicast() { return {.local = {loopback, 0}, .group = {}}; }
byte_vector long_payload() {
    byte_vector payload(3000);
    for (std::size_t i = 0; i != payload.size(); ++i) payload[i] = static_cast<std::byte>(i * 5);
    return payload;
}
byte_vector receive(udp::socket& socket) {
    byte_vector bytes(2048);
    bytes.resize(socket.receive(boost::asio::buffer(bytes.data(), bytes.size())));
    return bytes;
}

} // namespace

TEST_CASE("a peer that sends the capture's datagrams over UDP gets those of the component") {
    boost::asio::io_context context;
    station there{component};
    net::judp_link link{context, there.transport, unicast()};
    there.on_message = [&](const sae::received_message& m) {
        REQUIRE(link.send({.source = component, .destination = m.header.source}, from_hex("0f00 00")));
    };
    link.start(there.handlers());
    udp::socket peer{context, udp::endpoint{loopback, 0}};
    const auto request = from_hex("02 00 1100 19 0A017E00 14017E00 0D00 C8 0100");
    peer.send_to(boost::asio::buffer(request), link.local());
    REQUIRE(support::until(context, [&] { return !there.received.empty(); }));
    CHECK(to_hex(receive(peer)) == test::hex_of("02 00 0E00 31 14017E00 0A017E00 0100"));
    CHECK(to_hex(receive(peer)) == test::hex_of("02 00 1100 01 14017E00 0A017E00 0F00 00 0100"));
    CHECK(there.log.empty());
}

TEST_CASE("two links find each other by a multicast group and go on by unicast, also with a long message") {
    boost::asio::io_context context;
    const auto ports = support::free_ports<2>(boost::asio::ip::address_v4::any());
    const net::multicast_options group{
        .group = boost::asio::ip::address_v4{sae::judp_group}, .port = ports[0], .interface_name = "lo", .ttl = 0};
    station here{controller}, there{component};
    net::judp_link from{context, here.transport, {.local = {udp::v4(), ports[1]}, .group = group}};
    net::judp_link to{context, there.transport, {.local = {udp::v4(), ports[0]}, .group = group}};
    from.start(here.handlers());
    to.start(there.handlers());
    REQUIRE(from.send({.source = controller, .destination = component, .is_acknowledged = true}, from_hex("0d00 c8")));
    REQUIRE(support::until(context, [&] { return !here.outcomes.empty(); }));
    CHECK(here.outcomes.back() == sae::sent_outcome::acknowledged);
    REQUIRE(there.received.size() == 1);
    REQUIRE(here.transport.peers().find(component) != nullptr);
    CHECK(net::judp_link::endpoint_of(here.transport.peers().find(component)->endpoint).port() == ports[0]);

    const auto payload = long_payload();
    REQUIRE(to.send({.source = component, .destination = controller, .is_acknowledged = true}, payload));
    REQUIRE(support::until(context, [&] { return !there.outcomes.empty(); }));
    CHECK(there.outcomes.back() == sae::sent_outcome::acknowledged);
    REQUIRE(here.received.size() == 1);
    CHECK(here.received[0] == payload);

    REQUIRE(from.send({.source = controller, .destination = sae::everybody, .broadcast = sae::broadcast::global},
                      from_hex("002b 02")));
    REQUIRE(support::until(context, [&] { return there.received.size() == 2; }));
}

TEST_CASE("hosts that are not accepted and datagrams above the rate are counted, not processed") {
    boost::asio::io_context context;
    station there{component};
    auto options = unicast();
    options.accepted = {boost::asio::ip::make_address_v4("127.0.0.2")};
    options.limit = {.per_second = 1, .burst = 1};
    net::judp_link link{context, there.transport, options};
    link.start(there.handlers());
    udp::socket stranger{context, udp::endpoint{loopback, 0}};
    udp::socket peer{context, udp::endpoint{boost::asio::ip::make_address_v4("127.0.0.2"), 0}};
    auto query = from_hex("02 00 1000 01 0A017E00 14017E00 0220 0200");
    stranger.send_to(boost::asio::buffer(query), link.local());
    peer.send_to(boost::asio::buffer(query), link.local());
    query[15] = std::byte{3};
    peer.send_to(boost::asio::buffer(query), link.local());
    REQUIRE(support::until(context, [&] { return link.counts().rate_limited == 1; }));
    CHECK(link.counts().unknown_peer == 1);
    CHECK(there.received.size() == 1);
}

TEST_CASE("other forms of JAUS at the port are named once for each host, and counted") {
    boost::asio::io_context context;
    station there{component};
    net::judp_link link{context, there.transport, unicast()};
    link.start(there.handlers());
    udp::socket peer{context, udp::endpoint{loopback, 0}};
    auto counts = [&] { return there.transport.counts(); };
    for (int i = 0; i != 2; ++i)
        for (const std::string_view form :
             {"01 0000 0010 0602020001210203042005060000 0000", "4a41555330312e30 0602020001210203042005060000 0000",
              "01 0507 0010 0602020001210203042005060000 0000"})
            peer.send_to(boost::asio::buffer(from_hex(form)), link.local());
    REQUIRE(support::until(context, [&] { return link.counts().received == 6; }));
    CHECK(counts().of(jaus::datagram_form::judp1) == 2);
    CHECK(counts().of(jaus::datagram_form::jaus01) == 2);
    CHECK(counts().of(jaus::datagram_form::judp1_compressed) == 2);
    REQUIRE(there.log.size() == 3);
    CHECK(there.log[0].find("it is AS5669-2007, which is not served here: give start a handler of RA messages") !=
          std::string::npos);
    CHECK(there.log[1].find("it is JAUS01.0") != std::string::npos);
    CHECK(there.log[2].find("it is AS5669-2007 with header compression") != std::string::npos);
    udp::socket second{context, udp::endpoint{boost::asio::ip::make_address("127.0.0.2"), 0}};
    second.send_to(boost::asio::buffer(from_hex("4a41555330312e30 0602020001210203042005060000 0000")), link.local());
    REQUIRE(support::until(context, [&] { return link.counts().received == 7; }));
    REQUIRE(there.log.size() == 4);
    CHECK(there.log[3].find("from 127.0.0.2:") != std::string::npos);
}

TEST_CASE("a node of the RA behind the same port answers messages of AS5669-2007 and JAUS01.0") {
    boost::asio::io_context context;
    station there{component};
    net::judp_link link{context, there.transport, unicast()};
    const net::jaus_config config{
        .this_system = "robot",
        .systems = {{.name = "robot", .jausip = {0, 0, 1, 126}, .ip = loopback, .port = link.local().port()}}};
    net::node_machine node{config,
                           {.accept = net::access::open},
                           [&](std::span<const std::byte> message, const udp::endpoint& to, jaus::framing framing) {
                               static_cast<void>(link.send_ra(message, to, framing));
                           },
                           1};
    node.start(net::now());
    link.start(there.handlers(),
               [&](std::span<const std::byte> message, const udp::endpoint& from, jaus::framing framing) {
                   CHECK(node.on_datagram(message, from, framing, false, net::now()) == net::verdict::accepted);
                   if (node.next_event()) node.on_time(net::now());
               });
    udp::socket peer{context, udp::endpoint{loopback, 0}};
    // Query Identification of 7.1.32.1 to the node manager.
    for (const auto framing : {jaus::framing::judp1, jaus::framing::jaus01}) {
        auto bytes = from_hex("0602 002b 0101017e 01200107 0100 0000 02");
        const jaus::message_prefix prefix{framing, bytes.size()};
        bytes.insert(bytes.begin(), prefix.bytes().begin(), prefix.bytes().end());
        peer.send_to(boost::asio::buffer(bytes), link.local());
        unsigned code = 0;
        while (code != 0x4B00) {
            REQUIRE(support::until(context, [&] { return peer.available() != 0; }));
            const auto got = receive(peer);
            const auto part = jaus::remove_framing(got);
            const auto m = jaus::split(part.message);
            REQUIRE(m);
            if (m.header.command_code == 0x4B00) CHECK(part.how == framing);
            code = m.header.command_code;
        }
    }
    CHECK(there.received.empty());
    CHECK(there.log.empty());
}

namespace {

net::jaus_config robot_with_peer(std::uint16_t port, std::string_view peer_ip, net::rate limit) {
    return {.this_system = "robot",
            .systems = {{.name = "robot", .jausip = {0, 0, 1, 126}, .ip = loopback, .port = port},
                        {.name = "peer",
                         .jausip = {0, 0, 0, 7},
                         .ip = boost::asio::ip::make_address(peer_ip),
                         .port = 9, // its heartbeats are no matter here
                         .any_source_port = true,
                         .limits = {.messages = limit}}}};
}

} // namespace

TEST_CASE("a node of the RA hands SAE JAUS on, and both are answered from its one port") {
    boost::asio::io_context context;
    station there{component};
    std::optional<net::shared_judp> link;
    net::jaus_node_options options{
        .log = [&](std::string_view line) { there.log.emplace_back(line); },
        .on_sae_datagram = [&](std::span<const std::byte> datagram,
                               const udp::endpoint& from) { link->on_datagram(datagram, from); }};
    const auto port = support::free_ports<1>()[0];
    net::jaus_node node{context, robot_with_peer(port, "127.0.0.1", {.per_second = 1000, .burst = 100}), options};
    link.emplace(context, there.transport, [&](std::span<const std::byte> datagram, const udp::endpoint& to) {
        return node.send_datagram(datagram, to);
    });
    CHECK(node.send_datagram(from_hex("02"), {loopback, port}).error().code == net::errc::not_running);
    node.start();
    link->start(there.handlers());
    udp::socket peer{context, udp::endpoint{loopback, 0}};
    const udp::endpoint robot{loopback, port};
    peer.send_to(boost::asio::buffer(from_hex("02 00 1100 11 0A017E00 14017E00 0D00 C8 0100")), robot);
    REQUIRE(support::until(context, [&] { return peer.available() != 0; }));
    udp::endpoint answered_by;
    byte_vector answer(2048);
    answer.resize(peer.receive_from(boost::asio::buffer(answer.data(), answer.size()), answered_by));
    CHECK(to_hex(answer) == test::hex_of("02 00 0E00 31 14017E00 0A017E00 0100"));
    CHECK(answered_by == robot);
    REQUIRE(there.received.size() == 1);
    CHECK(to_hex(there.received[0]) == "0d 00 c8");
    // Query Identification of 7.1.32.1, bare and behind JAUS01.0, to the node manager.
    for (const std::string_view prefix : {"", "4a41555330312e30"}) {
        auto query = from_hex(prefix);
        const auto bare = from_hex("0602 002b 0101017e 01200107 0100 0000 02");
        query.insert(query.end(), bare.begin(), bare.end());
        peer.send_to(boost::asio::buffer(query), robot);
    }
    REQUIRE(support::until(context, [&] { return node.counts().received == 3; }));
    CHECK(there.received.size() == 1);
    CHECK(
        std::ranges::none_of(there.log, [](const std::string& line) { return line.find("is refused") != line.npos; }));
    for (const auto sent_from : std::array<std::uint16_t, 2>{9, 10})
        link->on_datagram(from_hex("02"), {udp::v6(), sent_from});
    CHECK(std::ranges::count_if(
              there.log, [](const std::string& line) { return line.find("JUDP needs IPv4") != line.npos; }) == 1);
    node.stop();
    link->stop();
}

TEST_CASE("SAE JAUS at a node of the RA has its access list and rate limits, and garbage hurts neither") {
    boost::asio::io_context context;
    std::vector<std::string> log;
    std::size_t taken = 0;
    net::jaus_node_options options{
        .log = [&](std::string_view line) { log.emplace_back(line); },
        .on_sae_datagram = [&](std::span<const std::byte>, const udp::endpoint&) { ++taken; }};
    const auto port = support::free_ports<1>()[0];
    net::jaus_node node{context, robot_with_peer(port, "127.0.0.2", {.per_second = 1, .burst = 2}), options};
    node.start();
    const udp::endpoint robot{loopback, port};
    const auto from = [&](const char* ip) {
        return udp::socket{context, udp::endpoint{boost::asio::ip::make_address(ip), 0}};
    };
    auto stranger = from("127.0.0.3"), peer = from("127.0.0.2");
    const auto query = from_hex("02 00 1000 01 0A017E00 14017E00 0220 0200");
    stranger.send_to(boost::asio::buffer(query), robot);
    REQUIRE(support::until(context, [&] { return node.counts().unknown_peer == 1; }));
    REQUIRE(log.size() == 1);
    CHECK(log[0] == "a datagram of SAE JAUS from 127.0.0.3:" + std::to_string(stranger.local_endpoint().port()) +
                        " is refused: no system of the configuration has this host; give it as ip of one");
    for (int i = 0; i != 3; ++i) peer.send_to(boost::asio::buffer(query), robot);
    REQUIRE(support::until(context, [&] { return node.counts().rate_limited == 1; }));
    CHECK(taken == 2);
    for (const std::string_view garbage : {"02", "02 00 1000 01 0A", "02 00 ff00 01 0A017E00 14017E00 0220 0200", "ff"})
        stranger.send_to(boost::asio::buffer(from_hex(garbage)), robot);
    REQUIRE(support::until(context, [&] { return node.counts().malformed == 4; }));
    CHECK(taken == 2);
    CHECK(node.running());
}

TEST_CASE("a node of the RA receives the group of SAE JAUS, and a transport sends to it from the node's port") {
    boost::asio::io_context context;
    const auto ports = support::free_ports<2>(boost::asio::ip::address_v4::any());
    auto group = net::judp_multicast();
    CHECK(group.ttl == 16);
    CHECK(group.port == 3794);
    CHECK(group.group == boost::asio::ip::make_address("239.255.0.1"));
    group.port = ports[0];
    group.interface_name = "lo";
    group.ttl = 0;
    station here{controller}, there{component};
    std::optional<net::shared_judp> link;
    net::jaus_node_options options{
        .accept = net::access::open,
        .log = [&](std::string_view line) { there.log.emplace_back(line); },
        .on_sae_datagram = [&](std::span<const std::byte> datagram,
                               const udp::endpoint& from) { link->on_datagram(datagram, from); },
        .sae_group = group};
    net::jaus_node node{context, robot_with_peer(ports[1], "127.0.0.2", {}), options};
    link.emplace(
        context, there.transport,
        [&](std::span<const std::byte> datagram, const udp::endpoint& to) { return node.send_datagram(datagram, to); },
        udp::endpoint{group.group, group.port});
    node.start();
    link->start(there.handlers());
    net::judp_link other{
        context, here.transport, {.local = {udp::v4(), ports[0]}, .socket = {.reuse_address = true}, .group = group}};
    other.start(here.handlers());
    REQUIRE(other.send({.source = controller, .destination = component, .is_acknowledged = true}, from_hex("0d00 c8")));
    REQUIRE(support::until(context, [&] { return !here.outcomes.empty(); }));
    CHECK(here.outcomes.back() == sae::sent_outcome::acknowledged);
    CHECK(there.received.size() == 1);
    REQUIRE(link->send({.source = component, .destination = sae::everybody, .broadcast = sae::broadcast::global},
                       from_hex("002b 02")));
    REQUIRE(support::until(context, [&] { return here.received.size() == 1; }));
    CHECK(net::judp_link::endpoint_of(here.transport.peers().find(component)->endpoint).port() == ports[1]);
}

TEST_CASE("a link that cannot open its port says so") {
    boost::asio::io_context context;
    station there{component};
    const udp::socket holder{context, udp::endpoint{loopback, 0}};
    const auto code = [](auto open) {
        try {
            open();
        } catch (const net::open_error& error) {
            return error.code();
        }
        return net::errc::ok;
    };
    CHECK(code([&] {
              const net::judp_link link{context, there.transport, {.local = holder.local_endpoint(), .group = {}}};
          }) == net::errc::address_in_use);
    CHECK(code([&] {
              const net::judp_link link{
                  context, there.transport, {.local = {boost::asio::ip::address_v6::loopback(), 0}, .group = {}}};
          }) == net::errc::invalid_address);
    const tcp::acceptor acceptor{context, tcp::endpoint{loopback, 0}};
    CHECK(code([&] { const net::jtcp_link link{context, there.transport, {.listen = acceptor.local_endpoint()}}; }) ==
          net::errc::address_in_use);
    CHECK(code([&] { const net::jserial_link link{context, there.transport, {.device = "/dev/no-such-line"}}; }) ==
          net::errc::not_opened);
}

TEST_CASE("a peer over TCP sends and gets one version byte, and messages in any pieces") {
    boost::asio::io_context context;
    station there{component};
    net::jtcp_link link{context, there.transport, {.listen = tcp::endpoint{loopback, 0}}};
    there.on_message = [&](const sae::received_message& m) {
        REQUIRE(link.send({.source = component, .destination = m.header.source}, from_hex("0f00 00")));
    };
    link.start(there.handlers());
    tcp::socket peer{context};
    peer.connect(link.local());
    peer.set_option(tcp::no_delay{true});
    const auto all = from_hex("02 00 1100 11 0A017E00 14017E00 0D00 C8 0100 00 1100 01 0A017E00 14017E00 0D00 C8 0200");
    for (std::size_t at = 0; at != all.size(); at += 5) { // each piece is received before the next one is sent
        boost::asio::write(peer, boost::asio::buffer(all.data() + at, 5));
        if (at == 15) REQUIRE(support::until(context, [&] { return there.received.size() == 1; }));
    }
    REQUIRE(support::until(context, [&] { return there.received.size() == 2; }));
    byte_vector answer(1 + 14 + 17 + 17);
    std::size_t got = 0;
    boost::asio::async_read(peer, boost::asio::buffer(answer.data(), answer.size()),
                            [&](const boost::system::error_code&, std::size_t size) { got = size; });
    REQUIRE(support::until(context, [&] { return got != 0; }));
    CHECK(to_hex(answer) == test::hex_of("02 00 0E00 31 14017E00 0A017E00 0100"
                                         "00 1100 01 14017E00 0A017E00 0F00 00 0100"
                                         "00 1100 01 14017E00 0A017E00 0F00 00 0200"));
    CHECK(link.connections() == 1);
    peer.close();
    REQUIRE(support::until(context, [&] { return link.connections() == 0; }));
    CHECK(there.transport.peers().find(controller) == nullptr);
}

TEST_CASE("two links over TCP exchange long messages and broadcasts") {
    boost::asio::io_context context;
    station here{controller}, there{component};
    net::jtcp_link to{context, there.transport, {.listen = tcp::endpoint{loopback, 0}}};
    net::jtcp_link from{context, here.transport, {.listen = {}}};
    to.start(there.handlers());
    from.start(here.handlers());
    from.connect(to.local());
    REQUIRE(support::until(context, [&] { return from.connections() == 1 && to.connections() == 1; }));
    REQUIRE(from.send({.source = controller, .destination = component, .is_acknowledged = true}, from_hex("0220")));
    REQUIRE(support::until(context, [&] { return here.outcomes.size() == 1; }));
    CHECK(here.outcomes[0] == sae::sent_outcome::acknowledged);
    const auto payload = long_payload();
    REQUIRE(from.send({.source = controller, .destination = component, .is_acknowledged = true}, payload));
    REQUIRE(support::until(context, [&] { return here.outcomes.size() == 2; }));
    CHECK(here.outcomes[1] == sae::sent_outcome::acknowledged);
    REQUIRE(there.received.size() == 2);
    CHECK(there.received[1] == payload);
    REQUIRE(to.send({.source = component, .destination = sae::everybody, .broadcast = sae::broadcast::global},
                    from_hex("002b 02")));
    REQUIRE(support::until(context, [&] { return here.received.size() == 1; }));
    from.stop();
    REQUIRE(support::until(context, [&] { return to.connections() == 0; }));
}

TEST_CASE("connections of another version, of other hosts and above the limit are closed") {
    boost::asio::io_context context;
    station there{component};
    net::jtcp_link link{context,
                        there.transport,
                        {.listen = tcp::endpoint{loopback, 0},
                         .max_connections = 1,
                         .accepted = {boost::asio::ip::make_address("127.0.0.2")}}};
    link.start(there.handlers());
    const auto from = [&](std::string_view host) {
        tcp::socket socket{context, tcp::endpoint{boost::asio::ip::make_address(host), 0}};
        socket.connect(link.local());
        return socket;
    };
    auto stranger = from("127.0.0.1");
    REQUIRE(support::until(context, [&] { return link.counts().unknown_peer == 1; }));
    auto first = from("127.0.0.2");
    REQUIRE(support::until(context, [&] { return link.connections() == 1; }));
    auto second = from("127.0.0.2");
    REQUIRE(support::until(context, [&] { return link.counts().no_capacity == 1; }));
    boost::asio::write(first, boost::asio::buffer(from_hex("01")));
    REQUIRE(support::until(context, [&] { return link.counts().wrong == 1; }));
    CHECK(link.connections() == 0);
}

TEST_CASE("links that are destroyed while they send leave no handler behind") {
    boost::asio::io_context context;
    station here{controller}, there{component};
    std::optional<net::jtcp_link> to{std::in_place, context, there.transport,
                                     net::jtcp_options{.listen = tcp::endpoint{loopback, 0}}};
    std::optional<net::jtcp_link> from{std::in_place, context, here.transport, net::jtcp_options{.listen = {}}};
    to->start(there.handlers());
    from->start(here.handlers());
    from->connect(to->local());
    REQUIRE(support::until(context, [&] { return from->connections() == 1 && to->connections() == 1; }));
    for (const auto end : {true, false}) {
        auto& link = end ? from : to;
        REQUIRE(link->send({.source = end ? controller : component,
                            .destination = sae::everybody,
                            .broadcast = sae::broadcast::global},
                           from_hex("002b 02")));
    }
    from.reset();
    to.reset();
    context.restart();
    context.run();
    CHECK(here.received.empty());
    CHECK(there.received.empty());
}

TEST_CASE("a link may be stopped by its handler") {
    boost::asio::io_context context;
    station there{component};
    net::jtcp_link link{context, there.transport, {.listen = tcp::endpoint{loopback, 0}}};
    there.on_message = [&](const sae::received_message&) { link.stop(); };
    link.start(there.handlers());
    tcp::socket peer{context};
    peer.connect(link.local());
    const auto two = from_hex("02 00 1100 11 0A017E00 14017E00 0D00 C8 0100 00 1100 01 0A017E00 14017E00 0D00 C8 0200");
    boost::asio::write(peer, boost::asio::buffer(two));
    REQUIRE(support::until(context, [&] { return !there.received.empty(); }));
    context.restart();
    context.run();
    CHECK(there.received.size() == 1);
    CHECK(link.connections() == 0);
}

TEST_CASE("pauses between attempts double up to the longest, and begin anew after a success") {
    net::growing_pause pause{{.first = 250ms, .longest = 1s}};
    for (const auto expected : {250ms, 500ms, 1000ms, 1000ms}) CHECK(pause.next() == expected);
    pause.reset();
    CHECK(pause.next() == 250ms);
    net::growing_pause endless{{.first = duration::max(), .longest = duration::max()}};
    CHECK(endless.next() == duration::max());
    CHECK(endless.next() == duration::max());
}

TEST_CASE("a connection that is refused is made as soon as the peer listens, and again after the peer has closed it") {
    boost::asio::io_context context;
    station here{controller};
    net::jtcp_link link{context, here.transport, {.listen = {}, .reconnect = {.first = 1ms, .longest = 5ms}}};
    link.start(here.handlers());
    tcp::acceptor acceptor{context, tcp::v4()}; // it refuses connections until it listens
    acceptor.bind({loopback, 0});
    const auto there = acceptor.local_endpoint();
    const auto name = "127.0.0.1:" + std::to_string(there.port());
    link.connect(there);
    REQUIRE(support::until(context, [&] { return link.counts().failed == 3; }));
    REQUIRE(here.log.size() == 1); // one reason is told once
    CHECK(here.log[0] ==
          "cannot connect to " + name +
              ": Connection refused; it is tried again: start the program there, or correct the address");
    CHECK(link.connections() == 0);

    acceptor.listen();
    for (const std::uint64_t connections : {1U, 2U}) {
        tcp::socket peer{context};
        bool is_accepted = false;
        acceptor.async_accept(peer, [&](const boost::system::error_code& error) { is_accepted = !error; });
        REQUIRE(support::until(context, [&] { return is_accepted && link.connections() == 1; }));
        CHECK(link.counts().connected == connections);
        CHECK(here.log.back() == "connected to " + name + " again");
        // A message is received over the new connection.
        auto message = from_hex("02 00 1100 01 14017E00 0A017E00 0F00 00 0000");
        message[16] = static_cast<std::byte>(connections); // its number
        boost::asio::write(peer, boost::asio::buffer(message));
        REQUIRE(support::until(context, [&] { return here.received.size() == connections; }));
        peer.close();
        REQUIRE(support::until(context, [&] { return link.connections() == 0; }));
        CHECK(here.log.back() ==
              "the connection with " + name + " has ended: the peer has closed it; it is made again");
    }
    link.stop();
    const auto failed = link.counts().failed;
    context.restart();
    context.run(); // nothing is tried after stop
    CHECK(link.counts().failed == failed);
}

TEST_CASE("an attempt to connect to a host that does not answer ends after the timeout, and is made again") {
    boost::asio::io_context context;
    tcp::acceptor acceptor{context, tcp::v4()};
    acceptor.bind({loopback, 0});
    acceptor.listen(0); // one connection waits to be accepted; requests for others get no answer
    tcp::socket waiting{context};
    waiting.connect(acceptor.local_endpoint());
    const auto name = "127.0.0.1:" + std::to_string(acceptor.local_endpoint().port());
    station here{controller};
    net::jtcp_link link{
        context, here.transport, {.listen = {}, .connect_timeout = 20ms, .reconnect = {.first = 1ms, .longest = 5ms}}};
    link.start(here.handlers());
    link.connect(acceptor.local_endpoint());
    REQUIRE(support::until(context, [&] { return link.counts().failed == 2; }));
    CHECK(here.log == std::vector<std::string>{"cannot connect to " + name +
                                               ": no answer within 20 ms (option connect_timeout); it is tried again:"
                                               " start the program there, or correct the address"});
    std::vector<tcp::socket> accepted;
    std::function<void()> accept = [&] {
        acceptor.async_accept([&](const boost::system::error_code& error, tcp::socket socket) {
            if (error) return;
            accepted.push_back(std::move(socket));
            accept();
        });
    };
    accept();
    REQUIRE(support::until(context, [&] { return link.counts().connected == 1; }));
    CHECK(here.log.back() == "connected to " + name + " again");
    CHECK(link.connections() == 1);
}

TEST_CASE("a link that stops while it connects keeps no handler waiting") {
    boost::asio::io_context context;
    tcp::acceptor acceptor{context, tcp::v4()};
    acceptor.bind({loopback, 0});
    acceptor.listen(0);
    tcp::socket waiting{context};
    waiting.connect(acceptor.local_endpoint());
    station here{controller};
    net::jtcp_link link{context, here.transport, {.listen = {}, .connect_timeout = {}}};
    link.start(here.handlers());
    link.connect(acceptor.local_endpoint());
    context.poll();
    CHECK_FALSE(context.stopped());
    link.stop();
    context.run(); // returns long before the system gives up
    CHECK(link.counts().failed == 0);
    CHECK(here.log.empty());
}

TEST_CASE("an accepted connection that says nothing is closed after the idle limit, one that speaks is kept") {
    boost::asio::io_context context;
    station there{component};
    net::jtcp_link link{context, there.transport, {.listen = tcp::endpoint{loopback, 0}, .idle_limit = 400ms}};
    link.start(there.handlers());
    tcp::socket silent{context}, speaking{context};
    silent.connect(link.local());
    speaking.connect(link.local());
    const auto silent_name = "127.0.0.1:" + std::to_string(silent.local_endpoint().port());
    boost::asio::steady_timer pause{context};
    std::function<void()> speak = [&] {
        boost::system::error_code ignored; // the version byte, then messages that are no one's
        boost::asio::write(speaking, boost::asio::buffer(from_hex("00 1000 01 63017E00 14017E00 0220 0200")), ignored);
        pause.expires_after(20ms);
        pause.async_wait([&](const boost::system::error_code& aborted) {
            if (!aborted) speak();
        });
    };
    boost::asio::write(speaking, boost::asio::buffer(from_hex("02")));
    speak();
    REQUIRE(support::until(context, [&] { return link.counts().idle != 0; }));
    CHECK(link.counts().idle == 1);
    CHECK(link.connections() == 1);
    REQUIRE(!there.log.empty());
    CHECK(there.log.back() ==
          "the connection with " + silent_name + " has ended: nothing came from it for longer than idle_limit");
}

TEST_CASE("keep-alive is set at the connection, in seconds, also for less than one") {
    boost::asio::io_context context;
    tcp::acceptor acceptor{context, tcp::endpoint{loopback, 0}};
    tcp::socket socket{context};
    socket.connect(acceptor.local_endpoint());
    const auto option = [&](int level, int name) {
        int value = -1;
        socklen_t size = sizeof value;
        REQUIRE(::getsockopt(socket.native_handle(), level, name, &value, &size) == 0);
        return value;
    };
    CHECK(option(SOL_SOCKET, SO_KEEPALIVE) == 0);
    REQUIRE(net::detail::set_keep_alive(socket, 12s));
    CHECK(option(SOL_SOCKET, SO_KEEPALIVE) == 1);
    CHECK(option(IPPROTO_TCP, TCP_KEEPIDLE) == 12);
    CHECK(option(IPPROTO_TCP, TCP_KEEPINTVL) == 4);
    CHECK(option(IPPROTO_TCP, TCP_KEEPCNT) == 3);
    CHECK(option(IPPROTO_TCP, TCP_USER_TIMEOUT) == 24'000);
    REQUIRE(net::detail::set_keep_alive(socket, 10ms));
    CHECK(option(IPPROTO_TCP, TCP_KEEPIDLE) == 1);
    CHECK(option(IPPROTO_TCP, TCP_KEEPINTVL) == 1);
}

TEST_CASE("garbage and a closed connection are told to the log, with the peer and the reason") {
    boost::asio::io_context context;
    station there{component};
    net::jtcp_link link{context, there.transport, {.listen = tcp::endpoint{loopback, 0}}};
    link.start(there.handlers());
    const auto open = [&] {
        tcp::socket socket{context};
        socket.connect(link.local());
        return socket;
    };
    auto garbage = open();
    boost::asio::write(garbage, boost::asio::buffer(std::string_view{"GET / HTTP/1.1"}));
    REQUIRE(support::until(context, [&] { return there.log.size() == 1; }));
    CHECK(there.log[0] == "the connection with 127.0.0.1:" + std::to_string(garbage.local_endpoint().port()) +
                              " has ended: " + std::string{describe(sae::transport_errc::wrong_version)});
    auto closed = open();
    const auto port = closed.local_endpoint().port();
    boost::asio::write(closed, boost::asio::buffer(from_hex("02 00 11")));
    REQUIRE(support::until(context, [&] { return link.connections() == 1; }));
    closed.close();
    REQUIRE(support::until(context, [&] { return there.log.size() == 2; }));
    CHECK(there.log[1] ==
          "the connection with 127.0.0.1:" + std::to_string(port) + " has ended: the peer has closed it");
    CHECK(there.received.empty());
}

TEST_CASE("a connection that is refused is reported") {
    boost::asio::io_context context;
    station here{controller};
    net::jtcp_link link{context, here.transport, {.listen = {}}};
    link.start(here.handlers());
    link.connect({loopback, support::free_ports<1>()[0]});
    REQUIRE(support::until(context, [&] { return !here.log.empty(); }));
    CHECK(here.log[0].starts_with("cannot connect to 127.0.0.1:"));
}

TEST_CASE("a peer at a serial line is answered in frames, past noise") {
    boost::asio::io_context context;
    const pseudo_terminal line;
    station there{component};
    net::jserial_link link{context, there.transport, {.device = line.device()}};
    link.start(there.handlers());
    boost::asio::posix::stream_descriptor peer{context, ::dup(line.master)};
    // Noise, and QueryStatus of 200.1.34 with acknowledgement request.
    byte_vector message(64), frame(128);
    const auto query =
        sae::join({.acknowledgement = sae::acknowledgement::request, .destination = component, .source = {34, 1, 200}},
                  from_hex("0220"), 1, message);
    REQUIRE(query);
    const auto framed = sae::put_serial_frame(*query, frame);
    REQUIRE(framed);
    boost::asio::write(peer, boost::asio::buffer(from_hex("ff 10 55")));
    boost::asio::write(peer, boost::asio::buffer(framed->data(), framed->size()));
    REQUIRE(support::until(context, [&] { return there.received.size() == 1; }));
    CHECK(to_hex(there.received[0]) == "02 20");
    byte_vector buffer(64), input(64), reply;
    sae::jserial_reader reader{buffer};
    std::function<void()> read = [&] {
        peer.async_read_some(boost::asio::buffer(input.data(), input.size()),
                             [&](const boost::system::error_code& error, std::size_t size) {
                                 if (error) return;
                                 reader.on_bytes(std::span{input}.first(size), [&](const sae::serial_frame& f) {
                                     reply.assign(f.message.begin(), f.message.end());
                                 });
                                 if (reply.empty()) read();
                             });
    };
    read();
    REQUIRE(support::until(context, [&] { return !reply.empty(); }));
    CHECK(to_hex(reply) == test::hex_of("00 0E00 31 2201C800 0A017E00 0100"));
    CHECK(link.counts().frames == 1);
    CHECK(link.counts().faults[static_cast<std::size_t>(sae::transport_errc::noise)] == 1);
}

TEST_CASE("two links at the ends of a serial line exchange a long message") {
    boost::asio::io_context context;
    const pseudo_terminal one, two; // their other ends are joined here
    station here{controller}, there{component};
    net::jserial_link from{context, here.transport, {.device = one.device()}};
    net::jserial_link to{context, there.transport, {.device = two.device()}};
    boost::asio::posix::stream_descriptor a{context, ::dup(one.master)}, b{context, ::dup(two.master)};
    support::join(a, b);
    from.start(here.handlers());
    to.start(there.handlers());
    REQUIRE(from.send({.source = controller, .destination = component, .is_acknowledged = true}, from_hex("0220")));
    REQUIRE(support::until(context, [&] { return here.outcomes.size() == 1; }));
    const auto payload = long_payload();
    REQUIRE(from.send({.source = controller, .destination = component, .is_acknowledged = true}, payload));
    REQUIRE(support::until(context, [&] { return here.outcomes.size() == 2; }));
    CHECK(here.outcomes == std::vector(2, sae::sent_outcome::acknowledged));
    REQUIRE(there.received.size() == 2);
    CHECK(there.received[1] == payload);
}

TEST_CASE("a serial line that goes away is opened again, and what is sent meanwhile is dropped") {
    boost::asio::io_context context;
    const auto device = std::filesystem::temp_directory_path() / ("jauscat-line-" + std::to_string(::getpid()));
    std::filesystem::remove(device);
    auto first = std::make_unique<pseudo_terminal>();
    std::filesystem::create_symlink(first->device(), device);
    station there{component};
    net::jserial_link link{
        context, there.transport, {.device = device.string(), .reopen = {.first = 1ms, .longest = 5ms}}};
    link.start(there.handlers());
    const auto send = [&](int master, std::uint16_t number) {
        byte_vector message(64), frame(128);
        const auto query =
            sae::join({.destination = component, .source = {34, 1, 200}}, from_hex("0220"), number, message);
        REQUIRE(query);
        const auto framed = sae::put_serial_frame(*query, frame);
        REQUIRE(framed);
        REQUIRE(::write(master, framed->data(), framed->size()) == static_cast<ssize_t>(framed->size()));
    };
    send(first->master, 1);
    REQUIRE(support::until(context, [&] { return there.received.size() == 1; }));

    std::filesystem::remove(device);
    first.reset();
    REQUIRE(support::until(context, [&] { return there.log.size() == 1; }));
    CHECK(there.log[0].starts_with("the serial line " + device.string() + " has failed: "));
    CHECK(there.log[0].ends_with("; it is opened again when it is there: see its cable and its power"));
    REQUIRE(link.send({.source = component, .destination = {34, 1, 200}}, from_hex("0240")));
    CHECK(link.counts().dropped == 1);
    CHECK(link.counts().reopened == 0);

    const pseudo_terminal second;
    std::filesystem::create_symlink(second.device(), device);
    REQUIRE(support::until(context, [&] { return link.counts().reopened == 1; }));
    CHECK(there.log.back() == "the serial line " + device.string() + " is open again");
    send(second.master, 2);
    REQUIRE(support::until(context, [&] { return there.received.size() == 2; }));
    CHECK(link.counts().frames == 2);
    REQUIRE(link.send({.source = component, .destination = {34, 1, 200}}, from_hex("0240")));
    boost::asio::posix::stream_descriptor peer{context, ::dup(second.master)};
    std::array<std::byte, 128> input{};
    std::size_t got = 0;
    peer.async_read_some(boost::asio::buffer(input),
                         [&](const boost::system::error_code&, std::size_t size) { got = size; });
    REQUIRE(support::until(context, [&] { return got != 0; }));
    std::filesystem::remove(device);
}
