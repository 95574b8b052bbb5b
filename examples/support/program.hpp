// What the example programs share: options, a `main` that turns exceptions into a message and an exit code, Ctrl-C.
#pragma once
#include "support/colour.hpp"
#include "support/log.hpp"
#include "support/output.hpp"

#include <boost/program_options.hpp>

#include <atomic>
#include <cstdio>
#include <iostream>
#include <stdexcept>
#include <string>

namespace example {

/// Exit codes of every program here.
enum exit_code : int { success = 0, failure = 1, usage = 2 };

/// A wrong command line.
struct usage_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Set by Ctrl-C and by SIGTERM; programs look at it in their loops.
inline std::atomic<bool> stop_requested{false};

/// SIGINT and SIGTERM set `stop_requested`.
void stop_on_signals();

/// Adds --log-format, which `parse` obeys.
void add_log_option(boost::program_options::options_description& options);

/// Parses the command line, which also has --help and --version: prints what they ask for and ends the program. `help`
/// begins with the program's name: "ocu: commands the efforts ...".
boost::program_options::variables_map
parse(int argc, char** argv, const boost::program_options::options_description& options, const std::string& help,
      const boost::program_options::positional_options_description& positional = {});

/// `more`: lines below, each with its end.
void say_error(const char* name, event_kind kind, const std::exception& error, const std::string& more = {});

/// Says on standard error if standard output could not be written, as an event, and returns 1 then, else `code`.
int end_of_output(const char* name, int code);

/// Runs `program`, and prints on standard error why it ended early, and if its output could not be written.
int run(const char* name, auto&& program) {
    program_name() = name;
    std::setvbuf(stdout, nullptr, _IOLBF,
                 4096); // a line is seen, whole, when it is written: in a terminal and in a log
    try {
        stop_on_signals();
        return end_of_output(name, program());
    } catch (const usage_error& error) {
        say_error(name, events::usage_error, error, "Try '" + std::string{name} + " --help'.\n");
        return usage;
    } catch (const std::exception& error) {
        say_error(name, events::failed, error);
        return failure;
    }
}

} // namespace example
