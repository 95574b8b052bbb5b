// Two communicators talk, by scripts.
#include "nodes/robot.hpp"
#include <jauscat/jaus/routing/routed.hpp>
#include <jauscat/net/config/verdict.hpp>

#include <cstdio>

using namespace nodes;

namespace {

// What the communicator of system a makes of these lines.
program& talk(robot& r, int code, const std::string& lines) {
    return r.run(code, "communicator", {"--config", r.config, "--this", "a"}, lines);
}

} // namespace

TEST_CASE("communicators send, answer and refuse messages") {
    if (!std::filesystem::exists(bin() / "communicator")) {
        std::puts("SKIPPED: communicator was not built: it needs libedit");
        return;
    }
    robot r;
    auto& other = r.start_program("communicator", {"--config", r.config, "--this", "b"}, "log on\n", true);
    other.wait_for("ready", {{"address", "2.1.32.1"}, {"system", "b"}});
    other.wait_for("log_switched", {{"on", true}});
    auto& first = talk(r, 0,
                       "send b set_component_authority authority_code=5\n"
                       "send b query_component_authority\nhelp\nq\n");
    CHECK(first.has("delivery", {{"code", 0x0001}, {"destination", "2.1.32.1"}, {"result", "acknowledged"}}));
    CHECK(first.has("message_received", {{"code", 0x4001}, {"body", "05"}}));
    CHECK(first.has("command_help"));
    other.wait_for("message_received",
                   {{"code", 0x0001}, {"size", 17}, {"source", "1.1.32.1"}, {"destination", "2.1.32.1"}});
    // Control, and a list; the last line has no end.
    auto& second = talk(r, 0,
                        "send 2.1.32.1 request_component_control authority_code=9\nsend b standby\n"
                        "send b query_component_status\nwait 1\nsend b release_component_control\n"
                        "send 2.1.1.1 query_configuration query_field=node_configuration\npeers");
    CHECK(second.has("message_received", {{"code", 0x000F}})); // Confirm Component Control
    const auto status = second.wait_for("message_received", {{"code", 0x4002}});
    CHECK(status["body"].get<std::string>().starts_with("02")); // Standby
    CHECK(second.has("message_received", {{"code", 0x4B01}}));  // Report Configuration
    const auto peers = second.wait_for("peers", {{"systems", "a b"}, {"heard", "2.1.1.1"}});
    CHECK(peers["text"].get<std::string>().find("2.0.0.0") != std::string::npos);
    CHECK(peers["text"].get<std::string>().find("port " + std::to_string(r.controller_port)) != std::string::npos);
    other.wait_for("controller_taken", {{"controller", "1.1.32.1"}, {"authority", 9}});
    other.wait_for("state_changed", {{"to", "standby"}});
    other.wait_for("controller_gone");
    other.wait_for("peer_heard", {{"address", "1.1.1.1"}});
    // A command that nobody there obeys, lines that are wrong, destinations that lead nowhere.
    CHECK(talk(r, 1, "send b set_travel_speed desired_speed=2.5\nq\n")
              .has("delivery", {{"code", 0x040A}, {"result", "refused"}}));
    for (const std::string wrong :
         {"send c standby", "send b standy", "send b set_component_authority authority_code=x", "nonsense", "wait x"}) {
        INFO(wrong);
        CHECK(talk(r, 1, wrong + "\n").has("line_refused"));
    }
    for (const std::string wrong : {"send 9.1.32.1 standby", "send 2.1.99.1 query_component_status"})
        talk(r, 1, wrong + "\n");
    const auto misspelt = talk(r, 1, "send b standy\n").wait_for("line_refused");
    CHECK(misspelt["text"].get<std::string>().find("standby") != std::string::npos);
    const auto no_component = std::string{describe(jauscat::jaus::routed::no_such_component)};
    other.wait_for("node_log", [&](const json& event) {
        return event["line"].get<std::string>().find(no_component) != std::string::npos;
    });
    // Who is not in the configuration may not send. Standby from 7.1.32.1.
    send_bytes(r.controller_port, "06020300012001020120010700000000");
    const auto unknown = std::string{describe(jauscat::net::verdict::unknown_peer)};
    other.wait_for("node_log", [&](const json& event) {
        return event["line"].get<std::string>().find(unknown) != std::string::npos;
    });
    r.run(2, "communicator", {"--nonsense"});
    CHECK(r.run(0, "communicator", {"--help"}).has_output("Examples:"));
    r.run(1, "communicator", {"--config", r.folder / "none.xml"});
    const auto busy = r.run(1, "communicator", {"--config", r.config, "--this", "b"}).wait_for("failed");
    CHECK(busy["text"].get<std::string>().find(std::to_string(r.controller_port)) != std::string::npos);
    REQUIRE(other.end(SIGINT) == 0);
    const auto stopped = other.wait_for("stopped", {{"unknown_peer", 1}});
    CHECK(stopped["received"] > 0);
}

TEST_CASE("private messages are sent by code in hex, and by name where their schemas are compiled in") {
    if (!std::filesystem::exists(bin() / "gripper_communicator")) {
        std::puts("SKIPPED: communicator was not built: it needs libedit");
        return;
    }
    robot r;
    const auto b = [&](const std::string& name) -> program& {
        auto& started = r.start_program(name, {"--config", r.config, "--this", "b"}, "log on\n", true);
        started.wait_for("ready");
        return started;
    };
    const std::string in_hex = "send b D101 hex=\"00 03 66:66 33\"\n"; // all fingers, 80 mm, 20 %
    auto& plain = b("communicator");
    CHECK(talk(r, 1, in_hex).has("delivery", {{"code", 0xD101}, {"result", "refused"}}));
    const auto in_bytes = plain.wait_for("message_received", {{"code", 0xD101}, {"body", "00 03 66 66 33"}});
    CHECK(in_bytes["text"].get<std::string>().find("command code 0xD101") != std::string::npos);
    for (const std::string wrong :
         {"send b D101", "send b D101 hex=123", "send b D101 opening=80", "send b 9999 hex=xy"}) {
        INFO(wrong);
        CHECK(talk(r, 1, wrong + "\n").has("line_refused"));
    }
    REQUIRE(plain.end(SIGINT) == 0);

    auto& knows = b("gripper_communicator");
    CHECK(talk(r, 0, in_hex).has("delivery", {{"code", 0xD101}, {"result", "acknowledged"}}));
    const auto decoded = knows.wait_for("message_received", {{"message", "Set Gripper"}})["text"].get<std::string>();
    INFO(decoded);
    CHECK(decoded.find("opening = 80 mm") != std::string::npos);
    auto& by_name = r.run(0, "gripper_communicator", {"--config", r.config, "--this", "a"},
                          "send b set_gripper finger=0 opening=80 force=20\n");
    CHECK(by_name.has("message_sent", {{"code", 0xD101}, {"body", "00 03 66 66 33"}, {"message", "Set Gripper"}}));
    knows.wait_for("message_received", {{"code", 0xD101}, {"body", "00 03 66 66 33"}}, 2);
    auto& unit = r.run(0, "gripper_ocu",
                       {"--config", r.config, "--this", "a", "--to", "2.1.32.1", "--no-control", "--send",
                        "set_gripper", "finger=0", "opening=80", "force=20"});
    CHECK(unit.has("message_sent", {{"code", 0xD101}, {"body", "00 03 66 66 33"}, {"message", "Set Gripper"}}));
    auto& unit_in_hex = r.run(0, "ocu",
                              {"--config", r.config, "--this", "a", "--to", "2.1.32.1", "--no-control", "--send",
                               "0xD101", "hex=0003666633"});
    CHECK(unit_in_hex.has("message_sent", {{"code", 0xD101}, {"body", "00 03 66 66 33"}}));
    knows.wait_for("message_received", {{"code", 0xD101}, {"body", "00 03 66 66 33"}}, 4);
    if (!std::filesystem::exists(bin() / "gripper_jausdump")) return;
    program dump{{(bin() / "gripper_jausdump").string()}, "860201d101012002010120010500000000036666 33\n"};
    REQUIRE(dump.wait() == 0);
    CHECK(dump.has_output("Set Gripper"));
    CHECK(dump.has_output("opening = 80 mm"));
}

TEST_CASE("commands are sent without asking for an acknowledgement where none will come") {
    if (!std::filesystem::exists(bin() / "communicator")) {
        std::puts("SKIPPED: communicator was not built: it needs libedit");
        return;
    }
    robot r;
    auto& other = r.start_program("communicator", {"--config", r.config, "--this", "b"}, "log on\n", true);
    other.wait_for("ready");
    auto& silent = r.run(0, "communicator", {"--config", r.config, "--this", "a", "--unacknowledged"},
                         "send b set_component_authority authority_code=5\nsend b query_component_authority\n");
    CHECK(silent.count("delivery") == 0);
    CHECK(silent.has("message_received", {{"code", 0x4001}, {"body", "05"}}));
    other.wait_for("message_received", {{"code", 0x0001}, {"acknowledgement", "none"}});
    auto& both = talk(r, 0,
                      "acknowledge off\nsend b set_component_authority authority_code=6\nacknowledge on\n"
                      "send b set_component_authority authority_code=7\n");
    CHECK(both.has("acknowledgement_switched", {{"on", false}}));
    CHECK(both.count("delivery", {{"result", "acknowledged"}}) == 1);
    other.wait_for("message_received", {{"code", 0x0001}, {"body", "06"}, {"acknowledgement", "none"}});
    other.wait_for("message_received", {{"code", 0x0001}, {"body", "07"}, {"acknowledgement", "request"}});
}

TEST_CASE("a subsystem says what it is") {
    if (!std::filesystem::exists(bin() / "communicator")) {
        std::puts("SKIPPED: communicator was not built: it needs libedit");
        return;
    }
    robot r;
    // Type 10001 is 2711h, 20001 is 4E21h, 30001 is 7531h.
    for (const auto& [type, bytes] : {std::pair{"vehicle", "11 27"}, {"operator", "21 4e"}, {"other", "31 75"}}) {
        INFO(type);
        auto& other = r.start_program("communicator", {"--config", r.config, "--this", "b", "--type", type}, "", true);
        other.wait_for("ready");
        auto& asking = talk(r, 0, "send 2.1.1.1 query_identification query_type=subsystem_identification\n");
        const auto body = asking.wait_for("message_received", {{"code", 0x4B00}})["body"].get<std::string>();
        CHECK(body.substr(6, 5) == bytes);
        REQUIRE(other.end(SIGINT) == 0);
    }
    CHECK(r.run(2, "communicator", {"--config", r.config, "--type", "boat"}).has_output("vehicle, operator or other"));
}
