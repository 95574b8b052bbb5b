// Presence vectors: optional and required members, unknown bits.
#include "both_ways.hpp"
#include "samples.hpp"
#include "support/random_message.hpp"

using samples::mixed;
using samples::open;
using wire::errc;

namespace {

/// As many optional members as its vector has bits.
struct full {
    std::optional<std::uint8_t> a{}, b{}, c{}, d{}, e{}, f{}, g{}, h{};
};

} // namespace

template <> struct jauscat::wire::schema<full> {
    using T = full;
    using type = layout<presence<u8, field<&T::a, u8>, field<&T::b, u8>, field<&T::c, u8>, field<&T::d, u8>,
                                 field<&T::e, u8>, field<&T::f, u8>, field<&T::g, u8>, field<&T::h, u8>>>;
};

TEST_CASE("an item without a std::optional is always there and takes no bit") {
    both_ways([] {
        const mixed value{.number = 7, .required = 0x0102};
        const auto expected = bytes(0x00, 7, 0x02, 0x01);
        return encodes_to(value, expected) && decodes_to(expected, value);
    });
}

TEST_CASE("each optional member sets its bit and stands at its place") {
    both_ways([] {
        const mixed value{.number = 7, .level = 100.0, .required = 0x0102};
        const auto expected = bytes(0x01, 7, 0xFF, 0x02, 0x01);
        return encodes_to(value, expected) && decodes_to(expected, value);
    });
    both_ways([] {
        const mixed value{.number = 7, .required = 0x0102, .place = samples::point{.x = -100.0, .y = 0.0}};
        const auto expected = bytes(0x02, 7, 0x02, 0x01, 0x01, 0x80, 0x00);
        return encodes_to(value, expected) && decodes_to(expected, value);
    });
    both_ways([] {
        const mixed value{.number = 7, .required = 0x0102, .id = 0xAABBCCDD};
        const auto expected = bytes(0x04, 7, 0x02, 0x01, 0xDD, 0xCC, 0xBB, 0xAA);
        return encodes_to(value, expected) && decodes_to(expected, value);
    });
}

TEST_CASE("all members together stand in the order of the layout") {
    both_ways([] {
        const mixed value{
            .number = 7, .level = 0.0, .required = 0x0102, .place = samples::point{.x = 100.0, .y = 100.0}, .id = 1};
        const auto expected = bytes(0x07, 7, 0x00, 0x02, 0x01, 0xFF, 0x7F, 0xFF, 0x01, 0x00, 0x00, 0x00);
        return encodes_to(value, expected) && decodes_to(expected, value);
    });
    STATIC_REQUIRE(wire::min_size<mixed> == 4);
    STATIC_REQUIRE(wire::max_size<mixed> == 12);
    STATIC_REQUIRE(!wire::fixed_message<mixed>);
}

TEST_CASE("decoding clears what the vector does not announce") {
    both_ways([] {
        mixed value{.level = 1.0, .place = samples::point{}, .id = 3};
        return wire::decode(value, bytes(0x00, 7, 0x02, 0x01)) && !value.level && !value.place && !value.id;
    });
}

TEST_CASE("every presence vector of eight fields decodes to those fields and encodes again") {
    for (unsigned mask = 0; mask <= 0xFF; ++mask) {
        std::array<std::byte, 9> in{}, out{};
        in[0] = static_cast<std::byte>(mask);
        const auto size = 1 + static_cast<std::size_t>(std::popcount(mask));
        for (std::size_t i = 1; i != 9; ++i) in[i] = static_cast<std::byte>(0x10 + i);
        full value{};
        const auto used = wire::decode(value, std::span{in}.first(size));
        REQUIRE(used);
        REQUIRE(used.size() == size);
        unsigned found = 0, at = 0;
        std::uint8_t next = 0x11;
        bool in_order = true;
        wire::visit(value, [&](auto, auto& member) {
            if (member) {
                found |= 1u << at;
                in_order = in_order && *member == next++;
            }
            ++at;
        });
        REQUIRE(found == mask);
        REQUIRE(in_order);
        REQUIRE(wire::encode(value, out).size() == size);
        REQUIRE(equal(std::span{out}.first(size), std::span{in}.first(size)));
    }
}

TEST_CASE("a bit that the layout does not define is refused") {
    both_ways([] { return decode_error<mixed>(bytes(0x08, 7, 0x02, 0x01)) == errc::unknown_presence_bit; });
    both_ways([] { return decode_error<mixed>(bytes(0x80, 7, 0x02, 0x01)) == errc::unknown_presence_bit; });
    both_ways([] { return decode_error<mixed>(bytes(0x09, 7, 0xFF, 0x02, 0x01)) == errc::unknown_presence_bit; });
}

TEST_CASE("an open presence vector drops unknown bits and the bytes behind the known fields") {
    both_ways([] {
        return decodes_to(bytes(0x03, 1, 0x02, 0x01), open{.first = std::uint8_t{1}, .second = std::uint16_t{0x0102}});
    });
    both_ways([] { return decodes_to(bytes(0x06, 0x02, 0x01, 0xAA, 0xBB), open{.second = std::uint16_t{0x0102}}); });
    both_ways([] { return decodes_to(bytes(0x81, 1), open{.first = std::uint8_t{1}}); });
    both_ways([] { return decode_error<open>(bytes(0x01, 1, 0xAA)) == errc::trailing_bytes; });
    both_ways([] { return decode_error<open>(bytes(0x82, 1)) == errc::truncated; });
    both_ways([] { return encodes_to(open{.first = std::uint8_t{1}}, bytes(0x01, 1)); });
}

TEST_CASE("random presence vectors survive encode and decode") {
    support::generator random{1};
    for (int round = 0; round != 2000; ++round) {
        // Through one encoding first: real values become what their raw values stand for.
        std::array<std::byte, wire::max_size<mixed>> first{}, second{};
        const auto written = wire::encode(support::random_message<mixed>(random), first);
        REQUIRE(written);
        mixed value{};
        REQUIRE(wire::decode(value, std::span{first}.first(written.size())));
        REQUIRE(wire::encode(value, second).size() == written.size());
        REQUIRE(first == second);
        REQUIRE(decodes_to(std::span{second}.first(written.size()), value));
    }
}
