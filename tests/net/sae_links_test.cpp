// SAE JAUS over UDP and TCP on the loopback interface, and over a pseudo-terminal.
#include "support/catch.hpp"
#include "support/free_ports.hpp"
#include "support/hex.hpp"
#include "support/until.hpp"
#include <jauscat/net/node/node_machine.hpp>
#include <jauscat/net/sae/jserial_link.hpp>
#include <jauscat/net/sae/jtcp_link.hpp>
#include <jauscat/net/sae/judp_link.hpp>

#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>

#include <cstdlib>
#include <fcntl.h>
#include <memory>
#include <termios.h>
#include <unistd.h>

using namespace jauscat;
using namespace std::chrono_literals;
using tcp = boost::asio::ip::tcp;
using udp = boost::asio::ip::udp;

namespace {

using byte_vector = std::vector<std::byte>;
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
std::string file_of(int descriptor) {
    std::array<char, 128> name{};
    REQUIRE(::ptsname_r(descriptor, name.data(), name.size()) == 0);
    return name.data();
}
/// A pseudo-terminal without line discipline; closed at the end.
struct pseudo_terminal {
    pseudo_terminal() {
        REQUIRE(master >= 0);
        REQUIRE(::grantpt(master) == 0);
        REQUIRE(::unlockpt(master) == 0);
        termios raw{};
        REQUIRE(::tcgetattr(master, &raw) == 0);
        ::cfmakeraw(&raw);
        REQUIRE(::tcsetattr(master, TCSANOW, &raw) == 0);
    }
    ~pseudo_terminal() {
        if (master >= 0) ::close(master);
    }
    pseudo_terminal(const pseudo_terminal&) = delete;
    pseudo_terminal& operator=(const pseudo_terminal&) = delete;

    int master{::posix_openpt(O_RDWR | O_NOCTTY)};
};

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

TEST_CASE("other forms of JAUS at the port are named once and counted") {
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
    CHECK(there.log[0].find("it is AS5669-2007, which is not served here") != std::string::npos);
    CHECK(there.log[1].find("it is JAUS01.0") != std::string::npos);
    CHECK(there.log[2].find("it is AS5669-2007 with header compression") != std::string::npos);
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

TEST_CASE("a connection that is refused is reported") {
    boost::asio::io_context context;
    station here{controller};
    net::jtcp_link link{context, here.transport, {.listen = {}}};
    link.start(here.handlers());
    link.connect({loopback, support::free_ports<1>()[0]});
    REQUIRE(support::until(context, [&] { return !here.log.empty(); }));
    CHECK(here.log[0].starts_with("cannot connect to 127.0.0.1 "));
}

TEST_CASE("a peer at a serial line is answered in frames, past noise") {
    boost::asio::io_context context;
    const pseudo_terminal line;
    station there{component};
    net::jserial_link link{context, there.transport, {.device = file_of(line.master)}};
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
    net::jserial_link from{context, here.transport, {.device = file_of(one.master)}};
    net::jserial_link to{context, there.transport, {.device = file_of(two.master)}};
    boost::asio::posix::stream_descriptor a{context, ::dup(one.master)}, b{context, ::dup(two.master)};
    std::array<std::byte, 256> from_a{}, from_b{};
    std::function<void(boost::asio::posix::stream_descriptor&, boost::asio::posix::stream_descriptor&,
                       std::array<std::byte, 256>&)>
        join = [&](auto& in, auto& out, auto& bytes) {
            in.async_read_some(boost::asio::buffer(bytes),
                               [&](const boost::system::error_code& error, std::size_t size) {
                                   if (error) return;
                                   boost::asio::async_write(out, boost::asio::buffer(bytes, size),
                                                            [&](const boost::system::error_code& failed, std::size_t) {
                                                                if (!failed) join(in, out, bytes);
                                                            });
                               });
        };
    join(a, b, from_a);
    join(b, a, from_b);
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
