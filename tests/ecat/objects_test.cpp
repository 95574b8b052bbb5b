// read, write and sdos of jauscat-ecat, with emulated slaves.
#include "ecat/tool.hpp"
#include "support/catch.hpp"

using namespace ecat_test;
using ethercat::al_state;

namespace {

/// Slaves without SDO information; the second one has objects of 4 and 2000 bytes.
struct bench {
    bench() {
        ring.with(1, [](auto& each) {
            each.own.add(0x2000, 0, 4);
            each.own.add(0x2001, 0, 2000);
        });
    }
    emulated_bus ring{three()};
};

} // namespace

TEST_CASE("emergencies that wait in a mailbox are printed when it is used") {
    bench b;
    REQUIRE(run("state pre-op --slave 1 --yes" + on(b.ring)).code == done);
    b.ring.with(1, [](auto& each) {
        CHECK(each.slave.send_emergency(
            {.error_code = 0x8110, .error_register = 0x11, .data = {std::byte{1}, std::byte{2}}}));
    });
    const auto ended = run("read 0x1008 --slave 1" + on(b.ring));
    INFO(ended.err);
    CHECK(ended.code == done);
    CHECK(ended.complains("emergency: error code 0x8110, error register 0x11, data 01 02 00 00 00\n"));
    CHECK_FALSE(run("read 0x1008 --slave 1" + on(b.ring)).complains("emergency"));
}

TEST_CASE("read shows entries of objects, and a slave in INIT is in INIT again") {
    bench b;
    const auto ended = run("read 0x1008 0x1018:0-4 --slave 1 --format json" + on(b.ring));
    INFO(ended.err);
    CHECK(ended.code == done);
    const auto rows = ended.parsed();
    REQUIRE(rows.size() == 6);
    CHECK(rows[0]["object"] == "0x1008:00");
    CHECK(rows[0]["bytes"] == "67726970706572");
    CHECK(rows[2]["index"] == 0x1018);
    CHECK(rows[2]["subindex"] == 1);
    CHECK(rows[2]["value"] == 7);
    CHECK(rows[5]["value"] == 11);
    CHECK(rows[5]["abort_code"] == nullptr);
    CHECK(run("read 0x1008 --type string --slave 1" + on(b.ring)).says("gripper"));
    CHECK(states(b.ring) == all_in(al_state::init));
    CHECK(stations(b.ring) == std::vector<std::uint16_t>{0, 0, 0});
}

TEST_CASE("read uses the mailbox of a slave in PRE-OP as it is") {
    bench b;
    REQUIRE(run("state pre-op --yes" + on(b.ring)).code == done);
    for (int i = 0; i != 8; ++i) CHECK(run("read 0x1018:1 --slave 1" + on(b.ring)).code == done);
    CHECK(states(b.ring) == all_in(al_state::pre_op));
}

TEST_CASE("read shows abort codes and goes on") {
    bench b;
    const auto ended = run("read 0x1018:4-5 0x5555 0x2000 --slave 1 --format json" + on(b.ring));
    CHECK(ended.code == failed);
    CHECK(ended.complains("object 0x5555:00: abort code 0x06020000: no such object in the dictionary"));
    const auto rows = ended.parsed();
    REQUIRE(rows.size() == 4);
    CHECK(rows[1]["abort_code"] == 0x06090011);
    CHECK(rows[2]["abort_code"] == 0x06020000);
    CHECK(rows[2]["value"] == nullptr);
    CHECK(rows[3]["value"] == 0);
}

TEST_CASE("with several slaves one is to be chosen, with a single one it is that") {
    bench b;
    const auto ended = run("read 0x1008" + on(b.ring));
    CHECK(ended.code == usage);
    CHECK(ended.complains("there are 3 slaves: choose one by --slave"));
    CHECK(run("read 0x1008 --alias 300" + on(b.ring)).code == done);
    const emulated_bus single{{{.vendor = 1}}};
    CHECK(run("read 0x1018:1" + on(single)).code == done);
}

TEST_CASE("write writes nothing without a yes") {
    bench b;
    const auto asked = run("write 0x2000 0x01020304 --type u32 --slave 1" + on(b.ring));
    CHECK(asked.code == not_confirmed);
    CHECK(asked.complains("Write 16909060 (0x01020304) (UNSIGNED32) to object 0x2000:00"));
    CHECK(run("read 0x2000 --slave 1 --format json" + on(b.ring)).parsed()[0]["value"] == 0);

    const auto written = run("write 0x2000 0x01020304 --type u32 --slave 1 --yes --format json" + on(b.ring));
    CHECK(written.code == done);
    CHECK(written.parsed()[0]["bytes"] == "04030201");
    CHECK(run("write 0x2000 -2 --type i32 --slave 1 --yes" + on(b.ring)).says("-2"));
    CHECK(run("write 0x2000 1.5 --type f32 --slave 1 --yes --format json" + on(b.ring)).parsed()[0]["value"] == 1.5);
    CHECK(states(b.ring) == all_in(al_state::init));
}

TEST_CASE("write transfers objects in segments") {
    bench b;
    const std::string data(4000, 'a');
    CHECK(
        run("write 0x2001 " + data + " --type bytes --slave 1 --yes --format json" + on(b.ring)).parsed()[0]["bytes"] ==
        data);
}

TEST_CASE("write needs a type where the slave states none, and explains an abort") {
    bench b;
    const auto untyped = run("write 0x2000 1 --slave 1 --yes" + on(b.ring));
    CHECK(untyped.code == usage);
    CHECK(untyped.complains("does not state the type of object 0x2000:00: give it by --type"));
    const auto aborted = run("write 0x1018:1 1 --type u32 --slave 1 --yes" + on(b.ring));
    CHECK(aborted.code == failed);
    CHECK(aborted.complains("abort code 0x06010002: the object can only be read"));
}

TEST_CASE("sdos lists what a slave states, and values by their type") {
    const emulated_bus ring{three(), true};
    const auto ended = run("sdos --values --slave 0 --format json" + on(ring));
    INFO(ended.err);
    CHECK(ended.code == done);
    const auto objects = ended.parsed();
    const auto mixture = std::ranges::find_if(objects, [](const json& each) { return each["index"] == 0x3000; });
    REQUIRE(mixture != objects.end());
    CHECK((*mixture)["name"] == "mixture");
    CHECK((*mixture)["code"] == "record");
    CHECK((*mixture)["entries"].size() == 5);
    CHECK((*mixture)["entries"][0]["value"] == 4);
    const auto table = run("sdos 0x1008-0x1018 --values --slave 0" + on(ring));
    CHECK(table.says("0x1018:01"));
    CHECK(table.says("axis"));
    CHECK_FALSE(table.says("0x3000"));
    // The type is known, so that write takes a number.
    CHECK(run("write 0x2002 7 --slave 0 --yes --format json" + on(ring)).parsed()[0]["type"] == "UNSIGNED32");
}

TEST_CASE("an entry without a name has the name of its object") {
    emulated_bus ring{three(), true};
    ring.with(1, [](auto& each) { each.other.are_entries_named = false; });
    CHECK(run("read 0x2002 --slave 1 --format json" + on(ring)).parsed()[0]["name"] == "gain");
    CHECK(run("sdos 0x2002 --slave 1 --format json" + on(ring)).parsed()[0]["entries"][0]["name"] == "gain");
}

TEST_CASE("sdos says what to do without SDO information") {
    bench b;
    const auto ended = run("sdos --slave 1" + on(b.ring));
    CHECK(ended.code == failed);
    CHECK(ended.complains("has no SDO information"));
}

TEST_CASE("a slave that does not work is named") {
    bench b;
    b.ring.with(1, [](auto& each) { each.hangs = true; });
    const auto ended = run("state pre-op --slave 1 --yes --frame-timeout 5" + on(b.ring));
    CHECK(ended.code == failed);
    CHECK(ended.complains("slave 1 on"));
}
