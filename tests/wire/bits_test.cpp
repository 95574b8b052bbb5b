// Bit-fields of one integer.
#include "array_samples.hpp"
#include "both_ways.hpp"
#include "support/random_message.hpp"

using samples::colour;
using samples::flags;
using samples::trims;
using wire::errc;

namespace {

/// A carrier of 64 bits, big endian, with widths on both sides of 32.
struct wide {
    std::uint64_t high{};
    std::uint8_t low{};
    friend constexpr bool operator==(const wide&, const wide&) = default;
};
/// Signed members, one that takes all bits of its type, in a carrier of 64 bits.
struct signed_wide {
    std::int8_t all{};
    std::int64_t long_one{};  ///< 40 bits
    std::int16_t short_one{}; ///< 1 bit: 0 or -1
    friend constexpr bool operator==(const signed_wide&, const signed_wide&) = default;
};
/// One member that fills its carrier.
struct whole {
    std::uint64_t all{};
    friend constexpr bool operator==(const whole&, const whole&) = default;
};

} // namespace

template <> struct jauscat::wire::schema<wide> {
    using type = layout<bit_fields<u64be, bit_field<&wide::low, 3>, reserved<9>, bit_field<&wide::high, 52>>>;
};
template <> struct jauscat::wire::schema<signed_wide> {
    using T = signed_wide;
    using type = layout<bit_fields<u64be, bit_field<&T::short_one, 1>, bit_field<&T::long_one, 40>,
                                   bit_field<&T::all, 8>, reserved<15>>>;
};
template <> struct jauscat::wire::schema<whole> {
    using type = layout<bit_fields<u64le, bit_field<&whole::all, 64>>>;
};

TEST_CASE("bit-fields fill their carrier from the least significant bit") {
    both_ways([] { return encodes_to(flags{.length = 0x7FF}, bytes(0xFF, 0x07)); });
    both_ways([] { return encodes_to(flags{.length = 1}, bytes(0x01, 0x00)); });
    both_ways([] { return encodes_to(flags{.shade = colour::green}, bytes(0x00, 0x20)); });
    both_ways([] { return encodes_to(flags{.circulating = true}, bytes(0x00, 0x40)); });
    both_ways([] {
        const flags value{.length = 0x123, .circulating = true, .shade = static_cast<colour>(3)};
        return encodes_to(value, bytes(0x23, 0x71)) && decodes_to(bytes(0x23, 0x71), value);
    });
}

TEST_CASE("bit-fields cross the middle of a 64-bit carrier") {
    both_ways([] {
        const wide value{.high = 0xFEDCBA9876543, .low = 5};
        const auto expected = bytes(0xFE, 0xDC, 0xBA, 0x98, 0x76, 0x54, 0x30, 0x05);
        return encodes_to(value, expected) && decodes_to(expected, value);
    });
    both_ways([] {
        const whole value{.all = 0x8123456789ABCDEF};
        const auto expected = bytes(0xEF, 0xCD, 0xAB, 0x89, 0x67, 0x45, 0x23, 0x81);
        return encodes_to(value, expected) && decodes_to(expected, value);
    });
}

TEST_CASE("a value wider than its bits does not encode") {
    both_ways([] { return encode_error(flags{.length = 0x7FF}) == errc::ok; });
    both_ways([] { return encode_error(flags{.length = 0x800}) == errc::out_of_range; });
    both_ways([] { return encode_error(flags{.shade = static_cast<colour>(4)}) == errc::out_of_range; });
    both_ways([] { return encode_error(wide{.low = 7}) == errc::ok; });
    both_ways([] { return encode_error(wide{.low = 8}) == errc::out_of_range; });
    both_ways([] { return encode_error(wide{.high = std::uint64_t{1} << 52}) == errc::out_of_range; });
}

TEST_CASE("reserved bits are sent as zero and ignored on receipt") {
    both_ways([] { return decodes_to(bytes(0x01, 0x88), flags{.length = 1}); });
    both_ways([] {
        flags value{};
        std::array<std::byte, 2> out{};
        return wire::decode(value, bytes(0x01, 0x88)) && wire::encode(value, out) && equal(out, bytes(0x01, 0x00));
    });
}

TEST_CASE("every pattern of a bit-field's carrier decodes, and encodes without its reserved bits") {
    for (unsigned pattern = 0; pattern <= 0xFFFF; ++pattern) {
        std::array<std::byte, 2> in{}, expected{}, out{};
        wire::u16le::store(in.data(), static_cast<std::uint16_t>(pattern));
        wire::u16le::store(expected.data(), static_cast<std::uint16_t>(pattern & 0x77FF));
        flags value{};
        const bool ok = wire::decode(value, in) && wire::encode(value, out) && out == expected;
        if (!ok) FAIL("pattern " << pattern);
    }
}

TEST_CASE("signed bit-fields are in two's complement of their width") {
    both_ways([] {
        const trims value{.pitch = -1, .locked = true, .heading = -256};
        const auto expected = bytes(0x3F, 0x80);
        return encodes_to(value, expected) && decodes_to(expected, value);
    });
    both_ways([] {
        const trims value{.pitch = -16, .heading = 255};
        const auto expected = bytes(0x90, 0x7F);
        return encodes_to(value, expected) && decodes_to(expected, value);
    });
    both_ways([] { return encodes_to(trims{.pitch = 15, .heading = 1}, bytes(0x8F, 0x00)); });
    both_ways([] { return decodes_to(bytes(0x40, 0x00), trims{}); }); // reserved
    both_ways([] {
        const signed_wide value{.all = -128, .long_one = -0x8000000000, .short_one = -1};
        const auto expected = bytes(0, 0x01, 0x01, 0, 0, 0, 0, 0x01);
        return encodes_to(value, expected) && decodes_to(expected, value);
    });
}

TEST_CASE("a signed value beyond its bits does not encode") {
    both_ways([] { return encode_error(trims{.pitch = 16}) == errc::out_of_range; });
    both_ways([] { return encode_error(trims{.pitch = -17}) == errc::out_of_range; });
    both_ways([] { return encode_error(trims{.heading = 256}) == errc::out_of_range; });
    both_ways([] { return encode_error(trims{.heading = -257}) == errc::out_of_range; });
    both_ways([] { return encode_error(trims{.heading = 0x7FFFFFFF}) == errc::out_of_range; });
    both_ways([] { return encode_error(signed_wide{.short_one = 1}) == errc::out_of_range; });
    both_ways([] { return encode_error(signed_wide{.short_one = -2}) == errc::out_of_range; });
    both_ways([] { return encode_error(signed_wide{.long_one = 0x8000000000}) == errc::out_of_range; });
    both_ways([] { return encode_error(signed_wide{.all = -128}) == errc::ok; });
    constexpr auto why = wire::diagnose(trims{.pitch = -16, .heading = -257});
    STATIC_REQUIRE(why.error == errc::out_of_range);
    CHECK(why.field == "heading");
}

TEST_CASE("a view and a raw read signed bit-fields") {
    both_ways([] {
        const auto in = bytes(0x30, 0x80);
        const wire::view<trims> view{in};
        wire::raw<trims> raw{};
        return view.get<&trims::pitch>() == -16 && view.get_raw<&trims::heading>() == -256 &&
               view.get<&trims::locked>() && wire::decode(raw, in) && raw.get<&trims::pitch>() == -16 &&
               encodes_to(raw, in);
    });
}

TEST_CASE("every pattern of signed bit-fields decodes, and encodes without its reserved bits") {
    for (unsigned pattern = 0; pattern <= 0xFFFF; ++pattern) {
        std::array<std::byte, 2> in{}, expected{}, out{};
        wire::u16le::store(in.data(), static_cast<std::uint16_t>(pattern));
        wire::u16le::store(expected.data(), static_cast<std::uint16_t>(pattern & 0xFFBF));
        trims value{};
        const bool ok = wire::decode(value, in) && wire::encode(value, out) && out == expected && value.pitch >= -16 &&
                        value.pitch <= 15 && value.heading >= -256 && value.heading <= 255;
        if (!ok) FAIL("pattern " << pattern);
    }
}

TEST_CASE("random signed bit-fields survive a round trip, or are refused") {
    support::generator random{33};
    int refused = 0;
    for (int round = 0; round != 2000; ++round) {
        const auto value = support::random_message<signed_wide>(random, {.illegal = 0.1});
        std::array<std::byte, 8> out{};
        const bool fits = value.long_one >= -(std::int64_t{1} << 39) && value.long_one < std::int64_t{1} << 39 &&
                          (value.short_one == 0 || value.short_one == -1);
        const auto written = wire::encode(value, out);
        REQUIRE(static_cast<bool>(written) == fits);
        refused += !fits;
        if (fits) REQUIRE(decodes_to(out, value));
    }
    REQUIRE(refused > 100);
}
