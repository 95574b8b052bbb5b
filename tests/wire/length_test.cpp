// Every wrong length of every kind of message.
#include "both_ways.hpp"
#include "samples.hpp"
#include "support/random_message.hpp"
#include <jauscat/schema/jaus/header.hpp>
#include <jauscat/schema/jaus/platform.hpp>

using wire::errc;

TEMPLATE_TEST_CASE("each missing and each extra byte is detected", "", samples::scalars, samples::flags, samples::point,
                   samples::mixed, samples::envelope, samples::open, samples::fine, jauscat::jaus::header,
                   jauscat::jaus::set_wrench_effort, jauscat::jaus::report_global_pose) {
    using T = TestType;
    support::generator random{2};
    constexpr std::byte canary{0x5A};
    for (int round = 0; round != 200; ++round) {
        const T value = support::random_message<T>(random);
        std::array<std::byte, wire::max_size<T> + 1> buffer{};
        buffer.fill(canary);
        const auto written = wire::encode(value, buffer);
        REQUIRE(written);
        const auto size = written->size();
        REQUIRE(size == wire::encoded_size(value));
        REQUIRE(buffer[size] == canary);

        T decoded{};
        REQUIRE(*wire::decode(decoded, std::span{buffer}.first(size)) == size);
        for (std::size_t cut = 0; cut != size; ++cut) {
            T other{};
            REQUIRE(wire::decode(other, std::span{buffer}.first(cut)).error() == errc::truncated);
            REQUIRE(wire::decode_prefix(other, std::span{buffer}.first(cut)).error() == errc::truncated);
        }

        T other{};
        REQUIRE(wire::decode(other, std::span{buffer}.first(size + 1)).error() == errc::trailing_bytes);
        const auto used = wire::decode_prefix(other, std::span{buffer}.first(size + 1));
        REQUIRE(used);
        REQUIRE(*used == size);
        REQUIRE(other == decoded);

        for (std::size_t space = 0; space != size; ++space) {
            std::array<std::byte, wire::max_size<T>> out{};
            out.fill(canary);
            REQUIRE(wire::encode(value, std::span{out}.first(space)).error() == errc::no_space);
            REQUIRE(out[0] == canary);
        }
        std::array<std::byte, wire::max_size<T>> exact{};
        REQUIRE(wire::encode(value, std::span{exact}.first(size))->size() == size);
        REQUIRE(equal(std::span{exact}.first(size), std::span{buffer}.first(size)));
    }
}

TEST_CASE("lengths are also checked in constant expressions") {
    both_ways([] { return decode_error<samples::scalars>(bytes(1, 2, 3)) == errc::truncated; });
    both_ways([] { return decode_error<samples::mixed>(bytes(0x04, 7, 0, 0, 1, 2, 3)) == errc::truncated; });
    both_ways([] { return decode_error<samples::mixed>(bytes(0x00, 7, 0, 0, 1)) == errc::trailing_bytes; });
    both_ways([] {
        std::array<std::byte, 4> out{};
        return wire::encode(samples::mixed{.level = 1.0}, out).error() == errc::no_space;
    });
}

TEMPLATE_TEST_CASE("after a failed decode the value remains usable", "", samples::flags, samples::mixed,
                   samples::envelope, jauscat::jaus::header, jauscat::jaus::set_wrench_effort,
                   jauscat::jaus::report_global_pose) {
    using T = TestType;
    support::generator random{3};
    std::array<std::byte, wire::max_size<T> + 2> noise{}, good{}, out{};
    T value{};
    int failures = 0;
    for (int round = 0; round != 5000; ++round) {
        support::fill(random, noise);
        const auto size = support::below(random, noise.size() + 1);
        if (wire::decode(value, std::span{noise}.first(size))) continue;
        ++failures;
        // Its members hold values of their types: encoding it says size or error, and touches nothing else.
        const auto again = wire::encode(value, out);
        REQUIRE((again ? again->size() == wire::encoded_size(value) : again.error() == errc::out_of_range));
        const T expected = [&] {
            T first{};
            const auto written = wire::encode(support::random_message<T>(random), good);
            REQUIRE(written);
            REQUIRE(wire::decode(first, *written));
            return first;
        }();
        REQUIRE(wire::decode(value, std::span{good}.first(wire::encoded_size(expected))));
        REQUIRE(value == expected);
    }
    REQUIRE(failures > 100);
}
