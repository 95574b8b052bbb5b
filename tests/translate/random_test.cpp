// The library against plain loops: random messages both ways, and random packets back.
#include "plain_translator.hpp"
#include "samples.hpp"
#include "support/catch.hpp"

#include <random>

using namespace jauscat;
using namespace jauscat::test;

namespace {

using generator = std::mt19937_64;

std::uint32_t below(generator& g, std::uint32_t limit) { return static_cast<std::uint32_t>(g() % limit); }
template <class T, std::size_t Size> T pick(generator& g, const std::array<T, Size>& from) {
    return from[below(g, Size)];
}

std::vector<std::byte> random_message(generator& g, std::uint16_t code, unsigned flag, std::size_t body) {
    std::vector<std::byte> message(16 + body);
    for (auto& byte : message) byte = static_cast<std::byte>(g());
    for (std::size_t id = 4; id != 12; ++id)
        if (below(g, 8) == 0) message[id] = std::byte{255};
    message[2] = static_cast<std::byte>(code);
    message[3] = static_cast<std::byte>(code >> 8);
    message[12] = static_cast<std::byte>(body);
    message[13] = static_cast<std::byte>(body >> 8 | flag << 4);
    return message;
}

/// Any code, any defined flag. Drawn one after the other: the order of a call's arguments differs between compilers.
std::vector<std::byte> random_message(generator& g, std::size_t body) {
    const auto code = pick(g, plain_codes);
    const auto flag = pick(g, plain::flags).flag;
    return random_message(g, code, flag, body);
}

/// Checked outside of Catch's macros, which are slow, because there are many.
template <class Translator> bool translates_like_plain_loops(const std::vector<std::byte>& message) {
    const auto there = to_packet<Translator>(message);
    if (there.error != translate::errc::ok || there.bytes != plain_forth(plain_of(Translator{}), message)) return false;
    const auto again = from_packet<Translator>(there.bytes);
    return again.error == translate::errc::ok && again.bytes == message;
}

/// A packet that is nearly one of the table's: a translated message with up to three words or bytes changed.
template <class Translator> std::vector<std::byte> random_packet(generator& g) {
    constexpr std::array<std::uint32_t, 14> edges{0,   1,    0x20, 158,  159,  254,        255,
                                                  256, 6899, 6900, 7155, 7156, 0x00650008, 0xFFFFFFFF};
    constexpr std::array<std::uint32_t, 6> positions{0x000, 0x040, 0x080, 0x0C0, 0x2C0, 0x100};
    const auto body = below(g, 60);
    auto packet = to_packet<Translator>(random_message(g, body)).bytes;
    for (std::uint32_t changes = below(g, 4); changes != 0; --changes) {
        const auto at = static_cast<word>(4 * below(g, 14));
        switch (below(g, 6)) {
        case 0: set(packet, at, static_cast<std::uint32_t>(g())); break;
        case 1: set(packet, at, pick(g, edges)); break;
        case 2: set(packet, at, get(packet, at) + below(g, 9) - 4); break;
        case 3: set(packet, word::ul_ext, pick(g, positions)); break;
        case 4: packet[below(g, static_cast<std::uint32_t>(packet.size()))] = static_cast<std::byte>(g()); break;
        case 5: packet.resize(56 + below(g, 90), std::byte{0xA5}); break;
        }
        if (packet.size() < 56) packet.resize(56);
    }
    if (below(g, 10) == 0) packet.resize(below(g, static_cast<std::uint32_t>(packet.size()) + 1));
    return packet;
}

} // namespace

TEMPLATE_TEST_CASE("every code under every data flag translates like plain loops, and back", "", seed, self_contained) {
    generator g{2011};
    for (const auto code : plain_codes)
        for (const auto& pair : plain::flags) {
            const auto size = below(g, TestType::max_body + 1);
            const auto message = random_message(g, code, pair.flag, size);
            INFO(to_hex(message));
            if (!translates_like_plain_loops<TestType>(message)) FAIL("differs");
        }
    SUCCEED();
}

TEMPLATE_TEST_CASE("every body size translates like plain loops, and back", "", seed, self_contained) {
    generator g{3794};
    for (std::size_t size = 0; size <= TestType::max_body; ++size) {
        const auto message = random_message(g, size);
        INFO(to_hex(message));
        if (!translates_like_plain_loops<TestType>(message)) FAIL("differs");
    }
    SUCCEED();
}

TEMPLATE_TEST_CASE("random messages translate like plain loops, and back", "", seed, self_contained) {
    generator g{39777};
    for (int i = 0; i != 20000; ++i) {
        const auto size = below(g, 200);
        const auto message = random_message(g, size);
        INFO(to_hex(message));
        if (!translates_like_plain_loops<TestType>(message)) FAIL("differs");
    }
    SUCCEED();
}

TEMPLATE_TEST_CASE("100 000 random packets are translated back like by plain loops, or refused by both", "", seed,
                   self_contained) {
    generator g{39778};
    int accepted = 0, refused = 0, canonical = 0;
    for (int i = 0; i != 100'000; ++i) {
        const auto packet_bytes = random_packet<TestType>(g);
        INFO(to_hex(packet_bytes));
        const auto message = from_packet<TestType>(packet_bytes);
        const auto expected = plain_back(plain_of(TestType{}), packet_bytes);
        if ((message.error == translate::errc::ok) != expected.has_value()) FAIL("only one of them refuses");
        if (!expected) {
            ++refused;
            continue;
        }
        if (message.bytes != *expected) FAIL("messages differ");
        ++accepted;

        // Translated forth again, the packet is the same unless it was padded.
        packet given{};
        REQUIRE(wire::decode_prefix(given, packet_bytes));
        const bool is_canonical =
            given.head.ul_len == 16 + given.ul_data_cnt && packet_bytes.size() == 56 + given.ul_data_cnt;
        const auto again = to_packet<TestType>(message.bytes, given);
        if (again.error != translate::errc::ok) FAIL("what came back does not translate");
        if (is_canonical && again.bytes != packet_bytes) FAIL("a canonical packet changes on the way back and forth");
        canonical += is_canonical;
    }
    // Seeded: the mixture stays worth testing.
    CHECK(accepted > 20'000);
    CHECK(canonical > 10'000);
    CHECK(refused > 20'000);
}

TEMPLATE_TEST_CASE("random bytes are refused without a crash", "", seed, self_contained) {
    generator g{34980};
    for (int i = 0; i != 20'000; ++i) {
        std::vector<std::byte> noise(below(g, 200));
        for (auto& byte : noise) byte = static_cast<std::byte>(g());
        INFO(to_hex(noise));
        if (from_packet<TestType>(noise).error == translate::errc::ok) FAIL("accepted");
        const auto there = to_packet<TestType>(noise); // accepted only if size and code happen to be right
        if (there.error == translate::errc::ok && from_packet<TestType>(there.bytes).bytes != noise) FAIL("changed");
    }
    SUCCEED();
}
