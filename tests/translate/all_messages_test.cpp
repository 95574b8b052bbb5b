// Every message of the standard through both tables: some against packets that are written out here, all of them with
// random headers and bodies against plain loops and back.
#include "plain_translator.hpp"
#include "samples.hpp"
#include "schema/messages.hpp"
#include "support/catch.hpp"
#include <jauscat/bridge/delivery.hpp>

#include <set>

using namespace jauscat;
using namespace jauscat::test;
using translate::errc;

namespace {

/// A message, and its packets under the seed table and under the self-contained one.
struct written_out {
    const char* what;
    const char* message;
    const char* seed_packet;
    const char* self_contained_packet;
};

// Header: properties, code, destination, source, data control, sequence number; then the body.
// Packet: its header; node, index, subindex, count; what travels of the JAUS header, then the body.
// clang-format off
constexpr written_out samples[]{
    {"Shutdown to everybody, no body",
     "0b02 0200 ff01ffff ee216fa5 0000 ffff",
     "ff000000 00000000 ff000000 00000000 18000000 00000000 00000000 08006500 00000000 00000000"
     " ff000000 f51a0000 02000000 08000000"
     " 0b02 ee216fa5 ffff",
     "20000000 00000000 00000000 00000000 1c000000 00000000 00000000 08006500 00000000 00000000"
     " ff000000 f51a0000 02000000 0c000000"
     " 0b02 ff ff ee216fa5 0000 ffff"},
    {"Query Wrench Effort, its presence vector",
     "d602 0524 e701ff88 7621d4a5 0200 8390"
     " a595",
     "88000000 00000000 e7000000 00000000 1a000000 00000000 00000000 08006500 00000000 00000000"
     " ff000000 f51a0000 48000000 0a000000"
     " d602 7621d4a5 8390 a595",
     "20000000 00000000 00000000 00000000 1e000000 00000000 00000000 08006500 00000000 00000000"
     " ff000000 f51a0000 48000000 0e000000"
     " d602 e7 88 7621d4a5 0200 8390 a595"},
    {"Create Event, the last of a large data set",
     "4002 f001 ff13fffb e221c2b7 1980 1d0c"
     " ac3ecf7004090000ff06000000000000 0000888c0100000077",
     "fb000000 00000000 ff000000 00000000 31000000 00000000 00000000 08006500 40000000 00000000"
     " ff000000 071b0000 12000000 21000000"
     " 4002 e221c2b7 1d0c ac3ecf7004090000ff06000000000000 0000888c0100000077",
     "20000000 00000000 00000000 00000000 35000000 00000000 00000000 08006500 00000000 00000000"
     " ff000000 071b0000 12000000 25000000"
     " 4002 ff fb e221c2b7 1980 1d0c ac3ecf7004090000ff06000000000000 0000888c0100000077"},
    {"Report Image, a packet in the middle, from the component that has the largest index",
     "8002 0748 26ff0f13 1a0134c8 2a20 ffff"
     " 010b7688385819d6ac61552f07d809c3 7e3639515c23dcaa258e48c29ef58fb3 03f4eccb5e7454dec402",
     "13000000 00000000 26000000 00000000 42000000 00000000 00000000 08006500 c0000000 00000000"
     " 0f000000 f31b0000 90000000 32000000"
     " 8002 1a0134c8 ffff 010b7688385819d6ac61552f07d809c3 7e3639515c23dcaa258e48c29ef58fb3 03f4eccb5e7454dec402",
     "20000000 00000000 00000000 00000000 46000000 00000000 00000000 08006500 00000000 00000000"
     " 0f000000 f31b0000 90000000 36000000"
     " 8002 26 13 1a0134c8 2a20 ffff 010b7688385819d6ac61552f07d809c3 7e3639515c23dcaa258e48c29ef58fb3 03f4eccb5e7454dec402"},
    {"Set Payload Data Element, a first packet",
     "6f02 010d ffffffff 2f999865 0410 0000"
     " 01040000",
     "ff000000 00000000 ff000000 00000000 1c000000 00000000 00000000 08006500 80000000 00000000"
     " ff000000 f31b0000 33000000 0c000000"
     " 6f02 2f999865 0000 01040000",
     "20000000 00000000 00000000 00000000 20000000 00000000 00000000 08006500 00000000 00000000"
     " ff000000 f31b0000 33000000 10000000"
     " 6f02 ff ff 2f999865 0410 0000 01040000"},
    {"Report Heartbeat Pulse, repeated",
     "1602 0242 ffffffff 4f2664d8 0040 d1d8",
     "ff000000 00000000 ff000000 00000000 18000000 00000000 00000000 08006500 c0020000 00000000"
     " ff000000 f31b0000 73000000 08000000"
     " 1602 4f2664d8 d1d8",
     "20000000 00000000 00000000 00000000 1c000000 00000000 00000000 08006500 00000000 00000000"
     " ff000000 f31b0000 73000000 0c000000"
     " 1602 ff ff 4f2664d8 0040 d1d8"},
    {"the experimental 0404h",
     "9b02 0404 4701ff46 0d26f173 1800 0e42"
     " 7b01714d4802ffffff7f82f68f938dfb c22c028001000000",
     "46000000 00000000 47000000 00000000 30000000 00000000 00000000 08006500 00000000 00000000"
     " ff000000 f51a0000 9e000000 20000000"
     " 9b02 0d26f173 0e42 7b01714d4802ffffff7f82f68f938dfb c22c028001000000",
     "20000000 00000000 00000000 00000000 34000000 00000000 00000000 08006500 00000000 00000000"
     " ff000000 f51a0000 9e000000 24000000"
     " 9b02 47 46 0d26f173 1800 0e42 7b01714d4802ffffff7f82f68f938dfb c22c028001000000"},
};
// clang-format on

/// Any header that a message may have at packet level, with the body of a message of this type.
std::vector<std::byte> random_message(support::generator& g, const messages::message& type) {
    const auto body = type.random(g, {}).bytes;
    auto head = support::random_message<jaus::header>(g);
    for (auto* address : {&head.destination, &head.source})
        for (auto* octet : {&address->instance, &address->component, &address->node, &address->subsystem})
            if (support::chance(g, 0.1)) *octet = 255;
    head.command_code = type.code;
    head.data_size = static_cast<std::uint16_t>(body.size() & 0xFFF);
    head.data_flag = static_cast<jaus::data_flag>(plain::flags[support::below(g, plain::flags.size())].flag);

    std::vector<std::byte> message(16 + body.size());
    REQUIRE(wire::encode(head, message));
    std::ranges::copy(body, message.begin() + 16);
    return message;
}

} // namespace

TEST_CASE("messages of seven kinds are translated to the expected packets and back") {
    for (const auto& sample : samples) {
        INFO(sample.what);
        const auto message = from_hex(sample.message);
        CHECK(to_hex(to_packet<seed>(message).bytes) == hex_of(sample.seed_packet));
        CHECK(to_hex(to_packet<self_contained>(message).bytes) == hex_of(sample.self_contained_packet));
        CHECK(to_hex(from_packet<seed>(from_hex(sample.seed_packet)).bytes) == to_hex(message));
        CHECK(to_hex(from_packet<self_contained>(from_hex(sample.self_contained_packet)).bytes) == to_hex(message));
    }
}

TEST_CASE("plain loops produce the same packets") {
    for (const auto& sample : samples) {
        INFO(sample.what);
        const auto message = from_hex(sample.message);
        CHECK(to_hex(plain_forth(plain_table::seed, message)) == hex_of(sample.seed_packet));
        CHECK(to_hex(plain_forth(plain_table::self_contained, message)) == hex_of(sample.self_contained_packet));
    }
}

TEMPLATE_TEST_CASE("every message with any header and body translates like plain loops, and back", "", seed,
                   self_contained) {
    support::generator g{158};
    std::set<std::uint16_t> codes;
    std::set<std::uint16_t> too_large;
    for (const auto& type : messages::all()) {
        INFO(type.name());
        for (int round = 0; round != 40; ++round) {
            const auto message = random_message(g, type);
            INFO(to_hex(message));
            const auto there = to_packet<TestType>(message);
            if (message.size() - 16 > TestType::max_body) {
                REQUIRE(there.error == errc::too_large);
                too_large.insert(type.code);
                continue;
            }
            REQUIRE(there.error == errc::ok);
            if (there.bytes != plain_forth(plain_of(TestType{}), message)) FAIL("plain loops make another packet");
            if (from_packet<TestType>(there.bytes).bytes != message) FAIL("the packet comes back as another message");
            codes.insert(type.code);
        }
    }
    CHECK(codes.size() == 158);
    CHECK(too_large.size() < 20); // the rest has seen every message
}

TEST_CASE("delivery refuses every part of a large data set, and broadcasts that name no slave") {
    using delivery = bridging::delivery<translation::seed_table>;
    for (const auto& type : messages::all())
        for (const auto& [flag, ul_ext] : plain::flags)
            for (const unsigned node : {0u, 1u, 254u, 255u}) {
                CAPTURE(type.name(), flag, node);
                const jaus::header head{.command_code = type.code,
                                        .destination = {255, 255, static_cast<std::uint8_t>(node), 255},
                                        .data_flag = static_cast<jaus::data_flag>(flag)};
                const auto expected = flag != 0                  ? errc::fragment_to_slave
                                      : node == 0 || node == 255 ? errc::broadcast_names_no_slave
                                                                 : errc::ok;
                REQUIRE(delivery::deliverable(head) == expected);
                // Refused by delivery, not by translation.
                std::array<std::byte, 16> message{};
                REQUIRE(wire::encode(head, message));
                REQUIRE(to_packet<seed>(message).error == errc::ok);
                REQUIRE(to_packet<self_contained>(message).error == errc::ok);
            }
}
