// The firmware on its emulated board: bytes into the serial line, bytes out of both lines. Every image does the same,
// the ones made with JausCat and the ones written by hand.
#include "emulated_board.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/sae/transport/jserial.hpp>

namespace {

using jauscat::test::emulated_board;
using jauscat::test::from_hex;
using jauscat::test::to_hex;
using bytes = std::vector<std::byte>;

bytes operator+(bytes first, const bytes& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}
bytes first_of(const bytes& all, std::ptrdiff_t count) { return {all.begin(), all.begin() + count}; }
bytes rest_of(const bytes& all, std::ptrdiff_t from) { return {all.begin() + from, all.end()}; }

// From 1.1.1.1 to 2.2.33.1, in wire order: properties, code, destination, source, size, sequence number; body.
// 7FFFh is 100 %, 8001h is -100 %, 4000h is 50.0015 %; FFh is 100 %, 80h is 50.2 %.
const bytes all_efforts = from_hex("0602 0504 01210202 01010101 1400 2200"
                                   "ff0f ff7f 0180 0000 0040 00c0 0100 ff 00 80 01 fe 7f");
const bytes all_efforts_packet = from_hex("02000000 00000000 01000000 00000000 2c000000 00000000 00000000 08006500"
                                          "00000000 00000000 02000000 151b0000 1a000000 1c000000"
                                          "0602 01010101 2200"
                                          "ff0f ff7f 0180 0000 0040 00c0 0100 ff 00 80 01 fe 7f");
const bytes one_effort = from_hex("0602 0504 01210202 01010101 0400 2300 0100 3412");
const bytes one_effort_packet = from_hex("02000000 00000000 01000000 00000000 1c000000 00000000 00000000 08006500"
                                         "00000000 00000000 02000000 151b0000 1a000000 0c000000"
                                         "0602 01010101 2300 0100 3412");
const bytes query_all_efforts = from_hex("0602 0524 01210202 01010101 0200 2400 ff0f");

const bytes status_query = from_hex("0602 0220 01210202 01010101 0000 7f7f");
// Its report after `refused` messages that were not obeyed.
bytes status_report(unsigned refused) {
    return from_hex("0602 0240 01010101 01210202 0500 7f7f 01") + bytes{std::byte(refused), {}, {}, {}};
}

/// Sends bytes and then a Query Component Status, whose report shows that all of them have been worked on; what the
/// board said before that report.
emulated_board::output converse(emulated_board& board, const bytes& sent, unsigned refused = 0) {
    board.send(sent + status_query);
    const bytes end = status_report(refused);
    auto said = board.receive_until(end);
    INFO("the board said " << to_hex(said.jaus) << " and to the card " << to_hex(said.card));
    REQUIRE(said.jaus.size() >= end.size());
    REQUIRE(rest_of(said.jaus, std::ssize(said.jaus) - std::ssize(end)) == end);
    said.jaus.resize(said.jaus.size() - end.size());
    return said;
}

/// Runs a test once for each image; of those made with the single header there are two.
std::string each_image() {
    if (emulated_board::other_images() != nullptr) return GENERATE(as<std::string>{}, "real_m3", "raw_m0");
    return GENERATE(as<std::string>{}, "real_m3", "real_by_hand_m3", "raw_m3", "raw_by_hand_m3", "smallest_m3",
                    "raw_m0", "raw_by_hand_m0", "smallest_m0");
}

} // namespace

TEST_CASE("Set Wrench Effort becomes its SDO download packet, byte for byte") {
    emulated_board board{each_image()};
    const auto said = converse(board, all_efforts + one_effort);
    CHECK(to_hex(said.card) == to_hex(all_efforts_packet + one_effort_packet));
    CHECK(to_hex(said.jaus) == "");
}

TEST_CASE("Query Wrench Effort is answered with the requested fields only") {
    emulated_board board{each_image()};
    const auto said = converse(board, all_efforts + from_hex("0802 0524 01210202 05040302 0200 2400 4508"));
    CHECK(to_hex(said.jaus) == to_hex(from_hex("0802 0544 05040302 01210202 0800 2400 4508 ff7f 0000 ff 7f")));
    CHECK(to_hex(said.card) == to_hex(all_efforts_packet));
}

TEST_CASE("a command changes only the efforts that it contains, and only known efforts are reported") {
    emulated_board board{each_image()};
    CHECK(to_hex(converse(board, query_all_efforts).jaus) ==
          to_hex(from_hex("0602 0544 01010101 01210202 0200 2400 0000")));
    const auto two_efforts = from_hex("0602 0504 01210202 01010101 0500 2200 0108 0040 80");
    CHECK(to_hex(converse(board, two_efforts + one_effort + query_all_efforts).jaus) ==
          to_hex(from_hex("0602 0544 01010101 01210202 0500 2400 0108 3412 80")));
}

TEST_CASE("every message of RA 3.3 without a handler becomes its packet, as does the experimental 0404h") {
    emulated_board board{each_image()};
    const auto travel_speed = from_hex("0602 0a04 01210202 01010101 0200 0100 3412");
    const auto velocity_state = from_hex("8602 0404 01210202 01010101 0000 0100");
    CHECK(to_hex(converse(board, travel_speed + velocity_state).card) ==
          to_hex(from_hex("02000000 00000000 01000000 00000000 1a000000 00000000 00000000 08006500 00000000 00000000"
                          "02000000 151b0000 1e000000 0a000000 0602 01010101 0100 3412"
                          "02000000 00000000 01000000 00000000 18000000 00000000 00000000 08006500 00000000 00000000"
                          "02000000 151b0000 9e000000 08000000 8602 01010101 0100")));
}

TEST_CASE("an executed command is acknowledged on request") {
    emulated_board board{each_image()};
    auto asking = one_effort;
    asking[0] = std::byte{0x16};
    const auto said = converse(board, asking + from_hex("1602 0220 01210202 01010101 0000 2500"));
    CHECK(to_hex(said.jaus) == to_hex(from_hex("3602 0504 01010101 01210202 0000 2300"
                                               "0602 0240 01010101 01210202 0500 2500 01 00000000"
                                               "3602 0220 01010101 01210202 0000 2500")));
    auto packet = one_effort_packet;
    packet[56] = std::byte{0x16};
    CHECK(to_hex(said.card) == to_hex(packet));
}

TEST_CASE("a command that cannot be executed changes nothing, is counted, and gets NAK on request") {
    emulated_board board{each_image()};
    const auto truncated = from_hex("1602 0504 01210202 01010101 0300 0100 0100 34");
    const auto trailing = from_hex("1602 0504 01210202 01010101 0500 0200 0100 3412 00");
    const auto no_vector = from_hex("1602 0524 01210202 01010101 0000 0400");
    const auto unknown_code = from_hex("1602 0f0f 01210202 01010101 0000 0500");
    const auto fragment = from_hex("1602 0504 01210202 01010101 0410 0600 0100 3412");
    const auto said = converse(board, truncated + trailing + no_vector + unknown_code + fragment, 5);
    CHECK(to_hex(said.jaus) == to_hex(from_hex("2602 0504 01010101 01210202 0000 0100"
                                               "2602 0504 01010101 01210202 0000 0200"
                                               "2602 0524 01010101 01210202 0000 0400"
                                               "2602 0f0f 01010101 01210202 0000 0500"
                                               "2602 0504 01010101 01210202 0000 0600")));
    CHECK(to_hex(said.card) == "");

    auto silent = truncated;
    silent[0] = std::byte{0x06};
    CHECK(to_hex(converse(board, silent, 6).jaus) == "");
    CHECK(to_hex(converse(board, query_all_efforts, 6).jaus) ==
          to_hex(from_hex("0602 0544 01010101 01210202 0200 2400 0000")));
}

TEST_CASE("presence bits without a field are ignored") {
    emulated_board board{each_image()};
    const auto all_bits =
        from_hex("1602 0504 01210202 01010101 1400 0300 ffff 3412 0000 0000 0000 0000 0000 000000000000");
    const auto one_bit = from_hex("1602 0504 01210202 01010101 0400 0400 0110 7856");
    CHECK(to_hex(converse(board, all_bits + one_bit + query_all_efforts).jaus) ==
          to_hex(from_hex("3602 0504 01010101 01210202 0000 0300"
                          "3602 0504 01010101 01210202 0000 0400"
                          "0602 0544 01010101 01210202 1400 2400"
                          "ff0f 7856 0000 0000 0000 0000 0000 000000000000")));
}

TEST_CASE("a raw value without a percentage is refused where percentages are used") {
    emulated_board board{"real_m3"};
    const auto said = converse(board, from_hex("1602 0504 01210202 01010101 0400 2200 0100 0080"), 1);
    CHECK(to_hex(said.jaus) == to_hex(from_hex("2602 0504 01010101 01210202 0000 2200")));
    CHECK(to_hex(said.card) == "");
}

TEST_CASE("messages to others and acknowledgements have no effect") {
    emulated_board board{each_image()};
    bytes others;
    for (const std::size_t octet : {4u, 5u, 6u, 7u}) {
        auto message = one_effort;
        message[0] = std::byte{0x16};
        message[octet] = std::byte{9};
        others = others + message;
    }
    const auto ack = from_hex("3602 0504 01210202 01010101 0000 2200");
    const auto said = converse(board, others + ack);
    CHECK(to_hex(said.jaus) == "");
    CHECK(to_hex(said.card) == "");
}

TEST_CASE("noise before, inside and after a message loses no other message") {
    emulated_board board{each_image()};
    const auto noise = from_hex("ff00 5a5a 0100 0000 ffff ffff ffff ffff ffff ffff ff");
    const auto said = converse(board, noise + all_efforts + noise + first_of(one_effort, 6) + noise +
                                          rest_of(one_effort, 6) + one_effort + noise);
    CHECK(to_hex(said.card) == to_hex(all_efforts_packet + one_effort_packet));
    CHECK(to_hex(said.jaus) == "");
}

TEST_CASE("an incomplete message is dropped when the line is idle, and messages inside it are delivered") {
    emulated_board board{each_image()};
    auto promise = first_of(one_effort, 16); // announces 256 bytes of body
    promise[12] = std::byte{0x00};
    promise[13] = std::byte{0x01};
    // The report that ends each conversation is itself swallowed until then, so no time of the host's matters.
    CHECK(to_hex(converse(board, promise + one_effort).card) == to_hex(one_effort_packet));

    // Nothing is left of what had only begun.
    board.send(promise + status_query + first_of(all_efforts, 30));
    CHECK(to_hex(board.receive_until(status_report(0)).jaus) == to_hex(status_report(0)));
    CHECK(to_hex(converse(board, one_effort).card) == to_hex(one_effort_packet));
}

TEST_CASE("a burst of messages is processed without loss") {
    emulated_board board{each_image()};
    bytes sent, expected;
    for (int i = 0; i != 100; ++i) {
        sent = sent + all_efforts;
        expected = expected + all_efforts_packet;
    }
    CHECK(to_hex(converse(board, sent).card) == to_hex(expected));
}

TEST_CASE("a message of 256 bytes of body is accepted, one byte more is noise") {
    emulated_board board{each_image()};
    // Set Payload Data Element (0D01h), rank 51, whose body is passed on as it is.
    const auto largest = from_hex("0602 010d 01210202 01010101 0001 2200") + bytes(256, std::byte{0xEE});
    const auto too_large = from_hex("0602 010d 01210202 01010101 0101 2200") + bytes(257, std::byte{0xEE});
    const auto said = converse(board, too_large + largest);
    CHECK(to_hex(said.card) ==
          to_hex(from_hex("02000000 00000000 01000000 00000000 18010000 00000000 00000000 08006500 00000000 00000000"
                          "02000000 151b0000 33000000 08010000 0602 01010101 2200") +
                 bytes(256, std::byte{0xEE})));
    CHECK(to_hex(said.jaus) == "");
}

namespace {

/// Frames of JSerial, one for each message in hex.
bytes framed(std::initializer_list<const char*> messages) {
    bytes all;
    for (const char* const hex : messages) {
        const auto message = from_hex(hex);
        bytes frame(jauscat::sae::max_serial_frame_size(message.size()));
        frame.resize(jauscat::sae::put_serial_frame(message, frame)->size());
        all = all + frame;
    }
    return all;
}

} // namespace

TEST_CASE("a node of SAE JAUS obeys, reports, acknowledges, and hands messages to the card by their table") {
    if (emulated_board::other_images() != nullptr) return; // the single header has no messages of SAE
    emulated_board board{GENERATE(as<std::string>{}, "sae_m3", "sae_by_hand_m3", "sae_m0", "sae_by_hand_m0")};
    // To 2.2.33 from 1.1.1: SetWrenchEffort with one effort, then a field cut off; to another component; QueryStatus;
    // a packet of several; QueryWrenchEffort.
    const auto noise = from_hex("ff 10 55 10 03 00");
    board.send(
        noise +
        framed({"00 1400 11 21 02 0200 01 01 0100 0504 0100 3412 2200",
                "00 1300 11 21 02 0200 01 01 0100 0504 0100 34 1000",
                "00 1400 11 22 02 0200 01 01 0100 0504 0100 7856 2200", "00 1000 01 21 02 0200 01 01 0100 0220 2500",
                "00 1400 51 21 02 0200 01 01 0100 0504 0100 7856 2600"}) +
        noise + framed({"00 1200 01 21 02 0200 01 01 0100 0524 ffff 2300"}));
    const auto report = framed({"00 1400 01 01 01 0100 21 02 0200 0544 0100 3412 2300"});
    const auto said = board.receive_until(report);
    CHECK(to_hex(said.jaus) ==
          to_hex(framed({"00 0e00 31 01 01 0100 21 02 0200 2200", "00 0e00 21 01 01 0100 21 02 0200 1000",
                         "00 0e00 21 01 01 0100 21 02 0200 2600"}) +
                 report));
    CHECK(to_hex(said.card) ==
          to_hex(from_hex("20000000 00000000 00000000 00000000 1d000000 00000000 00000000 08006500 00000000 00000000"
                          "02000000 21210000 02000000 0d000000 11 0200 01010100 0100 3412 2200"
                          "20000000 00000000 00000000 00000000 19000000 00000000 00000000 08006500 00000000 00000000"
                          "02000000 21200000 18000000 09000000 01 0200 01010100 2500")));
}
