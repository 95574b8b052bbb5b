// The operator control unit's session: control, refusals, losses, heartbeats; and the demonstration.
#include "nodes/namespaces.hpp"
#include "nodes/robot.hpp"
#include "support/paths.hpp"

#include <algorithm>
#include <filesystem>

using namespace nodes;

namespace {

const json has_control{{"address", "2.2.33.1"}};

// Ends a unit that holds control, which it releases.
void releases(program& unit, int signal) {
    REQUIRE(unit.end(signal) == 0);
    CHECK(unit.has("control_released", {{"address", "2.2.33.1"}, {"acknowledged", true}}));
}

} // namespace

TEST_CASE("a unit without a robot reports what is missing") {
    robot r;
    auto& control = r.ocu(1, {"--timeout", "100", "propulsive_linear_effort_x=1"});
    CHECK(control.has("control_unanswered", {{"address", "2.2.33.1"}, {"heard", false}}));
    CHECK(!control.has("message_sent", {{"code", set_wrench_effort}}));
    auto& query = r.ocu(1, {"--timeout", "100", "--query"});
    CHECK(query.has("no_answer", {{"code", query_wrench_effort}, {"heard", false}}));
    CHECK(query.has("copies_sent", {{"code", query_wrench_effort}, {"copies", 4}}));
    auto& wait = r.ocu(1, {"--wait", "0.5", "--query"});
    CHECK(wait.has("no_heartbeat", {{"subsystem", 2}}));
    CHECK(!wait.has("message_sent", {{"code", query_wrench_effort}}));
    // The node is there, the component is not.
    r.start();
    auto& no_component =
        r.ocu(1, {"--wait", "60", "--timeout", "100", "--to", "2.2.34.1", "propulsive_linear_effort_x=1"});
    CHECK(no_component.has("robot_heard", {{"address", "2.2.1.1"}}));
    CHECK(no_component.has("control_unanswered", {{"address", "2.2.34.1"}, {"heard", true}}));
    CHECK(no_component.has("heartbeats_counted", {{"address", "2.2.1.1"}}));
    r.ocu(0, {"--wait", "60", "--query"});
}

TEST_CASE("a unit takes control and releases it") {
    robot r;
    r.start();
    // One after the other: the second must not be taken for a repeat of the first.
    for (int i = 0; i != 3; ++i) {
        auto& unit = r.ocu(0, {"--authority", "7", "propulsive_linear_effort_x=50"});
        const auto request = unit.wait_for("message_sent", {{"code", 0x000D}});
        CHECK(request["body"].get<std::string>().ends_with("07")); // authority
        CHECK(unit.has("control_gained", has_control));
        CHECK(unit.has("report_compared", {{"equal", true}}));
        CHECK(unit.has("control_released", {{"address", "2.2.33.1"}, {"acknowledged", true}}));
    }
    r.nobody_controls();
    // Where nobody has control, no one must ask for it.
    auto& without = r.ocu(0, {"--no-control", "propulsive_linear_effort_x=20"});
    CHECK(!without.has("message_sent", {{"code", 0x000D}}));
    CHECK(!without.has("control_gained"));
    auto& keeps = r.ocu(0, {"--hold", "2.5", "propulsive_linear_effort_x=30"});
    CHECK(keeps.has("holding", {{"seconds", 2.5}, {"control", true}}));
    CHECK(keeps.wait_for("heartbeats_counted", {{"address", "2.2.1.1"}})["count"] >= 2);
    for (const auto* state : {"standby", "resume"}) CHECK(r.ocu(0, {"--send", state}).has("done"));
}

TEST_CASE("a unit that requests no acknowledgement gets none") {
    robot r;
    r.start();
    auto& unit = r.ocu(0, {"--unacknowledged", "propulsive_linear_effort_x=50"});
    CHECK(unit.has("report_compared", {{"equal", true}, {"acknowledged", false}}));
    CHECK(!unit.has("message_received", {{"acknowledgement", "ack"}}));
    r.nobody_controls();
    CHECK(r.ocu(0, {"--unacknowledged", "--send", "standby"}).has("done", {{"acknowledged", false}}));
    r.controller().wait_for("state_changed", {{"from", "ready"}, {"to", "standby"}});
    CHECK(r.ocu(1, {"--unacknowledged", "--timeout", "50", "--to", "2.2.34.1", "--query"})
              .has("no_answer", {{"code", query_wrench_effort}}));
}

TEST_CASE("a unit detects by the report whether a peer that never acknowledges has executed a command") {
    struct peer {
        std::string manner;
        int code;
    };
    for (const auto& [manner, code] : {peer{"obeys", 0}, {"ignores", 1}, {"mute", 1}}) {
        INFO("the peer " << manner);
        robot r;
        auto& silent = r.start_command({"python3", support::source_file("tests/nodes/silent_peer.py"),
                                        std::to_string(r.controller_port), std::to_string(r.ocu_port), manner});
        silent.wait_for_output("silent peer: ready");
        // Its heartbeats come from the component itself.
        auto& unit = r.ocu(code, {"--wait", "60", "--timeout", "50", "propulsive_linear_effort_x=50"});
        CHECK(unit.has("robot_heard", {{"address", "2.2.33.1"}}));
        CHECK(unit.has("control_gained", has_control));
        CHECK(unit.has("not_acknowledged", {{"code", set_wrench_effort}}));
        if (manner == "mute")
            CHECK(unit.has("no_answer", {{"code", query_wrench_effort}, {"heard", true}}));
        else
            CHECK(unit.has("report_compared", {{"equal", manner == "obeys"}, {"acknowledged", false}}));
        CHECK(!unit.has("release_unanswered"));
        CHECK(unit.has("control_released", {{"address", "2.2.33.1"}, {"acknowledged", false}}));
        auto& sender = r.ocu(
            code, {"--wait", "60", "--timeout", "50", "--send", "set_wrench_effort", "propulsive_linear_effort_x=-25"});
        CHECK(sender.has("not_acknowledged", {{"code", set_wrench_effort}}));
        if (manner != "mute")
            CHECK(sender.has("report_compared", {{"equal", manner == "obeys"}, {"acknowledged", false}}));
        auto& other = r.ocu(1, {"--wait", "60", "--timeout", "50", "--send", "standby"}); // nothing reports it
        CHECK(other.wait_for("no_answer")["text"].get<std::string>().find("--unacknowledged") != std::string::npos);
        silent.kill();
    }
}

TEST_CASE("a flood of reports does not fill a unit's log") { // none of which it asked for
    robot r;
    const auto port = r.add_second_unit();
    r.start();
    auto& unit = r.hold({"propulsive_linear_effort_x=50"});
    const json flood{{"code", report_wrench_effort}, {"source", "3.1.32.1"}};
    const auto is_left_out = [&] {
        for (const auto& event : unit.events("message_received", flood))
            if (event.contains("left_out")) return true;
        return false;
    };
    // Report Wrench Effort, from 3.1.32.1; the next of a kind says how many were left out.
    const std::string report = "0602054401200101012001030400000001000040";
    send_bytes_from(port, r.ocu_port, report, 2000);
    REQUIRE(eventually([&] {
        send_bytes_from(port, r.ocu_port, report, 1);
        return is_left_out();
    }));
    CHECK(unit.count("message_received", flood) < 500);
    releases(unit, SIGINT);
}

TEST_CASE("a unit with too little authority is refused, and reports the controller") {
    robot r;
    r.add_second_unit();
    r.start();
    auto& holder = r.hold({"--authority", "100", "propulsive_linear_effort_x=50"});
    const json by_a{{"address", "2.2.33.1"}, {"controller", "1.1.32.1"}, {"authority", 100}};
    for (const auto* authority : {"0", "99", "100"}) { // equal is not higher
        auto& unit = r.ocu(1, {"--authority", authority, "propulsive_linear_effort_x=-20"}, "c");
        CHECK(unit.has("control_refused", has_control));
        CHECK(unit.has("robot_controlled_by", by_a));
        CHECK(!unit.has("message_sent", {{"code", set_wrench_effort}}));
    }
    auto& unit = r.ocu(1, {"--no-control", "propulsive_linear_effort_x=-20"}, "c");
    CHECK(unit.has("message_refused", {{"code", set_wrench_effort}}));
    CHECK(unit.has("robot_controlled_by", by_a));
    r.ocu(1, {"--no-control", "--send", "standby"}, "c");
    // What asks or reports is anybody's.
    const auto report = r.ocu(0, {"--query"}, "c").wait_for("message_received", {{"code", report_wrench_effort}});
    CHECK(*efforts_in(report).propulsive_linear_effort_x == Approx(50.001526).epsilon(1e-6));
    for (const auto& shown : r.arm().events("efforts_in_force")) CHECK(shown["propulsive_linear_effort_x"] >= 0);
    releases(holder, SIGINT);
    r.ocu(0, {"--authority", "0", "propulsive_linear_effort_x=-20"}, "c");
}

TEST_CASE("a unit reports the loss of control, and whether the robot is lost") {
    robot r;
    r.add_second_unit();
    r.start();
    auto& first = r.hold({"propulsive_linear_effort_x=50"});
    r.ocu(0, {"--authority", "129", "propulsive_linear_effort_x=-20"}, "c");
    CHECK(first.wait() == 0); // its command was done
    CHECK(first.has("message_received", {{"code", 0x0010}}));
    CHECK(first.has("control_lost", {{"address", "2.2.33.1"}, {"robot_gone", false}}));
    CHECK(!first.has("message_sent", {{"code", 0x000E}})); // nothing is left to release
    r.nobody_controls();
    // A robot that is gone.
    auto& second = r.hold({"propulsive_linear_effort_x=50"});
    second.wait_for("robot_heard", {{"address", "2.2.1.1"}});
    r.controller().kill();
    CHECK(second.wait() == 0);
    CHECK(second.has("robot_silent", {{"address", "2.2.1.1"}}));
    CHECK(second.has("control_lost", {{"address", "2.2.33.1"}, {"robot_gone", true}}));
}

TEST_CASE("a unit that loses control before its commands are sent fails") { // while the arm does not answer its command
    robot r;
    r.add_second_unit();
    if (!is_slow()) r.master_options = {"--frame-timeout", "500", "--stop-within", "2000"};
    r.start();
    r.arm().signal(SIGSTOP);
    auto& first = r.unit({"--timeout", "30000", "propulsive_linear_effort_x=50"});
    first.wait_for("message_sent", {{"code", set_wrench_effort}});
    r.controller().signal(SIGSTOP); // it goes on when the request of c is there
    auto& second = r.unit({"--timeout", "30000", "--authority", "200", "propulsive_linear_effort_x=-20"}, "c");
    second.wait_for("message_sent", {{"code", 0x000D}});
    r.controller().signal(SIGCONT);
    CHECK(first.wait() == 1);
    CHECK(first.has("control_lost", {{"address", "2.2.33.1"}, {"robot_gone", false}}));
    CHECK(!first.has("control_released"));
    CHECK(second.wait() == 1); // the arm does not answer this one either
    CHECK(second.has("control_gained", has_control));
    r.controller().wait_for("slave_lost", {{"station", 2}, {"loss", "no_answer"}});
    r.arm().signal(SIGCONT);
    r.controller().wait_for("state_changed", {{"address", "2.2.33.1"}, {"from", "initialize"}, {"to", "ready"}}, 2);
    r.ocu(0, {"propulsive_linear_effort_x=-20"}, "c");
}

TEST_CASE("a unit stops an arm under control of another, and clears only its own emergency") {
    robot r;
    r.add_second_unit();
    r.start();
    auto& first = r.hold({"propulsive_linear_effort_x=50"});
    // Two units cannot be the same system at a time.
    const auto error = r.ocu(1, {"--query"}).wait_for("failed");
    CHECK(error["text"].get<std::string>().find(std::to_string(r.ocu_port)) != std::string::npos);
    // As long as it is there, the emergency is its.
    auto& second = r.hold({"--send", "set_emergency", "emergency_code=transition_to_emergency"}, "c");
    r.arm().wait_for("efforts_zeroed", {{"cause", "emergency"}});
    CHECK(r.controller().has("controller_taken", {{"address", "2.2.33.1"}, {"controller", "1.1.32.1"}}));
    releases(first, SIGINT);
    CHECK(r.ocu(1, {"propulsive_linear_effort_x=1"}).has("robot_state", {{"state", "emergency"}}));
    const words clear{"--send", "clear_emergency", "emergency_code=clear_emergency"};
    CHECK(r.ocu(1, clear).has("message_refused", {{"code", 0x0007}}));
    REQUIRE(second.end(SIGINT) == 0);
    r.ocu(0, clear, "c");
    CHECK(r.ocu(1, {"propulsive_linear_effort_x=1"}).has("robot_state", {{"state", "standby"}}));
    r.ocu(0, {"--send", "resume"});
    r.ocu(0, {"propulsive_linear_effort_x=1"});
}

TEST_CASE("a unit releases control on Ctrl-C and SIGTERM") {
    robot r;
    r.start();
    for (const int signal : {SIGINT, SIGTERM}) {
        releases(r.hold({"propulsive_linear_effort_x=50"}), signal);
        r.nobody_controls();
    }
    // Before anything is done it is a failure.
    r.controller().signal(SIGSTOP);
    auto& unit = r.unit({"--timeout", "20000", "propulsive_linear_effort_x=1"});
    unit.wait_for("message_sent", {{"code", 0x000D}});
    unit.signal(SIGINT);
    r.controller().signal(SIGCONT);
    CHECK(unit.wait() == 1);
    r.nobody_controls();
}

TEST_CASE("the demonstration runs, also while another one does") {
    const std::string root = support::source_file("");
    robot r;
    // Another one may run in another terminal: the ports of the example configuration are taken.
    const words example{"--config", root + "/examples/JausConfig.xml", "--this", "b"};
    auto& other_arm = r.start_program("robot_arm", example);
    auto& other_controller = r.start_program("robot_controller", example);
    const auto is_up = [](const program& one) { return one.has("ready") || one.has("failed"); };
    REQUIRE(eventually([&] { return is_up(other_arm) && is_up(other_controller); }));
    const auto start_demo = [&](const words& options) -> program& {
        words command{root + "/scripts/demo", "--bin", bin().string()};
        command.insert(command.end(), options.begin(), options.end());
        return r.start_command(command);
    };
    for (const auto* table : {"seed", "self-contained"}) {
        auto& demo = start_demo({"--table", table});
        REQUIRE(demo.wait() == 0);
        CHECK(demo.has_output("demo: OK: 20 steps as expected"));
        CHECK(std::ranges::count(demo.output(), '\n') <= 40);
        CHECK_FALSE(demo.has_output("\033")); // no terminal, no colours
    }
    auto& verbose = start_demo({"--verbose"});
    REQUIRE(verbose.wait() == 0);
    CHECK(verbose.has_output("Set Wrench Effort"));
    CHECK(verbose.has_output("efforts in force"));
    auto& interrupted = start_demo({"--verbose"});
    interrupted.wait_for_output("unit a takes control");
    CHECK(interrupted.end(SIGINT) == 130);
    CHECK(r.start_command({root + "/scripts/demo", "--nonsense"}).wait() == 2);
}
