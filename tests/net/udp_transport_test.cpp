// JAUS over UDP on the loopback interface: framings, limits, closed ports, garbage, and continued operation.
#include "support/allocations.hpp"
#include "support/catch.hpp"
#include "support/free_ports.hpp"
#include "support/until.hpp"
#include <jauscat/net/config/read_jaus_config.hpp>
#include <jauscat/net/link/udp_transport.hpp>
#include <jauscat/net/node/next_hop.hpp>
#include <jauscat/net/node/run_until.hpp>
#include <jauscat/wire/encode.hpp>

#include <boost/asio/ip/udp.hpp>

#include <algorithm>
#include <iostream>
#include <optional>
#include <random>
#include <string>
#include <vector>

using namespace jauscat;
using namespace std::chrono_literals;
using net::udp_transport;
using udp = boost::asio::ip::udp;

namespace {

using byte_vector = std::vector<std::byte>;

const udp::endpoint any_port{boost::asio::ip::make_address("127.0.0.1"), 0};

byte_vector bytes_of(std::string_view text) {
    const auto view = std::as_bytes(std::span{text});
    return {view.begin(), view.end()};
}

/// A transport that keeps what its handlers were given.
struct station {
    explicit station(boost::asio::io_context& context) : transport{context, any_port} {
        transport.start(
            [this](std::span<const std::byte> bytes, const udp::endpoint& sender, jaus::framing seen) {
                message.assign(bytes.begin(), bytes.end());
                from = sender;
                framing = seen;
            },
            [this](std::string_view text) { errors.emplace_back(text); });
    }

    /// Messages and errors so far.
    std::uint64_t events() const { return transport.counts().received + errors.size(); }

    udp_transport transport;
    byte_vector message{};
    udp::endpoint from{};
    jaus::framing framing{};
    std::vector<std::string> errors{};
};

/// A port on which nobody listens.
udp::endpoint closed_port(const boost::asio::ip::address& ip = boost::asio::ip::address_v4::loopback()) {
    return {ip, support::free_ports<1>(ip)[0]};
}

std::string text(const udp::endpoint& endpoint) { return "127.0.0.1:" + std::to_string(endpoint.port()); }

} // namespace

TEST_CASE("a message has the time that it waited in the socket") {
    boost::asio::io_context context;
    station sender{context};
    udp_transport receiver{context, any_port};
    std::vector<std::chrono::nanoseconds> waited;
    receiver.start(
        [&](std::span<const std::byte>, const udp::endpoint&, jaus::framing) { waited.push_back(receiver.waited()); },
        {});
    const auto after = [&](std::chrono::nanoseconds unread) {
        REQUIRE(sender.transport.send(bytes_of("old message"), receiver.local()));
        const auto begin = std::chrono::steady_clock::now();
        while (std::chrono::steady_clock::now() - begin < unread) {} // nobody receives
        const auto before = waited.size();
        REQUIRE(support::until(context, [&] { return waited.size() > before; }));
        CHECK(waited.back() <= std::chrono::steady_clock::now() - begin + 10ms);
        return waited.back();
    };
    // The kernel begins a moment later when no other socket of this machine wanted arrival times before.
    const auto give_up = std::chrono::steady_clock::now() + support::wait_limit;
    while (after(2ms) < 1ms) REQUIRE(std::chrono::steady_clock::now() < give_up);
    CHECK(after(50ms) >= 40ms); // by the clock of the kernel, which may be slewed
}

TEST_CASE("a message arrives unchanged in either framing") {
    boost::asio::io_context context;
    station sender{context};
    station receiver{context};
    for (const auto framing : {jaus::framing::bare, jaus::framing::jaus01}) {
        const auto message = bytes_of(framing == jaus::framing::bare ? "bare message" : "prefixed message");
        const auto before = receiver.events();
        REQUIRE(sender.transport.send(message, receiver.transport.local(), framing));
        REQUIRE(support::until(context, [&] { return receiver.events() > before; }));
        CHECK(receiver.message == message);
        CHECK(receiver.framing == framing);
        CHECK(receiver.from == sender.transport.local());
    }
    CHECK(sender.transport.counts().sent == 2);
    CHECK(receiver.transport.counts().received == 2);
    CHECK(receiver.transport.counts().errors == 0);
}

TEST_CASE("the prefix precedes the message on the wire") {
    boost::asio::io_context context;
    station sender{context};
    udp::socket peer{context, any_port};
    std::array<std::byte, 64> buffer{};
    const auto received = [&] {
        return byte_vector(buffer.begin(),
                           buffer.begin() + static_cast<std::ptrdiff_t>(peer.receive(boost::asio::buffer(buffer))));
    };

    REQUIRE(sender.transport.send(bytes_of("message"), peer.local_endpoint(), jaus::framing::jaus01));
    CHECK(received() == bytes_of("JAUS01.0message"));
    REQUIRE(sender.transport.send(bytes_of("message"), peer.local_endpoint()));
    CHECK(received() == bytes_of("message"));
}

TEST_CASE("a port in use is reported with a command that finds its owner") {
    boost::asio::io_context context;
    const station first{context};
    const auto port = std::to_string(first.transport.local().port());
    try {
        udp_transport second{context, first.transport.local()};
        FAIL("two transports at one port");
    } catch (const net::open_error& error) {
        CHECK(std::string{error.what()} == "cannot receive at UDP 127.0.0.1:" + port +
                                               ": Address already in use; find the program that holds the port with: "
                                               "ss -ulpn 'sport = :" +
                                               port + "'");
    }
}

TEST_CASE("an address of another machine cannot be bound") {
    boost::asio::io_context context;
    try {
        udp_transport transport{context, {boost::asio::ip::make_address("192.0.2.1"), 39777}};
        FAIL("bound to a foreign address");
    } catch (const net::open_error& error) {
        CHECK(std::string{error.what()}.starts_with("cannot receive at UDP 192.0.2.1:39777: Cannot assign"));
        CHECK(std::string{error.what()}.ends_with("this machine does not have that address: see ip -brief address"));
        CHECK(error.code() == net::errc::unknown_address);
    }
}

TEST_CASE("a closed port at the peer is reported with its address, and the transport continues to work") {
    boost::asio::io_context context;
    station sender{context};
    station receiver{context};
    const auto closed = closed_port();

    REQUIRE(sender.transport.send(bytes_of("to nobody"), closed));
    REQUIRE(support::until(context, [&] { return !sender.errors.empty(); }));
    CHECK(sender.errors == std::vector{text(closed) + ": closed port: no program receives there"});
    CHECK(sender.transport.counts().refused == 1);

    REQUIRE(receiver.transport.send(bytes_of("to the sender"), sender.transport.local()));
    REQUIRE(support::until(context, [&] { return !sender.message.empty(); }));
    CHECK(sender.message == bytes_of("to the sender"));
}

TEST_CASE("an absent peer is reported once, and again after it was present") {
    boost::asio::io_context context;
    station sender{context};
    const auto peer_port = closed_port();
    const auto refused = [&](std::uint64_t count) {
        REQUIRE(sender.transport.send(bytes_of("heartbeat"), peer_port));
        REQUIRE(support::until(context, [&] { return sender.transport.counts().refused == count; }));
    };
    for (const std::uint64_t count : {1U, 2U, 3U}) refused(count);
    CHECK(sender.errors == std::vector{text(peer_port) + ": closed port: no program receives there"});
    {
        udp_transport peer{context, peer_port};
        REQUIRE(peer.send(bytes_of("here"), sender.transport.local()));
        REQUIRE(support::until(context, [&] { return !sender.message.empty(); }));
        peer.stop();
    }
    for (const std::uint64_t count : {4U, 5U}) refused(count);
    CHECK(sender.errors.size() == 2);
}

TEST_CASE("a closed port at one peer does not lose the next message to another") {
    boost::asio::io_context context;
    station sender{context};
    station receiver{context};
    const auto closed = closed_port();

    // On the loopback interface the refusal is there before `send` returns; the io_context does not run in between.
    REQUIRE(sender.transport.send(bytes_of("to nobody"), closed));
    REQUIRE(sender.transport.send(bytes_of("to somebody"), receiver.transport.local()));
    CHECK(sender.errors == std::vector{text(closed) + ": closed port: no program receives there"});
    REQUIRE(support::until(context, [&] { return receiver.events() > 0; }));
    CHECK(receiver.message == bytes_of("to somebody"));
    CHECK(sender.transport.counts().sent == 2);
    CHECK(sender.transport.counts().refused == 1);
    CHECK(sender.transport.counts().errors == 0);
}

TEST_CASE("datagrams without a message are reported") {
    boost::asio::io_context context;
    station receiver{context};
    udp::socket peer{context, any_port};
    for (const std::string_view content : {"", "JAUS01.0"}) {
        receiver.errors.clear();
        peer.send_to(boost::asio::buffer(content), receiver.transport.local());
        REQUIRE(support::until(context, [&] { return !receiver.errors.empty(); }));
        CHECK(receiver.errors == std::vector{"a datagram from " + text(peer.local_endpoint()) + " holds no message"});
    }
    CHECK(receiver.transport.counts().received == 0);
    CHECK(receiver.transport.counts().errors == 2);
}

TEST_CASE("messages up to 65507 bytes are sent, larger and empty ones are not") {
    boost::asio::io_context context;
    station sender{context};
    station receiver{context};
    byte_vector message(65507);
    std::generate(message.begin(), message.end(), [n = 0u]() mutable { return static_cast<std::byte>(n++ * 7u); });
    REQUIRE(sender.transport.send(message, receiver.transport.local()));
    REQUIRE(support::until(context, [&] { return receiver.events() > 0; }));
    CHECK(receiver.message == message);

    const auto with_prefix = sender.transport.send(message, receiver.transport.local(), jaus::framing::jaus01);
    CHECK_FALSE(with_prefix);
    CHECK(with_prefix.error().code == net::errc::too_large);
    CHECK(with_prefix.error().message ==
          "a message of 65507 bytes does not fit a datagram of 65507 bytes; send it in several packets");
    message.push_back({});
    CHECK_FALSE(sender.transport.send(message, receiver.transport.local()));
    CHECK(sender.transport.send({}, receiver.transport.local()).error().message == "an empty message is not sent");
    CHECK(sender.transport.counts().sent == 1);
    CHECK(sender.transport.counts().errors == 3);
}

TEST_CASE("a datagram larger than IPv4 allows is dropped with a report") {
    boost::asio::io_context context;
    const udp::endpoint v6{boost::asio::ip::make_address("::1"), 0};
    std::optional<udp::socket> peer;
    try {
        peer.emplace(context, v6);
    } catch (const boost::system::system_error&) {
        std::cout << "SKIPPED: no IPv6 loopback on this machine\n";
        return;
    }
    udp_transport transport{context, v6};
    std::string error;
    transport.start([](auto...) { FAIL("an oversized datagram was handed on"); },
                    [&](std::string_view text) { error = text; });
    peer->send_to(boost::asio::buffer(byte_vector(65508)), transport.local());
    REQUIRE(support::until(context, [&] { return !error.empty(); }));
    CHECK(error == "a datagram from [::1]:" + std::to_string(peer->local_endpoint().port()) +
                       " is larger than 65507 bytes and was dropped");

    const auto closed = closed_port(v6.address());
    error.clear();
    REQUIRE(transport.send(bytes_of("to nobody"), closed));
    REQUIRE(support::until(context, [&] { return !error.empty(); }));
    CHECK(error == "[::1]:" + std::to_string(closed.port()) + ": closed port: no program receives there");
}

TEST_CASE("ten thousand datagrams of random content and size are all counted") {
    boost::asio::io_context context;
    station receiver{context};
    udp::socket peer{context, any_port};
    std::mt19937 random{20240607};
    std::uniform_int_distribution<std::size_t> size{0, 600};
    std::uniform_int_distribution<int> value{0, 255};
    const jaus::message_prefix mark{jaus::framing::jaus01, 0};
    const auto prefix = mark.bytes();
    byte_vector content;
    for (std::uint64_t n = 1; n <= 10'000; ++n) {
        content.resize(size(random));
        std::generate(content.begin(), content.end(), [&] { return static_cast<std::byte>(value(random)); });
        if (n % 4 == 0 && content.size() >= prefix.size()) std::ranges::copy(prefix, content.begin());
        peer.send_to(boost::asio::buffer(content), receiver.transport.local());
        REQUIRE(support::until(context, [&] { return receiver.events() == n; }));
    }
}

TEST_CASE("sending and receiving allocate nothing") {
    boost::asio::io_context context;
    udp_transport sender{context, any_port};
    udp_transport receiver{context, any_port};
    std::size_t seen = 0;
    receiver.start(
        [&](std::span<const std::byte> message, const udp::endpoint&, jaus::framing) { seen += message.size(); },
        [](std::string_view) {});
    const auto message = bytes_of("sixteen bytes ..");
    const auto exchange = [&](std::size_t times) {
        for (std::size_t i = 0; i < times; ++i) {
            if (!sender.send(message, receiver.local(), jaus::framing::jaus01)) return;
            const auto wanted = seen + message.size();
            support::until(context, [&] { return seen == wanted; });
        }
    };
    exchange(10);
    const auto before = support::allocations();
    exchange(1000);
    CHECK(support::allocations() - before == 0);
    CHECK(seen == 1010 * message.size());
}

TEST_CASE("a stopped transport calls no handler and refuses to send") {
    boost::asio::io_context context;
    station receiver{context};
    udp::socket peer{context, any_port};
    const auto address = receiver.transport.local();
    peer.send_to(boost::asio::buffer(std::string_view{"too late"}), address);
    receiver.transport.stop();
    context.run_for(1s); // ends at once: no work is left
    CHECK(context.stopped());
    CHECK(receiver.events() == 0);
    const auto refused = receiver.transport.send(bytes_of("x"), peer.local_endpoint());
    CHECK(refused.error().message.starts_with("cannot send to " + text(peer.local_endpoint())));
    CHECK_NOTHROW(udp_transport{context, address}); // the port is free again
}

TEST_CASE("a transport can be destroyed while datagrams wait for it") {
    boost::asio::io_context context;
    udp::socket peer{context, any_port};
    std::array<std::unique_ptr<udp_transport>, 2> transports;
    int handled = 0;
    for (auto& transport : transports) {
        transport = std::make_unique<udp_transport>(context, any_port);
        transport->start([&](auto...) { ++handled; }, [](std::string_view) {});
        peer.send_to(boost::asio::buffer(std::string_view{"message"}), transport->local());
    }
    // One poll of the system queues both completions; the first is handled, the other finds its transport gone.
    context.run_one_for(5s);
    for (auto& transport : transports) transport.reset();
    context.run_for(1s);
    CHECK(context.stopped());
    CHECK(handled == 1);
}

TEST_CASE("waiting without messages ends at its deadline") {
    boost::asio::io_context context;
    const station alone{context};
    const auto start = std::chrono::steady_clock::now();
    CHECK_FALSE(net::run_until(context, 20ms, [] { return false; }));
    CHECK(std::chrono::steady_clock::now() - start >= 20ms);
}

TEST_CASE("a message is sent to the system of its destination, in that system's framing") {
    boost::asio::io_context context;
    station here{context};
    station there{context};
    const auto system = [](const std::string& name, const std::string& jausip, const station& at,
                           const std::string& framing) {
        return "<system name='" + name + "' jausip='" + jausip + "' ip='127.0.0.1' port='" +
               std::to_string(at.transport.local().port()) + "' framing='" + framing + "'/>";
    };
    const auto config = net::parse_jaus_config("<jausconfig thissystem='a'>" + system("a", "1.0.0.0", here, "bare") +
                                                   system("b", "2.0.0.0", there, "JAUS01.0") + "</jausconfig>",
                                               "test.xml");
    std::array<std::byte, 16> message{};
    jaus::header header{.command_code = 0x0003};
    header.destination = {1, 33, 1, 2};
    REQUIRE(wire::encode(header, message));
    REQUIRE(net::send_to_next_hop(here.transport, config, message));
    REQUIRE(support::until(context, [&] { return there.events() > 0; }));
    CHECK(std::ranges::equal(there.message, message));
    CHECK(there.framing == jaus::framing::jaus01);

    header.destination = {1, 33, 1, 7};
    REQUIRE(wire::encode(header, message));
    CHECK(net::send_to_next_hop(here.transport, config, message).error().message ==
          "no route to 7.1.33.1: no <system> of test.xml has a jausip that covers it");
    CHECK(net::send_to_next_hop(here.transport, config, std::span{message}.first(15)).error().message ==
          "no JAUS header in 15 bytes: truncated: the bytes end before the last field");
    CHECK(here.transport.counts().sent == 1);
}
