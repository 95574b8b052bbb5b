// Scaled integers: literal values, limits, ties, and every raw value that can be tried.
#include "both_ways.hpp"
#include "samples.hpp"
#include "support/random_message.hpp"
#include <jauscat/schema/jaus/types.hpp>

#include <cmath>
#include <limits>

namespace {

namespace jaus = jauscat::jaus;
using samples::percent;
using samples::signed_percent;
using wire::errc;

template <class Codec> constexpr bool stores(double real, typename Codec::raw_type raw) {
    std::array<std::byte, Codec::size> out{}, expected{};
    Codec::raw_codec::store(expected.data(), raw);
    return Codec::store(out.data(), real) == errc::ok && out == expected;
}
template <class Codec> constexpr bool loads(typename Codec::raw_type raw, double real) {
    std::array<std::byte, Codec::size> in{};
    Codec::raw_codec::store(in.data(), raw);
    double loaded{};
    return Codec::load(in.data(), loaded) == errc::ok && loaded == real;
}
template <class Codec> constexpr errc store_error(double real) {
    std::array<std::byte, Codec::size> out{};
    return Codec::store(out.data(), real);
}
template <class Codec> constexpr errc load_error(typename Codec::raw_type raw) {
    std::array<std::byte, Codec::size> in{};
    Codec::raw_codec::store(in.data(), raw);
    double loaded{};
    return Codec::load(in.data(), loaded);
}

/// The raw value comes back, and its real value keeps the codec's own limits.
template <class Codec> bool survives(typename Codec::raw_type raw) {
    std::array<std::byte, Codec::size> in{}, out{};
    Codec::raw_codec::store(in.data(), raw);
    double real{};
    return Codec::load(in.data(), real) == errc::ok && real >= Codec::lowest && real <= Codec::highest &&
           Codec::store(out.data(), real) == errc::ok && in == out;
}
/// All raw values of 8 and 16 bits.
template <class Codec> void all_survive() {
    for (std::int32_t raw = Codec::bottom; raw <= Codec::top; ++raw)
        if (!survives<Codec>(static_cast<typename Codec::raw_type>(raw))) FAIL("raw value " << raw);
}
/// Both ends, what lies beside them, and many between.
template <class Codec> void many_survive() {
    using raw_type = typename Codec::raw_type;
    support::generator random{4};
    std::uniform_int_distribution<raw_type> any{Codec::bottom, Codec::top};
    for (raw_type i = 0; i != 1000; ++i) {
        if (!survives<Codec>(static_cast<raw_type>(Codec::bottom + i))) FAIL("raw value bottom + " << i);
        if (!survives<Codec>(static_cast<raw_type>(Codec::top - i))) FAIL("raw value top - " << i);
    }
    for (int i = 0; i != 50000; ++i) {
        const auto raw = any(random);
        if (!survives<Codec>(raw)) FAIL("raw value " << raw);
    }
}

template <class Range> using as_u8 = wire::scaled<wire::u8, Range>;
template <class Range> using as_i8 = wire::scaled<wire::i8, Range>;
template <class Range> using as_u16 = wire::scaled<wire::u16le, Range>;
template <class Range> using as_i16 = wire::scaled<wire::i16le, Range>;
template <class Range> using as_u32 = wire::scaled<wire::u32le, Range>;
template <class Range> using as_i32 = wire::scaled<wire::i32le, Range>;
template <class Range> using as_u64 = wire::scaled<wire::u64le, Range>;
template <class Range> using as_i64 = wire::scaled<wire::i64be, Range>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

} // namespace

TEST_CASE("the ends of a range are encoded as the ends of the carrier") {
    both_ways([] { return stores<as_u8<percent>>(0.0, 0) && stores<as_u8<percent>>(100.0, 255); });
    both_ways([] { return stores<as_i8<signed_percent>>(-100.0, -127) && stores<as_i8<signed_percent>>(100.0, 127); });
    both_ways([] { return stores<as_u16<percent>>(0.0, 0) && stores<as_u16<percent>>(100.0, 0xFFFF); });
    both_ways(
        [] { return stores<as_i16<signed_percent>>(-100.0, -32767) && stores<as_i16<signed_percent>>(100.0, 32767); });
    both_ways([] { return stores<as_u32<percent>>(0.0, 0) && stores<as_u32<percent>>(100.0, 0xFFFFFFFF); });
    both_ways([] {
        return stores<as_i32<signed_percent>>(-100.0, -2147483647) && stores<as_i32<signed_percent>>(100.0, 2147483647);
    });
    both_ways([] { return stores<as_u64<percent>>(0.0, 0) && stores<as_u64<percent>>(100.0, 0xFFFFFFFFFFFFFFFF); });
    both_ways([] {
        return stores<as_i64<signed_percent>>(-100.0, -0x7FFFFFFFFFFFFFFF) &&
               stores<as_i64<signed_percent>>(100.0, 0x7FFFFFFFFFFFFFFF);
    });
}

TEST_CASE("the ends of the carrier are decoded as the ends of the range") {
    both_ways([] { return loads<as_u8<percent>>(0, 0.0) && loads<as_u8<percent>>(255, 100.0); });
    both_ways([] {
        return loads<as_i16<signed_percent>>(-32767, -100.0) && loads<as_i16<signed_percent>>(32767, 100.0) &&
               loads<as_i16<signed_percent>>(0, 0.0);
    });
    both_ways([] { return loads<as_u32<percent>>(0xFFFFFFFF, 100.0) && loads<as_i32<signed_percent>>(0, 0.0); });
    both_ways(
        [] { return loads<as_u64<percent>>(0xFFFFFFFFFFFFFFFF, 100.0) && loads<as_i64<signed_percent>>(0, 0.0); });
}

TEST_CASE("real values are rounded to the nearest raw value") {
    both_ways([] { return stores<as_i16<signed_percent>>(1.0, 328); });               // 327.67
    both_ways([] { return stores<as_i16<signed_percent>>(-1.0, -328); });             // -327.67
    both_ways([] { return stores<as_u8<percent>>(1.0, 3); });                         // 2.55
    both_ways([] { return stores<as_u8<percent>>(0.9, 2); });                         // 2.295
    both_ways([] { return stores<as_u16<jaus::speed_limit>>(3.5, 23); });             // 22.937
    both_ways([] { return stores<as_i32<jaus::latitude_range>>(45.0, 1073741824); }); // 1073741823.5, a tie
}

TEST_CASE("ties are rounded up") {
    both_ways([] { return stores<as_u8<percent>>(50.0, 128); });                // 127.5
    both_ways([] { return stores<as_u8<percent>>(10.0, 26); });                 // 25.5
    both_ways([] { return stores<as_i16<signed_percent>>(50.0, 16384); });      // 16383.5
    both_ways([] { return stores<as_i16<signed_percent>>(-50.0, -16383); });    // -16383.5
    both_ways([] { return stores<as_u16<jaus::speed_limit>>(5000.0, 32768); }); // 32767.5
}

TEST_CASE("a value outside its range does not encode") {
    both_ways([] { return store_error<as_u8<percent>>(-0.001) == errc::out_of_range; });
    both_ways([] { return store_error<as_u8<percent>>(100.001) == errc::out_of_range; });
    both_ways([] { return store_error<as_i16<signed_percent>>(-100.001) == errc::out_of_range; });
    both_ways([] { return store_error<as_i16<signed_percent>>(100.001) == errc::out_of_range; });
    both_ways([] { return store_error<as_u32<percent>>(1e300) == errc::out_of_range; });
    both_ways([] { return store_error<as_i64<signed_percent>>(-1e300) == errc::out_of_range; });
    both_ways([] { return store_error<as_u64<percent>>(-5e-324) == errc::out_of_range; });
}

TEST_CASE("NaN and infinity do not encode as scaled integers") {
    both_ways([] { return store_error<as_u8<percent>>(not_a_number) == errc::out_of_range; });
    both_ways([] { return store_error<as_i16<signed_percent>>(not_a_number) == errc::out_of_range; });
    both_ways([] { return store_error<as_u32<percent>>(not_a_number) == errc::out_of_range; });
    both_ways([] { return store_error<as_u64<percent>>(not_a_number) == errc::out_of_range; });
    both_ways([] { return store_error<as_u16<percent>>(infinity) == errc::out_of_range; });
    both_ways([] { return store_error<as_i16<signed_percent>>(-infinity) == errc::out_of_range; });
}

TEST_CASE("the signed raw minimum is refused by real decode and accepted by raw decode") {
    both_ways([] { return load_error<as_i8<signed_percent>>(-128) == errc::out_of_range; });
    both_ways([] { return load_error<as_i16<signed_percent>>(-32767 - 1) == errc::out_of_range; });
    both_ways([] { return load_error<as_i32<signed_percent>>(-2147483647 - 1) == errc::out_of_range; });
    both_ways([] {
        return load_error<as_i64<signed_percent>>(std::numeric_limits<std::int64_t>::min()) == errc::out_of_range;
    });
    both_ways([] { return decode_error<samples::point>(bytes(0x00, 0x80, 0x00)) == errc::out_of_range; });
    both_ways([] {
        wire::raw<samples::point> raw{};
        return wire::decode(raw, bytes(0x00, 0x80, 0x00)) && raw.get<&samples::point::x>() == -32768;
    });
}

TEMPLATE_TEST_CASE("every raw value of a range survives decode and encode", "", jaus::percent, jaus::signed_percent,
                   jaus::speed_limit, jaus::latitude_range, jaus::longitude_range, jaus::elevation_range,
                   jaus::position_error, jaus::signed_angle, jaus::positive_angle) {
    SECTION("all of 8 bits, unsigned") { all_survive<as_u8<TestType>>(); }
    SECTION("all of 8 bits, signed") { all_survive<as_i8<TestType>>(); }
    SECTION("all of 16 bits, unsigned") { all_survive<as_u16<TestType>>(); }
    SECTION("all of 16 bits, signed") { all_survive<as_i16<TestType>>(); }
    SECTION("many of 32 bits, unsigned") { many_survive<as_u32<TestType>>(); }
    SECTION("many of 32 bits, signed") { many_survive<as_i32<TestType>>(); }
    SECTION("both ends of 64 bits") {
        REQUIRE(survives<as_u64<TestType>>(0));
        REQUIRE(survives<as_u64<TestType>>(std::numeric_limits<std::uint64_t>::max()));
        REQUIRE(survives<as_i64<TestType>>(as_i64<TestType>::bottom));
        REQUIRE(survives<as_i64<TestType>>(as_i64<TestType>::top));
    }
    SECTION("limits") {
        using codec = as_u32<TestType>;
        REQUIRE(store_error<codec>(codec::lowest) == errc::ok);
        REQUIRE(store_error<codec>(codec::highest) == errc::ok);
        REQUIRE(store_error<codec>(TestType::min) == errc::ok);
        REQUIRE(store_error<codec>(TestType::max) == errc::ok);
        REQUIRE(store_error<codec>(std::nextafter(codec::lowest, -infinity)) == errc::out_of_range);
        REQUIRE(store_error<codec>(std::nextafter(codec::highest, infinity)) == errc::out_of_range);
        // Rounding may widen the range, but by no more than it must.
        REQUIRE(codec::highest - TestType::max <= 1e-15 * std::abs(TestType::max));
        REQUIRE(TestType::min - codec::lowest <= 1e-15 * std::abs(TestType::min));
    }
}

TEMPLATE_TEST_CASE("64-bit raw values keep the precision of a double", "", jaus::percent, jaus::signed_percent,
                   jaus::latitude_range) {
    support::generator random{5};
    for (int i = 0; i != 20000; ++i) {
        using codec = as_u64<TestType>;
        std::array<std::byte, 8> in{}, out{};
        support::fill(random, in);
        double first{}, second{};
        REQUIRE(codec::load(in.data(), first) == errc::ok);
        REQUIRE(codec::store(out.data(), first) == errc::ok);
        REQUIRE(codec::load(out.data(), second) == errc::ok);
        REQUIRE(second == Approx(first).epsilon(1e-15).margin((TestType::max - TestType::min) * 1e-15));
    }
}

namespace {

template <int> struct uneven_range;
#define UNEVEN_RANGE(n, low, high)                                                                                     \
    template <> struct uneven_range<n> {                                                                               \
        static constexpr double min = low, max = high;                                                                 \
        [[maybe_unused]] static constexpr std::string_view unit = "m";                                                 \
    };
UNEVEN_RANGE(0, -0.1, 0.3)
UNEVEN_RANGE(1, -3.14159265358979, 3.14159265358979)
UNEVEN_RANGE(2, -1.1, 0.7)
UNEVEN_RANGE(3, 0.1, 0.7)
UNEVEN_RANGE(4, -10000.3, 35000.7)
UNEVEN_RANGE(5, -17.9, -5.3)
UNEVEN_RANGE(6, -1e287, 1e-300)
UNEVEN_RANGE(7, 1e15, 1e15 + 2)
#undef UNEVEN_RANGE

/// At both limits of the codec and of its range, and for many doubles to both sides of them: what is stored loads as a
/// value that is at most a step away, and nothing outside of the limits is stored.
template <class Codec> void keeps_its_limits() {
    using range = typename Codec::range_type;
    const double step = (range::max - range::min) / (std::pow(2.0, 8.0 * Codec::size) - 2);
    for (const double limit : {Codec::lowest, range::min, range::max, Codec::highest})
        for (const double way : {-infinity, infinity}) {
            double real = limit;
            for (int i = 0; i != 200; ++i, real = std::nextafter(real, way)) {
                std::array<std::byte, Codec::size> bytes{};
                const bool is_legal = real >= Codec::lowest && real <= Codec::highest;
                REQUIRE(Codec::store(bytes.data(), real) == (is_legal ? errc::ok : errc::out_of_range));
                if (!is_legal) continue;
                double loaded{};
                REQUIRE(Codec::load(bytes.data(), loaded) == errc::ok);
                const double rounding = 4 * std::abs(std::nextafter(limit, infinity) - limit);
                CAPTURE(real, loaded);
                REQUIRE(std::abs(loaded - real) <= step + 8 * rounding + (range::max - range::min) * 1e-15);
            }
        }
}
template <class Raw> void keeps_all_limits() {
    keeps_its_limits<wire::scaled<Raw, uneven_range<0>>>();
    keeps_its_limits<wire::scaled<Raw, uneven_range<1>>>();
    keeps_its_limits<wire::scaled<Raw, uneven_range<2>>>();
    keeps_its_limits<wire::scaled<Raw, uneven_range<3>>>();
    keeps_its_limits<wire::scaled<Raw, uneven_range<4>>>();
    keeps_its_limits<wire::scaled<Raw, uneven_range<5>>>();
    keeps_its_limits<wire::scaled<Raw, uneven_range<6>>>();
    keeps_its_limits<wire::scaled<Raw, uneven_range<7>>>();
}

} // namespace

TEMPLATE_TEST_CASE("at and around both limits a scaled value is stored as the limit's raw value or refused", "",
                   wire::u8, wire::i8, wire::u16le, wire::i16le, wire::u16be, wire::i16be, wire::u32le, wire::i32le,
                   wire::u32be, wire::i32be, wire::u64le, wire::i64le, wire::u64be, wire::i64be) {
    keeps_all_limits<TestType>();
}
