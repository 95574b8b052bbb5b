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

/// Four octets in the order of memory, in another order, and as integers in either byte order.
struct octets_4 {
    std::uint8_t a{}, b{}, c{}, d{};
    friend constexpr bool operator==(const octets_4&, const octets_4&) = default;
};
struct turned {
    std::uint8_t a{}, b{}, c{}, d{};
    friend constexpr bool operator==(const turned&, const turned&) = default;
};
struct words {
    std::uint16_t little{}, big{};
    friend constexpr bool operator==(const words&, const words&) = default;
};
struct little_words {
    std::uint16_t a{}, b{};
    friend constexpr bool operator==(const little_words&, const little_words&) = default;
};
struct all_orders {
    octets_4 straight{};
    turned back{};
    words mixed_order{};
    std::optional<little_words> optional{};
    friend constexpr bool operator==(const all_orders&, const all_orders&) = default;
};

} // namespace

template <> struct jauscat::wire::schema<octets_4> {
    using T = octets_4;
    using type = layout<field<&T::a, u8>, field<&T::b, u8>, field<&T::c, u8>, field<&T::d, u8>>;
};
template <> struct jauscat::wire::schema<turned> {
    using T = turned;
    using type = layout<field<&T::d, u8>, field<&T::c, u8>, field<&T::b, u8>, field<&T::a, u8>>;
};
template <> struct jauscat::wire::schema<words> {
    using type = layout<field<&words::little, u16le>, field<&words::big, u16be>>;
};
template <> struct jauscat::wire::schema<little_words> {
    using type = layout<field<&little_words::a, u16le>, field<&little_words::b, u16le>>;
};
template <> struct jauscat::wire::schema<all_orders> {
    using T = all_orders;
    using type =
        layout<nested<&T::straight>, nested<&T::back>, nested<&T::mixed_order>, presence<u8, nested<&T::optional>>>;
};

template <> struct jauscat::wire::schema<segment> {
    using type = layout<nested<&segment::from>, nested<&segment::to>>;
};

TEST_CASE("a fixed structure is embedded in its message byte for byte") {
    both_ways([] {
        const segment value{.from = {.x = 0.0, .y = 100.0}, .to = {.x = 100.0, .y = 0.0}};
        const auto expected = bytes(0x00, 0x00, 0xFF, 0xFF, 0x7F, 0x00);
        return encodes_to(value, expected) && decodes_to(expected, value);
    });
    STATIC_REQUIRE(wire::fixed_message<segment>);
    STATIC_REQUIRE(wire::max_size<segment> == 6);
}

TEST_CASE("a structure has the order of its layout, whatever the order in memory") {
    both_ways([] {
        const all_orders value{.straight = {.a = 1, .b = 2, .c = 3, .d = 4},
                               .back = {.a = 5, .b = 6, .c = 7, .d = 8},
                               .mixed_order = {.little = 0x0A09, .big = 0x0B0C},
                               .optional = little_words{.a = 0x0E0D, .b = 0x100F}};
        const auto expected = bytes(1, 2, 3, 4, 8, 7, 6, 5, 0x09, 0x0A, 0x0B, 0x0C, 0x01, 0x0D, 0x0E, 0x0F, 0x10);
        return encodes_to(value, expected) && decodes_to(expected, value);
    });
    both_ways([] {
        const auto in = bytes(1, 2, 3, 4, 8, 7, 6, 5, 0x09, 0x0A, 0x0B, 0x0C, 0x01, 0x0D, 0x0E, 0x0F, 0x10);
        wire::raw<all_orders> raw{};
        return wire::decode(raw, in) && raw.get<&all_orders::straight>().get<&octets_4::d>() == 4 &&
               raw.get<&all_orders::optional>()->get<&little_words::b>() == 0x100F && encodes_to(raw, in);
    });
}

TEST_CASE("a structure of variable size shifts the fields after it") {
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
