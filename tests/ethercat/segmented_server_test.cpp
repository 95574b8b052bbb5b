// The slave's end of transfers in segments, message by message: what it takes, and what it aborts.
#include "ethercat/objects.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/ethercat/slave/coe_server.hpp>

#include <string>
#include <vector>

using namespace jauscat::ethercat;
using jauscat::test::from_hex;
using jauscat::test::to_hex;
namespace test = jauscat::test;

namespace {

using bytes = std::vector<std::byte>;

// Object 2000h:1 of 12 bytes behind a server with memory for 32, in a mailbox of 24.
struct bench {
    test::objects objects{};
    bytes memory = bytes(32);
    coe_server server;

    explicit bench(std::size_t memory_size = 32) : memory(memory_size), server{objects, {.transfer_memory = memory}} {
        objects.add(0x2000, 1, 12);
    }
    std::string ask(std::string_view message) {
        bytes out(18, std::byte{0xEE}); // what an earlier message has left
        const auto answer = server.answer(from_hex(message), out);
        CHECK(answer.error == mailbox_error_code::none);
        out.resize(answer.size);
        return to_hex(out);
    }
    [[nodiscard]] std::string stored() { return to_hex(objects.entries.at({0x2000, 1}).value); }
    void keep(std::string_view value) { objects.entries.at({0x2000, 1}).value = from_hex(value); }
};

const std::string started = "00 30 60 00 20 01 00 00 00 00";
std::string abort_with(const std::string& code) { return "00 20 80 00 20 01 " + code; }
const std::string toggle_bit = abort_with("00 00 03 05"), command_specifier = abort_with("01 00 04 05"),
                  exceeds_mailbox = abort_with("05 00 01 06"), too_high = abort_with("12 00 07 06"),
                  too_low = abort_with("13 00 07 06");
const std::string nothing = "00 00 00 00 00 00 00 00 00 00 00 00";
const std::string twelve = "01 02 03 04 05 06 07 08 09 0a 0b 0c";

} // namespace

TEST_CASE("a segmented download starts with data, without data, and with the size bit clear") {
    bench with;
    CHECK(with.ask("0020 21 0020 01 0c000000 0102030405060708") == started);
    CHECK(with.ask("0020 07 090a0b0c000000") == "00 30 20 00 00 00 00 00 00 00");
    CHECK(with.stored() == twelve);

    for (const char* start : {"0020 21 0020 01 0c000000", "0020 20 0020 01 0c000000"}) {
        bench without;
        CHECK(without.ask(start) == started);
        CHECK(without.ask("0020 00 01020304050607") == "00 30 20 00 00 00 00 00 00 00");
        CHECK(without.stored() == nothing);
        CHECK(without.ask("0020 15 08090a0b0c0000") == "00 30 30 00 00 00 00 00 00 00");
        CHECK(without.stored() == twelve);
        CHECK(without.objects.writes == 1);
    }
}

TEST_CASE("a last segment may be short without padding, or empty") {
    bench short_one;
    CHECK(short_one.ask("0020 21 0020 01 0c000000 0102030405060708") == started);
    CHECK(short_one.ask("0020 07 090a0b0c") == "00 30 20 00 00 00 00 00 00 00");
    CHECK(short_one.stored() == twelve);

    bench empty_one;
    CHECK(empty_one.ask("0020 21 0020 01 0c000000 0102030405060708") == started);
    CHECK(empty_one.ask("0020 06 090a0b0c000000") == "00 30 20 00 00 00 00 00 00 00");
    CHECK(empty_one.ask("0020 1f 00000000000000") == "00 30 30 00 00 00 00 00 00 00");
    CHECK(empty_one.stored() == twelve);
}

TEST_CASE("a segment with the wrong toggle bit ends a transfer") {
    bench b;
    CHECK(b.ask("0020 21 0020 01 0c000000") == started);
    CHECK(b.ask("0020 10 01020304050607") == toggle_bit);
    CHECK(b.ask("0020 00 01020304050607") == "00 20 80 01 02 03 01 00 04 05"); // nothing is under way any more
    CHECK(b.ask("0020 21 0020 01 0c000000") == started);
    CHECK(b.ask("0020 00 01020304050607") == "00 30 20 00 00 00 00 00 00 00");
    CHECK(b.ask("0020 05 08090a0b0c0000") == toggle_bit); // the first toggle again
    CHECK(b.stored() == nothing);

    b.keep("01 02 03 04 05 06 07 08 09 0a 0b 0c");
    CHECK(b.ask("0020 40 0020 01 00000000") == "00 30 41 00 20 01 0c 00 00 00 01 02 03 04 05 06 07 08");
    CHECK(b.ask("0020 70 00000000000000") == toggle_bit);
    CHECK(b.ask("0020 60 0020 01 00000000") == command_specifier);
}

TEST_CASE("a total that differs from the announced size writes nothing") {
    bench b;
    CHECK(b.ask("0020 21 0020 01 0c000000 0102030405060708") == started);
    CHECK(b.ask("0020 05 090a0b0c0d0000") == too_high); // thirteen
    CHECK(b.ask("0020 21 0020 01 0c000000 0102030405060708") == started);
    CHECK(b.ask("0020 09 090a0b00000000") == too_low); // eleven
    CHECK(b.ask("0020 21 0020 01 0c000000") == started);
    CHECK(b.ask("0020 00 0102030405060708090a0b0c0d") == too_high); // not yet the last
    CHECK(b.objects.writes == 0);
    CHECK(b.stored() == nothing);
}

TEST_CASE("an object that exceeds the memory is aborted at the start") {
    bench b{32};
    CHECK(b.ask("0020 21 0020 01 21000000 0102030405060708") == exceeds_mailbox);
    CHECK(b.ask("0020 21 0020 01 ffffffff") == exceeds_mailbox);
    CHECK(b.ask("0020 21 0020 01 20000000") == started);
    b.objects.add(0x2000, 1, 33);
    CHECK(b.ask("0020 40 0020 01 00000000") == exceeds_mailbox);

    bench none{0};
    CHECK(none.ask("0020 21 0020 01 0c000000 0102030405060708") == exceeds_mailbox);
    CHECK(none.ask("0020 40 0020 01 00000000") == exceeds_mailbox);
    none.objects.add(0x2000, 1, 8);
    CHECK(none.ask("0020 40 0020 01 00000000") == "00 30 41 00 20 01 08 00 00 00 00 00 00 00 00 00 00 00");
}

TEST_CASE("a master's abort ends a transfer without an answer, whatever the other bits of its command") {
    for (const char* abort : {"0020 80 0020 01 00000405", "0020 9f 0020 01 00000405"}) {
        bench b;
        CHECK(b.ask("0020 21 0020 01 0c000000 0102030405060708") == started);
        CHECK(b.ask(abort).empty());
        CHECK(b.ask("0020 07 0020 01 0c000000") == command_specifier);
        CHECK(b.stored() == nothing);
        CHECK(b.ask("0020 40 0020 01 00000000").size() == 18 * 3 - 1);
        CHECK(b.ask(abort).empty());
        CHECK(b.ask("0020 60 0020 01 00000000") == command_specifier);
    }
}

TEST_CASE("a new request ends an abandoned transfer") {
    bench b;
    b.objects.add(0x2001, 0, 1);
    CHECK(b.ask("0020 21 0020 01 0c000000 0102030405060708") == started);
    CHECK(b.ask("0020 2f 0120 00 5a000000") == "00 30 60 01 20 00 00 00 00 00");
    CHECK(b.ask("0020 07 0020 01 0c000000") == command_specifier);
    CHECK(b.ask("0020 21 0020 01 0c000000") == started);
    CHECK(b.ask("0020 21 0020 01 0c000000") == started); // again, from the beginning
    CHECK(b.ask("0020 00 01020304050607") == "00 30 20 00 00 00 00 00 00 00");
    CHECK(b.ask("0020 15 08090a0b0c0000") == "00 30 30 00 00 00 00 00 00 00");
    CHECK(b.stored() == twelve);
}

TEST_CASE("a segment of the other direction ends a transfer") {
    bench b;
    CHECK(b.ask("0020 21 0020 01 0c000000 0102030405060708") == started);
    CHECK(b.ask("0020 60 00000000000000") == command_specifier);
    CHECK(b.ask("0020 40 0020 01 00000000").size() == 18 * 3 - 1);
    CHECK(b.ask("0020 07 090a0b0c000000") == command_specifier);
    CHECK(b.objects.writes == 0);
}

TEST_CASE("an object that refuses segmented data aborts after the last segment") {
    bench b;
    b.objects.entries.at({0x2000, 1}).write_abort = abort_code::value_range;
    CHECK(b.ask("0020 21 0020 01 0c000000 0102030405060708") == started);
    CHECK(b.ask("0020 07 090a0b0c000000") == abort_with("30 00 09 06"));
    CHECK(b.stored() == nothing);
}

TEST_CASE("the rest of a transfer is dropped on request and at power-on") {
    bench b;
    CHECK(b.ask("0020 21 0020 01 0c000000 0102030405060708") == started);
    b.server.forget_transfer();
    CHECK(b.ask("0020 07 0020 01 0c000000") == command_specifier);
    CHECK(b.ask("0020 21 0020 01 0c000000 0102030405060708") == started);
    b.server.power_on();
    CHECK(b.ask("0020 07 0020 01 0c000000") == command_specifier);
}
