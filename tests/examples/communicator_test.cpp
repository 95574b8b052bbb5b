// The communicator on a terminal: what libedit does with the keys.
#include "support/catch.hpp"
#include "support/free_ports.hpp"
#include "support/paths.hpp"
#include "support/terminal_program.hpp"

#include <filesystem>
#include <fstream>

namespace {

/// A configuration with one system at a free port, and a place for the history, removed with this object.
class configuration {
  public:
    configuration() {
        std::ofstream{path_} << "<jausconfig><thissystem>a</thissystem><system name='a' jausip='1.0.0.0' "
                                "ip='127.0.0.1' port='"
                             << support::free_ports<1>()[0] << "'/></jausconfig>";
        ::setenv("XDG_STATE_HOME", state_.c_str(), 1);
    }
    configuration(const configuration&) = delete;
    configuration& operator=(const configuration&) = delete;
    ~configuration() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
        std::filesystem::remove_all(state_, ignored);
    }
    [[nodiscard]] std::string path() const { return path_.string(); }

  private:
    std::filesystem::path path_ =
        std::filesystem::temp_directory_path() / ("communicator." + std::to_string(::getpid()) + ".xml");
    std::filesystem::path state_ = path_.string() + ".state"; ///< the history
};

} // namespace

TEST_CASE("every line on a terminal can be edited and is in the history, and exit ends the program") {
    const std::string up = "\x1b[A", to_the_begin = "\x01", backspace = "\x7f";
    const std::string shown = "\x1b[K"; // before a line of the program, not of the keys
    const configuration config;
    support::terminal_program program{{support::program("communicator"), "--config", config.path()}};
    program.wait_for("help lists the commands");
    program.wait_for("> ");
    program.type("log on\n");
    program.wait_for(shown + "log on\r\n");
    for (int round = 0; round != 3; ++round) {
        program.type("og off" + to_the_begin + "l\n");
        program.wait_for(shown + "log off\r\n> ");
        program.type("log om" + backspace + "n\n");
        program.wait_for(shown + "log on\r\n> ");
        program.type(up); // the terminal shows what the history has, before Enter
        program.wait_for("log on");
        program.type(up);
        program.wait_for("ff"); // log off, in place of log on
        program.type("\n");
        program.wait_for(shown + "log off\r\n> ");
    }
    program.type("exit\n");
    program.wait_for("communicator: stopped");
    CHECK(program.exit_code() == 0);
    CHECK(program.seen().find("is not understood") == std::string::npos);
    CHECK(program.seen().find("^[") == std::string::npos); // the terminal's own echo of a key
}

TEST_CASE("Tab completes commands, systems, messages, fields and values, and the history outlives the program") {
    const std::string tab = "\t", up = "\x1b[A";
    const configuration config;
    {
        support::terminal_program program{{support::program("communicator"), "--config", config.path()}};
        program.wait_for("> ");
        program.type("se" + tab + "a" + tab);
        program.wait_for("send a"); // the terminal moves its cursor over the space behind
        program.type("set_eme" + tab);
        program.wait_for("rgency");
        program.type("em" + tab + "tr" + tab);
        program.wait_for("ergency_code=");
        program.wait_for("ansition_to_emergency");
        program.type("\n");
        program.wait_for("sent Set Emergency to 1.1.32.1"); // the system has this component alone
        program.type("exit\n");
        CHECK(program.exit_code() == 0);
    }
    support::terminal_program again{{support::program("communicator"), "--config", config.path()}};
    again.wait_for("> ");
    again.type(up + up);
    again.wait_for("send a set_emergency emergency_code=transition_to_emergency");
    again.type("\x15"
               "exit\n");
    CHECK(again.exit_code() == 0);
}
