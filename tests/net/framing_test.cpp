// The eight characters in front of a JAUS message, and their absence.
#include "support/bytes.hpp"
#include "support/catch.hpp"
#include <jauscat/jaus/message/framing.hpp>

#include <algorithm>
#include <cstddef>
#include <span>

using namespace jauscat;

namespace {

constexpr auto prefixed = support::bytes(0x4A, 0x41, 0x55, 0x53, 0x30, 0x31, 0x2E, 0x30, 0x06, 0x02);
constexpr auto bare = support::bytes(0x06, 0x02, 0x05, 0x04);

} // namespace

TEST_CASE("the prefix is the eight characters JAUS01.0") {
    STATIC_REQUIRE(std::ranges::equal(jaus::prefix(jaus::framing::jaus01), std::span{prefixed}.first(8)));
    STATIC_REQUIRE(jaus::prefix(jaus::framing::bare).empty());
    STATIC_REQUIRE(jaus::name(jaus::framing::jaus01) == "JAUS01.0");
    STATIC_REQUIRE(jaus::name(jaus::framing::bare) == "bare");
}

TEST_CASE("a prefix is recognised and removed") {
    constexpr auto taken = jaus::remove_framing(prefixed);
    STATIC_REQUIRE(taken.how == jaus::framing::jaus01);
    STATIC_REQUIRE(taken.message.data() == prefixed.data() + 8);
    STATIC_REQUIRE(taken.message.size() == 2);
}

TEST_CASE("all other bytes are a bare message") {
    constexpr auto taken = jaus::remove_framing(bare);
    STATIC_REQUIRE(taken.how == jaus::framing::bare);
    STATIC_REQUIRE(taken.message.data() == bare.data());
    STATIC_REQUIRE(taken.message.size() == 4);
    STATIC_REQUIRE(jaus::remove_framing(std::span{prefixed}.first(7)).how == jaus::framing::bare);
    STATIC_REQUIRE(jaus::remove_framing({}).message.empty());
    for (std::size_t i = 0; i < 8; ++i) {
        auto changed = prefixed;
        changed[i] ^= std::byte{0x20};
        CHECK(jaus::remove_framing(changed).how == jaus::framing::bare);
    }
}

TEST_CASE("a prefix alone holds an empty message") {
    constexpr auto taken = jaus::remove_framing(std::span{prefixed}.first(8));
    STATIC_REQUIRE(taken.how == jaus::framing::jaus01);
    STATIC_REQUIRE(taken.message.empty());
}
