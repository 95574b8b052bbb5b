// Captures: real traffic, and frames of every link type made for the purpose.
#include "program.hpp"
#include "support/catch.hpp"

#include <map>
#include <sys/stat.h>

using dump_test::ethernet_frame;
using dump_test::from_hex;
using dump_test::json;
using dump_test::run;
using dump_test::scratch;
using dump_test::status;
using dump_test::two_bytes;
using dump_test::udp_packet;
using dump_test::write_capture;

namespace {

const std::string recorded = support::test_data("jaus_ra.pcap");
const std::string prefix = "4a41555330312e30";

/// A packet of Report Image from 1.1.37.1.
std::string image_packet(const std::string& flag_and_size, const std::string& number, const std::string& body) {
    return prefix + "0602 0748 01200101 01250101" + flag_and_size + number + body;
}

} // namespace

TEST_CASE("a capture is read from a pipe too") {
    const scratch files;
    const auto pipe = files / "pipe";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    const auto piped = run("--format json " + pipe, {}, "cat " + recorded + " >" + pipe + " &");
    REQUIRE(piped.code == 1);
    REQUIRE(piped.out == run("--format json " + recorded).out);
    REQUIRE(run("--format json -", dump_test::content(recorded)).out == piped.out);
}

TEST_CASE("the recorded JAUS traffic is listed completely") {
    const auto result = run("--format json " + recorded);
    REQUIRE(result.code == 1);
    REQUIRE(result.err.empty());
    std::map<std::string, int> messages;
    int standard = 0, last_packets = 0, private_codes = 0, with_dropped_bytes = 0, acknowledgements = 0;
    for (const auto& object : result.objects()) {
        const auto code = object.at("code").get<std::string>();
        INFO(object.dump());
        ++messages[code];
        if (code >= "0xD000") {
            ++private_codes;
            const auto name = object.at("message").get<std::string>();
            REQUIRE((name == "unknown" || name.ends_with("(OpenJAUS 3.2)")));
            REQUIRE((object.at("header").at("ack_nak") == 3 || object.at("bytes").get<std::string>().size() > 31));
            continue;
        }
        REQUIRE_FALSE(object.contains("error"));
        if (code == "0x4807") {
            ++last_packets;
            REQUIRE(object.at("header").at("data_flag") == 8);
            REQUIRE(object.at("data_set") != "whole");
            continue;
        }
        ++standard;
        const bool has_more = code == "0x4402" || code == "0x4404";
        REQUIRE(object.value("dropped", 0) == (has_more ? 2 : 0));
        with_dropped_bytes += has_more ? 1 : 0;
        if (object.at("header").at("ack_nak") == 3)
            ++acknowledgements;
        else
            REQUIRE(object.at("fields").is_object());
    }
    REQUIRE(private_codes == 1095);
    REQUIRE(last_packets == 482);
    REQUIRE(standard == 3329 - 1095 - 482);
    REQUIRE(with_dropped_bytes == 150);
    REQUIRE(acknowledgements == 6);
    REQUIRE(messages.size() == 23 + 26);
    REQUIRE(messages.at("0x0801") == 548);
}

TEST_CASE("the standard messages of the recorded traffic decode, and encode to the same bytes") {
    const auto result =
        run("--format json --reencode --code 000D,000E,000F,0010,040A,040C,0801,0802,2400,2801,2805,4002,"
            "4202,4400,4401,4405,4406,4800,4801,4805 " +
            recorded);
    REQUIRE(result.code == 0);
    const auto frames = jauscat::test::read_pcap("jaus_ra.pcap");
    constexpr std::size_t headers = 14 + 20 + 8 + 8; // Ethernet, IPv4, UDP, the prefix
    int count = 0;
    for (const auto& object : result.objects()) {
        const std::span frame{frames.at(object.at("origin").at("packet").get<std::size_t>() - 1)};
        const auto size = 16 + object.at("header").at("data_size").get<std::size_t>();
        const auto received = frame.subspan(headers, size); // a short frame is padded behind it
        REQUIRE(std::ranges::equal(dump_test::from_hex(object.at("hex").get<std::string>()), received));
        ++count;
    }
    REQUIRE(count == 3329 - 1095 - 482 - 150);
}

TEST_CASE("the summary of the recorded traffic has all counts") {
    const auto result = run("--summary " + recorded);
    REQUIRE(
        result.says("3329 messages: 1746 decoded, 9 acknowledgements, 482 packets of large data sets, 1092 unknown\n"));
    REQUIRE(result.says("13 skipped: not UDP: IP protocol 1\n"));
    REQUIRE(result.says("0x4402  Report Global Pose                          75        3600\n"));
}

TEST_CASE("frames of every link type hold messages, with and without the prefix") {
    const scratch files;
    const auto packet = udp_packet(prefix + status), bare = udp_packet(status);
    const std::vector<std::pair<std::uint32_t, std::vector<std::string>>> captures{
        {dump_test::link_ethernet,
         {ethernet_frame(packet), ethernet_frame(bare) + "0000000000", // padded to the shortest frame
          "020000000002 020000000001 8100 0005 0800 " + packet,
          "020000000002 020000000001 88a8 0005 8100 0006 0800 " + bare}},
        {dump_test::link_raw, {packet, bare}},
        {dump_test::link_cooked, {"0000 0001 0006 020000000001 0000 0800" + packet}},
        {dump_test::link_cooked_2, {"0800 0000 00000001 0001 00 06 020000000001 0000" + packet}},
        {dump_test::link_null, {"02000000" + packet, "00000002" + bare}}};
    for (const auto& [link_type, frames] : captures) {
        INFO("link type " << link_type);
        write_capture(files / "capture", link_type, frames);
        const auto result = run("--format json " + (files / "capture"));
        REQUIRE(result.code == 0);
        REQUIRE(result.objects().size() == frames.size());
        for (std::size_t i = 0; i != frames.size(); ++i) {
            const auto object = result.objects()[i];
            REQUIRE(object.at("message") == "Report Component Status");
            REQUIRE(object.at("origin").at("packet") == i + 1);
            REQUIRE(object.at("origin").at("time") == "2001-09-09T01:46:4" + std::to_string(i) + ".000250Z");
            REQUIRE(object.at("origin").at("from") == "10.0.0.1:3794");
            REQUIRE(object.at("origin").at("to") == "10.0.0.2:3794");
        }
    }
}

TEST_CASE("a capture with AS5669-2007 and header compression alone says so, with exit code 1") {
    const scratch files;
    const auto compressed = ethernet_frame(udp_packet("01 4000 0002 aabb"));
    write_capture(files / "capture", dump_test::link_ethernet, {compressed, compressed});
    const auto result = run(files / "capture");
    CHECK(result.code == 1);
    CHECK(result.says("no message was decoded: 2 datagrams are AS5669-2007 with header compression, which is not "
                      "supported\n"));
    // Beside other messages they are counted.
    write_capture(files / "capture", dump_test::link_ethernet, {compressed, ethernet_frame(udp_packet(status))});
    const auto mixed = run(files / "capture");
    CHECK(mixed.code == 0);
    CHECK(mixed.says("\n1 datagram is AS5669-2007 with header compression, which is not supported\n"));
}

TEST_CASE("IPv4 fragments are put together, in any order") {
    const scratch files;
    // The UDP header, 8 bytes, and the message, 21 bytes; two fragments of 16 and 13 bytes.
    const auto whole = from_hex("0ed2 0ed2 " + two_bytes(8 + from_hex(status).size()) + " 0000 " + status);
    const auto fragment = [&](std::size_t begin, std::size_t size, const std::string& place) {
        const auto part = std::span{whole}.subspan(begin, size);
        return ethernet_frame("45 00 " + two_bytes(20 + size) + " 0007" + place + "40 11 0000 0a000001 0a000002 " +
                              jauscat::test::to_hex(part));
    };
    const auto first = fragment(0, 16, "2000"), second = fragment(16, whole.size() - 16, "0002");
    for (const auto& frames : {std::vector{first, second}, {second, first}, {first, first, second}}) {
        write_capture(files / "capture", dump_test::link_ethernet, frames);
        const auto result = run("--format json " + (files / "capture"));
        REQUIRE(result.code == 0);
        REQUIRE(result.objects().size() == 1);
        CHECK(result.objects()[0].at("message") == "Report Component Status");
        CHECK(result.objects()[0].at("origin").at("packet") == frames.size());
        CHECK(result.objects()[0].at("origin").at("from") == "10.0.0.1:3794");
    }
    write_capture(files / "capture", dump_test::link_ethernet, {first});
    CHECK(run("--summary " + (files / "capture")).says("1 skipped: IPv4 fragment of a packet that is not complete\n"));
}

TEST_CASE("discovery messages of OpenJAUS 3.2 are named") {
    for (const auto& [code, name] : {std::pair{"a4d2", "Query Identification (OpenJAUS 3.2)"},
                                     {"a6d2", "Query Configuration (OpenJAUS 3.2)"},
                                     {"a7d2", "Query Services (OpenJAUS 3.2)"},
                                     {"a5d4", "Report Identification (OpenJAUS 3.2)"}}) {
        const auto object = dump_test::object_of("8602" + std::string{code} + "01010101 01200101 0000 0000");
        CHECK(object.at("message") == name);
        CHECK(object.at("error").at("error") == "unknown_command_code");
    }
}

TEST_CASE("data that are not JAUS are counted by reason") {
    const scratch files;
    const auto frame = [](const std::string& payload) { return ethernet_frame(udp_packet(payload)); };
    auto tcp = frame(status);
    tcp.replace(tcp.find("40 11"), 5, "40 06");
    auto cut_off = ethernet_frame(udp_packet(prefix + status));
    cut_off.resize(cut_off.size() - 6);
    write_capture(files / "capture", dump_test::link_ethernet,
                  {"020000000002 020000000001 0806 0001", "0200", tcp, cut_off,
                   ethernet_frame(udp_packet(status, "2000")), ethernet_frame(udp_packet(status, "0010")),
                   ethernet_frame("65 00"), ethernet_frame("60" + std::string(80, '0')), frame("0102"),
                   frame("ffff 0240 01200101 01210101 0500 0700 0100000000"),
                   frame("0602 0240 01200101 00000000 0500 0700 0100000000"),
                   frame("0602 15e0 01200101 01210101 0500 0700 01000000"), frame(status)});
    const auto result = run("--format json --summary " + (files / "capture"));
    REQUIRE(result.code == 0);
    REQUIRE(result.objects().at(0).at("skipped") == json{{"IPv4 fragment of a packet that is not complete", 2},
                                                         {"broken TCP header", 1},
                                                         {"not IPv4: EtherType 0x0806", 1},
                                                         {"not IPv4: IP version 6", 1},
                                                         {"not JAUS: no component is the source", 1},
                                                         {"not JAUS: not the first bytes of a header", 1},
                                                         {"not JAUS: shorter than a header", 1},
                                                         {"not JAUS: the size in the header is another", 1},
                                                         {"not captured to its end", 1},
                                                         {"shorter than its Ethernet header", 1},
                                                         {"shorter than its IPv4 header", 1}});
    REQUIRE(result.objects().at(0).at("decoded") == 1);
}

TEST_CASE("an incomplete message is shown as broken, since its code or prefix identifies it") {
    const scratch files;
    write_capture(files / "capture", dump_test::link_raw,
                  {udp_packet("0602 0240 01200101 01210101 0500 0700 0100"), udp_packet(prefix + "0602"),
                   udp_packet(prefix + status)});
    const auto result = run("--format json " + (files / "capture"));
    REQUIRE(result.code == 1);
    REQUIRE(result.objects().at(0).at("error").at("field") == "secondary_status_code");
    REQUIRE(result.objects().at(0).at("error").at("byte") == 17);
    REQUIRE(result.objects().at(1).at("error").at("field") == "command_code");
    REQUIRE_FALSE(result.objects().at(2).contains("error"));
}

TEST_CASE("packets of a large data set are listed and assembled, also out of order") {
    const scratch files;
    write_capture(files / "capture", dump_test::link_raw,
                  {udp_packet(image_packet("0310", "0000", "01 02 aa")), udp_packet(image_packet("0180", "0200", "dd")),
                   udp_packet(image_packet("0220", "0100", "bbcc")), udp_packet(image_packet("0220", "0100", "bbcc"))});
    const auto result = run("--format json --reencode " + (files / "capture"));
    REQUIRE(result.code == 1); // the repeated packet begins a data set that stays incomplete
    const auto objects = result.objects();
    REQUIRE(objects.size() == 5);
    std::string states;
    for (const auto& object : objects) states += object.at("data_set").get<std::string>() + " ";
    REQUIRE(states == "waiting waiting whole reassembled waiting ");
    REQUIRE(objects[0].at("fields").is_null());
    REQUIRE(objects[3].at("message") == "Report Image");
    REQUIRE(objects[3].at("header").at("data_size") == 6);
    REQUIRE(objects[3].at("fields").at("image_data") == "aabbccdd");
    REQUIRE(objects[3].at("hex") == "0602074801200101012501010600"
                                    "0000"
                                    "0102aabbccdd");
}

TEST_CASE("a large data set with more bytes than a header can state is decoded, and has no bytes to encode") {
    const scratch files;
    std::vector<std::string> frames;
    const std::string body = "01 02" + std::string(2 * 3998, 'a'); // 4000 bytes, a0fh
    for (int number = 0; number != 20; ++number) {
        const bool first = number == 0, last = number == 19;
        const auto packet_number = jauscat::test::to_hex(std::array{static_cast<std::byte>(number)}) + "00";
        frames.push_back(udp_packet(image_packet(first ? "a01f" : last ? "a08f" : "a02f", packet_number, body)));
    }
    write_capture(files / "capture", dump_test::link_raw, frames);
    const auto result = run("--format json --reencode " + (files / "capture"));
    REQUIRE(result.code == 0);
    const auto objects = result.objects();
    REQUIRE(objects.size() == 21);
    REQUIRE(objects[20].at("header").at("data_size") == 80000);
    REQUIRE(objects[20].at("header").at("data_flag") == 0);
    REQUIRE(objects[20].at("fields").at("image_data").get<std::string>().size() == 2 * 79998);
    REQUIRE_FALSE(objects[20].contains("hex"));
}

TEST_CASE("a data set that exceeds its memory is shown as broken") {
    const scratch files;
    const std::string body(2 * 4000, 'a');
    std::vector<std::string> frames(263); // 1 MiB is 262 packets of 4000 bytes and some more
    for (std::size_t number = 0; number != frames.size(); ++number)
        frames[number] = udp_packet(image_packet(
            "a02f",
            jauscat::test::to_hex(std::array{static_cast<std::byte>(number), static_cast<std::byte>(number >> 8)}),
            body));
    write_capture(files / "capture", dump_test::link_raw, frames);
    const auto result = run("--format json " + (files / "capture"));
    REQUIRE(result.code == 1);
    REQUIRE(result.objects().at(261).at("data_set") == "waiting");
    REQUIRE(result.objects().at(262).at("error").at("error") == "too_large");
}

TEST_CASE("payload data elements are decoded by the preceding report of their payload") {
    const scratch files;
    // One command interface "go": scaled byte, -10 to 10, no unit, no enumeration. Then Set Payload Data Element.
    const std::string report = prefix +
                               "0602 004d 01200101 01280101 1700 0000 00 01 00 676f00 0a 00 00 000020c1 00000000 "
                               "00002041 0000";
    const auto set = [](const std::string& to) { return prefix + "0602 010d" + to + "01200101 0300 0000 01 01 ff"; };
    write_capture(files / "capture", dump_test::link_raw,
                  {udp_packet(report), udp_packet(set("01280101")), udp_packet(set("01280202"))});
    const auto result = run("--format json --reencode " + (files / "capture"));
    INFO(result.out);
    REQUIRE(result.code == 0);
    const auto objects = result.objects();
    REQUIRE(objects.at(1).at("fields").at("element") ==
            json::array({{{"command_interface_number", 1}, {"value", {{"value", 10.0}, {"raw", 255}}}}}));
    REQUIRE(objects.at(2).at("fields").at("element") == "01ff");
}

TEST_CASE("a capture that cannot be read to its end is shown up to there, with exit code 2") {
    const scratch files;
    std::ofstream{files / "text"} << "this is no capture\n";
    write_capture(files / "cut", dump_test::link_raw, {udp_packet(status), udp_packet(status)}, 3);
    write_capture(files / "radio", 127, {});

    auto result = run(files / "none");
    REQUIRE(result.code == 2);
    REQUIRE(result.err == "jausdump: " + (files / "none") + ": No such file or directory\n");
    REQUIRE(result.out.empty());
    REQUIRE(run(files / "text").code == 2);
    result = run(files / "radio");
    REQUIRE(result.code == 2);
    REQUIRE(result.err.find("is not supported") != std::string::npos);
    result = run("--format json " + (files / "cut"));
    REQUIRE(result.code == 2);
    REQUIRE(result.objects().size() == 1);
    REQUIRE(result.err.find("after packet 1") != std::string::npos);
}
