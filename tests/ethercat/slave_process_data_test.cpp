// Process data of emulated slaves: FMMUs, buffered SyncManagers, working counters, states and the watchdog, frame by
// frame as any master's.
#include "ethercat/objects.hpp"
#include "ethercat/slave_bench.hpp"
#include "support/instant.hpp"
#include <jauscat/ethercat/slave/standard_objects.hpp>

#include <chrono>
#include <deque>
#include <string>
#include <vector>

using namespace jauscat::ethercat;
using namespace std::chrono_literals;
using jauscat::test::from_hex;
using jauscat::test::to_hex;
using support::instant;
namespace test = jauscat::test;

namespace {

struct reply {
    std::uint16_t working_counter{};
    std::string data{};
    friend bool operator==(const reply&, const reply&) = default;
};

constexpr std::array two_words{pdo_entry{0x7000, 1, 16, 6, "effort x"}, pdo_entry{0x7000, 2, 16, 6, "effort y"}};
constexpr std::array byte_and_bits{pdo_entry{0x6000, 1, 8, 5, "count"}, pdo_entry{0x6000, 2, 1, 1, "ready"},
                                   pdo_entry{0x6000, 3, 1, 1, "fault"}};
constexpr slave_description two_ways{.vendor = 1, .outputs = two_words, .inputs = byte_and_bits};

// A chain of slaves of one kind and the means to send them single datagrams.
struct chain {
    test::objects objects{};
    std::deque<standard_objects> dictionaries{};
    std::deque<slave> slaves{};

    explicit chain(const slave_description& description, std::size_t count = 1) {
        for (std::size_t i = 0; i != count; ++i) {
            dictionaries.emplace_back(description, objects);
            slaves.emplace_back(description, dictionaries.back());
        }
    }

    reply send(command cmd, std::uint32_t address, const std::vector<std::byte>& data) {
        const auto process = [this](std::span<std::byte> frame) {
            for (auto& each : slaves) each.process(frame);
        };
        const auto back = test::send_through(process, cmd, static_cast<std::uint16_t>(address),
                                             static_cast<std::uint16_t>(address >> 16), data);
        return {back.working_counter, to_hex(back.data)};
    }
    // Registers and memory of the slave at a position.
    reply write(std::uint16_t ado, std::string_view hex, unsigned position = 0) {
        return send(command::apwr, std::uint32_t{ado} << 16 | static_cast<std::uint16_t>(-int(position)),
                    from_hex(hex));
    }
    reply read(std::uint16_t ado, std::size_t size, unsigned position = 0) {
        return send(command::aprd, std::uint32_t{ado} << 16 | static_cast<std::uint16_t>(-int(position)),
                    std::vector<std::byte>(size));
    }
    reply lrw(std::uint32_t address, std::string_view hex) { return send(command::lrw, address, from_hex(hex)); }
    reply lwr(std::uint32_t address, std::string_view hex) { return send(command::lwr, address, from_hex(hex)); }
    reply lrd(std::uint32_t address, std::size_t size) {
        return send(command::lrd, address, std::vector<std::byte>(size));
    }
    std::string state(std::string_view control, unsigned position = 0) {
        write(0x0120, control, position);
        return read(0x0130, 6, position).data;
    }
    void mailbox(unsigned position = 0) { write(0x0800, "0010 0001 26 00 01 00 0016 0001 22 00 01 00", position); }
    // As for two_ways: 4 bytes of outputs at logical 0, 2 bytes of inputs at logical 0x10.
    void to_op() {
        mailbox();
        CHECK(state("0200") == "02 00 00 00 00 00");
        write(0x0810, "001c 0400 64 00 01 00 0024 0200 20 00 01 00");
        write(0x0600, "00000000 0400 00 07 001c 00 02 01 000000 10000000 0200 00 07 0024 00 01 01 000000");
        CHECK(state("0400") == "04 00 00 00 00 00");
        CHECK(state("0800") == "08 00 00 00 00 00");
    }
};

} // namespace

TEST_CASE("five slaves in a chain answer one LRW through byte and bit FMMUs") {
    chain ring{two_ways, 5};
    for (unsigned n = 0; n != 5; ++n) {
        ring.mailbox(n);
        REQUIRE(ring.state("0200", n) == "02 00 00 00 00 00");
        ring.write(0x0810, "001c 0400 64 00 01 00 0024 0200 20 00 01 00", n);
        // Outputs: 4 bytes each from logical 0x10000 on. Inputs: the byte from logical 0x10014 on, one each, and the
        // two bits behind it packed from bit 4 of logical 0x10019 on: those of the third slave cross no byte border,
        // those of all five take 10 bits.
        const char* const outputs[] = {"00000100", "04000100", "08000100", "0c000100", "10000100"};
        const char* const counts[] = {"14000100", "15000100", "16000100", "17000100", "18000100"};
        const char* const bits[] = {"19000100 0100 04 05", "19000100 0100 06 07", "1a000100 0100 00 01",
                                    "1a000100 0100 02 03", "1a000100 0100 04 05"};
        ring.write(0x0600, std::string{outputs[n]} + "0400 00 07 001c 00 02 01 000000", n);
        ring.write(0x0610, std::string{counts[n]} + "0100 00 07 0024 00 01 01 000000", n);
        ring.write(0x0620, std::string{bits[n]} + "0124 00 01 01 000000", n);
        REQUIRE(ring.state("0400", n) == "04 00 00 00 00 00");
        REQUIRE(ring.state("0800", n) == "08 00 00 00 00 00");
        const auto inputs = ring.slaves[n].inputs();
        REQUIRE(inputs.size() == 2);
        inputs[0] = static_cast<std::byte>(0xA0 + n);
        inputs[1] = static_cast<std::byte>(n % 2 == 0 ? 1 : 2); // ready and fault, in turn
    }
    const auto got = ring.lrw(0x00010000, "01020304 11121314 21222324 31323334 41424344 0000000000 0f c0");
    CHECK(got.working_counter == 5 * 3);
    // 01 10 in bits 4 to 7, then 01 10 01; bits that no FMMU maps come back as they were sent.
    CHECK(got.data == "01 02 03 04 11 12 13 14 21 22 23 24 31 32 33 34 41 42 43 44 a0 a1 a2 a3 a4 9f d9");
    CHECK(to_hex(ring.slaves[0].outputs()) == "01 02 03 04");
    CHECK(to_hex(ring.slaves[2].outputs()) == "21 22 23 24");
    CHECK(to_hex(ring.slaves[4].outputs()) == "41 42 43 44");
    for (auto& each : ring.slaves) {
        CHECK(each.take_outputs());
        CHECK_FALSE(each.take_outputs());
    }
    CHECK(ring.lrd(0x00010014, 7) == reply{5, "a0 a1 a2 a3 a4 90 19"});
    CHECK(ring.lwr(0x00010000, "05060708") == reply{1, "05 06 07 08"});
    CHECK(to_hex(ring.slaves[0].outputs()) == "05 06 07 08");
    CHECK(ring.lrw(0x00020000, "0000") == reply{0, "00 00"}); // nobody is there
}

TEST_CASE("an FMMU maps bits of outputs without changing adjacent bits") {
    constexpr std::array bits{pdo_entry{0x7000, 1, 3, 5, "low"}, pdo_entry{0x7000, 2, 5, 5, "high"}};
    chain one{{.outputs = bits}};
    one.mailbox();
    one.state("0200");
    one.write(0x0810, "001c 0100 24 00 01 00");
    // Three bits from logical bit 6 of byte 0 on are bits 0 to 2; five bits from bit 1 of byte 2 on are bits 3 to 7.
    one.write(0x0600, "00000000 0200 06 00 001c 00 02 01 000000 02000000 0100 01 05 001c 03 02 01 000000");
    CHECK(one.state("0400") == "04 00 00 00 00 00");
    CHECK(one.state("0800") == "08 00 00 00 00 00");
    CHECK(one.lwr(0, "c0 00 00").working_counter == 1);
    CHECK(to_hex(one.slaves[0].outputs()) == "03");
    CHECK(one.lwr(0, "40 01 3e").working_counter == 1);
    CHECK(to_hex(one.slaves[0].outputs()) == "fd");
    CHECK(one.lwr(2, "00").working_counter == 1); // the other FMMU's bits stay
    CHECK(to_hex(one.slaves[0].outputs()) == "05");
    CHECK(one.lrw(1, "00") == reply{2, "00"}); // one bit of three
    CHECK(to_hex(one.slaves[0].outputs()) == "01");
}

TEST_CASE("an FMMU maps the state of a mailbox to a bit") {
    chain one{{}};
    one.mailbox();
    one.state("0200");
    one.write(0x0600, "00000000 0100 00 00 0d08 03 01 01 000000");
    CHECK(one.lrd(0, 1) == reply{1, "00"});
    auto request = from_hex("0a00 0000 00 13 0020 40 0020 00 00000000");
    request.resize(256);
    CHECK(one.send(command::apwr, 0x10000000, request).working_counter == 1);
    CHECK(one.lrd(0, 1) == reply{1, "01"});
}

TEST_CASE("process data are closed below SAFE-OP, and outputs apply in OP only") {
    chain one{two_ways};
    one.mailbox();
    one.state("0200");
    one.write(0x0810, "001c 0400 64 00 01 00 0024 0200 20 00 01 00");
    one.write(0x0600, "00000000 0400 00 07 001c 00 02 01 000000 10000000 0200 00 07 0024 00 01 01 000000");
    CHECK(one.read(0x0810, 16).data == "00 1c 04 00 64 00 01 01 00 24 02 00 20 00 01 01");
    CHECK(one.lrd(0x10, 2) == reply{0, "00 00"});
    CHECK(one.lwr(0, "01020304").working_counter == 0);
    one.slaves[0].inputs()[1] = std::byte{3};

    CHECK(one.state("0400") == "04 00 00 00 00 00");
    CHECK(one.lrd(0x10, 2) == reply{1, "00 03"});
    CHECK(one.lwr(0, "01020304").working_counter == 1);
    CHECK(to_hex(one.slaves[0].outputs()) == "00 00 00 00");
    CHECK_FALSE(one.slaves[0].take_outputs());

    CHECK(one.state("0800") == "08 00 00 00 00 00");
    CHECK(one.lwr(0, "01020304").working_counter == 1);
    CHECK(to_hex(one.slaves[0].outputs()) == "01 02 03 04");
    CHECK(one.slaves[0].take_outputs());
    CHECK(one.read(0x0815, 3).data == "21 01 00"); // written twice: the third buffer holds the last
    CHECK(one.read(0x081D, 3).data == "02 01 00"); // read
    // Half of the outputs is none: they change hands with the last byte, and open with the first.
    CHECK(one.lwr(0, "1111").working_counter == 1);
    CHECK_FALSE(one.slaves[0].take_outputs());
    CHECK(one.lwr(2, "2222").working_counter == 1);
    CHECK(to_hex(one.slaves[0].outputs()) == "11 11 22 22");
    CHECK(one.lwr(2, "3333").working_counter == 0);
    // A SyncManager has one direction.
    CHECK(one.read(0x1C00, 4).working_counter == 0);
    CHECK(one.write(0x2400, "0000").working_counter == 0);
    CHECK(one.read(0x2400, 2) == reply{1, "00 03"});

    CHECK(one.state("0200") == "02 00 00 00 00 00");
    CHECK(one.lwr(0, "01020304").working_counter == 0);
    CHECK(to_hex(one.slaves[0].outputs()) == "11 11 22 22"); // the application looks at the state
    one.slaves[0].power_on();
    CHECK(to_hex(one.slaves[0].outputs()) == "00 00 00 00");
}

TEST_CASE("SAFE-OP and OP need the SyncManagers that the slave describes") {
    chain one{two_ways};
    one.mailbox();
    one.state("0200");
    CHECK(one.state("0400") == "12 00 00 00 1d 00");
    one.write(0x0810, "001c 0500 64 00 01 00"); // one byte too many
    CHECK(one.state("1400") == "12 00 00 00 1d 00");
    one.write(0x0816, "00");
    one.write(0x0810, "001c 0400 64 00 01 00");
    CHECK(one.state("1400") == "12 00 00 00 1e 00");
    one.write(0x0818, "0024 0200 22 00 01 00"); // a mailbox
    CHECK(one.state("1400") == "12 00 00 00 1e 00");
    one.write(0x081E, "00");
    one.write(0x0818, "0024 0200 20 00 01 00");
    CHECK(one.state("1400") == "04 00 00 00 00 00");
    one.write(0x0816, "00");
    CHECK(one.state("0800") == "14 00 00 00 1d 00");
    one.write(0x0816, "01");
    CHECK(one.state("1800") == "08 00 00 00 00 00");

    const std::vector<pdo_entry> large(86, pdo_entry{0x7000, 1, 64, 0x1B, ""}); // 688 bytes
    chain too_much{{.outputs = large}};
    too_much.mailbox();
    too_much.state("0200");
    CHECK(too_much.state("0400") == "12 00 00 00 25 00");
    const std::vector<pdo_entry> many(129, pdo_entry{0x6000, 1, 8, 5, ""});
    chain too_many{{.inputs = many}};
    too_many.mailbox();
    too_many.state("0200");
    CHECK(too_many.state("0400") == "12 00 00 00 24 00");

    chain inputs_only{{.inputs = byte_and_bits}};
    inputs_only.mailbox();
    inputs_only.state("0200");
    inputs_only.write(0x0810, "001c 0000 64 00 00 00 0024 0200 20 00 01 00");
    CHECK(inputs_only.state("0400") == "04 00 00 00 00 00");
    CHECK(inputs_only.state("0800") == "08 00 00 00 00 00");
}

TEST_CASE("a slave without outputs for the watchdog time goes to SAFE-OP with an error") {
    chain one{two_ways};
    CHECK(one.read(0x0400, 2).data == "c2 09");
    CHECK(one.read(0x0410, 2).data == "e8 03");
    CHECK(one.read(0x0420, 2).data == "e8 03");
    one.to_op();
    auto& device = one.slaves[0];
    CHECK(one.read(0x0440, 2).data == "01 00");
    device.on_time(instant{5s}); // the time begins with the first look
    one.lwr(0, "01020304");
    device.on_time(instant{5050ms});
    device.on_time(instant{5149ms});
    CHECK(device.state() == al_state::op);
    device.on_time(instant{5150ms});
    CHECK(one.read(0x0130, 6).data == "14 00 00 00 1b 00");
    CHECK(one.read(0x0440, 4).data == "00 00 01 00"); // expired once
    CHECK(one.lwr(0, "05060708").working_counter == 1);
    CHECK(to_hex(device.outputs()) == "01 02 03 04");
    CHECK(one.state("0800") == "14 00 00 00 1b 00"); // not acknowledged
    CHECK(one.state("1800") == "08 00 00 00 00 00");
    device.on_time(instant{9s});
    device.on_time(instant{9099ms});
    CHECK(device.state() == al_state::op);

    one.write(0x0420, "1400"); // 2 ms
    device.on_time(instant{9099ms + 1us});
    CHECK(device.state() == al_state::safe_op);
    CHECK(one.read(0x0442, 1).data == "02");
    CHECK(one.write(0x0443, "55").working_counter == 1); // clears both
    CHECK(one.read(0x0442, 2).data == "00 00");
    one.write(0x0420, "0000"); // off
    CHECK(one.state("1800") == "08 00 00 00 00 00");
    device.on_time(instant{20s});
    device.on_time(instant{30s});
    CHECK(device.state() == al_state::op);

    one.write(0x0420, "e803");
    one.write(0x0816, "00");
    one.write(0x0810, "001c 0400 24 00 01 00"); // a SyncManager without watchdog
    device.on_time(instant{40s});
    device.on_time(instant{50s});
    CHECK(device.state() == al_state::op);
}

TEST_CASE("the SII describes process data") {
    const auto image = make_sii_image(two_ways);
    CHECK(image.size() == 512);
    const auto bytes = to_hex(image);
    const auto contains = [&](std::string_view hex) { return bytes.find(to_hex(from_hex(hex))) != std::string::npos; };
    CHECK(contains("28 00 01 00 01 02"));
    CHECK(contains("29 00 10 00 00 10 00 01 26 00 01 01 00 16 00 01 22 00 01 02"
                   "00 1c 04 00 64 00 01 03 00 24 02 00 20 00 01 04"));
    CHECK(contains("32 00 10 00 00 1a 03 03 00 03 11 00"
                   "00 60 01 06 05 08 00 00 00 60 02 07 01 01 00 00 00 60 03 08 01 01 00 00"));
    CHECK(contains("33 00 0c 00 00 16 02 02 00 02 11 00"
                   "00 70 01 04 06 10 00 00 00 70 02 05 06 10 00 00 ff ff"));
    // Strings: the slave, both PDOs, and each entry.
    CHECK(contains("0a 00 21 00 08 0d 4a 61 75 73 43 61 74 20 73 6c 61 76 65 07 4f 75 74 70 75 74 73"
                   "06 49 6e 70 75 74 73 08 65 66 66 6f 72 74 20 78"));

    // The largest that a slave can have: names go as far as there is room.
    const std::vector<pdo_entry> many(128, pdo_entry{0x7000, 1, 40, 0, "sixteen letters!"});
    const auto large = make_sii_image({.outputs = many, .inputs = many});
    CHECK(large.size() == 4096);
    CHECK(to_hex(std::span{large}.subspan(0x3E * 2, 8)) == "1f 00 01 00 0a 00 6a 03");
    CHECK(to_hex(std::span{large}.last(2)) == "ff ff");
}

TEST_CASE("a large SII announces two-byte addresses") {
    const std::vector<pdo_entry> many(128, pdo_entry{0x7000, 1, 40, 0, ""});
    chain one{{.vendor = 0x11223344, .outputs = many}};
    one.write(0x0502, "0001 08000000");
    CHECK(one.read(0x0502, 10).data == "00 00 08 00 00 00 44 33 22 11");
    chain both{{.vendor = 0x11223344, .outputs = many, .inputs = many}};
    both.write(0x0502, "0001 08000000");
    CHECK(both.read(0x0502, 10).data == "80 00 08 00 00 00 44 33 22 11");
}

TEST_CASE("standard objects hold assignment and mapping") {
    test::objects application;
    standard_objects objects{two_ways, application};
    const auto read = [&](std::uint16_t index, std::uint8_t subindex) {
        std::vector<std::byte> value(64);
        const auto got = objects.read(index, subindex, value);
        if (got.error != abort_code::none) return std::to_string(static_cast<std::uint32_t>(got.error));
        value.resize(got.size);
        return to_hex(value);
    };
    CHECK(read(0x1C00, 0) == "04");
    CHECK(read(0x1C00, 1) == "01");
    CHECK(read(0x1C00, 2) == "02");
    CHECK(read(0x1C00, 3) == "03");
    CHECK(read(0x1C00, 4) == "04");
    CHECK(read(0x1C12, 0) == "01");
    CHECK(read(0x1C12, 1) == "00 16");
    CHECK(read(0x1C13, 0) == "01");
    CHECK(read(0x1C13, 1) == "00 1a");
    CHECK(read(0x1C13, 2) == std::to_string(0x06090011));
    CHECK(read(0x1600, 0) == "02");
    CHECK(read(0x1600, 2) == "10 02 00 70");
    CHECK(read(0x1A00, 0) == "03");
    CHECK(read(0x1A00, 3) == "01 03 00 60");
    CHECK(objects.write(0x1C12, 0, from_hex("00")) == abort_code::read_only);
    CHECK(objects.write(0x1600, 3, from_hex("00000000")) == abort_code::no_subindex);

    standard_objects none{{}, application};
    std::vector<std::byte> value(4);
    CHECK(none.read(0x1C12, 0, value).error == abort_code::no_object);
    CHECK(none.read(0x1600, 0, value).error == abort_code::no_object);
}

TEST_CASE("the port status shows a master which slaves have others behind them") {
    chain two{{}, 2};
    two.slaves[0].set_downstream(true);
    CHECK(two.read(0x0110, 2, 0).data == "30 5a");
    CHECK(two.read(0x0110, 2, 1).data == "10 56");
    two.slaves[0].power_on();
    CHECK(two.read(0x0110, 2, 0).data == "30 5a");
}

TEST_CASE("registers that a master reads or clears at start-up exist") {
    chain one{{}};
    CHECK(one.read(0x0000, 10) == reply{1, "11 01 01 00 08 08 08 0f 00 00"}); // bits in FMMUs, LRW, no clock
    CHECK(one.write(0x0300, "0000000000000000").working_counter == 1);
    CHECK(one.read(0x0300, 20).working_counter == 1);
    CHECK(one.write(0x0910, "0000000000000000").working_counter == 1);
    CHECK(one.write(0x0981, "00").working_counter == 1);
    CHECK(one.read(0x0900, 256) == reply{1, to_hex(std::vector<std::byte>(256))});
    CHECK(one.read(0x0600, 128) == reply{1, to_hex(std::vector<std::byte>(128))});
    one.write(0x0600, "ffffffffffffffffffffffffffffffff");
    CHECK(one.read(0x0600, 16).data == "ff ff ff ff ff ff ff ff ff ff ff ff ff 00 00 00");
}
