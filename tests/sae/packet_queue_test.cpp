// Packets are sent by priority and repeated until they are acknowledged.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/instant.hpp"
#include <jauscat/sae/transport/packet_queue.hpp>

#include <chrono>
#include <vector>

namespace {

namespace sae = jauscat::sae;
using namespace std::chrono_literals;
using jauscat::test::hex_literal;
using jauscat::test::hex_of;
using jauscat::test::to_hex;
using sae::sent_outcome;
using sae::transport_errc;
using support::instant;
using bytes = std::vector<std::byte>;

constexpr sae::jaus_id here{20, 1, 126}, there{10, 1, 126};
constexpr auto query = hex_literal<2>("0220");

struct queue {
    std::vector<sae::queued_packet> places;
    bytes memory;
    sae::packet_queue packets;

    explicit queue(std::size_t count = 8, std::size_t size = 64)
        : places(count), memory(count * size), packets{places, memory, {.interval = 100ms, .attempts = 3}} {}

    auto put(std::uint16_t number, sae::priority priority = {}, bool is_repeated = false,
             std::span<const std::byte> payload = query, std::size_t most = 40) {
        return packets
            .put({.priority = priority, .destination = there, .source = here}, sae::cut_payload{payload, most}, number,
                 is_repeated, instant{0s})
            .error();
    }
    std::string next(instant now = 0s) {
        const auto datagram = packets.next_datagram(now);
        return datagram ? to_hex(datagram->bytes) : "none";
    }
    int number_of_next(instant now = 0s) {
        const auto datagram = packets.next_datagram(now);
        if (!datagram) return -1;
        CHECK(datagram->destination == there);
        return sae::split(datagram->bytes.subspan(1)).sequence_number;
    }
    bool reply(std::uint16_t number, sae::acknowledgement how = sae::acknowledgement::ack) {
        return packets.on_reply({.acknowledgement = how, .destination = here, .source = there}, number);
    }
};

} // namespace

TEST_CASE("a packet is queued as the datagram of the capture") {
    queue q;
    CHECK(q.next() == "none");
    CHECK(q.put(2, sae::priority::standard) == transport_errc::ok);
    CHECK(q.packets.next_event() == instant{0s}.at);
    CHECK(q.next() == hex_of("02 00 1000 01 0A017E00 14017E00 0220 0200"));
    CHECK(q.next() == "none");
    CHECK_FALSE(q.packets.next_event());
    CHECK(q.packets.waiting() == 0);
}

TEST_CASE("the highest priority is sent first, and of one priority what came first") {
    queue q;
    CHECK(q.put(1, sae::priority::low) == transport_errc::ok);
    CHECK(q.put(2, sae::priority::high) == transport_errc::ok);
    CHECK(q.put(3, sae::priority::low) == transport_errc::ok);
    CHECK(q.put(4, sae::priority::safety_critical) == transport_errc::ok);
    CHECK(q.put(5, sae::priority::standard) == transport_errc::ok);
    CHECK(q.put(6, sae::priority::high) == transport_errc::ok);
    for (const int number : {4, 2, 6, 5, 1, 3, -1}) CHECK(q.number_of_next() == number);
}

TEST_CASE("a quarter of the places is for safety critical packets") {
    queue q;
    for (std::uint16_t n = 0; n != 6; ++n) CHECK(q.put(n, sae::priority::high) == transport_errc::ok);
    CHECK(q.put(6, sae::priority::high) == transport_errc::no_capacity);
    CHECK(q.put(7, sae::priority::safety_critical) == transport_errc::ok);
    CHECK(q.put(8, sae::priority::safety_critical) == transport_errc::ok);
    CHECK(q.put(9, sae::priority::safety_critical) == transport_errc::no_capacity);
    CHECK(q.number_of_next() == 7);
}

TEST_CASE("a packet that wants an acknowledgement is repeated with its number until it gets it") {
    queue q;
    CHECK(q.put(1, sae::priority::standard, true) == transport_errc::ok);
    const auto expected = hex_of("02 00 1000 11 0A017E00 14017E00 0220 0100");
    CHECK(q.next(0ms) == expected);
    CHECK(q.packets.next_event() == instant{100ms}.at);
    CHECK(q.next(99ms) == "none");
    CHECK(q.next(100ms) == expected);
    CHECK_FALSE(q.reply(2));
    CHECK_FALSE(q.packets.next_outcome());
    CHECK(q.reply(1));
    CHECK_FALSE(q.reply(1));
    const auto done = q.packets.next_outcome();
    REQUIRE(done);
    CHECK(done->outcome == sent_outcome::acknowledged);
    CHECK(done->first_number == 1);
    CHECK(done->destination == there);
    CHECK_FALSE(q.packets.next_outcome());
    CHECK(q.packets.waiting() == 0);
}

TEST_CASE("after its last attempt a packet times out") {
    queue q;
    CHECK(q.put(1, {}, true) == transport_errc::ok);
    for (const auto at : {0ms, 100ms, 200ms}) CHECK(q.number_of_next(at) == 1);
    CHECK(q.number_of_next(299ms) == -1);
    CHECK_FALSE(q.packets.next_outcome());
    CHECK(q.number_of_next(300ms) == -1);
    CHECK(q.packets.next_outcome()->outcome == sent_outcome::timed_out);
    CHECK_FALSE(q.reply(1));
}

TEST_CASE("a negative reply ends the repetition") {
    queue q;
    CHECK(q.put(1, {}, true) == transport_errc::ok);
    CHECK(q.number_of_next() == 1);
    CHECK(q.reply(1, sae::acknowledgement::nak));
    CHECK(q.packets.next_outcome()->outcome == sent_outcome::refused);
}

TEST_CASE("a reply of another component, or before the packet was sent, is none") {
    queue q;
    CHECK(q.put(1, {}, true) == transport_errc::ok);
    CHECK_FALSE(q.reply(1));
    CHECK(q.number_of_next() == 1);
    CHECK_FALSE(q.packets.on_reply(
        {.acknowledgement = sae::acknowledgement::ack, .destination = here, .source = {11, 1, 126}}, 1));
    CHECK(q.reply(1));
}

TEST_CASE("a message of several packets is acknowledged when all of them are, and fails with one") {
    const bytes payload(100, std::byte{0x55});
    queue q;
    CHECK(q.put(65535, {}, true, payload) == transport_errc::ok);
    for (const int number : {65535, 0, 1, -1}) CHECK(q.number_of_next() == number);
    CHECK(q.reply(0));
    CHECK(q.reply(65535));
    CHECK_FALSE(q.packets.next_outcome());
    CHECK(q.reply(1));
    const auto done = q.packets.next_outcome();
    REQUIRE(done);
    CHECK(done->outcome == sent_outcome::acknowledged);
    CHECK(done->first_number == 65535);

    CHECK(q.put(2, {}, true, payload) == transport_errc::ok);
    for (const int number : {2, 3, 4, -1}) CHECK(q.number_of_next() == number);
    CHECK(q.reply(3, sae::acknowledgement::nak));
    CHECK(q.packets.next_outcome()->outcome == sent_outcome::refused);
    CHECK_FALSE(q.packets.next_outcome());
    CHECK(q.packets.waiting() == 0);
}

TEST_CASE("all packets of a message are taken, or none") {
    const bytes payload(200, std::byte{0x55});
    queue q;
    CHECK(q.put(1) == transport_errc::ok);
    CHECK(q.put(2) == transport_errc::ok);
    CHECK(q.put(3, {}, false, payload) == transport_errc::no_capacity);
    CHECK(q.packets.waiting() == 2);
    CHECK(q.number_of_next() == 1);
    CHECK(q.put(3, {}, false, payload) == transport_errc::ok);
    CHECK(q.put(3, {}, false, bytes(300)) == transport_errc::too_large);
    CHECK(queue{}.put(3, {}, false, bytes(60), 60) == transport_errc::too_large);
    CHECK(queue{}.packets.payload_capacity() == 49);
    CHECK(queue{0}.packets.payload_capacity() == 0);
    CHECK(queue{0}.put(1) == transport_errc::too_large);
}
