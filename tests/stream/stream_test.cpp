// Messages found in a stream of bytes: whole, in pieces, and among noise.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/instant.hpp"
#include <jauscat/jaus/message/stream_framer.hpp>

#include <random>

namespace {

using namespace std::chrono_literals;
using jauscat::jaus::stream_framer;
using jauscat::test::from_hex;
using jauscat::test::to_hex;
using support::instant;
using bytes = std::vector<std::byte>;

// Set Wrench Effort, 50 % along x, from 1.1.1.1 to 2.2.33.1; Query Component Status, which has no body.
const bytes wrench = from_hex("0602 0504 01210202 01010101 0400 2200 0100 0040");
const bytes status = from_hex("0602 0220 01210202 01010101 0000 2300");

bytes operator+(bytes first, const bytes& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

/// A framer and the messages that it has handed on, as text.
template <std::size_t MaxBody = 64> struct listener {
    std::array<std::byte, jauscat::jaus::header_size + MaxBody> buffer{};
    stream_framer framer{buffer, 20ms};
    std::vector<std::string> messages{};

    void hear(const bytes& received, instant now = 0ms) {
        framer.on_bytes(received, now, [&](auto message) { messages.push_back(to_hex(message)); });
    }
    void wait(instant now) {
        framer.on_time(now, [&](auto message) { messages.push_back(to_hex(message)); });
    }
};

std::vector<std::string> texts(std::initializer_list<bytes> messages) {
    std::vector<std::string> found;
    for (const auto& message : messages) found.push_back(to_hex(message));
    return found;
}

bytes changed(bytes message, std::size_t at, unsigned value) {
    message.at(at) = static_cast<std::byte>(value);
    return message;
}

} // namespace

TEST_CASE("consecutive messages are delivered one by one, however the bytes arrive") {
    const auto stream = wrench + status + wrench;
    for (std::size_t piece = 1; piece <= stream.size(); ++piece) {
        listener heard;
        for (std::size_t at = 0; at < stream.size(); at += piece) {
            const auto end = std::min(at + piece, stream.size());
            heard.hear(
                {stream.begin() + static_cast<std::ptrdiff_t>(at), stream.begin() + static_cast<std::ptrdiff_t>(end)});
        }
        REQUIRE(heard.messages == texts({wrench, status, wrench}));
    }
}

TEST_CASE("a message is delivered with its last byte") {
    listener heard;
    heard.hear({wrench.begin(), wrench.end() - 1});
    CHECK(heard.messages.empty());
    heard.hear({wrench.back()});
    CHECK(heard.messages == texts({wrench}));
}

TEST_CASE("noise before, between and after messages is dropped at once where no header can begin in it") {
    listener heard;
    const auto noise = from_hex("ff00 5a5a 0100 0000 ffff ffff ffff ffff ffff ffff ff");
    heard.hear(noise + wrench + noise + status + noise);
    CHECK(heard.messages == texts({wrench, status}));
}

TEST_CASE("the eight-character prefix of some framings counts as noise") {
    listener heard;
    heard.hear(from_hex("4a415553 30312e30") + wrench + from_hex("4a415553 30312e30") + status);
    CHECK(heard.messages == texts({wrench, status}));
}

TEST_CASE("each impossible header is noise") {
    const auto version_1 = changed(status, 1, 0x01), version_3 = changed(status, 1, 0x03);
    const auto reserved_bit_14 = changed(status, 1, 0x42), reserved_bit_15 = changed(status, 1, 0x82);
    const auto flag_3 = changed(status, 13, 0x30), flag_15 = changed(status, 13, 0xF0);
    const auto no_instance = changed(status, 8, 0), all_instances = changed(status, 8, 255);
    const auto no_component = changed(status, 9, 0), all_components = changed(status, 9, 255);
    const auto no_node = changed(status, 10, 0), all_nodes = changed(status, 10, 255);
    const auto no_subsystem = changed(status, 11, 0), all_subsystems = changed(status, 11, 255);
    const auto too_large = changed(status, 12, 65);
    for (const auto& impossible :
         {version_1, version_3, reserved_bit_14, reserved_bit_15, flag_3, flag_15, no_instance, all_instances,
          no_component, all_components, no_node, all_nodes, no_subsystem, all_subsystems, too_large}) {
        listener heard;
        heard.hear(impossible + wrench);
        CHECK(heard.messages == texts({wrench}));
    }
}

TEST_CASE("every defined data flag is possible, and so is a body of the maximum size") {
    for (const unsigned flag : {0x00u, 0x10u, 0x20u, 0x40u, 0x80u}) {
        listener heard;
        heard.hear(changed(status, 13, flag));
        CHECK(heard.messages.size() == 1);
    }
    const auto largest = changed(status, 12, 64) + bytes(64, std::byte{0xA5});
    listener heard;
    heard.hear(largest + wrench);
    CHECK(heard.messages == texts({largest, wrench}));
}

TEST_CASE("a message with a body of 4080 bytes passes a framer with a sufficient buffer") {
    const auto largest = changed(changed(status, 12, 0xF0), 13, 0x0F) + bytes(4080, std::byte{0x02});
    listener<jauscat::jaus::max_body_size> heard;
    heard.hear(largest + status);
    CHECK(heard.messages == texts({largest, status}));

    listener<jauscat::jaus::max_body_size> refused;
    refused.hear(changed(changed(wrench, 12, 0xF1), 13, 0x0F) + wrench); // 4081
    CHECK(refused.messages == texts({wrench}));
}

TEST_CASE("noise inside a header is recognised and the next message is found") {
    listener heard;
    const bytes begun{wrench.begin(), wrench.begin() + 6}, rest{wrench.begin() + 6, wrench.end()};
    heard.hear(begun + from_hex("ff ff ff ff") + rest + status);
    CHECK(heard.messages == texts({status}));
}

TEST_CASE("noise inside a body truncates this message and does not affect the next") {
    listener heard;
    const bytes begun{wrench.begin(), wrench.begin() + 18}, rest{wrench.begin() + 18, wrench.end()};
    heard.hear(begun + from_hex("77 77") + rest + status);
    CHECK(heard.messages == texts({begun + from_hex("77 77"), status}));
}

TEST_CASE("an incomplete message is dropped exactly after the idle time") {
    for (const std::size_t length : {std::size_t{1}, std::size_t{15}, std::size_t{16}, wrench.size() - 1}) {
        const bytes begun{wrench.begin(), wrench.begin() + static_cast<std::ptrdiff_t>(length)};
        const bytes rest{wrench.begin() + static_cast<std::ptrdiff_t>(length), wrench.end()};
        listener in_time;
        in_time.hear(begun, 1s);
        in_time.wait(1s + 20ms - 1ns);
        in_time.hear(rest, 1s + 20ms - 1ns);
        CHECK(in_time.messages == texts({wrench}));

        listener told;
        told.hear(begun, 1s);
        told.wait(1s + 20ms);
        told.hear(wrench, 1s + 21ms);
        CHECK(told.messages == texts({wrench}));

        listener untold; // nobody called on_time in between
        untold.hear(begun, 1s);
        untold.hear(wrench, 1s + 20ms);
        CHECK(untold.messages == texts({wrench}));
    }
}

TEST_CASE("silence between messages has no effect") {
    listener heard;
    heard.hear(wrench, 0ms);
    heard.wait(1h);
    heard.hear(status, 2h);
    CHECK(heard.messages == texts({wrench, status}));
}

TEST_CASE("messages inside noise that resembled a header are delivered when the line is idle") {
    listener heard;
    const auto promise = changed(status, 12, 64); // announces 64 bytes of body that never come
    heard.hear(promise + wrench + status, 5ms);
    CHECK(heard.messages.empty());
    heard.wait(24ms);
    CHECK(heard.messages.empty());
    heard.wait(25ms);
    CHECK(heard.messages == texts({wrench, status}));
    heard.hear(status, 26ms);
    CHECK(heard.messages == texts({wrench, status, status}));
}

TEST_CASE("after any noise and an idle line, messages are delivered unchanged") {
    std::mt19937 random{20241};
    for (int round = 0; round != 2000; ++round) {
        listener heard;
        bytes noise(random() % 200);
        // Only values that headers are made of, so that false headers are frequent.
        for (auto& byte : noise) byte = static_cast<std::byte>(random() % 4);
        heard.hear(noise, 1ms);
        heard.wait(21ms);
        const auto from_noise = heard.messages.size();
        heard.hear(wrench + status, 22ms);
        REQUIRE(heard.messages.size() == from_noise + 2);
        CHECK(heard.messages[from_noise] == to_hex(wrench));
        CHECK(heard.messages[from_noise + 1] == to_hex(status));
    }
}

TEST_CASE("the framer works at compile time") {
    STATIC_REQUIRE([] {
        constexpr auto message = jauscat::test::hex_literal<16>("0602 0220 01210202 01010101 0000 2300");
        std::array<std::byte, 16> buffer{};
        stream_framer framer{buffer, 1ms};
        std::size_t found = 0;
        for (const std::byte byte : message)
            framer.on_bytes({&byte, 1}, instant{0ms}, [&](std::span<const std::byte> taken) { found += taken.size(); });
        return found == message.size();
    }());
}
