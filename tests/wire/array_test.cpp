// Arrays: a fixed number of values or records, in the message, in a presence vector, with lists in them.
#include "array_samples.hpp"
#include "list_checks.hpp"
#include "support/random_message.hpp"

using samples::arm;
using samples::board;
using samples::hand;
using samples::mixed;
using samples::piles;
using samples::point;
using samples::polygon;

namespace {

constexpr arm raised{
    .counts = {0x0102, 0x0304, 0xFFFF}, .effort = {0, 100}, .corner = {{{-100, 0}, {100, 100}}}, .tail = 9};
constexpr auto raised_bytes = bytes(1, 2, 3, 4, 0xFF, 0xFF, 0x00, 0xFF, 0x01, 0x80, 0x00, 0xFF, 0x7F, 0xFF, 9);

constexpr hand closed{.offsets = std::array<std::int8_t, 4>{-1, 2, -3, 4},
                      .grip = std::array{-100.0, 100.0},
                      .finger = std::array{mixed{.number = 1}, mixed{.number = 2, .id = 5}}};
constexpr auto closed_bytes = bytes(7, 0xFF, 2, 0xFD, 4, 0x01, 0x80, 0xFF, 0x7F, //
                                    0, 1, 0, 0,                                  //
                                    4, 2, 0, 0, 5, 0, 0, 0);

constexpr std::array<std::uint8_t, 2> first_cells{1, 2}, second_cells{3, 4};
constexpr board squares{.columns = 2, .row = {{{first_cells}, {second_cells}}}};
constexpr auto square_bytes = bytes(2, 1, 2, 3, 4);

} // namespace

TEST_CASE("an array is encoded as its elements, without a count") {
    both_ways([] { return encodes_to(raised, raised_bytes); });
    both_ways([] { return decodes_to(raised_bytes, raised); });
    STATIC_REQUIRE(wire::fixed_message<arm>);
    STATIC_REQUIRE(wire::max_size<arm> == 15);
    require_coding(raised, raised_bytes);
    require_exact_length<arm>(raised_bytes);
}

TEST_CASE("a presence vector announces an array as one field") {
    both_ways([] { return encodes_to(closed, closed_bytes); });
    both_ways([] { return decodes_to(closed_bytes, closed); });
    both_ways([] { return encodes_to(hand{}, bytes(0)) && decodes_to(bytes(0), hand{}); });
    both_ways([] {
        const hand half{.grip = std::array{0.0, 0.0}};
        return encodes_to(half, bytes(2, 0, 0, 0, 0)) && decodes_to(bytes(2, 0, 0, 0, 0), half);
    });
    STATIC_REQUIRE(wire::min_size<hand> == 1);
    STATIC_REQUIRE(wire::max_size<hand> == 1 + 4 + 4 + 2 * wire::max_size<mixed>);
    require_coding(closed, closed_bytes);
    require_exact_length<hand>(closed_bytes);
}

TEST_CASE("the structures in an array may have lists, and counts around them") {
    require_coding(squares, square_bytes);
    require_coding(board{}, bytes(0));
    require_exact_length<board>(square_bytes);
    static constexpr std::array<point, 1> corner{{{100, 0}}};
    const piles one{{polygon{.level = {0, 100}, .corner = corner}}};
    require_coding(one, bytes(2, 0x00, 0xFF, 1, 0, 0xFF, 0x7F, 0x00));
    require_exact_length<piles>(bytes(2, 0x00, 0xFF, 1, 0, 0xFF, 0x7F, 0x00));
    STATIC_REQUIRE(wire::needs_memory<piles>);
    STATIC_REQUIRE(!wire::needs_memory<arm>);
}

TEST_CASE("a view reads an array of values as one, and records by index") {
    both_ways([] {
        const wire::view<arm> view{raised_bytes};
        const auto corners = view.get<&arm::corner>();
        return view && view.get<&arm::counts>() == raised.counts && view.get<&arm::effort>() == raised.effort &&
               view.get_raw<&arm::effort>() == std::array<std::uint8_t, 2>{0, 0xFF} && corners.size() == 2 &&
               corners[1].get<&point::x>() == 100.0 && corners[0].get_raw<&point::x>() == -0x7FFF &&
               view.get<&arm::tail>() == 9;
    });
    both_ways([] {
        const wire::view<hand> view{closed_bytes};
        std::size_t fingers = 0;
        const auto seen = view.get<&hand::finger>();
        for (const auto each : *seen) fingers = fingers * 10 + each.get<&mixed::number>();
        return view && view.get<&hand::offsets>() == closed.offsets && fingers == 12;
    });
    both_ways([] {
        const auto absent = bytes(0);
        const wire::view<hand> view{absent};
        return view && !view.get<&hand::offsets>() && !view.get<&hand::grip>() && !view.get<&hand::finger>();
    });
    const wire::view<board> view{square_bytes};
    std::vector<int> cells;
    for (const auto row : view.get<&board::row>())
        for (const auto cell : row.get<&samples::cell_row::cell>()) cells.push_back(cell);
    CHECK(cells == std::vector<int>{1, 2, 3, 4});
}

TEST_CASE("an array with one illegal raw value is empty in a view, and does not decode") {
    both_ways([] {
        const auto in = bytes(2, 0x01, 0x80, 0x00, 0x80);
        const wire::view<hand> view{in};
        return !view.get<&hand::grip>() && view.get_raw<&hand::grip>() == std::array<std::int16_t, 2>{-32767, -32768} &&
               decode_error<hand>(in) == errc::out_of_range;
    });
}

TEST_CASE("a raw message holds an array's integers, and encodes any of them") {
    both_ways([] {
        const auto in = bytes(2, 0x01, 0x80, 0x00, 0x80);
        wire::raw<hand> raw{};
        return wire::decode(raw, in) && raw.get<&hand::grip>() == std::array<std::int16_t, 2>{-32767, -32768} &&
               encodes_to(raw, in);
    });
    both_ways([] {
        wire::raw<arm> raw{};
        return wire::decode(raw, raised_bytes) && raw.get<&arm::effort>()[1] == 0xFF &&
               raw.get<&arm::corner>()[0].get<&point::x>() == -0x7FFF && encodes_to(raw, raised_bytes);
    });
}

TEST_CASE("a diagnosis names the element of an array") {
    constexpr auto cut = bytes(1, 2, 3, 4, 0xFF);
    STATIC_REQUIRE(wire::diagnose<arm>(cut).error == errc::truncated);
    CHECK(told(wire::diagnose<arm>(cut)) == "counts[2].counts at 4 needs 2, has 1");
    CHECK(told(wire::diagnose<arm>(std::span{raised_bytes}.first(13))) == "corner[1].y at 13 needs 1, has 0");
    constexpr auto illegal = bytes(2, 0x01, 0x80, 0x00, 0x80);
    CHECK(told(wire::diagnose<hand>(illegal)) == "grip[1].grip at 3 needs 2, has 2");
    CHECK(told(wire::diagnose<hand>(std::span{closed_bytes}.first(17))) == "finger[1].id at 17 needs 4, has 0");

    constexpr auto why = wire::diagnose(arm{.effort = {1, 101}});
    STATIC_REQUIRE(why.error == errc::out_of_range);
    CHECK(told(why) == "effort[1].effort at 7 needs 1, has 0");
    CHECK(told(wire::diagnose(arm{.corner = {{{}, {.y = -1}}}})) == "corner[1].y at 13 needs 1, has 0");
}

TEST_CASE("clamp limits each element of an array") {
    both_ways([] {
        arm wild{.effort = {-1, 101}, .corner = {{{-101, 5}, {0, 200}}}};
        wire::clamp(wild);
        return wild.effort == std::array{0.0, 100.0} && wild.corner == std::array<point, 2>{{{-100, 5}, {0, 100}}};
    });
}

TEMPLATE_TEST_CASE("random messages with arrays survive a round trip", "", arm, hand) {
    using T = TestType;
    support::generator random{31};
    std::array<std::byte, wire::max_size<T>> out{}, again{};
    for (int round = 0; round != 2000; ++round) {
        const T value = support::random_message<T>(random, {.exact = true});
        const auto written = wire::encode(value, out);
        REQUIRE(written);
        const auto in = std::span<const std::byte>{*written};
        REQUIRE(decodes_to(in, value));
        REQUIRE(wire::view<T>{in});
        wire::raw<T> raw{};
        REQUIRE(wire::decode(raw, in));
        const auto written_again = wire::encode(raw, again);
        REQUIRE(written_again);
        REQUIRE(equal(*written_again, in));
        const auto size = support::below(random, in.size());
        REQUIRE(decode_error_in_arena<T>(in.first(size)) == errc::truncated);
    }
}

TEMPLATE_TEST_CASE("a diagnosis of a random array names the error that encode gave", "", arm, hand) {
    using T = TestType;
    support::generator random{32};
    int refused = 0;
    for (int round = 0; round != 2000; ++round) {
        const T value = support::random_message<T>(random, {.illegal = 0.05});
        const auto error = encode_error(value);
        const auto found = wire::diagnose(value);
        REQUIRE(found.error == error);
        if (error == errc::out_of_range) {
            ++refused;
            REQUIRE(!found.field.empty());
            REQUIRE(found.offset < wire::encoded_size(value));
        }
    }
    REQUIRE(refused > 100);
}
