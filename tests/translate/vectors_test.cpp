// Recorded messages of every command code, through both tables and back.
#include "plain_translator.hpp"
#include "samples.hpp"
#include "support/catch.hpp"
#include "support/paths.hpp"

#include <fstream>
#include <map>

using namespace jauscat;
using namespace jauscat::test;

namespace {

/// The messages of the vector file: all of its "hex" members.
std::vector<std::vector<std::byte>> golden_messages() {
    std::ifstream file{support::test_data("ra_vectors.jsonl")};
    std::vector<std::vector<std::byte>> messages;
    for (std::string line; std::getline(file, line);) {
        constexpr std::string_view member = "\"hex\": \"";
        const auto at = line.find(member);
        if (at == std::string::npos) continue;
        const auto digits = std::string_view{line}.substr(at + member.size());
        messages.push_back(from_hex(digits.substr(0, digits.find('"'))));
    }
    return messages;
}

unsigned command_code(std::span<const std::byte> message) {
    return std::to_integer<unsigned>(message[2]) | std::to_integer<unsigned>(message[3]) << 8;
}

} // namespace

TEMPLATE_TEST_CASE("every golden message translates like plain loops, and both restore it byte for byte", "", seed,
                   self_contained) {
    const auto messages = golden_messages();
    REQUIRE(messages.size() == 1255);
    std::map<unsigned, int> codes;
    for (const auto& message : messages) {
        INFO(to_hex(message));
        const auto there = to_packet<TestType>(message);
        REQUIRE(there.error == translate::errc::ok);
        REQUIRE(get(there.bytes, word::ul_data_cnt) == message.size() - 16 + TestType::rest_size);
        REQUIRE(to_hex(there.bytes) == to_hex(plain_forth(plain_of(TestType{}), message)));
        REQUIRE(to_hex(from_packet<TestType>(there.bytes).bytes) == to_hex(message));
        REQUIRE(plain_back(plain_of(TestType{}), there.bytes) == message);
        ++codes[command_code(message)];
    }
    CHECK(codes.size() == 157); // all but Set VKS Feature Class Metadata
}

TEST_CASE("every golden message under every reserved data flag is refused by the seed table") {
    for (auto& message : golden_messages())
        for (const unsigned flag : {3u, 5u, 6u, 7u, 9u, 10u, 11u, 12u, 13u, 14u, 15u}) {
            message[13] = (message[13] & std::byte{0x0F}) | static_cast<std::byte>(flag << 4);
            INFO(to_hex(message));
            REQUIRE(to_packet<seed>(message).error == translate::errc::reserved_value);
        }
}
