// EtherCAT on a pair of virtual Ethernet interfaces, jc0 and jc1, in a network namespace: see with_veth.sh.
#include "net/frames.hpp"
#include "support/catch.hpp"
#include "support/interfaces.hpp"
#include <jauscat/ethercat/link.hpp>
#include <jauscat/net/link/raw_link.hpp>

#include <boost/asio/buffer.hpp>
#include <boost/asio/generic/raw_protocol.hpp>
#include <boost/asio/io_context.hpp>

#include <filesystem>
#include <linux/if_packet.h>
#include <string>

using namespace jauscat;
using namespace std::chrono_literals;
using net::raw_link;
using support::bytes;
using support::comes_to;
using support::frame_buffer;
using support::ip;

static_assert(ethercat::link<raw_link>);

namespace {

/// Why an interface cannot be opened; ok if it can.
net::error refusal(const std::string& interface) {
    try {
        raw_link opened{interface};
        return {};
    } catch (const net::open_error& error) {
        CHECK(describe(error.error()) == error.what());
        return error.error();
    }
}

/// `frame` with the interface's address as its source.
std::vector<std::byte> from(const raw_link& link, std::vector<std::byte> frame) {
    std::ranges::copy(link.mac(), frame.begin() + 6);
    return frame;
}

/// Puts bytes on the wire as they are, by a packet socket without the link's rules.
void inject(const char* interface, const std::vector<std::byte>& frame) {
    boost::asio::io_context context;
    boost::asio::generic::raw_protocol::socket socket{context, {AF_PACKET, 0}};
    sockaddr_ll address{};
    address.sll_family = AF_PACKET;
    address.sll_ifindex = static_cast<int>(::if_nametoindex(interface));
    socket.send_to(boost::asio::buffer(frame), {&address, sizeof address});
}

/// Of all that has come, `link` hears this frame alone.
void require_only(raw_link& link, const std::vector<std::byte>& frame) {
    frame_buffer buffer;
    REQUIRE(buffer.receive_from(link) == frame.size());
    CHECK(buffer.frame() == frame);
    CHECK(buffer.receive_from(link, 0ns) == 0);
}

} // namespace

TEST_CASE("a frame passes between two interfaces in both directions", "[veth]") {
    raw_link master{"jc0"};
    raw_link slave{"jc1"};
    frame_buffer buffer;
    for (const std::size_t data : {0u, 1u, 31u, 32u, 33u, 1486u}) {
        const auto frame = support::frame(data);
        REQUIRE(master.send(frame));
        REQUIRE(buffer.receive_from(slave) == frame.size());
        CHECK(buffer.frame() == from(master, frame));
        REQUIRE(slave.send(buffer.frame())); // the source stays the master's
        REQUIRE(buffer.receive_from(master) == frame.size());
        CHECK(buffer.frame() == from(master, frame));
    }
}

TEST_CASE("short frames are padded with zeros, sent or received", "[veth]") {
    raw_link master{"jc0"};
    raw_link slave{"jc1"};
    frame_buffer buffer;
    const auto padded = support::frame(1);
    const auto runt = std::vector(padded.begin(), padded.begin() + 29);
    REQUIRE(master.send(runt));
    REQUIRE(buffer.receive_from(slave) == 60);
    CHECK(buffer.frame() == from(master, padded));
    inject("jc0", runt);
    REQUIRE(buffer.receive_from(slave) == 60);
    CHECK(buffer.frame() == padded);
}

TEST_CASE("a link does not receive its own frames", "[veth]") {
    raw_link link{"jc0"};
    raw_link same_interface{"jc0"};
    frame_buffer buffer;
    REQUIRE(link.send(support::frame(1)));
    CHECK(buffer.receive_from(link, 20ms) == 0);
    CHECK(buffer.receive_from(same_interface, 0ns) == 0);
}

TEST_CASE("a link receives every destination address, and no other EtherType", "[veth]") {
    raw_link slave{"jc1"};
    REQUIRE(ip("-details link show jc1 | grep -q 'promiscuity 1'"));
    auto other = support::frame(1);
    other[12] = std::byte{0x08};
    other[13] = std::byte{0x00};
    inject("jc0", other);
    auto unicast = support::frame(1);
    unicast[0] = std::byte{0x02};
    inject("jc0", unicast);
    require_only(slave, unicast);
}

TEST_CASE("an EtherCAT frame without datagrams is not received", "[veth]") {
    raw_link slave{"jc1"};
    for (const int type : {0, 2, 3, 4, 5, 9, 15}) {
        auto other = support::frame(1);
        other[15] = static_cast<std::byte>(type << 4);
        inject("jc0", other);
    }
    auto longest = support::frame(1);
    longest[15] = std::byte{0x1F}; // type 1, and all bits of the length that share the byte
    inject("jc0", longest);
    require_only(slave, longest);
}

TEST_CASE("a VLAN tag is removed", "[veth]") {
    raw_link slave{"jc1"};
    frame_buffer buffer;
    const auto plain = support::frame(1);
    for (const auto& tag : {bytes(0x81, 0x00, 0x00, 0x00), bytes(0x81, 0x00, 0x20, 0x05), bytes(0x81, 0x00, 0xEF, 0xFE),
                            bytes(0x88, 0xA8, 0x00, 0x05)}) {
        auto tagged = plain;
        tagged.insert(tagged.begin() + 12, tag.begin(), tag.end());
        inject("jc0", tagged);
        REQUIRE(buffer.receive_from(slave) == 60);
        CHECK(buffer.frame() == plain);
    }
}

TEST_CASE("a frame larger than the buffer is skipped", "[veth]") {
    raw_link master{"jc0"};
    raw_link slave{"jc1"};
    REQUIRE(master.send(support::frame(100)));
    REQUIRE(master.send(support::frame(1)));
    std::array<std::byte, 60> small{};
    CHECK(slave.receive(small, 5s) == 60);
    CHECK(slave.receive(small, 0ns) == 0);
    REQUIRE(master.send(support::frame(1)));
    CHECK(slave.receive(std::span{small}.first(59), 5ms) == 0);
}

TEST_CASE("bytes that are not a frame are not sent", "[veth]") {
    raw_link link{"jc0"};
    const auto frame = support::frame(1);
    CHECK_FALSE(link.send(std::span{frame}.first(13)));
    CHECK(link.problem() == "a frame of 13 bytes has no Ethernet header");
    CHECK_FALSE(link.send(std::vector<std::byte>(1600, std::byte{1})));
    CHECK(link.problem() == "interface jc0: Message too long");
    CHECK(link.send(frame));
    CHECK(link.problem().empty());
}

TEST_CASE("waiting on an interface ends at its deadline", "[veth]") {
    raw_link link{"jc0"};
    frame_buffer buffer;
    for (const std::chrono::nanoseconds timeout : {0ns, 5000ns, 300'000ns, 20'000'000ns}) {
        const auto start = std::chrono::steady_clock::now();
        CHECK(buffer.receive_from(link, timeout) == 0);
        CHECK(link.problem().empty());
        CHECK(std::chrono::steady_clock::now() - start >= timeout);
    }
}

TEST_CASE("an interface that goes down is reported, and works again when it is up", "[veth]") {
    raw_link master{"jc0"};
    raw_link slave{"jc1"};
    frame_buffer buffer;
    const std::string down = "interface jc0 is down; run: sudo ip link set jc0 up";
    REQUIRE(ip("link set jc0 down"));
    for (int look = 0; look != 3; ++look) {
        CHECK(buffer.receive_from(master, 1ms) == 0);
        CHECK(master.problem() == down);
    }
    CHECK_FALSE(master.send(support::frame(1)));
    CHECK(master.problem() == down);
    REQUIRE(comes_to("LOWERLAYERDOWN", "jc1"));
    CHECK(buffer.receive_from(slave, 1ms) == 0);
    CHECK(slave.problem() == "no link on jc1: is the cable in, and the other end on?");
    REQUIRE(ip("link set jc0 up"));
    REQUIRE(comes_to("UP", "jc0"));
    REQUIRE(comes_to("UP", "jc1"));
    CHECK(buffer.receive_from(slave, 1ms) == 0);
    CHECK(slave.problem().empty());
    CHECK(master.send(support::frame(1)));
    CHECK(buffer.receive_from(slave) == 60);
}

TEST_CASE("a link can be opened before the cable is connected", "[veth]") {
    REQUIRE(ip("link set jc1 down"));
    REQUIRE(comes_to("LOWERLAYERDOWN", "jc0"));
    raw_link master{"jc0"};
    const std::string no_link = "no link on jc0: is the cable in, and the other end on?";
    CHECK(master.problem() == no_link);
    frame_buffer buffer;
    CHECK(buffer.receive_from(master, 1ms) == 0);
    CHECK(master.problem() == no_link);
    REQUIRE(ip("link set jc1 up"));
    REQUIRE(comes_to("UP", "jc0"));
    REQUIRE(comes_to("UP", "jc1"));
    raw_link slave{"jc1"};
    CHECK(slave.problem().empty());
    CHECK(master.send(support::frame(1)));
    CHECK(buffer.receive_from(slave) == 60);
}

TEST_CASE("an interface that disappears is reported, and used again when it returns", "[veth]") {
    const auto plug_in = [] {
        REQUIRE(ip("link add jc2 type veth peer name jc3"));
        REQUIRE(ip("link set jc3 up"));
        REQUIRE(ip("link set jc2 up"));
        REQUIRE(comes_to("UP", "jc2"));
        REQUIRE(comes_to("UP", "jc3"));
    };
    plug_in();
    raw_link link{"jc2"};
    REQUIRE(ip("link delete jc2"));
    frame_buffer buffer;
    for (int look = 0; look != 2; ++look) {
        CHECK(buffer.receive_from(link, 1ms) == 0);
        CHECK(link.problem() == "interface jc2 is gone");
    }
    CHECK_FALSE(link.send(support::frame(1)));
    CHECK(link.problem() == "interface jc2 is gone");
    plug_in();
    REQUIRE(ip("-details link show jc2 | grep -q 'promiscuity 0'"));
    CHECK(buffer.receive_from(link, 1ms) == 0);
    CHECK(link.problem().empty());
    REQUIRE(ip("-details link show jc2 | grep -q 'promiscuity 1'"));
    raw_link peer{"jc3"};
    CHECK(link.send(support::frame(1)));
    REQUIRE(buffer.receive_from(peer) == 60);
    CHECK(buffer.frame() == from(link, support::frame(1)));
    CHECK(peer.send(support::frame(1)));
    CHECK(buffer.receive_from(link) == 60);
    REQUIRE(ip("link delete jc2"));
}

TEST_CASE("an interface that cannot be used is refused with the reason", "[veth]") {
    CHECK(refusal("jc7").message == "there is no interface jc7; this machine has: lo, jc1, jc0");
    CHECK(refusal("jc7").code == net::errc::no_interface);
    CHECK(refusal("a-name-that-is-much-too-long")
              .message.starts_with("there is no interface a-name-that-is-much-too-long; "));
    REQUIRE(ip("link set jc0 down"));
    CHECK(refusal("jc0").message == "interface jc0 is down; run: sudo ip link set jc0 up");
    CHECK(refusal("jc0").code == net::errc::interface_down);
    REQUIRE(ip("link set jc0 up"));
    CHECK(refusal("jc0") == net::error{});
    CHECK(refusal("lo").message == "lo is not an Ethernet interface; this machine has: lo, jc1, jc0");
    CHECK(refusal("lo").code == net::errc::not_ethernet);
}

TEST_CASE("without the capability the error has the setcap command for this program", "[unprivileged]") {
    CHECK(refusal("jc0").message ==
          "raw Ethernet needs the capability CAP_NET_RAW; run once: sudo setcap cap_net_raw+ep " +
              std::filesystem::read_symlink("/proc/self/exe").string());
    CHECK(refusal("jc0").code == net::errc::not_permitted);
}
