// Messages inside messages, of fixed and of variable size.
#include "both_ways.hpp"
#include "samples.hpp"

using samples::envelope;
using samples::mixed;
using samples::point;
using wire::errc;

namespace {

struct segment {
    point from{};
    point to{};
    friend constexpr bool operator==(const segment&, const segment&) = default;
};

} // namespace

template <> struct jauscat::wire::schema<segment> {
    using type = layout<nested<&segment::from>, nested<&segment::to>>;
};

TEST_CASE("a fixed structure lies inside its message byte for byte") {
    both_ways([] {
        const segment value{.from = {.x = 0.0, .y = 100.0}, .to = {.x = 100.0, .y = 0.0}};
        const auto expected = bytes(0x00, 0x00, 0xFF, 0xFF, 0x7F, 0x00);
        return encodes_to(value, expected) && decodes_to(expected, value);
    });
    STATIC_REQUIRE(wire::fixed_message<segment>);
    STATIC_REQUIRE(wire::max_size<segment> == 6);
}

TEST_CASE("a variable structure moves what follows it") {
    both_ways([] {
        const envelope value{.kind = 0x0102, .content = {.number = 7}, .tail = 0xEE};
        const auto expected = bytes(0x01, 0x02, 0x00, 7, 0x00, 0x00, 0xEE);
        return encodes_to(value, expected) && decodes_to(expected, value);
    });
    both_ways([] {
        const envelope value{.kind = 0x0102, .content = {.number = 7, .level = 100.0, .id = 5}, .tail = 0xEE};
        const auto expected = bytes(0x01, 0x02, 0x05, 7, 0xFF, 0x00, 0x00, 5, 0, 0, 0, 0xEE);
        return encodes_to(value, expected) && decodes_to(expected, value);
    });
    STATIC_REQUIRE(wire::min_size<envelope> == 7);
    STATIC_REQUIRE(wire::max_size<envelope> == 15);
}

TEST_CASE("an error inside a structure is the message's error") {
    both_ways([] { return encode_error(segment{.to = {.x = 101.0}}) == errc::out_of_range; });
    both_ways([] { return decode_error<segment>(bytes(0, 0, 0, 0x00, 0x80, 0)) == errc::out_of_range; });
    both_ways([] { return encode_error(mixed{.place = point{.y = -1.0}}) == errc::out_of_range; });
    both_ways([] { return decode_error<mixed>(bytes(0x02, 7, 0, 0, 0x00, 0x80, 0)) == errc::out_of_range; });
    both_ways([] { return decode_error<envelope>(bytes(1, 2, 0x80, 7, 0, 0, 0xEE)) == errc::unknown_presence_bit; });
    both_ways([] { return decode_error<envelope>(bytes(1, 2, 0x01, 7, 0xFF, 0, 0)) == errc::truncated; });
}
