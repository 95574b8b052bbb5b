// The robot controller: several masters, and what it does to a slave when a component is not to move it.
#include "nodes/namespaces.hpp"
#include "nodes/robot.hpp"

using namespace nodes;

namespace {

// The systems b (2.2.0.0), g (2.3.0.0) and h (2.2.34.0), whose masters are on the links given; b drives all.
void several_masters_on(robot& r, const std::string& link_b, const std::string& link_g, const std::string& link_h) {
    write_file(r.config, "<jausconfig thissystem=\"a\">\n"
                         "  <system name=\"a\" jausip=\"1.0.0.0\" ip=\"127.0.0.1\" port=\"" +
                             std::to_string(r.ocu_port) +
                             "\"/>\n"
                             "  <system name=\"b\" jausip=\"2.2.0.0\" ip=\"127.0.0.1\" port=\"" +
                             std::to_string(r.controller_port) + "\"><ethercat interface=\"" + link_b +
                             "\"/></system>\n"
                             "  <system name=\"g\" jausip=\"2.3.0.0\" ip=\"127.0.0.1\" port=\"" +
                             std::to_string(free_port()) + "\"><ethercat controller=\"b\" interface=\"" + link_g +
                             "\"/></system>\n"
                             "  <system name=\"h\" jausip=\"2.2.34.0\" ip=\"127.0.0.1\" port=\"" +
                             std::to_string(free_port()) + "\"><ethercat controller=\"b\" interface=\"" + link_h +
                             "\"/></system>\n</jausconfig>\n");
}
program& start_several_masters(robot& r) {
    auto& controller = r.start_node("robot_controller", r.master_options);
    for (const auto* system : {"b", "g", "h"}) controller.wait_for("ready", {{"system", system}});
    robot::is_ready(controller);
    return controller;
}
std::string in_udp(std::uint16_t port) { return "udp:127.0.0.1:" + std::to_string(port); }

void each_command_reaches_its_slave(robot& r, program& controller, program& second_arm, program& bus) {
    for (const std::string component : {"2.3.33.1", "2.2.34.1"}) robot::is_ready(controller, component);
    r.ocu(0, {"--to", "2.2.33.1", "propulsive_linear_effort_x=50"});
    r.arm().wait_for("efforts_in_force", {{"propulsive_linear_effort_x", 16384}});
    r.ocu(0, {"--to", "2.3.33.1", "propulsive_linear_effort_y=-100"});
    second_arm.wait_for("efforts_in_force", {{"propulsive_linear_effort_y", -32767}});
    CHECK(!second_arm.has("efforts_in_force", {{"propulsive_linear_effort_x", 16384}}));
    CHECK(!r.arm().has("efforts_in_force", {{"propulsive_linear_effort_y", -32767}}));
    // All fields, as long as the object of the emulated slave.
    r.ocu(0, words{"--to", "2.2.34.1", "--send", "set_wrench_effort"} + full_command);
    bus.wait_for("object_written", [](const json& event) {
        return event["index"] == 0x1B16 && event["subindex"] == 26 &&
               event["data"].get<std::string>().starts_with("16 02");
    });
    CHECK(r.arm().count("message_received", {{"code", set_wrench_effort}, {"source", "1.1.32.1"}}) == 1);
    controller.wait_for("message_received", {{"system", "h"}, {"code", set_wrench_effort}});
    controller.wait_for("packet_translated", {{"system", "g"}});
    controller.wait_for("sdo_sent", {{"system", "g"}, {"station", 3}, {"kind", "request"}});
}

const json ready_again{{"address", "2.2.33.1"}, {"from", "initialize"}, {"to", "ready"}};

void ends_while_its_slave_is_silent(const words& options) {
    robot r;
    r.arm_options = {"--command-timeout", "0"};
    r.master_options = r.master_options + options;
    r.start();
    r.ocu(0, {"propulsive_linear_effort_x=50"});
    r.arm().signal(SIGSTOP);
    // Messages are answered meanwhile.
    r.ocu(0, {"--send", "query_component_status"});
    r.controller().signal(SIGINT);
    // A second, but for a busy machine.
    const bool ends = r.controller().ends_within(is_slow() ? std::chrono::seconds{60} : std::chrono::seconds{10});
    r.arm().signal(SIGCONT);
    REQUIRE(ends);
    CHECK(r.controller().wait() == 1); // nobody knows what the arm does
    CHECK(r.controller().has("not_at_rest", {{"station", 2}}));
}

} // namespace

TEST_CASE("one controller drives several masters, each with its slave") {
    const auto second = free_port(), third = free_port();
    robot r;
    several_masters_on(r, in_udp(r.slave_port), in_udp(second), in_udp(third));
    r.start_arm();
    auto& second_arm =
        r.start_node("robot_arm", {"--command-timeout", "20000", "--ethercat-port", std::to_string(second)});
    second_arm.wait_for("ready");
    auto& bus = r.start_bus({"--ethercat-port", std::to_string(third), "--object", "0x1B16:26=28"});
    auto& controller = start_several_masters(r);
    each_command_reaches_its_slave(r, controller, second_arm, bus);
    // A slave that is gone holds nobody up.
    REQUIRE(r.arm().end(SIGTERM) == 0);
    controller.wait_for("slave_lost", {{"system", "b"}, {"station", 2}, {"loss", "no_answer"}});
    r.ocu(0, {"--to", "2.3.33.1", "propulsive_linear_effort_y=100"});
    second_arm.wait_for("efforts_in_force", {{"propulsive_linear_effort_y", 32767}});
    CHECK(r.ocu(1, {"--to", "2.2.33.1", "propulsive_linear_effort_x=20"}).has("message_refused"));
    r.start_arm();
    controller.wait_for("state_changed", ready_again, 2);
    r.ocu(0, {"--to", "2.2.33.1", "propulsive_linear_effort_x=30"});
    REQUIRE(controller.end(SIGINT) == 0);
    for (const auto* system : {"b", "g", "h"}) CHECK(controller.has("stopped", {{"system", system}}));
    const auto error = r.run(2, "robot_controller",
                             {"--config", r.config, "--this", "b", "--ethercat-port", std::to_string(r.slave_port)})
                           .wait_for("usage_error");
    CHECK(error["text"].get<std::string>().find("--ethercat-port is not for b") != std::string::npos);
    r.run(2, "robot_controller", {"--config", r.config, "--this", "b", "--station", "4"});
}

TEST_CASE("a master may start without its slave") {
    robot r;
    several_masters_on(r, in_udp(r.slave_port), in_udp(free_port()), in_udp(free_port()));
    r.start_arm();
    r.master_options = r.master_options + words{"--wait", is_slow() ? "5000" : "1000"};
    auto& controller = start_several_masters(r);
    CHECK(controller.has("ready", {{"system", "g"}, {"slave_up", false}}));
    r.ocu(0, {"--to", "2.2.33.1", "propulsive_linear_effort_x=50"});
    r.ocu(1, {"--to", "2.3.33.1", "propulsive_linear_effort_x=50"});
}

TEST_CASE("one controller drives masters on several interfaces, and keeps no privilege") {
    two_namespaces wire;
    if (!wire.exist()) return;
    const auto second = wire.add_cable("if_g"), third = wire.add_cable("if_h");
    robot r;
    several_masters_on(r, "if_m", "if_g", "if_h");
    r.link = {"--link", "raw", "--interface", "if_s"};
    r.prefix = wire.in_slave();
    r.start_arm();
    r.prefix = two_namespaces::in(second);
    auto& second_arm = r.start_node("robot_arm", r.link + words{"--command-timeout", "20000"});
    second_arm.wait_for("ready");
    r.prefix = two_namespaces::in(third);
    auto& bus = r.start_bus(r.link + words{"--object", "0x1B16:26=28"});
    r.prefix = wire.in_master();
    auto& controller = start_several_masters(r);
    CHECK(controller.has("link_opened", {{"system", "g"}, {"link", "raw Ethernet on if_g"}}));
    each_command_reaches_its_slave(r, controller, second_arm, bus);
    // No thread of the program has kept the privilege that the sockets took.
    const auto tasks = std::filesystem::path{"/proc"} / std::to_string(controller.pid()) / "task";
    for (const auto& task : std::filesystem::directory_iterator{tasks}) {
        const auto status = content((task.path() / "status").string());
        CHECK(status.find("CapEff:\t0000000000000000") != std::string::npos);
    }
    // A cable is cut: the others work on.
    wire.set_slave_link(false);
    controller.wait_for("slave_lost", {{"system", "b"}, {"station", 2}, {"loss", "no_answer"}});
    r.ocu(0, {"--to", "2.3.33.1", "propulsive_linear_effort_y=100"});
    second_arm.wait_for("efforts_in_force", {{"propulsive_linear_effort_y", 32767}});
    wire.set_slave_link(true);
    controller.wait_for("state_changed", ready_again, 2);
    r.ocu(0, {"--to", "2.2.33.1", "propulsive_linear_effort_x=30"});
}

TEST_CASE("every state but Ready brings the arm to rest") {
    robot r;
    r.start();
    const auto is_owed = [&](const std::string& cause, const std::string& state, std::size_t times = 1) {
        r.controller().wait_for(
            "stop_owed", {{"address", "2.2.33.1"}, {"cause", cause}, {"state", state}, {"slave_up", true}}, times);
    };
    r.ocu(0, {"propulsive_linear_effort_x=50"});
    r.ocu(0, {"--send", "standby"});
    is_owed("state", "standby");
    r.at_rest(2); // the first time when the slave came up
    CHECK(r.ocu(1, {"propulsive_linear_effort_x=20"}).has("message_refused"));
    r.ocu(0, {"--send", "resume"});
    r.ocu(0, {"propulsive_linear_effort_x=30"});
    // Reset: at rest, and ready again, since there is a slave.
    r.ocu(0, {"--send", "reset"});
    r.controller().wait_for("state_changed", ready_again, 2);
    r.at_rest(3);
    r.ocu(0, {"propulsive_linear_effort_x=40"});
    // Who stops the machine lets it go on, and then it waits for a Resume. The arm hears of both.
    r.ocu(0, {"--send", "set_emergency", "emergency_code=transition_to_emergency"});
    is_owed("state", "emergency");
    r.arm().wait_for("efforts_zeroed", {{"cause", "emergency"}});
    r.ocu(1, {"propulsive_linear_effort_x=20"});
    r.ocu(0, {"--send", "clear_emergency", "emergency_code=clear_emergency"});
    r.arm().wait_for("emergency_cleared");
    r.ocu(1, {"propulsive_linear_effort_x=20"});
    r.ocu(0, {"--send", "resume"});
    r.command_arrives();
    r.ocu(0, {"--send", "shutdown"});
    is_owed("state", "shutdown");
    r.ocu(1, {"propulsive_linear_effort_x=20"});
}

TEST_CASE("the loss of the controlling unit brings the arm to rest, a release does not") {
    robot r;
    r.start();
    auto& unit = r.hold({"propulsive_linear_effort_x=50"});
    r.controller().wait_for("controller_taken",
                            {{"address", "2.2.33.1"}, {"controller", "1.1.32.1"}, {"authority", 128}});
    r.controller().wait_for("peer_heard", {{"address", "1.1.1.1"}});
    r.arm().wait_for("efforts_in_force", {{"propulsive_linear_effort_x", 16384}});
    unit.kill();
    r.controller().wait_for("peer_lost", {{"address", "1.1.1.1"}});
    r.controller().wait_for("controller_gone", {{"address", "2.2.33.1"}});
    r.controller().wait_for("stop_owed", {{"address", "2.2.33.1"}, {"cause", "controller_lost"}});
    r.at_rest(2);
    r.ocu(0, {"propulsive_linear_effort_x=50"});
    r.controller().wait_for("controller_gone", {{"address", "2.2.33.1"}}, 2);
    const auto report = r.ocu(0, {"--query"}).wait_for("message_received", {{"code", report_wrench_effort}});
    CHECK(*efforts_in(report).propulsive_linear_effort_x == Approx(50.001526).epsilon(1e-6));
}

TEST_CASE("an emergency for an absent slave is not acknowledged, and is sent when the slave returns") {
    two_namespaces wire;
    if (!wire.exist()) return;
    robot r;
    wire.start_robot(r);
    r.ocu(0, {"propulsive_linear_effort_x=50"});
    wire.set_slave_link(false);
    r.controller().wait_for("slave_lost", {{"station", 2}, {"loss", "no_answer"}});
    // Nobody can say that the arm has stopped: no acknowledgement.
    auto& unit = r.ocu(1, {"--send", "set_emergency", "emergency_code=transition_to_emergency"});
    CHECK(unit.has("no_answer", {{"code", 0x0006}}));
    r.controller().wait_for("stop_owed", {{"address", "2.2.33.1"}, {"state", "emergency"}, {"slave_up", false}});
    wire.set_slave_link(true);
    r.arm().wait_for("efforts_zeroed", {{"cause", "emergency"}});
    r.controller().wait_for("stop_owed", {{"address", "2.2.33.1"}, {"cause", "slave_returned"}, {"slave_up", true}});
    r.controller().wait_for("stop_confirmed", {{"address", "2.2.33.1"}}, 2);
}

TEST_CASE("the state of a component reaches a slave with process data") {
    robot r;
    r.master_options = r.master_options + robot::cyclic();
    r.start();
    r.ocu(0, {"propulsive_linear_effort_x=50"});
    const auto moved = r.arm().wait_for("efforts_in_force", {{"propulsive_linear_effort_x", 16384}});
    r.ocu(0, {"--send", "standby"});
    const auto stopped = r.controller().wait_for("image_written", [&](const json& event) {
        return event["time"] > moved["time"] &&
               event["outputs"].get<std::string>().substr(6).starts_with("ff 0f 00 00 00 00 00 00");
    });
    r.arm().wait_for("efforts_commanded", {{"command", stopped["command"]}});
    r.ocu(0, {"--send", "resume"});
    r.command_arrives();
}

TEST_CASE("a controller has the components of its configuration") {
    robot r;
    auto text = content(r.config);
    const std::string id = "<jausip>2.0.0.0</jausip>";
    text.insert(text.find(id) + id.size(),
                "<node id=\"2\"><component id=\"33\" authority=\"7\"/><component id=\"49\"/></node>");
    write_file(r.config, text);
    r.start();
    r.command_arrives();
    // The arm has no objects of component 49: nobody knows what that does, so it is never ready.
    r.controller().wait_for("stop_refused",
                            {{"address", "2.2.49.1"}, {"order", "rest"}, {"attempt", 1}, {"abort_code", 0x06020000}});
    CHECK(r.ocu(1, {"--to", "2.2.49.1", "propulsive_linear_effort_x=1"}).has("message_refused"));
    auto& unit = r.ocu(0, {"--send", "query_component_authority"});
    CHECK(unit.wait_for("message_received", {{"code", 0x4001}})["body"] == "07");
}

TEST_CASE("a component behind its own master is notified of losses by the node manager behind another") {
    const auto third = free_port();
    robot r;
    several_masters_on(r, in_udp(r.slave_port), in_udp(free_port()), in_udp(third));
    r.start_arm();
    auto& bus = r.start_bus({"--ethercat-port", std::to_string(third), "--object", "0x1B16:26=28"});
    r.master_options = r.master_options + words{"--wait", is_slow() ? "5000" : "1000"};
    auto& controller = start_several_masters(r);
    robot::is_ready(controller, "2.2.34.1");
    auto& unit = r.hold(words{"--to", "2.2.34.1", "--send", "set_wrench_effort"} + full_command);
    controller.wait_for("controller_taken", {{"system", "h"}, {"address", "2.2.34.1"}, {"controller", "1.1.32.1"}});
    const json written{{"index", 0x1B16}, {"subindex", 26}};
    bus.wait_for("object_written", written);
    controller.wait_for("peer_heard", {{"system", "b"}, {"address", "1.1.1.1"}});
    const auto before = bus.count("object_written", written);
    unit.kill();
    controller.wait_for("stop_owed", {{"system", "h"}, {"address", "2.2.34.1"}, {"cause", "controller_lost"}});
    bus.wait_for("object_written", written, before + 1);
}

// Efforts must not outlive the program that commanded them.
TEST_CASE("the end of the controller by Ctrl-C or SIGTERM brings the arm to rest") {
    for (const int signal : {SIGINT, SIGTERM}) {
        robot r;
        r.arm_options = {"--command-timeout", "0"}; // the controller does it
        r.start();
        r.ocu(0, {"propulsive_linear_effort_x=50"});
        REQUIRE(r.controller().end(signal) == 0);
        CHECK(r.controller().has("stop_owed", {{"address", "2.2.33.1"}, {"cause", "program_ends"}}));
        r.at_rest(2); // when the slave came up, and now
        REQUIRE(r.arm().end(SIGTERM) == 0);
    }
}

TEST_CASE("a controller with a silent slave ends, and reports that rest is not confirmed") {
    ends_while_its_slave_is_silent({});
}

TEST_CASE("a cyclic controller with a silent slave ends, and reports that rest is not confirmed") {
    ends_while_its_slave_is_silent(robot::cyclic());
}

TEST_CASE("an arm stops by its own timeouts when its controller is killed") {
    robot r;
    r.arm_options = {"--command-timeout", is_slow() ? "5000" : "1000"};
    r.start();
    r.ocu(0, {"propulsive_linear_effort_x=50"});
    r.controller().kill();
    r.arm().wait_for("efforts_zeroed", {{"cause", "command_timeout"}});
    r.master_options = r.master_options + robot::cyclic();
    robot::is_ready(r.start_controller());
    r.ocu(0, {"propulsive_linear_effort_x=50"});
    r.controller().kill();
    r.arm().wait_for("efforts_zeroed", {{"cause", "no_process_data"}});
}
