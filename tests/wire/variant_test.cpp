// Variants: one of several structures with its number before it; constants.
#include "list_checks.hpp"

namespace variants {

struct point {
    std::uint16_t x{};
    friend constexpr bool operator==(const point&, const point&) = default;
    struct schema : wire::items {
        using type = layout<field<&point::x, u16le>>;
    };
};
struct path {
    wire::list<point> points{};
    friend constexpr bool operator==(const path&, const path&) = default;
    struct schema : wire::items {
        using type = layout<repeated<&path::points, count<"number_of_points", u8>>>;
    };
};
/// A variant without alternatives: its number alone.
struct nothing {
    friend constexpr bool operator==(const nothing&, const nothing&) = default;
    struct schema : wire::items {
        using type = layout<constant<"index", u8, 0>>;
    };
};
struct target {
    std::uint8_t id{};
    std::optional<std::variant<nothing, point, path, std::monostate>> where{};
    std::uint8_t last{};
    friend constexpr bool operator==(const target&, const target&) = default;
    struct schema : wire::items {
        using T = target;
        using type = layout<constant<"message_id", u16le, 0x4428>,
                            presence<u8, field<&T::id, u8>, variant<&T::where, u16le>, field<&T::last, u8>>>;
    };
};
constexpr std::array two_points{point{1}, point{2}};

} // namespace variants
using namespace variants;

TEST_CASE("a variant is the number of its alternative and the alternative") {
    require_coding(target{1, nothing{}, 9}, bytes(0x28, 0x44, 1, 1, 0, 0, 0, 9));
    require_coding(target{1, point{0x0203}, 9}, bytes(0x28, 0x44, 1, 1, 1, 0, 3, 2, 9));
    require_coding(target{1, path{wire::list<point>{two_points}}, 9}, bytes(0x28, 0x44, 1, 1, 2, 0, 2, 1, 0, 2, 0, 9));
    require_coding(target{1, std::monostate{}, 9}, bytes(0x28, 0x44, 1, 1, 3, 0, 9));
    require_coding(target{1, std::nullopt, 9}, bytes(0x28, 0x44, 0, 1, 9));
    require_exact_length<target>(bytes(0x28, 0x44, 1, 1, 2, 0, 2, 1, 0, 2, 0, 9));
    require_exact_length<target>(bytes(0x28, 0x44, 1, 1, 1, 0, 3, 2, 9));
}

TEST_CASE("a number without an alternative does not decode") {
    CHECK(decode_error_in_arena<target>(bytes(0x28, 0x44, 1, 1, 4, 0, 0, 0, 9)) == errc::unknown_tag);
    CHECK(decode_error_in_arena<target>(bytes(0x28, 0x44, 1, 1, 0, 1, 0, 0, 9)) == errc::unknown_tag);
    CHECK(told(wire::diagnose<target>(bytes(0x28, 0x44, 1, 1, 4, 0, 0, 0, 9))).starts_with("where.index at 4"));
}

TEST_CASE("a count beyond the end of an alternative is truncated") {
    CHECK(decode_error_in_arena<target>(bytes(0x28, 0x44, 1, 1, 2, 0, 200, 1, 0, 2, 0, 9)) == errc::truncated);
    CHECK(told(wire::diagnose<target>(bytes(0x28, 0x44, 1, 1, 2, 0, 3, 1, 0, 2, 0, 9)))
              .starts_with("where.points[2].x at 11 needs 2"));
}

TEST_CASE("another number than the constant does not decode") {
    lent_memory memory;
    target found{};
    CHECK(wire::decode(found, bytes(0x29, 0x44, 0, 1, 9), memory.arena).error() == errc::unknown_tag);
    CHECK(told(wire::diagnose<target>(bytes(0x29, 0x44, 0, 1, 9))).starts_with("message_id at 0"));
    CHECK(wire::decode(found, bytes(0x28, 0x44, 1, 1, 0, 0, 7, 9), memory.arena).error() == errc::unknown_tag);
    CHECK(told(wire::diagnose<target>(bytes(0x28, 0x44, 1, 1, 0, 0, 7, 9))).starts_with("where.index at 6"));
}

TEST_CASE("a view gives the alternative that was sent") {
    constexpr auto in = bytes(0x28, 0x44, 1, 1, 2, 0, 2, 1, 0, 2, 0, 9);
    const wire::view<target> view{in};
    REQUIRE(view);
    const auto where = view.get<&target::where>();
    REQUIRE(where.has_value());
    CHECK(where->index() == 2);
    CHECK(!where->get<point>());
    REQUIRE(where->get<path>());
    CHECK(where->get<path>()->get<&path::points>().size() == 2);
    CHECK(equal(where->bytes(), bytes(2, 1, 0, 2, 0)));
    CHECK(view.get<&target::last>() == 9);
    CHECK(!wire::view<target>{bytes(0x28, 0x44, 0, 1, 9)}.get<&target::where>());
}
