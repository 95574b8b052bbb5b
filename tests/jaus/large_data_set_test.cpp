// Large data sets put together from their packets, in whatever order and number these come.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/instant.hpp"
#include <jauscat/jaus/large_data/reassembler.hpp>

#include <random>
#include <string>

namespace {

using namespace std::chrono_literals;
using jauscat::jaus::data_flag;
using jauscat::jaus::reassembled;
using jauscat::test::from_hex;
using jauscat::test::to_hex;
using support::instant;
namespace jaus = jauscat::jaus;

/// Two places of at most four packets and eight bytes, and what came out of them.
struct receiver {
    std::array<jaus::partial_data_set, 2> places{};
    std::array<jaus::held_packet, 8> packets{};
    std::array<std::byte, 16> memory{};
    jaus::reassembler sets{places, packets, memory, 1s, {.places_per_source = 2, .longest_gap = 1s}};
    std::vector<std::string> whole{};
    std::vector<std::size_t> lost{}; ///< packets that each incomplete data set had

    reassembled hear(data_flag flag, std::uint16_t number, const std::string& body, instant now = 0ms,
                     std::uint8_t sender = 1, std::uint16_t code = 0x4807, jaus::ack_nak wish = jaus::ack_nak::none) {
        const auto bytes = from_hex(body);
        const jaus::header head{.ack_nak = wish,
                                .command_code = code,
                                .source = {sender, 37, 1, 2},
                                .data_size = static_cast<std::uint16_t>(bytes.size()),
                                .data_flag = flag,
                                .sequence_number = number};
        return sets.on_packet(
            head, bytes, now,
            [&](const jaus::header& first, std::span<const std::byte> all) {
                REQUIRE(first.sequence_number == 0);
                whole.push_back(to_hex(all));
            },
            [&](const jaus::partial_data_set& set) { lost.push_back(set.packets); });
    }
};
using texts = std::vector<std::string>;

} // namespace

TEST_CASE("packets in order give the whole body with the last one") {
    receiver r;
    REQUIRE(r.hear(data_flag::first, 0, "0102") == reassembled::waiting);
    REQUIRE(r.hear(data_flag::middle, 1, "0304") == reassembled::waiting);
    REQUIRE(r.whole.empty());
    REQUIRE(r.hear(data_flag::last, 2, "05") == reassembled::whole);
    REQUIRE(r.whole == texts{"01 02 03 04 05"});
    REQUIRE(r.lost.empty());
    REQUIRE(r.places[0].packets == 0);
}

TEST_CASE("a single packet is not handled") {
    receiver r;
    REQUIRE(r.hear(data_flag::only, 7, "0102") == reassembled::only);
    REQUIRE(r.whole.empty());
}

TEST_CASE("an acknowledgement is not a packet, whatever its data flag") {
    receiver r;
    for (const auto flag : {data_flag::first, data_flag::middle, data_flag::last, data_flag::repeated})
        for (const auto how : {jaus::ack_nak::ack, jaus::ack_nak::nak})
            REQUIRE(r.hear(flag, 0, "", 0ms, 1, 0x4807, how) == reassembled::only);
    REQUIRE(r.whole.empty());
    REQUIRE(r.places[0].packets == 0);
}

TEST_CASE("every order of the packets gives the same body") {
    struct packet {
        data_flag flag;
        std::uint16_t number;
        const char* body;
    };
    std::array<packet, 4> order{{{data_flag::first, 0, "0102"},
                                 {data_flag::middle, 1, "03"},
                                 {data_flag::repeated, 2, ""},
                                 {data_flag::last, 3, "040506"}}};
    const auto by_number = [](const packet& a, const packet& b) { return a.number < b.number; };
    int orders = 0;
    do {
        receiver r;
        for (const auto& p : order) r.hear(p.flag, p.number, p.body);
        REQUIRE(r.whole == texts{"01 02 03 04 05 06"});
        REQUIRE(r.lost.empty());
        ++orders;
    } while (std::ranges::next_permutation(order, by_number).found);
    REQUIRE(orders == 24);
}

TEST_CASE("a duplicate packet is dropped, a retransmitted one fills its gap") {
    receiver r;
    r.hear(data_flag::first, 0, "01");
    REQUIRE(r.hear(data_flag::first, 0, "01") == reassembled::repeated);
    REQUIRE(r.hear(data_flag::repeated, 0, "01") == reassembled::repeated);
    REQUIRE(r.hear(data_flag::last, 2, "03") == reassembled::waiting);
    REQUIRE(r.hear(data_flag::repeated, 1, "02") == reassembled::whole);
    REQUIRE(r.whole == texts{"01 02 03"});
}

TEST_CASE("data sets of several senders and codes are assembled concurrently") {
    receiver r;
    r.hear(data_flag::first, 0, "01", 0ms, 1);
    r.hear(data_flag::first, 0, "11", 0ms, 2);
    r.hear(data_flag::last, 1, "02", 0ms, 1);
    r.hear(data_flag::first, 0, "21", 0ms, 2, 0x4A23);
    r.hear(data_flag::last, 1, "12", 0ms, 2);
    r.hear(data_flag::last, 1, "22", 0ms, 2, 0x4A23);
    REQUIRE(r.whole == texts{"01 02", "11 12", "21 22"});
    REQUIRE(r.lost.empty());
}

TEST_CASE("a new data set of a sender ends its previous one") {
    receiver r;
    r.hear(data_flag::first, 0, "01");
    r.hear(data_flag::middle, 1, "02");
    REQUIRE(r.hear(data_flag::first, 0, "0a") == reassembled::waiting);
    REQUIRE(r.lost == std::vector<std::size_t>{2});
    REQUIRE(r.hear(data_flag::last, 1, "0b") == reassembled::whole);
    REQUIRE(r.whole == texts{"0a 0b"});

    // Seen in recorded traffic: last packets only, of the same number or of another.
    r.lost.clear();
    r.hear(data_flag::last, 3, "01");
    r.hear(data_flag::last, 3, "02");
    r.hear(data_flag::last, 4, "03");
    r.hear(data_flag::last, 2, "04");
    REQUIRE(r.lost == std::vector<std::size_t>{1, 1, 1});
    REQUIRE(r.whole.size() == 1);
}

TEST_CASE("a flood of first packets from spoofed sources displaces no active data set") {
    receiver r;
    r.hear(data_flag::first, 0, "01", 0ms, 1);
    r.hear(data_flag::middle, 1, "02", 10ms, 1);
    for (int round = 0; round != 40; ++round)
        for (unsigned sender = 2; sender != 256; ++sender)
            REQUIRE(r.hear(data_flag::first, 0, "ff", 20ms * round, static_cast<std::uint8_t>(sender)) ==
                    reassembled::waiting);
    // Each of the flood displaced the one before it, and nothing else.
    REQUIRE(r.lost == std::vector<std::size_t>(40 * 254 - 1, 1));
    REQUIRE(r.hear(data_flag::last, 2, "03", 900ms, 1) == reassembled::whole);
    REQUIRE(r.whole == texts{"01 02 03"});
}

TEST_CASE("a data set that begins during a flood of first packets is received") {
    receiver r;
    std::uint8_t spoofed = 2;
    const auto flood = [&](instant now) {
        r.hear(data_flag::first, 0, "ff", now, spoofed);
        if (++spoofed == 0) spoofed = 2;
    };
    for (int i = 0; i != 1000; ++i) flood(1ms);
    r.hear(data_flag::first, 0, "01", 1ms, 1);
    flood(1ms); // fewer than there are places, until its second packet comes
    r.hear(data_flag::middle, 1, "02", 1ms, 1);
    for (int i = 0; i != 1000; ++i) flood(1ms);
    REQUIRE(r.hear(data_flag::last, 2, "03", 1ms, 1) == reassembled::whole);
    REQUIRE(r.whole == texts{"01 02 03"});
}

TEST_CASE("places of active data sets are not given to new ones, which are refused") {
    receiver r;
    for (const std::uint8_t sender : {std::uint8_t{1}, std::uint8_t{2}})
        for (const std::uint16_t number : {std::uint16_t{0}, std::uint16_t{1}})
            r.hear(data_flag::middle, number, "01", 0ms, sender);
    REQUIRE(r.hear(data_flag::first, 0, "ff", 999ms, 3) == reassembled::no_capacity);
    REQUIRE(r.lost.empty());
    REQUIRE(r.hear(data_flag::first, 0, "ff", 1000ms, 3) == reassembled::waiting);
    REQUIRE(r.lost == std::vector<std::size_t>{2});
}

TEST_CASE("one source cannot take the places of others with many command codes") {
    std::array<jaus::partial_data_set, 4> places{};
    std::array<jaus::held_packet, 16> packets{};
    std::array<std::byte, 64> memory{};
    jaus::reassembler sets{places, packets, memory, 1s};
    const auto hear = [&](std::uint8_t sender, std::uint16_t code, std::uint16_t number) {
        const jaus::header head{.command_code = code,
                                .source = {sender, 37, 1, 2},
                                .data_flag = data_flag::middle,
                                .sequence_number = number};
        return sets.on_packet(head, from_hex("aa"), instant{0ms}, [](const auto&...) {}, [](const auto&...) {});
    };
    for (std::uint16_t code = 0; code != 1000; ++code) {
        // Two packets of each: the first two sets go on, so their source has its share, half of four.
        const auto expected = code < 2 ? reassembled::waiting : reassembled::no_capacity;
        REQUIRE(hear(1, code, 0) == expected);
        REQUIRE(hear(1, code, 1) == expected);
    }
    REQUIRE(hear(2, 7, 0) == reassembled::waiting);
    REQUIRE(hear(3, 7, 0) == reassembled::waiting);
    REQUIRE(std::ranges::count(places, std::uint8_t{1}, [](const auto& set) { return set.header.source.instance; }) ==
            2);
}

TEST_CASE("a late packet of a delivered data set does not become part of the next one") {
    receiver r;
    const auto send_first = [&] {
        r.hear(data_flag::first, 0, "01", 0ms);
        r.hear(data_flag::middle, 1, "02", 0ms);
        REQUIRE(r.hear(data_flag::last, 2, "03", 0ms) == reassembled::whole);
    };
    send_first();
    REQUIRE(r.hear(data_flag::middle, 1, "02", 1999us) == reassembled::repeated);
    REQUIRE(r.hear(data_flag::repeated, 0, "01", 1999us) == reassembled::repeated);
    // Of the next one packet 1 is lost: what came late of the first must not stand in for it.
    r.hear(data_flag::first, 0, "0a", 19ms);
    REQUIRE(r.hear(data_flag::last, 2, "0c", 19ms) == reassembled::waiting);
    REQUIRE(r.hear(data_flag::repeated, 1, "0b", 19ms) == reassembled::whole);
    REQUIRE(r.whole == texts{"01 02 03", "0a 0b 0c"});

    // The same data set again is one more when it does not come at once.
    for (const auto now : {21ms, 23ms}) {
        r.hear(data_flag::first, 0, "0a", now);
        r.hear(data_flag::middle, 1, "0b", now);
        REQUIRE(r.hear(data_flag::last, 2, "0c", now) == reassembled::whole);
    }
    REQUIRE(r.whole.size() == 4);
    REQUIRE(r.lost.empty());
}

TEST_CASE("equal data sets of two senders, or of two codes, are both received") {
    receiver r;
    const auto send = [&](std::uint8_t sender, std::uint16_t code) {
        REQUIRE(r.hear(data_flag::first, 0, "01", 0ms, sender, code) == reassembled::waiting);
        REQUIRE(r.hear(data_flag::last, 1, "02", 0ms, sender, code) == reassembled::whole);
    };
    send(1, 0x4807);
    send(2, 0x4807);
    send(2, 0x4A23);
    REQUIRE(r.whole == texts{"01 02", "01 02", "01 02"});
}

TEST_CASE("an equal data set without acknowledgement is received also if its last packet comes first") {
    receiver r;
    REQUIRE(r.hear(data_flag::first, 0, "01", 0ms) == reassembled::waiting);
    REQUIRE(r.hear(data_flag::last, 1, "02", 0ms) == reassembled::whole);
    REQUIRE(r.hear(data_flag::last, 1, "02", 100ms) == reassembled::waiting);
    REQUIRE(r.hear(data_flag::first, 0, "01", 101ms) == reassembled::whole);
}

TEST_CASE("a data set may take longer than the longest gap between two of its packets") {
    receiver r; // a gap of 1 s
    REQUIRE(r.hear(data_flag::first, 0, "01", 0ms) == reassembled::waiting);
    REQUIRE(r.hear(data_flag::middle, 1, "02", 900ms) == reassembled::waiting);
    REQUIRE(r.hear(data_flag::last, 2, "03", 1800ms) == reassembled::whole);
    REQUIRE(r.lost.empty());
}

TEST_CASE("a last packet repeated for want of its acknowledgement begins no data set") {
    receiver r;
    const auto hear = [&](data_flag flag, std::uint16_t number, const std::string& body, instant now) {
        return r.hear(flag, number, body, now, 1, 0x4807, jaus::ack_nak::request);
    };
    REQUIRE(hear(data_flag::first, 0, "01", 0ms) == reassembled::waiting);
    REQUIRE(hear(data_flag::last, 1, "02", 0ms) == reassembled::whole);
    REQUIRE(hear(data_flag::last, 1, "02", 1999ms) == reassembled::repeated);
    // Another one, and the same one again, are received all the same.
    for (const auto now : {1999ms, 2010ms}) {
        REQUIRE(hear(data_flag::first, 0, "03", now) == reassembled::waiting);
        REQUIRE(hear(data_flag::last, 1, "02", now) == reassembled::whole);
    }
    REQUIRE(r.whole == texts{"01 02", "03 02", "03 02"});
    REQUIRE(r.lost.empty());
    REQUIRE(hear(data_flag::last, 1, "02", 4010ms) == reassembled::waiting);
}

// Its acknowledgement would be taken for that of the same number of the next data set, which may have been lost.
TEST_CASE("a possible late copy from an acknowledged data set is not acknowledged as part of the next one") {
    receiver r;
    r.sets = jaus::reassembler{
        r.places, r.packets, r.memory, 5s, {.places_per_source = 2, .linger_of_copies = 375ms, .longest_gap = 1s}};
    const auto hear = [&](data_flag flag, std::uint16_t number, const std::string& body, instant now) {
        return r.hear(flag, number, body, now, 1, 0x4807, jaus::ack_nak::request);
    };
    REQUIRE(hear(data_flag::first, 0, "01", 0ms) == reassembled::waiting);
    REQUIRE(hear(data_flag::middle, 1, "02", 0ms) == reassembled::waiting);
    REQUIRE(hear(data_flag::last, 2, "03", 0ms) == reassembled::whole);
    SECTION("all packets are copies") {
        REQUIRE(hear(data_flag::first, 0, "01", 40ms) == reassembled::doubtful);
        REQUIRE(hear(data_flag::first, 0, "0a", 41ms) == reassembled::waiting);
        REQUIRE(r.lost.size() == 1);
        REQUIRE(hear(data_flag::first, 0, "01", 100ms) == reassembled::doubtful); // nothing is given up for it
        REQUIRE(hear(data_flag::middle, 1, "0b", 100ms) == reassembled::waiting);
        REQUIRE(hear(data_flag::middle, 1, "02", 101ms) == reassembled::doubtful);
        REQUIRE(hear(data_flag::last, 2, "03", 151ms) == reassembled::doubtful);
        REQUIRE(hear(data_flag::last, 2, "0c", 152ms) == reassembled::whole);
        REQUIRE(r.whole == texts{"01 02 03", "0a 0b 0c"});
    }
    SECTION("a packet was lost, and a copy takes its place") {
        REQUIRE(hear(data_flag::first, 0, "0a", 40ms) == reassembled::waiting);
        REQUIRE(hear(data_flag::middle, 1, "02", 41ms) == reassembled::doubtful);
        REQUIRE(hear(data_flag::repeated, 1, "0b", 91ms) == reassembled::waiting); // all of it begins anew
        REQUIRE(hear(data_flag::last, 2, "0c", 92ms) == reassembled::waiting);
        REQUIRE(r.whole == texts{"01 02 03"});
    }
    SECTION("equal parts are sent twice") {
        REQUIRE(hear(data_flag::first, 0, "01", 40ms) == reassembled::doubtful);
        REQUIRE(hear(data_flag::first, 0, "01", 41ms) == reassembled::repeated);
        REQUIRE(hear(data_flag::middle, 1, "02", 42ms) == reassembled::doubtful);
        REQUIRE(hear(data_flag::middle, 1, "02", 43ms) == reassembled::repeated);
        REQUIRE(hear(data_flag::last, 2, "03", 44ms) == reassembled::doubtful);
        REQUIRE(hear(data_flag::last, 2, "03", 45ms) == reassembled::whole);
        REQUIRE(r.whole == texts{"01 02 03", "01 02 03"});
    }
    SECTION("equal parts arrive after that time") {
        REQUIRE(hear(data_flag::first, 0, "01", 375ms) == reassembled::waiting);
        REQUIRE(hear(data_flag::middle, 1, "02", 375ms) == reassembled::waiting);
        REQUIRE(hear(data_flag::last, 2, "04", 375ms) == reassembled::whole);
    }
}

TEST_CASE("packets that may belong to two data sets are not combined") {
    receiver r;
    // The tail of one, whose head was not received, and the head of the next.
    r.hear(data_flag::middle, 1, "02", 0ms);
    r.hear(data_flag::last, 2, "03", 1ms);
    REQUIRE(r.hear(data_flag::first, 0, "0a", 3ms) == reassembled::waiting);
    REQUIRE(r.hear(data_flag::middle, 1, "0b", 4ms) == reassembled::waiting);
    REQUIRE(r.hear(data_flag::last, 2, "0c", 5ms) == reassembled::whole);
    // The head of one, and after a long silence the tail of the next, whose head was not received.
    r.hear(data_flag::first, 0, "01", 100ms);
    REQUIRE(r.hear(data_flag::last, 1, "0b", 1101ms) == reassembled::waiting);
    // The same, where the second asks for acknowledgement.
    r.hear(data_flag::first, 0, "01", 8000ms);
    REQUIRE(r.hear(data_flag::last, 1, "0b", 9001ms, 1, 0x4807, jaus::ack_nak::request) == reassembled::waiting);
    // Two that begin alike.
    r.hear(data_flag::first, 0, "01", 2000ms);
    r.hear(data_flag::middle, 1, "02", 2000ms);
    r.hear(data_flag::first, 0, "01", 2003ms);
    REQUIRE(r.hear(data_flag::last, 2, "0c", 2004ms) == reassembled::waiting);
    // One that asks for acknowledgement, and one that does not; other bytes under a number that was repeated.
    r.hear(data_flag::first, 0, "01", 4000ms, 1, 0x4807, jaus::ack_nak::request);
    REQUIRE(r.hear(data_flag::last, 1, "0b", 4001ms) == reassembled::waiting);
    r.hear(data_flag::first, 0, "01", 6000ms);
    r.hear(data_flag::repeated, 0, "0a", 6001ms);
    REQUIRE(r.hear(data_flag::last, 1, "02", 6001ms) == reassembled::whole);
    REQUIRE(r.whole == texts{"0a 0b 0c", "0a 02"});
}

TEST_CASE("a packet that ends one data set and continues another is of two") {
    receiver r;
    r.hear(data_flag::first, 0, "01");
    r.hear(data_flag::middle, 1, "02");
    REQUIRE(r.hear(data_flag::last, 1, "02") == reassembled::waiting);
    REQUIRE(r.lost == std::vector<std::size_t>{2});
    REQUIRE(r.hear(data_flag::middle, 1, "02") == reassembled::waiting);
    REQUIRE(r.lost == std::vector<std::size_t>{2, 1});
    REQUIRE(r.whole.empty());
}

TEST_CASE("a data set whose packet 0 is late begins with it") {
    receiver r;
    r.hear(data_flag::middle, 1, "02", 0us);
    REQUIRE(r.hear(data_flag::first, 0, "01", 1500us) == reassembled::waiting);
    REQUIRE(r.hear(data_flag::first, 0, "01", 3ms) == reassembled::repeated); // a copy: 1.5 ms after it
    REQUIRE(r.lost.empty());
    REQUIRE(r.hear(data_flag::last, 2, "03", 3ms) == reassembled::whole);
    REQUIRE(r.whole == texts{"01 02 03"});
}

TEST_CASE("a last packet that requests acknowledgement is kept when it completes the data set") {
    receiver r;
    const auto hear = [&](data_flag flag, std::uint16_t number, const std::string& body) {
        return r.hear(flag, number, body, 0ms, 1, 0x4807, jaus::ack_nak::request);
    };
    REQUIRE(hear(data_flag::first, 0, "01") == reassembled::waiting);
    REQUIRE(hear(data_flag::last, 2, "03") == reassembled::waiting);
    REQUIRE(hear(data_flag::middle, 1, "02") == reassembled::waiting);
    REQUIRE(hear(data_flag::last, 2, "03") == reassembled::whole);
    REQUIRE(r.whole == texts{"01 02 03"});
}

TEST_CASE("a silent data set is replaced by another") {
    receiver r;
    r.hear(data_flag::first, 0, "01", 0ms, 1);
    r.hear(data_flag::middle, 1, "01", 0ms, 1);
    r.hear(data_flag::first, 0, "02", 500ms, 2);
    r.hear(data_flag::middle, 1, "02", 500ms, 2);
    REQUIRE(r.hear(data_flag::first, 0, "03", 999ms, 3) == reassembled::no_capacity);
    REQUIRE(r.hear(data_flag::first, 0, "03", 1000ms, 3) == reassembled::waiting);
    REQUIRE(r.lost == std::vector<std::size_t>{2});

    r.sets.on_time(instant{1600ms}, [&](const jaus::partial_data_set& set) {
        REQUIRE(set.header.source.instance == 2);
        r.lost.push_back(set.packets);
    });
    REQUIRE(r.lost.size() == 2);
    REQUIRE(r.hear(data_flag::last, 1, "04", 1700ms, 3) == reassembled::whole);
}

TEST_CASE("a silent data set keeps its place while another place is free") {
    receiver r;
    r.hear(data_flag::first, 0, "01", 0ms, 1);
    r.hear(data_flag::first, 0, "02", 500ms, 2);
    REQUIRE(r.hear(data_flag::last, 1, "03", 500ms, 2) == reassembled::whole);
    REQUIRE(r.hear(data_flag::first, 0, "04", 1200ms, 3) == reassembled::waiting);
    REQUIRE(r.lost.empty());
    REQUIRE(r.hear(data_flag::last, 1, "05", 1200ms, 3) == reassembled::whole);
}

TEST_CASE("a data set with more bytes or packets than a place holds is dropped, without effect on others") {
    receiver r;
    r.hear(data_flag::first, 0, "aaaaaaaa", 0ms, 1);
    r.hear(data_flag::first, 0, "0102030405060708", 0ms, 2);
    REQUIRE(r.hear(data_flag::middle, 1, "09", 0ms, 2) == reassembled::too_large);
    REQUIRE(r.lost == std::vector<std::size_t>{1});
    for (std::uint16_t number = 0; number != 4; ++number) r.hear(data_flag::middle, number, "01", 0ms, 2);
    REQUIRE(r.hear(data_flag::middle, 4, "01", 0ms, 2) == reassembled::too_large);
    REQUIRE(r.lost == std::vector<std::size_t>{1, 4});
    REQUIRE(r.hear(data_flag::last, 1, "bbbbbbbb", 0ms, 1) == reassembled::whole);
    REQUIRE(r.whole == texts{"aa aa aa aa bb bb bb bb"});
}

TEST_CASE("a packet of more than 65535 bytes is too large for any memory") {
    std::array<jaus::partial_data_set, 1> places{};
    std::array<jaus::held_packet, 2> packets{};
    std::vector<std::byte> memory(0x20000);
    jaus::reassembler sets{places, packets, memory, 1s};
    const auto hear = [&](std::size_t size) {
        return sets.on_packet(
            {.data_flag = data_flag::first}, std::vector<std::byte>(size), instant{0s}, [](const auto&...) {},
            [](const auto&...) {});
    };
    REQUIRE(hear(0x10000) == reassembled::too_large);
    REQUIRE(sets.places()[0].packets == 0);
    REQUIRE(hear(0xFFFF) == reassembled::waiting);
    REQUIRE(sets.places()[0].bytes == 0xFFFF);
}

TEST_CASE("without places nothing is stored") {
    jaus::reassembler none{{}, {}, {}, 1s};
    const auto ignore = [](const auto&...) {};
    REQUIRE(none.on_packet({.data_flag = data_flag::first}, {}, instant{0s}, ignore, ignore) ==
            reassembled::no_capacity);
}

TEST_CASE("random packets stay within the memory and never make a body that was not sent") {
    std::mt19937 random{20};
    receiver r;
    // Each byte says its sender and the packet's number, so a body can be checked for mixed origins.
    for (int i = 0; i != 200000; ++i) {
        const auto sender = static_cast<std::uint8_t>(1 + random() % 4);
        const auto number = static_cast<std::uint16_t>(random() % 5);
        const auto flag =
            std::array{data_flag::first, data_flag::middle, data_flag::repeated, data_flag::last}[random() % 4];
        std::string body;
        for (unsigned size = random() % 4; size != 0; --size) body += std::to_string(sender) + std::to_string(number);
        r.hear(flag, number, body, std::chrono::milliseconds{i * 20}, sender);
    }
    REQUIRE(r.whole.size() > 100);
    for (const auto& body : r.whole)
        for (std::size_t at = 3; at < body.size(); at += 3) {
            REQUIRE(body[at] == body[0]);
            REQUIRE(body[at + 1] >= body[at - 2]);
        }
}
