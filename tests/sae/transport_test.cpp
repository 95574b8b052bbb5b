// The transport of a node, against literal datagrams.
#include "sae/machine.hpp"
#include "support/bytes.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"

#include <string>

namespace {

namespace jaus = jauscat::jaus;
namespace sae = jauscat::sae;
using namespace std::chrono_literals;
using jauscat::test::from_hex;
using jauscat::test::hex_of;
using jauscat::test::machine;
using jauscat::test::to_hex;
using sae::transport_errc;

constexpr sae::jaus_id controller{20, 1, 126}, component{10, 1, 126}, second{11, 1, 126};

struct sent {
    std::string to;
    std::string bytes;
    friend bool operator==(const sent&, const sent&) = default;
};
std::ostream& operator<<(std::ostream& out, const sent& s) { return out << s.to << ": " << s.bytes; }

sent next(machine& m, support::instant now = 0s) {
    const auto datagram = m.transport.next_datagram(now);
    if (!datagram) return {"none", ""};
    return {datagram->to ? std::to_string(datagram->to->value) : "group", to_hex(datagram->bytes)};
}
auto send(machine& m, const sae::outgoing_message& message, std::string_view payload, support::instant now = 0s) {
    return m.transport.send(message, from_hex(payload), now);
}

} // namespace

TEST_CASE("controller and component begin as in the capture") {
    machine here{{{controller}}}, there{{{component}}};
    const auto request = hex_of("02 00 1100 19 0A017E00 14017E00 0D00 C8 0100");
    REQUIRE(send(here, {.source = controller, .destination = component, .is_acknowledged = true}, "0d00 c8"));
    CHECK(next(here) == sent{"group", request});
    CHECK(here.receive(from_hex(request), 0s) == jaus::datagram_form::judp2);
    CHECK(here.transport.counts().own == 1); // the group's loopback

    CHECK(there.receive(from_hex(request), 0s, 7) == jaus::datagram_form::judp2);
    REQUIRE(there.received.size() == 1);
    CHECK(to_hex(there.received[0].payload) == "0d 00 c8");
    CHECK(there.received[0].message.to == component);
    CHECK(there.received[0].message.first_number == 1);
    CHECK(there.received[0].message.from.value == 7);
    REQUIRE(send(there, {.source = component, .destination = controller}, "0f00 00"));
    CHECK(there.transport.next_event() == jauscat::time_point::min());
    const sent acknowledge{"7", hex_of("02 00 0E00 31 14017E00 0A017E00 0100")};
    CHECK(next(there) == acknowledge);
    CHECK(next(there) == sent{"7", hex_of("02 00 1100 01 14017E00 0A017E00 0F00 00 0100")});
    CHECK(next(there).to == "none");

    CHECK(here.receive(from_hex(acknowledge.bytes), 0s, 8) == jaus::datagram_form::judp2);
    const auto done = here.transport.next_outcome();
    REQUIRE(done);
    CHECK(done->outcome == sae::sent_outcome::acknowledged);
    REQUIRE(send(here, {.source = controller, .destination = component}, "0220"));
    CHECK(next(here) == sent{"8", hex_of("02 00 1000 01 0A017E00 14017E00 0220 0200")});
}

TEST_CASE("a repeated packet is acknowledged again and delivered once") {
    machine m{{{component}}};
    const auto request = from_hex("02 00 1100 11 0A017E00 14017E00 0D00 C8 0100");
    m.receive(request, 0s);
    m.receive(request, 1s);
    CHECK(m.received.size() == 1);
    CHECK(m.transport.counts().repeated == 1);
    CHECK(next(m).bytes == hex_of("02 00 0E00 31 14017E00 0A017E00 0100"));
    CHECK(next(m).bytes == hex_of("02 00 0E00 31 14017E00 0A017E00 0100"));
    CHECK(next(m).to == "none");
}

TEST_CASE("a broadcast is delivered to each component that it covers, and not acknowledged") {
    machine m{{{component}, {second}, {{10, 2, 126}}}};
    m.receive(from_hex("02 00 1000 19 FF017E00 14017E00 0220 0100"), 0s);
    REQUIRE(m.received.size() == 2);
    CHECK(m.received[0].message.to == component);
    CHECK(m.received[1].message.to == second);
    CHECK(next(m).to == "none");
    m.receive(from_hex("02 00 1000 09 FFFFFFFF 14017E00 0220 0200"), 0s);
    CHECK(m.received.size() == 5);
    m.receive(from_hex("02 00 1000 01 00017E00 14017E00 0220 0300"), 0s); // component 0: each of the node
    CHECK(m.received.size() == 7);
    m.receive(from_hex("02 00 1000 01 00000000 14017E00 0220 0400"), 0s);
    m.receive(from_hex("02 00 1000 01 0AFF7F00 14017E00 0220 0500"), 0s);
    CHECK(m.received.size() == 7);
    CHECK(m.transport.counts().not_here == 2);
}

TEST_CASE("three packets of a known peer are one message, each acknowledged") {
    machine m{{{component}}};
    m.receive(from_hex("02 00 1200 51 0A017E00 14017E00 0D00C801 0100"), 0s);
    m.receive(from_hex("02 00 1000 D1 0A017E00 14017E00 0506 0300"), 0s);
    CHECK(m.received.empty());
    m.receive(from_hex("02 00 1200 91 0A017E00 14017E00 01020304 0200"), 0s);
    REQUIRE(m.received.size() == 1);
    CHECK(to_hex(m.received[0].payload) == hex_of("0D00C801 01020304 0506"));
    CHECK(m.received[0].message.first_number == 1);
    for (const std::string_view number : {"0100", "0300", "0200"})
        CHECK(next(m).bytes == hex_of("02 00 0E00 31 14017E00 0A017E00 " + std::string{number}));
    CHECK(next(m).to == "none");
}

TEST_CASE("a long message is sent in packets with numbers that follow each other") {
    machine m{{{controller, 65535}}};
    CHECK(m.transport.fix(component, {7}));
    const std::vector<std::byte> payload(150, std::byte{0x11});
    const auto number = m.transport.send({.source = controller, .destination = component}, payload, {});
    REQUIRE(number);
    CHECK(*number == 65535);
    const auto first = next(m), middle = next(m), last = next(m);
    CHECK(first.to == "7");
    CHECK(first.bytes.starts_with(hex_of("02 00 4E00 41 0A017E00 14017E00 11")));
    CHECK(first.bytes.ends_with("11 ff ff"));
    CHECK(middle.bytes.starts_with(hex_of("02 00 4E00 81 0A017E00 14017E00 11")));
    CHECK(middle.bytes.ends_with("11 00 00"));
    CHECK(last.bytes.starts_with(hex_of("02 00 2400 C1 0A017E00 14017E00 11")));
    CHECK(last.bytes.ends_with("11 01 00"));
    CHECK(next(m).to == "none");
    CHECK(*send(m, {.source = controller, .destination = component}, "0220") == 2);
}

TEST_CASE("wildcards of each part go to the group with the broadcast flag of the message") {
    machine m{{{controller}}};
    REQUIRE(
        send(m, {.source = controller, .destination = sae::everybody, .broadcast = sae::broadcast::global}, "002b 02"));
    CHECK(next(m) == sent{"group", hex_of("02 00 1100 09 FFFFFFFF 14017E00 002B 02 0100")});
    REQUIRE(send(m, {.source = controller, .destination = {255, 1, 126}, .broadcast = sae::broadcast::local}, "0220"));
    CHECK(next(m) == sent{"group", hex_of("02 00 1000 05 FF017E00 14017E00 0220 0200")});
    REQUIRE(send(m, {.source = controller, .destination = {10, 255, 126}}, "0220"));
    CHECK(next(m) == sent{"group", hex_of("02 00 1000 01 0AFF7E00 14017E00 0220 0300")});
}

TEST_CASE("an unknown destination is asked once where no acknowledgement is wanted") {
    machine m{{{controller}}};
    REQUIRE(send(m, {.source = controller, .destination = component}, "0220"));
    CHECK(next(m) == sent{"group", hex_of("02 00 1000 19 0A017E00 14017E00 0220 0100")});
    CHECK_FALSE(m.transport.next_event());
    m.receive(from_hex("02 00 0E00 31 14017E00 0A017E00 0100"), 0s, 9);
    CHECK(m.transport.counts().late_replies == 1);
    REQUIRE(send(m, {.source = controller, .destination = component}, "0220"));
    CHECK(next(m).to == "9");
}

TEST_CASE("what cannot be sent is refused with its reason") {
    machine m{{{controller}, {second}}};
    const auto error = [&m](sae::outgoing_message message, std::size_t size = 2) {
        return m.transport.send(message, std::vector<std::byte>(size), {}).error();
    };
    CHECK(error({.source = component, .destination = controller}) == transport_errc::unknown_source);
    CHECK(error({.source = controller, .destination = {0, 1, 126}}) == transport_errc::invalid_destination);
    CHECK(error({.source = controller, .destination = second}) == transport_errc::local_destination);
    CHECK(error({.source = controller, .destination = component}, 1) == transport_errc::no_message_id);
    CHECK(error({.source = controller, .destination = component}, 65) == transport_errc::unknown_peer);
    CHECK(error({.source = controller, .destination = sae::everybody}, 65) == transport_errc::not_one_component);
    CHECK(error({.source = controller, .destination = sae::everybody, .is_acknowledged = true}) ==
          transport_errc::not_one_component);
    CHECK(error({.source = controller, .destination = component, .broadcast = static_cast<sae::broadcast>(3)}) ==
          transport_errc::invalid_header);
    CHECK(m.transport.fix(component, {1}));
    CHECK(error({.source = controller, .destination = component}, 32 * 64) == transport_errc::too_large);
    CHECK_FALSE(m.transport.next_event());
    CHECK(m.components[0].next_number == 1);

    machine alone{{{controller}}, {.has_group = false}};
    CHECK(alone.transport.send({.source = controller, .destination = component}, from_hex("0220"), {}).error() ==
          transport_errc::unknown_peer);
    CHECK(alone.transport.fix(component, {1}));
    CHECK(alone.transport.send({.source = controller, .destination = component}, from_hex("0220"), {}));
    CHECK(next(alone).to == "1");
}

TEST_CASE("a packet whose connection has ended is not sent, and counted") {
    machine m{{{controller}}, {.has_group = false}};
    m.receive(from_hex("02 00 1000 01 14017E00 0A017E00 0220 0200"), 0s, 5);
    REQUIRE(send(m, {.source = controller, .destination = component}, "0240"));
    m.transport.forget({5});
    CHECK(next(m).to == "none");
    CHECK(m.transport.counts().unknown_peers == 1);
}

TEST_CASE("other forms of JAUS at the port are named and counted") {
    machine m{{{component}}};
    CHECK(m.receive(from_hex("06 02 0200 01210203 04200506 0000 0000"), 0s) == jaus::datagram_form::bare);
    CHECK(m.receive(from_hex("01 0000 0010 0602020001210203042005060000 0000"), 0s) == jaus::datagram_form::judp1);
    CHECK(m.receive(from_hex("4a41555330312e30 0602020001210203042005060000 0000"), 0s) == jaus::datagram_form::jaus01);
    CHECK(m.receive(from_hex("ff"), 0s) == jaus::datagram_form::unknown);
    const auto& counts = m.transport.counts();
    CHECK(counts.of(jaus::datagram_form::bare) == 1);
    CHECK(counts.of(jaus::datagram_form::judp1) == 1);
    CHECK(counts.of(jaus::datagram_form::jaus01) == 1);
    CHECK(counts.of(jaus::datagram_form::unknown) == 1);
    CHECK(m.received.empty());
}

TEST_CASE("faulty packets are counted by their error, and those behind them are processed") {
    machine m{{{component}}};
    m.receive(from_hex("02 C0 1200 0507 01 0A017E00 14017E00 0220 0200 00 1000 01 0A017E00 14017E00 0220 0300"), 0s);
    m.receive(from_hex("02 40 1200 0507 01 0A017E00 14017E00 0220 0400"), 0s); // a proposal is a message
    m.receive(from_hex("02 00 0F00 01 0A017E00 14017E00 02 0500"), 0s);
    m.receive(from_hex("02 00 1000 01 0A017E00 14017E00 0220 05"), 0s);
    m.receive(from_hex("02 01 1000 01 0A017E00 14017E00 0220 0600"), 0s);
    CHECK(m.received.size() == 2);
    const auto& counts = m.transport.counts();
    CHECK(counts.of(transport_errc::compressed) == 1);
    CHECK(counts.of(transport_errc::no_message_id) == 1);
    CHECK(counts.of(transport_errc::truncated) == 1);
    CHECK(counts.of(transport_errc::unknown_type) == 1);
}

TEST_CASE("a source that is configured for another endpoint is not heard") {
    machine m{{{component}}};
    CHECK(m.transport.fix(controller, {7}));
    m.receive(from_hex("02 00 1000 11 0A017E00 14017E00 0220 0100"), 0s, 8);
    CHECK(m.received.empty());
    CHECK(next(m).to == "none");
    CHECK(m.transport.counts().wrong_endpoint == 1);
    m.receive(from_hex("02 00 1000 11 0A017E00 14017E00 0220 0100"), 0s, 7);
    CHECK(m.received.size() == 1);
}

TEST_CASE("an acknowledged message to nobody times out after its attempts") {
    machine m{{{controller}}, {.retry = {.interval = 100ms, .attempts = 2}}};
    REQUIRE(send(m, {.source = controller, .destination = component, .is_acknowledged = true}, "0220"));
    CHECK(next(m, 0ms).to == "group");
    CHECK(m.transport.next_event() == support::instant{100ms}.at);
    CHECK(next(m, 100ms).to == "group");
    CHECK(next(m, 200ms).to == "none");
    const auto done = m.transport.next_outcome();
    REQUIRE(done);
    CHECK(done->outcome == sae::sent_outcome::timed_out);
    CHECK(done->destination == component);
    CHECK_FALSE(m.transport.next_event());
}

TEST_CASE("a closed transport hears configured components alone") {
    machine m{{{component}}, {.is_closed = true}};
    CHECK(m.transport.fix(controller, {7}));
    m.receive(from_hex("02 00 1000 11 0A017E00 14017E00 0220 0100"), 0s, 7);
    m.receive(from_hex("02 00 1000 11 0A017E00 15017E00 0220 0100"), 0s, 7);
    CHECK(m.received.size() == 1);
    CHECK(m.transport.counts().unknown_source == 1);
    CHECK(m.transport.peers().find({21, 1, 126}) == nullptr);
    CHECK(next(m).to == "7");
    CHECK(next(m).to == "none");
}
