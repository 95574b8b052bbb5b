// The live view of the programs: --web.
#include "live/web_client.hpp"
#include "nodes/robot.hpp"

#include <cstdint>

using namespace nodes;
using live_test::web_client;

namespace {

/// Port of the link that a program has logged.
std::uint16_t port_in(const std::string& text) {
    const auto at = text.find("http://127.0.0.1:") + 17;
    return static_cast<std::uint16_t>(std::stoi(text.substr(at)));
}
std::uint16_t web_port(program& of) { return port_in(of.wait_for("web_opened")["link"].get<std::string>()); }

/// The first update from now on whose list has such an element.
json find(web_client& viewer, const char* list, const std::function<bool(const json&)>& is_it) {
    json found;
    viewer.next([&](const json& frame) {
        if (!frame.contains(list)) return false;
        for (const auto& one : frame[list])
            if (is_it(one)) found = one;
        return !found.is_null();
    });
    return found;
}

} // namespace

TEST_CASE("robot_controller and ocu show their messages, components and slaves") {
    robot r;
    r.master_options = r.master_options + robot::cyclic() + words{"--web", "0"};
    r.start();
    const auto port = web_port(r.controller());
    CHECK(web_client{port}.request("/").status == 200);
    web_client viewer{port};
    REQUIRE(viewer.watch().status == 101);
    CHECK(viewer.next()["hello"]["program"] == "robot_controller");
    const auto slave = find(viewer, "buses", [](const json& bus) { return bus["state"] == "op"; });
    CHECK(slave["slaves"][0]["in_service"] == true);
    CHECK(slave["cycles"] > 0);

    auto& unit = r.hold({"--web", "127.0.0.1:0", "propulsive_linear_effort_x=50"});
    const auto driver = find(viewer, "components", [](const json& one) { return one["controller"] == "1.1.32.1"; });
    CHECK(driver["id"] == "2.2.33.1");
    CHECK(driver["state"] == "ready");
    CHECK(driver["authority"] == 128);
    const auto command = find(viewer, "messages", [](const json& one) { // not the acknowledgement
        return one["name"] == "set_wrench_effort" && one["way"] == "received";
    });
    CHECK(command["from"] == "1.1.32.1");
    CHECK(command["fields"]["propulsive_linear_effort_x"].get<double>() == Approx(50).margin(0.01));

    web_client unit_viewer{web_port(unit)};
    REQUIRE(unit_viewer.watch().status == 101);
    find(unit_viewer, "systems", [](const json& one) { return one["subsystem"] == 2 && one["alive"] == true; });
    REQUIRE(unit.end(SIGTERM) == 0);
    // A viewer keeps no program from its end.
    r.stop();
}

TEST_CASE("robot_controller shows the distributed clock that its cycles are to follow") {
    if (!std::filesystem::exists(bin() / "jauscat-esi")) return;
    robot r;
    const auto esi = r.folder / "arm.xml";
    REQUIRE(r.start_command({(bin() / "jauscat-esi").string(), "--output", esi}).wait() == 0);
    auto text = content(esi);
    text.insert(text.find("<Eeprom"),
                "<Dc><OpMode><Name>DC</Name><AssignActivate>#x300</AssignActivate></OpMode></Dc>");
    write_file(esi, text);
    text = content(r.config);
    text.replace(text.find("2.0.0.0"), 7, "2.2.0.0"); // a system with slaves names its node
    text.insert(text.rfind("</system>"), "<ethercat interface=\"udp:127.0.0.1:" + std::to_string(r.slave_port) +
                                             "\"><slave name=\"arm\" position=\"0\"><sync/></slave></ethercat>");
    write_file(r.config, text);
    r.start_bus(r.link + words{"--esi", esi});
    auto& controller = r.start_node("robot_controller", r.master_options + robot::cyclic() + words{"--web", "0"});

    web_client viewer{web_port(controller)};
    REQUIRE(viewer.watch().status == 101);
    // Before OP, which needs cycles that are in time: a busy machine may not have them.
    const auto bus = find(viewer, "buses", [](const json& one) { return one.contains("clock"); });
    CHECK(bus["clock"]["reference"] == bus["slaves"][0]["station"]);
    CHECK(bus["clock"]["offset_ns"].is_number_integer());
    CHECK(bus["clock"]["in_step"].is_boolean());
    CHECK(bus["slaves"][0]["name"] == "arm");
}

TEST_CASE("the controller's faults are in its live view") {
    robot r;
    r.arm_options = {"--command-timeout", "0"};
    r.master_options = r.master_options + words{"--web", "0"};
    r.start();
    web_client viewer{web_port(r.controller())};
    REQUIRE(viewer.watch().status == 101);
    r.arm().kill();
    const auto lost = find(viewer, "faults", [](const json& one) { return one["level"] == "bad"; });
    CHECK(lost["text"].get<std::string>().starts_with("controller: "));
    find(viewer, "components", [](const json& one) { return one["id"] == "2.2.33.1" && one["state"] == "failure"; });
}

TEST_CASE("jausdump shows the messages of a port") {
    if (!std::filesystem::exists(bin() / "jausdump")) return;
    robot r;
    const auto udp = free_port();
    auto& dump = r.start_command(
        {(bin() / "jausdump").string(), "--listen", std::to_string(udp), "--web", "0", "--web-token", "12345678"});
    dump.wait_for_output("?token=12345678");
    dump.wait_for_output("listening on UDP port");
    const auto port = port_in(dump.output());
    CHECK(web_client{port}.request("/").status == 403);
    web_client viewer{port};
    REQUIRE(viewer.watch("/live?token=12345678").status == 101);
    viewer.next();
    send_bytes(udp, "0602050401210202012001010400220001000040");
    const auto row = viewer.row("set_wrench_effort");
    CHECK(row["way"] == "seen");
    CHECK(row["from"] == "1.1.32.1");
    REQUIRE(dump.end(SIGINT) == 0);
}

TEST_CASE("wrong options of the live view are refused") {
    robot r;
    const auto text = [](program& of) { return of.wait_for("usage_error")["text"].get<std::string>(); };
    const words controller{"--config", r.config, "--this", "b"};
    for (const std::string wrong : {"x", "70000", "-1", "127.0.0.1:", ":80", "8080x"})
        CHECK(text(r.run(2, "robot_controller", controller + words{"--web", wrong})).find("--web") !=
              std::string::npos);
    CHECK(text(r.run(2, "robot_controller", controller + words{"--web-token", "12345678"})).find("needs --web") !=
          std::string::npos);
    CHECK(
        text(r.run(2, "robot_controller", controller + words{"--web", "0", "--web-token", "short"})).find("8 to 128") !=
        std::string::npos);
    auto& wrong_address = r.run(1, "robot_controller", controller + words{"--web", "robot:8080"});
    CHECK(wrong_address.wait_for("failed")["text"].get<std::string>().find("no IP address") != std::string::npos);
    r.master_options = r.master_options + words{"--web", "0"};
    r.start();
    const auto taken = std::to_string(web_port(r.controller()));
    auto& second = r.run(1, "ocu", {"--config", r.config, "--query", "--web", taken});
    CHECK(second.wait_for("failed")["text"].get<std::string>().find("ss -ltnp") != std::string::npos);
}
