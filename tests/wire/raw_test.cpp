// The raw form of a message.
#include "both_ways.hpp"
#include "samples.hpp"
#include "support/random_message.hpp"
#include <jauscat/schema/jaus/platform.hpp>

using samples::envelope;
using samples::fine;
using samples::mixed;
using samples::point;
using wire::errc;

TEST_CASE("a raw message has the integers on the wire under the same member pointers") {
    both_ways([] {
        wire::raw<mixed> raw{};
        raw.set<&mixed::number>(std::uint8_t{7});
        raw.set<&mixed::level>(std::uint8_t{200});
        wire::raw<point> place{};
        place.set<&point::x>(std::int16_t{-2});
        place.set<&point::y>(std::uint8_t{3});
        raw.set<&mixed::place>(place);
        const auto expected = bytes(0x03, 7, 200, 0x00, 0x00, 0xFE, 0xFF, 3);
        return encodes_to(raw, expected) && decodes_to(expected, raw);
    });
    both_ways([] {
        wire::raw<envelope> raw{};
        const auto used = wire::decode(raw, bytes(0x01, 0x02, 0x01, 7, 200, 0x34, 0x12, 0xEE));
        return used && raw.get<&envelope::kind>() == 0x0102 &&
               raw.get<&envelope::content>().get<&mixed::level>() == std::uint8_t{200} &&
               raw.get<&envelope::content>().get<&mixed::required>() == 0x1234 &&
               !raw.get<&envelope::content>().get<&mixed::id>() && raw.get<&envelope::tail>() == 0xEE;
    });
    STATIC_REQUIRE(wire::max_size<wire::raw<mixed>> == wire::max_size<mixed>);
    STATIC_REQUIRE(
        std::is_same_v<std::remove_cvref_t<decltype(std::declval<const wire::raw<mixed>&>().get<&mixed::level>())>,
                       std::optional<std::uint8_t>>);
    STATIC_REQUIRE(std::is_same_v<std::remove_cvref_t<decltype(std::declval<const wire::raw<fine>&>().get<&fine::b>())>,
                                  std::int64_t>);
}

TEST_CASE("a raw member can be changed in place") {
    both_ways([] {
        wire::raw<point> raw{};
        raw.slot<&point::x>() += 5;
        return raw.get<&point::x>() == 5 && encodes_to(raw, bytes(5, 0, 0));
    });
}

TEST_CASE("raw bit-fields keep the widths of their schema") {
    wire::raw<samples::flags> raw{};
    raw.set<&samples::flags::length>(std::uint16_t{0x800});
    std::array<std::byte, 2> out{};
    REQUIRE(wire::encode(raw, out).error() == errc::out_of_range);
}

TEMPLATE_TEST_CASE("a raw message is exact for every byte pattern", "", point, mixed, envelope, fine,
                   jauscat::jaus::set_wrench_effort, jauscat::jaus::set_travel_speed) {
    using T = TestType;
    support::generator random{6};
    std::array<std::byte, wire::max_size<T>> in{}, out{};
    int exact = 0;
    for (int round = 0; round != 20000; ++round) {
        support::fill(random, in);
        if constexpr (std::same_as<T, jauscat::jaus::set_wrench_effort>) in[1] &= std::byte{0x0F}; // ignores the others
        wire::raw<T> raw{};
        const auto used = wire::decode_prefix(raw, in);
        if (!used) {
            REQUIRE(used.error() == errc::unknown_presence_bit);
            continue;
        }
        ++exact;
        REQUIRE(wire::encode(raw, out)->size() == *used);
        REQUIRE(equal(std::span{in}.first(*used), std::span{out}.first(*used)));
    }
    REQUIRE(exact > 500);
}

TEST_CASE("raw and real messages of the same bytes agree") {
    using T = jauscat::jaus::set_wrench_effort;
    support::generator random{7};
    for (int round = 0; round != 2000; ++round) {
        std::array<std::byte, wire::max_size<T>> in{};
        const auto size = wire::encode(support::random_message<T>(random), in)->size();
        T real{};
        wire::raw<T> raw{};
        REQUIRE(wire::decode(real, std::span{in}.first(size)));
        REQUIRE(wire::decode(raw, std::span{in}.first(size)));
        wire::visit(real, [&]<class Item>(Item, const std::optional<double>& value) {
            const auto& integer = raw.template get<Item::key>();
            REQUIRE(value.has_value() == integer.has_value());
            if (value) REQUIRE(*value == Item::codec_type::to_real(*integer));
        });
    }
}
