// The packets that create a component's objects in a Hilscher slave, byte by byte.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/bridge/object_creation.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/schema/translation/seed_table.hpp>
#include <jauscat/translate/fixed_length.hpp>

#include <vector>

using namespace jauscat;
using jauscat::test::from_hex;
using jauscat::test::hex_of;
using jauscat::test::to_hex;

namespace {

using bridging::creation_errc;
using bridging::object_creation;

constexpr auto& arm = bridging::object_list<translation::seed_table, 33, jaus::set_wrench_effort,
                                            jaus::report_wrench_effort>::description;
using fixed_table =
    translate::fixed_length<translation::seed_table, jaus::set_wrench_effort, jaus::report_wrench_effort>;
constexpr auto& strict_arm =
    bridging::object_list<fixed_table, 33, jaus::set_wrench_effort, jaus::report_wrench_effort>::description;

std::vector<std::byte> packet_of(const object_creation& creation, std::size_t number) {
    std::vector<std::byte> out(200);
    out.resize(creation.packet(number, out)->size());
    return out;
}

// "component 33", "set_wrench_effort", "report_wrench_effort"
constexpr std::string_view object_packet = "20000000 00000000 00000000 00000000 24000000 00000000 00000000 806a0000"
                                           "00000000 00000000" // ulLen 36, ulCmd 6A80h
                                           "151b 79 09 0004"   // 6933, up to subindex 121, record, make subindex 0
                                           "01 00 0000 0000"   // with a name
                                           "00000000 10000000" // 16 bytes of data
                                           "0c000000 636f6d706f6e656e74203333";
constexpr std::string_view command_packet = "20000000 00000000 00000000 00000000 26000000 01000000 00000000 826a0000"
                                            "00000000 00000000"  // ulLen 38, ulId 1, ulCmd 6A82h
                                            "151b 1a 81 02"      // subindex 26, name and variable size, tell of writes
                                            "3800 0a00 1c000000" // write, octet string, 28 bytes
                                            "15000000"           // 21 bytes of data
                                            "11000000 7365745f7772656e63685f6566666f7274";
constexpr std::string_view report_packet = "20000000 00000000 00000000 00000000 29000000 02000000 00000000 826a0000"
                                           "00000000 00000000"  // ulLen 41, ulId 2
                                           "151b 79 81 03"      // subindex 121, tell of reads and writes
                                           "3f00 0a00 1c000000" // read and write
                                           "18000000"
                                           "14000000 7265706f72745f7772656e63685f6566666f7274";

} // namespace

TEST_CASE("an object list becomes one packet for the object and one for each subobject") {
    const object_creation creation{arm};
    REQUIRE(creation.size() == 3);
    CHECK(to_hex(packet_of(creation, 0)) == hex_of(object_packet));
    CHECK(to_hex(packet_of(creation, 1)) == hex_of(command_packet));
    CHECK(to_hex(packet_of(creation, 2)) == hex_of(report_packet));
}

TEST_CASE("objects of fixed length are created without variable size") {
    const object_creation creation{strict_arm};
    CHECK(to_hex(packet_of(creation, 0)) == hex_of(object_packet));
    auto expected = from_hex(command_packet);
    expected[43] = std::byte{0x01};
    expected[49] = std::byte{30};
    CHECK(to_hex(packet_of(creation, 1)) == to_hex(expected));
}

TEST_CASE("the caller's fields are in every creation packet, and packet numbers increase") {
    const object_creation creation{arm,
                                   {.ul_dest = 0x01020304, .ul_src = 0x05060708, .ul_src_id = 0x0A0B0C0D, .ul_id = 7}};
    auto expected = from_hex(command_packet);
    std::ranges::copy(from_hex("04030201 08070605 00000000 0d0c0b0a"), expected.begin());
    expected[20] = std::byte{8};
    CHECK(to_hex(packet_of(creation, 1)) == to_hex(expected));
}

TEST_CASE("a creation packet is not truncated to the buffer") {
    const object_creation creation{arm};
    std::vector<std::byte> out(78);
    CHECK(creation.packet(1, out)->size() == 78);
    CHECK(creation.packet(1, std::span{out}.first(77)).error() == wire::errc::no_space);
}

TEST_CASE("confirmations report whether the object and its subobjects were created") {
    const object_creation creation{arm};
    const auto object = from_hex("20000000 00000000 00000000 00000000 02000000 00000000 00000000 816a0000"
                                 "00000000 00000000 151b");
    const auto subobject = from_hex("20000000 00000000 00000000 00000000 03000000 01000000 00000000 836a0000"
                                    "00000000 00000000 151b 1a");
    CHECK(creation.answer(0, object));
    CHECK(creation.answer(1, subobject));
    CHECK(creation.answer(1, object).error == creation_errc::not_an_answer);
    CHECK(creation.answer(0, subobject).error == creation_errc::not_an_answer);
    CHECK(creation.answer(2, subobject).error == creation_errc::not_an_answer); // another ulId
    CHECK(creation.answer(0, std::span{object}.first(41)).error == creation_errc::truncated);
    CHECK(creation.answer(0, std::span{object}.first(39)).error == creation_errc::truncated);
    CHECK(creation.answer(1, std::span{subobject}.first(42)).error == creation_errc::truncated);

    auto other = subobject;
    other[42] = std::byte{27};
    CHECK(creation.answer(1, other).error == creation_errc::not_an_answer);
    other = object;
    other[40] = std::byte{0x16};
    CHECK(creation.answer(0, other).error == creation_errc::not_an_answer);
}

TEST_CASE("a refused object has a reason, with and without the fields after the status") {
    const object_creation creation{arm};
    const auto refusal = from_hex("20000000 00000000 00000000 00000000 00000000 00000000 13809bc0 816a0000"
                                  "00000000 00000000");
    const auto answer = creation.answer(0, refusal);
    CHECK(answer.error == creation_errc::refused);
    CHECK(answer.status == hilscher::od_status::object_exists);
    CHECK(describe(answer.status) == "the object exists already");
    CHECK(describe(static_cast<hilscher::od_status>(1)) == "unknown status");
}

TEST_CASE("all parts of a subobject are in the manual's order and announced by bValueInfo") {
    const auto one = from_hex("01"), two = from_hex("02 03"), three = from_hex("04"), four = from_hex("05");
    hilscher::od_create_subobject_request request{.us_index = 0x2000,
                                                  .b_sub_index = 1,
                                                  .has_name = true,
                                                  .has_initial = true,
                                                  .has_unit = true,
                                                  .has_default = true,
                                                  .has_minimum = true,
                                                  .has_maximum = true,
                                                  .us_datatype = hilscher::od_data_type::octet_string,
                                                  .unit = 0x11223344,
                                                  .name = "n",
                                                  .minimum = wire::blob{one},
                                                  .maximum = wire::blob{two},
                                                  .initial = wire::blob{three},
                                                  .default_ = wire::blob{four}};
    std::vector<std::byte> out(200);
    const auto bytes = wire::encode(request, out);
    REQUIRE(bytes);
    CHECK(to_hex(bytes->subspan(40)) == hex_of("0020 01 7b 00 0000 0a00 00000000 00000000"
                                               "44332211 01000000 6e 01000000 01 02000000 0203"
                                               "01000000 04 01000000 05"));
    hilscher::od_create_subobject_request again{};
    REQUIRE(wire::decode(again, *bytes));
    CHECK(again.unit == request.unit);
    CHECK(again.name == request.name);
    CHECK(again.maximum == request.maximum);
    CHECK(again.default_ == request.default_);

    request.has_unit = false;
    CHECK(wire::encode(request, out).error() == wire::errc::presence_mismatch);
}

TEST_CASE("confirmations are 42 and 43 bytes") {
    STATIC_REQUIRE(wire::max_size<hilscher::od_create_object_confirmation> == 42);
    STATIC_REQUIRE(wire::max_size<hilscher::od_create_subobject_confirmation> == 43);
    STATIC_REQUIRE(wire::min_size<hilscher::od_create_object_request> == 60);
    STATIC_REQUIRE(wire::min_size<hilscher::od_create_subobject_request> == 57);
}
