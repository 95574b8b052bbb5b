// The table of messages by sender.
#include "program.hpp"
#include "support/catch.hpp"
#include "support/terminal_program.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>

#include <sys/ioctl.h>
#include <termios.h>

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

const std::string other_status = "0602 0240 01200101 01210101 0500 0800 0100000002";

struct table_capture {
    scratch files{};
    std::string path{files / "a.pcap"};
    table_capture() {
        std::vector<std::string> frames;
        for (const auto& message : {status, wrench, other_status, control, status})
            frames.push_back(ethernet_frame(udp_packet(message)));
        write_capture(path, dump_test::link_ethernet, frames);
    }
};

} // namespace

TEST_CASE("the table of a capture has counts, rates, ages and changed bytes by message and sender") {
    const table_capture capture;
    const auto result = run("--top " + capture.path);
    REQUIRE(result.code == 0);
    CHECK(
        result.out ==
        "code   message                                source             count   per s age (s)  size  body, * behind "
        "changed bytes\n"
        "0x000D RequestControl                         1.2.3                  1       -     1.0     3  0d 00 23\n"
        "0x0405 Set Wrench Effort                      1.1.32.1               1       -     3.0     5  41 00 ff 3f 20\n"
        "0x4002 Report Component Status                1.1.33.1               3    0.50     0.0     5  01 00 00 00 "
        "00*\n");
}

TEST_CASE("the table is sorted by each column, and is JSON on request") {
    const table_capture capture;
    const auto codes = [&](const std::string& order) {
        std::string all;
        for (const auto& row : run("--top --format json --sort " + order + " " + capture.path).objects())
            all += row.at("code").get<std::string>() + " ";
        return all;
    };
    const std::string control_first = "0x000D 0x0405 0x4002 ", status_first = "0x4002 0x000D 0x0405 ";
    CHECK(codes("code") == control_first);
    CHECK(codes("message") == "0x4002 0x000D 0x0405 ");
    CHECK(codes("source") == "0x0405 0x4002 0x000D ");
    CHECK(codes("count") == status_first);
    CHECK(codes("rate") == status_first);
    CHECK(codes("age") == status_first);
    const auto row = run("--top --format json --code 4002 " + capture.path).objects().at(0);
    CHECK(row == json{{"message", "Report Component Status"},
                      {"code", "0x4002"},
                      {"generation", "RA"},
                      {"source", "1.1.33.1"},
                      {"count", 3},
                      {"rate", 0.5},
                      {"age", 0.0},
                      {"size", 5},
                      {"bytes", "0100000000"},
                      {"changed", {4}}});
}

TEST_CASE("options of the table that do not fit are refused") {
    const table_capture capture;
    const auto says = [&](const std::string& arguments, const std::string& text) {
        const auto result = run(arguments + " " + capture.path);
        INFO(arguments << ": " << result.err);
        CHECK(result.code == 2);
        CHECK(result.err.find(text) != std::string::npos);
    };
    says("--sort rate", "--sort needs --top");
    says("--interval 1", "--interval needs --top");
    says("--top --interval -1", "--interval must be above 0");
    says("--top --sort size", "--sort must be code or message");
    says("--top --summary", "--summary does not go with --top");
}

TEST_CASE(
    "on a terminal the table of a port is drawn, sorted by keys, follows the window, and q gives the terminal back") {
    boost::asio::io_context context;
    boost::asio::ip::udp::socket socket{context, boost::asio::ip::udp::v4()};
    support::terminal_program program{{dump_test::jausdump(), "--listen", "0", "--top", "--interval", "0.05"}};
    program.wait_for("listening on UDP port ");
    program.wait_for("; Ctrl-C ends it");
    const auto& seen = program.seen();
    const auto at = seen.find("port ") + 5;
    const auto port = static_cast<std::uint16_t>(std::stoi(seen.substr(at)));
    const auto send = [&](const std::string& hex) {
        socket.send_to(boost::asio::buffer(from_hex(hex)), {boost::asio::ip::address_v4::loopback(), port});
    };
    CHECK(seen.find("\033[?1049h\033[?25l") != std::string::npos);
    program.wait_for("0 messages; by c code");
    send(wrench);
    program.wait_for("0x0405 Set Wrench");
    send(status);
    send(other_status);
    program.wait_for("01 00 00 00 \033[7m02\033[0m");
    program.type("n");                              // the most frequent one first
    program.wait_for("\033[0m\033[K\r\r\n0x4002 "); // the terminal adds a CR
    program.type("\033[Bx");                        // an arrow and an unknown key
    program.resize(40, 10);
    program.wait_for("\033[1mcode   message      source      count   \033[0m");
    program.type("q");
    CHECK(program.exit_code() == 0);
    CHECK(seen.find("\033[?25h\033[?1049l") != std::string::npos);
    CHECK(seen.rfind("\033[?1049l") < seen.rfind("Set Wrench")); // the last table stays
}

TEST_CASE("Ctrl-C ends the table too, and a dumb terminal gets it once, without escape sequences") {
    for (const std::string kind : {"xterm", "dumb"}) {
        support::terminal_program program{
            {"/usr/bin/env", "TERM=" + kind, dump_test::jausdump(), "--listen", "0", "--top"}};
        program.wait_for("; Ctrl-C ends it");
        if (kind == "xterm") program.wait_for("0 messages");
        program.type("\x03");
        CHECK(program.exit_code() == 0);
        CHECK(program.seen().find("code   message") != std::string::npos);
        CHECK((program.seen().find('\033') == std::string::npos) == (kind == "dumb"));
    }
}
