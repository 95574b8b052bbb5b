// The emulated slave, register by register and frame by frame, as foreign masters see it.
#include "ethercat/objects.hpp"
#include "ethercat/slave_bench.hpp"

#include <random>
#include <string>
#include <vector>

using namespace jauscat::ethercat;
using jauscat::test::from_hex;
using jauscat::test::to_hex;
namespace test = jauscat::test;

namespace {

struct reply {
    std::uint16_t working_counter{};
    std::uint16_t adp{};
    std::string data{};
    friend bool operator==(const reply&, const reply&) = default;
};

// One slave and the means to send it single datagrams.
struct bench {
    test::objects objects{};
    slave device;

    explicit bench(const slave_description& description = {}) : device{description, objects} {}

    reply send(command cmd, std::uint16_t adp, std::uint16_t ado, const std::vector<std::byte>& data) {
        const auto back = through(cmd, adp, ado, data);
        return {back.working_counter, back.adp, to_hex(back.data)};
    }
    reply write(std::uint16_t ado, std::string_view hex) { return send(command::apwr, 0, ado, from_hex(hex)); }
    reply read(std::uint16_t ado, std::size_t size) {
        return send(command::aprd, 0, ado, std::vector<std::byte>(size));
    }

    // Mailboxes as the default description has them: 256 bytes at 0x1000 and at 0x1600.
    void to_pre_op() {
        write(0x0800, "0010 0001 26 00 01 00 0016 0001 22 00 01 00");
        write(0x0120, "0200");
        REQUIRE(read(0x0130, 6).data == "02 00 00 00 00 00");
    }
    std::uint16_t put_mail(std::string_view hex, std::size_t size = 256) {
        auto message = from_hex(hex);
        message.resize(size);
        return send(command::apwr, 0, 0x1000, message).working_counter;
    }
    std::string take_mail(std::size_t size = 256) {
        return test::mail_in(through(command::aprd, 0, 0x1600, std::vector<std::byte>(size)));
    }

  private:
    test::returned_datagram through(command cmd, std::uint16_t adp, std::uint16_t ado,
                                    std::span<const std::byte> data) {
        return test::send_through([this](std::span<std::byte> frame) { device.process(frame); }, cmd, adp, ado, data);
    }
};

} // namespace

TEST_CASE("each command reads, writes and counts as in the standard") {
    bench b;
    b.write(0x0010, "0110");
    const auto at = [&](command cmd, std::uint16_t adp) { return b.send(cmd, adp, 0x1000, from_hex("f0")); };
    const auto cell = [&] { return b.read(0x1000, 1).data; };
    const auto set = [&] { b.write(0x1000, "0f"); };

    set();
    CHECK(at(command::nop, 0) == reply{0, 0, "f0"});
    CHECK(at(command::aprd, 0) == reply{1, 1, "0f"});
    CHECK(at(command::aprd, 0xFFFF) == reply{0, 0, "f0"});
    CHECK(at(command::apwr, 1) == reply{0, 2, "f0"});
    CHECK(cell() == "0f");
    CHECK(at(command::apwr, 0) == reply{1, 1, "f0"});
    CHECK(cell() == "f0");
    set();
    CHECK(at(command::aprw, 0) == reply{3, 1, "0f"});
    CHECK(cell() == "f0");
    set();
    CHECK(at(command::fprd, 0x1001) == reply{1, 0x1001, "0f"});
    CHECK(at(command::fprd, 0x1002) == reply{0, 0x1002, "f0"});
    CHECK(at(command::fprw, 0x1001) == reply{3, 0x1001, "0f"});
    CHECK(cell() == "f0");
    set();
    CHECK(at(command::fpwr, 0x1001) == reply{1, 0x1001, "f0"});
    CHECK(cell() == "f0");
    set();
    CHECK(at(command::brd, 5) == reply{1, 6, "ff"});
    CHECK(at(command::brw, 5) == reply{3, 6, "ff"});
    CHECK(cell() == "f0");
    set();
    CHECK(at(command::bwr, 0) == reply{1, 1, "f0"});
    CHECK(cell() == "f0");
    for (const auto logical : {command::lrd, command::lwr, command::lrw}) CHECK(at(logical, 0) == reply{0, 0, "f0"});
    set();
    CHECK(at(command::armw, 0) == reply{1, 1, "0f"});
    CHECK(cell() == "0f");
    CHECK(at(command::armw, 3) == reply{1, 4, "f0"});
    CHECK(cell() == "f0");
    set();
    CHECK(at(command::frmw, 0x1001) == reply{1, 0x1001, "0f"});
    CHECK(cell() == "0f");
    CHECK(at(command::frmw, 0x1002) == reply{1, 0x1002, "f0"});
    CHECK(cell() == "f0");
    CHECK(at(static_cast<command>(15), 0) == reply{0, 0, "f0"});
}

TEST_CASE("a slave answers to its alias only while the alias is enabled") {
    bench b{{.station_alias = 0x0055}};
    CHECK(b.read(0x0012, 2).data == "55 00");
    CHECK(b.send(command::fprd, 0x55, 0, from_hex("00")).working_counter == 0);
    b.write(0x0100, "00000001");
    CHECK(b.send(command::fprd, 0x55, 0, from_hex("00")).working_counter == 1);
}

TEST_CASE("a slave marks the source address and does not change frames of other protocols") {
    bench b;
    auto frame = from_hex("ffffffffffff 00aa00000000 88a4 0d10 07 05 0000 0000 0100 0000 00 0000");
    b.device.process(frame);
    CHECK(frame[6] == std::byte{0x02});
    auto other = from_hex("ffffffffffff 00aa00000000 0800 0d10 07 05 0000 0000 0100 0000 00 0000");
    const auto before = other;
    b.device.process(other);
    CHECK(other == before);
}

TEST_CASE("read-only registers of a slave controller cannot be overwritten") {
    bench b;
    const auto before = b.read(0x0000, 16).data;
    CHECK(b.write(0x0000, "ffffffffffffffffffffffffffffffff").working_counter == 1);
    CHECK(b.read(0x0000, 16).data == before);
    CHECK(b.write(0x0130, "0800").working_counter == 1);
    CHECK(b.read(0x0130, 2).data == "01 00");
    b.write(0x0805, "ff00ff");
    CHECK(b.read(0x0805, 3).data == "00 00 00");
}

TEST_CASE("an access beyond the memory, or of no bytes, does not count") {
    bench b;
    CHECK(b.read(0x2FFF, 1).working_counter == 1);
    CHECK(b.read(0x2FFF, 2).working_counter == 0);
    CHECK(b.read(0xFFFF, 2).working_counter == 0);
    CHECK(b.read(0x1000, 0).working_counter == 0);
}

TEST_CASE("a SyncManager keeps its area while it is enabled") {
    bench b;
    b.write(0x0800, "0010 8000 26 00 01 00");
    b.write(0x0800, "0020 4000 22 00 01 00");
    CHECK(b.read(0x0800, 8).data == "00 10 80 00 26 00 01 00");
    b.write(0x0806, "00");
    b.write(0x0800, "0020 4000 22 00 01 00");
    CHECK(b.read(0x0800, 8).data == "00 20 40 00 22 00 01 00");
}

TEST_CASE("the SII is read in 4 or 8 bytes and only while the master owns it") {
    bench four{{.vendor = 0x11223344, .product = 0x55667788}};
    CHECK(four.write(0x0502, "0001 08000000").working_counter == 1);
    CHECK(four.read(0x0502, 14).data == "00 00 08 00 00 00 44 33 22 11 00 00 00 00");
    CHECK(four.write(0x0500, "01").working_counter == 1);
    four.write(0x0502, "0001 0a000000");
    CHECK(four.read(0x0508, 4).data == "44 33 22 11");
    four.write(0x0500, "02");
    four.write(0x0500, "00");
    four.write(0x0502, "0001 0a000000");
    CHECK(four.read(0x0508, 4).data == "88 77 66 55");
    four.write(0x0502, "0001 ff0f0000");
    CHECK(four.read(0x0508, 4).data == "ff ff ff ff");
    four.write(0x0502, "0003 08000000"); // no command that there is
    CHECK(four.read(0x0502, 2).data == "00 20");

    bench eight{{.vendor = 0x11223344, .product = 0x55667788, .eight_byte_sii_reads = true}};
    eight.write(0x0502, "0001 08000000");
    CHECK(eight.read(0x0502, 14).data == "40 00 08 00 00 00 44 33 22 11 88 77 66 55");
}

TEST_CASE("the SII is busy until the slave has read it") {
    bench b{{.vendor = 1}};
    auto frame = from_hex("ffffffffffff 000000000000 88a4 1210 02 00 0000 0205 0600 0000 0001 08000000 0000");
    b.device.pass(frame);
    auto poll = from_hex("ffffffffffff 000000000000 88a4 0e10 01 00 0000 0205 0200 0000 0000 0000");
    b.device.pass(poll);
    CHECK(to_hex(std::span{poll}.subspan(26, 4)) == "00 81 01 00");
    b.device.work();
    CHECK(b.read(0x0502, 2).data == "00 00");
}

TEST_CASE("a master writes the SII word by word, and the slave loads its alias from there") {
    bench b{{.vendor = 0x11223344, .station_alias = 5}};
    const auto write = [&](std::string_view word, std::string_view data) {
        CHECK(b.write(0x0502, "0102" + std::string{word} + std::string{data}).working_counter == 1);
        return b.read(0x0502, 2).data;
    };
    const auto read = [&](std::string_view word) {
        b.write(0x0502, "0001" + std::string{word});
        return b.read(0x0508, 4).data;
    };
    CHECK(write("40000000", "abcd") == "00 00");
    CHECK(read("40000000").starts_with("ab cd"));
    b.write(0x0502, "0002 40000000 1234"); // not enabled
    CHECK(b.read(0x0502, 2).data == "00 40");
    CHECK(read("40000000").starts_with("ab cd"));
    CHECK(write("ffff0000", "0000") == "00 20"); // beyond the memory

    CHECK(b.read(0x0012, 2).data == "05 00");
    CHECK(write("04000000", "0900") == "00 00");
    CHECK(b.read(0x0012, 2).data == "05 00"); // what it has loaded
    b.write(0x0502, "0004");
    CHECK(b.read(0x0502, 2).data == "00 08"); // the checksum is that of alias 5
    CHECK(b.read(0x0012, 2).data == "00 00");
    const auto image = make_sii_image({.vendor = 0x11223344, .station_alias = 9});
    CHECK(write("07000000", to_hex(std::span{image}.subspan(14, 2))) == "00 08");
    b.device.power_on();
    CHECK(b.read(0x0502, 2).data == "00 00");
    CHECK(b.read(0x0012, 2).data == "09 00");
}

TEST_CASE("a slave with a whole SII is written to in a copy of it") {
    std::vector<std::byte> sii(4096 + 512, std::byte{7});
    const auto image = make_sii_image({.vendor = 1, .station_alias = 3});
    std::ranges::copy(image, sii.begin());
    bench b{{.sii = sii}};
    CHECK(b.read(0x0012, 2).data == "03 00");
    b.write(0x0502, "0102 40000000 1234");
    b.write(0x0502, "0001 40000000");
    CHECK(b.read(0x0508, 4).data.starts_with("12 34"));
    CHECK(sii[0x80] == image[0x80]);
    b.write(0x0502, "0001 00080000"); // behind what is kept
    CHECK(b.read(0x0508, 4).data == "07 07 07 07");
    b.write(0x0502, "0102 00080000 1234");
    CHECK(b.read(0x0502, 2).data == "80 20");
}

TEST_CASE("the SII describes the slave and its checksum is right") {
    const auto image = make_sii_image({.vendor = 0x6A5, .product = 2, .revision = 3, .serial = 4, .name = "arm"});
    CHECK(to_hex(std::span{image}.first(32)) == "80 00 00 00 00 00 00 00 00 00 00 00 00 00 e9 00 "
                                                "a5 06 00 00 02 00 00 00 03 00 00 00 04 00 00 00");
    CHECK(to_hex(std::span{image}.subspan(0x18 * 2, 10)) == "00 10 00 01 00 16 00 01 04 00");
    CHECK(to_hex(std::span{image}.subspan(0x3E * 2, 16)) == "03 00 01 00 0a 00 03 00 01 03 61 72 6d 00 1e 00");
    // The checksum of a configuration that an independent slave carries: words 0 to 7 of a recorded SII.
    CHECK(sii_checksum(from_hex("8002006eff00ff00000000000000")) == 0xB6);
}

TEST_CASE("states go up one at a time, and every refusal has its code") {
    bench b;
    const auto ask = [&](std::string_view control) {
        b.write(0x0120, control);
        return b.read(0x0130, 6).data;
    };
    CHECK(ask("0200") == "11 00 00 00 16 00"); // no mailbox yet
    CHECK(ask("0200") == "11 00 00 00 16 00"); // not acknowledged
    CHECK(ask("1100") == "01 00 00 00 00 00");
    CHECK(ask("0400") == "11 00 00 00 11 00");
    CHECK(ask("1300") == "11 00 00 00 13 00");
    CHECK(ask("1700") == "11 00 00 00 12 00");
    b.write(0x0800, "0010 0001 26 00 01 00 0016 0002 22 00 01 00"); // SyncManager 1 of another size
    CHECK(ask("1200") == "11 00 00 00 16 00");
    b.write(0x080E, "00");
    b.write(0x0808, "0016 0001 22 00 01 00");
    CHECK(ask("1200") == "02 00 00 00 00 00");
    CHECK(ask("0800") == "12 00 00 00 11 00");
    CHECK(ask("1200") == "02 00 00 00 00 00");
    CHECK(ask("0400") == "04 00 00 00 00 00");
    CHECK(ask("0800") == "08 00 00 00 00 00");
    CHECK(ask("0200") == "02 00 00 00 00 00");
    CHECK(ask("0100") == "01 00 00 00 00 00");
}

TEST_CASE("SDO requests are answered byte for byte") {
    bench b;
    b.objects.add(0x2002, 0, 1);
    b.objects.add(0x6926, 1, 28);
    b.objects.entries[{0x2010, 0}].write_abort = abort_code::read_only;
    b.to_pre_op();
    const auto ask = [&](std::string_view request) {
        CHECK(b.put_mail(request) == 1);
        return b.take_mail();
    };
    CHECK(ask("0a00 0000 00 13 0020 2f 0220 00 5a000000") == "0a 00 00 00 00 13 00 30 60 02 20 00 00 00 00 00");
    CHECK(ask("0a00 0000 00 23 0020 40 0220 00 00000000") == "0a 00 00 00 00 23 00 30 4f 02 20 00 5a 00 00 00");
    const std::string data = "00 01 02 03 04 05 06 07 08 09 0a 0b 0c 0d 0e 0f 10 11 12 13 14 15 16 17 18 19 1a 1b";
    CHECK(ask("2600 0000 00 33 0020 21 2669 01 1c000000" + data) == "0a 00 00 00 00 33 00 30 60 26 69 01 00 00 00 00");
    CHECK(ask("0a00 0000 00 43 0020 40 2669 01 00000000") == "26 00 00 00 00 43 00 30 41 26 69 01 1c 00 00 00 " + data);
    // The size bit clear, as one public master sends it.
    CHECK(ask("2600 0000 00 53 0020 20 2669 01 1c000000" + data) == "0a 00 00 00 00 53 00 30 60 26 69 01 00 00 00 00");
    CHECK(b.objects.writes == 3);
    // Aborts: read-only, no such object, wrong size, complete access, unknown specifier, more than a mailbox.
    CHECK(ask("0a00 0000 00 63 0020 23 1020 00 44332211") == "0a 00 00 00 00 63 00 20 80 10 20 00 02 00 01 06");
    CHECK(ask("0a00 0000 00 73 0020 40 5555 01 00000000") == "0a 00 00 00 00 73 00 20 80 55 55 01 00 00 02 06");
    CHECK(ask("0a00 0000 00 13 0020 2b 0220 00 5a5a0000") == "0a 00 00 00 00 13 00 20 80 02 20 00 10 00 07 06");
    CHECK(ask("0a00 0000 00 23 0020 50 0220 00 00000000") == "0a 00 00 00 00 23 00 20 80 02 20 00 04 00 01 06");
    CHECK(ask("0a00 0000 00 33 0020 60 0220 00 00000000") == "0a 00 00 00 00 33 00 20 80 02 20 00 01 00 04 05");
    CHECK(ask("0e00 0000 00 43 0020 21 2669 01 e8030000 01020304") ==
          "0a 00 00 00 00 43 00 20 80 26 69 01 05 00 01 06");
    CHECK(ask("0e00 0000 00 53 0020 21 2669 01 03000000 01020304") ==
          "0a 00 00 00 00 53 00 20 80 26 69 01 10 00 07 06");
    b.objects.add(0x3000, 0, 241);
    CHECK(ask("0a00 0000 00 63 0020 40 0030 00 00000000") == "0a 00 00 00 00 63 00 20 80 00 30 00 05 00 01 06");
    // Mailbox errors: another protocol, too short, longer than the mailbox, another CoE service.
    CHECK(ask("0a00 0000 00 74 0000 00 0000 00 00000000") == "04 00 00 00 00 70 01 00 02 00");
    CHECK(ask("0100 0000 00 13 00") == "04 00 00 00 00 10 01 00 06 00");
    CHECK(ask("0500 0000 00 23 0020 40 0220") == "04 00 00 00 00 20 01 00 06 00");
    CHECK(ask("fb00 0000 00 33 0020 40 0220 00 00000000") == "04 00 00 00 00 30 01 00 08 00");
    CHECK(ask("0a00 0000 00 43 0080 01 0000 00 00000000") == "04 00 00 00 00 40 01 00 04 00");
    CHECK(ask("0a00 0000 00 53 0020 80 0220 00 00000405").empty()); // an abort needs no answer
}

TEST_CASE("a mailbox works in PRE-OP, opens at its first byte and is handed over at its last") {
    bench b;
    b.objects.add(0x2002, 0, 1);
    b.write(0x0800, "0010 0001 26 00 01 00 0016 0001 22 00 01 00");
    const std::string upload = "0a00 0000 00 13 0020 40 0220 00 00000000";
    CHECK(b.put_mail(upload) == 1);
    CHECK(b.read(0x0805, 1).data == "09"); // full, and nobody takes it in INIT
    CHECK(b.put_mail(upload) == 0);
    CHECK(b.read(0x1600, 256).working_counter == 0);
    b.write(0x0120, "0200"); // a slave forgets what came before
    CHECK(b.read(0x0130, 2).data == "02 00");
    b.write(0x1001, "00");
    CHECK(b.send(command::apwr, 0, 0x1001, std::vector<std::byte>(255)).working_counter == 0);
    CHECK(b.put_mail("0a00 0000 00 14", 200) == 1);
    CHECK(b.read(0x080D, 1).data == "00");
    CHECK(b.send(command::apwr, 0, 0x10C8, std::vector<std::byte>(56)).working_counter == 1);
    CHECK(b.take_mail() == "04 00 00 00 00 10 01 00 02 00"); // a protocol it does not have
    CHECK(b.send(command::aprd, 0, 0x1000, std::vector<std::byte>(256)).working_counter == 0);
    CHECK(b.send(command::apwr, 0, 0x1600, std::vector<std::byte>(256)).working_counter == 0);
}

TEST_CASE("a full reply mailbox delays the next request") {
    bench b;
    b.objects.add(0x2002, 0, 1);
    b.to_pre_op();
    CHECK(b.put_mail("0a00 0000 00 13 0020 2f 0220 00 01000000") == 1);
    CHECK(b.put_mail("0a00 0000 00 23 0020 2f 0220 00 02000000") == 1);
    CHECK(b.put_mail("0a00 0000 00 33 0020 2f 0220 00 03000000") == 0);
    CHECK(b.objects.writes == 1);
    CHECK(b.take_mail() == "0a 00 00 00 00 13 00 30 60 02 20 00 00 00 00 00");
    CHECK(b.objects.writes == 2);
    CHECK(b.take_mail() == "0a 00 00 00 00 23 00 30 60 02 20 00 00 00 00 00");
    CHECK(b.take_mail().empty());
}

TEST_CASE("a repeated request is not executed twice, and a lost reply is sent again") {
    bench b;
    b.objects.add(0x2002, 0, 1);
    b.to_pre_op();
    const std::string request = "0a00 0000 00 13 0020 2f 0220 00 01000000";
    const std::string response = "0a 00 00 00 00 13 00 30 60 02 20 00 00 00 00 00";
    b.write(0x080E, "03"); // nothing was sent yet: acknowledged, but there is nothing to give
    CHECK(b.read(0x080D, 3).data == "00 03 02");
    CHECK(b.put_mail(request) == 1);
    CHECK(b.take_mail() == response);
    CHECK(b.put_mail(request) == 1);
    CHECK(b.take_mail().empty());
    CHECK(b.objects.writes == 1);
    b.write(0x080E, "01");
    CHECK(b.read(0x080D, 3).data == "09 01 00");
    CHECK(b.take_mail() == response);
    CHECK(b.take_mail().empty());
    b.write(0x0120, "0100");
    b.to_pre_op(); // from INIT a slave starts afresh, whatever the counter
    CHECK(b.put_mail(request) == 1);
    CHECK(b.take_mail() == response);
    CHECK(b.objects.writes == 2);
}

TEST_CASE("an emergency is the next message that a master reads, and is sent again if it is lost") {
    bench b;
    b.objects.add(0x2002, 0, 1);
    CHECK_FALSE(b.device.send_emergency({.error_code = 0x8110})); // in INIT
    b.to_pre_op();
    CHECK(b.device.send_emergency({.error_code = 0x8110, .error_register = 0x11, .data = {std::byte{1}}}));
    CHECK(b.put_mail("0a00 0000 00 13 0020 2f 0220 00 01000000") == 1);
    CHECK(b.take_mail() == "0a 00 00 00 00 13 00 30 60 02 20 00 00 00 00 00"); // the request was there first
    const std::string sent = "0a 00 00 00 00 23 00 10 10 81 11 01 00 00 00 00";
    CHECK(b.take_mail() == sent);
    b.write(0x080E, "03");
    CHECK(b.take_mail() == sent);
    CHECK(b.take_mail().empty());
    for (std::uint16_t i = 0; i != slave_mailbox::max_emergencies; ++i)
        CHECK(b.device.send_emergency({.error_code = i}));
    CHECK_FALSE(b.device.send_emergency({.error_code = 4}));
    b.read(0x0130, 2); // a frame passes
    for (const auto* code : {"00 00", "01 00", "02 00", "03 00"}) CHECK(b.take_mail().substr(24, 5) == code);
    CHECK(b.take_mail().empty());
    CHECK(b.device.send_emergency({}));
    b.device.power_on();
    b.to_pre_op();
    CHECK(b.take_mail().empty());

    bench none{{.mailbox_out_size = 0, .mailbox_in_size = 0}};
    none.write(0x0120, "0200");
    CHECK_FALSE(none.device.send_emergency({}));
}

TEST_CASE("a slave with the smallest mailbox keeps its answers within it") {
    bench b{{.mailbox_out_size = 24, .mailbox_in_size = 24}};
    b.objects.add(0x2002, 0, 8);
    b.write(0x0800, "0010 1800 26 00 01 00 0016 1800 22 00 01 00");
    b.write(0x0120, "0200");
    CHECK(b.put_mail("1200 0000 00 13 0020 21 0220 00 08000000 0102030405060708", 24) == 1);
    CHECK(b.take_mail(24) == "0a 00 00 00 00 13 00 30 60 02 20 00 00 00 00 00");
    CHECK(b.put_mail("0a00 0000 00 23 0020 40 0220 00 00000000", 24) == 1);
    CHECK(b.take_mail(24) == "12 00 00 00 00 23 00 30 41 02 20 00 08 00 00 00 01 02 03 04 05 06 07 08");
}

TEST_CASE("a slave described with an impossible mailbox refuses PRE-OP") {
    bench small{{.mailbox_out_size = 23}};
    small.write(0x0800, "0010 1700 26 00 01 00 0016 0001 22 00 01 00");
    small.write(0x0120, "0200");
    CHECK(small.read(0x0130, 6).data == "11 00 00 00 16 00");
    bench outside{{.mailbox_in_offset = 0x2F80}};
    outside.write(0x0800, "0010 0001 26 00 01 00 802f 0001 22 00 01 00");
    outside.write(0x0120, "0200");
    CHECK(outside.read(0x0130, 6).data == "11 00 00 00 16 00");
}

TEST_CASE("a slave survives 100000 random frames") {
    bench b;
    b.objects.add(0x2002, 0, 1);
    b.objects.add(0x2003, 1, 28);
    std::mt19937 random{7};
    const std::vector<std::uint16_t> places{0x0000, 0x0010, 0x0100, 0x0120, 0x0130, 0x0500, 0x0502,
                                            0x0504, 0x0508, 0x0800, 0x0806, 0x080E, 0x1000, 0x1600};
    std::size_t answered = 0;
    for (int round = 0; round != 100'000; ++round) {
        if (round % 100 == 0) {
            b.device.power_on();
            b.to_pre_op();
        }
        std::vector<std::byte> frame(max_frame_size);
        frame_builder builder{frame};
        const bool mail = random() % 2 == 0;
        const std::uint16_t ado = mail ? 0x1000 : places[random() % places.size()];
        const auto data =
            builder.add(static_cast<command>(mail ? 2 : random() % 16),
                        static_cast<std::uint16_t>(random() % 8 == 0 ? random() : 0), ado, mail ? 256 : random() % 300);
        for (auto& byte : data) byte = static_cast<std::byte>(random() % 4 == 0 ? random() : 0);
        if (mail) {
            const auto valid = from_hex("0a00 0000 00 13 0020 40 0320 01 00000000");
            for (std::size_t i = 0; i != valid.size(); ++i)
                data[i] = random() % 16 == 0 ? static_cast<std::byte>(random()) : valid[i];
        }
        const auto size = builder.finish()->size();
        if (random() % 4 == 0) frame[random() % size] = static_cast<std::byte>(random());
        const std::size_t cut = random() % 16 == 0 ? random() % (size + 1) : size;
        b.device.process(std::span{frame}.first(cut));
        answered += b.read(0x1600, 256).working_counter;
    }
    CHECK(answered > 10'000);
}

TEST_CASE("a slave relies on the lengths of the datagrams, not on that of the frame") {
    jauscat::test::objects objects;
    slave device{{.vendor = 1, .product = 2}, objects};
    const auto made = [](std::initializer_list<std::size_t> sizes) {
        std::vector<std::byte> frame(max_frame_size);
        frame_builder builder{frame};
        for (const auto size : sizes) builder.add(command::brd, 0, 0, size);
        frame.resize(builder.finish()->size());
        return frame;
    };
    for (const int extra : {0, 1, 12, -13, 900}) {
        INFO(extra);
        auto frame = made({1});
        const auto length = static_cast<unsigned>(std::to_integer<int>(frame[14]) + extra);
        frame[14] = static_cast<std::byte>(length & 0xFF);
        frame[15] = static_cast<std::byte>(0x10 | (length >> 8 & 7));
        device.process(frame);
        CHECK(frame[16 + 10 + 1] == std::byte{1}); // the working counter
    }
    // A datagram that the frame does not hold whole is not executed, and those before it are.
    auto frame = made({1, 100});
    frame.pop_back();
    device.process(frame);
    CHECK(frame[16 + 10 + 1] == std::byte{1});
}
