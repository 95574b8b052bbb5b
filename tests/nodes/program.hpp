// A program as a user runs it: its process, the events that it logs, and its exit code.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace nodes {

using json = nlohmann::json;
using words = std::vector<std::string>;

/// Programs are several times slower than usual: they run with sanitizers, or behind the command of NODE_WRAPPER.
bool is_slow();
/// The words of the environment variable NODE_WRAPPER: a command in front of every program, such as valgrind.
const words& wrapper();
/// Long enough for a busy machine; only a test that fails waits so long.
std::chrono::seconds wait_limit();

/// Whether there is a program of this name in PATH.
bool is_installed(const std::string& name);

/// `first`, then `more`.
words operator+(words first, const words& more);

/// A running program. Every function that waits fails the test after `wait_limit`.
class program {
  public:
    using predicate = std::function<bool(const json& event)>;

    /// `command`: a path or a name to be looked for, then arguments. `input`: its standard input, which stays open if
    /// `keeps_input`.
    explicit program(const words& command, const std::string& input = {}, bool keeps_input = false);
    program(const program&) = delete;
    program& operator=(const program&) = delete;
    /// Kills it if it still runs.
    ~program();

    /// The `times`th event of this name whose members equal `members`, once it is there.
    json wait_for(std::string_view name, const json& members = json::object(), std::size_t times = 1);
    json wait_for(std::string_view name, const predicate& is_it, std::size_t times = 1);
    /// Until its output contains `text`.
    void wait_for_output(const std::string& text);
    /// The events so far.
    [[nodiscard]] std::vector<json> events(std::string_view name, const json& members = json::object()) const;
    [[nodiscard]] std::size_t count(std::string_view name, const json& members = json::object()) const;
    [[nodiscard]] bool has(std::string_view name, const json& members = json::object()) const;
    /// Standard output and standard error so far.
    [[nodiscard]] std::string output() const;
    [[nodiscard]] bool has_output(const std::string& text) const;

    void signal(int number) const;
    /// Waits for its end. Returns the exit code, or the negated number of the signal that has ended it.
    int wait();
    /// `wait`, but false if it has not ended within `limit`.
    bool ends_within(std::chrono::milliseconds limit);
    /// Sends the signal and waits for its end.
    int end(int number);
    /// As in a crash.
    void kill();
    /// Its end has been waited for.
    [[nodiscard]] bool has_ended() const;
    [[nodiscard]] int pid() const;
    [[nodiscard]] const std::string& name() const;

  private:
    struct state;
    std::unique_ptr<state> is_;
};

} // namespace nodes
