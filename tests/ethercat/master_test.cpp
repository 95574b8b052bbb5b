// The master against emulated slaves: what it sends, how many frames it needs, what it reports.
#include "ethercat/objects.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/instant.hpp"
#include "support/simulated_link.hpp"
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/slave/loopback_link.hpp>
#include <jauscat/net/link/run_master.hpp>

#include <array>
#include <string>
#include <vector>

using namespace jauscat::ethercat;
using namespace std::chrono_literals;
using jauscat::test::counting;
using jauscat::test::from_hex;
using jauscat::test::simulated_link;
using jauscat::test::to_hex;
using support::instant;
namespace test = jauscat::test;

namespace {

using bytes = std::vector<std::byte>;

// One slave with two objects, a link and a master.
struct bench {
    test::objects objects{};
    std::array<slave, 1> devices;
    simulated_link link{devices};
    master_for<16> master;

    explicit bench(const slave_description& description = {.vendor = 1, .product = 2, .serial = 3},
                   const master_config& config = {})
        : devices{slave{description, objects}}, master{config} {
        objects.add(0x2002, 0, 1);
        objects.add(0x1AF5, 26, 28);
        objects.add(0x3000, 0, 600);
    }

    master_result<> bring_up(std::uint16_t position = 0, std::uint16_t station = 0x1001) {
        return link.run(master, jauscat::ethercat::bring_up{position, station}).error();
    }
    master_result<> download(std::uint16_t index, std::uint8_t subindex, const bytes& data) {
        return link.run(master, jauscat::ethercat::download{0x1001, index, subindex, data});
    }
    master_result<std::size_t> upload(std::uint16_t index, std::uint8_t subindex, bytes& into) {
        return test::size_of(link.run(master, jauscat::ethercat::upload{0x1001, index, subindex, into}));
    }
};

// The data of the first datagram of a frame, up to `size` bytes.
std::string front_of(const bytes& frame, std::size_t size) { return to_hex(std::span{frame}.subspan(26, size)); }

} // namespace

TEST_CASE("bring-up to PRE-OP takes 24 frames, or 18 with SII reads of 8 bytes") {
    bench four;
    REQUIRE(four.bring_up());
    CHECK(four.devices[0].state() == al_state::pre_op);
    CHECK(four.devices[0].station_address() == 0x1001);
    CHECK(four.master.statistics().sent == 24);
    REQUIRE(four.master.slaves().size() == 1);
    const auto& found = four.master.slaves()[0];
    CHECK(found.identity.vendor == 1);
    CHECK(found.identity.product == 2);
    CHECK(found.identity.serial == 3);
    CHECK(found.mailbox.receive_offset == 0x1000);
    CHECK(found.mailbox.send_size == 256);

    bench eight{{.vendor = 1, .serial = 0x04030201, .eight_byte_sii_reads = true}};
    REQUIRE(eight.bring_up());
    CHECK(eight.master.statistics().sent == 18);
    CHECK(eight.master.slaves()[0].identity.serial == 0x04030201);
    CHECK(eight.master.slaves()[0].mailbox.send_offset == 0x1600);
}

TEST_CASE("a slave is brought up again from PRE-OP and after an old error") {
    bench b;
    REQUIRE(b.bring_up());
    REQUIRE(b.download(0x2002, 0, counting(1)));
    REQUIRE(b.bring_up(0, 0x1002));
    CHECK(b.master.slaves().size() == 1);
    CHECK(b.devices[0].station_address() == 0x1002);
    const auto data = counting(1);
    CHECK(b.link.run(b.master, download{0x1002, 0x2002, 0, data}));

    // SAFE-OP straight from INIT leaves an error behind.
    b.devices[0].power_on();
    bytes frame(max_frame_size);
    frame_builder builder{frame};
    builder.add(command::bwr, 0, 0x0120, al_control{.state = al_state::safe_op});
    b.devices[0].process(*builder.finish());
    CHECK(b.bring_up());
}

TEST_CASE("a download of 28 bytes takes two frames, as does an upload") {
    bench b;
    REQUIRE(b.bring_up());
    const auto data = counting(28);
    REQUIRE(b.download(0x1AF5, 26, data)); // drains the mailbox first
    const auto before = b.master.statistics().sent;
    for (int i = 0; i != 100; ++i) REQUIRE(b.download(0x1AF5, 26, data));
    CHECK(b.master.statistics().sent - before == 200);
    CHECK(b.objects.entries.at({0x1AF5, 26}).value == data);

    bytes read(100);
    const auto result = b.upload(0x1AF5, 26, read);
    REQUIRE(result);
    CHECK(result == master_result<std::size_t>{28});
    read.resize(28);
    CHECK(read == data);
    CHECK(b.master.statistics().sent - before == 202);
}

TEST_CASE("the frames of a download equal the standard's byte for byte") {
    bench b;
    REQUIRE(b.bring_up());
    b.link.record = true;
    REQUIRE(b.download(0x1AF5, 26, counting(28)));
    REQUIRE(b.link.seen.size() == 3);
    CHECK(to_hex(std::span{b.link.seen[0]}.first(26)) ==
          "ff ff ff ff ff ff 00 00 00 00 00 00 88 a4 0c 11 04 19 01 10 00 16 00 01 00 00");
    CHECK(to_hex(std::span{b.link.seen[1]}.first(26)) ==
          "ff ff ff ff ff ff 00 00 00 00 00 00 88 a4 0c 11 05 1a 01 10 00 10 00 01 00 00");
    CHECK(front_of(b.link.seen[1], 46) == "26 00 00 00 00 13 00 20 21 f5 1a 1a 1c 00 00 00 "
                                          "01 02 03 04 05 06 07 08 09 0a 0b 0c 0d 0e 0f 10 11 12 13 14 15 16 17 18 19 "
                                          "1a 1b 1c 00 00");
    CHECK(b.link.seen[1].size() == 16 + 12 + 256);
    CHECK(to_hex(std::span{b.link.seen[2]}.first(26)) ==
          "ff ff ff ff ff ff 00 00 00 00 00 00 88 a4 0c 11 04 1b 01 10 00 16 00 01 00 00");

    b.link.seen.clear();
    REQUIRE(b.download(0x2002, 0, counting(1)));
    CHECK(front_of(b.link.seen[0], 16) == "0a 00 00 00 00 23 00 20 2f 02 20 00 01 00 00 00");
    bytes into(4);
    b.link.seen.clear();
    REQUIRE(b.upload(0x2002, 0, into));
    CHECK(front_of(b.link.seen[0], 16) == "0a 00 00 00 00 33 00 20 40 02 20 00 00 00 00 00");
    for (const std::size_t size : {std::size_t{2}, std::size_t{3}, std::size_t{4}}) {
        b.link.seen.clear();
        b.objects.add(0x2003, 0, size);
        REQUIRE(b.download(0x2003, 0, counting(size)));
        CHECK(front_of(b.link.seen[0], 9).substr(24) == (size == 2 ? "2b" : size == 3 ? "27" : "23"));
    }
}

TEST_CASE("the mailbox counter runs from 1 to 7 and restarts at 1") {
    bench b;
    REQUIRE(b.bring_up());
    REQUIRE(b.download(0x2002, 0, counting(1)));
    b.link.record = true;
    for (int i = 0; i != 8; ++i) REQUIRE(b.download(0x2002, 0, counting(1)));
    std::string counters;
    for (std::size_t i = 0; i != b.link.seen.size(); i += 2) counters += front_of(b.link.seen[i], 6).substr(15) + ' ';
    CHECK(counters == "23 33 43 53 63 73 13 23 ");
}

TEST_CASE("data can fill a mailbox, and one byte more needs segments, which a slave without them aborts") {
    bench b{{.mailbox_out_size = 44, .mailbox_in_size = 24}};
    REQUIRE(b.bring_up());
    CHECK(b.download(0x1AF5, 26, counting(28)));
    CHECK(b.download(0x1AF5, 26, counting(29)).error() ==
          master_error{.code = master_errc::sdo_abort, .abort = abort_code::exceeds_mailbox});
    CHECK(b.objects.entries.at({0x1AF5, 26}).value == counting(28));
    CHECK(b.download(0x2002, 0, {}).error() ==
          master_error{.code = master_errc::sdo_abort, .abort = abort_code::length_mismatch});

    bytes into(100);
    const auto too_large = b.upload(0x1AF5, 26, into);
    CHECK(too_large.error().code == master_errc::sdo_abort);
    CHECK(describe_reason(too_large.error()) == "the object is larger than the mailbox");
}

TEST_CASE("an upload that exceeds the caller's buffer is an error") {
    bench b;
    REQUIRE(b.bring_up());
    bytes small(27);
    const auto too_long = [](std::uint32_t bytes, std::uint32_t found) {
        return master_error{.code = master_errc::data_too_long, .bytes = bytes, .found_bytes = found};
    };
    CHECK(b.upload(0x1AF5, 26, small).error() == too_long(27, 28));
    bytes none;
    CHECK(b.upload(0x2002, 0, none).error() == too_long(0, 1));
}

TEST_CASE("an abort is reported with code and text, and the next transfer works") {
    bench b;
    REQUIRE(b.bring_up());
    const auto result = b.download(0x1AF6, 1, counting(28));
    CHECK(result.error().code == master_errc::sdo_abort);
    CHECK(static_cast<std::uint32_t>(result.error().abort) == 0x06020000);
    CHECK(describe_reason(result.error()) == "no such object in the dictionary");
    CHECK(b.download(0x1AF5, 26, counting(28)));
}

TEST_CASE("two slaves in a ring are brought up with separate objects") {
    test::objects first, second;
    first.add(0x2002, 0, 1);
    second.add(0x2002, 0, 1);
    std::array devices{slave{{.vendor = 1}, first},
                       slave{{.vendor = 2, .mailbox_out_size = 64, .mailbox_in_size = 64}, second}};
    simulated_link link{devices};
    master_for<16> m;
    REQUIRE(link.run(m, bring_up{0, 0x1001}));
    REQUIRE(link.run(m, bring_up{1, 0x1002}));
    CHECK(devices[0].station_address() == 0x1001);
    CHECK(devices[1].station_address() == 0x1002);
    REQUIRE(m.slaves().size() == 2);
    CHECK(m.slaves()[1].identity.vendor == 2);
    const auto one = counting(1);
    REQUIRE(link.run(m, download{0x1002, 0x2002, 0, one}));
    CHECK(first.writes == 0);
    CHECK(second.writes == 1);
    // There is no third slave.
    CHECK(link.run(m, bring_up{2, 0x1003}).error() == master_error{.code = master_errc::no_slave, .slaves = 2});
    CHECK(m.slaves().size() == 2);
    // The address of the first slave for the second one too.
    CHECK(link.run(m, bring_up{1, 0x1001}).error() ==
          master_error{.code = master_errc::duplicate_station, .working_counter = 2});
}

TEST_CASE("a request to an unknown station is refused before a frame is sent") {
    bench b;
    REQUIRE(b.bring_up());
    const auto sent = b.master.statistics().sent;
    const auto data = counting(1);
    REQUIRE(b.master.start(download{0x1002, 0x2002, 0, data}));
    CHECK(b.master.idle());
    CHECK(b.master.error() == master_error{.code = master_errc::wrong_station, .station = 0x1002});
    CHECK(b.master.statistics().sent == sent);
}

TEST_CASE("a second job is refused while one runs") {
    bench b;
    REQUIRE(b.master.start(bring_up{0, 1}));
    const auto data = counting(1);
    CHECK_FALSE(b.master.start(bring_up{0, 2}));
    CHECK_FALSE(b.master.start(download{1, 0x2002, 0, data}));
    CHECK(b.link.run(b.master));
}

TEST_CASE("a master supports as many slaves as it has memory for") {
    test::objects objects;
    std::vector<slave> devices(17, slave{{.mailbox_out_size = 24, .mailbox_in_size = 24}, objects});
    simulated_link link{devices};
    master_for<16> m;
    for (std::uint16_t i = 0; i != 16; ++i) REQUIRE(link.run(m, bring_up{i, static_cast<std::uint16_t>(i + 1)}));
    CHECK(link.run(m, bring_up{16, 17}).error().code == master_errc::too_many_slaves);
}

TEST_CASE("a master with too small a frame buffer reports the error") {
    bench b;
    bytes small(59);
    REQUIRE(b.master.start(bring_up{0, 1}));
    CHECK(b.master.next_frame(small, instant{0ns}) == 0);
    CHECK(b.master.idle());
    CHECK(b.master.error().code == master_errc::no_space);
}

TEST_CASE("the blocking driver runs a job over the loopback link") {
    test::objects objects;
    objects.add(0x2002, 0, 1);
    std::array devices{slave{{}, objects}};
    loopback_link link{devices};
    master_for<16> m;
    REQUIRE(jauscat::net::run(link, m, bring_up{0, 0x1001}));
    const auto data = from_hex("5a");
    REQUIRE(jauscat::net::run(link, m, download{0x1001, 0x2002, 0, data}));
    CHECK(objects.entries.at({0x2002, 0}).value == data);
    // No job: nothing to do, and the last result is kept.
    CHECK(jauscat::net::run(link, m));
}

TEST_CASE("a job that could not start does not return the running job's result") {
    test::objects objects;
    std::array devices{slave{{}, objects}};
    loopback_link link{devices};
    master_for<16> m;
    std::array<std::byte, 1> type{};
    REQUIRE(m.start(exchange_datagram{command::brd, 0, 0x0000, type})); // and its result is not fetched yet
    CHECK(jauscat::net::run(link, m, bring_up{0, 7}).error().code == master_errc::busy);
    CHECK(m.slaves().empty());
    REQUIRE(jauscat::net::run(link, m));
    CHECK(m.result<exchange_datagram>() == master_result<std::uint16_t>{1});
    CHECK(jauscat::net::run(link, m, bring_up{0, 7}));
    CHECK(m.slaves().size() == 1);
}

TEST_CASE("a check reports the state of a slave and whether its mailbox has a message") {
    test::objects objects;
    std::array devices{slave{{}, objects}};
    loopback_link link{devices};
    master_for<16> m;
    REQUIRE(jauscat::net::run(link, m, bring_up{0, 7}));
    REQUIRE(jauscat::net::run(link, m, check{7}));
    CHECK(m.find(7)->al.state == al_state::pre_op);
    CHECK_FALSE(m.find(7)->reply_waiting);

    auto request = from_hex("0a00 0000 00 13 0020 40 0220 00 00000000"); // an upload of another master's
    request.resize(m.find(7)->mailbox.receive_size);
    REQUIRE(
        jauscat::net::run(link, m, exchange_datagram{command::fpwr, 7, m.find(7)->mailbox.receive_offset, request}));
    REQUIRE(jauscat::net::run(link, m, check{7}));
    CHECK(m.find(7)->reply_waiting);
    REQUIRE(jauscat::net::run(link, m, collect_emergencies{7}));
    REQUIRE(jauscat::net::run(link, m, check{7}));
    CHECK_FALSE(m.find(7)->reply_waiting);

    devices[0].power_on();
    CHECK(jauscat::net::run(link, m, check{7}).error().code == master_errc::working_counter);
    CHECK(m.find(7)->al.state == al_state{}); // the old state is no news
    CHECK(jauscat::net::run(link, m, check{8}).error().code == master_errc::wrong_station);
}

TEST_CASE("the blocking driver reports a link that accepts no frames, and a passed deadline") {
    struct dead_link {
        bool takes{};
        bool send(std::span<const std::byte>) { return takes; }
        std::size_t receive(std::span<std::byte>, std::chrono::nanoseconds) { return 0; }
    };
    dead_link link{};
    master_for<16> m;
    CHECK(jauscat::net::run(link, m, bring_up{0, 1}).error().code == master_errc::not_sent);
    link.takes = true;
    CHECK(jauscat::net::run(link, m, bring_up{0, 1}, 1ms).error().code == master_errc::timeout);
    master_for<16> impatient{{.frame_timeout = 1ms, .retries = 2}};
    CHECK(jauscat::net::run(link, impatient, bring_up{0, 1}).error().code == master_errc::no_reply);
    CHECK(impatient.statistics().sent == 3);
}

TEST_CASE("every error of the master has a line of text") {
    for (unsigned code = 0; code <= static_cast<unsigned>(master_errc::no_space); ++code)
        CHECK(describe(static_cast<master_errc>(code)) != "unknown error");
    CHECK(describe_reason({.code = master_errc::al_error, .al_status = al_status_code{0x16}}) ==
          "invalid mailbox configuration for PRE-OP");
    CHECK(describe_reason({.code = master_errc::mailbox_error, .mailbox = mailbox_error_code{2}}) ==
          "the mailbox protocol is not supported");
    CHECK(describe_reason({.code = master_errc::sdo_abort, .abort = abort_code{0x12345678}}) == "unknown abort code");
    CHECK(describe_reason({.code = master_errc::no_reply}).empty());
    STATIC_REQUIRE(describe(abort_code::read_only) == "the object can only be read");
}
