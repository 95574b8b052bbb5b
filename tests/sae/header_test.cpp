// Header and addresses of the SAE transport, against literal bytes.
#include "support/bytes.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/sae/transport/message.hpp>
#include <jauscat/wire/wire.hpp>

namespace {

namespace sae = jauscat::sae;
namespace wire = jauscat::wire;
using jauscat::test::hex_literal;
using sae::transport_errc;

constexpr sae::jaus_id controller{20, 1, 126}, component{10, 1, 126};
constexpr auto request_control = hex_literal<17>("001100190a017e0014017e000d00c80100");
constexpr auto acknowledge = hex_literal<14>("000e003114017e000a017e000100");

constexpr auto joined(const sae::transport_header& head) {
    std::array<std::byte, 14> out{};
    const auto made = sae::join(head, {}, 0, out);
    if (!made) out.fill(std::byte{0xEE});
    return out;
}
constexpr std::byte properties(sae::transport_header head) {
    head.destination = component;
    head.source = controller;
    return joined(head)[3];
}
constexpr transport_errc join_error(const sae::transport_header& head) {
    std::array<std::byte, 14> out{};
    return sae::join(head, {}, 0, out).error();
}

} // namespace

TEST_CASE("an SAE address is sent as component, node, subsystem") {
    std::array<std::byte, 4> out{};
    REQUIRE(wire::encode(component, out));
    REQUIRE(support::equal(out, hex_literal<4>("0a017e00")));
    sae::jaus_id got{};
    REQUIRE(wire::decode(got, hex_literal<4>("0a01feca")));
    REQUIRE(got == sae::jaus_id{10, 1, 0xCAFE});
}

TEST_CASE("properties have priority, broadcast, acknowledgement and data flag at their bits") {
    STATIC_REQUIRE(properties({.priority = sae::priority::low}) == std::byte{0});
    STATIC_REQUIRE(properties({}) == std::byte{1});
    STATIC_REQUIRE(properties({.priority = sae::priority::safety_critical}) == std::byte{3});
    STATIC_REQUIRE(properties({.broadcast = sae::broadcast::local}) == std::byte{1 | 1 << 2});
    STATIC_REQUIRE(properties({.broadcast = sae::broadcast::global}) == std::byte{1 | 2 << 2});
    STATIC_REQUIRE(properties({.acknowledgement = sae::acknowledgement::request}) == std::byte{1 | 1 << 4});
    STATIC_REQUIRE(properties({.acknowledgement = sae::acknowledgement::nak}) == std::byte{1 | 2 << 4});
    STATIC_REQUIRE(properties({.acknowledgement = sae::acknowledgement::ack}) == std::byte{1 | 3 << 4});
    STATIC_REQUIRE(properties({.fragment_flag = sae::fragment_flag::first}) == std::byte{1 | 1 << 6});
    STATIC_REQUIRE(properties({.fragment_flag = sae::fragment_flag::last}) == std::byte{1 | 3 << 6});
}

TEST_CASE("Request Control of the capture splits into its parts and joins to its bytes") {
    constexpr auto m = sae::split(request_control);
    STATIC_REQUIRE(m);
    STATIC_REQUIRE(m.header.priority == sae::priority::standard);
    STATIC_REQUIRE(m.header.broadcast == sae::broadcast::global);
    STATIC_REQUIRE(m.header.acknowledgement == sae::acknowledgement::request);
    STATIC_REQUIRE(m.header.fragment_flag == sae::fragment_flag::single);
    STATIC_REQUIRE(m.header.destination == component);
    STATIC_REQUIRE(m.header.source == controller);
    STATIC_REQUIRE(support::equal(m.payload, hex_literal<3>("0d00c8")));
    STATIC_REQUIRE(m.sequence_number == 1);
    STATIC_REQUIRE(m.rest.empty());
    std::array<std::byte, 17> out{};
    const auto again = sae::join(m.header, m.payload, m.sequence_number, out);
    REQUIRE(again);
    REQUIRE(support::equal(*again, request_control));
}

TEST_CASE("an acknowledgement has no payload and the number of the packet") {
    constexpr auto m = sae::split(acknowledge);
    STATIC_REQUIRE(m);
    STATIC_REQUIRE(m.payload.empty());
    STATIC_REQUIRE(m.sequence_number == 1);
    STATIC_REQUIRE(sae::is_acknowledgement(m.header));
    std::array<std::byte, 14> out{};
    REQUIRE(sae::join(sae::acknowledgement_of(sae::split(request_control).header, component), {}, 1, out));
    REQUIRE(out == acknowledge);
}

TEST_CASE("several messages are split off one after the other") {
    static constexpr auto two = hex_literal<30>("00100001 0a017e00 14017e00 0220 0200 000e0031 14017e00 0a017e00 0100");
    constexpr auto first = sae::split(two);
    STATIC_REQUIRE(first);
    STATIC_REQUIRE(first.bytes.size() == 16);
    constexpr auto second = sae::split(first.rest);
    STATIC_REQUIRE(second);
    STATIC_REQUIRE(second.rest.empty());
}

TEST_CASE("sizes that cannot be leave the end of the message unknown") {
    STATIC_REQUIRE(sae::split({}).error == transport_errc::truncated);
    STATIC_REQUIRE(sae::split(std::span{request_control}.first(16)).error == transport_errc::truncated);
    STATIC_REQUIRE(sae::split(hex_literal<14>("000d003114017e000a017e000100")).error == transport_errc::wrong_size);
    STATIC_REQUIRE(sae::split(hex_literal<14>("000d003114017e000a017e000100")).bytes.empty());
    STATIC_REQUIRE(sae::split(hex_literal<15>("400f00310114017e000a017e000100")).error == transport_errc::wrong_size);
}

TEST_CASE("a proposal of header compression is a message without its two bytes") {
    static constexpr auto bytes = hex_literal<18>("40 1200 0507 01 0a017e00 14017e00 0220 0200");
    constexpr auto m = sae::split(bytes);
    STATIC_REQUIRE(m);
    STATIC_REQUIRE(m.header.compression == sae::compression::proposed);
    STATIC_REQUIRE(m.header.destination == component);
    STATIC_REQUIRE(m.header.source == controller);
    STATIC_REQUIRE(support::equal(m.payload, hex_literal<2>("0220")));
    STATIC_REQUIRE(m.sequence_number == 2);
}

TEST_CASE("other header compression, message types and sources are refused and skipped") {
    const auto error_of = [](std::string_view text) {
        const auto bytes = jauscat::test::from_hex(text);
        const auto m = sae::split(bytes);
        CHECK(m.rest.size() == 1);
        return m.error;
    };
    CHECK(error_of("80 1200 0507 01 0a017e00 14017e00 0220 0200 ff") == transport_errc::compressed);
    CHECK(error_of("c0 1200 0507 01 0a017e00 14017e00 0220 0200 ff") == transport_errc::compressed);
    CHECK(error_of("01 1000 01 0a017e00 14017e00 0220 0200 ff") == transport_errc::unknown_type);
    CHECK(error_of("00 1000 01 0a017e00 00017e00 0220 0200 ff") == transport_errc::invalid_source);
    CHECK(error_of("00 1000 01 0a017e00 14ff7e00 0220 0200 ff") == transport_errc::invalid_source);
    CHECK(error_of("00 1000 01 0a017e00 1401ffff 0220 0200 ff") == transport_errc::invalid_source);
}

TEST_CASE("what is not for sending is not joined") {
    static constexpr sae::transport_header good{.destination = component, .source = controller};
    const auto with = [](auto member, auto value) {
        auto head = good;
        head.*member = value;
        return head;
    };
    using head = sae::transport_header;
    CHECK(join_error(good) == transport_errc::ok);
    CHECK(join_error(with(&head::message_type, std::uint8_t{1})) == transport_errc::invalid_header);
    CHECK(join_error(with(&head::compression, sae::compression::proposed)) == transport_errc::invalid_header);
    CHECK(join_error(with(&head::broadcast, static_cast<sae::broadcast>(3))) == transport_errc::invalid_header);
    CHECK(join_error(with(&head::priority, static_cast<sae::priority>(4))) == transport_errc::invalid_header);
    CHECK(join_error(with(&head::source, sae::everybody)) == transport_errc::invalid_source);
    CHECK(join_error(with(&head::destination, sae::jaus_id{0, 1, 126})) == transport_errc::invalid_destination);
    CHECK(join_error(with(&head::destination, sae::everybody)) == transport_errc::ok);
    std::array<std::byte, 14> out{};
    CHECK(sae::join(good, hex_literal<1>("00"), 0, out).error() == transport_errc::no_space);
    CHECK(sae::join(good, std::vector<std::byte>(sae::max_payload_size + 1), 0, out).error() ==
          transport_errc::too_large);
}

TEST_CASE("each part of a destination may be a wildcard") {
    STATIC_REQUIRE(sae::covers(component, component));
    STATIC_REQUIRE_FALSE(sae::covers(component, controller));
    STATIC_REQUIRE(sae::covers({255, 1, 126}, component));
    STATIC_REQUIRE(sae::covers({10, 255, 126}, component));
    STATIC_REQUIRE(sae::covers({10, 1, 0xFFFF}, component));
    STATIC_REQUIRE(sae::covers(sae::everybody, component));
    STATIC_REQUIRE_FALSE(sae::covers({255, 2, 126}, component));
    STATIC_REQUIRE_FALSE(sae::covers({255, 255, 127}, component));
    STATIC_REQUIRE(sae::covers({0, 1, 126}, component));
    STATIC_REQUIRE_FALSE(sae::covers({0, 0, 0}, component));
    STATIC_REQUIRE(sae::names_one_component(component));
    STATIC_REQUIRE(sae::names_one_component({254, 254, 65534}));
    STATIC_REQUIRE_FALSE(sae::names_one_component({1, 0, 1}));
    STATIC_REQUIRE_FALSE(sae::names_one_component({1, 1, 0xFFFF}));
}

TEST_CASE("addresses as text have their subsystem first") {
    STATIC_REQUIRE(sae::jaus_id_text{component}.view() == "126.1.10");
    STATIC_REQUIRE(sae::jaus_id_text{sae::everybody}.view() == "65535.255.255");
    STATIC_REQUIRE(sae::jaus_id_text{sae::jaus_id{}}.view() == "0.0.0");
    STATIC_REQUIRE(sae::parse_jaus_id("126.1.10") == component);
    STATIC_REQUIRE(sae::parse_jaus_id("65535.255.255") == sae::everybody);
    for (const std::string_view wrong : {"", "1", "1.2", "1.2.3.4", "1..3", ".1.2", "1.2.", "1.2.256", "65536.1.1",
                                         "1.256.1", "a.1.1", "-1.1.1", " 1.1.1", "01.1.1", "99999999999.1.1"})
        CHECK_FALSE(sae::parse_jaus_id(wrong));
}

TEST_CASE("each error has a text") {
    for (int code = 0; code <= static_cast<int>(transport_errc::noise); ++code)
        CHECK(sae::describe(static_cast<transport_errc>(code)) != "unknown error");
    STATIC_REQUIRE(sae::describe(static_cast<transport_errc>(200)) == "unknown error");
}
