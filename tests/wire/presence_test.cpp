// Presence vectors: optional and required members, unknown bits.
#include "both_ways.hpp"
#include "samples.hpp"
#include "support/random_message.hpp"

using samples::mixed;
using samples::open;
using samples::with_spare_bits;
using wire::errc;

namespace {

/// As many optional members as its vector has bits.
struct full {
    std::optional<std::uint8_t> a{}, b{}, c{}, d{}, e{}, f{}, g{}, h{};
};

/// All bits of the widest vector, and a required member behind them.
struct widest {
    std::optional<std::uint8_t> m0{}, m1{}, m2{}, m3{}, m4{}, m5{}, m6{}, m7{}, m8{}, m9{}, m10{}, m11{}, m12{}, m13{},
        m14{}, m15{}, m16{}, m17{}, m18{}, m19{}, m20{}, m21{}, m22{}, m23{}, m24{}, m25{}, m26{}, m27{}, m28{}, m29{},
        m30{}, m31{}, m32{}, m33{}, m34{}, m35{}, m36{}, m37{}, m38{}, m39{}, m40{}, m41{}, m42{}, m43{}, m44{}, m45{},
        m46{}, m47{}, m48{}, m49{}, m50{}, m51{}, m52{}, m53{}, m54{}, m55{}, m56{}, m57{}, m58{}, m59{}, m60{}, m61{},
        m62{}, m63{};
    std::uint8_t last{};
    friend constexpr bool operator==(const widest&, const widest&) = default;
};

} // namespace

template <> struct jauscat::wire::schema<full> {
    using T = full;
    using type = layout<presence<u8, field<&T::a, u8>, field<&T::b, u8>, field<&T::c, u8>, field<&T::d, u8>,
                                 field<&T::e, u8>, field<&T::f, u8>, field<&T::g, u8>, field<&T::h, u8>>>;
};

template <> struct jauscat::wire::schema<widest> {
    using T = widest;
    template <auto Member> using octet = field<Member, u8>;
    using type =
        layout<presence<u64le, octet<&T::m0>, octet<&T::m1>, octet<&T::m2>, octet<&T::m3>, octet<&T::m4>, octet<&T::m5>,
                        octet<&T::m6>, octet<&T::m7>, octet<&T::m8>, octet<&T::m9>, octet<&T::m10>, octet<&T::m11>,
                        octet<&T::m12>, octet<&T::m13>, octet<&T::m14>, octet<&T::m15>, octet<&T::m16>, octet<&T::m17>,
                        octet<&T::m18>, octet<&T::m19>, octet<&T::m20>, octet<&T::m21>, octet<&T::m22>, octet<&T::m23>,
                        octet<&T::m24>, octet<&T::m25>, octet<&T::m26>, octet<&T::m27>, octet<&T::m28>, octet<&T::m29>,
                        octet<&T::m30>, octet<&T::m31>, octet<&T::m32>, octet<&T::m33>, octet<&T::m34>, octet<&T::m35>,
                        octet<&T::m36>, octet<&T::m37>, octet<&T::m38>, octet<&T::m39>, octet<&T::m40>, octet<&T::m41>,
                        octet<&T::m42>, octet<&T::m43>, octet<&T::m44>, octet<&T::m45>, octet<&T::m46>, octet<&T::m47>,
                        octet<&T::m48>, octet<&T::m49>, octet<&T::m50>, octet<&T::m51>, octet<&T::m52>, octet<&T::m53>,
                        octet<&T::m54>, octet<&T::m55>, octet<&T::m56>, octet<&T::m57>, octet<&T::m58>, octet<&T::m59>,
                        octet<&T::m60>, octet<&T::m61>, octet<&T::m62>, octet<&T::m63>, octet<&T::last>>>;
};

TEST_CASE("an item without a std::optional is always present and has no bit") {
    both_ways([] {
        const mixed value{.number = 7, .required = 0x0102};
        const auto expected = bytes(0x00, 7, 0x02, 0x01);
        return encodes_to(value, expected) && decodes_to(expected, value);
    });
}

TEST_CASE("each optional member sets its bit and is encoded at its position") {
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

TEST_CASE("all members together are encoded in layout order") {
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

TEST_CASE("decoding clears members that the vector does not announce") {
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
        REQUIRE(*used == size);
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
        REQUIRE(wire::encode(value, out)->size() == size);
        REQUIRE(equal(std::span{out}.first(size), std::span{in}.first(size)));
    }
}

TEST_CASE("a vector of 64 bits is used to its last bit") {
    both_ways([] {
        const widest value{
            .m0 = std::uint8_t{1}, .m31 = std::uint8_t{2}, .m32 = std::uint8_t{3}, .m63 = std::uint8_t{4}, .last = 5};
        const auto expected = bytes(0x01, 0, 0, 0x80, 0x01, 0, 0, 0x80, 1, 2, 3, 4, 5);
        const wire::view<widest> view{expected};
        return encodes_to(value, expected) && decodes_to(expected, value) && view.get<&widest::m32>() == 3 &&
               view.get<&widest::m63>() == 4 && !view.get<&widest::m33>() && view.get<&widest::last>() == 5;
    });
}

TEST_CASE("a bit that the layout does not define is refused") {
    both_ways([] { return decode_error<mixed>(bytes(0x08, 7, 0x02, 0x01)) == errc::unknown_presence_bit; });
    both_ways([] { return decode_error<mixed>(bytes(0x80, 7, 0x02, 0x01)) == errc::unknown_presence_bit; });
    both_ways([] { return decode_error<mixed>(bytes(0x09, 7, 0xFF, 0x02, 0x01)) == errc::unknown_presence_bit; });
}

TEST_CASE("a lenient presence vector ignores the bits that the layout does not define") {
    both_ways([] {
        return decodes_to(bytes(0xFF, 1, 0x02, 0x01, 9),
                          with_spare_bits{.first = std::uint8_t{1}, .second = std::uint16_t{0x0102}, .last = 9});
    });
    both_ways([] {
        return decodes_to(bytes(0xFE, 0x02, 0x01, 9), with_spare_bits{.second = std::uint16_t{0x0102}, .last = 9});
    });
    both_ways([] { return decodes_to(bytes(0x80, 9), with_spare_bits{.last = 9}); });
    // Bytes that the bits may stand for are not dropped.
    both_ways(
        [] { return decode_error<with_spare_bits>(bytes(0xFF, 1, 0x02, 0x01, 0xAA, 9)) == errc::trailing_bytes; });
    both_ways([] { return decode_error<with_spare_bits>(bytes(0xFF, 1, 0x02, 0x01)) == errc::truncated; });
    both_ways([] {
        const auto in = bytes(0xFD, 1, 9);
        const wire::view<with_spare_bits> view{in};
        return view.get<&with_spare_bits::first>() == 1 && !view.get<&with_spare_bits::second>() &&
               view.get<&with_spare_bits::last>() == 9;
    });
    both_ways([] { return encodes_to(with_spare_bits{.first = std::uint8_t{1}, .last = 9}, bytes(0x01, 1, 9)); });
}

TEST_CASE("an open presence vector drops unknown bits and the bytes after the known fields") {
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
        REQUIRE(wire::decode(value, *written));
        REQUIRE(wire::encode(value, second)->size() == written->size());
        REQUIRE(first == second);
        REQUIRE(decodes_to(*written, value));
    }
}
