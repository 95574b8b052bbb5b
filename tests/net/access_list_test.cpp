// Permitted senders: spoofed sources, strangers, several addresses, and an open list.
#include "net/config_text.hpp"
#include <jauscat/net/config/access_list.hpp>
#include <jauscat/net/node/datagram_gate.hpp>

#include <random>

using namespace jauscat;
using net::access_list;
using net::verdict;

namespace {

const auto config = net_test::parse(
    "<thissystem>a</thissystem>" + net_test::system_a +
    "<system name='b' jausip='2.0.0.0' ip='10.0.0.2' port='3794'><ip>10.0.1.2</ip><ip>fd00::2</ip></system>\n"
    "<system name='arm' jausip='2.7.0.0' ip='10.0.0.7' port='3794' sourceport='any'/>\n"
    "<system name='c' jausip='3.0.0.0' ip='10.0.0.2' port='4000'/>\n");

jaus::address id(const char* text) { return net::parse_jausip(text).value(); }

access_list::endpoint at(const char* ip, std::uint16_t port) { return {boost::asio::ip::make_address(ip), port}; }

} // namespace

TEST_CASE("a message is accepted only from the address of the system that has its source") {
    const access_list list{config};
    CHECK_FALSE(list.is_open());
    const auto check = [&](const char* source, const char* ip, std::uint16_t port) {
        return list.check(id(source), at(ip, port)).what;
    };
    CHECK(check("2.1.33.1", "10.0.0.2", 3794) == verdict::accepted);
    CHECK(check("2.254.254.254", "10.0.0.2", 3794) == verdict::accepted);
    CHECK(check("2.1.33.1", "10.0.1.2", 3794) == verdict::accepted);
    CHECK(check("2.1.33.1", "fd00::2", 3794) == verdict::accepted);
    CHECK(check("2.1.33.1", "::ffff:10.0.0.2", 3794) == verdict::accepted);
    // a stranger, a port that any user of the peer's machine may open, another peer
    CHECK(check("2.1.33.1", "10.0.0.9", 3794) == verdict::wrong_sender);
    CHECK(check("2.1.33.1", "10.0.0.2", 3795) == verdict::wrong_sender);
    CHECK(check("2.1.33.1", "10.0.0.2", 4000) == verdict::wrong_sender);
    CHECK(check("3.1.33.1", "10.0.0.2", 3794) == verdict::wrong_sender);
    CHECK(check("2.1.33.1", "10.0.0.7", 3794) == verdict::wrong_sender);
    CHECK(check("9.1.33.1", "10.0.0.2", 3794) == verdict::unknown_peer);
    // this system's own address, claimed from outside
    CHECK(check("1.1.33.1", "10.0.0.2", 3794) == verdict::wrong_sender);
    CHECK(check("1.1.33.1", "127.0.0.1", 39777) == verdict::accepted);
}

TEST_CASE("a system that is a node of another sends from its own address, from any port if configured") {
    const access_list list{config};
    CHECK(list.check(id("2.7.33.1"), at("10.0.0.7", 3794)).what == verdict::accepted);
    CHECK(list.check(id("2.7.33.1"), at("10.0.0.7", 50000)).what == verdict::accepted);
    CHECK(list.check(id("2.7.33.1"), at("10.0.0.2", 3794)).what == verdict::wrong_sender);
    CHECK(list.check(id("2.8.33.1"), at("10.0.0.7", 3794)).what == verdict::wrong_sender);
}

TEST_CASE("a verdict names the system, unless the sender is another") {
    const access_list list{config};
    CHECK(list.check(id("2.1.33.1"), at("10.0.0.2", 3794)).peer == 1U);
    CHECK(list.check(id("2.7.33.1"), at("10.0.0.7", 3794)).peer == 2U);
    CHECK_FALSE(list.check(id("2.1.33.1"), at("10.0.0.9", 3794)).peer);
    CHECK_FALSE(list.check(id("9.1.33.1"), at("10.0.0.2", 3794)).peer);
}

TEST_CASE("an open list accepts every sender, but not a stranger in place of a peer") {
    const access_list list{config, net::access::open};
    CHECK(list.is_open());
    CHECK(list.check(id("9.1.33.1"), at("10.0.0.9", 1)).what == verdict::accepted);
    CHECK(list.check(id("2.1.33.1"), at("10.0.0.9", 1)).what == verdict::accepted);
    CHECK_FALSE(list.check(id("2.1.33.1"), at("10.0.0.9", 1)).peer);
    CHECK(list.check(id("2.1.33.1"), at("10.0.0.2", 3794)).peer == 1U);
}

TEST_CASE("a configuration without peers gives an open list") {
    CHECK(access_list{net_test::parse("<thissystem>a</thissystem>" + net_test::system_a)}.is_open());
}

TEST_CASE("a list of 200 subsystems and 50 nodes agrees with the configuration's next hop") {
    net::jaus_config large{.this_system = "1"};
    for (unsigned subsystem = 1; subsystem <= 200; ++subsystem) {
        const auto add = [&](std::uint8_t node) {
            const auto number = static_cast<std::uint32_t>(large.systems.size() + 1);
            large.systems.push_back({.name = std::to_string(number),
                                     .jausip = {.node = node, .subsystem = static_cast<std::uint8_t>(subsystem)},
                                     .ip = boost::asio::ip::make_address_v4(0x0A000000 + number),
                                     .port = 3794});
        };
        add(0);
        if (subsystem == 7)
            for (std::uint8_t node = 1; node <= 50; ++node) add(node);
    }
    const access_list list{large};
    std::mt19937 random{7};
    const auto level = [&](unsigned last) { return static_cast<std::uint8_t>(1 + random() % last); };
    unsigned known = 0;
    for (int i = 0; i != 3000; ++i) {
        const jaus::address source{level(254), level(254), level(60), i % 3 == 0 ? std::uint8_t{7} : level(254)};
        const auto* hop = large.next_hop(source);
        const auto from = hop ? hop->endpoint() : at("10.0.0.1", 3794);
        CHECK(list.check(source, from).what == (hop ? verdict::accepted : verdict::unknown_peer));
        if (!hop) continue;
        ++known;
        CHECK(&large.systems[list.check(source, from).peer.value()] == hop);
        CHECK(list.check(source, {boost::asio::ip::make_address_v4(0x0A000000), 3794}).what == verdict::wrong_sender);
    }
    CHECK(known > 2000);
    CHECK(known < 3000);
}

TEST_CASE("a datagram of SAE JAUS is accepted from each host of a system") {
    net::datagram_gate gate{config, net::access::closed, 1};
    const time_point now{};
    for (const auto* const host : {"10.0.0.2", "10.0.1.2", "fd00::2", "::ffff:10.0.1.2", "10.0.0.7"}) {
        CAPTURE(host);
        CHECK(gate.check_sae(at(host, 50000), now) == verdict::accepted);
    }
    CHECK(gate.check_sae(at("10.0.0.9", 3794), now) == verdict::unknown_peer);
}
