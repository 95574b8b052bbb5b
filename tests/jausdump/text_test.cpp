// Readable output: columns, fields, colours; and the command line.
#include "program.hpp"
#include "support/catch.hpp"
#include "support/terminal_program.hpp"

using dump_test::jausdump;
using dump_test::run;

namespace {
const std::string wrench = "0602 0504 01210202 01200101 0500 2200 4100 ff3f 20\n";
}

TEST_CASE("a message is shown as a line of columns, then its fields with units and raw integers") {
    const auto result = run("", wrench);
    REQUIRE(result.code == 0);
    REQUIRE(
        result.out ==
        " number  time (UTC)       code    message                                 body  source          -> "
        "destination      sequence\n"
        "      1                   0x0405  Set Wrench Effort                          5  1.1.32.1        -> 2.2.33.1  "
        "       34\n"
        "         presence_vector = 0x0041\n"
        "         propulsive_linear_effort_x = 49.998474 % (raw 16383)\n"
        "         resistive_linear_effort_x = 12.54902 % (raw 32)\n"
        "\n"
        "code    message                                  count       bytes  not decoded\n"
        "0x0405  Set Wrench Effort                            1          21\n"
        "1 message: 1 decoded\n");
}

TEST_CASE("bytes are shown with offsets on request, and where a message is broken") {
    const std::string dump = "         0000  06 02 05 04 01 21 02 02 01 20 01 01 05 00 22 00\n"
                             "         0010  41 00 ff 3f 20\n";
    REQUIRE_FALSE(run("", wrench).says(dump));
    REQUIRE(run("--hex", wrench).says(dump));

    const auto broken = run("", "0602 0504 01210202 01200101 0300 2200 4100 ff\n");
    REQUIRE(broken.code == 1);
    REQUIRE(broken.says("propulsive_linear_effort_x at byte 18 needs 2 bytes, 1 left\n"));
    REQUIRE(broken.says("         0010  41 00 ff\n"));
    const auto unknown = run("", "0602 15e0 01210202 01200101 0100 2200 41\n");
    REQUIRE(unknown.says("unknown: command code 0xE015 is not one of the standard's\n"));
    REQUIRE(unknown.says("         0010  41\n"));
}

TEST_CASE("encoded and translated bytes are described") {
    const auto result = run("--reencode --translate seed", wrench);
    REQUIRE(result.says("         encoded again: 06020504012102020120010105002200"
                        "4100ff3f20\n"));
    REQUIRE(result.says("         SDO packet: 0200000000000000"));
    REQUIRE(
        run("--translate seed", "0602 15e0 01210202 01200101 0000 2200\n").says("SDO packet: unknown_command_code\n"));
}

TEST_CASE("payload data elements are shown after their bytes") {
    const auto result =
        run("--payload-types 2,21", "9002010d ffff94ff 6c218209 0b00 3f22 02 01 00000080 02 0100 ffff\n");
    REQUIRE(result.code == 0);
    REQUIRE(result.says("         element[0]: interface 1 = -2147483648\n"
                        "         element[1]: interface 2 = {\"first\":1,\"second\":65535}\n"));
}

TEST_CASE("the summary counts by message") {
    const auto result = run("--summary", wrench + wrench + "06\n");
    REQUIRE(result.out == "\n"
                          "code    message                                  count       bytes  not decoded\n"
                          "-       not a message                                1           1            1\n"
                          "0x0405  Set Wrench Effort                            2          42\n"
                          "3 messages: 2 decoded, 1 broken\n");
}

TEST_CASE("a terminal gets colours, except with NO_COLOR") {
    const dump_test::scratch files;
    std::ofstream{files / "in"} << wrench;
    const auto on_terminal = [&](const std::string& before) {
        const auto command = before + " script -qec \"'" + jausdump() + "' <" + (files / "in") + "\" /dev/null >" +
                             (files / "out") + " 2>/dev/null";
        REQUIRE(std::system(command.c_str()) == 0);
        return dump_test::content(files / "out");
    };
    if (std::system("command -v script >/dev/null") != 0) {
        std::puts("SKIPPED: script (package bsdutils) is missing");
        return;
    }
    const std::string coloured = "\033[1mSet Wrench Effort\033[0m";
    REQUIRE(on_terminal("TERM=xterm NO_COLOR=").find(coloured) != std::string::npos);
    const auto plain = on_terminal("TERM=xterm NO_COLOR=1");
    REQUIRE(plain.find("Set Wrench Effort") != std::string::npos);
    REQUIRE(plain.find('\033') == std::string::npos);
    REQUIRE(on_terminal("TERM=dumb NO_COLOR=").find('\033') == std::string::npos);
    REQUIRE(run("", wrench).out.find('\033') == std::string::npos);
}

TEST_CASE("the progress of a long capture is shown on a terminal without messages") {
    if (std::system("command -v script >/dev/null") != 0) {
        std::puts("SKIPPED: script (package bsdutils) is missing");
        return;
    }
    const dump_test::scratch files;
    const auto seen = [&](const std::string& output) {
        const auto command = "script -qec \"'" + jausdump() + "' " + support::test_data("jaus_ra.pcap") + " " + output +
                             "\" /dev/null >" + (files / "terminal") + " 2>/dev/null";
        static_cast<void>(std::system(command.c_str())); // 1: not all of this capture is of the standard
        return dump_test::content(files / "terminal");
    };
    REQUIRE(seen(">" + (files / "out")).find("reading: 50 %") != std::string::npos);
    REQUIRE(seen("").find("reading:") == std::string::npos);
}

TEST_CASE("without arguments on a terminal the program states its input, and Ctrl-C ends it with the summary") {
    support::terminal_program program{{jausdump()}};
    program.wait_for("jausdump: type messages as hex digits, one a line");
    program.type(wrench);
    program.wait_for("propulsive_linear_effort_x");
    program.type("\x03");
    program.wait_for("1 message: 1 decoded");
    REQUIRE(program.exit_code() == 0);
}

TEST_CASE("Ctrl-C on a terminal also ends it before any input, and inside a line") {
    for (const std::string keys : {"", "0602"}) {
        support::terminal_program program{{jausdump()}};
        program.wait_for("Ctrl-D or Ctrl-C ends it, --help explains more");
        program.type(keys + "\x03");
        program.wait_for("0 messages");
        REQUIRE(program.exit_code() == 0);
    }
}

TEST_CASE("unterminated lines and many lines at once are all read") {
    std::string many;
    for (int i = 0; i != 5000; ++i) many += wrench;
    const auto result = run("--summary", many + wrench.substr(0, wrench.size() - 1));
    REQUIRE(result.code == 0);
    REQUIRE(result.says("5001 messages: 5001 decoded\n"));
}

TEST_CASE("help shows examples and the exit codes") {
    const auto result = run("--help");
    REQUIRE(result.code == 0);
    for (const auto* text : {"Examples:", "Exit code:", "--payload-types", "--listen", "jausdump drive.pcap"})
        REQUIRE(result.says(text));
}

TEST_CASE("a wrong command line ends with exit code 2 and an explanation") {
    const auto says = [](const std::string& arguments, const std::string& text) {
        const auto result = run(arguments);
        INFO(arguments << ": " << result.err);
        REQUIRE(result.code == 2);
        REQUIRE(result.out.empty());
        REQUIRE(result.err.find(text) != std::string::npos);
    };
    says("--nonsense", "nonsense");
    says("--format xml", "--format must be text or json, not 'xml'");
    says("--translate paper", "--translate must be seed or self-contained, not 'paper'");
    says("--code xyz", "'xyz' is no command code");
    says("--code 10405", "'10405' is no command code");
    says("--name wrnch", "no message has 'wrnch' in its name");
    for (const auto* id : {"1.2.3.4.5", "1..3", "65536", "1.256", "0", "1.x", "1."})
        says("--from " + std::string{id}, "is no JAUS ID");
    says("--payload-types 1,23", "'23' is no payload type code");
    says("--payload-types /nowhere", "cannot read /nowhere");
    says("--listen 70000", "listen");
    says("--join 224.1.0.1", "--join needs --listen");
    says("--listen 3794 a.pcap", "either a capture or --listen");
    says("a.pcap b.pcap", "too many positional");
    says("--listen 0 --join 300.1.1.1", "300.1.1.1");
}
