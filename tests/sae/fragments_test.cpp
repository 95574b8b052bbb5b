// Messages of several packets: cut and put together.
#include "support/bytes.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/instant.hpp"
#include <jauscat/sae/transport/fragments.hpp>

#include <algorithm>
#include <chrono>
#include <random>
#include <vector>

namespace {

namespace sae = jauscat::sae;
using namespace std::chrono_literals;
using sae::fragment_flag;
using sae::fragment_outcome;
using support::instant;
using bytes = std::vector<std::byte>;

constexpr sae::jaus_id sender{1, 1, 2}, other_sender{2, 1, 3}, receiver{1, 1, 1};

bytes payload_of(std::size_t size) {
    bytes all(size);
    for (std::size_t i = 0; i != size; ++i) all[i] = static_cast<std::byte>(i * 7 + i / 256);
    return all;
}

struct memory {
    std::vector<sae::held_fragment> places;
    bytes parts;
    bytes whole;
    sae::fragment_reassembler reassembler;

    explicit memory(std::size_t count = 16, std::size_t part = 100, std::size_t most = 1000)
        : places(count), parts(count * part), whole(most), reassembler{places, parts, whole, 1s} {}

    auto receive(const sae::cut_payload& cut, std::size_t packet, std::uint16_t first_number, instant now = 0s,
                 sae::jaus_id source = sender) {
        return reassembler.on_packet({.fragment_flag = cut.flag(packet), .destination = receiver, .source = source},
                                     cut.part(packet), static_cast<std::uint16_t>(first_number + packet), now);
    }
};

} // namespace

TEST_CASE("9986 bytes are cut as a known peer cuts them") {
    const auto all = payload_of(9986);
    const sae::cut_payload cut{all, sae::usual_payload_size};
    REQUIRE(cut.packets() == 3);
    CHECK(cut.part(0).size() == 4079);
    CHECK(cut.part(1).size() == 4079);
    CHECK(cut.part(2).size() == 1828);
    CHECK(cut.flag(0) == fragment_flag::first);
    CHECK(cut.flag(1) == fragment_flag::middle);
    CHECK(cut.flag(2) == fragment_flag::last);
    CHECK(sae::cut_payload{std::span{all}.first(4079), 4079}.flag(0) == fragment_flag::single);
    CHECK(sae::cut_payload{{}, 4079}.packets() == 1);
}

TEST_CASE("parts of a message in any order give its payload once") {
    const auto all = payload_of(450);
    const sae::cut_payload cut{all, 100};
    std::vector<std::size_t> order{0, 1, 2, 3, 4};
    do {
        memory m;
        for (std::size_t i = 0; i != order.size(); ++i) {
            const auto got = m.receive(cut, order[i], 65534); // the numbers go once around
            CHECK(got.outcome == (i == 4 ? fragment_outcome::whole : fragment_outcome::waiting));
            if (i != 4) {
                CHECK(m.receive(cut, order[i], 65534).outcome == fragment_outcome::repeated);
                continue;
            }
            CHECK(support::equal(got.payload, all));
            CHECK(got.first_number == 65534);
        }
        CHECK(m.reassembler.held() == 0);
    } while (std::ranges::next_permutation(order).found);
}

TEST_CASE("messages of one source and of several at a time are kept apart, in any order") {
    std::mt19937 random{1};
    const auto one = payload_of(250), two = payload_of(330), three = payload_of(290);
    struct packet {
        const bytes* payload;
        std::size_t number;
        std::uint16_t first;
        sae::jaus_id source;
    };
    std::vector<packet> packets;
    for (std::size_t i = 0; i != 3; ++i) packets.push_back({&one, i, 10, sender});
    for (std::size_t i = 0; i != 4; ++i) packets.push_back({&two, i, 13, sender});
    for (std::size_t i = 0; i != 3; ++i) packets.push_back({&three, i, 10, other_sender});
    for (int round = 0; round != 200; ++round) {
        std::ranges::shuffle(packets, random);
        memory m;
        int whole = 0;
        for (const auto& p : packets) {
            const auto got = m.receive(sae::cut_payload{*p.payload, 100}, p.number, p.first, 0s, p.source);
            if (got.outcome != fragment_outcome::whole) continue;
            ++whole;
            CHECK(support::equal(got.payload, *p.payload));
        }
        CHECK(whole == 3);
        CHECK(m.reassembler.held() == 0);
    }
}

TEST_CASE("a message that is larger than the memory is dropped as soon as that is known") {
    const auto all = payload_of(350);
    const sae::cut_payload cut{all, 100};
    memory m{16, 100, 300};
    CHECK(m.receive(cut, 0, 1).outcome == fragment_outcome::waiting);
    CHECK(m.receive(cut, 1, 1).outcome == fragment_outcome::waiting);
    CHECK(m.receive(cut, 2, 1).outcome == fragment_outcome::waiting);
    CHECK(m.receive(cut, 3, 1).outcome == fragment_outcome::too_large);
    CHECK(m.reassembler.held() == 0);
    CHECK(m.receive(sae::cut_payload{all, 101}, 0, 1).outcome == fragment_outcome::too_large);
    CHECK(m.reassembler.held() == 0);
}

TEST_CASE("the parts of one node leave a quarter of the places to others, until they are too old") {
    const auto all = payload_of(900);
    const sae::cut_payload cut{all, 50};
    memory m{8, 50, 1000};
    for (std::size_t i = 0; i != 6; ++i) CHECK(m.receive(cut, i, 1).outcome == fragment_outcome::waiting);
    CHECK(m.receive(cut, 6, 1).outcome == fragment_outcome::no_capacity);
    CHECK(m.receive(cut, 0, 1, 0s, other_sender).outcome == fragment_outcome::waiting);
    CHECK(m.receive(cut, 1, 1, 0s, other_sender).outcome == fragment_outcome::waiting);
    CHECK(m.receive(cut, 2, 1, 0s, other_sender).outcome == fragment_outcome::no_capacity);
    CHECK(m.receive(cut, 6, 1, 1s).outcome == fragment_outcome::waiting);
    CHECK(m.reassembler.held() == 1);
}

TEST_CASE("a source that restarts with the same numbers replaces its parts") {
    const auto old = payload_of(200);
    auto fresh = old;
    fresh[0] ^= std::byte{1};
    fresh[150] ^= std::byte{1};
    memory m;
    CHECK(m.receive(sae::cut_payload{old, 100}, 0, 1).outcome == fragment_outcome::waiting);
    CHECK(m.receive(sae::cut_payload{fresh, 100}, 0, 1).outcome == fragment_outcome::waiting);
    const auto got = m.receive(sae::cut_payload{fresh, 100}, 1, 1);
    CHECK(got.outcome == fragment_outcome::whole);
    CHECK(support::equal(got.payload, fresh));
}

TEST_CASE("without memory no part is kept") {
    sae::fragment_reassembler none{{}, {}, {}};
    CHECK(none.on_packet({.fragment_flag = fragment_flag::first}, {}, 0, instant{0s}).outcome ==
          fragment_outcome::no_capacity);
    for (int outcome = 0; outcome <= static_cast<int>(fragment_outcome::too_large); ++outcome)
        CHECK(describe(static_cast<fragment_outcome>(outcome)) != "unknown");
}
