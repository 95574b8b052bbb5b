// The datagrams of a capture, sent again.
#include "program.hpp"
#include "support/catch.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>

using boost::asio::ip::udp;
using dump_test::control;
using dump_test::ethernet_frame;
using dump_test::from_hex;
using dump_test::json;
using dump_test::run;
using dump_test::scratch;
using dump_test::status;
using dump_test::udp_packet;
using dump_test::wrench;
using dump_test::write_capture;

namespace {

const std::string prefixed = "4a41555330312e30 " + wrench;

/// A socket that has received all of a replay before it is read.
class receiver {
  public:
    receiver() { socket_.non_blocking(true); }
    [[nodiscard]] std::string target() const { return "127.0.0.1:" + std::to_string(socket_.local_endpoint().port()); }
    std::vector<std::vector<std::byte>> received() {
        std::vector<std::vector<std::byte>> all;
        std::vector<std::byte> buffer(65536);
        boost::system::error_code error;
        for (;;) {
            const auto size = socket_.receive(boost::asio::buffer(buffer), 0, error);
            if (error) return all;
            all.emplace_back(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(size));
        }
    }

  private:
    boost::asio::io_context context_{};
    udp::socket socket_{context_, udp::endpoint{boost::asio::ip::address_v4::loopback(), 0}};
};

struct replayed_capture {
    scratch files{};
    std::string path{files / "a.pcap"};
    replayed_capture() {
        write_capture(path, dump_test::link_ethernet,
                      {ethernet_frame(udp_packet(status)), ethernet_frame(udp_packet("ffff")),
                       ethernet_frame(udp_packet(prefixed)), ethernet_frame(udp_packet(control))});
    }
};

} // namespace

TEST_CASE("the datagrams of a capture arrive byte by byte, in their order") {
    const replayed_capture capture;
    receiver host;
    const auto result = run(capture.path + " --speed 0 --replay " + host.target());
    REQUIRE(result.err.empty());
    REQUIRE(result.code == 0);
    CHECK(result.says("3 datagrams (68 bytes) sent to " + host.target() + " in "));
    CHECK(result.says("1 datagram passed over: not JAUS, or not chosen by the filters\n"));
    CHECK(host.received() == std::vector{from_hex(status), from_hex(prefixed), from_hex(control)});
}

TEST_CASE("filters choose the datagrams that are replayed") {
    const replayed_capture capture;
    receiver host;
    const auto result = run(capture.path + " --format json --speed 0 --code 0405 --replay " + host.target());
    REQUIRE(result.code == 0);
    const auto counts = result.objects().at(0);
    CHECK(counts.at("sent") == 1);
    CHECK(counts.at("bytes") == 29);
    CHECK(counts.at("passed_over") == 3);
    CHECK(counts.at("stopped") == false);
    CHECK(host.received() == std::vector<std::vector<std::byte>>{from_hex(prefixed)});
}

TEST_CASE("a replay keeps the recorded pace, and its factor") {
    const replayed_capture capture; // three seconds
    receiver host;
    const auto seconds = [&](const std::string& speed) {
        return run(capture.path + " --format json --speed " + speed + " --replay " + host.target())
            .objects()
            .at(0)
            .at("seconds")
            .get<double>();
    };
    CHECK(seconds("30") >= 0.1);
    CHECK(seconds("10") >= 0.3);
}

TEST_CASE("a closed port is named, and the other datagrams are sent") {
    const replayed_capture capture;
    std::string target;
    {
        const receiver gone;
        target = gone.target();
    }
    const auto result = run(capture.path + " --speed 0 --replay " + target);
    CHECK(result.code == 1);
    CHECK(result.err.find(target + ": Connection refused: no program receives there; sending goes on\n") !=
          std::string::npos);
    CHECK(result.says("3 datagrams (68 bytes) sent"));
    CHECK(result.says("refused: closed port, or not reachable\n"));
}

TEST_CASE("a wrong host, a capture without datagrams and options that do not fit are refused") {
    const replayed_capture capture;
    const auto says = [&](const std::string& arguments, int code, const std::string& text) {
        const auto result = run(arguments);
        INFO(arguments << ": " << result.err);
        CHECK(result.code == code);
        CHECK(result.err.find(text) != std::string::npos);
    };
    says(capture.path + " --replay 127.0.0.1", 2, "--replay must be HOST:PORT");
    says(capture.path + " --replay 127.0.0.1:0", 2, "--replay must be HOST:PORT");
    says(capture.path + " --replay host.invalid:3794", 2, "--replay host.invalid:3794: ");
    says(capture.path + " --replay 127.0.0.1:3794 --speed -1", 2, "--speed must be 0 or more");
    says(capture.path + " --speed 2", 2, "--speed needs --replay");
    says("--replay 127.0.0.1:3794", 2, "--replay needs a capture");
    says(capture.path + " --replay 127.0.0.1:3794 --top", 2, "--top does not go with --replay");
    says(capture.path + " --replay 127.0.0.1:3794 --code 2402", 1, "nothing to send");
    const scratch files;
    write_capture(files / "none.pcap", dump_test::link_ethernet, {});
    says(files / "none.pcap --replay 127.0.0.1:3794", 1, "nothing to send");
}

TEST_CASE("messages of serial lines are not replayed, which is said") {
    const scratch files;
    write_capture(files / "line.pcap", dump_test::link_user0,
                  {"1001 02 00 1100 01 06050400 03020100 0d0023 0700 1003 0000"});
    const auto result = run(files / "line.pcap --speed 0 --replay 127.0.0.1:3794");
    CHECK(result.code == 1);
    CHECK(result.err.find("nothing to send") != std::string::npos);
}
