// Lists: of records, of single values, in lists, with counts before them, in another member and further out.
#include "list_checks.hpp"

using samples::chain;
using samples::grid;
using samples::parcel;
using samples::point;
using samples::polygon;
using samples::polygons;
using samples::row;

namespace {

constexpr std::array<point, 2> corners{{{-100, 0}, {100, 100}}};
constexpr polygon filled{.level = {0, 100}, .corner = corners};
constexpr auto filled_bytes = bytes(2, 0x00, 0xFF, 2, 0, 0x01, 0x80, 0x00, 0xFF, 0x7F, 0xFF);

constexpr std::array<std::uint16_t, 2> cells{0x0102, 0x0304};
constexpr std::array<row, 2> rows{{{7, cells}, {8, cells}}};
constexpr grid table{.columns = 2, .row = rows};
constexpr auto table_bytes = bytes(2, 2, 7, 1, 2, 3, 4, 8, 1, 2, 3, 4);

constexpr auto body = bytes(0xAA, 0xBB);
constexpr parcel sent{.header = {.size = 2, .colour = 0xF}, .body = body, .tail = 9};
constexpr auto sent_bytes = bytes(0x02, 0xF0, 0xAA, 0xBB, 9);

constexpr std::array<point, 2> wrong{{{0, 0}, {0, 101}}};

} // namespace

TEST_CASE("a list is encoded as its count, then its elements") {
    both_ways([] { return encodes_to(filled, filled_bytes); });
    both_ways([] { return encodes_to(polygon{}, bytes(0, 0, 0)); });
    require_coding(filled, filled_bytes);
    require_coding(polygon{}, bytes(0, 0, 0));
    require_exact_length<polygon>(filled_bytes);
}

TEST_CASE("a nested list is decoded into the arena, and its elements are found") {
    const std::array<polygon, 3> shapes{{filled, {}, filled}};
    std::vector<std::byte> expected{std::byte{0}, std::byte{3}};
    const auto append = [&](auto&& more) { expected.insert(expected.end(), more.begin(), more.end()); };
    append(filled_bytes);
    append(bytes(0, 0, 0));
    append(filled_bytes);
    require_coding(polygons{shapes}, expected);
    require_exact_length<polygons>(expected);
}

TEST_CASE("a count may be in the enclosing structure") {
    both_ways([] { return encodes_to(table, table_bytes); });
    require_coding(table, table_bytes);
    require_exact_length<grid>(table_bytes);
    require_coding(grid{.columns = 255}, bytes(255, 0));
}

TEST_CASE("a count may exceed the number of elements by one") {
    static constexpr std::array<point, 1> link{{{0, 0}}};
    both_ways([] { return encodes_to(chain{.joints = 2, .base = 5, .link = link}, bytes(2, 5, 0, 0, 0)); });
    require_coding(chain{.joints = 2, .base = 5, .link = link}, bytes(2, 5, 0, 0, 0));
    require_coding(chain{.joints = 1, .base = 5}, bytes(1, 5));
    require_coding(chain{.joints = 0, .base = 5}, bytes(0, 5));
    require_exact_length<chain>(bytes(2, 5, 0, 0, 0));
}

TEST_CASE("a count may be in a structure beside the bytes") {
    both_ways([] { return encodes_to(sent, sent_bytes); });
    both_ways([] { return decodes_to(sent_bytes, sent); });
    require_coding(sent, sent_bytes);
    require_exact_length<parcel>(sent_bytes);
}

TEST_CASE("bytes are referenced, not copied") {
    constexpr auto in = bytes(0x02, 0x00, 0xAA, 0xBB, 9);
    parcel found{};
    REQUIRE(wire::decode(found, in));
    CHECK(found.body.data() == in.data() + 2);
}

TEST_CASE("a count that differs from the list does not encode") {
    both_ways([] { return encode_error(grid{.columns = 3, .row = rows}) == errc::count_mismatch; });
    both_ways([] { return encode_error(chain{.joints = 3}) == errc::count_mismatch; });
    both_ways([] { return encode_error(parcel{.header = {.size = 1}}) == errc::count_mismatch; });
    constexpr auto why = wire::diagnose(grid{.columns = 3, .row = rows});
    STATIC_REQUIRE(why.error == errc::count_mismatch);
    CHECK(told(why) == "row[0].cell at 3 needs 0, has 0");
}

TEST_CASE("more elements than a count can state do not encode") {
    const std::vector<row> many(256);
    const grid large{.columns = 0, .row = std::span{many}};
    std::vector<std::byte> out(wire::encoded_size(large));
    CHECK(wire::encode(large, out).error() == errc::count_above_capacity);
    CHECK(wire::diagnose(large).field == "number_of_rows");
    const grid most{.columns = 0, .row = std::span{many}.first(255)};
    REQUIRE(wire::encode(most, out)->size() == 2 + 255);
    CHECK(out[1] == std::byte{255});
}

TEST_CASE("more elements than the capacity of an inline list do not decode") {
    constexpr auto in = bytes(4, 1, 2, 3, 4, 0, 0);
    lent_memory memory;
    polygon found{};
    CHECK(wire::decode(found, in, memory.arena).error() == errc::count_above_capacity);
    constexpr auto why = wire::diagnose<polygon>(in);
    STATIC_REQUIRE(why.error == errc::count_above_capacity);
    CHECK(why.field == "number_of_levels");
    CHECK(wire::view<polygon>{in}.get<&polygon::level>().size() == 4); // a view holds nothing
}

TEST_CASE("an inline list holds as many elements as its capacity") {
    both_ways([] {
        wire::inline_list<int, 2> list{1};
        const bool added = list.push_back(2) && !list.push_back(3);
        return added && list.size() == 2 && list[1] == 2 && list == wire::inline_list<int, 2>{1, 2} && list.resize(1) &&
               list == wire::inline_list<int, 2>{1} && list.resize(2) && list[1] == 0 && !list.resize(3) &&
               list.size() == 2 && (list.clear(), list.empty());
    });
}

TEST_CASE("an arena that is too small for the lists gives arena_full") {
    std::array<std::byte, sizeof(row)> one{};
    wire::arena memory{one};
    grid found{};
    CHECK(wire::decode(found, table_bytes, memory).error() == errc::arena_full);
    CHECK(wire::diagnose<grid>(table_bytes));
    wire::arena none{{}};
    CHECK(wire::decode(found, bytes(9, 0), none));
    CHECK(found == grid{.columns = 9});
}

TEST_CASE("an arena allocates until it is full, and is reset at once") {
    alignas(8) std::array<std::byte, 32> place{};
    wire::arena memory{place};
    auto* const first = memory.allocate<std::uint16_t>(1);
    REQUIRE(first != nullptr);
    auto* const second = memory.allocate<std::uint64_t>(3);
    REQUIRE(second != nullptr);
    CHECK(reinterpret_cast<std::uintptr_t>(second) % 8 == 0);
    CHECK(memory.used() == 32);
    CHECK(memory.allocate<char>(1) == nullptr);
    CHECK(memory.allocate<std::uint64_t>(~std::size_t{}) == nullptr);
    memory.reset();
    CHECK(memory.used() == 0);
    CHECK(memory.allocate<std::uint64_t>(4) != nullptr);
}

TEST_CASE("a view reads elements without decoding the message") {
    both_ways([] {
        const wire::view<polygon> view{filled_bytes};
        const auto levels = view.get<&polygon::level>();
        const auto seen = view.get<&polygon::corner>();
        auto at = seen.begin();
        const auto second = *++at;
        return view && levels.size() == 2 && *levels.begin() == 0.0 && seen.size() == 2 &&
               second.get<&point::x>() == 100.0 && second.get_raw<&point::x>() == 0x7FFF && ++at == seen.end();
    });
    both_ways([] {
        const wire::view<grid> view{table_bytes};
        std::uint32_t numbers = 0, sum = 0;
        for (const auto each : view.get<&grid::row>()) {
            numbers = numbers * 10 + each.get<&row::number>();
            for (const std::uint16_t cell : each.get<&row::cell>()) sum += cell;
        }
        return numbers == 78 && sum == 2 * (0x0102 + 0x0304);
    });
    static_assert(std::ranges::forward_range<decltype(wire::view<grid>{table_bytes}.get<&grid::row>())>);
}

TEST_CASE("an element with an illegal raw value is empty in a view, and does not decode") {
    constexpr auto in = bytes(0, 1, 0, 0x00, 0x80, 0);
    both_ways([] {
        const auto received = bytes(0, 1, 0, 0x00, 0x80, 0);
        const auto corner = *wire::view<polygon>{received}.get<&polygon::corner>().begin();
        return !corner.get<&point::x>() && corner.get_raw<&point::x>() == -32768;
    });
    lent_memory memory;
    polygon found{};
    CHECK(wire::decode(found, in, memory.arena).error() == errc::out_of_range);
    CHECK(told(wire::diagnose<polygon>(in)) == "corner[0].x at 3 needs 2, has 3");
    wire::raw<polygon> raw{};
    REQUIRE(wire::decode(raw, in, memory.arena));
    CHECK(raw.get<&polygon::corner>()[0].get<&point::x>() == -32768);
}

TEST_CASE("a diagnosis names the field, the element and the byte") {
    constexpr auto cut = bytes(0, 2, 0, 0, 0, 0, 2, 0, 0, 1, 2, 3, 4);
    STATIC_REQUIRE(wire::diagnose<polygons>(cut).error == errc::truncated);
    CHECK(told(wire::diagnose<polygons>(cut)) == "shape[1].corner[1].y at 13 needs 1, has 0");
    CHECK(told(wire::diagnose<grid>(bytes(2, 2, 7, 1, 2, 3, 4, 8, 1, 2, 3))) ==
          "row[1].cell[1].cell at 10 needs 2, has 1");
    CHECK(told(wire::diagnose<grid>(bytes(2, 1))) == "row[0].number at 2 needs 1, has 0");
    CHECK(told(wire::diagnose<grid>(bytes(2))) == "number_of_rows at 1 needs 1, has 0");

    constexpr auto why = wire::diagnose(polygon{.level = {}, .corner = wrong});
    STATIC_REQUIRE(why.error == errc::out_of_range);
    CHECK(told(why) == "corner[1].y at 8 needs 1, has 0");
}

TEST_CASE("raw lists are exact for every byte") {
    const auto in = bytes(1, 0x7F, 1, 0, 0x01, 0x00, 0x80);
    lent_memory memory;
    wire::raw<polygon> raw{};
    REQUIRE(wire::decode(raw, in, memory.arena));
    CHECK(raw.get<&polygon::level>() == wire::inline_list<std::uint8_t, 3>{0x7F});
    CHECK(raw.get<&polygon::corner>()[0].get<&point::x>() == 1);
    CHECK(raw.get<&polygon::corner>()[0].get<&point::y>() == 0x80);
    CHECK(encodes_to(raw, in));
}

TEST_CASE("a message larger than a result can state does not encode") {
    const std::vector<std::byte> much(wire::packed_size<errc>::max_size);
    const samples::labels large{.rest = {reinterpret_cast<const char*>(much.data()), much.size()}};
    std::vector<std::byte> out(much.size());
    CHECK(wire::encode(large, out).error() == errc::too_long);
    CHECK(wire::diagnose(large).error == errc::too_long);
    const std::vector<std::byte> received(wire::packed_size<errc>::max_size + 1);
    samples::labels found{};
    CHECK(wire::decode(found, received).error() == errc::too_long);
}
