// The communicator on a terminal: what libedit does with the keys.
#include "support/catch.hpp"
#include "support/free_ports.hpp"
#include "support/paths.hpp"
#include "support/terminal_program.hpp"

#include <filesystem>
#include <fstream>

namespace {

/// A configuration with one system at a free port, removed with this object.
class configuration {
  public:
    configuration() {
        std::ofstream{path_} << "<jausconfig><thissystem>a</thissystem><system name='a' jausip='1.0.0.0' "
                                "ip='127.0.0.1' port='"
                             << support::free_ports<1>()[0] << "'/></jausconfig>";
    }
    configuration(const configuration&) = delete;
    configuration& operator=(const configuration&) = delete;
    ~configuration() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    [[nodiscard]] std::string path() const { return path_.string(); }

  private:
    std::filesystem::path path_ =
        std::filesystem::temp_directory_path() / ("communicator." + std::to_string(::getpid()) + ".xml");
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
