// Tables of a user's own: private messages, other index bases, and bit-fields as rows.
#include "compile_fail/small_table.hpp"
#include "samples.hpp"
#include "support/catch.hpp"

using namespace jauscat;
using namespace jauscat::test;
using translate::errc;

namespace {

/// RA 3.3, and a private message behind it.
constexpr auto codes_with_private_message = translation::ra_command_codes_and<0xD123>;

using at_2000 = translate::translator<translation::seed_table_of<0x2000, codes_with_private_message>::type>;
using at_6900 = translate::translator<translation::self_contained_table_of<0x6900, codes_with_private_message>::type>;

/// A packet of a user's own, and a table that gives each bit-field of the properties a word in it.
struct spread_packet {
    std::uint32_t priority{}, ack_nak{}, service_connection{}, experimental{}, version{}, reserved{}, code{}, count{};
};

} // namespace

template <> struct jauscat::wire::schema<spread_packet> {
    using T = spread_packet;
    using type = layout<field<&T::priority, u32le>, field<&T::ack_nak, u32le>, field<&T::service_connection, u32le>,
                        field<&T::experimental, u32le>, field<&T::version, u32le>, field<&T::reserved, u32le>,
                        field<&T::code, u32be>, field<&T::count, u32le>>;
};

namespace {

using J = jaus::header;
using P = spread_packet;
using translate::at;
using spread = translate::translator<translate::table<
    J, P, 100, translate::copy<at<&J::priority>, at<&P::priority>>, translate::copy<at<&J::ack_nak>, at<&P::ack_nak>>,
    translate::copy<at<&J::service_connection>, at<&P::service_connection>>,
    translate::copy<at<&J::experimental>, at<&P::experimental>>, translate::copy<at<&J::version>, at<&P::version>>,
    translate::copy<at<&J::reserved>, at<&P::reserved>>, translate::copy<at<&J::command_code>, at<&P::code>>,
    translate::body_size_in_rest<at<&J::data_size>>, translate::data_count<at<&P::count>>, translate::rest>>;

constexpr auto spread_message = hex_literal<18>("fbd9 ff4e 01020304 05060708 0220 0a0b cafe");
constexpr auto spread_bytes = hex_literal<46>("0b000000 03000000 01000000 01000000 19000000 03000000 00004eff 0e000000"
                                              "01020304 05060708 0220 0a0b cafe");

} // namespace

TEMPLATE_TEST_CASE("a private message appended to the list has rank 159 and keeps the other ranks", "", at_2000,
                   at_6900) {
    auto message = message_with_body(3);
    CHECK(get(to_packet<TestType>(message).bytes, word::ul_sub_index) == 26);
    message[2] = std::byte{0x23};
    message[3] = std::byte{0xD1};
    const auto there = to_packet<TestType>(message);
    REQUIRE(there.error == errc::ok);
    CHECK(get(there.bytes, word::ul_sub_index) == 159);
    CHECK(from_packet<TestType>(there.bytes).bytes == message);
    CHECK(from_packet<TestType>(with(there.bytes, word::ul_sub_index, 160)).error == errc::unknown_subindex);

    CHECK(to_packet<seed>(message).error == errc::unknown_command_code);
}

TEST_CASE("a table with its own index base has component 0 there") {
    auto message = vector_of(wrench_effort);
    CHECK(get(to_packet<at_2000>(message).bytes, word::ul_index) == 0x2021);
    CHECK(get(to_packet<at_6900>(message).bytes, word::ul_index) == 0x6921);
    message[5] = std::byte{255};
    CHECK(get(to_packet<at_2000>(message).bytes, word::ul_index) == 0x20FF);
    CHECK(from_packet<at_2000>(to_packet<at_2000>(message).bytes).bytes == message);
    CHECK(from_packet<at_6900>(to_packet<at_6900>(message).bytes).bytes == message);

    const auto there = to_packet<at_2000>(message).bytes;
    CHECK(from_packet<at_2000>(with(there, word::ul_index, 0x1FFF)).error == errc::unknown_index);
    CHECK(from_packet<at_2000>(with(there, word::ul_index, 0x2000)).error == errc::ok);
    CHECK(from_packet<at_2000>(with(there, word::ul_index, 0x2100)).error == errc::unknown_index);
    CHECK(from_packet<at_2000>(with(there, word::ul_index, 6933)).error == errc::unknown_index);
}

TEST_CASE("rows can use bit-fields of any type, and words of either byte order") {
    const auto there = to_packet<spread>(spread_message);
    CHECK(to_hex(there.bytes) == to_hex(spread_bytes));
    CHECK(to_hex(from_packet<spread>(there.bytes).bytes) == to_hex(spread_message));
}

TEST_CASE("a word that does not fit its bit-field is out of range") {
    const auto [offset, most] = GENERATE(std::pair{0, 15}, std::pair{4, 3}, std::pair{8, 1}, std::pair{12, 1},
                                         std::pair{16, 63}, std::pair{20, 3});
    CAPTURE(offset);
    auto bytes = vector_of(spread_bytes);
    set(bytes, static_cast<word>(offset), static_cast<std::uint32_t>(most));
    CHECK(from_packet<spread>(bytes).error == errc::ok);
    set(bytes, static_cast<word>(offset), static_cast<std::uint32_t>(most) + 1);
    CHECK(from_packet<spread>(bytes).error == errc::out_of_range);
    set(bytes, static_cast<word>(offset), 256);
    CHECK(from_packet<spread>(bytes).error == errc::out_of_range);
}

TEST_CASE("the small table of the compile-fail tests is valid without their mistakes") {
    using table = translate::translator<small::right_table>;
    constexpr auto bytes = hex_literal<19>("fb1a0000 03000000 00000000 03000000 5a cafe");
    constexpr auto message = hex_literal<8>("07 0404 5a 0200 cafe");
    CHECK(to_hex(to_packet<table>(message).bytes) == to_hex(bytes));
    CHECK(to_hex(from_packet<table>(bytes).bytes) == to_hex(message));
}
