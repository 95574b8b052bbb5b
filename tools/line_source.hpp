// Where the lines of a user come from: a terminal with line editing, or a script through standard input.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

class line_source {
  public:
    line_source() = default;
    line_source(const line_source&) = delete;
    line_source& operator=(const line_source&) = delete;
    virtual ~line_source() = default;

    /// The next line, if there is one now. Does not wait.
    virtual std::optional<std::string> next() = 0;
    /// No more lines will come.
    [[nodiscard]] virtual bool ended() const = 0;
    /// Shows text, without harm to what the user is typing.
    virtual void show(std::string_view text) = 0;
};

/// Lines of standard input as they come.
std::unique_ptr<line_source> script_lines();
/// Line editing and history; only one at a time.
std::unique_ptr<line_source> terminal_lines(const std::string& prompt);

/// Whether standard input has something to read or has ended.
bool input_is_ready();
