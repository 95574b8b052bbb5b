// What stands in front of a JAUS message: nothing, eight characters, or the head of AS5669-2007.
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
    STATIC_REQUIRE(
        std::ranges::equal(jaus::message_prefix{jaus::framing::jaus01, 2}.bytes(), std::span{prefixed}.first(8)));
    STATIC_REQUIRE(jaus::message_prefix{jaus::framing::bare, 2}.bytes().empty());
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

namespace {

/// Query Heartbeat Pulse, and Report Heartbeat Pulse to all node managers, in one datagram of AS5669-2007.
constexpr auto two =
    support::bytes(0x01,                   // version
                   0x00, 0x00, 0x00, 0x10, // 16 bytes
                   0x06, 0x02, 0x02, 0x22, 0x01, 0x21, 0x01, 0x64, 0x01, 0x28, 0x01, 0x01, 0, 0, 0, 0, 0x00, 0x00, 0x00,
                   0x12, // 18 bytes
                   0x06, 0x02, 0x05, 0x24, 0x01, 0x01, 0xFF, 0xFF, 0x01, 0x01, 0x01, 0x01, 2, 0, 0, 0, 0xFF, 0x0F);

} // namespace

TEST_CASE("a datagram of AS5669-2007 holds one or more messages") {
    constexpr auto first = jaus::remove_framing(two);
    STATIC_REQUIRE(first.how == jaus::framing::judp1);
    STATIC_REQUIRE(first.message.data() == two.data() + 5);
    STATIC_REQUIRE(first.message.size() == 16);
    constexpr auto second = jaus::next_message(first);
    STATIC_REQUIRE(second.how == jaus::framing::judp1);
    STATIC_REQUIRE(second.message.data() == two.data() + 25);
    STATIC_REQUIRE(second.message.size() == 18);
    STATIC_REQUIRE(second.rest.empty());
    STATIC_REQUIRE(std::ranges::equal(jaus::message_prefix{jaus::framing::judp1, 16}.bytes(), std::span{two}.first(5)));
    STATIC_REQUIRE(std::ranges::equal(jaus::message_prefix{jaus::framing::judp1, 0x1234}.bytes(),
                                      support::bytes(0x01, 0x00, 0x00, 0x12, 0x34)));
    STATIC_REQUIRE(jaus::name(jaus::framing::judp1) == "judp1");
    STATIC_REQUIRE(jaus::foreign_form(two).empty());
}

TEST_CASE("bytes behind the messages of AS5669-2007 that are none are left in the rest") {
    for (std::size_t size = 21; size != two.size(); ++size) {
        const auto first = jaus::remove_framing(std::span{two}.first(size));
        CHECK(first.message.size() == 16);
        const auto second = jaus::next_message(first);
        CHECK(second.message.empty());
        CHECK(second.rest.size() == size - 21);
    }
    for (std::size_t size = 0; size != 21; ++size)
        CHECK(jaus::remove_framing(std::span{two}.first(size)).how == jaus::framing::bare);
}

TEST_CASE("a bare message of priority 1 is not taken for AS5669-2007, whatever follows") {
    auto message = std::array<std::byte, 21>{};
    std::ranges::copy(std::span{two}.first(21), message.begin());
    message[1] = std::byte{2}; // the version in a header
    CHECK(jaus::remove_framing(message).how == jaus::framing::bare);
    CHECK(jaus::foreign_form(message).empty());
}

TEST_CASE("other generations and header compression are named") {
    auto compressed = two;
    compressed[1] = std::byte{7};
    CHECK(jaus::foreign_form(compressed) == "AS5669-2007 with header compression, which is not supported");
    constexpr auto sae = support::bytes(0x02, 0x00, 0x0E, 0x00, 0x01, 1, 2, 3, 4, 5, 6, 7, 8, 9, 0);
    CHECK(jaus::foreign_form(sae) == "SAE JAUS (AS5669A, version 2), which is not supported");
    CHECK(jaus::foreign_form(std::span{sae}.first(14)).empty());
    CHECK(jaus::foreign_form(prefixed).empty());
}
