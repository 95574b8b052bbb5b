// The map from addresses to values against a search through all entries, which is what it replaces.
#include "support/catch.hpp"
#include <jauscat/jaus/routing/address_map.hpp>

#include <random>
#include <vector>

namespace {

namespace jaus = jauscat::jaus;
using jaus::inserted;

constexpr jaus::address make(std::uint8_t subsystem, std::uint8_t node, std::uint8_t component, std::uint8_t instance) {
    return {.instance = instance, .component = component, .node = node, .subsystem = subsystem};
}

struct entry {
    jaus::address address{};
    int value{};
};

// The rule as the configuration's manual has it: of all that cover the address, who names the higher level.
const entry* search(const std::vector<entry>& entries, const jaus::address& wanted) {
    const entry* best = nullptr;
    int best_rank = -1;
    for (const auto& e : entries) {
        int rank = 0;
        bool covers = true;
        for (const auto level :
             {&jaus::address::subsystem, &jaus::address::node, &jaus::address::component, &jaus::address::instance}) {
            const auto id = e.address.*level;
            rank = 2 * rank + (id != 0 ? 1 : 0);
            covers = covers && (id == 0 || id == wanted.*level);
        }
        if (covers && rank > best_rank) {
            best = &e;
            best_rank = rank;
        }
    }
    return best;
}

struct small_map {
    explicit small_map(std::size_t count) : places(count) {}
    std::vector<jaus::address_place<int>> places;
    jaus::address_map<int> map{places};
};

} // namespace

TEST_CASE("an entry for a higher level is found") {
    small_map m{16};
    REQUIRE(m.map.insert(make(0, 0, 0, 0), 1) == inserted::ok);
    REQUIRE(m.map.insert(make(1, 0, 0, 0), 2) == inserted::ok);
    REQUIRE(m.map.insert(make(1, 0, 33, 0), 3) == inserted::ok);
    REQUIRE(m.map.insert(make(1, 2, 0, 0), 4) == inserted::ok);
    REQUIRE(m.map.find(make(1, 2, 33, 1))->value == 4);
    REQUIRE(m.map.find(make(1, 3, 33, 1))->value == 3);
    REQUIRE(m.map.find(make(1, 3, 34, 1))->value == 2);
    REQUIRE(m.map.find(make(2, 2, 33, 1))->value == 1);
    REQUIRE(m.map.exactly(make(1, 2, 33, 1)) == nullptr);
    REQUIRE(m.map.exactly(make(1, 2, 0, 0))->value == 4);
}

TEST_CASE("an empty map finds nothing, and a map without memory is full") {
    for (const std::size_t places : {0U, 1U}) {
        small_map m{places};
        REQUIRE(m.map.capacity() == 0);
        REQUIRE(m.map.find(make(1, 1, 1, 1)) == nullptr);
        REQUIRE(m.map.insert(make(1, 1, 1, 1), 1) == inserted::full);
        REQUIRE_FALSE(m.map.erase(make(1, 1, 1, 1)));
    }
    REQUIRE(small_map{8}.map.longest_probe() == 0);
}

TEST_CASE("a map has none of the entries that its memory had before") {
    small_map m{8};
    REQUIRE(m.map.insert(make(1, 2, 0, 0), 1) == inserted::ok);
    jaus::address_map<int> next{m.places};
    REQUIRE(next.insert(make(1, 3, 0, 0), 2) == inserted::ok);
    REQUIRE(next.find(make(1, 2, 33, 1)) == nullptr);
    REQUIRE(next.find(make(1, 3, 33, 1))->value == 2);
}

TEST_CASE("a duplicate address is refused and keeps the first value") {
    small_map m{8};
    REQUIRE(m.map.insert(make(1, 0, 0, 0), 1) == inserted::ok);
    REQUIRE(m.map.insert(make(1, 0, 0, 0), 2) == inserted::duplicate);
    REQUIRE(m.map.find(make(1, 9, 9, 9))->value == 1);
    REQUIRE(m.map.size() == 1);
}

TEST_CASE("a map is full at three quarters of the largest power of two") {
    for (const std::size_t places : {2U, 3U, 4U, 100U, 1024U}) {
        small_map m{places};
        std::size_t taken = 0;
        for (unsigned i = 0; i != 2000; ++i) {
            const auto result = m.map.insert(
                make(static_cast<std::uint8_t>(1 + i / 200), static_cast<std::uint8_t>(1 + i % 200), 0, 0), 0);
            if (result != inserted::ok) {
                REQUIRE(result == inserted::full);
                break;
            }
            ++taken;
        }
        REQUIRE(taken == m.map.capacity());
        REQUIRE(taken >= std::bit_floor(places) / 2);
        REQUIRE(taken < places);
    }
}

TEST_CASE("random entries and look-ups agree with a linear search, also after removals") {
    std::mt19937 random{7};
    // Few IDs, so that entries of many patterns cover the same address.
    const auto id = [&](bool wildcard) { return static_cast<std::uint8_t>(random() % 4 + (wildcard ? 0 : 1)); };
    for (int round = 0; round != 200; ++round) {
        small_map m{256};
        std::vector<entry> entries;
        for (int i = 0; i != 150; ++i) {
            const auto address = make(id(true), id(true), id(true), id(true));
            const auto known = std::ranges::find(entries, address, &entry::address);
            if (random() % 3 == 0) {
                REQUIRE(m.map.erase(address) == (known != entries.end()));
                if (known != entries.end()) entries.erase(known);
                continue;
            }
            REQUIRE(m.map.insert(address, i) == (known == entries.end() ? inserted::ok : inserted::duplicate));
            if (known == entries.end()) entries.push_back({address, i});
        }
        REQUIRE(m.map.size() == entries.size());
        for (int i = 0; i != 100; ++i) {
            const auto wanted = make(id(false), id(false), id(false), id(false));
            const auto* expected = search(entries, wanted);
            const auto* found = m.map.find(wanted);
            REQUIRE((found == nullptr) == (expected == nullptr));
            if (found != nullptr) REQUIRE(found->value == expected->value);
        }
        m.map.clear();
        REQUIRE(m.map.size() == 0);
        REQUIRE(m.map.find(make(1, 1, 1, 1)) == nullptr);
    }
}

TEST_CASE("250 subsystems of 254 nodes are all found, each within a few probes") {
    small_map m{131072};
    int value = 0;
    for (unsigned s = 1; s <= 250; ++s)
        for (unsigned n = 1; n <= 254; ++n)
            REQUIRE(m.map.insert(make(static_cast<std::uint8_t>(s), static_cast<std::uint8_t>(n), 0, 0), value++) ==
                    inserted::ok);
    value = 0;
    for (unsigned s = 1; s <= 250; ++s)
        for (unsigned n = 1; n <= 254; ++n)
            REQUIRE(m.map.find(make(static_cast<std::uint8_t>(s), static_cast<std::uint8_t>(n), 33, 1))->value ==
                    value++);
    REQUIRE(m.map.find(make(251, 1, 33, 1)) == nullptr);
    REQUIRE(m.map.longest_probe() <= 16);
}
