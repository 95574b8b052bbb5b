// The long answer to a failed encode or decode.
#include "both_ways.hpp"
#include "samples.hpp"
#include "support/random_message.hpp"
#include <jauscat/schema/jaus/header.hpp>
#include <jauscat/schema/jaus/platform.hpp>

using samples::envelope;
using samples::flags;
using samples::mixed;
using samples::point;
using wire::errc;

namespace {

constexpr bool same(const wire::diagnosis& a, const wire::diagnosis& b) {
    return a.error == b.error && a.field == b.field && a.parent() == b.parent() && a.offset == b.offset &&
           a.needed == b.needed && a.available == b.available;
}

/// Whether `T`, or a structure in it, has a member of that name.
template <wire::message T> bool knows(std::string_view name) {
    bool found = false;
    const T value{};
    wire::visit(value, [&]<class Item>(Item, const auto&) {
        found = found || Item::name() == name;
        if constexpr (requires { typename Item::inner; }) found = found || knows<typename Item::value_type>(name);
    });
    return found;
}

} // namespace

TEST_CASE("success is diagnosed as ok") {
    both_ways([] { return static_cast<bool>(wire::diagnose<mixed>(bytes(0x00, 7, 0, 0))); });
    both_ways([] { return same(wire::diagnose<mixed>(bytes(0x00, 7, 0, 0)), {}); });
    both_ways([] { return same(wire::diagnose(mixed{}), {}); });
    both_ways([] { return same(wire::diagnose(mixed{}, 4), {}); });
    both_ways([] { return same(wire::diagnose<samples::empty>(std::span<const std::byte>{}), {}); });
}

TEST_CASE("a truncated message is diagnosed at the field that does not fit") {
    both_ways([] {
        return same(wire::diagnose<samples::scalars>(bytes(1, 2, 3, 4, 5)),
                    {.error = errc::truncated, .field = "big", .offset = 3, .needed = 4, .available = 2});
    });
    both_ways([] {
        return same(wire::diagnose<mixed>(std::span<const std::byte>{}),
                    {.error = errc::truncated, .field = "presence_vector", .needed = 1});
    });
    both_ways([] {
        return same(wire::diagnose<mixed>(bytes(0x05, 7, 0xFF, 0, 0, 1, 2, 3)),
                    {.error = errc::truncated, .field = "id", .offset = 5, .needed = 4, .available = 3});
    });
    both_ways([] {
        return same(wire::diagnose<flags>(bytes(1)),
                    {.error = errc::truncated, .field = "length", .needed = 2, .available = 1});
    });
    both_ways([] {
        return same(wire::diagnose<mixed>(bytes(0x02, 7, 0, 0, 1)), {.error = errc::truncated,
                                                                     .field = "x",
                                                                     .path = {{{"place"}}},
                                                                     .depth = 1,
                                                                     .offset = 4,
                                                                     .needed = 2,
                                                                     .available = 1});
    });
    both_ways([] {
        return same(wire::diagnose<envelope>(bytes(1, 2, 0x01, 7, 0xFF, 0, 0)),
                    {.error = errc::truncated, .field = "tail", .offset = 7, .needed = 1, .available = 0});
    });
}

TEST_CASE("trailing bytes are diagnosed at the first of them") {
    both_ways([] {
        return same(wire::diagnose<mixed>(bytes(0x01, 7, 0, 0, 0, 1, 2)),
                    {.error = errc::trailing_bytes, .offset = 5, .available = 2});
    });
}

TEST_CASE("an unknown presence bit is diagnosed at its vector") {
    both_ways([] {
        return same(wire::diagnose<mixed>(bytes(0x80, 7, 0, 0)),
                    {.error = errc::unknown_presence_bit, .field = "presence_vector", .needed = 1, .available = 4});
    });
    both_ways([] {
        return same(wire::diagnose<envelope>(bytes(1, 2, 0x80, 7, 0, 0, 9)), {.error = errc::unknown_presence_bit,
                                                                              .field = "presence_vector",
                                                                              .path = {{{"content"}}},
                                                                              .depth = 1,
                                                                              .offset = 2,
                                                                              .needed = 1,
                                                                              .available = 5});
    });
}

TEST_CASE("an illegal raw value is diagnosed at its field") {
    both_ways([] {
        return same(wire::diagnose<point>(bytes(0x00, 0x80, 0)),
                    {.error = errc::out_of_range, .field = "x", .needed = 2, .available = 3});
    });
    both_ways([] {
        return same(wire::diagnose<mixed>(bytes(0x03, 7, 0xFF, 0, 0, 0x00, 0x80, 0)), {.error = errc::out_of_range,
                                                                                       .field = "x",
                                                                                       .path = {{{"place"}}},
                                                                                       .depth = 1,
                                                                                       .offset = 5,
                                                                                       .needed = 2,
                                                                                       .available = 3});
    });
}

TEST_CASE("a value that does not encode is diagnosed at its field") {
    both_ways([] {
        return same(wire::diagnose(point{.y = 101.0}),
                    {.error = errc::out_of_range, .field = "y", .offset = 2, .needed = 1});
    });
    both_ways([] {
        return same(
            wire::diagnose(mixed{.level = 1.0, .place = point{.y = -1.0}}),
            {.error = errc::out_of_range, .field = "y", .path = {{{"place"}}}, .depth = 1, .offset = 7, .needed = 1});
    });
    both_ways([] {
        return same(wire::diagnose(flags{.shade = static_cast<samples::colour>(4)}),
                    {.error = errc::out_of_range, .field = "shade", .needed = 2});
    });
    both_ways([] {
        return same(
            wire::diagnose(envelope{.content = {.place = point{.x = 500.0}}}),
            {.error = errc::out_of_range, .field = "x", .path = {{{"place"}}}, .depth = 1, .offset = 6, .needed = 2});
    });
}

TEST_CASE("a buffer that is too small is diagnosed with the size needed") {
    both_ways(
        [] { return same(wire::diagnose(mixed{.id = 1}, 7), {.error = errc::no_space, .needed = 8, .available = 7}); });
}

TEST_CASE("a field beyond the end is diagnosed as truncated if decode says so, whatever precedes it") {
    both_ways([] { // x holds an illegal raw value
        return same(wire::diagnose<point>(bytes(0x00, 0x80)),
                    {.error = errc::truncated, .field = "y", .offset = 2, .needed = 1, .available = 0});
    });
    both_ways([] { // an unknown bit, and no bytes for the known ones
        return same(wire::diagnose<mixed>(bytes(0x83, 7, 0, 0)),
                    {.error = errc::truncated, .field = "required", .offset = 3, .needed = 2, .available = 1});
    });
}

TEMPLATE_TEST_CASE("the diagnosis of random bytes has the error of decode", "", samples::scalars, flags, point, mixed,
                   envelope, samples::open, samples::fine, jauscat::jaus::header, jauscat::jaus::set_wrench_effort,
                   jauscat::jaus::report_global_pose) {
    using T = TestType;
    support::generator random{10};
    std::array<std::byte, wire::max_size<T> + 3> buffer{};
    int failed = 0;
    for (int round = 0; round != 8000; ++round) {
        support::fill(random, buffer);
        // Some signed raw minima and small vectors, which noise alone seldom has.
        if (support::chance(random, 0.5)) buffer[0] &= std::byte{0x07};
        for (std::size_t i = 0; i + 1 < buffer.size(); ++i)
            if (support::chance(random, 0.05)) buffer[i] = std::byte{}, buffer[i + 1] = std::byte{0x80};
        const auto in = std::span<const std::byte>{buffer}.first(support::below(random, buffer.size() + 1));
        T value{};
        const auto used = wire::decode(value, in);
        const auto found = wire::diagnose<T>(in);
        REQUIRE(found.error == used.error());
        if (used) continue;
        ++failed;
        REQUIRE(found.offset + found.available == in.size());
        if (found.error == errc::truncated) REQUIRE(found.needed > found.available);
        if (found.error == errc::out_of_range) REQUIRE(found.needed <= found.available);
        if (found.error == errc::trailing_bytes)
            REQUIRE(found.field.empty());
        else
            REQUIRE((found.field == "presence_vector" || knows<T>(found.field)));
    }
    REQUIRE(failed > 1000);
}

TEMPLATE_TEST_CASE("the diagnosis of a random value has the error of encode", "", flags, point, mixed, envelope,
                   samples::fine, jauscat::jaus::header, jauscat::jaus::set_wrench_effort,
                   jauscat::jaus::report_global_pose) {
    using T = TestType;
    support::generator random{11};
    int out_of_range = 0, no_space = 0;
    for (int round = 0; round != 4000; ++round) {
        const T value = support::random_message<T>(random, {.illegal = 0.1});
        std::array<std::byte, wire::max_size<T>> out{};
        const auto space =
            wire::max_size<T> - (support::chance(random, 0.3) ? support::below(random, wire::max_size<T> + 1) : 0);
        const auto written = wire::encode(value, std::span{out}.first(space));
        const auto found = wire::diagnose(value, space);
        REQUIRE(found.error == written.error());
        if (found.error == errc::out_of_range) {
            ++out_of_range;
            REQUIRE(knows<T>(found.field));
            REQUIRE(found.offset + found.needed <= wire::encoded_size(value));
        } else if (found.error == errc::no_space) {
            ++no_space;
            REQUIRE(found.needed == wire::encoded_size(value));
            REQUIRE(found.available == space);
        }
    }
    REQUIRE(out_of_range > 200);
    REQUIRE(no_space > 200);
}
