// EtherCAT in UDP on the loopback interface: the frames on both ends and the datagrams between them.
#include "net/frames.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/ethercat/link.hpp>
#include <jauscat/net/link/udp_link.hpp>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>

using namespace jauscat;
using namespace std::chrono_literals;
using support::bytes;
using support::frame_buffer;
using udp = boost::asio::ip::udp;

static_assert(ethercat::link<net::udp_link>);

namespace {

net::udp_link serve() { return net::udp_link::serve(0, "127.0.0.1"); }
net::udp_link connect_to(const net::udp_link& slave) { return net::udp_link::connect("127.0.0.1", slave.port()); }

/// What a link gives for the frame `support::frame(...)`: broadcast destination, no source.
std::vector<std::byte> rebuilt(std::vector<std::byte> frame) {
    std::fill_n(frame.begin(), 6, std::byte{0xFF});
    std::fill_n(frame.begin() + 6, 6, std::byte{});
    return frame;
}

} // namespace

TEST_CASE("a frame passes from master to slave and back over UDP") {
    auto slave = serve();
    auto master = connect_to(slave);
    frame_buffer buffer;
    for (const std::size_t data : {0u, 1u, 31u, 32u, 33u, 1486u}) {
        const auto frame = support::frame(data);
        REQUIRE(master.send(frame));
        REQUIRE(buffer.receive_from(slave) == frame.size());
        CHECK(buffer.frame() == rebuilt(frame));
        REQUIRE(slave.send(buffer.frame()));
        REQUIRE(buffer.receive_from(master) == frame.size());
        CHECK(buffer.frame() == rebuilt(frame));
    }
}

TEST_CASE("a datagram holds the EtherCAT header and the datagrams, without padding") {
    boost::asio::io_context context;
    udp::socket peer{context, {boost::asio::ip::make_address("127.0.0.1"), 0}};
    auto master = net::udp_link::connect("localhost", peer.local_endpoint().port());
    REQUIRE(master.send(support::frame(1)));
    std::array<std::byte, 64> payload{};
    udp::endpoint from;
    const auto size = peer.receive_from(boost::asio::buffer(payload), from);
    const auto expected = bytes(0x0D, 0x10, 0x07, 0x5A, 0, 0, 0x30, 0x01, 0x01, 0, 0, 0, 0x01, 0, 0);
    CHECK(test::to_hex(std::span{payload}.first(size)) == test::to_hex(expected));

    // And the way back, from bytes.
    peer.send_to(boost::asio::buffer(expected), from);
    frame_buffer buffer;
    REQUIRE(buffer.receive_from(master) == 60);
    CHECK(buffer.frame() == rebuilt(support::frame(1)));
}

TEST_CASE("the slave's end answers the latest sender") {
    auto slave = serve();
    auto first = connect_to(slave);
    auto second = connect_to(slave);
    frame_buffer buffer;
    for (auto* master : {&first, &second, &first}) {
        REQUIRE(master->send(support::frame(4)));
        REQUIRE(buffer.receive_from(slave) == 60);
        REQUIRE(slave.send(buffer.frame()));
        CHECK(buffer.receive_from(*master) == 60);
    }
    CHECK(second.receive(buffer.storage, 0ns) == 0);
}

TEST_CASE("the slave's end reports that there was no request yet") {
    auto slave = serve();
    CHECK_FALSE(slave.send(support::frame(4)));
    CHECK(slave.problem() == "no master has sent a frame yet, so there is no address to answer");
}

TEST_CASE("the master's end reports that there is no slave, and works when one starts") {
    auto port = std::uint16_t{};
    {
        const auto slave = serve();
        port = slave.port();
    }
    auto master = net::udp_link::connect("127.0.0.1", port);
    frame_buffer buffer;
    REQUIRE(master.send(support::frame(4)));
    CHECK(master.receive(buffer.storage, 5s) == 0);
    CHECK(master.problem() == "no slave receives at UDP 127.0.0.1:" + std::to_string(port));

    auto slave = net::udp_link::serve(port, "127.0.0.1");
    REQUIRE(master.send(support::frame(4)));
    CHECK(master.problem().empty());
    CHECK(buffer.receive_from(slave) == 60);
}

TEST_CASE("a frame shorter than its header announces is not sent over UDP") {
    auto slave = serve();
    auto master = connect_to(slave);
    const auto frame = support::frame(100);
    for (const std::size_t size : {0u, 13u, 15u, 60u, 127u}) {
        CHECK_FALSE(master.send(std::span{frame}.first(size)));
        CHECK(master.problem() == "a frame of " + std::to_string(size) + " bytes is shorter than its header announces");
    }
    CHECK(master.send(frame));
}

TEST_CASE("datagrams too short, or too long for the buffer, are skipped") {
    boost::asio::io_context context;
    udp::socket peer{context, {boost::asio::ip::make_address("127.0.0.1"), 0}};
    auto slave = serve();
    const udp::endpoint to{boost::asio::ip::make_address("127.0.0.1"), slave.port()};
    for (const std::size_t size : {0u, 1u, 1501u, 9000u})
        peer.send_to(boost::asio::buffer(std::vector<std::byte>(size)), to);
    peer.send_to(boost::asio::buffer(std::vector<std::byte>(1500)), to);
    frame_buffer buffer;
    CHECK(buffer.receive_from(slave) == 1514);
    CHECK(slave.receive(buffer.storage, 0ns) == 0);

    peer.send_to(boost::asio::buffer(std::vector<std::byte>(10)), to);
    CHECK(slave.receive(std::span{buffer.storage}.first(59), 5ms) == 0);
}

TEST_CASE("waiting for a frame ends at its deadline") {
    auto slave = serve();
    frame_buffer buffer;
    for (const std::chrono::nanoseconds timeout : {0ns, 5000ns, 300'000ns, 20'000'000ns}) {
        const auto start = std::chrono::steady_clock::now();
        CHECK(slave.receive(buffer.storage, timeout) == 0);
        CHECK(slave.problem().empty());
        CHECK(std::chrono::steady_clock::now() - start >= timeout);
    }
    auto master = connect_to(slave);
    REQUIRE(master.send(support::frame(4)));
    CHECK(slave.receive(buffer.storage, std::chrono::nanoseconds::max()) == 60);
}

TEST_CASE("an unknown host and a port in use are explained") {
    try {
        static_cast<void>(net::udp_link::connect("no-such-host.invalid"));
        FAIL("connected to nowhere");
    } catch (const net::open_error& error) {
        CHECK(std::string{error.what()}.starts_with("cannot reach a slave at no-such-host.invalid:34980: "));
        CHECK(error.code() == net::errc::unreachable);
        CHECK(error.error().reason);
    }
    const auto slave = serve();
    try {
        static_cast<void>(net::udp_link::serve(slave.port(), "127.0.0.1"));
        FAIL("two slaves at one port");
    } catch (const net::open_error& error) {
        CHECK(std::string{error.what()}.find("find the program that holds the port") != std::string::npos);
        CHECK(error.code() == net::errc::address_in_use);
        CHECK(error.error().reason == std::errc::address_in_use);
    }
    try {
        static_cast<void>(net::udp_link::serve(0, "localhost"));
        FAIL("served at a name");
    } catch (const net::open_error& error) {
        CHECK(error.code() == net::errc::invalid_address);
    }
}
