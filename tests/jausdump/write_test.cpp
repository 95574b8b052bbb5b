// Captures that jausdump writes: read again they show the same.
#include "program.hpp"
#include "support/catch.hpp"

using dump_test::control;
using dump_test::ethernet_frame;
using dump_test::json;
using dump_test::run;
using dump_test::scratch;
using dump_test::status;
using dump_test::udp_packet;
using dump_test::wrench;
using dump_test::write_capture;

namespace {

// Packets of a message of two.
const std::string first_part = "02 00 1000 41 06050400 03020100 0d00 0800";
const std::string last_part = "02 00 0f00 c1 06050400 03020100 23 0900";

/// The objects, without the numbers of packets.
std::vector<json> without_numbers(std::vector<json> objects) {
    for (auto& object : objects) object.at("origin").erase("packet");
    return objects;
}
/// What `file` shows with `arguments` is what the file written of it shows, with and without them.
void require_same_of_copy(const std::string& file, const std::string& arguments, std::size_t messages) {
    INFO(file << " " << arguments);
    const scratch files;
    const auto copy = files / "copy.pcap";
    const auto read = run("--format json " + file + " " + arguments + " --write " + copy);
    REQUIRE(read.err.empty());
    const auto shown = without_numbers(read.objects());
    REQUIRE(shown.size() == messages);
    CHECK(without_numbers(run("--format json " + arguments + " " + copy).objects()) == shown);
}

} // namespace

TEST_CASE("a written capture shows what the capture that was read shows") {
    require_same_of_copy(support::test_data("jaus_ra.pcap"), "", 3329);
    require_same_of_copy(support::test_data("jaus_ra.pcap"), "--name global_pose", 75);
    require_same_of_copy(support::test_data("ethercat_jauscat_seed.pcap"),
                         "--ethercat seed --subsystem 2 --name report",
                         run("--format json --ethercat seed --subsystem 2 --name report " +
                             support::test_data("ethercat_jauscat_seed.pcap"))
                             .lines()
                             .size());
}

TEST_CASE("packets without a message that passes the filters are not written, and the others are as they were") {
    const scratch files;
    const auto capture = files / "all.pcap";
    write_capture(capture, dump_test::link_ethernet,
                  {ethernet_frame(udp_packet(status)), ethernet_frame(udp_packet(wrench)),
                   ethernet_frame(udp_packet("ffff")), "020000000002 020000000001 0806 0001",
                   ethernet_frame(udp_packet(wrench)) + "0000"});
    const auto written = files / "written.pcap", expected = files / "expected.pcap";
    REQUIRE(run(capture + " --code 0405 --write " + written).code == 0);
    write_capture(expected, dump_test::link_ethernet,
                  {ethernet_frame(udp_packet(wrench)), ethernet_frame(udp_packet(wrench)) + "0000"});
    // The times differ: the second and the fifth packet, and a file with nanoseconds.
    const auto frames_of = [](const std::string& path) {
        std::vector<std::string> all;
        const auto bytes = dump_test::content(path);
        for (std::size_t at = 24; at + 16 <= bytes.size();) {
            const auto size = static_cast<std::size_t>(static_cast<unsigned char>(bytes[at + 8]));
            all.push_back(bytes.substr(at + 16, size));
            at += 16 + size;
        }
        return all;
    };
    REQUIRE(frames_of(written).size() == 2);
    CHECK(frames_of(written) == frames_of(expected));
    const auto times = run("--format json " + written).objects();
    CHECK(times[0].at("origin").at("time") == "2001-09-09T01:46:41.000250Z");
    CHECK(times[1].at("origin").at("time") == "2001-09-09T01:46:44.000250Z");
}

TEST_CASE("parts of messages in several packets are written whatever the filters are") {
    const scratch files;
    const auto capture = files / "parts.pcap";
    const auto payload = dump_test::from_hex(status);
    const std::string udp = "0ed2 0ed2 " + dump_test::two_bytes(8 + payload.size()) + " 0000 " + status;
    const auto whole = jauscat::test::to_hex(dump_test::from_hex(udp));
    const auto fragment = [](const std::string& flags, const std::string& part) {
        const auto size = dump_test::from_hex(part).size();
        return ethernet_frame("45 00 " + dump_test::two_bytes(20 + size) + " 0007" + flags +
                              "40 11 0000 0a000001 0a000002 " + part);
    };
    write_capture(capture, dump_test::link_ethernet,
                  {fragment("2000", whole.substr(0, 16 * 3)), fragment("0002", whole.substr(16 * 3)),
                   ethernet_frame(udp_packet(first_part)), ethernet_frame(udp_packet(last_part)),
                   ethernet_frame(udp_packet(control))});
    require_same_of_copy(capture, "", 5);
    require_same_of_copy(capture, "--code 4002", 1);
    require_same_of_copy(capture, "--code 000d", 3); // the first packet, the message, and that of one packet
    const auto copy = files / "copy.pcap";
    REQUIRE(run(capture + " --code 4002 --write " + copy).code == 0);
    CHECK(run("--format json " + copy).lines().size() == 4); // not that of one packet
}

TEST_CASE("a capture without messages gives a file without packets") {
    const scratch files;
    write_capture(files / "none.pcap", dump_test::link_ethernet, {});
    REQUIRE(run(files / "none.pcap --write " + (files / "copy.pcap")).code == 0);
    const auto read = run(files / "copy.pcap");
    CHECK(read.code == 0);
    CHECK(read.says("0 messages\n"));
}

TEST_CASE("a file that cannot be written, or is the one that is read, ends with exit code 2") {
    const scratch files;
    const auto capture = files / "a.pcap";
    write_capture(capture, dump_test::link_ethernet, {ethernet_frame(udp_packet(status))});
    const auto before = dump_test::content(capture);
    const auto same = run(capture + " --write " + capture);
    CHECK(same.code == 2);
    CHECK(same.err.find("this is the capture that is read") != std::string::npos);
    CHECK(dump_test::content(capture) == before);
    CHECK(run(capture + " --write /nowhere/b.pcap").code == 2);
    CHECK(run("--write " + (files / "b.pcap"), status + "\n").err.find("needs a capture or --listen") !=
          std::string::npos);
    CHECK(run(capture + " --write /dev/full").code == 1);
}

TEST_CASE("times are shown since the first message, since the one before, or not at all") {
    const scratch files;
    const auto capture = files / "a.pcap";
    const auto frame = ethernet_frame(udp_packet(status));
    write_capture(capture, dump_test::link_ethernet, {frame, frame, frame});
    const auto times = [&](const std::string& display) {
        std::vector<json> all;
        for (const auto& object : run("--format json --time " + display + " " + capture).objects())
            all.push_back(object.at("origin").value("time", json{}));
        return all;
    };
    CHECK(times("relative") == std::vector<json>{0.0, 1.0, 2.0});
    CHECK(times("delta") == std::vector<json>{0.0, 1.0, 1.0});
    CHECK(times("none") == std::vector<json>{nullptr, nullptr, nullptr});
    CHECK(times("absolute")[2] == "2001-09-09T01:46:42.000250Z");
    CHECK(run(capture).says(" number  time (UTC)       code"));
    const auto relative = run("--time relative " + capture);
    CHECK(relative.says(" number  time (s)         code"));
    CHECK(relative.says("      3  2.000000         0x4002"));
    CHECK(run("--time delta " + capture).says("      3  1.000000         0x4002"));
    CHECK(run("--time none " + capture).says("      3                   0x4002"));
    CHECK(run("--time tomorrow " + capture).err.find("--time must be absolute or relative or delta or none") !=
          std::string::npos);
}
