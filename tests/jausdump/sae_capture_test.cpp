// SAE JAUS in captures: recorded traffic, and datagrams made for the purpose.
#include "program.hpp"
#include "support/catch.hpp"

#include <map>

using dump_test::ethernet_frame;
using dump_test::from_hex;
using dump_test::json;
using dump_test::run;
using dump_test::scratch;
using dump_test::two_bytes;
using dump_test::udp_packet;
using dump_test::write_capture;

namespace {

/// A message of the transport from 1.2.3 to 4.5.6. `properties`: priority, broadcast, acknowledgement, fragment flag.
std::string message(const std::string& payload, const std::string& properties = "01",
                    const std::string& number = "0700") {
    const auto size = two_bytes(14 + from_hex(payload).size());
    return "00" + size.substr(2) + size.substr(0, 2) + properties + "06050400 03020100" + payload + number;
}
std::string datagram(const std::string& messages) { return "02" + messages; }

struct shown {
    int code{};
    std::vector<json> objects{};
};
shown shown_of(const std::vector<std::string>& datagrams, const std::string& arguments = {}) {
    const scratch files;
    std::vector<std::string> frames;
    for (const auto& one : datagrams) frames.push_back(udp_packet(one));
    write_capture(files / "capture", dump_test::link_raw, frames);
    const auto result = run("--format json --reencode " + arguments + " " + (files / "capture"));
    return {result.code, result.objects()};
}

// Report Component Status of RA 3.3.
const std::string ra_status = "0602 0240 01200101 01210101 0500 0700 0100000000";

} // namespace

TEST_CASE("recorded traffic of SAE JAUS is decoded, and encoded again to the bytes of each datagram") {
    const auto result = run("--format json --reencode " + support::test_data("sae_management.pcap"));
    CHECK(result.code == 0);
    CHECK(result.err.empty());
    const auto objects = result.objects();
    REQUIRE(objects.size() == 22);
    const auto frames = jauscat::test::read_pcap("sae_management.pcap");
    constexpr std::size_t headers = 14 + 20 + 8 + 1; // Ethernet, IPv4, UDP, the version
    std::map<std::string, int> messages;
    for (const auto& object : objects) {
        INFO(object.dump());
        ++messages[object.at("message")];
        if (object.at("code") == "0x0006" || object.at("code") == "0x0007") { // emergency 0, not defined
            CHECK(object.at("fields") == json{{"emergency_code", 0}});
            CHECK(object.at("outside_values") == json::array({"emergency_code"}));
        } else {
            CHECK_FALSE(object.contains("outside_values"));
        }
        CHECK_FALSE(object.contains("error"));
        const std::span frame{frames.at(object.at("origin").at("packet").get<std::size_t>() - 1)};
        const auto received = frame.subspan(headers, object.at("header").at("size").get<std::size_t>());
        CHECK(std::ranges::equal(from_hex(object.at("hex").get<std::string>()), received));
    }
    CHECK(messages == std::map<std::string, int>{{"ClearEmergency", 1},
                                                 {"ConfirmControl", 2},
                                                 {"QueryStatus", 5},
                                                 {"RejectControl", 1},
                                                 {"ReleaseControl", 1},
                                                 {"ReportStatus", 5},
                                                 {"RequestControl", 2},
                                                 {"Resume", 2},
                                                 {"SetEmergency", 1},
                                                 {"Standby", 1},
                                                 {"acknowledgement", 1}});
    CHECK(objects[0].at("header") == json::parse(R"({"message_type":0,"compression":0,"size":17,"priority":1,)"
                                                 R"("broadcast":2,"acknowledgement":1,"fragment_flag":0,)"
                                                 R"("destination":{"subsystem":126,"node":1,"component":10},)"
                                                 R"("source":{"subsystem":126,"node":1,"component":20},)"
                                                 R"("sequence_number":1})"));
    CHECK(run("--format json --from 126.1.20 --code 000D " + support::test_data("sae_management.pcap"))
              .objects()
              .size() == 2);
}

TEST_CASE("both generations at one port are shown side by side") {
    const auto [code, objects] =
        shown_of({datagram(message("0220")), ra_status, datagram(message("0240 01 00000000"))});
    CHECK(code == 0);
    REQUIRE(objects.size() == 3);
    CHECK(objects[0].at("message") == "QueryStatus");
    CHECK(objects[0].at("generation") == "SAE");
    CHECK(objects[1].at("message") == "Report Component Status");
    CHECK_FALSE(objects[1].contains("generation"));
    CHECK(objects[2].at("message") == "ReportStatus");
    // Both have the ID; only a message of SAE has such a subsystem, only one of the RA an instance.
    CHECK(shown_of({datagram(message("0240 01 00000000")), ra_status}, "--code 4002").objects.size() == 2);
    const auto large = datagram("00 1000 01 06050400 03027d01 0220 0000");
    CHECK(shown_of({large, ra_status}, "--from 381.2").objects.size() == 1);
    CHECK(shown_of({large, ra_status}, "--from '*.*.*.1'").objects.at(0).at("code") == "0x4002");
}

TEST_CASE("all messages of a datagram are shown, also behind one that is not processed") {
    const auto answered = "80" + message("0220").substr(2); // an answer of header compression
    const auto [code, objects] = shown_of({datagram(message("0220") + answered + message("0d20"))});
    CHECK(code == 1);
    REQUIRE(objects.size() == 3);
    CHECK(objects[0].at("message") == "QueryStatus");
    CHECK(objects[1].at("error").at("error") == "compressed");
    CHECK(objects[2].at("message") == "QueryControl");
    // What stands behind the last message is shown, too.
    const auto more = shown_of({datagram(message("0220") + "ffee")}).objects;
    REQUIRE(more.size() == 2);
    CHECK(more[1].at("error").at("error") == "truncated");
    CHECK(more[1].at("bytes") == "ffee");
}

TEST_CASE("an acknowledgement, a proposal of header compression and a damaged message are told apart") {
    const auto acknowledgement = shown_of({datagram(message("", "31"))});
    CHECK(acknowledgement.code == 0);
    CHECK(acknowledgement.objects.at(0).at("fields").is_null());
    CHECK(acknowledgement.objects.at(0).at("header").at("acknowledgement") == 3);
    CHECK(acknowledgement.objects.at(0).at("hex") == "000e0031060504000302010"
                                                     "00700");
    CHECK(shown_of({datagram(message(""))}).objects.at(0).at("error").at("error") == "no_message_id");

    const auto proposal = shown_of({datagram("40 1200 0a0b 01 06050400 03020100 0220 0700")});
    CHECK(proposal.code == 0);
    CHECK(proposal.objects.at(0).at("message") == "QueryStatus");
    CHECK(proposal.objects.at(0).at("hex") == "4012000a0b01060504000302010002200700");

    // The byte is counted from the header: 12 bytes, the ID, then the field.
    const auto broken = shown_of({datagram(message("0d00"))});
    CHECK(broken.code == 1);
    CHECK(broken.objects.at(0).at("error").at("field") == "authority_code");
    CHECK(broken.objects.at(0).at("error").at("byte") == 14);
    const auto unknown = shown_of({datagram(message("fed0 0102"))}).objects.at(0);
    CHECK(unknown.at("code") == "0xD0FE");
    CHECK(unknown.at("payload_size") == 4);
    CHECK(unknown.at("header").at("size") == 18);
    CHECK(unknown.at("bytes") == "00120001060504000302010"
                                 "0fed001020700");

    const auto cut = shown_of({datagram("00 1100 01 06050400 03020100 0d00")}).objects.at(0);
    CHECK(cut.at("error").at("error") == "truncated");
    CHECK(cut.at("header").at("size") == 17);
    CHECK(shown_of({datagram("00 1000 01 06050400 00020100 0220 0000")}).objects.empty()); // from no component
}

TEST_CASE("a message of several packets is put together, in any order") {
    // Set Authority, 3 bytes, and its packets 6, 7 and 8.
    const auto first = datagram(message("01", "41", "0600")), middle = datagram(message("00", "81", "0700")),
               last = datagram(message("3e", "c1", "0800"));
    for (const auto& order : {std::vector{first, middle, last}, {last, first, middle}}) {
        const auto [code, objects] = shown_of(order);
        CHECK(code == 0);
        REQUIRE(objects.size() == 4);
        CHECK(objects[0].at("data_set") == "waiting");
        CHECK(objects[2].at("data_set") == "whole");
        CHECK(objects[3].at("data_set") == "reassembled");
        CHECK(objects[3].at("message") == "SetAuthority");
        CHECK(objects[3].at("fields") == json{{"authority_code", 62}});
        CHECK(objects[3].at("hex") == "00110001060504000302010001003e0600");
    }
    // Selected by name, packets that do not have it are still used.
    CHECK(shown_of({first, middle, last}, "--name set_authority").objects.size() == 1);
    // Incomplete at the end, or silent for 10 seconds: the frames are a second apart.
    CHECK(shown_of({first, last}).code == 1);
    std::vector<std::string> late{first, last};
    late.resize(12, datagram(message("0220")));
    late.push_back(middle);
    const auto incomplete = shown_of(late, "--summary").objects.at(0);
    CHECK(incomplete.at("incomplete_large_data_sets") == 2);
}

TEST_CASE("SAE JAUS in IPv4 fragments is decoded") {
    const scratch files;
    const auto payload = datagram(message("0d0023"));
    const auto whole = from_hex("0ed2 0ed2 " + two_bytes(8 + from_hex(payload).size()) + " 0000 " + payload);
    const auto fragment = [&](std::size_t begin, std::size_t size, const std::string& place) {
        return ethernet_frame("45 00 " + two_bytes(20 + size) + " 0007" + place + "40 11 0000 0a000001 0a000002 " +
                              jauscat::test::to_hex(std::span{whole}.subspan(begin, size)));
    };
    write_capture(files / "capture", dump_test::link_ethernet,
                  {fragment(16, whole.size() - 16, "0002"), fragment(0, 16, "2000")});
    const auto objects = run("--format json " + (files / "capture")).objects();
    REQUIRE(objects.size() == 1);
    CHECK(objects[0].at("message") == "RequestControl");
}

TEST_CASE("SAE JAUS is shown as text with its flags") {
    const scratch files;
    write_capture(files / "capture", dump_test::link_raw, {udp_packet(datagram(message("0d0023", "19")))});
    const auto result = run(files / "capture");
    CHECK(result.says(
        "0x000D  RequestControl                             3  1.2.3           -> 4.5.6            7, wants "
        "ACK, broadcast: global\n"));
}

TEST_CASE("a line of hex may be a datagram of SAE JAUS") {
    CHECK(dump_test::object_of(datagram(message("0d0023"))).at("message") == "RequestControl");
}
