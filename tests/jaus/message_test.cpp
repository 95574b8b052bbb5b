// Complete messages built and split, against literal bytes.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/jaus/platform.hpp>

#include <set>

using namespace jauscat;
using namespace jauscat::test;
using jaus::errc;

namespace {

/// A user's message, as large as one packet takes or one byte larger.
template <std::size_t Size> struct bulk {
    std::array<std::byte, Size> data{};
};

} // namespace

template <std::size_t Size> struct jauscat::wire::schema<bulk<Size>> {
    static constexpr std::uint16_t command_code = 0xD001;
    using T = bulk<Size>;
    using type = layout<field<&T::data, octets<Size>>>;
};

namespace {

/// Set Emergency with code 5: priority 15, version 2, to 1.1.1.1 from 2.2.2.2, sequence number 34.
constexpr auto set_emergency = hex_literal<18>("0f02 0600 01010101 02020202 0200 2200 0500");
constexpr jaus::header emergency_header{.priority = 15,
                                        .destination = {.instance = 1, .component = 1, .node = 1, .subsystem = 1},
                                        .source = {.instance = 2, .component = 2, .node = 2, .subsystem = 2},
                                        .sequence_number = 34};
constexpr jaus::set_emergency emergency_code_5{.emergency_code = wire::bit_set<jaus::set_emergency_code>::from_bits(5)};

/// Report Wrench Effort with the first and the last element, from 9.8.33.7 to 1.2.32.3.
constexpr auto report_wrench_effort = hex_literal<21>("4602 0544 03200201 07210809 0500 efbe 0108 ff7f 33");
constexpr jaus::header report_header{.service_connection = true,
                                     .destination = {.instance = 3, .component = 32, .node = 2, .subsystem = 1},
                                     .source = {.instance = 7, .component = 33, .node = 8, .subsystem = 9},
                                     .sequence_number = 0xBEEF};
constexpr jaus::report_wrench_effort reported{.propulsive_linear_effort_x = 100, .resistive_rotational_effort_z = 20};

template <class T> std::string made(const jaus::header& head, const T& body) {
    std::vector<std::byte> out(jaus::header_size + jaus::max_body_size + 1);
    const auto message_bytes = jaus::make_message(head, body, out);
    return message_bytes ? to_hex(*message_bytes) : std::string{jaus::describe(message_bytes.error())};
}

errc split_with(std::size_t at, int value) {
    auto bytes = set_emergency;
    bytes[at] = static_cast<std::byte>(value);
    return jaus::split(bytes).error;
}

} // namespace

TEST_CASE("Set Emergency with code 5 is built byte for byte") {
    CHECK(made(emergency_header, emergency_code_5) == to_hex(set_emergency));
    STATIC_REQUIRE([] {
        std::array<std::byte, 18> out{};
        return jaus::make_message(emergency_header, emergency_code_5, out)->size() == 18 && out == set_emergency;
    }());
}

TEST_CASE("Report Wrench Effort is built byte for byte, with the present fields") {
    CHECK(made(report_header, reported) == to_hex(report_wrench_effort));
}

TEST_CASE("command code and data size are those of the body, whatever the header has") {
    auto head = emergency_header;
    head.command_code = 0x1234;
    head.data_size = 99;
    CHECK(made(head, emergency_code_5) == to_hex(set_emergency));
}

TEST_CASE("a message is split into header and body") {
    const auto emergency = jaus::split(set_emergency);
    REQUIRE(emergency);
    CHECK(emergency.header.priority == 15);
    CHECK(emergency.header.version == 2);
    CHECK(emergency.header.command_code == 0x0006);
    CHECK(emergency.header.destination == emergency_header.destination);
    CHECK(emergency.header.source == emergency_header.source);
    CHECK(emergency.header.data_size == 2);
    CHECK(emergency.header.sequence_number == 34);
    CHECK(emergency.body.data() == set_emergency.data() + 16);
    CHECK(to_hex(emergency.body) == "05 00");

    const auto report = jaus::split(report_wrench_effort);
    REQUIRE(report);
    CHECK(report.header.service_connection);
    CHECK(report.header.destination == report_header.destination);
    CHECK(report.header.source == report_header.source);
    CHECK(to_hex(report.body) == "01 08 ff 7f 33");
    jaus::report_wrench_effort body{};
    REQUIRE(wire::decode(body, report.body));
    CHECK(body == jaus::report_wrench_effort{.propulsive_linear_effort_x = 100, .resistive_rotational_effort_z = 20});
}

TEST_CASE("a message shorter than its header is truncated") {
    for (std::size_t size = 0; size != 16; ++size) {
        const auto message = jaus::split(std::span{set_emergency}.first(size));
        CHECK(message.error == errc::truncated);
        CHECK(message.body.empty());
    }
}

TEST_CASE("a message with less or more data than its header states has the wrong size") {
    CHECK(jaus::split(std::span{set_emergency}.first(16)).error == errc::wrong_size);
    CHECK(jaus::split(std::span{set_emergency}.first(17)).error == errc::wrong_size);
    CHECK(jaus::split(set_emergency).error == errc::ok);
    CHECK(jaus::split(hex_literal<19>("0f02 0600 01010101 02020202 0200 2200 0500 00")).error == errc::wrong_size);
    CHECK(split_with(12, 1) == errc::wrong_size);
    CHECK(split_with(12, 3) == errc::wrong_size);
    CHECK(split_with(13, 1) == errc::wrong_size); // 258 bytes
}

TEST_CASE("a message of a version other than 2 has the wrong version") {
    CHECK(split_with(1, 0) == errc::wrong_version);
    CHECK(split_with(1, 1) == errc::wrong_version);
    CHECK(split_with(1, 2) == errc::ok);
    CHECK(split_with(1, 3) == errc::wrong_version);
    CHECK(split_with(1, 63) == errc::wrong_version);
    CHECK(split_with(1, 0xC2) == errc::ok); // the two reserved bits are no part of it
}

TEST_CASE("a source with an octet of 0 or 255 is invalid, a destination is not") {
    for (std::size_t at = 8; at != 12; ++at) {
        CAPTURE(at);
        CHECK(split_with(at, 0) == errc::invalid_source);
        CHECK(split_with(at, 1) == errc::ok);
        CHECK(split_with(at, 254) == errc::ok);
        CHECK(split_with(at, 255) == errc::invalid_source);
    }
    for (std::size_t at = 4; at != 8; ++at) {
        CHECK(split_with(at, 0) == errc::ok);
        CHECK(split_with(at, 255) == errc::ok);
    }
}

TEST_CASE("header and body join to the message from which they were split") {
    constexpr auto joined = [] {
        const auto parts = jaus::split(report_wrench_effort);
        std::array<std::byte, report_wrench_effort.size()> out{};
        jaus::header head = parts.header;
        head.data_size = 99; // is taken from the body
        return std::pair{jaus::join(head, parts.body, out)->size(), out};
    }();
    STATIC_REQUIRE(joined.first == report_wrench_effort.size());
    STATIC_REQUIRE(joined.second == report_wrench_effort);

    std::vector<std::byte> body(jaus::max_body_size + 1), out(jaus::header_size + body.size());
    CHECK(jaus::join(report_header, body, out).error() == errc::body_too_large);
    body.pop_back();
    CHECK(jaus::join(report_header, body, out)->size() == jaus::header_size + body.size());
    CHECK(jaus::join(report_header, body, std::span{out}.first(jaus::header_size + body.size() - 1)).error() ==
          errc::no_space);
    jaus::header wrong = report_header;
    wrong.priority = 16;
    CHECK(jaus::join(wrong, body, out).error() == errc::invalid_header);
}

TEST_CASE("a message that exceeds its buffer gives no_space") {
    std::array<std::byte, 21> out{};
    for (std::size_t size = 0; size != 18; ++size)
        CHECK(jaus::make_message(emergency_header, emergency_code_5, std::span{out}.first(size)).error() ==
              errc::no_space);
    CHECK(jaus::make_message(emergency_header, emergency_code_5, std::span{out}.first(18)));
    CHECK(jaus::make_message(report_header, reported, std::span{out}.first(20)).error() == errc::no_space);
    CHECK(jaus::make_message(report_header, reported, out));
}

TEST_CASE("a body with a value outside its limits is invalid") {
    std::array<std::byte, 64> out{};
    auto body = reported;
    body.propulsive_linear_effort_x = 101;
    CHECK(jaus::make_message(report_header, body, out).error() == errc::invalid_body);
}

TEST_CASE("a header with a value wider than its bits is invalid") {
    std::array<std::byte, 64> out{};
    auto head = emergency_header;
    head.priority = 16;
    CHECK(jaus::make_message(head, emergency_code_5, out).error() == errc::invalid_header);
}

TEST_CASE("a body of 4080 bytes fits a message, and one of 4081 is too large") {
    std::vector<std::byte> out(5000);
    const auto largest = jaus::make_message(emergency_header, bulk<4080>{}, out);
    REQUIRE(largest);
    CHECK(largest->size() == 4096);
    CHECK(to_hex(std::span{out}.subspan(12, 2)) == "f0 0f");
    CHECK(jaus::make_message(emergency_header, bulk<4081>{}, out).error() == errc::body_too_large);
}

TEST_CASE("a received body of 4080 bytes is accepted, and one of 4081 to 4095 is too large") {
    for (const std::size_t size : {4080U, 4081U, 4095U}) {
        CAPTURE(size);
        auto head = emergency_header;
        head.data_size = static_cast<std::uint16_t>(size);
        std::vector<std::byte> message(jaus::header_size + size);
        REQUIRE(wire::encode(head, message));
        CHECK(jaus::split(message).error == (size == 4080 ? errc::ok : errc::body_too_large));
    }
}

TEST_CASE("an answer has the sender as destination and the same sequence number, and is not an acknowledgement") {
    const jaus::header request{.priority = 11,
                               .ack_nak = jaus::ack_nak::request,
                               .service_connection = true,
                               .experimental = true,
                               .version = 2,
                               .command_code = 0x2405,
                               .destination = {.instance = 1, .component = 2, .node = 3, .subsystem = 4},
                               .source = {.instance = 5, .component = 6, .node = 7, .subsystem = 8},
                               .data_size = 2,
                               .data_flag = jaus::data_flag::only,
                               .sequence_number = 0x1234};
    const auto answer = jaus::answer_to(request);
    CHECK(answer == jaus::header{.priority = 11,
                                 .destination = {.instance = 5, .component = 6, .node = 7, .subsystem = 8},
                                 .source = {.instance = 1, .component = 2, .node = 3, .subsystem = 4},
                                 .sequence_number = 0x1234});
    CHECK(made(answer, reported) == to_hex(hex_literal<21>("0b02 0544 05060708 01020304 0500 3412 0108 ff7f 33")));
}

TEST_CASE("an acknowledgement has no body, whatever its command code") {
    // ACK and NAK of Set Wrench Effort, whose shortest body is 2 bytes; then the same bytes asking for an ACK.
    const auto ack = jaus::split(hex_literal<16>("3602 0504 01200101 01210201 0000 2200"));
    REQUIRE(ack);
    CHECK(jaus::is_acknowledgement(ack.header));
    CHECK(ack.body.empty());
    const auto nak = jaus::split(hex_literal<16>("2602 0504 01200101 01210201 0000 2200"));
    REQUIRE(nak);
    CHECK(jaus::is_acknowledgement(nak.header));
    const auto wanted = jaus::split(hex_literal<16>("1602 0504 01200101 01210201 0000 2200"));
    REQUIRE(wanted);
    CHECK(!jaus::is_acknowledgement(wanted.header));
    const auto unasked = jaus::split(hex_literal<16>("0602 0504 01200101 01210201 0000 2200"));
    REQUIRE(unasked);
    CHECK(!jaus::is_acknowledgement(unasked.header));
}

TEST_CASE("every message error has a distinct text") {
    std::set<std::string_view> lines;
    for (int i = 0; i <= static_cast<int>(errc::body_too_large); ++i)
        lines.insert(jaus::describe(static_cast<errc>(i)));
    CHECK(lines.size() == static_cast<std::size_t>(errc::body_too_large) + 1);
    CHECK(!lines.contains("unknown error"));
}
