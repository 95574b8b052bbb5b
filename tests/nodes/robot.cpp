#include "nodes/robot.hpp"

#include "support/free_ports.hpp"
#include "support/hex.hpp"
#include "support/paths.hpp"
#include <jauscat/wire/decode.hpp>

#include <boost/asio/buffer.hpp>

#include <exception>
#include <fstream>
#include <iostream>
#include <thread>

namespace nodes {

std::filesystem::path bin() { return support::program(""); }

void write_file(const std::string& path, const std::string& content) { std::ofstream{path} << content; }
std::uint16_t free_port() { return support::free_ports<1>()[0]; }

namespace {

using udp = boost::asio::ip::udp;

void send_all(udp::socket& socket, std::uint16_t port, const std::string& hex, unsigned times) {
    const auto bytes = jauscat::test::from_hex(hex);
    boost::system::error_code ignored; // such as a closed port
    for (unsigned i = 0; i != times; ++i)
        socket.send_to(boost::asio::buffer(bytes.data(), bytes.size()), {boost::asio::ip::address_v4::loopback(), port},
                       0, ignored);
}

/// What each program has written, for a test that has failed.
void show(const program& one) {
    constexpr std::size_t most = 20'000;
    const auto output = one.output();
    std::cerr << "--- " << one.name() << "\n"
              << (output.size() > most ? "...\n" : "") << output.substr(output.size() - std::min(output.size(), most));
}

} // namespace

void send_bytes(std::uint16_t port, const std::string& hex, unsigned times) {
    boost::asio::io_context context;
    udp::socket socket{context, udp::v4()};
    send_all(socket, port, hex, times);
}
void send_bytes_from(std::uint16_t from, std::uint16_t port, const std::string& hex, unsigned times) {
    boost::asio::io_context context;
    udp::socket socket{context, {boost::asio::ip::address_v4::loopback(), from}};
    send_all(socket, port, hex, times);
}

bool eventually(const std::function<bool()>& done) {
    const auto until = std::chrono::steady_clock::now() + wait_limit();
    while (!done()) {
        if (std::chrono::steady_clock::now() > until) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds{20});
    }
    return true;
}

jauscat::jaus::report_wrench_effort efforts_in(const json& event) {
    const auto body = jauscat::test::from_hex(event.at("body").get<std::string>());
    jauscat::jaus::report_wrench_effort report{};
    if (!jauscat::wire::decode(report, body)) FAIL("no Report Wrench Effort: " << event.dump());
    return report;
}

const words full_command{
    "propulsive_linear_effort_x=50",      "propulsive_linear_effort_y=50",      "propulsive_linear_effort_z=50",
    "propulsive_rotational_effort_x=-50", "propulsive_rotational_effort_y=-50", "propulsive_rotational_effort_z=-50",
    "resistive_linear_effort_x=50",       "resistive_linear_effort_y=50",       "resistive_linear_effort_z=50",
    "resistive_rotational_effort_x=100",  "resistive_rotational_effort_y=100",  "resistive_rotational_effort_z=100"};

robot::robot()
    : ocu_port{free_port()},
      controller_port{free_port()},
      slave_port{free_port()},
      config{folder / "JausConfig.xml"},
      link{"--ethercat-port", std::to_string(slave_port)},
      master_options{is_slow() ? words{"--frame-timeout", "1000", "--stop-within", "6500"}
                               : words{"--frame-timeout", "100", "--stop-within", "2000"}} {
    write_file(config, "<jausconfig>\n  <thissystem>a</thissystem>\n"
                       "  <system><name>a</name><jausip>1.0.0.0</jausip><ip>127.0.0.1</ip><port>" +
                           std::to_string(ocu_port) +
                           "</port></system>\n"
                           "  <system><name>b</name><jausip>2.0.0.0</jausip><ip>127.0.0.1</ip><port>" +
                           std::to_string(controller_port) + "</port></system>\n</jausconfig>\n");
}

robot::~robot() {
    if (std::uncaught_exceptions() != 0) {
        for (const auto& one : programs_) show(*one);
        return;
    }
    if (wrapper().empty()) return;
    // The last first: a controller whose arm is gone cannot bring it to rest, and says so by its exit code.
    while (!programs_.empty()) {
        auto& one = *programs_.back();
        if (!one.has_ended()) {
            one.signal(SIGTERM);
            const bool ends = one.ends_within(wait_limit());
            CHECK(ends);
            if (ends) CHECK(one.wait() == 0);
        }
        programs_.pop_back();
    }
}

program& robot::start_command(const words& command) {
    return *programs_.emplace_back(std::make_unique<program>(command));
}
program& robot::start_program(const std::string& name, const words& arguments, const std::string& input,
                              bool keeps_input) {
    const auto command =
        prefix + wrapper() + words{(bin() / name).string()} + arguments + words{"--log-format", "json"};
    return *programs_.emplace_back(std::make_unique<program>(command, input, keeps_input));
}
program& robot::start_node(const std::string& name, const words& arguments) {
    return start_program(name, words{"--config", config, "--this", "b", "--table", table} + arguments);
}
program& robot::start_arm() {
    auto options = link + arm_options;
    if (std::ranges::find(options, "--command-timeout") == options.end()) // a busy machine may hold the controller up
        options = options + words{"--command-timeout", "20000"};
    arm_ = &start_node("robot_arm", options);
    arm_->wait_for("ready");
    return *arm_;
}
program& robot::start_controller() {
    controller_ = &start_node("robot_controller", (master_link.empty() ? link : master_link) + master_options);
    controller_->wait_for("ready");
    return *controller_;
}
program& robot::start_bus(const words& options) {
    auto& bus = start_program("emulated_bus", options);
    bus.wait_for("ready");
    return bus;
}
void robot::stop() {
    REQUIRE(controller_->end(SIGTERM) == 0);
    REQUIRE(arm_->end(SIGTERM) == 0);
}

program& robot::run(int code, const std::string& name, const words& arguments, const std::string& input) {
    auto& one = start_program(name, arguments, input);
    INFO(name << " " << json(arguments).dump());
    REQUIRE(one.wait() == code);
    return one;
}
program& robot::unit(const words& arguments, const std::string& system) {
    return start_program("ocu", words{"--config", config, "--this", system} + arguments);
}
program& robot::ocu(int code, const words& arguments, const std::string& system) {
    auto& one = unit(arguments, system);
    INFO("ocu " << json(arguments).dump());
    REQUIRE(one.wait() == code);
    return one;
}
program& robot::hold(const words& arguments, const std::string& system) {
    auto& one = unit(words{"--hold", "600"} + arguments, system);
    one.wait_for("holding");
    return one;
}
std::uint16_t robot::add_second_unit() {
    const auto port = free_port();
    auto text = content(config);
    text.insert(text.find("</jausconfig>"), "<system><name>c</name><jausip>3.0.0.0</jausip><ip>127.0.0.1</ip><port>" +
                                                std::to_string(port) + "</port></system>\n");
    write_file(config, text);
    return port;
}

program& robot::command_arrives() {
    auto& unit = ocu(0, full_command);
    REQUIRE(unit.has("report_compared", {{"equal", true}, {"acknowledged", true}}));
    const auto reports = unit.events("message_received", {{"code", report_wrench_effort}, {"source", "2.2.33.1"}});
    REQUIRE(!reports.empty());
    const auto efforts = efforts_in(reports.back());
    // 50 % is 16383.5 of 32767 and 127.5 of 255: ties go up.
    CHECK(*efforts.propulsive_linear_effort_z == Approx(50.001526).epsilon(1e-6));
    CHECK(*efforts.resistive_linear_effort_x == Approx(50.196078).epsilon(1e-6));
    json raw;
    for (const std::string axis : {"x", "y", "z"}) {
        raw["propulsive_linear_effort_" + axis] = 16384;
        raw["propulsive_rotational_effort_" + axis] = -16383;
        raw["resistive_linear_effort_" + axis] = 128;
        raw["resistive_rotational_effort_" + axis] = 255;
    }
    arm().wait_for("efforts_in_force", raw);
    return unit;
}
void robot::nobody_controls() {
    auto& unit = ocu(0, {"--send", "query_component_control"});
    const auto reports = unit.events("message_received", {{"code", 0x400D}});
    REQUIRE(!reports.empty());
    // Instance, component, node and subsystem of the controller.
    CHECK(reports.back()["body"].get<std::string>().substr(0, 11) == "00 00 00 00");
}
void robot::at_rest(std::size_t times) {
    arm().wait_for("message_received",
                   {{"code", set_wrench_effort}, {"source", "2.2.33.1"}, {"destination", "2.2.33.1"}}, times);
    REQUIRE(eventually([&] {
        const auto all = arm().events("efforts_in_force");
        if (all.empty()) return false;
        for (const auto& [name, value] : all.back().items())
            if (name.find("_effort_") != std::string::npos && value != 0) return false;
        return true;
    }));
}

} // namespace nodes
