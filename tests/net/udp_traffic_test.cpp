// JAUS over UDP under load and with options: batches, back-pressure, filters, multicast, shared ports, both IP
// versions.
#include "support/allocations.hpp"
#include "support/catch.hpp"
#include "support/until.hpp"
#include <jauscat/net/link/udp_transport.hpp>

#include <iostream>
#include <net/if.h>
#include <optional>
#include <string>
#include <sys/socket.h>
#include <vector>

using namespace jauscat;
using namespace std::chrono_literals;
using net::udp_transport;
using udp = boost::asio::ip::udp;

namespace {

udp::endpoint at(const char* ip, std::uint16_t port = 0) { return {boost::asio::ip::make_address(ip), port}; }
const auto any_port = at("127.0.0.1");

std::string text_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
std::span<const std::byte> bytes_of(std::string_view text) { return std::as_bytes(std::span{text}); }

/// A transport that keeps the messages it was given.
struct station {
    explicit station(boost::asio::io_context& context, const udp::endpoint& local = any_port,
                     const net::udp_options& options = {})
        : transport{context, local, options} {
        start();
    }
    void start() {
        transport.start(
            [this](std::span<const std::byte> bytes, const udp::endpoint& sender, jaus::framing) {
                messages.push_back(text_of(bytes));
                from = sender;
                if (on_message) on_message(bytes);
            },
            [this](std::string_view text) { errors.emplace_back(text); });
    }

    udp_transport transport;
    std::vector<std::string> messages{};
    udp::endpoint from{};
    std::vector<std::string> errors{};
    std::function<void(std::span<const std::byte>)> on_message{};
};

/// Whether this machine lets a socket be opened there.
bool can_bind(boost::asio::io_context& context, const udp::endpoint& local) {
    udp::socket socket{context, local.protocol()};
    boost::system::error_code error;
    socket.bind(local, error);
    if (error) std::cout << "SKIPPED: " << error.message() << "\n";
    return !error;
}

} // namespace

TEST_CASE("a thousand queued datagrams arrive in order") {
    boost::asio::io_context context;
    station receiver{context, any_port, {.receive_buffer = 4'000'000}};
    udp::socket peer{context, any_port};
    for (int i = 0; i != 1000; ++i) peer.send_to(boost::asio::buffer(std::to_string(i)), receiver.transport.local());
    REQUIRE(support::until(context, [&] { return receiver.messages.size() == 1000; }));
    for (int i = 0; i != 1000; ++i) CHECK(receiver.messages[static_cast<std::size_t>(i)] == std::to_string(i));
    CHECK(receiver.transport.counts().received == 1000);
    CHECK(receiver.transport.counts().dropped == 0);
}

TEST_CASE("a flood does not starve the other handlers of the io_context") {
    boost::asio::io_context context;
    station receiver{context, any_port, {.receive_buffer = 4'000'000}};
    udp::socket peer{context, any_port};
    const auto to = receiver.transport.local();
    for (int i = 0; i != 1000; ++i) peer.send_to(boost::asio::buffer("x", 1), to);
    context.run_one_for(5s);
    CHECK(receiver.messages.size() == 128);
}

TEST_CASE("datagrams dropped by the kernel are counted") {
    boost::asio::io_context context;
    station receiver{context, any_port, {.receive_buffer = 1}};
    udp::socket peer{context, any_port};
    const std::string message(1000, 'x');
    for (int i = 0; i != 500; ++i) peer.send_to(boost::asio::buffer(message), receiver.transport.local());
    REQUIRE(support::until(context, [&] { return receiver.transport.counts().received != 0; }));
    // The next one tells how many were lost before it.
    const auto count = [&] { return receiver.transport.counts().received + receiver.transport.counts().dropped; };
    for (int i = 1; i != 4; ++i) {
        peer.send_to(boost::asio::buffer(message), receiver.transport.local());
        REQUIRE(support::until(context, [&] { return count() == static_cast<std::uint64_t>(500 + i); }));
    }
    CHECK(receiver.transport.counts().received < 100);
    CHECK(receiver.transport.counts().dropped > 400);
}

TEST_CASE("a full network queue is reported to the sender and counted") {
    boost::asio::io_context context;
    if (!can_bind(context, at("::1"))) return;
    // A datagram that the loopback interface has to fragment needs more memory than this socket may use.
    station sender{context, at("::1"), {.send_buffer = 1}};
    const std::vector<std::byte> message(udp_transport::max_datagram_size);
    const auto refused = sender.transport.send(message, at("::1", 9));
    CHECK(refused.error().code == net::errc::back_pressure);
    CHECK(refused.error().reason == std::errc::no_buffer_space);
    CHECK(refused.error().message ==
          "cannot send to [::1]:9: No buffer space available; the network takes less than is "
          "sent: send more slowly, or set send_buffer");
    CHECK(sender.transport.counts().would_block == 1);
    CHECK(sender.transport.counts().sent == 0);
    CHECK(sender.transport.counts().errors == 0);
}

TEST_CASE("messages posted by a handler are sent after the datagrams received with it are processed") {
    boost::asio::io_context context;
    station asking{context}, answering{context};
    answering.on_message = [&](std::span<const std::byte> bytes) {
        answering.transport.post(bytes, answering.from);
        if (answering.messages.size() < 3) CHECK(answering.transport.counts().sent == 0);
    };
    const auto to = answering.transport.local();
    for (int i = 0; i != 100; ++i) REQUIRE(asking.transport.send(bytes_of(std::to_string(i)), to));
    REQUIRE(support::until(context, [&] { return asking.messages.size() == 100; }));
    CHECK(asking.messages == answering.messages);
    CHECK(answering.transport.counts().sent == 100);

    answering.transport.post(bytes_of("outside of a handler"), asking.transport.local());
    CHECK(answering.transport.counts().sent == 101);
    answering.transport.post({}, asking.transport.local());
    CHECK(answering.errors == std::vector<std::string>{"an empty message is not sent"});
}

TEST_CASE("posted and sent messages keep their order, also large ones") {
    boost::asio::io_context context;
    station asking{context}, answering{context};
    const std::string large(20'000, 'L');
    answering.on_message = [&](auto) {
        answering.transport.post(bytes_of("1"), answering.from, jaus::framing::jaus01);
        answering.transport.post(bytes_of(large), answering.from);
        answering.transport.post(bytes_of("2"), answering.from);
        CHECK(answering.transport.send(bytes_of("3"), answering.from));
        answering.transport.post(bytes_of("4"), answering.from);
        answering.transport.stop(); // what was posted goes out
    };
    REQUIRE(asking.transport.send(bytes_of("go"), answering.transport.local()));
    REQUIRE(support::until(context, [&] { return asking.messages.size() == 5; }));
    CHECK(asking.messages == std::vector<std::string>{"1", large, "2", "3", "4"});
}

TEST_CASE("a posted message to a closed port does not delay the others") {
    boost::asio::io_context context;
    station asking{context}, answering{context};
    std::optional<udp::socket> closed{std::in_place, context, any_port};
    const auto nobody = closed->local_endpoint();
    closed.reset();
    answering.on_message = [&](auto bytes) {
        for (int i = 0; i != 20; ++i) {
            answering.transport.post(bytes, nobody);
            answering.transport.post(bytes, answering.from);
        }
    };
    REQUIRE(asking.transport.send(bytes_of("go"), answering.transport.local()));
    REQUIRE(support::until(context, [&] { return asking.messages.size() == 20; }));
    REQUIRE(support::until(context, [&] { return answering.transport.counts().refused != 0; }));
    CHECK(answering.errors.front().ends_with(": closed port: no program receives there"));
    CHECK(answering.transport.counts().errors == 0);
    CHECK(answering.transport.counts().sent == 40);
}

TEST_CASE("after an exception from a handler, receiving continues with the next datagram") {
    boost::asio::io_context context;
    station receiver{context};
    udp::socket peer{context, any_port};
    receiver.on_message = [&](auto) {
        if (receiver.messages.size() == 2) throw std::runtime_error{"handler"};
    };
    for (const char* message : {"1", "2", "3", "4"})
        peer.send_to(boost::asio::buffer(message, 1), receiver.transport.local());
    CHECK_THROWS_AS(support::until(context, [&] { return receiver.messages.size() == 4; }), std::runtime_error);
    receiver.start();
    REQUIRE(support::until(context, [&] { return receiver.messages.size() == 4; }));
    CHECK(receiver.messages == std::vector<std::string>{"1", "2", "3", "4"});
}

TEST_CASE("after a handler stops the transport, no other is called") {
    boost::asio::io_context context;
    station receiver{context};
    udp::socket peer{context, any_port};
    receiver.on_message = [&](auto) { receiver.transport.stop(); };
    for (int i = 0; i != 5; ++i) peer.send_to(boost::asio::buffer("x", 1), receiver.transport.local());
    context.run_for(1s);
    CHECK(context.stopped());
    CHECK(receiver.messages.size() == 1);
}

TEST_CASE("a filter is called first, and its refusals are counted without a report") {
    boost::asio::io_context context;
    station receiver{context};
    receiver.transport.set_filter([](std::span<const std::byte> message, const udp::endpoint&, jaus::framing) {
        if (message.empty()) return net::verdict::malformed;
        return static_cast<net::verdict>(std::to_integer<int>(message[0]) - '0');
    });
    udp::socket peer{context, any_port};
    for (const std::string_view message :
         {"", "JAUS01.0", "JAUS01.04", "1", "2", "2", "3", "4", "4", "4", "5", "6", "6", "0 taken"})
        peer.send_to(boost::asio::buffer(message), receiver.transport.local());
    REQUIRE(support::until(context, [&] { return !receiver.messages.empty(); }));
    const auto& counts = receiver.transport.counts();
    CHECK(receiver.messages == std::vector<std::string>{"0 taken"});
    CHECK(counts.received == 1);
    CHECK(counts.malformed == 3);
    CHECK(counts.unknown_peer == 2);
    CHECK(counts.wrong_sender == 1);
    CHECK(counts.rate_limited == 4);
    CHECK(counts.other_framing == 1);
    CHECK(counts.other_generation == 2);
    CHECK(counts.errors == 0);
    CHECK(receiver.errors.empty());
}

TEST_CASE("several transports share a port") {
    boost::asio::io_context context;
    for (const net::udp_options options :
         {net::udp_options{.reuse_address = true}, net::udp_options{.reuse_port = true}}) {
        station first{context, any_port, options};
        station second{context, first.transport.local(), options};
        udp::socket peer{context, any_port};
        peer.send_to(boost::asio::buffer("x", 1), first.transport.local());
        REQUIRE(support::until(context, [&] { return first.messages.size() + second.messages.size() == 1; }));
        CHECK_THROWS_AS(udp_transport(context, first.transport.local()), net::open_error);
    }
}

TEST_CASE("every member of a group on this host receives each member's messages, with the sender's own port") {
    boost::asio::io_context context;
    const net::multicast_options group{.port = 0, .interface_name = "lo"};
    const net::udp_options shared{.reuse_address = true};
    station first{context, {group.group, 0}, shared};
    station second{context, first.transport.local(), shared};
    first.transport.join(group);
    second.transport.join(group);
    station sender{context};
    sender.transport.send_multicast_by(group);
    REQUIRE(sender.transport.send(bytes_of("heartbeat"), first.transport.local()));
    REQUIRE(support::until(context, [&] { return first.messages.size() + second.messages.size() == 2; }));
    CHECK(first.messages == second.messages);
    CHECK(first.from == sender.transport.local());
}

TEST_CASE("an IPv6 group works like an IPv4 group") {
    boost::asio::io_context context;
    if (!can_bind(context, at("::1"))) return;
    net::multicast_options group{.group = boost::asio::ip::make_address("ff11::e001:1")};
    station member{context, at("::")}, sender{context, at("::")};
    const udp::endpoint to{group.group, member.transport.local().port()};
    // The loopback interface has no route for groups of IPv6, and others may have no address yet.
    auto* const interfaces = ::if_nameindex();
    bool sent = false;
    for (const auto* one = interfaces; one->if_index != 0 && !sent; ++one) {
        group.interface_name = one->if_name;
        sender.transport.send_multicast_by(group);
        sent = static_cast<bool>(sender.transport.send(bytes_of("heartbeat"), to));
    }
    ::if_freenameindex(interfaces);
    if (!sent) {
        std::cout << "SKIPPED: no interface sends to groups of IPv6\n";
        return;
    }
    member.transport.join(group);
    REQUIRE(sender.transport.send(bytes_of("heartbeat"), to));
    REQUIRE(support::until(context, [&] { return !member.messages.empty(); }));
    CHECK(member.messages.front() == "heartbeat");
    CHECK(member.from.port() == sender.transport.local().port());
}

TEST_CASE("time to live and loopback of multicast follow the options") {
    boost::asio::io_context context;
    udp::socket socket{context, any_port};
    net::set_multicast_sending(socket, {.interface_name = "lo", .ttl = 7, .loop = false});
    const auto option = [&](int name) {
        int value = -1;
        socklen_t size = sizeof value;
        ::getsockopt(socket.native_handle(), IPPROTO_IP, name, &value, &size);
        return value;
    };
    CHECK(option(IP_MULTICAST_TTL) == 7);
    CHECK(option(IP_MULTICAST_LOOP) == 0);
}

TEST_CASE("a group that cannot be joined is explained") {
    boost::asio::io_context context;
    udp_transport transport{context, any_port};
    auto code = net::errc::ok;
    const auto complaint = [&](const net::multicast_options& options, auto act) {
        try {
            act(options);
        } catch (const net::open_error& error) {
            code = error.code();
            return std::string{error.what()};
        }
        return std::string{"done"};
    };
    const auto join = [&](const auto& options) { transport.join(options); };
    const auto send = [&](const auto& options) { transport.send_multicast_by(options); };
    const net::multicast_options no_group{.group = boost::asio::ip::make_address("10.0.0.1")};
    CHECK(complaint(no_group, join) == "10.0.0.1 is no multicast group; use 224.1.0.1");
    CHECK(complaint(no_group, send) == "10.0.0.1 is no multicast group; use 224.1.0.1");
    CHECK(code == net::errc::invalid_address);
    const net::multicast_options no_interface{.interface_name = "nowhere0"};
    CHECK(complaint(no_interface, send) ==
          "cannot use the multicast group 224.1.0.1 on nowhere0: No such device; see ip -brief address");
    CHECK(code == net::errc::no_interface);
    const net::multicast_options once{.interface_name = "lo"};
    CHECK(complaint(once, join) == "done");
    CHECK(complaint(once, join) == "cannot join the multicast group 224.1.0.1 on lo: Address already in use");
    CHECK(code == net::errc::not_opened);
}

TEST_CASE("one socket serves both IP versions and names their addresses in the usual form") {
    boost::asio::io_context context;
    if (!can_bind(context, at("::1"))) return;
    station both{context, at("::")};
    const auto port = both.transport.local().port();
    for (const auto* const ip : {"127.0.0.1", "::1"}) {
        station peer{context, at(ip)};
        REQUIRE(peer.transport.send(bytes_of(ip), at(ip, port)));
        REQUIRE(support::until(context, [&] { return !both.messages.empty() && both.messages.back() == ip; }));
        CHECK(both.from == peer.transport.local());
        REQUIRE(both.transport.send(bytes_of("back"), both.from));
        REQUIRE(support::until(context, [&] { return !peer.messages.empty(); }));
    }
}

TEST_CASE("a filter, a batch and its answers allocate nothing") {
    boost::asio::io_context context;
    udp_transport asking{context, any_port}, answering{context, any_port};
    std::size_t answered = 0;
    answering.set_filter([](auto, const auto&, auto) { return net::verdict::accepted; });
    answering.start([&](auto message, const auto& from, auto framing) { answering.post(message, from, framing); },
                    [](std::string_view) {});
    asking.start([&](auto, const auto&, auto) { ++answered; }, [](std::string_view) {});
    const auto exchange = [&](std::size_t rounds) {
        for (std::size_t i = 0; i != rounds; ++i) {
            for (int n = 0; n != 20; ++n)
                if (!asking.send(bytes_of("sixteen bytes .."), answering.local(), jaus::framing::jaus01)) return;
            const auto wanted = answered + 20;
            support::until(context, [&] { return answered >= wanted; });
        }
    };
    exchange(5);
    const auto before = support::allocations();
    exchange(100);
    CHECK(support::allocations() - before == 0);
    CHECK(answered == 105 * 20);
}

TEST_CASE("counters are summarised in one line, also as differences") {
    CHECK(net::summary({}) == "nothing");
    net::udp_counters counts{.received = 12, .wrong_sender = 3, .sent = 1};
    CHECK(net::summary(counts) == "received 12, wrong sender 3, sent 1");
    const auto before = counts;
    counts.count(net::verdict::rate_limited);
    counts.dropped = 7;
    CHECK(net::summary(counts - before) == "dropped 7, rate-limited 1");
    static_assert(net::udp_counter_list.size() * sizeof(std::uint64_t) == sizeof(net::udp_counters));
}
