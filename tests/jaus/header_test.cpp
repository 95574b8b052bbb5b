// The JAUS header, against literal bytes.
#include "support/bytes.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/jaus/header.hpp>
#include <jauscat/wire/wire.hpp>

namespace {

namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;
using jauscat::test::hex_literal;

constexpr auto bytes_of(const jaus::header& header) {
    std::array<std::byte, 16> out{};
    if (wire::encode(header, out)->size() != 16) out.fill(std::byte{0xEE});
    return out;
}
constexpr std::byte byte_0(const jaus::header& header) { return bytes_of(header)[0]; }

constexpr jaus::header nothing{.priority = 0, .version = 0};
constexpr jaus::header with(auto member, auto value) {
    jaus::header header = nothing;
    header.*member = value;
    return header;
}

} // namespace

TEST_CASE("a header takes 16 bytes") {
    STATIC_REQUIRE(wire::min_size<jaus::header> == 16);
    STATIC_REQUIRE(wire::max_size<jaus::header> == 16);
    STATIC_REQUIRE(bytes_of(nothing) == hex_literal<16>("00000000000000000000000000000000"));
}

TEST_CASE("byte 0 has priority, ack/nak, service connection and experimental at their bits") {
    using jaus::header;
    STATIC_REQUIRE(byte_0(with(&header::priority, std::uint8_t{11})) == std::byte{11});
    STATIC_REQUIRE(byte_0(with(&header::priority, std::uint8_t{15})) == std::byte{15});
    STATIC_REQUIRE(byte_0(with(&header::ack_nak, jaus::ack_nak::request)) == std::byte{1 << 4});
    STATIC_REQUIRE(byte_0(with(&header::ack_nak, jaus::ack_nak::nak)) == std::byte{2 << 4});
    STATIC_REQUIRE(byte_0(with(&header::ack_nak, jaus::ack_nak::ack)) == std::byte{3 << 4});
    STATIC_REQUIRE(byte_0(with(&header::service_connection, true)) == std::byte{1 << 6});
    STATIC_REQUIRE(byte_0(with(&header::experimental, true)) == std::byte{1 << 7});
    STATIC_REQUIRE(
        byte_0({.priority = 9, .ack_nak = jaus::ack_nak::nak, .service_connection = true, .experimental = true}) ==
        std::byte{9 | 2 << 4 | 1 << 6 | 1 << 7});
}

TEST_CASE("byte 1 has the version below the reserved bits") {
    STATIC_REQUIRE(bytes_of({.version = 2})[1] == std::byte{2});
    STATIC_REQUIRE(bytes_of({.version = 63})[1] == std::byte{63});
    STATIC_REQUIRE(bytes_of({.version = 2, .reserved = 3})[1] == std::byte{2 | 3 << 6});
}

TEST_CASE("each field of a header is at its offset, little endian") {
    constexpr jaus::header header{.priority = 6,
                                  .ack_nak = jaus::ack_nak::request,
                                  .version = 2,
                                  .command_code = 0x0405,
                                  .destination = {.instance = 1, .component = 33, .node = 2, .subsystem = 3},
                                  .source = {.instance = 4, .component = 32, .node = 5, .subsystem = 6},
                                  .data_size = 0xABC,
                                  .data_flag = jaus::data_flag::last,
                                  .sequence_number = 0x1234};
    constexpr auto expected = hex_literal<16>("1602 0504 01210203 04200506 bc8a 3412");
    STATIC_REQUIRE(bytes_of(header) == expected);
    REQUIRE(support::equal(bytes_of(header), expected));
    jaus::header decoded{};
    REQUIRE(wire::decode(decoded, expected));
    REQUIRE(decoded == header);
}

TEST_CASE("a new header is a normal message of RA 3.3 that fits into one packet") {
    STATIC_REQUIRE(bytes_of(jaus::header{}) == hex_literal<16>("0602 0000 00000000 00000000 0000 0000"));
}

TEST_CASE("header values wider than their bits do not encode") {
    const auto error = [](const jaus::header& header) {
        std::array<std::byte, 16> out{};
        return wire::encode(header, out).error();
    };
    REQUIRE(error({.priority = 16}) == wire::errc::out_of_range);
    REQUIRE(error({.ack_nak = static_cast<jaus::ack_nak>(4)}) == wire::errc::out_of_range);
    REQUIRE(error({.version = 64}) == wire::errc::out_of_range);
    REQUIRE(error({.reserved = 4}) == wire::errc::out_of_range);
    REQUIRE(error({.data_size = 4096}) == wire::errc::out_of_range);
    REQUIRE(error({.data_flag = static_cast<jaus::data_flag>(16)}) == wire::errc::out_of_range);
    REQUIRE(error({.data_size = 4095}) == wire::errc::ok);
}

TEST_CASE("Set Emergency with code 5 encodes to the bytes derived by hand") {
    // Priority 15, version 2: 0F 02. Code 0006h. Destination and source. Two bytes of body, only packet. Sequence 34.
    constexpr jaus::header header{.priority = 15,
                                  .version = 2,
                                  .command_code = jaus::command_code_of<jaus::set_emergency>,
                                  .destination = {.instance = 1, .component = 1, .node = 1, .subsystem = 1},
                                  .source = {.instance = 2, .component = 2, .node = 2, .subsystem = 2},
                                  .data_size = 2,
                                  .sequence_number = 34};
    STATIC_REQUIRE(bytes_of(header) == hex_literal<16>("0f02 0600 01010101 02020202 0200 2200"));

    // Bits 0 and 2: the emergency, and an unassigned one.
    constexpr jaus::set_emergency body{.emergency_code = wire::bit_set<jaus::set_emergency_code>::from_bits(5)};
    std::array<std::byte, 2> out{};
    REQUIRE(wire::encode(body, out));
    REQUIRE(out == hex_literal<2>("0500"));
}

TEST_CASE("every octet of an address is decoded from its offset") {
    jaus::address id{};
    REQUIRE(wire::decode(id, support::bytes(1, 33, 254, 255)));
    REQUIRE(id == jaus::address{.instance = 1, .component = 33, .node = 254, .subsystem = 255});
}
