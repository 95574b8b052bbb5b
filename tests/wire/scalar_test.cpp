// Codecs of single values: literal bytes, both byte orders.
#include "both_ways.hpp"
#include "samples.hpp"

#include <limits>

namespace {

using wire::errc;

/// `value` is stored as `expected`, and `expected` loads as `value`.
template <wire::codec Codec, std::size_t N>
constexpr bool carries(typename Codec::value_type value, const std::array<std::byte, N>& expected) {
    static_assert(N == Codec::size);
    std::array<std::byte, N> out{};
    typename Codec::value_type loaded{};
    return Codec::store(out.data(), value) == errc::ok && out == expected &&
           Codec::load(expected.data(), loaded) == errc::ok && loaded == value;
}

} // namespace

TEST_CASE("integers of 8 bits are encoded unchanged") {
    both_ways([] { return carries<wire::u8>(0xA5, bytes(0xA5)); });
    both_ways([] { return carries<wire::i8>(-2, bytes(0xFE)); });
    both_ways([] { return carries<wire::i8>(std::numeric_limits<std::int8_t>::min(), bytes(0x80)); });
}

TEST_CASE("integers of 16 bits are encoded in either byte order") {
    both_ways([] { return carries<wire::u16le>(0x1234, bytes(0x34, 0x12)); });
    both_ways([] { return carries<wire::u16be>(0x1234, bytes(0x12, 0x34)); });
    both_ways([] { return carries<wire::i16le>(-2, bytes(0xFE, 0xFF)); });
    both_ways([] { return carries<wire::i16be>(-2, bytes(0xFF, 0xFE)); });
}

TEST_CASE("integers of 32 bits are encoded in either byte order") {
    both_ways([] { return carries<wire::u32le>(0x12345678, bytes(0x78, 0x56, 0x34, 0x12)); });
    both_ways([] { return carries<wire::u32be>(0x12345678, bytes(0x12, 0x34, 0x56, 0x78)); });
    both_ways([] { return carries<wire::i32le>(-2, bytes(0xFE, 0xFF, 0xFF, 0xFF)); });
    both_ways([] { return carries<wire::i32be>(-2, bytes(0xFF, 0xFF, 0xFF, 0xFE)); });
}

TEST_CASE("integers of 64 bits are encoded in either byte order") {
    both_ways(
        [] { return carries<wire::u64le>(0x0123456789ABCDEF, bytes(0xEF, 0xCD, 0xAB, 0x89, 0x67, 0x45, 0x23, 0x01)); });
    both_ways(
        [] { return carries<wire::u64be>(0x0123456789ABCDEF, bytes(0x01, 0x23, 0x45, 0x67, 0x89, 0xAB, 0xCD, 0xEF)); });
    both_ways([] {
        return carries<wire::i64le>(std::numeric_limits<std::int64_t>::min(), bytes(0, 0, 0, 0, 0, 0, 0, 0x80));
    });
    both_ways([] { return carries<wire::i64be>(-2, bytes(0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFE)); });
}

TEST_CASE("floating point is encoded as IEEE 754 in either byte order") {
    both_ways([] { return carries<wire::f32le>(1.5f, bytes(0x00, 0x00, 0xC0, 0x3F)); });
    both_ways([] { return carries<wire::f32be>(1.5f, bytes(0x3F, 0xC0, 0x00, 0x00)); });
    both_ways([] { return carries<wire::f64le>(-2.0, bytes(0, 0, 0, 0, 0, 0, 0x00, 0xC0)); });
    both_ways([] { return carries<wire::f64be>(-2.0, bytes(0xC0, 0x00, 0, 0, 0, 0, 0, 0)); });
    both_ways([] {
        return carries<wire::f64le>(std::numeric_limits<double>::infinity(), bytes(0, 0, 0, 0, 0, 0, 0xF0, 0x7F));
    });
}

TEST_CASE("a NaN keeps its payload") {
    both_ways([] {
        const auto quiet = bytes(0x01, 0x00, 0xC0, 0x7F);
        float value{};
        std::array<std::byte, 4> out{};
        return wire::f32le::load(quiet.data(), value) == errc::ok && value != value &&
               wire::f32le::store(out.data(), value) == errc::ok && out == quiet;
    });
    both_ways([] {
        const auto quiet = bytes(0xFF, 0xF8, 0, 0, 0, 0, 0, 0x2A);
        double value{};
        std::array<std::byte, 8> out{};
        return wire::f64be::load(quiet.data(), value) == errc::ok && value != value &&
               wire::f64be::store(out.data(), value) == errc::ok && out == quiet;
    });
}

TEST_CASE("an enumeration is encoded as its integer, and unnamed values pass") {
    using colours = wire::enumeration<samples::colour, wire::u8>;
    using faults = wire::enumeration<samples::fault, wire::u16be>;
    both_ways([] { return carries<colours>(samples::colour::green, bytes(2)); });
    both_ways([] { return carries<colours>(static_cast<samples::colour>(0xEE), bytes(0xEE)); });
    both_ways([] { return carries<faults>(samples::fault::overheated, bytes(0x12, 0x34)); });
    both_ways([] { return carries<faults>(static_cast<samples::fault>(0xFFFE), bytes(0xFF, 0xFE)); });
}

TEST_CASE("octets keep their order") {
    both_ways([] { return carries<wire::octets<3>>(bytes(0x0A, 0xFF, 0x01), bytes(0x0A, 0xFF, 0x01)); });
}

TEST_CASE("fields of a message are encoded without padding") {
    both_ways([] {
        const samples::scalars value{.small = 0x7F,
                                     .little = -2,
                                     .big = 0x12345678,
                                     .single_precision = 1.5f,
                                     .shade = static_cast<samples::colour>(9),
                                     .error = samples::fault::overheated,
                                     .station = bytes(1, 2, 3, 4, 5, 6)};
        const auto expected =
            bytes(0x7F, 0xFE, 0xFF, 0x12, 0x34, 0x56, 0x78, 0x00, 0x00, 0xC0, 0x3F, 9, 0x34, 0x12, 1, 2, 3, 4, 5, 6);
        return encodes_to(value, expected) && decodes_to(expected, value);
    });
    STATIC_REQUIRE(wire::min_size<samples::scalars> == 20);
    STATIC_REQUIRE(wire::max_size<samples::scalars> == 20);
    STATIC_REQUIRE(wire::fixed_message<samples::scalars>);
}

TEST_CASE("a message without fields has no bytes") {
    both_ways(
        [] { return encodes_to(samples::empty{}, {}) && decodes_to(std::span<const std::byte>{}, samples::empty{}); });
    both_ways([] { return decode_error<samples::empty>(bytes(0)) == errc::trailing_bytes; });
    both_ways([] {
        const auto in = bytes(1, 2);
        samples::empty value{};
        const auto used = wire::decode_prefix(value, in);
        return used && *used == 0;
    });
    STATIC_REQUIRE(wire::max_size<samples::empty> == 0);
}
