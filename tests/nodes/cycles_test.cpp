// Process data between controller and arm, the program cyclic, and the bus of emulated slaves.
#include "nodes/robot.hpp"

using namespace nodes;

namespace {

// A robot whose slave runs in OP.
struct cyclic_robot : robot {
    cyclic_robot() { master_options = master_options + cyclic(); }
};

// Options of the program cyclic for the slave of a robot.
words cyclic_options(const robot& r, const words& more) {
    return words{"--ethercat-port", std::to_string(r.slave_port), "--period", robot::period(),
                 "--frame-timeout", is_slow() ? "1000" : "500"} +
           more;
}

// Outputs that begin with these bytes behind the number of their command.
program::predicate outputs_after_number(const std::string& bytes) {
    return [=](const json& event) { return event["outputs"].get<std::string>().substr(6).starts_with(bytes); };
}

} // namespace

TEST_CASE("commands and reports pass by process data", "[valgrind]") {
    cyclic_robot r;
    r.master_options.emplace_back("--open");
    r.start();
    CHECK(r.controller().has("ready", {{"cyclic", true}, {"slave_up", true}}));
    r.arm().wait_for("slave_state", {{"state", "op"}, {"station", 2}});
    r.command_arrives();
    // Commands that bring the arm to rest come before it: one for each time that the slave is back.
    const auto written = r.controller().wait_for(
        "image_written", outputs_after_number("ff 0f 00 40 00 40 00 40 01 c0 01 c0 01 c0 80 80 80 ff ff ff"));
    const auto number = written["outputs"].get<std::string>().substr(0, 6);
    r.controller().wait_for("image_read", [&](const json& event) {
        return event["inputs"].get<std::string>().starts_with(number + "ff 0f 00 40");
    });
    r.controller().wait_for("message_sent", {{"code", set_wrench_effort}, {"acknowledgement", "ack"}});
    r.arm().wait_for("efforts_commanded", {{"command", written["command"]}});
    CHECK(!r.controller().has("packet_translated")); // nothing has gone by the mailbox yet
    CHECK(!r.arm().has("message_received", {{"code", set_wrench_effort}}));
    // Fields that a command leaves out keep their effort; a query gets what it asks for.
    r.ocu(0, {"propulsive_linear_effort_y=-100"});
    r.controller().wait_for("image_written", outputs_after_number("02 00 00 40 01 80"));
    const auto report = r.ocu(0, {"--query"}).wait_for("message_received", {{"code", report_wrench_effort}});
    CHECK(*efforts_in(report).propulsive_linear_effort_x == Approx(50.001526).epsilon(1e-6));
    CHECK(*efforts_in(report).propulsive_linear_effort_y == Approx(-100));
    for (const auto* seed : {"1", "2", "3", "4", "5"})
        CHECK(r.ocu(0, {"--random", seed}).has("report_compared", {{"equal", true}}));
    // -32768 stands for no effort.
    send_bytes(r.controller_port, "1602050401210202012001010400090001000080");
    r.controller().wait_for("not_delivered", {{"address", "2.2.33.1"}, {"code", set_wrench_effort}});
    r.controller().wait_for("message_sent", {{"code", set_wrench_effort}, {"acknowledgement", "nak"}});
}

TEST_CASE("other messages are sent by mailbox between cycles") {
    cyclic_robot r;
    r.start();
    r.ocu(0, {"--send", "set_travel_speed", "desired_speed=2.5"});
    const auto set = r.arm().wait_for("travel_speed_set");
    CHECK(set["speed"].get<double>() == Approx(2.4414435).epsilon(1e-6));
    r.controller().wait_for("packet_translated");
    r.ocu(0, {"--send", "query_travel_speed"});
    r.command_arrives();
    r.controller().wait_for("image_written");
    // An emergency comes by the mailbox, and process data do not bring the efforts back.
    r.ocu(0, {"--send", "set_emergency", "emergency_code=transition_to_emergency"});
    r.arm().wait_for("efforts_zeroed", {{"cause", "emergency"}});
    REQUIRE(eventually([&] { // a report is as old as the last cycle
        const auto report = r.ocu(0, {"--query"}).wait_for("message_received", {{"code", report_wrench_effort}});
        return *efforts_in(report).propulsive_linear_effort_x == 0;
    }));
    r.ocu(1, {"propulsive_linear_effort_x=1"});
    CHECK(!r.arm().has("efforts_in_force", {{"propulsive_linear_effort_x", 328}}));
}

TEST_CASE("an arm that is restarted between cycles executes new commands only") {
    cyclic_robot r;
    r.start();
    r.command_arrives();
    REQUIRE(r.arm().end(SIGTERM) == 0);
    r.controller().wait_for("slave_lost", {{"station", 2}});
    CHECK(r.ocu(1, {"--timeout", "5000", "propulsive_linear_effort_x=1"}).has("message_refused"));
    r.start_arm();
    r.arm().wait_for("slave_state", {{"state", "op"}, {"station", 2}});
    r.controller().wait_for("state_changed", {{"address", "2.2.33.1"}, {"from", "initialize"}, {"to", "ready"}}, 2);
    // What stood in the outputs is no new command.
    CHECK(!r.arm().has("efforts_in_force", {{"propulsive_linear_effort_x", 16384}}));
    r.command_arrives();
}

TEST_CASE("a controller that is restarted between cycles finds the arm at rest") {
    cyclic_robot r;
    r.start();
    r.command_arrives();
    REQUIRE(r.controller().end(SIGTERM) == 0);
    r.arm().wait_for("efforts_zeroed", {{"cause", "no_process_data"}});
    robot::is_ready(r.start_controller());
    const auto report = r.ocu(0, {"--query"}).wait_for("message_received", {{"code", report_wrench_effort}});
    CHECK(*efforts_in(report).propulsive_linear_effort_x == 0);
    r.command_arrives();
}

TEST_CASE("a slave leaves OP by its watchdog when the controller is stopped, and returns") {
    cyclic_robot r;
    r.start();
    r.command_arrives();
    r.controller().signal(SIGSTOP);
    r.arm().wait_for("efforts_zeroed", {{"cause", "no_process_data"}});
    r.controller().signal(SIGCONT);
    r.controller().wait_for("state_changed", {{"address", "2.2.33.1"}, {"from", "ready"}, {"to", "failure"}});
    r.controller().wait_for("state_changed", {{"address", "2.2.33.1"}, {"from", "initialize"}, {"to", "ready"}}, 2);
    r.command_arrives();
}

TEST_CASE("an arm stops without messages, unless it has no command timeout") {
    robot r;
    // Longer than a slow machine holds the controller up, who has to be killed.
    r.arm_options = {"--command-timeout", is_slow() ? "5000" : "1000"};
    r.start();
    r.command_arrives();
    r.controller().kill();
    r.arm().wait_for("efforts_zeroed", {{"cause", "command_timeout"}});
    auto& other = r.start_node("robot_arm", {"--command-timeout", "0", "--ethercat-port", std::to_string(free_port())});
    other.wait_for("ready");
    CHECK(other.has("no_command_timeout"));
}

TEST_CASE("cyclic measures its cycles while it uploads objects") {
    robot r;
    r.start_arm();
    auto& one =
        r.run(0, "cyclic", cyclic_options(r, {"--watchdog", "2000", "--seconds", "2", "--upload-every", "100"}));
    CHECK(one.has("slave_configured", {{"station", 1}, {"outputs", 22}, {"inputs", 22}}));
    const auto measured = one.wait_for("measured", {{"incomplete", 0}, {"failed_uploads", 0}});
    CHECK(measured["uploads"] >= 5);
    CHECK(measured["uploads"] <= 21);
    CHECK(measured["late_max_us"] > 0);
    CHECK(measured["round_trip_max_us"] > 0);
    CHECK(r.arm().has("slave_state", {{"state", "op"}, {"station", 1}}));
    r.arm().wait_for("slave_state", [](const json& event) { return event["state"] == "pre_op"; }, 2);
    CHECK(r.run(2, "cyclic", {"--period", "0"}).has("usage_error"));
    const auto error = r.run(2, "cyclic", {"--watchdog", "6554"}).wait_for("usage_error");
    CHECK(error["text"].get<std::string>().find("--watchdog must be 1 to 6553") != std::string::npos);
}

TEST_CASE("cyclic follows the reference clock of a bus, however busy the machine is") {
    robot r;
    r.start_bus(r.link + words{"--slaves", "3", "--outputs", "2", "--inputs", "2", "--clock", "64", "--drift", "100"});
    auto& one = r.start_program("cyclic", words{"--ethercat-port", std::to_string(r.slave_port), "--period",
                                                is_slow() ? "20000" : "2000", "--clocks", "--clock-limit", "6000",
                                                "--frame-timeout", "1000", "--watchdog", "5000", "--seconds", "600"});
    CHECK(one.wait_for("clock_set_up", {{"station", 3}})["delay_ns"] > 0);
    const auto locked = one.wait_for("clocks_locked");
    CHECK(locked["drift_ppb"] > 0); // the first clock is slow by 100 ppm
    one.wait_for("ready", {{"slaves", 3}});
    one.signal(SIGINT);
    CHECK(one.wait_for("measured").contains("clock_error_median_us"));
}

TEST_CASE("the clocks of a long bus have the delays of its cables") {
    constexpr std::int64_t cable = 2000, through = 300, resolution = 10; // ns; `through` each slave
    robot r;
    r.start_bus(r.link + words{"--slaves", "40", "--outputs", "2", "--clock", "64", "--cable", std::to_string(cable)});
    auto& one = r.start_program("cyclic", words{"--ethercat-port", std::to_string(r.slave_port), "--period", "20000",
                                                "--clocks", "--clock-limit", "6000", "--frame-timeout", "1000",
                                                "--watchdog", "5000", "--seconds", "600"});
    for (const int station : {1, 2, 20, 40}) {
        const auto delay = one.wait_for("clock_set_up", {{"station", station}})["delay_ns"].get<std::int64_t>();
        CAPTURE(station, delay);
        CHECK(std::abs(delay - (station - 1) * (cable + through)) <= 2 * resolution);
    }
    one.wait_for("ready", {{"slaves", 40}});
    one.signal(SIGINT);
    one.wait_for("measured");
}

TEST_CASE("cyclic waits for clocks up to a limit, and says how far they are") {
    robot r;
    r.start_bus(r.link + words{"--slaves", "2", "--outputs", "2", "--clock", "64"});
    auto& one = r.run(1, "cyclic",
                      {"--ethercat-port", std::to_string(r.slave_port), "--clocks", "--clock-limit", "0",
                       "--frame-timeout", "1000", "--watchdog", "5000"});
    const auto text = one.wait_for("failed")["text"].get<std::string>();
    CHECK(text.find("--clock-limit") != std::string::npos);
    CHECK(text.find("off their phase") != std::string::npos);
}

TEST_CASE("cyclic reports when slaves leave OP because another master resets them") {
    robot r;
    r.start_bus(r.link + words{"--slaves", "2", "--outputs", "2", "--inputs", "2"});
    auto& first = r.start_program("cyclic", cyclic_options(r, {"--watchdog", "2000", "--seconds", "600"}));
    first.wait_for("ready", {{"slaves", 2}});
    // The second one gives the slaves other station addresses.
    r.run(0, "cyclic", cyclic_options(r, {"--watchdog", "2000", "--seconds", "1", "--station", "11"}));
    first.wait_for("slave_stopped", {{"station", 1}});
    first.wait_for("slave_stopped", {{"station", 2}, {"condition", "absent"}});
    CHECK(first.end(SIGINT) == 1); // no slave is in OP
}

TEST_CASE("cyclic ends on Ctrl-C, also without an answer from any slave") {
    robot r;
    auto& bus = r.start_bus(r.link + words{"--slaves", "5", "--outputs", "2", "--inputs", "2"});
    auto& one = r.start_program("cyclic", cyclic_options(r, {"--watchdog", "2000", "--seconds", "600"}));
    one.wait_for("ready", {{"slaves", 5}});
    bus.signal(SIGSTOP);
    one.wait_for("slave_stopped", {{"station", 5}});
    one.signal(SIGINT);
    const bool ends = one.ends_within(is_slow() ? std::chrono::seconds{60} : std::chrono::seconds{10});
    bus.signal(SIGCONT); // before anything fails: a stopped program does not end
    REQUIRE(ends);
}

TEST_CASE("a bus of emulated slaves survives the end of its master, and refuses wrong arguments") {
    robot r;
    auto& bus = r.start_bus(
        r.link + words{"--slaves", "5", "--outputs", "10", "--inputs", "7", "--mailbox-size", "40", "--slow", "3"});
    CHECK(bus.has("ready", {{"slaves", 5}}));
    // A master that dies: the watchdog of each slave that had its outputs.
    auto& master = r.start_program("cyclic", cyclic_options(r, {"--seconds", "600"}));
    bus.wait_for("slave_state", {{"slave", 4}, {"state", "op"}});
    master.kill();
    bus.wait_for("slave_state", {{"slave", 4}, {"state", "safe_op"}, {"error", true}, {"code", 0x001B}});
    // The next one brings them up again.
    auto& next =
        r.run(0, "cyclic", cyclic_options(r, {"--watchdog", "2000", "--seconds", "2", "--upload-every", "100"}));
    CHECK(next.has("slave_configured", {{"station", 5}, {"outputs", 10}, {"inputs", 7}}));
    CHECK(next.has("measured", {{"incomplete", 0}, {"failed_uploads", 0}}));
    CHECK(bus.has("station_address", {{"slave", 4}, {"station", 5}}));
    bus.wait_for("slave_state", {{"slave", 4}, {"state", "pre_op"}});
    REQUIRE(bus.end(SIGINT) == 0);
    CHECK(bus.has("stopped"));
    for (const words& wrong :
         {words{"--slaves", "0"}, words{"--outputs", "683"}, words{"--inputs", "1025"}, words{"--mailbox-size", "23"},
          words{"--abort", "0x2000"}, words{"--abort", "0x2000:256=1"}, words{"--object", "x=1"}}) {
        const auto error = r.run(2, "emulated_bus", wrong).wait_for("usage_error");
        CHECK(error["text"].get<std::string>().find(wrong[0]) != std::string::npos);
    }
    CHECK(r.run(0, "emulated_bus", {"--help"}).has_output("Examples:"));
}

TEST_CASE("emulated slaves send emergencies at the request of a line") {
    robot r;
    auto& bus = r.start_program("emulated_bus",
                                r.link + words{"--slaves", "2", "--outputs", "2", "--inputs", "2", "--commands"},
                                "emergency 1 0x8110 0x11 0102\nemergency 0 256\nemergency 2 1\nemergency 0\n"
                                "emergency 0 1 2 010203040506\n\nhello\n");
    bus.wait_for("ready");
    bus.wait_for("line_refused", json::object(), 4);
    CHECK(bus.count("line_refused") == 4);
    CHECK(bus.has("line_refused", {{"line", "hello"}}));
    auto& master = r.run(0, "cyclic", cyclic_options(r, {"--seconds", "1", "--upload-every", "10"}));
    CHECK(master.has("measured", {{"failed_uploads", 0}}));
    CHECK(
        master.has("slave_emergency", {{"error_code", 0x8110}, {"error_register", 0x11}, {"data", "01 02 00 00 00"}}));
    CHECK(master.has("slave_emergency", {{"error_code", 0x100}, {"data", "00 00 00 00 00"}}));
    bus.wait_for("emergency_sent", {{"slave", 1}, {"error_code", 0x8110}, {"error_register", 0x11}});
    bus.wait_for("emergency_sent", {{"slave", 0}, {"error_code", 0x100}, {"data", "00 00 00 00 00"}});
}

TEST_CASE("a controller reports the JAUS node that its slave must have") { // the slave has its own configuration
    robot r;
    r.start_bus(r.link + words{"--abort", "0x1B15=0x06040043"});
    r.start_controller();
    const auto refused = r.controller().wait_for("stop_refused", {{"address", "2.2.33.1"},
                                                                  {"order", "rest"},
                                                                  {"attempt", 1},
                                                                  {"station", 2},
                                                                  {"status", 0xC0650034},
                                                                  {"abort_code", 0x06040043}});
    CHECK(refused["text"].get<std::string>().find("see robot_arm --node") != std::string::npos);
}
