// Messages of AS5669A in datagrams, and how they are told from other forms of JAUS.
#include "support/bytes.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/sae/transport/judp.hpp>

namespace {

namespace jaus = jauscat::jaus;
namespace sae = jauscat::sae;
using jaus::datagram_form;
using jauscat::test::from_hex;
using jauscat::test::hex_literal;
using sae::transport_errc;

constexpr auto query_status = hex_literal<17>("02 00 1000 01 0a017e00 14017e00 0220 0200");
constexpr auto two = hex_literal<31>("02 00 1000 01 0a017e00 14017e00 0220 0200 00 0e00 31 14017e00 0a017e00 0100");
constexpr auto ra_message = hex_literal<17>("06 02 0200 01210203 04200506 0100 0000 01");

std::vector<transport_errc> errors_of(std::span<const std::byte> datagram) {
    std::vector<transport_errc> errors;
    for (sae::datagram_reader messages{datagram}; messages.has_next();) errors.push_back(messages.next().error);
    return errors;
}

} // namespace

TEST_CASE("a datagram has the version in front of its message") {
    std::array<std::byte, 17> out{};
    const auto made =
        sae::put_datagram({.destination = {10, 1, 126}, .source = {20, 1, 126}}, hex_literal<2>("0220"), 2, out);
    REQUIRE(made);
    CHECK(support::equal(*made, query_status));
    CHECK(sae::put_datagram({.destination = {10, 1, 126}, .source = {20, 1, 126}}, hex_literal<2>("0220"), 2,
                            std::span{out}.first(16))
              .error() == transport_errc::no_space);
    CHECK(sae::put_datagram({}, {}, 2, {}).error() == transport_errc::no_space);
}

TEST_CASE("every message of a datagram is read") {
    CHECK(errors_of(query_status) == std::vector{transport_errc::ok});
    CHECK(errors_of(two) == std::vector{transport_errc::ok, transport_errc::ok});
    auto faulty = two;
    faulty[1] = std::byte{0xC0}; // compressed
    CHECK(errors_of(faulty) == std::vector{transport_errc::compressed, transport_errc::ok});
    CHECK(errors_of(std::span{two}.first(30)) == std::vector{transport_errc::ok, transport_errc::truncated});
    CHECK(errors_of(std::span{two}.first(1)).empty());
    CHECK(errors_of({}) == std::vector{transport_errc::wrong_version});
    CHECK(errors_of(ra_message) == std::vector{transport_errc::wrong_version});
}

TEST_CASE("the forms of JAUS that share a port are told apart") {
    STATIC_REQUIRE(jaus::form_of(query_status) == datagram_form::judp2);
    STATIC_REQUIRE(jaus::form_of(two) == datagram_form::judp2);
    STATIC_REQUIRE(jaus::form_of(ra_message) == datagram_form::bare);
    CHECK(jaus::form_of(from_hex("4a41555330312e30 0602020001210203042005060000 0000")) == datagram_form::jaus01);
    CHECK(jaus::form_of(from_hex("01 0000 0010 0602020001210203042005060000 0000")) == datagram_form::judp1);
    CHECK(jaus::form_of(from_hex("01 0507 0010 0602020001210203042005060000 0000")) == datagram_form::judp1_compressed);
    CHECK(jaus::form_of(from_hex("0202020001210203042005060000 0000")) == datagram_form::bare); // priority 2
    CHECK(jaus::form_of(std::span{query_status}.first(16)) == datagram_form::unknown);
    STATIC_REQUIRE(jaus::form_of({}) == datagram_form::unknown);
    for (int form = 0; form <= static_cast<int>(datagram_form::judp2); ++form)
        CHECK(jaus::describe(static_cast<datagram_form>(form)) != "unknown form");
}

TEST_CASE("damaged datagrams of version 2 remain those of this transport, bare RA messages of priority 2 do not") {
    STATIC_REQUIRE(sae::is_judp2(query_status));
    STATIC_REQUIRE(sae::is_judp2(std::span{query_status}.first(16)));
    CHECK_FALSE(sae::is_judp2(from_hex("0202020001210203042005060000 0000")));
    STATIC_REQUIRE_FALSE(sae::is_judp2(ra_message));
    STATIC_REQUIRE_FALSE(sae::is_judp2({}));
}
