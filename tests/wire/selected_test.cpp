// Values whose type or scale another member selects, and those whose type the receiver knows.
#include "list_checks.hpp"

using samples::agreed;
using samples::kind;
using samples::measure;
using samples::rgb;
using samples::typed;

// Decoding a std::variant is no constant expression with clang 14.
TEST_CASE("a value has the type of its tag") {
    both_ways([] { return encodes_to(typed{kind::byte, std::uint8_t{5}}, bytes(0, 5)); });
    both_ways([] { return encodes_to(typed{kind::real, 1.0f}, bytes(7, 0, 0, 0x80, 0x3F)); });
    both_ways([] { return encodes_to(typed{kind::colour, rgb{1, 2, 3}}, bytes(9, 1, 2, 3)); });
    both_ways([] { return encodes_to(typed{kind::none, std::monostate{}}, bytes(255)); });
    REQUIRE(decodes_to(bytes(0, 5), typed{kind::byte, std::uint8_t{5}}));
    REQUIRE(decodes_to(bytes(7, 0, 0, 0x80, 0x3F), typed{kind::real, 1.0f}));
    REQUIRE(decodes_to(bytes(9, 1, 2, 3), typed{kind::colour, rgb{1, 2, 3}}));
    REQUIRE(decodes_to(bytes(255), typed{kind::none, std::monostate{}}));
    require_exact_length<typed>(bytes(7, 0, 0, 0x80, 0x3F));
    require_exact_length<typed>(bytes(9, 1, 2, 3));
    require_exact_length<typed>(bytes(255));
}

TEST_CASE("a tag without a type neither decodes nor encodes") {
    both_ways([] { return decode_error<typed>(bytes(1, 0, 0)) == errc::unknown_tag; });
    both_ways([] { return encode_error(typed{static_cast<kind>(1), std::uint8_t{}}) == errc::unknown_tag; });
    CHECK(decode_error_in_arena<typed>(bytes(1, 0)) == errc::unknown_tag);
    CHECK(told(wire::diagnose<typed>(bytes(1, 0, 0))).starts_with("value at 1"));
}

TEST_CASE("a value of another type than its tag's does not encode") {
    both_ways([] { return encode_error(typed{kind::real, std::uint8_t{5}}) == errc::unknown_tag; });
    both_ways([] { return encode_error(typed{kind::none, std::uint8_t{5}}) == errc::unknown_tag; });
    CHECK(wire::diagnose(typed{kind::real, std::uint8_t{5}}).field == "value");
}

TEST_CASE("a tag selects the scale of a plain number") {
    both_ways([] { return encodes_to(measure{0, 100}, bytes(0, 255)); });
    both_ways([] { return encodes_to(measure{1, -100}, bytes(1, 0x01, 0x80)); });
    both_ways([] { return decodes_to(bytes(0, 255), measure{0, 100}); });
    both_ways([] { return decodes_to(bytes(1, 0xFF, 0x7F), measure{1, 100}); });
    both_ways([] { return encode_error(measure{0, -1}) == errc::out_of_range; });
    both_ways([] { return encode_error(measure{2, 0}) == errc::unknown_tag; });
    both_ways([] { return decode_error<measure>(bytes(1, 0x00, 0x80)) == errc::out_of_range; });
    require_exact_length<measure>(bytes(1, 0, 0));
}

TEST_CASE("in a raw message a selected number is the integer on the wire") {
    both_ways([] {
        wire::raw<measure> raw{};
        constexpr auto in = bytes(1, 0x00, 0x80); // no real value
        return wire::decode(raw, in) && static_cast<std::int16_t>(raw.get<&measure::value>()) == -32768 &&
               encodes_to(raw, in);
    });
}

TEST_CASE("a view reads the value by its tag") {
    constexpr auto in_float = bytes(7, 0, 0, 0x80, 0x3F);
    const wire::view<typed> view{in_float};
    REQUIRE(view);
    REQUIRE(view.get<&typed::value>());
    CHECK(std::get<float>(*view.get<&typed::value>()) == 1.0f);
    both_ways([] {
        const auto in = bytes(0, 255);
        return wire::view<measure>{in}.get<&measure::value>() == 100.0;
    });
    both_ways([] {
        const auto in = bytes(1, 0x00, 0x80);
        return !wire::view<measure>{in}.get<&measure::value>();
    });
}

TEST_CASE("a type that is not on the wire is set by the receiver") {
    both_ways([] { return encodes_to(agreed{kind::colour, rgb{1, 2, 3}}, bytes(1, 2, 3)); });
    agreed found{.kind = kind::colour};
    REQUIRE(wire::decode(found, bytes(1, 2, 3)));
    CHECK(found == agreed{kind::colour, rgb{1, 2, 3}});
    both_ways([] {
        agreed value{.kind = kind::colour};
        return wire::decode(value, bytes(1, 2)).error() == errc::truncated;
    });
    both_ways([] {
        agreed value{.kind = static_cast<kind>(4)};
        return wire::decode(value, bytes(1, 2)).error() == errc::unknown_tag;
    });
}

TEST_CASE("flags are named bits, and unnamed ones pass") {
    using samples::lamp;
    using samples::lamps;
    both_ways([] { return encodes_to(lamps{{lamp::left, lamp::top}}, bytes(0x80, 0x01)); });
    both_ways([] {
        lamps found{};
        return wire::decode(found, bytes(0x40, 0x02)) && found.lit.test(lamp::right) && !found.lit.test(lamp::left) &&
               found.lit.bits() == 0x4002 && encodes_to(found, bytes(0x40, 0x02)) &&
               found.lit.set(lamp::right, false).bits() == 0x4000;
    });
}
