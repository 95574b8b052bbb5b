// Optional members of any length, and members that a flag further out announces.
#include "list_checks.hpp"

using samples::kind;
using samples::spot;
using samples::survey;

namespace {

constexpr auto extra = bytes(0xAA, 0xBB);
constexpr std::array<spot, 2> with_buffers{{{0x0102, 1}, {0x0304, 2}}};
constexpr std::array<spot, 1> without_buffer{{{{}, 3}}};
constexpr survey everything{.extra = wire::blob{extra},
                            .buffer_present = true,
                            .spots = wire::list<spot>{with_buffers},
                            .limit = samples::typed{kind::byte, std::uint8_t{9}}};
constexpr auto everything_bytes = bytes(0x0F, 2, 0, 0xAA, 0xBB, 2, 2, 1, 1, 4, 3, 2, 0, 9);

} // namespace

TEST_CASE("a presence vector announces lists, bytes, structures of any length, and flags") {
    both_ways([] { return encodes_to(everything, everything_bytes); });
    both_ways([] { return encodes_to(survey{}, bytes(0)); });
    require_coding(everything, everything_bytes);
    require_coding(survey{}, bytes(0));
    require_coding(survey{.buffer_present = true}, bytes(2));
    require_coding(survey{.spots = wire::list<spot>{without_buffer}}, bytes(4, 1, 3));
    require_coding(survey{.extra = wire::blob{}, .spots = wire::list<spot>{}}, bytes(5, 0, 0, 0));
    require_exact_length<survey>(everything_bytes);
}

TEST_CASE("a member that contradicts its flag does not encode") {
    both_ways([] { return encode_error(survey{.spots = wire::list<spot>{with_buffers}}) == errc::presence_mismatch; });
    both_ways([] {
        return encode_error(survey{.buffer_present = true, .spots = wire::list<spot>{without_buffer}}) ==
               errc::presence_mismatch;
    });
    const survey wrong{.buffer_present = true, .spots = wire::list<spot>{without_buffer}};
    CHECK(told(wire::diagnose(wrong)) == "spots[0].buffer at 2 needs 0, has 0");
}

TEST_CASE("decoding clears absent members") {
    lent_memory memory;
    survey value = everything;
    REQUIRE(wire::decode(value, bytes(0), memory.arena));
    CHECK(value == survey{});
}

TEST_CASE("a presence bit without a member is refused") {
    CHECK(decode_error_in_arena<survey>(bytes(0x10)) == errc::unknown_presence_bit);
    CHECK(wire::diagnose<survey>(bytes(0x10)).field == "presence_vector");
}

TEST_CASE("a view reads present members and reports absent ones") {
    both_ways([] {
        const wire::view<survey> view{everything_bytes};
        const auto spots = view.get<&survey::spots>();
        if (!view || !view.get<&survey::buffer_present>() || !spots) return false;
        std::uint32_t sum = 0;
        for (const auto each : *spots) sum += each.get<&spot::buffer>().value_or(0) + each.get<&spot::id>();
        const auto limit = view.get<&survey::limit>();
        return sum == 0x0102 + 0x0304 + 3 && equal(*view.get<&survey::extra>(), extra) && limit &&
               limit->get<&samples::typed::kind>() == kind::byte;
    });
    both_ways([] {
        const auto in = bytes(4, 1, 3);
        const wire::view<survey> view{in};
        const auto spots = view.get<&survey::spots>();
        return view && !view.get<&survey::extra>() && !view.get<&survey::buffer_present>() && spots &&
               !(*spots->begin()).get<&spot::buffer>() && (*spots->begin()).get<&spot::id>() == 3 &&
               !view.get<&survey::limit>();
    });
}

TEST_CASE("a diagnosis names the member of an element") {
    const auto cut = std::span{everything_bytes}.first(10);
    CHECK(told(wire::diagnose<survey>(cut)) == "spots[1].buffer at 9 needs 2, has 1");
    CHECK(told(wire::diagnose<survey>(std::span{everything_bytes}.first(13))) == "limit.value at 13 needs 1, has 0");
    CHECK(told(wire::diagnose<survey>(std::span{everything_bytes}.first(4))) == "extra at 3 needs 2, has 1");
}
