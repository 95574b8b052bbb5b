// JAUS messages in EtherCAT captures: recorded ones, and frames made for the purpose.
#include "ethercat_frames.hpp"
#include "support/catch.hpp"

using namespace dump_test;

namespace {

const std::string own_seed = support::test_data("ethercat_jauscat_seed.pcap");
const std::string own_self_contained = support::test_data("ethercat_jauscat_self_contained.pcap");

// Set Wrench Effort from 1.1.32.1, sequence number 34, under the seed table: 12 bytes for object 1B15h:26.
const std::string wrench = "0602 01200101 2200 0100 ff3f";
const std::string download = "0020 21 151b 1a 0c000000" + wrench;
const std::string confirmation = "0030 60 151b 1a 00000000";

// The same in two segments of 6 bytes.
const std::string begin_segments = "0020 21 151b 1a 0c000000";
const std::string first_segment = "0020 02 0602 01200101 00";   // toggle 0, 1 byte unused
const std::string last_segment = "0020 13 2200 0100 ff3f 00";   // toggle 1, 1 byte unused, last
const std::string confirmed_segment = "0030 20 00000000000000"; // toggle 0
const std::string confirmed_last_segment = "0030 30 0000000000000000";

std::vector<std::string> names_of(const outcome& result) {
    std::vector<std::string> names;
    for (const auto& object : result.objects())
        names.push_back(object.at("message").is_null() ? "-" : object.at("message").get<std::string>());
    return names;
}
json summary_of(const std::string& arguments, const std::vector<datagram>& datagrams) {
    return run_ring(arguments + " --format json --summary", datagrams).objects().at(0);
}

} // namespace

TEST_CASE("the messages between controller and arm are shown, under both tables and in segments") {
    for (const auto& [arguments, heartbeats] :
         {std::pair{"seed --subsystem 2 " + own_seed, 4}, {"self-contained " + own_self_contained, 3}}) {
        INFO(arguments);
        const auto result = run("--format json --ethercat " + arguments);
        CHECK(result.code == 1); // the message that is aborted is broken
        CHECK(result.err.empty());
        const auto objects = result.objects();
        std::map<std::string, int> messages;
        for (const auto& object : objects) {
            if (!object.contains("refusal")) ++messages[object.at("message").get<std::string>()];
            CHECK(object.at("header").at("destination") ==
                  json{{"subsystem", 2}, {"node", 2}, {"component", 33}, {"instance", 1}});
        }
        CHECK(messages == std::map<std::string, int>{{"Report Heartbeat Pulse", heartbeats},
                                                     {"Report Wrench Effort", 1},
                                                     {"Query Wrench Effort", 1},
                                                     {"Set Wrench Effort", 4}});
    }
}

TEST_CASE("a message between controller and arm has its fields, station and object") {
    for (const auto& arguments : {"seed --subsystem 2 " + own_seed, "self-contained " + own_self_contained}) {
        INFO(arguments);
        const auto command =
            run("--format json --name set_wrench_effort --from 1.1.32.1 --ethercat " + arguments).objects().at(0);
        CHECK(command.at("header").at("data_size") == 20); // more than a mailbox of 32 bytes takes at once
        CHECK(command.at("header").at("ack_nak") == 1);
        CHECK(command.at("fields").at("propulsive_rotational_effort_y").at("raw") == -16383);
        CHECK(command.at("origin").at("from") == "master");
        CHECK(command.at("origin").at("to") == "station 2");
        CHECK(command.at("origin").at("object") == "0x1B15:26");

        const auto report = run("--format json --code 4405 --to 2.2.33 --ethercat " + arguments).objects().at(0);
        CHECK(report.at("fields").at("propulsive_rotational_effort_y").at("raw") == -16383);
        CHECK(report.at("origin").at("from") == "station 2");
        CHECK(report.at("origin").at("to") == "master");
        CHECK(report.at("origin").at("object") == "0x1B15:121");

        const auto text = run("--ethercat " + arguments);
        CHECK(text.says("\n         EtherCAT: download to station 2, object 0x1B15:26\n         presence_vector"));
        CHECK(text.says("\n         EtherCAT: upload from station 2, object 0x1B15:121\n         presence_vector"));
    }
}

TEST_CASE("an abort is shown with the refused message, its code and its text") {
    for (const auto& arguments : {"seed --subsystem 2 " + own_seed, "self-contained " + own_self_contained}) {
        INFO(arguments);
        const auto objects = run("--format json --from 1.1.32.1 --code 0405 --ethercat " + arguments).objects();
        REQUIRE(objects.size() == 3); // all efforts; the cut one; its refusal
        const auto& refused = objects[2];
        CHECK(refused.at("message") == "Set Wrench Effort");
        CHECK(refused.at("header").at("sequence_number") == 99);
        CHECK(refused.at("refusal") ==
              json{{"by", "slave"}, {"what", "SDO abort"}, {"code", "0x06090030"}, {"text", "value out of range"}});
        const auto text = run("--ethercat " + arguments);
        CHECK(text.says("         refused: SDO abort 0x06090030: value out of range\n"));
        CHECK(text.says("1 refused: Set Wrench Effort: SDO abort 0x06090030: value out of range\n"));
    }
}

TEST_CASE("in captures of other stacks only the objects of components are messages") {
    const auto soem = run("--ethercat seed " + support::test_data("ethercat_soem_soes.pcap"));
    CHECK(soem.says("EtherCAT: download to station 4097 (0x1001), object 0x1B1A:1\n"));
    CHECK(soem.says("refused: SDO abort 0x06010003: "));
    CHECK(soem.says("8 skipped: SDO of an object that is not a JAUS component's\n"));
    const std::string kickcat = support::test_data("ethercat_kickcat.pcap");
    CHECK(run("--ethercat seed " + kickcat).says("\n0 messages\n"));
    const auto other_base = run("--ethercat seed --index-base 0x6900 " + kickcat);
    CHECK(other_base.says("EtherCAT: download to station 1001 (0x03E9), object 0x6926:1\n"));
    CHECK(other_base.says("EtherCAT: upload from station 1001 (0x03E9), object 0x6926:1\n"));
}

TEST_CASE("a message is shown once, in however many frames it is") {
    auto out = write_to(2, 1, download);
    out.working_counter = 0;
    auto repeated = write_to(2, 1, download);
    repeated.index = 9;
    const auto result = run_ring("seed --format json", {out, write_to(2, 1, download), repeated,
                                                        read_from(2, 1, confirmation), read_from(2, 1, confirmation),
                                                        write_to(2, 2, download), read_from(2, 2, confirmation)});
    CHECK(result.code == 0);
    CHECK(names_of(result) == std::vector<std::string>{"Set Wrench Effort", "Set Wrench Effort"});
    CHECK(result.objects()[0].at("origin").at("packet") == 2);
    CHECK(result.objects()[1].at("origin").at("packet") == 6);

    // Without a counter, another frame is another message.
    repeated = write_to(2, 0, download);
    repeated.index = 9;
    CHECK(run_ring("seed --format json", {write_to(2, 0, download), write_to(2, 0, download), repeated})
              .objects()
              .size() == 2);
    // After a change of state to INIT the counters begin anew.
    const datagram init{.cmd = fpwr, .adp = 2, .ado = 0x0120, .data = "0100", .working_counter = 1};
    CHECK(run_ring("seed --format json", {write_to(2, 1, download), init, write_to(2, 1, download)}).objects().size() ==
          2);
}

TEST_CASE("a message that no slave read is counted and not shown") {
    auto out = write_to(2, 1, download);
    out.working_counter = 0;
    const auto summary = summary_of("seed", {out, out, out});
    CHECK(summary.at("decoded") == 0);
    CHECK(summary.at("skipped") == json{{"EtherCAT mailbox message that no slave took: working counter 0", 1}});
}

TEST_CASE("segments are assembled for each station") {
    std::vector<datagram> frames;
    for (const auto& [request, answer] : {std::pair{begin_segments, confirmation},
                                          {first_segment, confirmed_segment},
                                          {last_segment, confirmed_last_segment}})
        for (const std::uint16_t station : {std::uint16_t{2}, std::uint16_t{3}}) {
            const unsigned counter = static_cast<unsigned>(frames.size() / 4 + 1);
            frames.push_back(write_to(station, counter, request));
            frames.push_back(read_from(station, counter, answer));
        }
    const auto result = run_ring("seed --subsystem 7 --format json", frames);
    CHECK(result.code == 0);
    const auto objects = result.objects();
    REQUIRE(objects.size() == 2);
    for (const std::size_t i : {0U, 1U}) {
        CHECK(objects[i].at("header").at("destination") ==
              json{{"subsystem", 7}, {"node", 2 + i}, {"component", 33}, {"instance", 1}});
        CHECK(objects[i].at("fields").at("propulsive_linear_effort_x").at("raw") == 16383);
    }
}

TEST_CASE("missing segments make a transfer incomplete") {
    const auto expect_incomplete = [](const std::vector<datagram>& frames) {
        const auto result = run_ring("seed --format json --summary", frames);
        CHECK(result.code == 1);
        CHECK(result.objects().at(0).at("incomplete_transfers") == 1);
        CHECK(result.objects().at(0).at("decoded") == 0);
    };
    expect_incomplete({write_to(2, 1, begin_segments)});
    expect_incomplete({write_to(2, 1, begin_segments), write_to(2, 2, last_segment)});
    expect_incomplete({write_to(2, 1, begin_segments), write_to(2, 2, "0020 03 0602 01200101 00")}); // last: too few
    CHECK(run_ring("seed", {write_to(2, 1, begin_segments)}).says("1 incomplete SDO transfers of messages\n"));

    const auto late = summary_of("seed", {write_to(2, 2, first_segment), write_to(2, 3, last_segment)});
    CHECK(late.at("skipped") == json{{"SDO message of a transfer that began before the capture", 2}});
}

TEST_CASE("a transfer can be aborted by the master, and refused by the mailbox") {
    const auto given_up =
        run_ring("seed", {write_to(2, 1, begin_segments), write_to(2, 2, "0020 80 151b 1a 00000405")});
    CHECK(given_up.says("         aborted by the master: SDO abort 0x05040000: SDO protocol timeout\n"));
    auto error = read_from(2, 1, "");
    error.data = "0400 0000 00 10 0100 0600" + std::string(100, '0');
    const auto refused = run_ring("seed --format json", {write_to(2, 1, download), error}).objects();
    REQUIRE(refused.size() == 2);
    CHECK(refused[1].at("refusal").at("what") == "mailbox error");
    CHECK(refused[1].at("refusal").at("code") == "0x0006");

    // An abort of an upload, whose message has no header yet: what its object says.
    const auto upload = run_ring("seed --format json", {write_to(2, 1, "0020 40 151b 79 00000000"),
                                                        read_from(2, 1, "0020 80 151b 79 24000008")});
    REQUIRE(names_of(upload) == std::vector<std::string>{"Report Wrench Effort"});
    CHECK(upload.objects()[0].at("refusal").at("text") == "no data available");
    CHECK(upload.objects()[0].at("header").at("destination").at("component") == 33);
    CHECK(upload.code == 0);
}

TEST_CASE("a late answer is not used for another object") {
    const std::string late_data = "0030 41 151b 1a 0c000000" + wrench; // of an upload that was given up
    const auto result =
        run_ring("seed --format json", {write_to(2, 1, "0020 40 1810 01 00000000"), read_from(2, 1, late_data)});
    REQUIRE(names_of(result) == std::vector<std::string>{"Set Wrench Effort"});
    CHECK(result.objects()[0].at("origin").at("object") == "0x1B15:26");

    const auto refused =
        run_ring("seed --format json", {write_to(2, 1, download), read_from(2, 1, "0030 60 1810 01 00000000"),
                                        read_from(2, 2, "0020 80 151b 1a 00000008")})
            .objects();
    REQUIRE(refused.size() == 2);
    CHECK(refused[1].at("refusal").at("text") == "general error");
}

TEST_CASE("a slave addressed by position is shown with its station address, if known") {
    auto out = write_to(0, 1, download);
    out.cmd = apwr;
    out.adp = 0xFFFF; // the second slave; each of three increments it
    out.working_counter = 0;
    auto back = out;
    back.adp = 2;
    back.working_counter = 1;
    const auto unknown = run_ring("seed --format json", {out, back}).objects();
    REQUIRE(unknown.size() == 1);
    CHECK(unknown[0].at("origin").at("to") == "slave at position 1");
    CHECK(unknown[0].at("header").at("destination").at("node") == 0);

    const datagram name_out{.cmd = apwr, .adp = 0xFFFF, .ado = 0x0010, .data = "0500", .index = 7};
    auto name_back = name_out;
    name_back.adp = 2;
    name_back.working_counter = 1;
    const auto known = run_ring("seed --format json", {name_out, name_back, out, back}).objects();
    REQUIRE(known.size() == 1);
    CHECK(known[0].at("origin").at("to") == "station 5");
    CHECK(known[0].at("header").at("destination").at("node") == 5);
}

TEST_CASE("EtherCAT is read after VLAN tags, in UDP, and beside JAUS in UDP") {
    const scratch files;
    const auto frame = ring_frame(write_to(2, 1, download));
    const std::string status = "0602 0240 01200101 01210101 0500 0700 0100000000";
    auto in_udp = udp_packet(ring_frame(write_to(3, 1, download)));
    in_udp.replace(in_udp.rfind("0ed2 0ed2"), 9, "0ed2 88a4");
    write_capture(files / "ring", link_ethernet,
                  {"ffffffffffff 020000000001 8100 0005 88a4" + frame, ethernet_frame(in_udp),
                   ethernet_frame(udp_packet(status))});
    const auto result = run("--format json --ethercat seed " + (files / "ring"));
    CHECK(result.code == 0);
    CHECK(names_of(result) ==
          std::vector<std::string>{"Set Wrench Effort", "Set Wrench Effort", "Report Component Status"});
    CHECK(run("--summary " + (files / "ring")).says("1 skipped: EtherCAT: --ethercat shows the JAUS messages in it\n"));
}

TEST_CASE("data of fixed length and with other index bases are read") {
    const std::string padded = "0c00" + wrench + "00000000";
    const auto objects = run_ring("seed --fixed-length --index-base 0x2000 --format json",
                                  {write_to(2, 1, "0020 21 2120 1a 12000000" + padded)})
                             .objects();
    REQUIRE(objects.size() == 1);
    CHECK(objects[0].at("fields").at("propulsive_linear_effort_x").at("raw") == 16383);
    CHECK(objects[0].at("header").at("data_size") == 4);
    for (const std::string wrong : {"", "00", "ff000602"}) {
        const auto size = from_hex(wrong).size();
        const auto result = run_ring("seed --fixed-length --format json",
                                     {write_to(2, 1, "0020 21 151b 1a" + little(size) + "0000" + wrong)});
        CHECK(result.code == 1);
        CHECK(result.objects().at(0).at("error").at("error") == (size < 2 ? "truncated" : "wrong_size"));
    }
}

TEST_CASE("a component's object that is not a message is shown as broken, other objects are counted") {
    const auto expedited = run_ring("seed --format json", {write_to(2, 1, "0020 23 151b 1a 01020304")});
    CHECK(expedited.code == 1);
    CHECK(expedited.objects().at(0).at("message").is_null());
    CHECK(expedited.objects().at(0).at("error").at("error") == "truncated");
    CHECK(expedited.objects().at(0).at("bytes") == "01020304");
    CHECK(expedited.objects().at(0).at("origin").at("object") == "0x1B15:26");
    const auto no_rank = run_ring("seed", {write_to(2, 1, "0020 21 151b c8 0c000000" + wrench)});
    CHECK(no_rank.code == 1);
    CHECK(no_rank.says("not a message: unknown subindex: no command code has this rank\n"));

    const auto others =
        summary_of("seed", {write_to(2, 1, "0020 2f 151b 00 00000000"), // subindex 0
                            write_to(2, 2, "0020 23 f31a 01 01020304"), // one below
                            write_to(2, 3, "0020 23 f41b 01 01020304"), // one above
                            write_to(2, 4, "0020 40 1810 01 00000000"), read_from(2, 4, "0030 43 1810 01 01020304")});
    CHECK(others.at("skipped") == json{{"SDO of an object that is not a JAUS component's", 4}});
    auto foe = write_to(2, 1, "0001");
    foe.data.replace(foe.data.find("13"), 2, "14");
    CHECK(summary_of("seed", {foe, read_from(2, 1, "0010 0000000000000000"), read_from(2, 2, "00"),
                              write_to(2, 2, "0020 a0 151b 1a 00000000")})
              .at("skipped") == json{{"CoE message that breaks off", 1},
                                     {"CoE message that is not an SDO", 1},
                                     {"EtherCAT mailbox message of another protocol than CoE", 1},
                                     {"SDO message of an unknown kind", 1}});
}

TEST_CASE("incomplete frames, and frames with any changed byte, are counted") {
    const auto recorded = jauscat::test::read_pcap("ethercat_jauscat_seed.pcap");
    const scratch files;
    std::vector<std::string> frames;
    for (std::size_t i = 58; i != 72; ++i) {
        for (std::size_t size = 0; size != recorded[i].size(); ++size)
            frames.push_back(jauscat::test::to_hex(std::span{recorded[i]}.first(size)));
        for (std::size_t at = 12; at != recorded[i].size(); ++at)
            for (const auto mask : {std::byte{0xFF}, std::byte{0x01}, std::byte{0x80}}) {
                auto changed = recorded[i];
                changed[at] ^= mask;
                frames.push_back(jauscat::test::to_hex(changed));
            }
    }
    write_capture(files / "garbage", link_ethernet, frames);
    for (const std::string table : {"seed", "self-contained", "seed --fixed-length"}) {
        const auto result = run("--format json --summary --ethercat " + table + " " + (files / "garbage"));
        CHECK(result.code == 1);
        CHECK(result.err.empty());
        const auto skipped = result.objects().at(0).at("skipped");
        CHECK(skipped.contains("shorter than its Ethernet header"));
        CHECK(skipped.contains("EtherCAT: length beyond frame: the header announces more bytes than arrived"));
    }
}

TEST_CASE("an incomplete capture is shown up to its end") {
    const scratch files;
    write_capture(files / "cut", link_ethernet,
                  {ethernet_ring_frame(write_to(2, 1, download)), ethernet_ring_frame(read_from(2, 1, confirmation))},
                  10);
    const auto result = run("--ethercat seed " + (files / "cut"));
    CHECK(result.code == 2);
    CHECK(result.says("1 message: 1 decoded\n"));
    CHECK(result.err.find("after packet 1") != std::string::npos);
}

TEST_CASE("wrong arguments of --ethercat and captures without EtherCAT are reported") {
    const auto says = [](const std::string& arguments, const std::string& text) {
        const auto result = run(arguments);
        INFO(arguments << ": " << result.err);
        CHECK(result.code == 2);
        CHECK(result.err.find(text) != std::string::npos);
    };
    says("--ethercat paper " + own_seed, "--ethercat must be seed or self-contained or sae, not 'paper'");
    says("--ethercat seed", "--ethercat needs a capture");
    says("--ethercat seed --listen 0", "--ethercat needs a capture");
    says("--index-base 0x2000 " + own_seed, "--index-base needs --ethercat");
    says("--fixed-length " + own_seed, "--fixed-length needs --ethercat");
    says("--subsystem 2 " + own_seed, "--subsystem needs --ethercat");
    says("--ethercat seed --subsystem 255 " + own_seed, "--subsystem must be 1 to 254");
    says("--ethercat seed --subsystem -1 " + own_seed, "--subsystem must not be negative");
    says("--ethercat seed --index-base 0x3000 " + own_seed, "--index-base must be 6900 or 0x2000 or 0x6900");
    says("--ethercat seed " + support::test_data("jaus_ra.pcap"), "jaus_ra.pcap: holds no EtherCAT");
    says("--ethercat seed /nowhere.pcap", "/nowhere.pcap");
    CHECK(run("--help").says("jausdump ring.pcap --ethercat seed --subsystem 2\n"));
}

TEST_CASE("messages of SAE JAUS are shown by their table, and encoded again to the bytes before translation") {
    // SetAuthority 35 to 258.2.33 from 65534.4.3: object 2021h:1, 10 bytes. SetWrenchEffort, one effort: 2121h:2.
    const auto authority = write_to(2, 1, "0020 21 2120 01 0a000000 06 0201 0304feff 23 2200");
    const auto effort = write_to(2, 2, "0020 21 2121 02 0d000000 06 0201 0304feff 0100 ffbf 0700");
    const auto other = write_to(2, 3, "0020 21 1b15 1a 0c000000" + wrench);
    const auto result =
        run_ring("sae --format json --reencode", {authority, read_from(2, 1, "0030 60 2120 01 00000000"), effort,
                                                  read_from(2, 2, "0030 60 2121 02 00000000"), other});
    CHECK(result.code == 0);
    const auto objects = result.objects();
    REQUIRE(objects.size() == 2);
    CHECK(objects[0].at("message") == "SetAuthority");
    CHECK(objects[0].at("generation") == "SAE");
    CHECK(objects[0].at("fields") == json{{"authority_code", 35}});
    CHECK(objects[0].at("header").at("destination") == json{{"subsystem", 258}, {"node", 2}, {"component", 33}});
    CHECK(objects[0].at("header").at("source") == json{{"subsystem", 65534}, {"node", 4}, {"component", 3}});
    CHECK(objects[0].at("hex") == "0011000621020201030"
                                  "4feff0100232200");
    CHECK(objects[0].at("origin").at("object") == "0x2021:1");
    CHECK(objects[1].at("message") == "SetWrenchEffort");
    CHECK(objects[1].at("fields").contains("propulsive_linear_effort_x"));
    CHECK(summary_of("sae", {other}).at("skipped") == json{{"SDO of an object that is not a JAUS component's", 1}});
}

TEST_CASE("a refused message of SAE JAUS is shown with its name; an object without a message as unknown") {
    const auto authority = write_to(2, 1, "0020 21 2120 01 0a000000 06 0201 0304feff 23 2200");
    const auto refused =
        run_ring("sae --format json", {authority, read_from(2, 1, "0030 80 2120 01 30000906")}).objects();
    REQUIRE(refused.size() == 2);
    CHECK(refused[1].at("message") == "SetAuthority");
    CHECK(refused[1].at("code") == "0x0001");
    CHECK(refused[1].at("header").at("sequence_number") == 0x22);
    CHECK(refused[1].at("refusal").at("code") == "0x06090030");
    // An upload that is refused has no data: object and station say what it was.
    const auto asked = run_ring("sae --format json", {write_to(2, 1, "0020 40 2120 27 00000000"),
                                                      read_from(2, 1, "0030 80 2120 27 24000008")})
                           .objects();
    REQUIRE(asked.size() == 1);
    CHECK(asked[0].at("message") == "ReportStatus");
    CHECK(asked[0].at("header").at("destination") == json{{"subsystem", 0}, {"node", 2}, {"component", 33}});
    const auto unknown =
        run_ring("sae --format json", {write_to(2, 1, "0020 21 2120 63 0a000000 06 0201 0304feff 23 2200")});
    CHECK(unknown.code == 1);
    CHECK(unknown.objects().at(0).at("error").at("error") == "unknown_subindex");
    CHECK(run("--ethercat sae --subsystem 2 x").code == 2);
    CHECK(run("--ethercat sae --index-base 6900 x").code == 2);
    CHECK(run_ring("sae --index-base 0x6900 --format json", {authority}).objects().empty());
}
