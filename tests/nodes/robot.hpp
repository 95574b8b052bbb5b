// A robot arm, its controller and operators on loopback ports of their own.
#pragma once
#include "nodes/program.hpp"
#include "support/catch.hpp"
#include "support/scratch.hpp"
#include <jauscat/schema/jaus/platform.hpp>

#include <csignal>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <string>

namespace nodes {

/// The folder of the programs.
std::filesystem::path bin();
using jauscat::test::content;
using jauscat::test::scratch;

void write_file(const std::string& path, const std::string& content);
std::uint16_t free_port();
/// A datagram of bytes in hex to a port of the loopback interface, `times` in all.
void send_bytes(std::uint16_t port, const std::string& hex, unsigned times = 1);
/// As `send_bytes`, from this port.
void send_bytes_from(std::uint16_t from, std::uint16_t port, const std::string& hex, unsigned times);
/// Until `done()`; false after `wait_limit`. For states that no program logs.
bool eventually(const std::function<bool()>& done);

/// The efforts in the body of an event about a Report Wrench Effort.
jauscat::jaus::report_wrench_effort efforts_in(const json& event);

inline constexpr std::uint16_t set_wrench_effort = 0x0405, query_wrench_effort = 0x2405, report_wrench_effort = 0x4405;
/// Every field of Set Wrench Effort.
extern const words full_command;

class robot {
  public:
    robot();
    robot(const robot&) = delete;
    robot& operator=(const robot&) = delete;
    /// Shows what all programs have written if the test has failed. Under a wrapper every program has to end well.
    ~robot();

    const scratch folder{};
    const std::uint16_t ocu_port, controller_port, slave_port;
    const std::string config;

    words link;           ///< of the arm, and of the controller without `master_link`
    words master_link{};  ///< of the controller
    words master_options; ///< with times for a busy machine
    words arm_options{};
    words prefix{}; ///< in front of the programs, such as a network namespace
    std::string table{"seed"};

    /// Microseconds that a slow machine keeps up with.
    [[nodiscard]] static std::string period() { return is_slow() ? "30000" : "10000"; }
    static words cyclic() { return {"--cycle", period()}; }

    /// Starts a program that logs JSON.
    program& start_program(const std::string& name, const words& arguments, const std::string& input = {},
                           bool keeps_input = false);
    /// Starts any program.
    program& start_command(const words& command);
    /// robot_arm or robot_controller, of the system b.
    program& start_node(const std::string& name, const words& arguments);
    program& start_arm();
    program& start_controller();
    /// Both, and the component that drives the arm is ready.
    void start() {
        start_arm();
        start_controller();
        is_ready(controller());
    }
    /// The component executes commands: its slave is up and at rest.
    static void is_ready(program& controller, const std::string& component = "2.2.33.1") {
        controller.wait_for("state_changed", {{"address", component}, {"to", "ready"}});
    }
    program& start_bus(const words& options);
    [[nodiscard]] program& arm() { return *arm_; }
    [[nodiscard]] program& controller() { return *controller_; }
    /// Both, by SIGTERM.
    void stop();

    /// Runs a program to its end, which has to be this exit code.
    program& run(int code, const std::string& name, const words& arguments, const std::string& input = {});
    program& ocu(int code, const words& arguments, const std::string& system = "a");
    /// Starts a unit.
    program& unit(const words& arguments, const std::string& system = "a");
    /// A unit that stays, with control if it needs that.
    program& hold(const words& arguments, const std::string& system = "a");
    /// System c, subsystem 3, in the configuration. Returns its port.
    std::uint16_t add_second_unit();

    /// Commands all fields: the report equals the command, and the arm has executed it.
    program& command_arrives();
    void nobody_controls();
    /// For the `times`th time the slave has confirmed what it was owed, and the arm shows zero efforts.
    void at_rest(std::size_t times);

  private:
    std::deque<std::unique_ptr<program>> programs_{};
    program *arm_{}, *controller_{};
};

} // namespace nodes
