// Ranks, indices and flags, each against the number that the standard or the plan gives; and the lookup behind ranks.
#include "plain_translator.hpp"
#include "samples.hpp"
#include "support/catch.hpp"

#include <numeric>

using namespace jauscat;
using namespace jauscat::test;

namespace {

std::uint32_t rank_of(std::uint16_t code) {
    auto message = message_with_body(0);
    message[2] = static_cast<std::byte>(code);
    message[3] = static_cast<std::byte>(code >> 8);
    const auto there = to_packet<seed>(message);
    return there.bytes.empty() ? 0 : get(there.bytes, word::ul_sub_index);
}

constexpr std::array<std::uint16_t, 0> no_codes{};
constexpr std::array<std::uint16_t, 1> one_code{0x0405};
constexpr std::array<std::uint16_t, 5> unsorted_codes{0xFFFF, 0x0000, 0x4405, 0x0405, 0x00FF};
template <std::size_t Size> consteval auto spread_codes(std::size_t step) {
    std::array<std::uint16_t, Size> codes{};
    for (std::size_t i = 0; i != Size; ++i) codes[i] = static_cast<std::uint16_t>(i * step);
    return codes;
}
constexpr auto every_high_byte_but_one = spread_codes<255>(0x101);
constexpr auto whole_pages = spread_codes<512>(1);
constexpr auto more_than_a_byte_counts = spread_codes<300>(7);

template <const auto& Codes> std::size_t count_wrong_places() {
    std::array<std::size_t, 0x10000> expected{};
    expected.fill(wire::code_index<Codes>::npos);
    for (std::size_t i = 0; i != Codes.size(); ++i) expected[Codes[i]] = i;
    std::size_t wrong = 0;
    for (std::uint32_t code = 0; code != 0x10000; ++code)
        wrong += wire::code_index<Codes>::find(static_cast<std::uint16_t>(code)) != expected[code];
    return wrong;
}
template <const auto& Codes> std::size_t count_wrong_values() {
    constexpr std::uint32_t none = 0x10000;
    static constexpr auto values = [] {
        std::array<std::uint32_t, Codes.size()> made{};
        std::ranges::copy(Codes, made.begin());
        return made;
    }();
    static constexpr auto by_slot = wire::code_index<Codes>::by_slot(values, none);
    std::size_t wrong = 0;
    for (std::uint32_t code = 0; code != 0x10000; ++code) {
        const auto expected = std::ranges::find(Codes, code) != Codes.end() ? code : none;
        wrong += by_slot[wire::code_index<Codes>::slot(static_cast<std::uint16_t>(code))] != expected;
    }
    return wrong;
}

} // namespace

TEST_CASE("ranks are frozen: the first is 1, wrench efforts are 26, 72 and 121, the experimental message is 158") {
    CHECK(rank_of(0x0001) == 1);
    CHECK(rank_of(0x0405) == 26);
    CHECK(rank_of(0x2405) == 72);
    CHECK(rank_of(0x4405) == 121);
    CHECK(rank_of(0x4E01) == 157);
    CHECK(rank_of(0x0404) == 158);
}

TEST_CASE("the rank of every command code of RA 3.3 is its position in the standard") {
    for (std::size_t i = 0; i != plain_codes.size(); ++i) {
        CAPTURE(plain_codes[i]);
        CHECK(rank_of(plain_codes[i]) == i + 1);
    }
}

TEST_CASE("every component has the index 6900 plus its ID, and is restored from it") {
    for (std::uint32_t component = 0; component != 256; ++component) {
        CAPTURE(component);
        auto message = vector_of(wrench_effort);
        message[5] = static_cast<std::byte>(component);
        const auto there = to_packet<seed>(message);
        REQUIRE(there.error == translate::errc::ok);
        CHECK(get(there.bytes, word::ul_index) == 6900 + component);
        CHECK(from_packet<seed>(there.bytes).bytes == message);
    }
}

TEST_CASE("every data flag has its sequence position in ulExt, and is restored from it") {
    const auto [flag, ul_ext] = GENERATE(std::pair{0x00, 0x000u}, std::pair{0x10, 0x080u}, std::pair{0x20, 0x0C0u},
                                         std::pair{0x80, 0x040u}, std::pair{0x40, 0x2C0u});
    auto message = vector_of(wrench_effort);
    message[13] = static_cast<std::byte>(flag);
    const auto there = to_packet<seed>(message);
    REQUIRE(there.error == translate::errc::ok);
    CHECK(get(there.bytes, word::ul_ext) == ul_ext);
    CHECK(from_packet<seed>(there.bytes).bytes == message);
}

TEST_CASE("a code index finds every code at its position and no other code") {
    CHECK(count_wrong_places<translation::ra_command_codes>() == 0);
    CHECK(count_wrong_places<no_codes>() == 0);
    CHECK(count_wrong_places<one_code>() == 0);
    CHECK(count_wrong_places<unsorted_codes>() == 0);
    CHECK(count_wrong_places<every_high_byte_but_one>() == 0);
    CHECK(count_wrong_places<whole_pages>() == 0);
    CHECK(count_wrong_places<more_than_a_byte_counts>() == 0);
}

TEST_CASE("a table by slots has each code's value, and another in all that no code has") {
    CHECK(count_wrong_values<translation::ra_command_codes>() == 0);
    CHECK(count_wrong_values<no_codes>() == 0);
    CHECK(count_wrong_values<one_code>() == 0);
    CHECK(count_wrong_values<unsorted_codes>() == 0);
    CHECK(count_wrong_values<every_high_byte_but_one>() == 0);
    CHECK(count_wrong_values<whole_pages>() == 0);
    CHECK(count_wrong_values<more_than_a_byte_counts>() == 0);
}
