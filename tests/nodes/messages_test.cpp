// Messages from an operator through the controller to the arm, and back.
#include "nodes/robot.hpp"
#include <jauscat/jaus/routing/routed.hpp>
#include <jauscat/net/config/verdict.hpp>

#include <cstdio>

using namespace nodes;

namespace {

const std::string set_x_to_50_percent = "160205040121020201200101040009000100ff3f"; // from 1.1.32.1, acknowledged

} // namespace

TEST_CASE("a command and its report pass by the seed table", "[valgrind]") {
    robot r;
    r.start();
    auto& unit = r.command_arrives();
    r.controller().wait_for(
        "packet_translated",
        {{"dest", 2}, {"node_id", 2}, {"index", 6933}, {"subindex", 26}, {"data_count", 28}, {"length", 44}});
    r.controller().wait_for("packet_translated", {{"index", 6933}, {"subindex", 72}}); // the query
    r.controller().wait_for("report_requested", {{"node_id", 2}, {"index", 6933}, {"subindex", 121}});
    CHECK(
        unit.has("message_received",
                 {{"code", report_wrench_effort}, {"size", 36}, {"source", "2.2.33.1"}, {"destination", "1.1.32.1"}}));
}

TEST_CASE("a command and its report pass by the self-contained table", "[valgrind]") {
    robot r;
    r.table = "self-contained";
    r.start();
    r.command_arrives();
    r.controller().wait_for("packet_translated",
                            {{"dest", 32}, {"index", 6933}, {"subindex", 26}, {"data_count", 32}, {"length", 48}});
}

TEST_CASE("tables with other index bases carry commands") {
    robot r;
    r.link = r.link + words{"--index-base", "0x2000"};
    r.start();
    r.command_arrives();
    r.controller().wait_for("packet_translated", {{"index", 0x2021}});
    r.stop();
    r.table = "self-contained";
    r.link = {"--ethercat-port", std::to_string(r.slave_port), "--index-base", "0x6900"};
    r.start();
    r.command_arrives();
    r.controller().wait_for("packet_translated", {{"index", 0x6921}});
    auto& refused = r.run(2, "robot_arm", {"--config", r.config, "--index-base", "0x3000"});
    CHECK(refused.wait_for("usage_error")["text"].get<std::string>().find("--index-base") != std::string::npos);
}

TEST_CASE("a strict arm accepts objects of exact size only") {
    robot r;
    r.arm_options = {"--strict"};
    r.start();
    r.command_arrives(); // with all its fields it has the object's size
    auto& refused = r.ocu(1, {"propulsive_linear_effort_x=1"});
    CHECK(refused.has("message_refused", {{"code", set_wrench_effort}}));
    const auto why = r.controller().wait_for("not_delivered", {{"abort_code", 0x06070010}});
    CHECK(why["text"].get<std::string>().find("fixed_length") != std::string::npos);
    r.stop();
    for (const std::string table : {"seed", "self-contained"}) {
        r.table = table;
        r.link = {"--ethercat-port", std::to_string(r.slave_port), "--fixed-length"};
        r.start();
        r.command_arrives();
        r.ocu(0, {"propulsive_linear_effort_y=-100"});
        const auto report = r.ocu(0, {"--query"}).wait_for("message_received", {{"code", report_wrench_effort}});
        CHECK(*efforts_in(report).propulsive_linear_effort_y == Approx(-100));
        r.stop();
    }
}

TEST_CASE("a slave with the rule of subindex 0 needs an option of the controller, or another index base") {
    robot r;
    r.arm_options = {"--subindex-0-rule"};
    r.start_arm();
    r.start_controller();
    CHECK(r.ocu(1, {"propulsive_linear_effort_x=1"}).has("message_refused"));
    r.controller().wait_for("stop_refused", {{"abort_code", 0x06010003}, {"status", 0xC0650044}});
    REQUIRE(r.controller().end(SIGTERM) >= 0); // the arm refuses zeros, too
    REQUIRE(r.arm().end(SIGTERM) == 0);
    r.master_options.emplace_back("--clear-subindex-0");
    r.start();
    r.command_arrives();
    r.stop();
    r.master_options.pop_back();
    r.link = {"--ethercat-port", std::to_string(r.slave_port), "--index-base", "0x2000"}; // not a mapping object
    r.start();
    r.command_arrives();
}

TEST_CASE("a private message passes to a slave and back") {
    robot r;
    auto& one = r.start_command(wrapper() + words{(bin() / "private_message").string()});
    REQUIRE(one.wait() == 0);
    for (const std::string line :
         {"opening = 80", "ul_index = 8225", "ul_sub_index = 159", "translated back: the same 21 bytes",
          "slave: object 0x2021:159, 17 bytes", "confirmation: ok (ulSta 0x00000000)", "slave: finger 0, opening 80",
          "force 20 %", "answer: command code 0xD101 (ACK), 16 bytes, 1.2.33.1 -> 1.1.32.1, sequence 7"}) {
        INFO(line);
        CHECK(one.has_output(line));
    }
}

TEST_CASE("packets of a card's API are executed") {
    robot r;
    auto& one = r.start_command(wrapper() + words{(bin() / "card_packets").string()});
    REQUIRE(one.wait() == 0);
    for (const std::string line : {"scan: ok (ulSta 0x00000000)", "slaves: 2", "vendor 0x00001A2B, product 0x00000002",
                                   "0x1018:1 is 2b 1a 00 00", "0x1018 \"Identity\", highest subindex 4", "state 4"}) {
        INFO(line);
        CHECK(one.has_output(line));
    }
    auto& no_link = r.start_command(wrapper() + words{(bin() / "card_packets").string(), "no_such_link"});
    REQUIRE(no_link.wait() == 1);
    CHECK(no_link.has_output("card_packets: "));
}

TEST_CASE("messages with the prefix JAUS01.0 pass, and bare ones beside them") {
    robot r;
    auto text = content(r.config);
    for (auto at = text.find("</port>"); at != std::string::npos; at = text.find("</port>", at + 20))
        text.insert(at + 7, "<framing>JAUS01.0</framing>");
    write_file(r.config, text);
    r.master_options.emplace_back("--open");
    r.start();
    r.command_arrives();
    send_bytes(r.controller_port, "060205040121020201200101040009000100ff3f");
    r.arm().wait_for("efforts_in_force", {{"propulsive_linear_effort_x", 16383}});
}

TEST_CASE("a query alone returns all efforts in force") {
    robot r;
    r.start();
    r.ocu(0, {"propulsive_linear_effort_y=-100"});
    const auto report = r.ocu(0, {"--query"}).wait_for("message_received", {{"code", report_wrench_effort}});
    CHECK(report["body"].get<std::string>().starts_with("ff 0f ")); // presence vector
    CHECK(*efforts_in(report).propulsive_linear_effort_y == Approx(-100));
    CHECK(*efforts_in(report).resistive_rotational_effort_z == 0);
}

TEST_CASE("random fields are reported as they were commanded", "[valgrind]") {
    robot r;
    r.start();
    for (const auto* seed : {"1", "2", "3", "4", "5"})
        CHECK(r.ocu(0, {"--random", seed}).has("report_compared", {{"equal", true}}));
}

TEST_CASE("any message of the standard is sent by its name, and refused by a robot without a handler") {
    robot r;
    r.start();
    // The nearest of 16 bits over 10000 m/s.
    CHECK(r.ocu(0, {"--send", "set_travel_speed", "desired_speed=2.5"}).has("done", {{"acknowledged", true}}));
    const auto set = r.arm().wait_for("travel_speed_set");
    CHECK(set["speed"].get<double>() == Approx(2.4414435).epsilon(1e-6));
    r.ocu(0, {"--send", "query_travel_speed"});
    r.ocu(0, {"--send", "Set Component Authority", "authority_code=7"});
    auto& refused = r.ocu(1, {"--send", "query_camera_pose", "camera_id=1", "presence_vector=1"});
    CHECK(refused.has("message_sent", {{"code", 0x2800}}));
    CHECK(refused.has("message_refused", {{"code", 0x2800}}));
}

TEST_CASE("a datagram with the source of another system is refused, and garbage on the sockets does no harm",
          "[valgrind]") {
    robot r;
    r.start();
    // Closed, as it is by default, the controller takes nothing from a port that is nobody's.
    send_bytes(r.controller_port, set_x_to_50_percent);
    const auto refused = std::string{describe(jauscat::net::verdict::wrong_sender)};
    r.controller().wait_for("node_log", [&](const json& event) {
        return event["line"].get<std::string>().find(refused) != std::string::npos;
    });
    CHECK(!r.controller().has("message_received", {{"code", set_wrench_effort}}));
    REQUIRE(r.controller().end(SIGTERM) == 0);
    r.master_options.emplace_back("--open");
    robot::is_ready(r.start_controller());
    std::uint32_t state = 1;
    const auto random_hex = [&](std::size_t bytes) {
        std::string text;
        for (std::size_t i = 0; i != bytes; ++i) {
            state = state * 1664525 + 1013904223;
            char digits[3]{};
            std::snprintf(digits, sizeof digits, "%02x", state >> 24);
            text += digits;
        }
        return text;
    };
    for (const auto port : {r.controller_port, r.slave_port}) {
        send_bytes(port, "00");
        send_bytes(port, "4a41555330312e30");
        send_bytes(port, "ffffffffffffffffffffffffffffffffffffffffffffffff");
        send_bytes(port, random_hex(1400));
        for (std::size_t size = 1; size <= 200; size += 4) send_bytes(port, random_hex(size));
    }
    // A Set Wrench Effort whose presence vector announces more than there is, asking for an acknowledgement.
    send_bytes(r.controller_port, "1602050401210202012001010200630000ff0f");
    send_bytes(r.controller_port, "16020504012102020120010102006300ff0f");
    const auto malformed = std::string{describe(jauscat::net::verdict::malformed)};
    r.controller().wait_for("node_log", [&](const json& event) {
        return event["line"].get<std::string>().find(malformed) != std::string::npos;
    });
    r.arm().wait_for("message_malformed", {{"code", set_wrench_effort}});
    r.controller().wait_for(
        "not_delivered", {{"address", "2.2.33.1"}, {"status", 0xC065003B}, {"abort_code", 0x06090030}, {"station", 2}});
    r.controller().wait_for("message_sent", {{"code", set_wrench_effort}, {"acknowledgement", "nak"}});
    // A Set Component Authority without its body: the log names the field.
    send_bytes(r.controller_port, "16020100012102020120010100006400");
    r.controller().wait_for("node_log", [&](const json& event) {
        return event["line"].get<std::string>().find("authority_code") != std::string::npos;
    });
    // A command code that the table does not have.
    send_bytes(r.controller_port, "16029999012102020120010100006300");
    r.controller().wait_for("not_delivered", {{"code", 0x9999}, {"refusal", "not_translated"}});
    r.command_arrives();
}

TEST_CASE("a flood of messages does not fill the log") { // each of these makes 30 lines
    robot r;
    r.master_options.emplace_back("--open");
    r.start();
    send_bytes(r.controller_port, "060205040121020201200101040009000100ff3f", 3000);
    // The next entry of a cause says how many were left out.
    const auto is_left_out = [&] {
        for (const auto& event : r.controller().events("message_received"))
            if (event.contains("left_out")) return true;
        return false;
    };
    REQUIRE(eventually([&] {
        r.ocu(0, {"--query"});
        return is_left_out();
    }));
    CHECK(r.controller().count("message_received", {{"code", set_wrench_effort}}) < 1000);
    r.command_arrives();
}

TEST_CASE("messages to nodes and components that do not exist are dropped") {
    robot r;
    r.start();
    using jauscat::jaus::routed;
    const auto is_about = [](const std::string& text) {
        return [=](const json& event) { return event["line"].get<std::string>().find(text) != std::string::npos; };
    };
    for (const auto& [address, why] :
         {std::pair<std::string, routed>{"2.9.33.1", routed::no_route}, {"2.2.99.1", routed::no_such_component}}) {
        auto& unit = r.ocu(1, {"--to", address, "propulsive_linear_effort_x=1"});
        CHECK(unit.has("control_unanswered", {{"address", address}}));
        r.controller().wait_for("node_log", is_about("-> " + address + ": " + std::string{describe(why)}));
    }
    CHECK(!r.arm().has("message_received", {{"source", "1.1.32.1"}}));
}

TEST_CASE("a unit reports that it cannot reach a subsystem outside of its configuration") {
    robot r;
    r.start();
    CHECK(r.ocu(1, {"--to", "3.2.33.1", "propulsive_linear_effort_x=1"})
              .has("control_unanswered", {{"address", "3.2.33.1"}}));
}

TEST_CASE("a large data set is delivered when it is complete") {
    robot r;
    r.master_options.emplace_back("--open");
    r.start();
    const std::string head = "160205040121020201200101"; // one field; each packet asks for an acknowledgement
    const auto zeros = std::string(1000, '0');
    const json translated{{"index", 6933}, {"subindex", 26}, {"data_count", 12}};
    send_bytes(r.controller_port, head + "0210000001");                // wrong size: dropped
    send_bytes(r.controller_port, head + "021000000100");              // the first packet: presence vector
    send_bytes(r.controller_port, "06020220012102020120010900000000"); // Query Component Status of another
    r.controller().wait_for("message_received", {{"source", "9.1.32.1"}});
    CHECK(!r.controller().has("packet_translated", translated));
    send_bytes(r.controller_port, head + "02800100ff3f"); // the last packet: the effort
    r.controller().wait_for("packet_translated", translated);
    r.arm().wait_for("efforts_in_force", {{"propulsive_linear_effort_x", 16383}});
    // More than an SDO packet holds.
    send_bytes(r.controller_port, head + "f4110000" + zeros);
    for (const auto* number : {"1", "2"}) send_bytes(r.controller_port, head + "f4210" + number + "00" + zeros);
    send_bytes(r.controller_port, head + "f4810300" + zeros);
    r.controller().wait_for("not_delivered", {{"address", "2.2.33.1"}, {"refusal", "too_large"}});
}

TEST_CASE("objects pass a mailbox of 24 bytes in segments") { // 8 bytes of data in a first message, 15 in a segment
    robot r;
    r.arm_options = {"--mailbox-size", "24", "--empty-start", "--node", "2"};
    r.start();
    r.command_arrives();
    CHECK(r.controller().has("sdo_sent", {{"kind", "segment_request"}, {"mailbox_length", 18}}));
    for (const words& wrong : {words{"--mailbox-size", "23"}, words{"--node", "255"}}) {
        const auto error = r.run(2, "robot_arm", words{"--config", r.config} + wrong).wait_for("usage_error");
        CHECK(error["text"].get<std::string>().find(wrong[0]) != std::string::npos);
    }
}

TEST_CASE("a restarted arm receives commands again") {
    robot r;
    r.start();
    r.command_arrives();
    REQUIRE(r.arm().end(SIGTERM) == 0);
    CHECK(r.ocu(1, {"--timeout", "5000", "propulsive_linear_effort_x=1"}).has("message_refused"));
    r.start_arm();
    r.controller().wait_for("slave_up", {{"station", 2}, {"state", "pre_op"}}, 2);
    r.command_arrives();
}

TEST_CASE("the programs end with exit code 0 on Ctrl-C and SIGTERM") {
    robot r;
    r.start();
    REQUIRE(r.controller().end(SIGINT) == 0);
    CHECK(r.controller().has("stopped"));
    REQUIRE(r.arm().end(SIGTERM) == 0);
    CHECK(r.arm().has("stopped"));
}

TEST_CASE("output has colours on terminals only") {
    if (!is_installed("script")) {
        std::puts("SKIPPED: script (package bsdutils) is missing");
        return;
    }
    robot r;
    const std::string escape = "\033";
    std::string in_front;
    for (const auto& word : wrapper()) in_front += word + " ";
    const auto on_terminal = [&](const words& variables, const std::string& command) -> program& {
        auto& one = r.start_command(words{"env", "TERM=xterm", "NO_COLOR="} + variables +
                                    words{"script", "-qec", in_front + bin().string() + "/" + command, "/dev/null"});
        one.wait();
        return one;
    };
    CHECK(on_terminal({}, "cyclic --period 0")
              .has_output(escape + "[31mcyclic: --period must be 1 to 1000000" + escape + "[0m"));
    CHECK(on_terminal({}, "ocu --help").has_output(escape + "[1mOptions" + escape + "[0m:"));
    for (const std::string variable : {"NO_COLOR=1", "TERM=dumb"}) {
        auto& plain = on_terminal({variable}, "ocu --help");
        CHECK(plain.has_output("Options:"));
        CHECK(!plain.has_output(escape + "["));
    }
    auto& no_terminal = r.start_command({(bin() / "ocu").string(), "--help"});
    REQUIRE(no_terminal.wait() == 0);
    CHECK(no_terminal.has_output("Options:"));
    CHECK(!no_terminal.has_output(escape + "["));
    r.start();
    const auto command = "ocu --config " + r.config + " --this a propulsive_linear_effort_x=50";
    CHECK(on_terminal({}, command).has_output(escape + "[32mOK: the report equals the command" + escape + "[0m"));
    CHECK(!on_terminal({}, command + " --log-format json").has_output(escape + "["));
    CHECK(!r.controller().has_output(escape + "["));
    CHECK(!r.arm().has_output(escape + "["));
}
