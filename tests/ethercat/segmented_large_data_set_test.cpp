// A JAUS message too large for one packet and for the slave's mailbox: assembled, translated, delivered in segments.
#include "ethercat/segmented_bench.hpp"
#include "support/instant.hpp"
#include <jauscat/bridge/delivery.hpp>
#include <jauscat/bridge/message_assembly.hpp>
#include <jauscat/schema/translation/seed_table.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>

using namespace jauscat;
using namespace std::chrono_literals;
using jaus::reassembled;
using support::instant;
using test::counting;
using test::segmented_bench;
using test::to_hex;

namespace {

using bytes = std::vector<std::byte>;
using packets = std::vector<bytes>;

constexpr jaus::header head{.command_code = 0x0405, // any will do: a body is carried, not understood
                            .destination = {.instance = 1, .component = 33, .node = 2, .subsystem = 1},
                            .source = {.instance = 1, .component = 38, .node = 1, .subsystem = 2}};

bytes message(jaus::header h, std::span<const std::byte> body) {
    bytes out(jaus::header_size + body.size());
    h.data_size = static_cast<std::uint16_t>(body.size());
    REQUIRE(wire::encode(h, out));
    std::ranges::copy(body, out.begin() + jaus::header_size);
    return out;
}

// `body` in packets of at most `share` bytes.
packets large_data_set(const bytes& body, std::size_t share) {
    packets all;
    for (std::size_t at = 0; at < body.size(); at += share) {
        auto h = head;
        h.sequence_number = static_cast<std::uint16_t>(all.size());
        const bool last = body.size() - at <= share;
        h.data_flag = at == 0 ? jaus::data_flag::first : last ? jaus::data_flag::last : jaus::data_flag::middle;
        all.push_back(message(h, std::span{body}.subspan(at, std::min(share, body.size() - at))));
    }
    return all;
}

// What an assembly makes of packets, and what became of the last of them.
template <class Table> struct assembled {
    bridging::message_assembly<translate::translator<Table>::max_body> assembly{5s};
    packets taken{};
    jauscat::time_point now{};

    reassembled give(const bytes& packet) {
        jaus::header h{};
        REQUIRE(wire::decode_prefix(h, packet));
        return assembly.on_message(h, packet, now, [&](auto whole) { taken.emplace_back(whole.begin(), whole.end()); });
    }
};

template <class Table> void delivers(std::size_t largest) {
    using delivery = bridging::delivery<Table>;
    assembled<Table> a;
    const auto body = counting(largest);
    auto parts = large_data_set(body, 500);
    parts[2][0] |= std::byte{0x10}; // the one that comes last asks for an acknowledgement
    REQUIRE(parts.size() == 4);
    for (const std::size_t i : {1u, 0u, 3u}) CHECK(a.give(parts[i]) == reassembled::waiting);
    CHECK(a.give(parts[2]) == reassembled::whole);
    REQUIRE(a.taken.size() == 1);
    auto whole_head = head;
    whole_head.sequence_number = 2;
    whole_head.ack_nak = jaus::ack_nak::request;
    const auto whole = message(whole_head, body);
    CHECK(a.taken[0] == whole);

    bytes packet(delivery::translator::max_packet_size);
    REQUIRE(delivery::translator::to_packet(whole, packet)->size() == packet.size());
    const auto object = delivery::object_of(packet);
    CHECK(object.data.size() == Table::max_data);
    for (const std::uint16_t mailbox : std::initializer_list<std::uint16_t>{24, 128, 1486}) {
        segmented_bench b{mailbox};
        b.objects.add(object.index, object.subindex, object.data.size());
        REQUIRE(b.download(object.index, object.subindex, bytes(object.data.begin(), object.data.end())));
        auto written = object;
        written.data = b.objects.entries.at({object.index, object.subindex}).value;
        bytes back(delivery::translator::max_message_size);
        REQUIRE(delivery::message_of(written, {.subsystem = 1, .station = 2, .instance = 1}, back)->size() ==
                whole.size());
        back.resize(whole.size());
        CHECK(back == whole);
    }

    // One byte more is refused, as a large data set and as a single packet.
    a.now += 1s; // what is equal and comes at once is a straggler
    const auto more = large_data_set(counting(largest + 1), 500);
    for (const std::size_t i : {0u, 1u, 2u}) CHECK(a.give(more[i]) == reassembled::waiting);
    CHECK(a.give(more[3]) == reassembled::too_large);
    CHECK(a.taken.size() == 1);
    CHECK(delivery::translator::to_packet(message(head, counting(largest + 1)), packet).error() ==
          translate::errc::too_large);
}

} // namespace

TEST_CASE("a large data set that fills an SDO packet reaches the slave, and one byte more is refused") {
    delivers<translation::seed_table>(1532);
    delivers<translation::self_contained_table>(1528);
}

TEST_CASE("a message in one packet passes the assembly unchanged") {
    assembled<translation::seed_table> a;
    const auto single = message(head, counting(20));
    CHECK(a.give(single) == reassembled::only);
    REQUIRE(a.taken.size() == 1);
    CHECK(to_hex(a.taken[0]) == to_hex(single));
    CHECK(a.give(message(head, counting(2000))) == reassembled::only); // whose size is for the translator to judge
}

TEST_CASE("four large data sets are assembled at a time, and a silent one is replaced by a fifth") {
    assembled<translation::seed_table> a;
    const auto part_from = [](std::uint8_t subsystem, std::uint16_t number = 0) {
        auto h = head;
        h.source.subsystem = subsystem;
        h.data_flag = number == 0 ? jaus::data_flag::first : jaus::data_flag::middle;
        h.sequence_number = number;
        return message(h, counting(10));
    };
    // Each goes on: one of which a single packet has come would give way.
    for (std::uint8_t subsystem = 1; subsystem <= 4; ++subsystem)
        for (const std::uint16_t number : {std::uint16_t{0}, std::uint16_t{1}})
            CHECK(a.give(part_from(subsystem, number)) == reassembled::waiting);
    CHECK(a.give(part_from(4)) == reassembled::repeated);
    CHECK(a.give(part_from(5)) == reassembled::no_capacity);
    a.now = instant{6s};
    CHECK(a.give(part_from(5)) == reassembled::waiting);
    CHECK(describe(reassembled::no_capacity) == "too many large data sets at a time: send it again later");
}
