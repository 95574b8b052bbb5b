// Text and JSON of items that no message of the standard has: arrays, signed bit-fields.
#include "support/bytes.hpp"
#include "support/catch.hpp"
#include "wire/array_samples.hpp"
#include <jauscat/text/annotate.hpp>
#include <jauscat/text/json.hpp>
#include <jauscat/text/print.hpp>

namespace {

namespace text = jauscat::text;
namespace wire = jauscat::wire;
using samples::arm;
using samples::hand;
using samples::mixed;
using samples::trims;
using support::bytes;
using text::json;

constexpr arm raised{.counts = {1, 2, 3}, .effort = {0, 100}, .corner = {{{-100, 0}, {100, 100}}}, .tail = 9};

/// What is wrong with a line or some JSON as a message of type T.
template <class T> std::string wrong(std::string_view line) {
    std::vector<std::byte> lists(4096);
    wire::arena memory{lists};
    T message{};
    return text::from_text(line, message, memory).error().message;
}
template <class T> T made(const json& fields) {
    std::vector<std::byte> lists(4096);
    wire::arena memory{lists};
    T message{};
    REQUIRE(text::from_json(fields, message, memory));
    return message;
}

} // namespace

TEST_CASE("an array is printed element by element") {
    CHECK(text::to_text(raised) == "  counts[0] = 1\n"
                                   "  counts[1] = 2\n"
                                   "  counts[2] = 3\n"
                                   "  effort[0] = 0 % (raw 0)\n"
                                   "  effort[1] = 100 % (raw 255)\n"
                                   "  corner[0]\n"
                                   "    x = -100 % (raw -32767)\n"
                                   "    y = 0 % (raw 0)\n"
                                   "  corner[1]\n"
                                   "    x = 100 % (raw 32767)\n"
                                   "    y = 100 % (raw 255)\n"
                                   "  tail = 9\n");
    CHECK(text::to_text(std::array<std::uint8_t, 2>{3, 4}) == "[3, 4]");
    CHECK(text::to_text(bytes(3, 4)) == "03 04");
}

TEST_CASE("an array is annotated element by element") {
    constexpr auto in = bytes(0, 1, 0, 2, 0, 3, 0x00, 0xFF, 0x01, 0x80, 0x00, 0xFF, 0x7F, 0xFF, 9);
    CHECK(text::annotate<arm>(in) == "  0000  00 01         counts[0] = 1\n"
                                     "  0002  00 02         counts[1] = 2\n"
                                     "  0004  00 03         counts[2] = 3\n"
                                     "  0006  00            effort[0] = 0 % (raw 0)\n"
                                     "  0007  ff            effort[1] = 100 % (raw 255)\n"
                                     "  0008  01 80         corner[0].x = -100 % (raw -32767)\n"
                                     "  000a  00            corner[0].y = 0 % (raw 0)\n"
                                     "  000b  ff 7f         corner[1].x = 100 % (raw 32767)\n"
                                     "  000d  ff            corner[1].y = 100 % (raw 255)\n"
                                     "  000e  09            tail = 9\n");
    CHECK(text::to_text(wire::diagnose<arm>(std::span{in}.first(5))) ==
          "truncated: the bytes end before the last field: counts[2] at byte 4 needs 2 bytes, 1 left");
}

TEST_CASE("an array in JSON is an array of values or of objects, and is restored") {
    const json fields = text::to_json(raised);
    CHECK(fields.dump() == R"({"counts":[1,2,3],"effort":[{"value":0.0,"raw":0},{"value":100.0,"raw":255}],)"
                           R"("corner":[{"x":{"value":-100.0,"raw":-32767},"y":{"value":0.0,"raw":0}},)"
                           R"({"x":{"value":100.0,"raw":32767},"y":{"value":100.0,"raw":255}}],"tail":9})");
    CHECK(made<arm>(fields) == raised);
    const hand closed{.offsets = std::array<std::int8_t, 4>{-1, 2, -3, 4},
                      .finger = std::array{mixed{.number = 1}, mixed{.number = 2, .id = 5}}};
    CHECK(made<hand>(text::to_json(closed)) == closed);
    CHECK(made<hand>(json::object()) == hand{});
}

TEST_CASE("an array is read from text, with all elements") {
    std::vector<std::byte> lists(4096);
    wire::arena memory{lists};
    hand found{};
    REQUIRE(text::from_text("offsets[0]=1 offsets[1]=-2 offsets[2]=3 offsets[3]=raw:-4", found, memory));
    CHECK(found == hand{.offsets = std::array<std::int8_t, 4>{1, -2, 3, -4}});
    CHECK(wrong<hand>("offsets[0]=1") == "offsets has 1 elements, must have 4");
    CHECK(wrong<hand>("offsets[1]=1 offsets[3]=1") == "offsets[0] is missing");
    CHECK(wrong<hand>("offsets[4]=1") == "offsets has 5 elements, must have at most 4");
    CHECK(wrong<hand>("offsets[0]=128 offsets[1]=1 offsets[2]=1 offsets[3]=1") ==
          "offsets[0] is '128', must be -128 to 127");
    CHECK(wrong<arm>("tail=1") == "counts is missing");
}

TEST_CASE("signed bit-fields have a sign in text and JSON") {
    const trims value{.pitch = -16, .heading = -1};
    CHECK(text::to_text(value) == "  pitch = -16\n  locked = false\n  heading = -1\n");
    CHECK(text::to_json(value).dump() == R"({"pitch":-16,"locked":0,"heading":-1})");
    CHECK(made<trims>(text::to_json(value)) == value);
    CHECK(text::annotate<trims>(bytes(0x10, 0xFF)) ==
          "  0000  10 ff         pitch = -16, locked = false, heading = -2\n");
    CHECK(wrong<trims>("pitch=16 locked=false heading=0") == "pitch is '16', must be -16 to 15");
    CHECK(wrong<trims>("pitch=-17 locked=false heading=0") == "pitch is '-17', must be -16 to 15");
}
