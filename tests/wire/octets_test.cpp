// Text and bytes of every length.
#include "list_checks.hpp"

using samples::labels;
using samples::lenient;

namespace {

constexpr labels filled{.fixed = "ab", .terminated = "cd", .counted = "efg", .rest = "hi"};
constexpr auto filled_bytes = bytes('a', 'b', 0, 0, 'c', 'd', 0, 3, 'e', 'f', 'g', 'h', 'i');

template <wire::message T> T decoded(std::span<const std::byte> in) {
    T value{};
    REQUIRE(*wire::decode(value, in) == in.size());
    return value;
}

} // namespace

TEST_CASE("text is padded, zero-terminated, counted, or ended by the body") {
    both_ways([] { return encodes_to(filled, filled_bytes); });
    both_ways([] { return encodes_to(labels{}, bytes(0, 0, 0, 0, 0, 0)); });
    CHECK(decoded<labels>(filled_bytes) == filled);
    CHECK(decoded<labels>(bytes(0, 0, 0, 0, 0, 0)) == labels{});
    CHECK(decoded<labels>(bytes('a', 'b', 'c', 'd', 0, 0)).fixed == "abcd");
    // Zeros inside and counted ones are part of the value.
    CHECK(decoded<labels>(bytes(0, 'b', 0, 0, 0, 1, 0, 0)) ==
          labels{.fixed = {"\0b", 2}, .counted = {"\0", 1}, .rest = {"\0", 1}});
}

TEST_CASE("text points into the received bytes") {
    const auto value = decoded<labels>(filled_bytes);
    CHECK(static_cast<const void*>(value.counted.data()) == filled_bytes.data() + 8);
}

TEST_CASE("text that ends before its length, its zero or its padding is truncated") {
    for (std::size_t size = 0; size != 11; ++size) {
        CAPTURE(size);
        CHECK(decode_error<labels>(std::span{filled_bytes}.first(size)) == errc::truncated);
        CHECK(wire::view<labels>{std::span{filled_bytes}.first(size)}.error() == errc::truncated);
    }
    CHECK(decoded<labels>(std::span{filled_bytes}.first(11)).rest.empty());
    CHECK(told(wire::diagnose<labels>(std::span{filled_bytes}.first(3))) == "fixed at 0 needs 4, has 3");
    CHECK(told(wire::diagnose<labels>(std::span{filled_bytes}.first(6))) == "terminated at 4 needs 3, has 2");
    CHECK(told(wire::diagnose<labels>(std::span{filled_bytes}.first(7))) == "number_of_characters at 7 needs 1, has 0");
    CHECK(told(wire::diagnose<labels>(std::span{filled_bytes}.first(10))) == "counted at 8 needs 3, has 2");
}

TEST_CASE("text that exceeds its field does not encode") {
    both_ways([] { return encode_error(labels{.fixed = "abcde"}) == errc::out_of_range; });
    both_ways([] { return encode_error(labels{.terminated = {"a\0b", 3}}) == errc::out_of_range; });
    both_ways([] { return encode_error(lenient{.text = "abcdefg"}) == errc::out_of_range; });
    CHECK(told(wire::diagnose(labels{.fixed = "abcde"})) == "fixed at 0 needs 4, has 0");
    CHECK(told(wire::diagnose(labels{.terminated = {"a\0b", 3}})) == "terminated at 4 needs 0, has 0");
    const std::string long_one(256, 'x');
    CHECK(encode_error(labels{.counted = long_one}) == errc::count_above_capacity);
    CHECK(told(wire::diagnose(labels{.counted = long_one})) == "number_of_characters at 5 needs 1, has 0");
}

TEST_CASE("lenient text is sent with its own padding and received with any") {
    both_ways([] { return encodes_to(lenient{.id = 1, .text = "abc"}, bytes(1, 'a', 'b', 'c', 0, 0, 0)); });
    const lenient abc{.id = 1, .text = "abc"};
    CHECK(decoded<lenient>(bytes(1, 'a', 'b', 'c')) == abc);
    CHECK(decoded<lenient>(bytes(1, 'a', 'b', 'c', 0)) == abc);
    CHECK(decoded<lenient>(bytes(1, 'a', 'b', 'c', 0, 0, 0, 0, 0)) == abc);
    CHECK(decoded<lenient>(bytes(1)) == lenient{.id = 1});
    CHECK(decoded<lenient>(bytes(1, 'a', 'b', 'c', 'd', 'e', 'f', 'g')).text == "abcdefg");
    CHECK(decode_error<lenient>({}) == errc::truncated);
}

TEST_CASE("a view shows text and bytes in place") {
    const wire::view<labels> view{filled_bytes};
    REQUIRE(view);
    CHECK(view.get<&labels::fixed>() == "ab");
    CHECK(view.get<&labels::terminated>() == "cd");
    CHECK(view.get<&labels::counted>() == "efg");
    CHECK(view.get<&labels::rest>() == "hi");
    constexpr auto in = bytes(1, 'a', 0);
    CHECK(wire::view<lenient>{in}.get<&lenient::text>() == "a");
    both_ways([] {
        const auto received = bytes(0x02, 0x00, 0xAA, 0xBB, 9);
        const wire::view<samples::parcel> seen{received};
        return seen && equal(seen.get<&samples::parcel::body>(), bytes(0xAA, 0xBB)) &&
               seen.get<&samples::parcel::tail>() == 9;
    });
}
