// Two transports over a network that loses, doubles, delays and reorders datagrams; and any bytes.
#include "sae/machine.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/sae/transport/jserial.hpp>
#include <jauscat/sae/transport/jtcp.hpp>

#include <map>
#include <random>

namespace {

namespace sae = jauscat::sae;
using namespace std::chrono_literals;
using jauscat::test::datagram_network;
using jauscat::test::from_hex;
using jauscat::test::machine;
using bytes = std::vector<std::byte>;

constexpr sae::jaus_id one{1, 1, 1}, two{1, 1, 2};

/// All packets that a transport has counted as received.
std::uint64_t received_by(const sae::transport& transport) {
    const auto& c = transport.counts();
    std::uint64_t sum = c.packets + c.replies + c.late_replies + c.repeated + c.not_here + c.own + c.unknown_source +
                        c.wrong_endpoint + c.no_capacity;
    for (const auto count : c.faults) sum += count;
    return sum;
}

/// A payload that is found again by its number.
bytes payload_of(std::uint16_t number, std::size_t size) {
    bytes payload(size);
    for (std::size_t i = 0; i != size; ++i) payload[i] = static_cast<std::byte>(number >> (i % 2 * 8));
    return payload;
}

struct sender {
    machine& from;
    sae::jaus_id source, destination;
    std::mt19937 random;
    std::map<std::uint16_t, bytes> sent{};
    int acknowledged{}, failed{};
    std::map<std::uint16_t, bool> outcomes{}; // by the number of the first packet

    void work(jauscat::time_point now, std::size_t most) {
        while (const auto done = from.transport.next_outcome())
            outcomes[done->first_number] = done->outcome == sae::sent_outcome::acknowledged;
        if (sent.size() == most || from.transport.next_event().value_or(now + 1h) <= now) return;
        const auto id = static_cast<std::uint16_t>(sent.size());
        const bool is_known = from.transport.peers().find(destination) != nullptr;
        const auto payload = payload_of(id, is_known ? 2 + random() % 400 : 2);
        const auto number = from.transport.send({.source = source,
                                                 .destination = destination,
                                                 .priority = static_cast<sae::priority>(random() % 4),
                                                 .is_acknowledged = true},
                                                payload, now);
        if (number) sent.emplace(*number, payload);
    }
};

void check(const sender& s, const machine& receiver) {
    std::map<std::uint16_t, int> delivered;
    for (const auto& got : receiver.received) {
        const auto found = s.sent.find(got.message.first_number);
        REQUIRE(found != s.sent.end());
        CHECK(found->second == got.payload);
        ++delivered[got.message.first_number];
    }
    for (const auto& [number, payload] : s.sent) {
        const auto outcome = s.outcomes.find(number);
        REQUIRE(outcome != s.outcomes.end());
        if (outcome->second)
            CHECK(delivered[number] == 1);
        else
            CHECK(delivered[number] <= 1);
    }
}

} // namespace

TEST_CASE("whatever the network does, an acknowledged message is delivered exactly once") {
    int acknowledged = 0, failed = 0;
    for (unsigned seed = 1; seed <= 60; ++seed) {
        const sae::transport_options options{.retry = {.interval = 50ms, .attempts = seed % 3 == 0 ? 4U : 12U}};
        machine a{{{one, static_cast<std::uint16_t>(65536 - seed)}}, options}, b{{{two}}, options};
        datagram_network network{seed};
        network.lose = seed % 40;
        network.duplicate = seed % 30;
        network.delay = seed % 50;
        network.add(a);
        network.add(b);
        constexpr std::size_t most = 40;
        sender from_a{a, one, two, std::mt19937{seed}}, from_b{b, two, one, std::mt19937{seed + 1000}};
        network.work = [&] {
            from_a.work(network.now, most);
            from_b.work(network.now, most);
        };
        network.run(10min);
        INFO("seed " << seed);
        REQUIRE(from_a.sent.size() == most);
        REQUIRE(from_b.sent.size() == most);
        check(from_a, b);
        check(from_b, a);
        for (const auto* s : {&from_a, &from_b})
            for (const auto& [number, is_acknowledged] : s->outcomes) ++(is_acknowledged ? acknowledged : failed);
    }
    CHECK(acknowledged > 4000);
    CHECK(failed > 10);
}

TEST_CASE("any bytes give messages or counted errors") {
    std::mt19937 random{7};
    machine m{{{one}}};
    bytes buffer(128);
    sae::jserial_reader serial{buffer};
    bytes stream_buffer(128);
    std::uint64_t messages = 0, expected = 0;
    for (int round = 0; round != 20'000; ++round) {
        bytes any(random() % 80);
        for (auto& b : any) b = static_cast<std::byte>(random() % 4 == 0 ? 0x10 : random());
        if (!any.empty() && round % 2 == 0) any[0] = std::byte{2};
        if (sae::is_judp2(any))
            for (sae::datagram_reader packets{any}; packets.has_next(); ++expected) static_cast<void>(packets.next());
        m.receive(any, std::chrono::milliseconds{round}, random() % 4);
        serial.on_bytes(any, [&](const sae::serial_frame& f) {
            if (f) ++messages;
        });
        sae::jtcp_reader stream{stream_buffer};
        stream.on_bytes(any, [&](const auto& packet) {
            ++expected;
            m.transport.on_packet({9}, packet, {}, [](const auto&) {});
        });
        while (m.transport.next_datagram(jauscat::time_point{} + std::chrono::milliseconds{round})) continue;
    }
    CHECK(messages == 0);
    CHECK(received_by(m.transport) == expected); // each packet is counted once
}

TEST_CASE("each cut and each changed byte of a datagram gives messages or counted errors") {
    const auto datagram =
        from_hex("02 00 1200 51 01010100 14017E00 0D00C801 0100 00 1000 D1 01010100 14017E00 0506 0200"
                 "00 1000 19 FFFFFFFF 14017E00 0220 0300");
    for (std::size_t size = 0; size <= datagram.size(); ++size) {
        machine m{{{one}}};
        m.receive(std::span{datagram}.first(size), 0s);
        CHECK(m.received.size() == (size == datagram.size() ? 2U : size >= 35 ? 1U : 0U));
    }
    for (std::size_t at = 0; at != datagram.size(); ++at)
        for (unsigned value = 0; value != 256; ++value) {
            auto changed = datagram;
            changed[at] = static_cast<std::byte>(value);
            machine m{{{one}}};
            m.receive(changed, 0s);
            CHECK(m.received.size() <= 3);
            std::uint64_t expected = 0;
            if (sae::is_judp2(changed))
                for (sae::datagram_reader packets{changed}; packets.has_next(); ++expected)
                    static_cast<void>(packets.next());
            CHECK(received_by(m.transport) == expected);
            while (m.transport.next_datagram({})) continue;
        }
}

TEST_CASE("a flood of forged sources does not keep a known peer out") {
    std::mt19937 random{3};
    machine m{{{one}}};
    m.receive(from_hex("02 00 1000 01 01010100 01010200 0220 0100"), 0s, 1);
    for (int i = 0; i != 10'000; ++i) {
        auto forged = from_hex("02 00 1200 51 01010100 14017E00 0D00C801 0100");
        for (std::size_t at : {9U, 10U, 11U, 15U, 17U}) forged[at] = static_cast<std::byte>(random() % 254 + 1);
        m.receive(forged, 1s, 2);
    }
    m.received.clear();
    m.receive(from_hex("02 00 1000 01 01010100 01010200 0220 0200"), 1s, 1);
    CHECK(m.received.size() == 1);
    REQUIRE(m.transport.peers().find(two) != nullptr);
    CHECK(m.transport.peers().find(two)->endpoint.value == 1);
}
