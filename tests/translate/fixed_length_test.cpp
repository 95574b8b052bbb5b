// Tables with objects of fixed length: the bytes, what is refused, and every message there and back.
#include "plain_translator.hpp"
#include "samples.hpp"
#include "schema/messages.hpp"
#include "support/catch.hpp"
#include <jauscat/bridge/delivery.hpp>
#include <jauscat/schema/jaus/messages.hpp>

#include <map>
#include <random>

using namespace jauscat;
using namespace jauscat::test;
using translate::errc;

namespace {

using fixed_seed_table = translate::fixed_length<translation::seed_table, jaus::messages>;
using fixed_self_contained_table = translate::fixed_length<translation::self_contained_table, jaus::messages>;
using fixed_seed = translate::translator<fixed_seed_table>;
using fixed_self_contained = translate::translator<fixed_self_contained_table>;

constexpr plain_table plain_of(fixed_seed) { return plain_table::seed; }
constexpr plain_table plain_of(fixed_self_contained) { return plain_table::self_contained; }

/// Set Wrench Effort with one element.
constexpr auto one_effort = hex_literal<20>("0602 0504 05210201 02200304 0400 2200 0100 ff7f");
constexpr auto one_effort_seed = hex_literal<86>("01000000 00000000 05000000 00000000"
                                                 "2e000000 00000000 00000000 08006500" // ulLen 46
                                                 "00000000 00000000"
                                                 "02000000 151b0000 1a000000 1e000000" // ulDataCnt 30
                                                 "0c00"                                // real length 12
                                                 "0602 02200304 2200 0100 ff7f"
                                                 "0000000000000000 0000000000000000");
constexpr auto one_effort_self_contained = hex_literal<90>("20000000 00000000 00000000 00000000"
                                                           "32000000 00000000 00000000 08006500" // ulLen 50
                                                           "00000000 00000000"
                                                           "02000000 151b0000 1a000000 22000000" // ulDataCnt 34
                                                           "1000"                                // real length 16
                                                           "0602 05 01 02200304 0400 2200 0100 ff7f"
                                                           "0000000000000000 0000000000000000");
/// The largest: nothing is left to fill up.
constexpr auto full_seed = hex_literal<86>("01000000 00000000 05000000 00000000"
                                           "2e000000 00000000 00000000 08006500"
                                           "00000000 00000000"
                                           "02000000 151b0000 1a000000 1e000000"
                                           "1c00" // real length 28
                                           "0602 02200304 2200"
                                           "ff0f ff7f 0180 0000 0040 01c0 0020 00ff80 336699");
/// Report Wrench Effort without any element, from 4.3.32.2 to 1.2.33.5.
constexpr auto no_report = hex_literal<18>("0602 0544 05210201 02200304 0200 2200 0000");
constexpr auto no_report_seed = hex_literal<86>("01000000 00000000 05000000 00000000"
                                                "2e000000 00000000 00000000 08006500"
                                                "00000000 00000000"
                                                "02000000 151b0000 79000000 1e000000" // subindex 121
                                                "0a00 0602 02200304 2200 0000"
                                                "000000000000000000 000000000000000000");

/// The packet by plain loops: that of the table without the option, its data behind their length and filled up.
std::vector<std::byte> plain_fixed(plain_table table, const std::vector<std::byte>& message, std::size_t object) {
    const auto bare = plain_forth(table, message);
    const std::size_t real = bare.size() - 56;
    std::vector<std::byte> packet(bare.begin(), bare.begin() + 56);
    set(packet, word::ul_len, static_cast<std::uint32_t>(16 + object));
    set(packet, word::ul_data_cnt, static_cast<std::uint32_t>(object));
    packet.push_back(static_cast<std::byte>(real & 0xFF));
    packet.push_back(static_cast<std::byte>(real >> 8));
    packet.insert(packet.end(), bare.begin() + 56, bare.end());
    packet.resize(56 + object);
    return packet;
}

std::vector<std::byte> with_code(std::vector<std::byte> message, std::uint16_t code) {
    message[2] = static_cast<std::byte>(code & 0xFF);
    message[3] = static_cast<std::byte>(code >> 8);
    return message;
}

} // namespace

TEST_CASE("a fixed object has the real length, the data and zeros up to its size") {
    CHECK(to_hex(to_packet<fixed_seed>(one_effort).bytes) == to_hex(one_effort_seed));
    CHECK(to_hex(from_packet<fixed_seed>(one_effort_seed).bytes) == to_hex(one_effort));
    CHECK(to_hex(to_packet<fixed_self_contained>(one_effort).bytes) == to_hex(one_effort_self_contained));
    CHECK(to_hex(from_packet<fixed_self_contained>(one_effort_self_contained).bytes) == to_hex(one_effort));
}

TEST_CASE("the largest command fills its fixed object, which also holds a report") {
    CHECK(to_hex(to_packet<fixed_seed>(wrench_effort).bytes) == to_hex(full_seed));
    CHECK(to_hex(from_packet<fixed_seed>(full_seed).bytes) == to_hex(wrench_effort));
    CHECK(to_hex(to_packet<fixed_seed>(no_report).bytes) == to_hex(no_report_seed));
    CHECK(to_hex(from_packet<fixed_seed>(no_report_seed).bytes) == to_hex(no_report));
}

TEST_CASE("a fixed object is made in a constant expression") {
    constexpr auto packet = [] {
        const auto message = one_effort; // a copy: see delivery_test.cpp
        std::array<std::byte, one_effort_seed.size()> out{};
        const auto translated = fixed_seed::to_packet(message, out);
        return translated ? out : decltype(out){};
    }();
    STATIC_REQUIRE(packet == one_effort_seed);
}

TEST_CASE("objects have the size of the largest body, those of unbounded messages the size of a packet") {
    const auto size_of = []<class Table>(Table, std::uint16_t code) {
        return Table::object_size(jaus::header{.command_code = code});
    };
    CHECK(size_of(fixed_seed_table{}, 0x0405) == 30);
    CHECK(size_of(fixed_seed_table{}, 0x0002) == 10); // Shutdown has no body
    CHECK(size_of(fixed_seed_table{}, 0x2405) == 12);
    CHECK(size_of(fixed_seed_table{}, 0x4405) == 30);
    CHECK(size_of(fixed_seed_table{}, 0x4807) == 1540); // Report Image
    CHECK(size_of(fixed_seed_table{}, 0x4402) == 1540); // known senders append to it
    CHECK(size_of(fixed_seed_table{}, 0xD000) == 0);
    CHECK(size_of(fixed_self_contained_table{}, 0x0405) == 34);
    CHECK(size_of(fixed_self_contained_table{}, 0x0002) == 14);
    CHECK(size_of(fixed_self_contained_table{}, 0x4807) == 1540);
    STATIC_REQUIRE(fixed_seed::max_body == 1530);
    STATIC_REQUIRE(fixed_self_contained::max_body == 1526);
    STATIC_REQUIRE(translate::has_fixed_length<fixed_seed_table>);
    STATIC_REQUIRE(!translate::has_fixed_length<translation::seed_table>);
}

TEST_CASE("a fixed object of another size or with an impossible length is refused") {
    const auto error = [](std::vector<std::byte> bytes) { return from_packet<fixed_seed>(bytes).error; };
    const auto good = vector_of(one_effort_seed);
    const auto with_length = [&](unsigned length) {
        auto bytes = good;
        bytes[56] = static_cast<std::byte>(length);
        return bytes;
    };
    CHECK(error(good) == errc::ok);
    CHECK(error(with(good, word::ul_data_cnt, 29)) == errc::wrong_size);
    CHECK(error(with(good, word::ul_data_cnt, 1)) == errc::truncated);
    CHECK(error(with(good, word::ul_data_cnt, 31)) == errc::truncated);   // there are no 31
    CHECK(error(with(good, word::ul_sub_index, 30)) == errc::wrong_size); // Set Travel Speed is shorter
    CHECK(error(with_length(28)) == errc::ok);
    CHECK(error(with_length(29)) == errc::wrong_size);
    CHECK(error(with_length(8)) == errc::ok); // no body
    CHECK(error(with_length(7)) == errc::truncated);
    auto longer = with(with(good, word::ul_data_cnt, 31), word::ul_len, 47);
    longer.resize(longer.size() + 1);
    CHECK(error(longer) == errc::wrong_size);

    auto self_contained = vector_of(one_effort_self_contained);
    self_contained[56] = std::byte{15};
    CHECK(from_packet<fixed_self_contained>(self_contained).error == errc::wrong_size); // its header says the size too
}

TEST_CASE("the padding of a fixed object is ignored") {
    auto filled = vector_of(one_effort_seed);
    std::fill(filled.end() - 16, filled.end(), std::byte{0xA5});
    CHECK(to_hex(from_packet<fixed_seed>(filled).bytes) == to_hex(one_effort));
}

TEST_CASE("a body larger than its message allows does not fit a fixed object") {
    CHECK(to_packet<fixed_seed>(message_with_body(20)).error == errc::ok);
    CHECK(to_packet<fixed_seed>(message_with_body(21)).error == errc::too_large);
    CHECK(to_packet<seed>(message_with_body(21)).error == errc::ok);
    const auto image = [](std::size_t size) { return with_code(message_with_body(size), 0x4807); };
    CHECK(to_packet<fixed_seed>(image(1530)).error == errc::ok);
    CHECK(to_packet<fixed_seed>(image(1531)).error == errc::too_large);
    CHECK(to_packet<fixed_self_contained>(image(1526)).error == errc::ok);
    CHECK(to_packet<fixed_self_contained>(image(1527)).error == errc::too_large);
}

TEST_CASE("a fixed object needs a buffer of its whole size") {
    std::vector<std::byte> out(one_effort_seed.size());
    CHECK(fixed_seed::to_packet(one_effort, out)->size() == one_effort_seed.size());
    CHECK(fixed_seed::to_packet(one_effort, std::span{out}.first(out.size() - 1)).error() == errc::no_space);
    CHECK(fixed_seed::from_packet(one_effort_seed, std::span{out}.first(one_effort.size()))->size() ==
          one_effort.size());
    CHECK(fixed_seed::from_packet(one_effort_seed, std::span{out}.first(one_effort.size() - 1)).error() ==
          errc::no_space);
}

TEST_CASE("a message without a fixed object is refused in both directions") {
    using commands = translate::translator<translate::fixed_length<translation::seed_table, jaus::set_wrench_effort>>;
    CHECK(to_hex(to_packet<commands>(one_effort).bytes) == to_hex(one_effort_seed));
    CHECK(to_packet<commands>(no_report).error == errc::unknown_command_code);
    CHECK(from_packet<commands>(no_report_seed).error == errc::unknown_subindex);
    CHECK(to_packet<commands>(with_code(vector_of(one_effort), 0xD000)).error == errc::unknown_command_code);
}

TEMPLATE_TEST_CASE("every code with any body of its object translates like plain loops, and back", "", fixed_seed,
                   fixed_self_contained) {
    std::mt19937_64 g{607};
    const std::size_t overhead = 2 + TestType::rest_size;
    for (const auto& type : messages::all()) {
        CAPTURE(type.name());
        const std::size_t object = [&] {
            using table =
                std::conditional_t<std::is_same_v<TestType, fixed_seed>, fixed_seed_table, fixed_self_contained_table>;
            return table::object_size(jaus::header{.command_code = type.code});
        }();
        REQUIRE(object >= std::min<std::size_t>(1540, overhead + type.max_size()));
        for (std::size_t size = 0; size <= object - overhead;
             size = size == object - overhead ? size + 1 : std::min(object - overhead, size + (size < 40 ? 1 : 83))) {
            auto message = with_code(message_with_body(size), type.code);
            for (auto& byte : std::span{message}.first(2)) byte = static_cast<std::byte>(g());
            for (auto& byte : std::span{message}.subspan(4, 8)) byte = static_cast<std::byte>(g());
            for (auto& byte : std::span{message}.subspan(14)) byte = static_cast<std::byte>(g());
            INFO(to_hex(message));
            const auto there = to_packet<TestType>(message);
            if (there.error != errc::ok) FAIL("refused");
            if (there.bytes != plain_fixed(plain_of(TestType{}), message, object)) FAIL("differs");
            if (from_packet<TestType>(there.bytes).bytes != message) FAIL("does not come back");
        }
    }
}

TEMPLATE_TEST_CASE("every valid message fits its fixed object unless no packet could carry it", "", fixed_seed,
                   fixed_self_contained) {
    support::generator g{608};
    std::size_t carried = 0;
    for (const auto& type : messages::all())
        for (const double present : {0.0, 0.5, 1.0}) {
            const auto body = type.random(g, {.present = present}).bytes;
            INFO(type.name() << ", " << body.size() << " bytes of body");
            if (body.size() > jaus::max_body_size) continue; // not one JAUS packet either
            auto message = with_code(message_with_body(body.size()), type.code);
            std::ranges::copy(body, message.begin() + 16);
            const auto there = to_packet<TestType>(message);
            REQUIRE(there.error == (body.size() <= TestType::max_body ? errc::ok : errc::too_large));
            if (there.error != errc::ok) continue;
            REQUIRE(from_packet<TestType>(there.bytes).bytes == message);
            ++carried;
        }
    CHECK(carried > 3 * 140);
}

TEST_CASE("a slave restores the message from a fixed object") {
    using delivery = bridging::delivery<fixed_seed_table>;
    const auto object = delivery::object_of(one_effort_seed);
    CHECK(object.index == 6933);
    CHECK(object.subindex == 26);
    CHECK(object.data.size() == 30);
    std::vector<std::byte> out(delivery::translator::max_message_size);
    const auto restored = delivery::message_of(object, {.subsystem = 1, .station = 2, .instance = 5}, out);
    REQUIRE(restored);
    CHECK(to_hex(*restored) == to_hex(one_effort));
}
