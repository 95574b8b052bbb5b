// Duplicates are recognised, peers are learnt by the source of their packets.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/instant.hpp"
#include <jauscat/sae/transport/duplicate_filter.hpp>
#include <jauscat/sae/transport/peer_table.hpp>

#include <array>
#include <chrono>

namespace {

namespace sae = jauscat::sae;
using namespace std::chrono_literals;
using jauscat::test::hex_literal;
using sae::learnt;
using sae::seen;
using support::instant;

constexpr sae::jaus_id one{1, 1, 1}, two{1, 1, 2}, three{1, 1, 3};
constexpr auto payload = hex_literal<2>("0220");

seen packet(sae::duplicate_filter& filter, const sae::jaus_id& source, std::uint16_t number, instant now,
            bool wants_reply = false) {
    return filter.on_packet(
        {.acknowledgement = wants_reply ? sae::acknowledgement::request : sae::acknowledgement{}, .source = source},
        payload, number, now);
}

} // namespace

TEST_CASE("a packet is repeated if source, number and payload are those of one within the window") {
    std::array<sae::seen_packet, 8> places{};
    sae::duplicate_filter filter{places, 3s};
    CHECK(packet(filter, one, 5, 1s) == seen::fresh);
    CHECK(packet(filter, one, 5, 3s) == seen::repeated);
    CHECK(packet(filter, two, 5, 3s) == seen::fresh);
    CHECK(packet(filter, one, 6, 3s) == seen::fresh);
    CHECK(filter.on_packet({.source = one}, hex_literal<2>("0240"), 5, instant{3s}) == seen::fresh);
    CHECK(packet(filter, one, 5, 4s) == seen::fresh);
}

TEST_CASE("a packet that is forgotten is fresh again") {
    std::array<sae::seen_packet, 8> places{};
    sae::duplicate_filter filter{places, 3s};
    CHECK(packet(filter, one, 5, 1s) == seen::fresh);
    filter.forget({.source = one}, payload, 5);
    CHECK(packet(filter, one, 5, 1s) == seen::fresh);
}

TEST_CASE("acknowledged packets keep their place, others make room") {
    std::array<sae::seen_packet, 8> places{};
    sae::duplicate_filter filter{places, 3s};
    for (std::uint16_t n = 0; n != 6; ++n) CHECK(packet(filter, one, n, 1s, true) == seen::fresh);
    CHECK(packet(filter, one, 6, 1s, true) == seen::no_capacity);
    CHECK(packet(filter, two, 0, 1s) == seen::fresh);
    CHECK(packet(filter, two, 1, 1100ms) == seen::fresh);
    CHECK(packet(filter, two, 2, 1200ms) == seen::fresh); // in place of the oldest
    CHECK(packet(filter, two, 2, 1200ms) == seen::repeated);
    CHECK(packet(filter, three, 0, 1300ms, true) == seen::fresh);
    CHECK(packet(filter, three, 1, 1300ms, true) == seen::fresh);
    CHECK(packet(filter, three, 2, 1300ms, true) == seen::no_capacity);
    for (std::uint16_t n = 0; n != 6; ++n) CHECK(packet(filter, one, n, 1400ms, true) == seen::repeated);
    CHECK(packet(filter, three, 2, 4s, true) == seen::fresh);
    CHECK(packet(filter, one, 0, 4s, true) == seen::fresh);
}

TEST_CASE("without memory only packets without acknowledgement are taken") {
    sae::duplicate_filter filter{{}};
    CHECK(packet(filter, one, 0, 0s) == seen::fresh);
    CHECK(packet(filter, one, 0, 0s, true) == seen::no_capacity);
}

TEST_CASE("the endpoint of a component is that of its last packet") {
    std::array<sae::known_peer, 4> places{};
    sae::peer_table peers{places, 60s};
    CHECK(peers.find(one) == nullptr);
    CHECK(peers.on_packet(one, {7}, instant{1s}) == learnt::added);
    CHECK(peers.on_packet(one, {7}, instant{2s}) == learnt::known);
    REQUIRE(peers.find(one) != nullptr);
    CHECK(peers.find(one)->endpoint.value == 7);
    CHECK(peers.on_packet(one, {8}, instant{3s}) == learnt::moved);
    CHECK(peers.find(one)->endpoint.value == 8);
    peers.forget({8});
    CHECK(peers.find(one) == nullptr);
}

TEST_CASE("a configured component never moves and is not forgotten") {
    std::array<sae::known_peer, 2> places{};
    sae::peer_table peers{places, 1s};
    CHECK(peers.fix(one, {7}));
    CHECK(peers.on_packet(one, {8}, instant{1s}) == learnt::wrong_endpoint);
    CHECK(peers.on_packet(one, {7}, instant{1s}) == learnt::known);
    peers.forget({7});
    REQUIRE(peers.find(one) != nullptr);
    CHECK(peers.fix(one, {9}));
    CHECK(peers.find(one)->endpoint.value == 9);
    CHECK(peers.on_packet(two, {8}, instant{1s}) == learnt::added);
    CHECK_FALSE(peers.fix(three, {9}));
    CHECK(peers.on_packet(three, {8}, instant{1s}) == learnt::no_capacity);
    CHECK(peers.on_packet(three, {8}, instant{2s}) == learnt::added); // two is silent
    CHECK(peers.find(two) == nullptr);
}

TEST_CASE("one endpoint leaves a quarter of the places to others") {
    std::array<sae::known_peer, 8> places{};
    sae::peer_table peers{places, 60s};
    for (std::uint16_t n = 1; n != 7; ++n) CHECK(peers.on_packet({1, 1, n}, {7}, instant{1s}) == learnt::added);
    CHECK(peers.on_packet({1, 1, 7}, {7}, instant{1s}) == learnt::no_capacity);
    CHECK(peers.on_packet({1, 1, 7}, {8}, instant{1s}) == learnt::added);
}
