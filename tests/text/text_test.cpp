// Messages with offsets, bytes and fields as text.
#include "support/bytes.hpp"
#include "support/catch.hpp"
#include <jauscat/text/jaus.hpp>

#include <vector>

namespace {

namespace jaus = jauscat::jaus;
namespace text = jauscat::text;

std::vector<std::byte> message(const auto& body, jaus::header head) {
    std::vector<std::byte> bytes(64);
    bytes.resize(jaus::make_message(head, body, bytes)->size());
    return bytes;
}

} // namespace

TEST_CASE("a message is shown with offsets, bytes, names, units and raw values") {
    const auto bytes =
        message(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50, .resistive_linear_effort_y = 100},
                {.ack_nak = jaus::ack_nak::request,
                 .destination = {1, 33, 2, 2},
                 .source = {1, 32, 1, 1},
                 .sequence_number = 7});
    CHECK(
        text::annotate_message(bytes, jaus::message_list<jaus::set_wrench_effort>{}) ==
        "  0000  16 02         priority = 6, ack_nak = request (1), service_connection = false, experimental = false, "
        "version = 2, reserved = 0\n"
        "  0002  05 04         command_code = 0x0405 (Set Wrench Effort)\n"
        "  0004  01            destination.instance = 1\n"
        "  0005  21            destination.component = 33\n"
        "  0006  02            destination.node = 2\n"
        "  0007  02            destination.subsystem = 2\n"
        "  0008  01            source.instance = 1\n"
        "  0009  20            source.component = 32\n"
        "  000a  01            source.node = 1\n"
        "  000b  01            source.subsystem = 1\n"
        "  000c  05 00         data_size = 5, data_flag = only (0)\n"
        "  000e  07 00         sequence_number = 7\n"
        "  0010  81 00         presence_vector = 0x0081\n"
        "  0012  00 40         propulsive_linear_effort_x = 50.001526 % (raw 16384)\n"
        "  0014  ff            resistive_linear_effort_y = 100 % (raw 255)\n");
    CHECK(text::summary(jaus::split(bytes).header) == "Set Wrench Effort, 21 bytes, 1.1.32.1 -> 2.2.33.1, sequence 7");
}

TEST_CASE("a body that does not decode is dumped with the field at fault") {
    const auto cut = support::bytes(0x03, 0x00, 0x00, 0x40, 0x01);
    CHECK(text::annotate<jaus::set_wrench_effort>(cut, 16) ==
          "  0010  03 00 00 40 01\n"
          "  truncated: the bytes end before the last field: propulsive_linear_effort_y at byte 20 needs 2 bytes, 1 "
          "left\n");
}

TEST_CASE("an acknowledgement, an unknown code and an unnamed enumerator have texts") {
    jaus::header head{.ack_nak = jaus::ack_nak::nak, .command_code = 0x9999};
    CHECK(text::summary(head) == "command code 0x9999 (NAK), 16 bytes, 0.0.0.0 -> 0.0.0.0, sequence 0");
    CHECK(text::to_text(jaus::primary_status_code::standby) == "standby");
    CHECK(text::to_text(static_cast<jaus::primary_status_code>(0xC8)) == "0xC8");
    CHECK(text::hex_number(0, 4) == "0x0000");
    CHECK(text::hex_number(0x1AF4, 2) == "0x1AF4");
    CHECK(text::hex_dump(std::vector<std::byte>(17)) ==
          "  0000  00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00\n  0010  00\n");
    CHECK(text::hex_dump(std::vector<std::byte>(17), "", 16) ==
          "0010  00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00\n0020  00\n");
}
