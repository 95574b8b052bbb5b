// Values outside the sets that a standard defines.
#include "list_checks.hpp"

namespace value_sets {

enum class code : std::uint8_t { accepted = 0, refused = 1, unknown = 255 };
struct flags {
    std::uint8_t low{}, high{};
    friend constexpr bool operator==(const flags&, const flags&) = default;
    struct schema : wire::items {
        using T = flags;
        using type = layout<bit_fields<u8, bit_field<&T::low, 4>, bit_field_in_set<&T::high, 4, between<0, 9>>>>;
    };
};
struct answer {
    std::uint16_t id{};
    std::optional<code> result{};
    flags state{};
    wire::inline_list<std::int8_t, 3> levels{};
    friend constexpr bool operator==(const answer&, const answer&) = default;
    struct schema : wire::items {
        using T = answer;
        using type = layout<
            presence<u8, field<&T::id, in_value_set<u16le, between<1, 1000>>>,
                     field<&T::result, in_value_set<enumeration<code, u8>, between<0, 1>, one_of<code::unknown>>>>,
            nested<&T::state>,
            repeated<&T::levels, count_between<"number_of_levels", u8, 1, 3>,
                     element<"level", in_value_set<i8, between<-5, 5>>>>>;
    };
};

/// Differs from a message of the standard in the values only.
constexpr bool outside(std::span<const std::byte> in) {
    answer strict{}, tolerant{};
    return wire::decode(strict, in).error() == errc::outside_value_set &&
           wire::decode(tolerant, in, wire::tolerate_values) && strict == tolerant &&
           wire::check_values(strict) == errc::outside_value_set && encode_error(strict) == errc::outside_value_set;
}

} // namespace value_sets
using namespace value_sets;

TEST_CASE("values in their sets are coded as others") {
    both_ways([] {
        wire::inline_list<std::int8_t, 3> levels{-5, 5};
        return encodes_to(answer{1, code::unknown, {15, 9}, levels}, bytes(1, 1, 0, 255, 0x9F, 2, 0xFB, 5)) &&
               decodes_to(bytes(1, 1, 0, 255, 0x9F, 2, 0xFB, 5), answer{1, code::unknown, {15, 9}, levels});
    });
}

TEST_CASE("a value outside its set is told apart, and tolerated on request") {
    both_ways([] { return outside(bytes(1, 0, 0, 255, 0x9F, 1, 0)); });       // id
    both_ways([] { return outside(bytes(1, 0xE9, 0x03, 255, 0x9F, 1, 0)); }); // id
    both_ways([] { return outside(bytes(1, 1, 0, 2, 0x9F, 1, 0)); });         // result
    both_ways([] { return outside(bytes(0, 1, 0, 0xA0, 1, 0)); });            // state
    both_ways([] { return outside(bytes(0, 1, 0, 0x90, 0)); });               // number of levels
    both_ways([] { return outside(bytes(0, 1, 0, 0x90, 2, 0, 6)); });         // level
}

TEST_CASE("a value outside its set is re-encoded on request") {
    constexpr auto in = bytes(1, 0, 0, 2, 0xAF, 2, 0, 6);
    answer found{};
    REQUIRE(wire::decode(found, in, wire::tolerate_values));
    std::array<std::byte, 20> out{};
    const auto written = wire::encode(found, out, wire::tolerate_values);
    REQUIRE(written);
    CHECK(equal(*written, in));
}

TEST_CASE("bytes that cannot be stay errors where values are tolerated") {
    answer found{};
    CHECK(wire::decode(found, bytes(1, 0, 0, 2, 0xAF, 2, 0), wire::tolerate_values).error() == errc::truncated);
    CHECK(wire::decode(found, bytes(2, 0, 0, 2, 0xAF, 2, 0, 6), wire::tolerate_values).error() ==
          errc::unknown_presence_bit);
    CHECK(wire::decode(found, bytes(0, 1, 0, 0x90, 4, 0, 0, 0, 0), wire::tolerate_values).error() ==
          errc::count_above_capacity);
    CHECK(wire::decode_prefix(found, bytes(0, 0, 0, 0x90, 1, 0, 77)).error() == errc::outside_value_set);
    CHECK(*wire::decode_prefix(found, bytes(0, 0, 0, 0x90, 1, 0, 77), wire::tolerate_values) == 6);
}

TEST_CASE("diagnose names the value outside its set") {
    const auto where = [](const auto& in) { return told(wire::diagnose<answer>(in)); };
    CHECK(where(bytes(1, 0, 0, 2, 0x9F, 1, 0)).starts_with("id at 1"));
    CHECK(where(bytes(1, 1, 0, 2, 0x9F, 1, 0)).starts_with("result at 3"));
    CHECK(where(bytes(0, 1, 0, 0xA0, 1, 0)).starts_with("state.high at 3"));
    CHECK(where(bytes(0, 1, 0, 0x90, 0)).starts_with("number_of_levels at 4"));
    CHECK(where(bytes(0, 1, 0, 0x90, 2, 0, 6)).starts_with("levels[1].levels at 6"));
    answer value{};
    CHECK(wire::diagnose(value).error == errc::outside_value_set);
    CHECK(wire::diagnose(value).field == "id");
    value.id = 1;
    CHECK(wire::diagnose(value).field == "number_of_levels");
}

TEST_CASE("a view and a raw message do not look at value sets") {
    constexpr auto in = bytes(1, 0, 0, 2, 0xAF, 2, 0, 6);
    CHECK(wire::view<answer>{in});
    wire::raw<answer> raw{};
    REQUIRE(wire::decode(raw, in));
    CHECK(encodes_to(raw, in));
}
