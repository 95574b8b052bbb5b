// The tables with other index bases: the same but for the index.
#include "samples.hpp"
#include "support/catch.hpp"

using namespace jauscat;
using namespace jauscat::test;
using translate::errc;

namespace {

using seed_at_2000h = translate::translator<translation::seed_table_at_2000h>;
using seed_at_6900h = translate::translator<translation::seed_table_at_6900h>;
using self_contained_at_2000h = translate::translator<translation::self_contained_table_at_2000h>;
using self_contained_at_6900h = translate::translator<translation::self_contained_table_at_6900h>;

std::vector<std::byte> to_component(unsigned component) {
    auto message = vector_of(wrench_effort);
    message[5] = static_cast<std::byte>(component);
    return message;
}

/// Whether a table differs from the one with the seed's base in the index alone, which is `first` and the component.
template <class Translator, class AtSeedsBase> bool differs_by_index_alone(std::uint32_t first) {
    for (unsigned component = 0; component != 256; ++component) {
        const auto message = to_component(component);
        auto expected = to_packet<AtSeedsBase>(message).bytes;
        set(expected, word::ul_index, first + component);
        const auto there = to_packet<Translator>(message);
        if (there.error != errc::ok || there.bytes != expected) return false;
        if (from_packet<Translator>(there.bytes).bytes != message) return false;
    }
    return true;
}

/// Whether the first and the last index, and no others, come back.
template <class Translator> bool takes_exactly(std::uint32_t first) {
    const auto packet = to_packet<Translator>(wrench_effort).bytes;
    const auto error = [&](std::uint32_t index) {
        return from_packet<Translator>(with(packet, word::ul_index, index)).error;
    };
    return error(first) == errc::ok && error(first + 255) == errc::ok && error(first - 1) == errc::unknown_index &&
           error(first + 256) == errc::unknown_index;
}

} // namespace

TEST_CASE("component 33 has index 8225 with base 2000h, and 26913 with base 6900h") {
    CHECK(get(to_packet<seed_at_2000h>(wrench_effort).bytes, word::ul_index) == 8225);
    CHECK(get(to_packet<self_contained_at_2000h>(wrench_effort).bytes, word::ul_index) == 8225);
    CHECK(get(to_packet<seed_at_6900h>(wrench_effort).bytes, word::ul_index) == 26913);
    CHECK(get(to_packet<self_contained_at_6900h>(wrench_effort).bytes, word::ul_index) == 26913);
}

TEST_CASE("Set Wrench Effort under the self-contained table at 2000h equals the expected bytes") {
    CHECK(to_hex(to_packet<self_contained_at_2000h>(wrench_effort).bytes) ==
          hex_of("20000000 00000000 00000000 00000000 30000000 00000000 00000000 08006500 00000000 00000000"
                 " 02000000 21200000 1a000000 20000000 0602 05 01 02200304 1400 2200"
                 " ff0f ff7f 0180 0000 0040 01c0 0020 00ff80 336699"));
}

TEST_CASE("another base changes only the index, for every component and both ways") {
    CHECK(differs_by_index_alone<seed_at_2000h, seed>(0x2000));
    CHECK(differs_by_index_alone<seed_at_6900h, seed>(0x6900));
    CHECK(differs_by_index_alone<self_contained_at_2000h, self_contained>(0x2000));
    CHECK(differs_by_index_alone<self_contained_at_6900h, self_contained>(0x6900));
}

TEST_CASE("a table accepts the 256 indices from its base on and no others") {
    CHECK(takes_exactly<seed>(6900));
    CHECK(takes_exactly<seed_at_2000h>(0x2000));
    CHECK(takes_exactly<seed_at_6900h>(0x6900));
    CHECK(takes_exactly<self_contained>(6900));
    CHECK(takes_exactly<self_contained_at_2000h>(0x2000));
    CHECK(takes_exactly<self_contained_at_6900h>(0x6900));
}

TEST_CASE("the seed's indices are in the TxPDO mapping area, those of the other bases in free areas") {
    using namespace translation;
    STATIC_REQUIRE(seed_index_base >= 0x1A00);
    STATIC_REQUIRE(seed_index_base + 255 <= 0x1BFF);
    STATIC_REQUIRE(manufacturer_index_base >= 0x2000);
    STATIC_REQUIRE(manufacturer_index_base + 255 <= 0x5FFF);
    STATIC_REQUIRE(profile_index_base >= 0x6000);
    STATIC_REQUIRE(profile_index_base + 255 <= 0x9FFF);
}
