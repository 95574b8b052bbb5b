// Command lines and configurations that are refused, and what the programs do where nothing answers.
#include "nodes/robot.hpp"

using namespace nodes;

namespace {

/// Exit code 2, and the line names what is wrong and what it may be.
void is_refused(robot& r, const std::string& name, const words& arguments, const words& mentions = {}) {
    auto& one = r.run(2, name, arguments);
    const auto text = one.wait_for("usage_error")["text"].get<std::string>();
    CHECK(text.find("Try '" + name + " --help'") != std::string::npos);
    for (const auto& mentioned : mentions) {
        INFO(text << " does not mention " << mentioned);
        CHECK(text.find(mentioned) != std::string::npos);
    }
}
/// Exit code 1, and the line mentions where.
void fails(robot& r, const std::string& name, const words& arguments, const std::string& mentions) {
    auto& one = r.run(1, name, arguments);
    const auto text = one.wait_for("failed")["text"].get<std::string>();
    INFO(text << " does not mention " << mentions);
    CHECK(text.find(mentions) != std::string::npos);
}

} // namespace

TEST_CASE("wrong arguments are refused with their names and ranges") {
    robot r;
    is_refused(r, "ocu", {});
    is_refused(r, "ocu", {"speed=5"}, {"speed"});
    is_refused(r, "ocu", {"propulsive_linear_effort_x=101"}, {"-100", "100"});
    is_refused(r, "ocu", {"propulsive_linear_effort_x="});
    is_refused(r, "ocu", {"--send", "set_travel_sped", "desired_speed=1"}, {"set_travel_speed"});
    is_refused(r, "ocu", {"--send", "set_travel_speed"}, {"desired_speed"});
    is_refused(r, "ocu", {"--send", "set_camera_pose"}, {"mode_indicator"});
    is_refused(r, "ocu", {"--to", "1.2.3", "--query"}, {"1.2.3"});
    is_refused(r, "robot_arm", {"--link", "token-ring", "--config", r.config}, {"--link"});
    is_refused(r, "robot_arm", {"--link", "raw", "--config", r.config}, {"--interface"});
    is_refused(r, "robot_controller", {"--table", "paper", "--config", r.config}, {"--table"});
    is_refused(r, "robot_controller", {"--station", "0", "--config", r.config}, {"--station"});
    for (const std::string name : {"ocu", "robot_controller", "robot_arm"}) {
        is_refused(r, name, {"--nonsense"}, {"--nonsense"});
        CHECK(r.run(0, name, {"--help"}).has_output("Examples:"));
    }
    auto& no_format = r.start_command({(bin() / "ocu").string(), "--query", "--log-format", "xml"});
    REQUIRE(no_format.wait() == 2);
    CHECK(no_format.has_output("--log-format must be text or json"));
}

TEST_CASE("wrong options of the operator control unit are refused") {
    robot r;
    for (const words& wrong :
         {words{"--authority", "256"}, words{"--authority", "-1"}, words{"--authority", "x"}, words{"--hold", "-1"},
          words{"--hold", "nan"}, words{"--wait", "x"}, words{"--timeout", "0"}, words{"--to", "2.255.33.1"},
          words{"--to", "2.0.33.1"}, words{"--random", "1"}})
        is_refused(r, "ocu", words{"--config", r.config, "--query"} + wrong);
    is_refused(r, "ocu", {"--config", r.config, "--send", "nonsense"});
    is_refused(r, "ocu", {"--config", r.config, "--send", "standby", "x=1"});
}

TEST_CASE("wrong times of the controller are refused with their ranges") {
    robot r;
    const words controller{"--config", r.config, "--this", "b"};
    is_refused(r, "robot_controller", controller + words{"--stop-within", "19"}, {"--stop-within", "20", "60000"});
    is_refused(r, "robot_controller", controller + words{"--cycle", "10000", "--stop-within", "6501"},
               {"--stop-within", "20", "6500", "--cycle"});
    is_refused(r, "robot_controller", controller + words{"--cycle", "10000", "--stop-within", "30"},
               {"--stop-within", "4"});
}

TEST_CASE("a missing configuration is reported by name") {
    robot r;
    const words none{"--config", r.folder / "none.xml"};
    fails(r, "robot_controller", none, "none.xml");
    fails(r, "robot_arm", none, "none.xml");
    fails(r, "ocu", none + words{"--query"}, "none.xml");
    fails(r, "ocu", {"--config", r.config, "--this", "c", "--query"}, "\"c\"");
}

TEST_CASE("a malformed configuration is reported with the line") {
    robot r;
    write_file(r.folder / "bad.xml", "<jausconfig>\n<thissystem>a</thissystem>\n<system><name>a</jausconfig>\n");
    fails(r, "ocu", {"--config", r.folder / "bad.xml", "--query"}, "bad.xml:3");
}

TEST_CASE("a port in use is reported, and the program that uses it continues to work") {
    robot r;
    r.start();
    const words arguments = words{"--config", r.config, "--this", "b"} + r.link;
    fails(r, "robot_arm", arguments, std::to_string(r.slave_port));
    fails(r, "robot_controller", arguments, std::to_string(r.controller_port));
    r.command_arrives();
}

TEST_CASE("a controller without a slave ends") {
    robot r;
    auto& one = r.run(1, "robot_controller", words{"--config", r.config, "--this", "b", "--wait", "300"} + r.link);
    CHECK(one.has("failed"));
    CHECK(!one.has("ready"));
}

TEST_CASE("a unit reports that the port of its robot is closed") {
    robot r;
    auto& one = r.ocu(1, {"--timeout", "100", "--query"});
    CHECK(one.has("no_answer", {{"code", query_wrench_effort}, {"heard", false}}));
    CHECK(one.wait_for("node_log")["line"].get<std::string>().find("closed port") != std::string::npos);
}
