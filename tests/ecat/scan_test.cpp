// scan, info and state of jauscat-ecat, with emulated slaves.
#include "ecat/tool.hpp"
#include "support/catch.hpp"

using namespace ecat_test;
using ethercat::al_state;

TEST_CASE("scan lists the slaves as JSON, with nine members each, and changes nothing") {
    emulated_bus ring{three()};
    const auto ended = run("scan --format json" + on(ring));
    CHECK(ended.code == done);
    CHECK(ended.err.empty());
    CHECK(ended.parsed() == json::parse(R"([
        {"position": 0, "station": 0, "alias": 0, "vendor": 7, "product": 1, "revision": 3, "serial": 10,
         "name": "axis", "state": "INIT"},
        {"position": 1, "station": 0, "alias": 300, "vendor": 7, "product": 2, "revision": 1, "serial": 11,
         "name": "gripper", "state": "INIT"},
        {"position": 2, "station": 0, "alias": 0, "vendor": 7, "product": 1, "revision": 1, "serial": 12,
         "name": "axis", "state": "INIT"}])"));
    CHECK(states(ring) == all_in(al_state::init));
    CHECK(stations(ring) == std::vector<std::uint16_t>{0, 0, 0});
}

TEST_CASE("scan lists the slaves as a table") {
    const emulated_bus ring{three()};
    const auto ended = run("scan" + on(ring));
    CHECK(ended.code == done);
    CHECK(ended.out == "position  station  alias  vendor      product     revision    serial  name     state\n"
                       "       0        0      0  0x00000007  0x00000001  0x00000003      10  axis     INIT\n"
                       "       1        0    300  0x00000007  0x00000002  0x00000001      11  gripper  INIT\n"
                       "       2        0      0  0x00000007  0x00000001  0x00000001      12  axis     INIT\n");
}

TEST_CASE("a slave without a name has an empty one") {
    const emulated_bus ring{{{.vendor = 9, .product = 1, .name = ""}}};
    const auto ended = run("scan --format json" + on(ring));
    CHECK(ended.code == done);
    REQUIRE(ended.parsed().size() == 1);
    CHECK(ended.parsed()[0]["name"] == "");
}

TEST_CASE("info shows controller, mailbox and ports") {
    const emulated_bus ring{three()};
    const auto one = run("info --slave 1 --format json" + on(ring));
    CHECK(one.code == done);
    const auto all = one.parsed();
    REQUIRE(all.size() == 1);
    CHECK(all[0]["name"] == "gripper");
    CHECK(all[0]["alias"] == 300);
    CHECK(all[0]["mailbox"]["protocols"] == json::array({"CoE"}));
    CHECK(all[0]["mailbox"]["receive_size"] == 256);
    CHECK(all[0]["ports"].size() == 2);
    CHECK(all[0]["controller"]["fmmus"] == 8);
    CHECK(run("info --alias 300" + on(ring)).says("gripper"));
    CHECK(run("info --format json" + on(ring)).parsed().size() == 3);
}

TEST_CASE("a slave that is not there is named") {
    const emulated_bus ring{three()};
    const auto position = run("info --slave 3" + on(ring));
    CHECK(position.code == failed);
    CHECK(position.complains("there is no slave 3: the positions are 0 to 2"));
    const auto alias = run("info --alias 7" + on(ring));
    CHECK(alias.code == failed);
    CHECK(alias.complains("no slave has the alias 7"));
}

TEST_CASE("state takes slaves to another state, if it may, and leaves station addresses alone") {
    static const std::vector<ethercat::pdo_entry> inputs{
        {.index = 0x6000, .subindex = 1, .bits = 16, .data_type = 6, .name = "position"}};
    auto slaves = three();
    slaves[2].inputs = inputs;
    emulated_bus ring{slaves};
    const auto asked = run("state pre-op" + on(ring));
    CHECK(asked.code == not_confirmed);
    CHECK(asked.complains("Take 3 slaves on " + ring.where() + " to PRE-OP?"));
    CHECK(asked.complains("use --yes"));
    CHECK(states(ring) == all_in(al_state::init));

    const auto taken = run("state pre-op --yes --format json" + on(ring));
    CHECK(taken.code == done);
    CHECK(taken.parsed()[2] == json{{"position", 2}, {"station", 0}, {"state", "PRE-OP"}, {"al_status_code", 0}});
    CHECK(states(ring) == all_in(al_state::pre_op));
    CHECK(run("state safe-op --slave 2 --yes" + on(ring)).code == done);
    CHECK(states(ring).back() == al_state::safe_op);
    CHECK(stations(ring) == std::vector<std::uint16_t>{0, 0, 0});
    CHECK(run("state" + on(ring)).says("SAFE-OP"));
    CHECK(run("state INIT --yes" + on(ring)).code == done);
    CHECK(states(ring) == all_in(al_state::init));
}

TEST_CASE("state takes slaves without outputs to OP, and leaves others in SAFE-OP") {
    static const std::vector<ethercat::pdo_entry> entries{
        {.index = 0x6000, .subindex = 1, .bits = 16, .data_type = 6, .name = "position"}};
    auto slaves = three();
    slaves[1].outputs = entries;
    slaves[2].inputs = entries;
    emulated_bus ring{slaves};
    const auto ended = run("state op --yes" + on(ring));
    CHECK(ended.code == failed);
    CHECK(ended.complains("slave 1 on " + ring.where() + ": it has outputs: in OP they would be in force"));
    CHECK_FALSE(ended.complains("slave 2"));
    CHECK(states(ring) == std::vector{al_state::op, al_state::safe_op, al_state::op});
    CHECK(stations(ring) == std::vector<std::uint16_t>{0, 0, 0});
    // They are no running master's.
    CHECK(run("watch --slave 2 --seconds 0.01" + on(ring)).code == done);
    CHECK(run("state op --slave 1 --yes" + on(ring)).code == failed); // already in SAFE-OP
    CHECK(run("state safe-op --slave 2 --yes" + on(ring)).code == done);
    CHECK(run("state op --slave 2 --yes" + on(ring)).code == done);
    CHECK(states(ring) == std::vector{al_state::op, al_state::safe_op, al_state::op});
    CHECK(run("state init --yes" + on(ring)).code == done);
    CHECK(states(ring) == all_in(al_state::init));
}

TEST_CASE("state says why a slave refuses") {
    emulated_bus ring{three()};
    const auto ended = run("state boot --slave 1 --yes" + on(ring));
    CHECK(ended.code == failed);
    CHECK(ended.complains("slave 1 on " + ring.where() +
                          ": the state BOOT was refused: AL status code 0x0013: bootstrap is not supported"));
    CHECK(ended.says("INIT ERROR"));
    CHECK(run("state init --slave 1 --yes" + on(ring)).code == done);
    CHECK(run("scan" + on(ring)).out.find("ERROR") == std::string::npos);
}
