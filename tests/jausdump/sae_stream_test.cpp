// SAE JAUS over TCP in captures, and on serial lines.
#include "program.hpp"
#include "support/catch.hpp"
#include <jauscat/sae/transport/jserial.hpp>

using dump_test::from_hex;
using dump_test::json;
using dump_test::run;
using dump_test::scratch;
using dump_test::two_bytes;

namespace {

namespace sae = jauscat::sae;

/// A message of the transport from 1.2.3 to 4.5.6.
std::string message(const std::string& payload) {
    const auto size = two_bytes(14 + from_hex(payload).size());
    return "00" + size.substr(2) + size.substr(0, 2) + "01 06050400 03020100" + payload + "0700";
}
const std::string request = message("0d0023"), query = message("0220");

/// A part of a hex string, by bytes.
std::string part_of(const std::string& hex, std::size_t begin, std::size_t size = std::string::npos) {
    const auto bytes = from_hex(hex);
    const auto rest = std::span{bytes}.subspan(begin);
    return jauscat::test::to_hex(rest.first(std::min(size, rest.size())));
}

/// A TCP segment from 10.0.0.1:3794 to 10.0.0.2:40000, or back.
std::string segment(unsigned number, const std::string& payload, const std::string& flags = "10", bool back = false) {
    const std::string there = "0a000001 0a000002 0ed2 9c40", answer = "0a000002 0a000001 9c40 0ed2";
    return "45 00 " + two_bytes(40 + from_hex(payload).size()) + " 0001 0000 40 06 0000 " + (back ? answer : there) +
           two_bytes(number >> 16) + two_bytes(number & 0xFFFF) + " 00000000 50" + flags + "2000 0000 0000" + payload;
}
const std::string syn = "02";

struct shown {
    int code{};
    std::vector<json> objects{};
    /// Codes, or the errors.
    [[nodiscard]] std::string codes() const {
        std::string text;
        for (const auto& object : objects)
            text += (object.contains("error") ? object.at("error").at("error") : object.at("code")).get<std::string>() +
                    " ";
        return text;
    }
};
shown shown_of(const std::vector<std::string>& packets) {
    const scratch files;
    dump_test::write_capture(files / "capture", dump_test::link_raw, packets);
    const auto result = run("--format json --reencode " + (files / "capture"));
    return {result.code, result.objects()};
}
json skipped_of(const std::vector<std::string>& packets) {
    const scratch files;
    dump_test::write_capture(files / "capture", dump_test::link_raw, packets);
    return run("--format json --summary " + (files / "capture")).objects().at(0).at("skipped");
}

std::vector<std::byte> frame_of(const std::string& hex) {
    const auto bytes = from_hex(hex);
    std::vector<std::byte> frame(sae::max_serial_frame_size(bytes.size()));
    const auto written = sae::put_serial_frame(bytes, frame);
    REQUIRE(written);
    frame.resize(written->size());
    return frame;
}
shown serial_of(const std::vector<std::byte>& bytes) {
    const scratch files;
    std::ofstream{files / "line", std::ios::binary}.write(reinterpret_cast<const char*>(bytes.data()),
                                                          static_cast<std::streamsize>(bytes.size()));
    const auto result = run("--format json --reencode --jserial " + (files / "line"));
    return {result.code, result.objects()};
}

} // namespace

TEST_CASE("messages of a TCP stream are shown, however its segments cut them, in both directions") {
    const auto stream = syn + request + query;
    for (const std::size_t cut : {1U, 2U, 5U, 13U, 14U, 17U, 18U, 20U, 30U}) {
        INFO("cut behind byte " << cut);
        const auto [code, objects] =
            shown_of({segment(0xFFFFFFF8, "", "02"), segment(0xFFFFFFF9, part_of(stream, 0, cut)),
                      segment(0xFFFFFFF9 + static_cast<unsigned>(cut), part_of(stream, cut))}); // the numbers wrap
        CHECK(code == 0);
        REQUIRE(objects.size() == 2);
        CHECK(objects[0].at("message") == "RequestControl");
        CHECK(objects[0].at("hex") == "0011000106050400030201000d00230700");
        CHECK(objects[0].at("origin").at("packet") == (cut < 18 ? 3 : 2));
        CHECK(objects[0].at("origin").at("from") == "10.0.0.1:3794");
        CHECK(objects[0].at("origin").at("to") == "10.0.0.2:40000");
        CHECK(objects[1].at("message") == "QueryStatus");
        CHECK(objects[1].at("origin").at("packet") == 3);
    }
    const auto both =
        shown_of({segment(10, "", "02"), segment(80, "", "12", true), segment(11, syn + part_of(request, 0, 9)),
                  segment(81, syn + query, "10", true), segment(21, part_of(request, 9))});
    CHECK(both.codes() == "0x2002 0x000D ");
}

TEST_CASE("segments that are repeated, overlap or arrive in another order are put in order") {
    const auto stream = syn + request + query;
    const auto part = [&](std::size_t begin, std::size_t size) {
        return segment(100 + static_cast<unsigned>(begin), part_of(stream, begin, size));
    };
    const auto start = segment(99, "", "02");
    CHECK(shown_of({start, part(20, 20), part(10, 10), part(0, 10)}).codes() == "0x000D 0x2002 ");
    CHECK(shown_of({start, part(0, 10), part(0, 10), part(5, 20), part(10, 3), part(20, 20)}).codes() ==
          "0x000D 0x2002 ");
    CHECK(shown_of({start, start, part(0, 40), start, part(0, 40)}).codes() == "0x000D 0x2002 ");
}

TEST_CASE("a missing segment loses its message alone, and so does the end of the capture") {
    const auto start = segment(99, syn + part_of(request, 0, 9), "02");
    // 10 bytes at 100, then 8 that lack, then whole messages.
    const auto gap = shown_of({start, segment(118, query), segment(134, request)});
    CHECK(gap.code == 1);
    CHECK(gap.codes() == "truncated 0x2002 0x000D ");
    const auto end = shown_of({segment(99, syn + request + part_of(query, 0, 5), "02")});
    CHECK(end.code == 1);
    CHECK(end.codes() == "0x000D truncated ");
    // A size that cannot be: the next message is found where a segment begins with one.
    const auto damaged =
        shown_of({segment(99, syn + request + "00 0200 01 06050400 03020100 0000", "02"), segment(132, query)});
    CHECK(damaged.codes() == "0x000D wrong_size 0x2002 ");
}

TEST_CASE("a stream whose beginning was not captured is read from the next message on") {
    CHECK(shown_of({segment(500, part_of(request, 5)), segment(512, query + request)}).codes() == "0x2002 0x000D ");
    CHECK(shown_of({segment(500, syn + query)}).codes() == "0x2002 ");
}

TEST_CASE("TCP of other protocols is counted") {
    const std::string http = "474554202f20485454502f312e310d0a0d0a";
    CHECK(skipped_of({segment(99, "", "02"), segment(100, http)}) == json{{"TCP: not a stream of JTCP", 1}});
    CHECK(skipped_of({segment(100, http), segment(118, http)}) ==
          json{{"TCP: not the beginning of a JTCP message", 2}});
    CHECK(skipped_of({segment(100, http), segment(300, http)}) ==
          json{{"TCP: not the beginning of a JTCP message", 2}});
    CHECK(shown_of({segment(99, http, "02")}).code == 0);
}

TEST_CASE("the frames of a serial line are shown, with noise between them counted") {
    auto bytes = frame_of(request);
    bytes.insert(bytes.end(), 3, std::byte{0x55});
    const auto second = frame_of(message("0100 10")); // a byte that is doubled
    bytes.insert(bytes.end(), second.begin(), second.end());
    const auto [code, objects] = serial_of(bytes);
    CHECK(code == 0);
    REQUIRE(objects.size() == 2);
    CHECK(objects[0].at("message") == "RequestControl");
    CHECK(objects[0].at("hex") == "0011000106050400030201000d00230700");
    CHECK(objects[1].at("fields") == json{{"authority_code", 16}});
    CHECK(objects[1].at("origin") == json{{"frame", 2}});

    const scratch files;
    std::ofstream{files / "line", std::ios::binary}.write(reinterpret_cast<const char*>(bytes.data()),
                                                          static_cast<std::streamsize>(bytes.size()));
    CHECK(run("--jserial - ", dump_test::content(files / "line")).says("1 skipped: noise: bytes of the serial line"));
}

TEST_CASE("a damaged frame of a serial line is shown as broken, and so is one that is cut off") {
    auto bytes = frame_of(request);
    bytes[bytes.size() - 6] ^= std::byte{0x40}; // the sequence number
    const auto good = frame_of(query);
    bytes.insert(bytes.end(), good.begin(), good.end());
    const auto damaged = serial_of(bytes);
    CHECK(damaged.code == 1);
    CHECK(damaged.codes() == "packet_checksum 0x2002 ");
    auto cut = good;
    cut.resize(cut.size() - 7);
    CHECK(serial_of(cut).codes() == "truncated ");
    CHECK(serial_of({}).codes().empty());
    CHECK(run("--jserial").code == 2);
    CHECK(run("--jserial /nowhere").err.find("No such file") != std::string::npos);
}

TEST_CASE("a capture of a serial line is shown, both directions apart") {
    const scratch files;
    const auto sent = jauscat::test::to_hex(frame_of(request)), received = jauscat::test::to_hex(frame_of(query));
    const auto head = [](const std::string& event) { return "3b9aca00 00000064 " + event + " 15 0000"; };
    dump_test::write_capture(files / "rtac", dump_test::link_rtac_serial,
                             {head("01") + part_of(sent, 0, 9), head("00"), head("02") + received,
                              head("03") + part_of(sent, 9), head("04") + part_of(received, 0, 8)});
    const auto result = run("--format json --reencode " + (files / "rtac"));
    CHECK(result.code == 1);
    const auto objects = result.objects();
    REQUIRE(objects.size() == 3);
    CHECK(objects[0].at("message") == "QueryStatus");
    CHECK(objects[0].at("origin").at("from") == "RX");
    CHECK(objects[0].at("origin").at("packet") == 3);
    CHECK(objects[1].at("hex") == "0011000106050400030201000d00230700");
    CHECK(objects[1].at("origin").at("from") == "TX");
    CHECK(objects[1].at("origin").at("packet") == 4);
    CHECK(objects[2].at("error").at("error") == "truncated");

    dump_test::write_capture(files / "user", dump_test::link_user0 + 7,
                             {sent + part_of(received, 0, 9), part_of(received, 9)});
    CHECK(run("--format json --summary " + (files / "user")).objects().at(0).at("decoded") == 2);
    dump_test::write_capture(files / "short", dump_test::link_rtac_serial, {"3b9aca00"});
    CHECK(run(files / "short").says("1 skipped: shorter than its RTAC serial header"));
}

TEST_CASE("messages of TCP streams are counted by a replay, and their segments written whatever the filters are") {
    const scratch files;
    const auto capture = files / "capture", copy = files / "copy";
    const auto stream = "02" + request + query;
    dump_test::write_capture(capture, dump_test::link_raw,
                             {segment(99, "", syn), segment(100, part_of(stream, 0, 9)),
                              segment(109, part_of(stream, 9)), dump_test::udp_packet("02" + request)});
    const auto replayed = run(capture + " --format json --speed 0 --replay 127.0.0.1:9"); // discard
    REQUIRE(replayed.objects().size() == 1);
    CHECK(replayed.objects()[0].at("sent") == 1);
    CHECK(replayed.objects()[0].at("tcp") == 1);
    REQUIRE(run(capture + " --code 2002 --write " + copy).code == 0);
    const auto read = run("--format json " + copy).objects();
    REQUIRE(read.size() == 2);
    CHECK(read[0].at("code") == "0x000D");
    CHECK(read[1].at("code") == "0x2002");
}
