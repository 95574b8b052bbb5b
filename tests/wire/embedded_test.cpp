// Messages inside messages.
#include "list_checks.hpp"

namespace embeddings {

struct inner {
    std::uint16_t number{};
    struct schema : wire::items {
        using type =
            layout<constant<"message_id", u16le, 0x2002>, field<&inner::number, in_value_set<u16le, between<0, 1000>>>>;
    };
};
struct level {
    static constexpr double min = 0, max = 255;
};
struct scaled_inner {
    double height{};
    struct schema : wire::items {
        using type = layout<field<&scaled_inner::height, scaled<u8, level>>>;
    };
};
struct outer {
    wire::embedded_message query{};
    std::optional<wire::embedded_message> report{};
    struct schema : wire::items {
        using T = outer;
        using type = layout<presence<u8, embedded<&T::query, count_between<"query_size", u32le, 2, 1000>>,
                                     embedded<&T::report, count<"report_size", u8>>>>;
    };
};
constexpr auto golden = bytes(1, 4, 0, 0, 0, 0x02, 0x20, 7, 0, 2, 0xAA, 0xBB);

} // namespace embeddings
using namespace embeddings;

TEST_CASE("a message of the caller's is encoded in place") {
    const inner query{7};
    constexpr auto report = bytes(0xAA, 0xBB);
    CHECK(encodes_to(outer{wire::embedded_message::of(query), wire::embedded_message{report}}, golden));
}

TEST_CASE("an embedded message is decoded without a copy") {
    outer found{};
    REQUIRE(wire::decode(found, golden));
    CHECK(found.query.bytes().data() == golden.data() + 5);
    CHECK(!found.query.is_to_encode());
    inner query{};
    REQUIRE(found.query.decode(query));
    CHECK(query.number == 7);
    CHECK(encodes_to(found, golden));
    const wire::view<outer> view{golden};
    REQUIRE(view);
    CHECK(view.get<&outer::report>()->bytes().data() == golden.data() + 10);
}

TEST_CASE("an embedded message is complete") {
    require_exact_length<outer>(golden);
    CHECK(decode_error_in_arena<outer>(bytes(0, 5, 0, 0, 0, 0x02, 0x20, 7, 0)) == errc::truncated);
    CHECK(told(wire::diagnose<outer>(bytes(0, 5, 0, 0, 0, 0x02, 0x20, 7, 0))) == "query at 5 needs 5, has 4");
}

TEST_CASE("a message whose embedded one does not encode does not either") {
    const scaled_inner above{300};
    const outer made{wire::embedded_message::of(above), std::nullopt};
    std::array<std::byte, 100> out{};
    CHECK(wire::encode(made, out, wire::tolerate_values).error() == errc::out_of_range);
    CHECK(wire::diagnose(made).error == errc::out_of_range);
    CHECK(wire::diagnose(made).field == "query");
    const inner outside{1001};
    const outer second{wire::embedded_message::of(outside), std::nullopt};
    CHECK(encode_error(second) == errc::outside_value_set);
    CHECK(wire::diagnose(second).field == "query");
    CHECK(wire::encode(second, out, wire::tolerate_values));
}

TEST_CASE("a size outside its limits is told apart") {
    constexpr auto short_one = bytes(0, 1, 0, 0, 0, 0xAA);
    outer found{};
    CHECK(wire::decode(found, short_one).error() == errc::outside_value_set);
    CHECK(wire::decode(found, short_one, wire::tolerate_values));
    CHECK(told(wire::diagnose<outer>(short_one)).starts_with("query_size at 1"));
}
