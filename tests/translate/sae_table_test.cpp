// The table of SAE JAUS: a packet that is written out, ranks, and every golden message to a slave and back.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/paths.hpp"
#include "support/random_message.hpp"
#include <jauscat/bridge/sae_delivery.hpp>
#include <jauscat/schema/translation/sae_table.hpp>
#include <jauscat/translate/diagnose.hpp>
#include <jauscat/translate/translator.hpp>

#include <fstream>
#include <set>
#include <string>
#include <vector>

using namespace jauscat;
using test::from_hex;
using test::to_hex;
using translate::errc;

namespace {

using bytes = std::vector<std::byte>;
using table = translation::sae_table;
using translator = translate::translator<table>;
using delivery = bridging::sae_delivery<table>;

struct outcome {
    errc error{};
    bytes made{};
};
template <class Translator = translator> outcome to_packet(const bytes& message) {
    bytes out(Translator::max_packet_size);
    const auto made = Translator::to_packet(message, out);
    out.resize(made->size());
    return {made.error(), out};
}
template <class Translator = translator> outcome from_packet(const bytes& packet) {
    bytes out(Translator::max_message_size);
    const auto made = Translator::from_packet(packet, out);
    out.resize(made->size());
    return {made.error(), out};
}

/// SetAuthority 35 to 258.2.33 from 65534.4.3, high priority, number 22h.
const bytes message = from_hex("00 1100 06 21 02 0201 03 04 feff 0100 23 2200");
const bytes packet = from_hex("20000000 00000000 00000000 00000000 1a000000 00000000 00000000 08006500"
                              "00000000 00000000 02000000 21200000 01000000 0a000000"
                              "06 0201 0304feff 23 2200");

bytes changed(bytes from, std::size_t at, unsigned value) {
    from[at] = static_cast<std::byte>(value);
    return from;
}

void put16(bytes& out, unsigned value) {
    out.push_back(static_cast<std::byte>(value & 0xFF));
    out.push_back(static_cast<std::byte>(value >> 8));
}
void append(bytes& out, const bytes& in, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i != to; ++i) out.push_back(in[i]);
}

/// The packet by plain loops and byte offsets; the IDs from the lists.
bytes plain_packet(const bytes& in) {
    const auto id = std::to_integer<unsigned>(in[12]) | std::to_integer<unsigned>(in[13]) << 8;
    const std::vector<std::span<const std::uint16_t>> lists{translation::sae_core_ids, translation::sae_mobility_ids,
                                                            translation::sae_environment_sensing_ids,
                                                            translation::sae_manipulator_ids, translation::sae_ugv_ids};
    unsigned segment = 0, rank = 0;
    for (unsigned s = 0; s != lists.size(); ++s)
        for (unsigned r = 0; r != lists[s].size(); ++r)
            if (lists[s][r] == id) segment = s, rank = r + 1;
    bytes data;
    append(data, in, 3, 4);
    append(data, in, 6, 12);
    append(data, in, 14, in.size());
    const auto n = static_cast<unsigned>(data.size());
    bytes made;
    const auto put = [&](unsigned value) { put16(made, value & 0xFFFF), put16(made, value >> 16); };
    for (const unsigned word : {0x20u, 0u, 0u, 0u, 16 + n, 0u, 0u, 0x650008u, 0u, 0u}) put(word);
    put(std::to_integer<unsigned>(in[5]));
    put(0x2000 + 256 * segment + std::to_integer<unsigned>(in[4]));
    put(rank);
    put(n);
    append(made, data, 0, data.size());
    return made;
}

/// The payloads of all golden messages.
std::vector<bytes> golden() {
    std::vector<bytes> all;
    std::ifstream file{support::test_data("sae_vectors.jsonl")};
    const std::string before = "\"hex\":\"";
    for (std::string line; std::getline(file, line);) {
        const auto at = line.find(before) + before.size();
        all.push_back(from_hex(line.substr(at, line.find('"', at) - at)));
    }
    return all;
}
/// With any header of a whole message.
bytes with_random_head(support::generator& g, const bytes& payload) {
    auto head = support::random_message<sae::transport_header>(g);
    head.message_type = 0;
    head.compression = sae::compression::none;
    head.fragment_flag = sae::fragment_flag::single;
    head.size = static_cast<std::uint16_t>(14 + payload.size());
    bytes made(12);
    REQUIRE(wire::encode(head, made));
    append(made, payload, 0, payload.size());
    put16(made, static_cast<unsigned>(support::below(g, 0x10000)));
    return made;
}
void comes_back(const bytes& sent) {
    const auto there = to_packet(sent);
    REQUIRE(there.error == errc::ok);
    REQUIRE(to_hex(there.made) == to_hex(plain_packet(sent)));
    REQUIRE(to_hex(from_packet(there.made).made) == to_hex(sent));
    // What crosses the wire is enough.
    bytes out(translator::max_message_size);
    const auto received = delivery::message_of(delivery::object_of(there.made), out);
    REQUIRE(received);
    REQUIRE(to_hex(*received) == to_hex(sent));
}

} // namespace

TEST_CASE("an SAE message becomes the expected packet, and comes back") {
    CHECK(to_hex(to_packet(message).made) == to_hex(packet));
    CHECK(to_hex(from_packet(packet).made) == to_hex(message));
    STATIC_REQUIRE(table::overhead == 7);
    STATIC_REQUIRE(translator::header_size == 14);
}

TEST_CASE("each set of SAE messages has a segment, and a message its rank in it") {
    using segments = translation::sae_segments_and<0xD123, 0xF900>;
    const auto at = [](std::uint16_t id) {
        const auto found = segments::find(id);
        return std::pair<int, int>{found.segment, found.rank};
    };
    CHECK(at(0x0001) == std::pair{0, 1});  // SetAuthority
    CHECK(at(0x4B04) == std::pair{0, 54}); // ReportServiceList
    CHECK(at(0x0402) == std::pair{1, 1});
    CHECK(at(0xD123) == std::pair{15, 1});
    CHECK(at(0xF900) == std::pair{15, 2});
    CHECK(at(0x0000) == std::pair{0, 0});
    CHECK(at(0xFFFF) == std::pair{0, 0});
    STATIC_REQUIRE(segments::codes.size() == 278);
    for (const auto id : segments::codes) {
        const auto found = segments::find(id);
        std::uint16_t again{};
        REQUIRE(segments::find(found.segment, found.rank, again));
        REQUIRE(again == id);
    }
    std::uint16_t none{};
    CHECK_FALSE(segments::find(0, 0, none));
    CHECK_FALSE(segments::find(0, 55, none));
    CHECK_FALSE(segments::find(5, 1, none));
    CHECK_FALSE(segments::find(15, 3, none));
    CHECK_FALSE(segments::find(16, 1, none));
}

TEST_CASE("every golden SAE message with any header becomes the packet of plain loops, and comes back") {
    support::generator g{1444};
    const auto all = golden();
    REQUIRE(all.size() == 1444);
    std::set<unsigned> ids;
    for (const auto& payload : all) {
        INFO(to_hex(payload));
        if (payload.size() > translator::max_body) {
            CHECK(to_packet(with_random_head(g, payload)).error == errc::too_large);
            continue;
        }
        ids.insert(std::to_integer<unsigned>(payload[0]) | std::to_integer<unsigned>(payload[1]) << 8);
        for (int round = 0; round != 5; ++round) comes_back(with_random_head(g, payload));
    }
    CHECK(ids.size() == 276);
}

TEST_CASE("any bytes behind the ID of an SAE message come back, up to the largest body") {
    support::generator g{276};
    for (const std::uint16_t id : translation::sae_segments::codes)
        for (const std::size_t size :
             {std::size_t{0}, std::size_t{1}, support::below(g, 1500), translator::max_body - 2}) {
            bytes payload;
            put16(payload, id);
            for (std::size_t i = 0; i != size; ++i) payload.push_back(static_cast<std::byte>(support::below(g, 256)));
            comes_back(with_random_head(g, payload));
            if (size == translator::max_body - 2) {
                payload.push_back({});
                REQUIRE(to_packet(with_random_head(g, payload)).error == errc::too_large);
            }
        }
}

TEST_CASE("an SAE message that is no whole message of the table is refused") {
    CHECK(to_packet(bytes(message.begin(), message.end() - 2)).error == errc::wrong_size);
    CHECK(to_packet(changed(message, 0, 1)).error == errc::reserved_value);    // message type
    CHECK(to_packet(changed(message, 0, 0x40)).error == errc::reserved_value); // header compression
    CHECK(to_packet(changed(message, 1, 0x12)).error == errc::wrong_size);
    for (const unsigned flag : {0x40u, 0x80u, 0xC0u})
        CHECK(to_packet(changed(message, 3, flag)).error == errc::fragment_to_slave);
    CHECK(to_packet(changed(message, 12, 0)).error == errc::unknown_command_code);
    for (std::size_t size = 0; size != 14; ++size)
        CHECK(to_packet(bytes(message.begin(), message.begin() + static_cast<std::ptrdiff_t>(size))).error ==
              errc::truncated);
    // An acknowledgement: what seems to be its ID is its sequence number.
    CHECK(to_packet(from_hex("00 0e00 31 21020201 0304feff 0100")).error == errc::truncated);
}

TEST_CASE("a packet that is none of the SAE table is refused") {
    CHECK(from_packet(changed(packet, 40, 0)).error == errc::ok);
    CHECK(from_packet(changed(packet, 41, 1)).error == errc::out_of_range); // node 258
    CHECK(from_packet(changed(packet, 45, 0x1F)).error == errc::unknown_index);
    CHECK(from_packet(changed(packet, 45, 0x30)).error == errc::unknown_index);
    CHECK(from_packet(changed(packet, 45, 0x25)).error == errc::unknown_subindex); // a segment without messages
    CHECK(from_packet(changed(packet, 48, 0)).error == errc::unknown_subindex);
    CHECK(from_packet(changed(packet, 48, 55)).error == errc::unknown_subindex);
    CHECK(from_packet(changed(packet, 0, 0x21)).error == errc::wrong_packet);
    CHECK(from_packet(changed(packet, 56, 0x46)).error == errc::fragment_to_slave); // in the rest
    CHECK(from_packet(changed(packet, 52, 8)).error == errc::truncated);            // no sequence number
    CHECK(from_packet(changed(packet, 52, 6)).error == errc::truncated);
    CHECK(from_packet(changed(packet, 52, 11)).error == errc::truncated);
}

TEST_CASE("a refused SAE message is explained by row and field") {
    const auto fragment = translate::diagnose_to_packet<table>(errc::fragment_to_slave, changed(message, 3, 0x40));
    CHECK(fragment.field == "fragment_flag");
    CHECK(fragment.value == 1);
    const auto unknown = translate::diagnose_to_packet<table>(errc::unknown_command_code, changed(message, 13, 0x77));
    CHECK(unknown.field == "message_id");
    CHECK(unknown.value == 0x7701);
}

TEST_CASE("fragments and broadcasts that name no slave are not delivered") {
    sae::transport_header head{.destination = {.component = 33, .node = 2, .subsystem = 258}};
    CHECK(delivery::deliverable(head) == errc::ok);
    head.fragment_flag = sae::fragment_flag::last;
    CHECK(delivery::deliverable(head) == errc::fragment_to_slave);
    head.fragment_flag = sae::fragment_flag::single;
    for (const std::uint8_t node : {std::uint8_t{0}, std::uint8_t{255}}) {
        head.destination.node = node;
        CHECK(delivery::deliverable(head) == errc::broadcast_names_no_slave);
    }
}
